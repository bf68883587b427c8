import '@awesome.me/webawesome/dist/components/slider/slider.js';
import type { Parameter } from '../scenes/scene.ts';
import { type RendererKind, rendererKinds, rendererNames } from '../stage/renderers.ts';
import type { Stage } from '../stage/stage.ts';
import { seedOf } from './address.ts';
import { find } from './find.ts';

const speeds = [0.1, 0.25, 0.5, 1, 2];

/** Fills in the sliders, the speed, the renderer and the seed. Their room on the page was kept for them. */
export function addControls(stage: Stage, renderer: RendererKind): void {
  for (const host of document.querySelectorAll<HTMLElement>('[data-parameter]')) {
    const name = host.dataset['parameter'] ?? '';
    host.replaceChildren(...slider(stage, name, stage.scene.parameters[name]));
  }
  fillChoice(
    find('[data-choice="speed"]'),
    'Speed',
    speeds.map((speed) => [String(speed), `${speed}×`]),
    String(stage.speed),
    (value) => {
      stage.speed = Number(value);
    },
  );
  fillChoice(
    find('[data-choice="renderer"]'),
    'Renderer',
    rendererKinds.map((kind) => [kind, rendererNames[kind]]),
    renderer,
    (value) => void stage.useRenderer(value as RendererKind),
  );
  seedField(stage);
}

function slider(stage: Stage, name: string, { label, unit, min, max, step, value, live }: Parameter): HTMLElement[] {
  const element = document.createElement('wa-slider');
  const digits = Math.max(0, Math.ceil(-Math.log10(step) - 1e-9));
  const format = (number: number): string => `${number.toFixed(digits)}${unit ? ` ${unit}` : ''}`;
  const reading = document.createElement('output');
  element.label = label;
  element.min = min;
  element.max = max;
  element.step = step;
  element.defaultValue = value;
  element.value = stage.values[name];
  element.size = 's';
  element.valueFormatter = format;
  reading.textContent = format(stage.values[name]);
  element.addEventListener('input', () => {
    if (stage.values[name] === element.value) return;
    stage.values[name] = element.value;
    reading.textContent = format(element.value);
    if (live) stage.announce();
    else stage.reset();
  });
  return [element, reading];
}

function fillChoice(
  host: HTMLElement,
  label: string,
  choices: readonly (readonly [value: string, text: string])[],
  chosen: string,
  choose: (value: string) => void,
): void {
  const group = document.createElement('fieldset');
  const legend = document.createElement('legend');
  legend.className = 'choice-label';
  legend.textContent = label;
  group.append(legend);
  for (const [value, text] of choices) {
    const option = document.createElement('label');
    const radio = document.createElement('input');
    radio.type = 'radio';
    radio.name = label;
    radio.checked = value === chosen;
    radio.addEventListener('change', () => choose(value));
    option.append(radio, text);
    group.append(option);
  }
  host.replaceChildren(group);
}

function seedField(stage: Stage): void {
  const field = find('#seed') as HTMLInputElement;
  field.value = String(stage.seed);
  field.addEventListener('change', () => {
    const seed = seedOf(field.value);
    if (seed === undefined) {
      field.value = String(stage.seed);
      return;
    }
    stage.seed = seed;
    stage.reset();
  });
}
