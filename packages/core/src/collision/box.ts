import { requireFinite, requireOptions, requirePositive, requireVector } from '../math/checks.ts';
import { cos, sin } from '../math/trigonometry.ts';
import type { Vec2 } from '../math/vec2.ts';
import { Edges } from './edges.ts';
import type { Shape } from './shape.ts';
import { Surface, type SurfaceOptions } from './surface.ts';
import type { SurfaceReport } from './surface-report.ts';
import type { Sweep } from './sweep.ts';

/** How an immovable box is made. */
export interface BoxOptions extends SurfaceOptions {
  /** Unit: m. */
  centre: Readonly<Vec2>;
  /** Along its own x axis, positive. Unit: m. */
  width: number;
  /** Along its own y axis, positive. Unit: m. */
  height: number;
  /** How far it is turned, counter-clockwise. Unit: rad. @default 0 */
  angle?: number;
}

/**
 * An immovable, solid box. A particle whose centre is inside is pushed out through the nearest side. Boxes side by side make one floor
 * where the resolver looks ahead, as the sub-step resolver does: a disc slides over the joints and does not feel them.
 */
export class Box extends Surface implements Shape {
  readonly minX: number;
  readonly minY: number;
  readonly maxX: number;
  readonly maxY: number;
  /** Unit: m. */
  readonly centre: Readonly<Vec2>;
  /** Along its own x axis. Unit: m. */
  readonly width: number;
  /** Along its own y axis. Unit: m. */
  readonly height: number;
  /** How far it is turned, counter-clockwise. Unit: rad. */
  readonly angle: number;
  readonly #cos: number;
  readonly #sin: number;
  readonly #edges: Edges;

  constructor(options: BoxOptions) {
    requireOptions('Box', 'options', options, '{ centre: { x: 0, y: 0 }, width: 2, height: 1 }');
    super('Box', options);
    const { centre, width, height, angle = 0 } = options;
    requireVector('Box', 'centre', centre, 'metres');
    requirePositive('Box', 'width', width, 'metres');
    requirePositive('Box', 'height', height, 'metres');
    requireFinite('Box', 'angle', angle, 'radians');
    this.centre = Object.freeze({ x: centre.x, y: centre.y });
    this.width = width;
    this.height = height;
    this.angle = angle;
    this.#cos = cos(angle);
    this.#sin = sin(angle);
    const halfX = (Math.abs(this.#cos) * width + Math.abs(this.#sin) * height) / 2;
    const halfY = (Math.abs(this.#sin) * width + Math.abs(this.#cos) * height) / 2;
    this.minX = centre.x - halfX;
    this.minY = centre.y - halfY;
    this.maxX = centre.x + halfX;
    this.maxY = centre.y + halfY;
    this.#edges = new Edges(this.corners, true);
  }

  /** Its corners, counter-clockwise from the one at its own lower left. Unit: m. */
  get corners(): Vec2[] {
    return [-1, 1, 1, -1].map((side, corner) => {
      const u = (side * this.width) / 2;
      const v = ((corner < 2 ? -1 : 1) * this.height) / 2;
      return { x: this.centre.x + this.#cos * u - this.#sin * v, y: this.centre.y + this.#sin * u + this.#cos * v };
    });
  }

  findSurface(x: number, y: number, reach: number, surface: SurfaceReport): void {
    const dx = x - this.centre.x;
    const dy = y - this.centre.y;
    const u = this.#cos * dx + this.#sin * dy; // the point as the box sees it
    const v = this.#cos * dy - this.#sin * dx;
    const overU = Math.abs(u) - this.width / 2; // past its sides; negative within
    const overV = Math.abs(v) - this.height / 2;
    const signU = u < 0 ? -1 : 1;
    const signV = v < 0 ? -1 : 1;
    if (overU > 0 && overV > 0) {
      const distance = Math.sqrt(overU * overU + overV * overV);
      if (distance < reach) this.#add(distance, (overU / distance) * signU, (overV / distance) * signV, surface);
    } else if (overU > overV) {
      if (overU < reach) this.#add(overU, signU, 0, surface);
    } else if (overV < reach) {
      this.#add(overV, 0, signV, surface);
    }
  }

  sweep(sweep: Sweep): void {
    this.#edges.tell(sweep, 0, 'right');
  }

  #add(distance: number, nu: number, nv: number, surface: SurfaceReport): void {
    surface.add(distance, this.#cos * nu - this.#sin * nv, this.#sin * nu + this.#cos * nv);
  }
}
