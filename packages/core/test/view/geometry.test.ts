import { describe, expect, it } from 'vitest';
import { addArrow } from '../../src/view/arrow.ts';
import { addCoil, coilCount, coilRadius } from '../../src/view/coil.ts';
import { addCircle, addRounded, clipToHalfPlane, signedArea } from '../../src/view/geometry.ts';
import { addHatching } from '../../src/view/hatch.ts';
import { PathList, type PathPaint, pathKinds } from '../../src/view/index.ts';
import { Points } from '../../src/view/points.ts';
import { addSlack } from '../../src/view/sag.ts';

const paint: PathPaint = { color: '#000000', rgb: 0, alpha: 1, width: 2, together: true };

/** The points of a path, as pairs. */
function pathOf(list: PathList, p = 0): [number, number][] {
  const pairs: [number, number][] = [];
  for (let k = list.starts[p]; k < list.starts[p + 1]; k += 2) pairs.push([list.points[k], list.points[k + 1]]);
  return pairs;
}

function lengthOf(points: readonly [number, number][]): number {
  return points.slice(1).reduce((sum, [x, y], k) => sum + Math.hypot(x - points[k][0], y - points[k][1]), 0);
}

function pointsOf(...pairs: [number, number][]): Points {
  const points = new Points();
  for (const [x, y] of pairs) points.add(x, y);
  return points;
}

describe('PathList', () => {
  it('keeps paths one after the other, and grows', () => {
    const list = new PathList();
    for (let n = 0; n < 500; n++) list.line(n, 1, n, 2, paint);
    expect(list.count).toBe(500);
    expect(pathOf(list, 499)).toEqual([
      [499, 1],
      [499, 2],
    ]);
    expect(list.kinds[499]).toBe(pathKinds.line);
    const { version } = list;
    list.clear();
    expect(list.count).toBe(0);
    expect(list.version).toBe(version + 1);
  });
});

describe('a spring', () => {
  const crests = (length: number, rest = 100, coils = 9): number => {
    const list = new PathList();
    addCoil(list, 0, 0, length, 0, rest, coils, 16, paint);
    const ys = pathOf(list).map(([, y]) => y);
    return ys.filter((y, k) => k > 0 && k < ys.length - 1 && y > ys[k - 1] && y > ys[k + 1]).length;
  };

  it('has as many coils however far it is stretched', () => {
    expect([50, 100, 200, 500].map((length) => crests(length))).toEqual([9, 9, 9, 9]);
  });

  it('grows narrower as it is stretched, wider as it is pressed', () => {
    const radii = [40, 70, 100, 150, 300].map((length) => coilRadius(16, 100, length));
    expect(radii).toEqual([...radii].sort((a, b) => b - a));
    expect(new Set(radii).size).toBe(5);
    expect(coilRadius(16, 100, 100)).toBe(8);
    expect(coilRadius(16, 100, 1e9)).toBeGreaterThan(2);
  });

  it('begins and ends where its ends are, also where those are one', () => {
    const list = new PathList();
    addCoil(list, 3, 4, 50, 60, 30, 9, 16, paint);
    addCoil(list, 3, 4, 3, 4, 30, 9, 16, paint);
    expect(pathOf(list)[0]).toEqual([3, 4]);
    expect(pathOf(list).at(-1)).toEqual([50, 60]);
    expect(pathOf(list, 1).flat().every(Number.isFinite)).toBe(true);
  });

  it('has fewer coils where it is small on the screen, and narrower ones', () => {
    expect(coilCount(9, 100, 1.75)).toBe(9);
    expect(coilCount(9, 12, 1.75)).toBe(2);
    expect(coilCount(9, 1, 1.75)).toBe(1);
    expect(coilRadius(16, 12, 12)).toBe(3);
  });

  it('without coils is straight', () => {
    const list = new PathList();
    addCoil(list, 0, 0, 100, 0, 80, 0, 16, paint);
    expect(pathOf(list).flat()).toEqual([0, 0, 100, 0]);
  });

  it('without a rest length is as wide as the style says', () => {
    expect(coilCount(9, 0, 1.75)).toBe(9);
    expect(coilRadius(16, 0, 32)).toBe(8);
  });
});

describe('a slack line', () => {
  const hang = (x1: number, y1: number, length: number, gx = 0, gy = 1): [number, number][] => {
    const list = new PathList();
    addSlack(list, 0, 0, x1, y1, length, gx, gy, paint);
    return pathOf(list);
  };

  it('is drawn as long as it is', () => {
    for (const [x, y, length] of [
      [100, 0, 101],
      [100, 0, 130],
      [100, 80, 200],
      [0, 100, 160],
      [0, 0, 100],
      [5, -60, 300],
    ]) {
      const drawn = lengthOf(hang(x, y, length));
      expect(Math.abs(drawn - length)).toBeLessThan(0.004 * length);
    }
  });

  it('is straight when taut, or stretched', () => {
    expect(hang(100, 0, 100)).toEqual([
      [0, 0],
      [100, 0],
    ]);
    expect(hang(100, 0, 60).length).toBe(2);
  });

  it('hangs the way that things fall', () => {
    expect(Math.max(...hang(100, 0, 130).map(([, y]) => y))).toBeGreaterThan(30);
    expect(Math.min(...hang(100, 0, 130, 0, -1).map(([, y]) => y))).toBeLessThan(-30);
    expect(Math.max(...hang(0, 100, 130, 1, 0).map(([x]) => x))).toBeGreaterThan(30);
  });
});

describe('hatching', () => {
  const view = { left: 0, top: 0, width: 200, height: 200 };
  const square = pointsOf([20, 20], [120, 20], [120, 120], [20, 120]);

  const hatch = (points: Points, spacing = 10, within = view): PathList => {
    const list = new PathList();
    addHatching(list, points, spacing, within, paint);
    return list;
  };

  it('lies within the shape, at even distances', () => {
    const list = hatch(square);
    expect(list.count).toBeGreaterThan(10);
    const sums = new Set<number>();
    for (let p = 0; p < list.count; p++) {
      for (const [x, y] of pathOf(list, p)) {
        expect(Math.min(x, y)).toBeGreaterThanOrEqual(20 - 1e-9);
        expect(Math.max(x, y)).toBeLessThanOrEqual(120 + 1e-9);
        sums.add(Math.round((x + y) * 1e6) / 1e6);
      }
    }
    const sorted = [...sums].sort((a, b) => a - b);
    for (let k = 1; k < sorted.length; k++) {
      expect((sorted[k] - sorted[k - 1]) / Math.SQRT2).toBeCloseTo(10, 4);
    }
  });

  it('leaves out what a notch leaves out', () => {
    const notched = pointsOf([0, 0], [100, 0], [100, 100], [50, 10], [0, 100]);
    const list = hatch(notched);
    for (let p = 0; p < list.count; p++) {
      const [[x0, y0], [x1, y1]] = pathOf(list, p);
      const x = (x0 + x1) / 2;
      expect((y0 + y1) / 2).toBeLessThan(10 + (90 * Math.abs(x - 50)) / 50 + 1e-6);
    }
  });

  it('goes with the scenery when the camera moves', () => {
    const moved = pointsOf([27, 23], [127, 23], [127, 123], [27, 123]);
    const before = pathOf(hatch(square), 3);
    const after = pathOf(hatch(moved, 10, { ...view, left: 7, top: 3 }), 3);
    expect(after[0][0]).toBeCloseTo(before[0][0] + 7, 9);
    expect(after[0][1]).toBeCloseTo(before[0][1] + 3, 9);
  });

  it('is drawn in the view alone, however large the shape', () => {
    const list = hatch(pointsOf([-1e6, -1e6], [1e6, -1e6], [1e6, 1e6], [-1e6, 1e6]));
    expect(list.count).toBeLessThan(40);
  });
});

describe('outlines', () => {
  const grow = (points: Points, radius: number, inwards = false): Points => {
    const grown = new Points();
    addRounded(grown, points.data, points.count, new Float64Array(points.count).fill(radius), inwards);
    return grown;
  };
  const areaOf = (points: Points): number => Math.abs(signedArea(points.data, points.count)) / 2;
  const square: [number, number][] = [
    [0, 0],
    [100, 0],
    [100, 100],
    [0, 100],
  ];

  it('grow by the radius, round at the corners, either way round', () => {
    const expected = 100 * 100 + 4 * 100 * 10 + Math.PI * 100;
    expect(areaOf(grow(pointsOf(...square), 10)) / expected).toBeCloseTo(1, 3);
    expect(areaOf(grow(pointsOf(...square.toReversed()), 10)) / expected).toBeCloseTo(1, 3);
  });

  it('stay sharp without a radius', () => {
    const { data, count } = grow(pointsOf(...square), 0);
    expect(count).toBe(4);
    expect([...data.subarray(0, 8)]).toEqual(square.flat());
  });

  it('follow a corner that goes in', () => {
    const arrow = pointsOf([0, 0], [100, 50], [0, 100], [40, 50]);
    const { data, count } = grow(arrow, 5);
    for (let i = 0; i < count; i++) {
      const distances = [0, 1, 2, 3].map((k) =>
        Math.hypot(data[2 * i] - arrow.data[2 * k], data[2 * i + 1] - arrow.data[2 * k + 1]),
      );
      expect(Math.min(...distances)).toBeLessThan(12);
    }
  });

  it('of a line there and back are a capsule', () => {
    const capsule = grow(pointsOf([0, 0], [100, 0]), 10);
    expect(areaOf(capsule) / (100 * 20 + Math.PI * 100)).toBeCloseTo(1, 2);
  });

  it('shrink inwards', () => {
    expect(areaOf(grow(pointsOf(...square), 10, true))).toBeCloseTo(80 * 80, 6);
  });

  it('stand for circles to a tenth of a pixel', () => {
    for (const radius of [2, 10, 100, 300]) {
      const points = new Points();
      addCircle(points, 0, 0, radius);
      expect(radius * (1 - Math.cos(Math.PI / points.count))).toBeLessThan(0.1);
    }
  });
});

describe('clipping', () => {
  const square = [0, 0, 10, 0, 10, 10, 0, 10];
  const out = new Float64Array(12);

  it('keeps the side that the normal points away from', () => {
    const count = clipToHalfPlane(square, 4, 0, 4, 0, -1, out);
    expect(count).toBe(4);
    expect(Math.abs(signedArea(out, count)) / 2).toBe(60);
    expect(clipToHalfPlane(square, 4, 0, -1, 0, 1, out)).toBe(0);
    expect(clipToHalfPlane(square, 4, 0, 20, 0, 1, out)).toBe(4);
  });

  it('cuts a corner off', () => {
    const count = clipToHalfPlane(square, 4, 8, 0, Math.SQRT1_2, Math.SQRT1_2, out);
    expect(Math.abs(signedArea(out, count)) / 2).toBeCloseTo(32, 9);
  });
});

describe('an arrow', () => {
  const arrow = (dx: number, dy: number, longest = 100): PathList => {
    const list = new PathList();
    addArrow(list, 10, 10, dx, dy, longest, paint, { ...paint, width: 0 });
    return list;
  };

  it('ends at its tip', () => {
    const list = arrow(30, 40);
    expect(pathOf(list, 0)[0]).toEqual([10, 10]);
    expect(pathOf(list, 1)[0]).toEqual([40, 50]);
    expect(list.kinds[1]).toBe(pathKinds.fill);
  });

  it('is no longer than allowed, and is left out where it is but a dot', () => {
    expect(pathOf(arrow(3e9, 0), 1)[0][0]).toBeCloseTo(110, 6);
    expect(arrow(1, 0).count).toBe(0);
    expect(arrow(Number.NaN, 0).count).toBe(0);
  });
});
