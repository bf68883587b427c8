import { Box, Disc, HalfPlane, Polygon, Polyline, Random, Segment, type Shape } from '@mass/core';
import { describe, expect, it } from 'vitest';
import { type Point, placesOf, searchedDistance, segmentsOf, windsAround } from './surface.ts';

const random = new Random(77);
const REACH = 0.8;

function randomPoint(size: number = 3): Point {
  return { x: random.between(-size, size), y: random.between(-size, size) };
}

/** A polygon around (0, 0), convex or not, that does not cross itself: points at growing angles. */
function starPolygon(corners: number, least: number): Point[] {
  return Array.from({ length: corners }, (_, i) => {
    const angle = ((i + random.between(0, 0.8)) / corners) * 2 * Math.PI;
    const radius = random.between(least, 2);
    return { x: radius * Math.cos(angle), y: radius * Math.sin(angle) };
  });
}

/** A shape, and the signed distance of a point to it by other means. */
interface Sample {
  readonly shape: Shape;
  readonly distance: (p: Point) => number;
}

const samples: Record<string, () => Sample> = {
  'half-plane': () => {
    const point = randomPoint();
    const angle = random.between(0, 7);
    const normal = { x: 3 * Math.cos(angle), y: 3 * Math.sin(angle) };
    const distance = (p: Point) => Math.cos(angle) * (p.x - point.x) + Math.sin(angle) * (p.y - point.y);
    return { shape: new HalfPlane({ point, normal }), distance };
  },
  segment: () => {
    const [a, b, thickness] = [randomPoint(), randomPoint(), random.between(0, 1)];
    const distance = (p: Point) => searchedDistance(p, [[a, b]]) - thickness / 2;
    return { shape: new Segment({ a, b, thickness }), distance };
  },
  'open polyline': () => {
    const points = Array.from({ length: random.integer(2, 9) }, () => randomPoint());
    const thickness = random.between(0, 0.5);
    const distance = (p: Point) => searchedDistance(p, segmentsOf(points, false)) - thickness / 2;
    return { shape: new Polyline({ points, thickness }), distance };
  },
  'closed polyline': () => {
    const points = Array.from({ length: random.integer(3, 9) }, () => randomPoint());
    const distance = (p: Point) => searchedDistance(p, segmentsOf(points, true));
    return { shape: new Polyline({ points, closed: true }), distance };
  },
  disc: () => {
    const [centre, radius] = [randomPoint(), random.between(0.1, 2)];
    return {
      shape: new Disc({ centre, radius }),
      distance: (p) => Math.hypot(p.x - centre.x, p.y - centre.y) - radius,
    };
  },
  box: () => {
    const [centre, width, height] = [randomPoint(1), random.between(0.1, 3), random.between(0.1, 3)];
    const box = new Box({ centre, width, height, angle: random.between(-7, 7) });
    return { shape: box, distance: signed(box.corners) };
  },
  polygon: () => {
    const points = starPolygon(random.integer(3, 12), 0.3);
    if (random.next() < 0.5) points.reverse();
    return { shape: new Polygon({ points }), distance: signed(points) };
  },
};

function signed(points: readonly Point[]): (p: Point) => number {
  return (p) => searchedDistance(p, segmentsOf(points, true)) * (windsAround(p, points) ? -1 : 1);
}

describe.each(Object.entries(samples))('%s', (_name, make) => {
  it('[C1] the least distance that it reports is the signed distance, and beyond reach it reports nothing', () => {
    for (let round = 0; round < 300; round++) {
      const { shape, distance } = make();
      for (let i = 0; i < 10; i++) {
        const p = randomPoint();
        const expected = distance(p);
        if (Math.abs(expected - REACH) < 1e-9) continue;
        const places = placesOf(shape, p.x, p.y, REACH);
        if (expected > REACH) expect(places).toEqual([]);
        else expect(Math.min(...places.map((place) => place.distance))).toBeCloseTo(expected, 7);
      }
    }
  });

  it('[C1] each place lies on the surface, along a unit normal', () => {
    for (let round = 0; round < 300; round++) {
      const { shape, distance } = make();
      for (let i = 0; i < 10; i++) {
        const p = randomPoint();
        for (const { distance: d, nx, ny } of placesOf(shape, p.x, p.y, REACH)) {
          expect(Math.hypot(nx, ny)).toBeCloseTo(1, 12);
          // Rounded ends of thick chains lie inside the next segment: there the place is within, never outside.
          expect(distance({ x: p.x - d * nx, y: p.y - d * ny })).toBeLessThan(1e-6);
        }
      }
    }
  });

  it('[C2] its bounds hold every point that it reports anything negative for', () => {
    for (let round = 0; round < 300; round++) {
      const { shape, distance } = make();
      const p = randomPoint();
      if (distance(p) > -1e-9) continue;
      expect(p.x).toBeGreaterThan(shape.minX);
      expect(p.x).toBeLessThan(shape.maxX);
      expect(p.y).toBeGreaterThan(shape.minY);
      expect(p.y).toBeLessThan(shape.maxY);
    }
  });
});

describe('corners', () => {
  it('[C3] a disc over a chain of points in a line, or bent outwards, touches once, wherever it stands', () => {
    const flat = Array.from({ length: 41 }, (_, i) => ({ x: i * 0.1 - 2, y: 0.3 * i - 6 }));
    const hill = Array.from({ length: 41 }, (_, i) => ({ x: i * 0.1 - 2, y: -0.2 * (i * 0.1 - 2) ** 2 }));
    for (const points of [flat, hill]) {
      const chain = new Polyline({ points });
      for (const { x, y } of points.slice(5, -5)) {
        for (const dx of [-0.05, -1e-3, 0, 1e-3, 0.03]) expect(placesOf(chain, x + dx, y + 0.25, 0.3)).toHaveLength(1);
      }
    }
  });

  it('[C3] the normal turns without a jump as a disc goes over a corner that sticks out', () => {
    const chain = new Polyline({ points: [{ x: -1, y: 0 }, { x: 0, y: 0 }, { x: 1, y: -1 }] }); // biome-ignore format: one line
    let before = placesOf(chain, -0.5, 0.2, 0.3)[0];
    for (let i = 0; i <= 1000; i++) {
      const turn = Math.PI / 2 - (Math.PI / 4) * Math.min(Math.max(0, (i - 200) / 600), 1);
      const along = (i < 200 ? i - 200 : Math.max(0, i - 800)) / 500;
      const x = i < 200 ? along : along * Math.SQRT1_2;
      const y = i < 200 ? 0 : -along * Math.SQRT1_2;
      const places = placesOf(chain, x + 0.2 * Math.cos(turn), y + 0.2 * Math.sin(turn), 0.3);
      expect(places).toHaveLength(1);
      expect(places[0].distance).toBeCloseTo(0.2, 9);
      expect(Math.hypot(places[0].nx - before.nx, places[0].ny - before.ny)).toBeLessThan(0.01);
      before = places[0];
    }
  });

  it('[C3] a groove holds a disc from both sides, in a chain and in a polygon', () => {
    const groove = [{ x: -1, y: 1 }, { x: 0, y: 0 }, { x: 1, y: 1 }]; // biome-ignore format: one line
    const solid = [...groove, { x: 1, y: -1 }, { x: -1, y: -1 }];
    for (const shape of [new Polyline({ points: groove }), new Polygon({ points: solid })]) {
      const places = placesOf(shape, 0, 0.4, 0.3);
      expect(places.map(({ distance }) => distance)).toEqual([0.4 * Math.SQRT1_2, 0.4 * Math.SQRT1_2].map(about));
      expect(places.map(({ nx }) => Math.sign(nx)).sort()).toEqual([-1, 1]);
      expect(places.every(({ ny }) => ny > 0)).toBe(true);
    }
  });

  it('[C3] an edge of a polygon does not push from behind: a plank thinner than a disc holds it up', () => {
    const plank = new Polygon({ points: [{ x: -1, y: 0 }, { x: 1, y: 0 }, { x: 1, y: 0.1 }, { x: -1, y: 0.1 }] }); // biome-ignore format: one line
    expect(placesOf(plank, 0.2, 0.3, 0.5)).toEqual([{ distance: about(0.2), nx: about(0), ny: about(1) }]);
  });

  it('[C3] on the middle line of a segment, the centre of a disc or of a box, some normal is given', () => {
    const shapes = [
      new Segment({ a: { x: -1, y: 0 }, b: { x: 1, y: 0 } }),
      new Polyline({ points: [{ x: -1, y: 0 }, { x: 0, y: 0 }, { x: 0, y: 1 }] }), // biome-ignore format: one line
      new Disc({ centre: { x: 0, y: 0 }, radius: 1 }),
      new Box({ centre: { x: 0, y: 0 }, width: 1, height: 1 }),
      new Polygon({ points: [{ x: 0, y: 0 }, { x: 1, y: 0 }, { x: 0, y: 1 }] }), // biome-ignore format: one line
    ];
    for (const shape of shapes) {
      const places = placesOf(shape, 0, 0, 0.1);
      expect(places.length).toBeGreaterThan(0);
      for (const { distance, nx, ny } of places) {
        expect(distance).toBeLessThanOrEqual(0);
        expect(nx * nx + ny * ny).toBeCloseTo(1, 12);
      }
    }
  });

  it('[C3] a polygon reports the same, bit for bit, whichever way round its points are given', () => {
    const points = starPolygon(9, 0.5);
    const one = new Polygon({ points });
    const other = new Polygon({ points: points.toReversed() });
    for (let i = 0; i < 200; i++) {
      const p = randomPoint(2);
      const byNormal = (shape: Shape) => placesOf(shape, p.x, p.y, 0.5).toSorted((a, b) => a.nx - b.nx);
      expect(byNormal(other)).toEqual(byNormal(one));
    }
  });
});

function about(value: number): unknown {
  return expect.closeTo(value, 12);
}

describe('what makes no sense', () => {
  const point = { x: 0, y: 0 };
  it.each([
    ['Segment', () => new Segment({ a: point, b: point }), 'apart'],
    ['Segment', () => new Segment({ a: point, b: { x: NaN, y: 0 } }), 'finite'],
    ['Segment', () => new Segment({ a: point, b: { x: 1, y: 0 }, thickness: -1 }), 'thickness'],
    ['Segment', () => new Segment(undefined as never), 'object'],
    ['Polyline', () => new Polyline({ points: [point] }), 'at least 2'],
    ['Polyline', () => new Polyline({ points: [point, { x: 1, y: 0 }], closed: true }), 'at least 3'],
    ['Polyline', () => new Polyline({ points: [point, { x: 1, y: 0 }, { x: 1, y: 0 }] }), 'points 1 and 2'],
    ['Polyline', () => new Polyline({ points: 'zigzag' as never }), 'array'],
    ['Polyline', () => new Polyline({ points: [point, { x: 1, y: 0 }], restitution: 2 }), 'restitution'],
    ['Disc', () => new Disc({ centre: point, radius: 0 }), 'radius'],
    ['Disc', () => new Disc({ centre: null as never, radius: 1 }), 'centre'],
    ['Box', () => new Box({ centre: point, width: -1, height: 1 }), 'width'],
    ['Box', () => new Box({ centre: point, width: 1, height: Infinity }), 'height'],
    ['Box', () => new Box({ centre: point, width: 1, height: 1, angle: NaN }), 'angle'],
    ['Polygon', () => new Polygon({ points: [point, { x: 1, y: 0 }] }), 'at least 3'],
    ['Polygon', () => new Polygon({ points: [point, { x: 1, y: 0 }, { x: 2, y: 0 }] }), 'edges must not meet'],
    [
      'Polygon',
      () => new Polygon({ points: [point, { x: 1, y: 1 }, { x: 1, y: 0 }, { x: 0, y: 1 }] }),
      'points 0 and 2',
    ],
    ['Polygon', () => new Polygon({ points: [point, { x: 1, y: 0 }, { x: 1, y: 1 }, point] }), 'points 3 and 0'],
  ])('[C4] %s says so', (name, make, part) => {
    expect(make).toThrow(name);
    expect(make).toThrow(part);
  });

  it('[C4] points are copied: what the caller does to them later does not matter', () => {
    const points = [{ x: 0, y: 0 }, { x: 1, y: 0 }]; // biome-ignore format: one line
    const chain = new Polyline({ points });
    points[0].x = 100;
    expect(chain.points[0]).toEqual({ x: 0, y: 0 });
  });
});
