import type { Bounds } from '@mass/core/view';
import { loadScene } from '../scenes/load-scene.ts';
import { DEFAULT_SEED, defaultValues } from '../scenes/run.ts';
import type { Scene } from '../scenes/scene.ts';
import { Hand } from '../stage/hand.ts';
import { Stage } from '../stage/stage.ts';
import { find } from './find.ts';
import './mass.ts';
import { currentPalette, watchTheme } from './theme.ts';

/** How long a thumbnail runs before it starts again. Unit: s. */
const THUMBNAIL_TIME = 30;

/** A thumbnail of which less is in sight stands still: only a few run at a time. */
const SEEN = 0.4;

/** The most that starting thumbnails may take of a frame. Unit: ms. */
const START_TIME = 6;

const narrow = matchMedia('(max-width: 560px)');
const still = matchMedia('(prefers-reduced-motion: reduce)');
const stages = new Map<HTMLElement, Stage>();
/** Cards that are near and not started, and the scenes of those of them whose code has come. */
const waiting = new Set<HTMLElement>();
const ready = new Map<HTMLElement, Scene>();
const seen = new Set<HTMLElement>();
const hero = find('#hero');

function start(host: HTMLElement, scene: Scene): Stage {
  const stage = new Stage(host, {
    scene,
    values: Object.assign(defaultValues(scene), scene.light),
    seed: DEFAULT_SEED,
    palette: currentPalette(),
    failed: (error) => {
      host.dataset['failed'] = String(error);
    },
  });
  stages.set(host, stage);
  if (still.matches) stage.skip(scene.poster ?? 2);
  return stage;
}

/** Plays what is in sight, unless the reader wants no motion. */
function move(host: HTMLElement, stage: Stage): void {
  if (!still.matches && (host === hero || seen.has(host))) stage.play();
  else stage.pause();
}

function fitHero(): void {
  const view: Bounds = JSON.parse(hero.dataset[narrow.matches ? 'narrow' : 'wide'] ?? '');
  heroStage.moveCameras((camera) => camera.fit(view));
}

/** Starts thumbnails that came near, a few at each frame: those in sight first. */
function startReady(): void {
  const until = performance.now() + START_TIME;
  while (ready.size > 0 && performance.now() < until) {
    const [host, scene] = [...ready].find(([each]) => seen.has(each)) ?? [...ready][0];
    waiting.delete(host);
    ready.delete(host);
    near.unobserve(host);
    move(host, start(host, scene));
  }
  if (ready.size > 0) requestAnimationFrame(startReady);
}

async function load(host: HTMLElement): Promise<void> {
  const scene = await loadScene(host.dataset['scene']);
  if (!waiting.has(host)) return;
  if (ready.size === 0) requestAnimationFrame(startReady);
  ready.set(host, scene);
}

/** A scene is loaded and started when its card comes near, not before; one that was passed by waits for the next time. */
const near = new IntersectionObserver(
  (entries) => {
    for (const { target, isIntersecting } of entries) {
      const host = target as HTMLElement;
      waiting.delete(host);
      ready.delete(host);
      if (!isIntersecting) continue;
      waiting.add(host);
      void load(host);
    }
  },
  { rootMargin: '200px' },
);

const sight = new IntersectionObserver(
  (entries) => {
    for (const { target, intersectionRatio } of entries) {
      const host = target as HTMLElement;
      if (intersectionRatio >= SEEN) seen.add(host);
      else seen.delete(host);
      const stage = stages.get(host);
      if (stage) move(host, stage);
    }
  },
  { threshold: SEEN },
);

still.addEventListener('change', () => {
  for (const [host, stage] of stages) move(host, stage);
});
watchTheme((palette) => {
  for (const stage of stages.values()) stage.usePalette(palette);
});
window.stages = stages;

// The scene at the top moves first, and can be played with; the others follow.
const heroStage = start(hero, await loadScene(hero.dataset['scene']));
new Hand(heroStage, { camera: false });
fitHero();
narrow.addEventListener('change', fitHero);
move(hero, heroStage);
requestAnimationFrame(() => {
  for (const host of document.querySelectorAll<HTMLElement>('.thumbnail')) {
    near.observe(host);
    sight.observe(host);
  }
});
setInterval(() => {
  for (const [host, stage] of stages) {
    if (host !== hero && stage.setup.world.time > THUMBNAIL_TIME) stage.reset();
  }
}, 1000);
