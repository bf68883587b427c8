import { sceneOf } from '../scenes/index.ts';
import { DEFAULT_SEED, defaultValues } from '../scenes/run.ts';
import { Stage } from '../stage/stage.ts';
import { exposeThumbnails } from './mass.ts';
import { currentPalette, watchTheme } from './theme.ts';

/** How long a thumbnail runs before it starts again. Unit: s. */
const THUMBNAIL_TIME = 30;

const still = matchMedia('(prefers-reduced-motion: reduce)');
const stages = new Map<HTMLElement, Stage>();

/** A scene is started when its card comes near, not before. */
const near = new IntersectionObserver(
  (entries) => {
    for (const { target, isIntersecting } of entries) {
      if (!isIntersecting) continue;
      near.unobserve(target);
      start(target as HTMLElement);
    }
  },
  { rootMargin: '200px' },
);

function start(host: HTMLElement): void {
  const scene = sceneOf(host.dataset['scene']);
  const stage = new Stage(host, {
    scene,
    values: defaultValues(scene),
    seed: DEFAULT_SEED,
    palette: currentPalette(),
    failed: (error) => {
      host.dataset['failed'] = String(error);
    },
  });
  stages.set(host, stage);
  if (still.matches) stage.skip(scene.poster ?? 2);
  else stage.play();
}

still.addEventListener('change', () => {
  for (const stage of stages.values()) still.matches ? stage.pause() : stage.play();
});
watchTheme((palette) => {
  for (const stage of stages.values()) stage.usePalette(palette);
});
exposeThumbnails(stages);
for (const host of document.querySelectorAll<HTMLElement>('.thumbnail')) near.observe(host);
setInterval(() => {
  for (const stage of stages.values()) if (stage.setup.world.time > THUMBNAIL_TIME) stage.reset();
}, 1000);
