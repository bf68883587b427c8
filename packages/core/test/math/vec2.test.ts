import { Random, vec2 } from '@mass/core';
import { describe, expect, it } from 'vitest';

const point = (x: number, y: number) => Object.freeze({ x, y });
const zero = point(0, 0);
const a = point(3, 4);
const b = point(-1, 2);

describe('vec2', () => {
  it('[M4] adds, subtracts, scales', () => {
    expect(vec2.add(a, b)).toEqual({ x: 2, y: 6 });
    expect(vec2.subtract(a, b)).toEqual({ x: 4, y: 2 });
    expect(vec2.scale(a, -2)).toEqual({ x: -6, y: -8 });
    expect(vec2.addScaled(a, b, 10)).toEqual({ x: -7, y: 24 });
  });

  it('[M4] dot is 0 for right angles, cross is positive to the left', () => {
    expect(vec2.dot(a, b)).toBe(5);
    expect(vec2.dot(a, vec2.perpendicular(a))).toBe(0);
    expect(vec2.cross(a, b)).toBe(10);
    expect(vec2.cross(b, a)).toBe(-10);
    expect(vec2.cross(point(1, 0), point(0, 1))).toBe(1);
    expect(vec2.cross(a, a)).toBe(0);
  });

  it('[M4] measures length, distance and angle', () => {
    expect(vec2.length(a)).toBe(5);
    expect(vec2.distance(a, point(0, 0))).toBe(5);
    expect(vec2.distance(a, b)).toBe(Math.sqrt(20));
    expect(vec2.angle(point(0, 2))).toBe(Math.PI / 2);
    expect(vec2.angle(point(-1, 0))).toBe(Math.PI);
    expect(vec2.angle(point(1, -1))).toBe(-Math.PI / 4);
  });

  it('[M4] normalises to length 1 in the same direction', () => {
    expect(vec2.normalise(a)).toEqual({ x: 0.6, y: 0.8 });
    const random = new Random(8);
    for (let i = 0; i < 1000; i++) {
      const v = point(random.between(-1e6, 1e6), random.between(-1e-6, 1e-6));
      const unit = vec2.normalise(v);
      expect(vec2.length(unit)).toBeCloseTo(1, 14);
      expect(vec2.dot(unit, v)).toBeGreaterThan(0);
      expect(Math.abs(vec2.cross(unit, v))).toBeLessThan(1e-9);
    }
  });

  it('[M4] perpendicular turns a quarter to the left', () => {
    expect(vec2.perpendicular(a)).toEqual({ x: -4, y: 3 });
    expect(vec2.cross(a, vec2.perpendicular(a))).toBe(25);
    expect(vec2.perpendicular(point(1, 0))).toEqual({ x: 0, y: 1 });
  });

  it('[M4] the zero vector has no direction and gives no NaN', () => {
    expect(vec2.normalise(zero)).toEqual({ x: 0, y: 0 });
    expect(vec2.length(zero)).toBe(0);
    expect(vec2.angle(zero)).toBe(0);
    expect(vec2.perpendicular(zero)).toEqual({ x: 0, y: 0 });
    expect(vec2.distance(a, a)).toBe(0);
  });

  it('[M4] the result is a new vector, never an argument', () => {
    for (const result of [
      vec2.add(a, zero),
      vec2.subtract(a, zero),
      vec2.scale(a, 1),
      vec2.addScaled(a, b, 0),
      vec2.normalise(point(1, 0)),
      vec2.normalise(zero),
      vec2.perpendicular(zero),
    ]) {
      expect(Object.isFrozen(result)).toBe(false);
    }
  });

  it('[M4] each function is covered here', () => {
    expect(Object.keys(vec2).sort()).toEqual([
      'add',
      'addScaled',
      'angle',
      'cross',
      'distance',
      'dot',
      'length',
      'normalise',
      'perpendicular',
      'scale',
      'subtract',
    ]);
  });
});
