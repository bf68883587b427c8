import type { SurfaceReport } from './surface-report.ts';

/** A way that closes by less than this share of its length runs along a surface, to rounding. */
const ALONG = 1e-9;

/** A disc that meets a flat this far beyond its end, or behind it, still meets it: no gap opens between two. Unit: m. */
export const SEAM = 1e-9;

/** A corner this near to a surface that the disc slides on already is a joint of a floor, as a share of the radius. */
const JOINT = 1e-4;

/**
 * A disc, or a point, on a straight way past static shapes: what does it meet first, and where? A shape tells its flats and its
 * corners, each as if it were alone. What is only passed by narrowly is told, too, since the way may bend: as the plane between, which
 * does not hinder the way itself.
 */
export class Sweep {
  /** Where the way begins, and where it leads from there. Unit: m. */
  x = 0;
  y = 0;
  dx = 0;
  dy = 0;
  /** Length of the way. Unit: m. */
  length = 0;
  /** Radius of the disc. Unit: m. */
  radius = 0;
  /** What is passed by less than this is told. Unit: m. */
  slack = 0;
  /** Whether it stands on something solid from the front alone. */
  held = false;
  /** Where something is met first, as a share of the way; `Infinity` where nothing is. */
  time: number = Infinity;
  /** The unit normal there. */
  normalX = 0;
  normalY = 0;
  /** How far in front of the plane there the centre is where the way begins. Unit: m. */
  distance = 0;
  readonly #passed: SurfaceReport | undefined;
  /** Planes that it slides on: unit normal and offset of each. */
  readonly #floors: number[] = [];
  #floorCount = 0;

  /** @param passed - Where to tell what is passed by. */
  constructor(passed?: SurfaceReport) {
    this.#passed = passed;
  }

  /** Begins a way. */
  begin(x: number, y: number, dx: number, dy: number, slack: number): void {
    this.x = x;
    this.y = y;
    this.dx = dx;
    this.dy = dy;
    this.length = Math.sqrt(dx * dx + dy * dy);
    this.slack = slack;
    this.time = Infinity;
  }

  /** Forgets the planes that it slides on. */
  clearFloors(): void {
    this.#floorCount = 0;
  }

  /** Has it slide on a plane, normal·place = offset. */
  addFloor(normalX: number, normalY: number, offset: number): void {
    const f = this.#floorCount++ * 3;
    this.#floors[f] = normalX;
    this.#floors[f + 1] = normalY;
    this.#floors[f + 2] = offset;
  }

  /** Whether a way from (x, y) leads into one of these planes at once. */
  isBlocked(x: number, y: number, dx: number, dy: number): boolean {
    const floors = this.#floors;
    const least = -ALONG * Math.sqrt(dx * dx + dy * dy);
    for (let f = 0; f < this.#floorCount * 3; f += 3) {
      const nx = floors[f];
      const ny = floors[f + 1];
      if (dx * nx + dy * ny < least && x * nx + y * ny - floors[f + 2] <= this.radius + SEAM) return true;
    }
    return false;
  }

  /**
   * A flat surface.
   * @param distance - How far in front of it the way begins, negative behind. Unit: m.
   * @param normalX - Unit normal.
   * @param normalY - Unit normal.
   * @param along - Where along it the way begins, from its start. Unit: m.
   * @param alongWay - How far along it the way leads. Unit: m.
   * @param length - How long it is. Unit: m.
   */
  flat(distance: number, normalX: number, normalY: number, along: number, alongWay: number, length: number): void {
    const gap = distance - this.radius;
    const way = this.dx * normalX + this.dy * normalY;
    // The part of the way that leads over it.
    const a = (-SEAM - along) / alongWay;
    const b = (length + SEAM - along) / alongWay;
    const isAcross = alongWay === 0;
    if (isAcross && !(along >= -SEAM && along <= length + SEAM)) return;
    const enter = isAcross ? 0 : Math.max(0, Math.min(a, b));
    const leave = isAcross ? 1 : Math.min(1, Math.max(a, b));
    if (!(enter <= leave)) return;
    if (way < -ALONG * this.length) {
      const time = Math.max(enter, gap / -way);
      if (time <= leave && distance + way * time >= -SEAM) {
        this.meet(time, distance, normalX, normalY);
        return;
      }
    }
    if (gap >= 0 && gap + way >= 0 && gap + Math.min(0, way) < this.slack)
      this.#passed?.add(distance, normalX, normalY);
  }

  /**
   * A round place: a corner, an end, a disc. It counts for centres that lie past the surface before it and not yet over the one after.
   * @param cx - Its centre. Unit: m.
   * @param cy - Its centre. Unit: m.
   * @param round - Its radius. Unit: m.
   * @param beforeX - Unit vector along the surface that ends there; 0 where none does.
   * @param beforeY - Unit vector along the surface that ends there; 0 where none does.
   * @param afterX - Unit vector along the surface that begins there; 0 where none does.
   * @param afterY - Unit vector along the surface that begins there; 0 where none does.
   */
  corner(
    cx: number,
    cy: number,
    round: number,
    beforeX: number,
    beforeY: number,
    afterX: number,
    afterY: number,
  ): void {
    const { dx, dy, radius } = this;
    const px = this.x - cx;
    const py = this.y - cy;
    const b = px * dx + py * dy;
    if (!(b < -ALONG * this.length * Math.sqrt(px * px + py * py)) || this.#isJoint(cx, cy, round)) return;
    const square = this.length * this.length;
    const sum = radius + round;
    const nearest = Math.min(1, -b / square);
    const offX = px + dx * nearest;
    const offY = py + dy * nearest;
    const off = Math.sqrt(offX * offX + offY * offY);
    if (!(off < sum + this.slack)) return;
    let time = nearest;
    if (off < sum) {
      const c = px * px + py * py - sum * sum;
      const half = Math.sqrt(sum * sum - off * off) / this.length; // of the chord, as a share of the way, without cancellation
      if (c <= 0) time = 0;
      else time = nearest < 1 ? nearest - half : c / (Math.sqrt(Math.max(0, b * b - square * c)) - b);
    }
    const hx = px + dx * time;
    const hy = py + dy * time;
    if (hx * beforeX + hy * beforeY < 0 || hx * afterX + hy * afterY > 0) return;
    const distance = Math.sqrt(hx * hx + hy * hy);
    if (distance === 0) return;
    const nx = hx / distance;
    const ny = hy / distance;
    const start = px * nx + py * ny - round;
    if (off < sum) this.meet(time, start, nx, ny);
    else this.#passed?.add(start, nx, ny);
  }

  /**
   * Something that is met: the first counts.
   * @param time - Where, as a share of the way.
   * @param distance - How far in front of the plane there the way begins. Unit: m.
   * @param normalX - Unit normal there.
   * @param normalY - Unit normal there.
   */
  meet(time: number, distance: number, normalX: number, normalY: number): void {
    if (!(time < this.time)) return;
    this.time = time;
    this.distance = distance;
    this.normalX = normalX;
    this.normalY = normalY;
  }

  /** Whether a round place only just touches a plane that the disc slides on: two boxes side by side make one floor. */
  #isJoint(cx: number, cy: number, round: number): boolean {
    const floors = this.#floors;
    const near = JOINT * this.radius;
    for (let f = 0; f < this.#floorCount * 3; f += 3) {
      if (Math.abs(cx * floors[f] + cy * floors[f + 1] + round - floors[f + 2]) <= near) return true;
    }
    return false;
  }
}
