import { DEFAULT_SEED, defaultValues } from '../scenes/run.ts';
import type { Scene, Values } from '../scenes/scene.ts';
import { type RendererKind, rendererKinds } from '../stage/renderers.ts';

/** All that a link to a scene says: who opens it sees the same. */
export interface Address {
  readonly renderer: RendererKind;
  readonly seed: number;
  readonly values: Values;
}

/** Reads the address: what it does not say, or says wrongly, is as the scene has it. */
export function readAddress(scene: Scene, search: string): Address {
  const query = new URLSearchParams(search);
  const values = defaultValues(scene);
  for (const [name, { min, max }] of Object.entries(scene.parameters)) {
    const value = numberOf(query.get(name));
    if (value !== undefined) values[name] = Math.min(max, Math.max(min, value));
  }
  return {
    renderer: rendererKinds.find((kind) => kind === query.get('renderer')) ?? 'canvas2d',
    seed: seedOf(query.get('seed') ?? '') ?? DEFAULT_SEED,
    values,
  };
}

/** Writes the address: only what is not as the scene has it, so that the plain link stays plain. */
export function writeAddress(scene: Scene, { renderer, seed, values }: Address): string {
  const query = new URLSearchParams();
  if (renderer !== 'canvas2d') query.set('renderer', renderer);
  if (seed !== DEFAULT_SEED) query.set('seed', String(seed));
  for (const [name, { value }] of Object.entries(scene.parameters)) {
    if (values[name] !== value) query.set(name, String(values[name]));
  }
  return query.size > 0 ? `?${query}` : '';
}

/** A seed from what somebody typed: a whole number, 0 to 2³² - 1. */
export function seedOf(text: string): number | undefined {
  const seed = numberOf(text);
  return seed !== undefined && Number.isInteger(seed) && seed >= 0 && seed <= 0xffffffff ? seed : undefined;
}

function numberOf(text: string | null): number | undefined {
  const value = text === null || text.trim() === '' ? Number.NaN : Number(text);
  return Number.isFinite(value) ? value : undefined;
}
