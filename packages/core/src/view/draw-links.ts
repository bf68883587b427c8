import type { Link } from '../links/link.ts';
import { particleOf } from '../particles/end.ts';
import type { Frame } from './frame.ts';
import type { LinkStyle } from './link-style.ts';
import { type PathList, pathKinds } from './path-list.ts';
import type { PinMarks } from './pin-marks.ts';
import { PaintRamp } from './ramp.ts';
import { addSlack } from './sag.ts';
import type { SceneStyle } from './scene-style.ts';

/** What a link may tell of itself, for drawing. A link that tells nothing is a straight line. */
interface ToldLink extends Link {
  readonly kind?: string;
  readonly minLength?: number;
  readonly maxLength?: number;
}

/** Draws links: straight, or in a curve where they are slack. */
export class LinkArt {
  readonly #paints = new Map<string, LinkPaints | null>();
  readonly #other: LinkPaints | null;

  constructor({ links, otherLinks }: SceneStyle) {
    for (const [kind, style] of Object.entries(links)) {
      this.#paints.set(kind, style && paintsOf(style));
    }
    this.#other = otherLinks && paintsOf(otherLinks);
  }

  /** Adds every link but those within a body whose outline is drawn. */
  draw(links: readonly Link[], list: PathList, frame: Frame, pins: PinMarks): void {
    for (let l = 0; l < links.length; l++) {
      const link: ToldLink = links[l];
      const paints = link.kind === undefined ? this.#other : this.#paintsFor(link.kind);
      if (paints === null) continue;
      const a = particleOf(link.a);
      const b = particleOf(link.b);
      pins.note(link.a);
      pins.note(link.b);
      if (a && b && frame.bodyOf[a.slot] > 0 && frame.bodyOf[a.slot] === frame.bodyOf[b.slot]) continue;
      addLink(link, paints, list, frame);
    }
  }

  #paintsFor(kind: string): LinkPaints | null {
    const paints = this.#paints.get(kind);
    return paints === undefined ? this.#other : paints;
  }
}

/** What a link is painted with, by its strain, and how wide. */
interface LinkPaints {
  readonly ramp: PaintRamp<'strain'>;
  readonly width: number;
}

function paintsOf({ color, colorBy, alpha, width }: LinkStyle): LinkPaints {
  return { ramp: new PaintRamp(color, colorBy, alpha, [width]), width };
}

function addLink(link: ToldLink, { ramp, width }: LinkPaints, list: PathList, frame: Frame): void {
  const x0 = frame.endX(link.a);
  const y0 = frame.endY(link.a);
  const x1 = frame.endX(link.b);
  const y1 = frame.endY(link.b);
  const { minLength = 0, maxLength = 0 } = link;
  const hangs = maxLength > minLength && maxLength < Infinity;
  const length = hangs ? maxLength * frame.scale : 0;
  if (frame.misses(x0, y0, x1, y1, length + width)) return;
  const paint = ramp.at(ramp.by === null ? 0 : strainOf(x1 - x0, y1 - y0, minLength, maxLength, frame.scale));
  if (hangs) addSlack(list, x0, y0, x1, y1, length, frame.hangX, frame.hangY, paint);
  else {
    list.add(x0, y0);
    list.add(x1, y1);
    list.end(pathKinds.line, paint);
  }
}

function strainOf(dx: number, dy: number, minLength: number, maxLength: number, scale: number): number {
  const length = Math.sqrt(dx * dx + dy * dy) / scale;
  if (length > maxLength) return maxLength > 0 ? length / maxLength - 1 : 0;
  return length < minLength ? length / minLength - 1 : 0;
}
