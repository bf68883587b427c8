import type { ForceGenerator } from '../forces/force-generator.ts';
import type { Spring } from '../forces/spring.ts';
import { addCoil } from './coil.ts';
import type { Frame } from './frame.ts';
import type { SpringQuantity } from './link-style.ts';
import type { PathList } from './path-list.ts';
import type { PinMarks } from './pin-marks.ts';
import { PaintRamp } from './ramp.ts';
import { addSlack } from './sag.ts';
import type { SceneStyle } from './scene-style.ts';
import { generatorWithin } from './within.ts';

/** How many widths a bungee has, and the narrowest as a share of the first. */
const widths = 12;
const narrowest = 0.3;

/** Draws springs with their coils, and bungees as cords. */
export class SpringArt {
  readonly #springs: PaintRamp<SpringQuantity> | null;
  readonly #bungees: PaintRamp<SpringQuantity> | null;
  readonly #coils: number;
  readonly #diameter: number;

  constructor({ springs, bungees }: SceneStyle) {
    this.#springs = springs && new PaintRamp(springs.color, springs.colorBy, springs.alpha, [springs.width]);
    this.#coils = springs?.coils ?? 0;
    this.#diameter = springs?.diameter ?? 0;
    this.#bungees =
      bungees &&
      new PaintRamp(
        bungees.color,
        bungees.colorBy,
        bungees.alpha,
        Array.from({ length: widths }, (_, n) => bungees.width * (1 - ((1 - narrowest) * n) / (widths - 1))),
      );
  }

  /** Adds the springs and bungees among the force generators. */
  draw(forces: readonly ForceGenerator[], list: PathList, frame: Frame, pins: PinMarks): void {
    for (let f = 0; f < forces.length; f++) {
      const generator = generatorWithin(forces[f]);
      if (isSpring(generator)) this.#add(generator, list, frame, pins);
      else if (isBatch(generator)) {
        const springs = generator.list;
        for (let s = 0; s < springs.length; s++) this.#add(springs[s], list, frame, pins);
      }
    }
  }

  #add(spring: Spring, list: PathList, frame: Frame, pins: PinMarks): void {
    const cord = spring.kind === 'bungee';
    const paints = cord ? this.#bungees : this.#springs;
    if (paints === null || !spring.alive) return;
    const { a, b, restLength } = spring;
    pins.note(a);
    pins.note(b);
    const x0 = frame.endX(a);
    const y0 = frame.endY(a);
    const x1 = frame.endX(b);
    const y1 = frame.endY(b);
    const rest = restLength * frame.scale;
    if (frame.misses(x0, y0, x1, y1, cord ? rest : this.#diameter)) return;
    const length = Math.sqrt((x1 - x0) * (x1 - x0) + (y1 - y0) * (y1 - y0));
    const value = quantity(paints.by, spring, length, rest);
    if (cord) {
      // A cord keeps its volume: seen from the side it is as wide as the root of its length is long.
      const width = length > rest && rest > 0 ? Math.max(narrowest, Math.sqrt(rest / length)) : 1;
      const paint = paints.at(value, (1 - width) / (1 - narrowest));
      addSlack(list, x0, y0, x1, y1, rest, frame.hangX, frame.hangY, paint);
    } else addCoil(list, x0, y0, x1, y1, rest, this.#coils, this.#diameter, paints.at(value));
  }
}

function quantity(by: SpringQuantity | null, spring: Spring, length: number, rest: number): number {
  if (by === 'strain') return rest > 0 ? length / rest - 1 : length > 0 ? Infinity : 0;
  if (by === 'force') return spring.force;
  return by === 'stiffness' ? spring.stiffness : 0;
}

function isSpring(generator: object): generator is Spring {
  return 'restLength' in generator && 'a' in generator && 'b' in generator;
}

function isBatch(generator: object): generator is { readonly list: readonly Spring[] } {
  return 'list' in generator && 'kind' in generator && Array.isArray(generator.list);
}
