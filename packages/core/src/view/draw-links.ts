import type { Link } from '../links/link.ts';
import { particleOf } from '../particles/end.ts';
import type { Frame } from './frame.ts';
import { type PathList, type PathPaint, pathKinds } from './path-list.ts';
import type { PinMarks } from './pin-marks.ts';
import { pathPaint } from './ramp.ts';
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
  readonly #paints = new Map<string, PathPaint | null>();
  readonly #other: PathPaint | null;

  constructor({ links, otherLinks }: SceneStyle) {
    for (const [kind, style] of Object.entries(links)) {
      this.#paints.set(kind, style && pathPaint(style.color, style.alpha, style.width));
    }
    this.#other = otherLinks && pathPaint(otherLinks.color, otherLinks.alpha, otherLinks.width);
  }

  /** Adds every link but those within a body whose outline is drawn. */
  draw(links: readonly Link[], list: PathList, frame: Frame, pins: PinMarks): void {
    for (let l = 0; l < links.length; l++) {
      const link: ToldLink = links[l];
      const paint = link.kind === undefined ? this.#other : this.#paintOf(link.kind);
      if (paint === null) continue;
      const a = particleOf(link.a);
      const b = particleOf(link.b);
      pins.note(link.a);
      pins.note(link.b);
      if (a && b && frame.bodyOf[a.slot] > 0 && frame.bodyOf[a.slot] === frame.bodyOf[b.slot]) continue;
      addLink(link, paint, list, frame);
    }
  }

  #paintOf(kind: string): PathPaint | null {
    const paint = this.#paints.get(kind);
    return paint === undefined ? this.#other : paint;
  }
}

function addLink(link: ToldLink, paint: PathPaint, list: PathList, frame: Frame): void {
  const x0 = frame.endX(link.a);
  const y0 = frame.endY(link.a);
  const x1 = frame.endX(link.b);
  const y1 = frame.endY(link.b);
  const { minLength = 0, maxLength = 0 } = link;
  const hangs = maxLength > minLength && maxLength < Infinity;
  const length = hangs ? maxLength * frame.scale : 0;
  if (frame.misses(x0, y0, x1, y1, length + paint.width)) return;
  if (hangs) addSlack(list, x0, y0, x1, y1, length, frame.hangX, frame.hangY, paint);
  else {
    list.add(x0, y0);
    list.add(x1, y1);
    list.end(pathKinds.line, paint);
  }
}
