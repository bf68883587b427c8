import type { Shape } from '@mass/core';

/** A place that a shape reports. */
export interface Place {
  readonly distance: number;
  readonly nx: number;
  readonly ny: number;
}

/** What a shape reports for a point. */
export function placesOf(shape: Shape, x: number, y: number, reach: number): Place[] {
  const places: Place[] = [];
  shape.findSurface(x, y, reach, { add: (distance, nx, ny) => places.push({ distance, nx, ny }) });
  return places;
}

export interface Point {
  readonly x: number;
  readonly y: number;
}

/** The distance of a point to the nearest of some segments, by a fine search along each that knows no projection. */
export function searchedDistance(p: Point, segments: readonly (readonly [Point, Point])[]): number {
  let least = Infinity;
  for (const [a, b] of segments) {
    let low = 0;
    let high = 1;
    const at = (t: number) => Math.hypot(a.x + (b.x - a.x) * t - p.x, a.y + (b.y - a.y) * t - p.y);
    // The distance along a segment falls and then rises: thirds close in on its least.
    for (let i = 0; i < 100; i++) {
      const third = (high - low) / 3;
      if (at(low + third) < at(high - third)) high -= third;
      else low += third;
    }
    least = Math.min(least, at(0), at(1), at((low + high) / 2));
  }
  return least;
}

/** The segments from each point to the next. */
export function segmentsOf(points: readonly Point[], closed: boolean): (readonly [Point, Point])[] {
  const pairs = points.map((point, i) => [point, points[(i + 1) % points.length]] as const);
  return closed ? pairs : pairs.slice(0, -1);
}

/** Whether a point lies inside a polygon, by the sum of the angles under which its edges are seen. */
export function windsAround(p: Point, points: readonly Point[]): boolean {
  let sum = 0;
  for (const [a, b] of segmentsOf(points, true)) {
    const ax = a.x - p.x;
    const ay = a.y - p.y;
    const bx = b.x - p.x;
    const by = b.y - p.y;
    sum += Math.atan2(ax * by - ay * bx, ax * bx + ay * by);
  }
  return Math.abs(sum) > Math.PI;
}
