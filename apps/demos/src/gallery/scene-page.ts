import { loadScene } from '../scenes/load-scene.ts';
import { Hand } from '../stage/hand.ts';
import { Stage } from '../stage/stage.ts';
import { readAddress, writeAddress } from './address.ts';
import { find } from './find.ts';
import { Keyboard } from './keyboard.ts';
import { exposeStage } from './mass.ts';
import { Readings } from './readings.ts';
import { currentPalette, watchTheme } from './theme.ts';
import { Transport } from './transport.ts';

const scene = await loadScene(find('article').dataset['scene']);
const address = readAddress(scene, location.search);
const host = find('#stage');
const fault = find('#fault');
const fitButton = find('#fit');
let addressTimer = 0;

const stage = new Stage(host, {
  scene,
  values: address.values,
  seed: address.seed,
  palette: currentPalette(),
  failed: showFault,
  changed: () => {
    if (!stage.failed) fault.hidden = true;
    fitButton.hidden = stage.fitted;
    transport.update();
    keepAddress();
  },
});
const transport = new Transport(stage);
new Hand(stage);
new Keyboard(stage, () => transport.togglePlaying());
new Readings(stage);
fitButton.addEventListener('click', () => stage.fit());
watchTheme((palette) => {
  stage.usePalette(palette);
  transport.paint();
});
exposeStage(stage);

// The scene moves first; its controls follow.
if (!matchMedia('(prefers-reduced-motion: reduce)').matches) stage.play();
const ready = address.renderer === 'canvas2d' ? Promise.resolve() : stage.useRenderer(address.renderer);
const { addControls } = await import('./controls.ts');
addControls(stage, address.renderer);
await ready;

/** Keeps the address as what is seen, so that it can be sent to somebody; not too often, which browsers refuse. */
function keepAddress(): void {
  clearTimeout(addressTimer);
  addressTimer = window.setTimeout(() => {
    const { renderer, seed, values } = stage;
    const search = writeAddress(scene, { renderer, seed, values });
    if (search !== location.search) history.replaceState(null, '', `${location.pathname}${search}${location.hash}`);
  }, 150);
}

/** An error of a step is shown, not hidden in the console; a reset goes on. */
function showFault(error: unknown): void {
  fault.textContent = `${error instanceof Error ? error.message : String(error)} The scene stands still: press Reset to start it anew.`;
  fault.hidden = false;
}
