import type { CanvasTarget } from '../src/index.ts';

/** A call on the context, or the setting of a property, as `['fillStyle=', '#fff']`. */
export type Call = readonly [name: string, ...values: unknown[]];

const state = [
  'fillStyle',
  'strokeStyle',
  'globalAlpha',
  'lineWidth',
  'lineCap',
  'lineJoin',
  'globalCompositeOperation',
];

/** A 2D context that writes down what is asked of it. */
export function fakeContext(
  width: number,
  height: number,
): { context: CanvasTarget; calls: Call[]; canvas: { width: number; height: number } } {
  const calls: Call[] = [];
  const canvas = { width, height };
  const context = new Proxy({ canvas } as Record<string, unknown>, {
    has: () => true,
    get: (target, name: string) =>
      name in target || state.includes(name) ? target[name] : (...values: unknown[]) => calls.push([name, ...values]),
    set: (target, name: string, value) => {
      target[name] = value;
      calls.push([`${name}=`, value]);
      return true;
    },
  });
  return { context: context as unknown as CanvasTarget, calls, canvas };
}
