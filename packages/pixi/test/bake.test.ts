import { describe, expect, it } from 'vitest';
import { bakeLine, bakeRing } from '../src/bake.ts';

function area(image: Uint8Array): number {
  let sum = 0;
  for (let at = 3; at < image.length; at += 4) sum += image[at] / 255;
  return sum;
}

function ring(size: number, inner: number, outer: number): Uint8Array {
  const image = new Uint8Array(size * size * 4);
  bakeRing(image, size, 0, 0, size, inner, outer);
  return image;
}

describe('bakeRing', () => {
  it.each([1, 2, 3.3, 10, 50])('covers the area of a disc of radius %d', (radius) => {
    const covered = area(ring(2 * Math.ceil(radius + 1), 0, radius));
    expect(covered / (Math.PI * radius * radius)).toBeCloseTo(1, radius < 2 ? 0 : 1);
  });

  it('covers the area of a ring, and leaves its middle empty', () => {
    const image = ring(44, 18, 20);
    expect(area(image) / (Math.PI * (20 * 20 - 18 * 18))).toBeCloseTo(1, 1);
    expect(image[(22 * 44 + 22) * 4 + 3]).toBe(0);
  });

  it('leaves a clear border, so that shapes do not bleed into one another', () => {
    const image = ring(22, 0, 10);
    for (let i = 0; i < 22; i++) {
      expect(image[i * 4 + 3]).toBe(0);
      expect(image[i * 22 * 4 + 3]).toBe(0);
    }
  });

  it('is white with premultiplied alpha', () => {
    const image = ring(12, 2, 4.5);
    for (let at = 0; at < image.length; at += 4) {
      expect([image[at], image[at + 1], image[at + 2]]).toEqual([image[at + 3], image[at + 3], image[at + 3]]);
    }
  });

  it('stays inside its square of a larger image', () => {
    const image = new Uint8Array(32 * 32 * 4);
    bakeRing(image, 32, 10, 12, 8, 0, 3);
    for (let y = 0; y < 32; y++) {
      for (let x = 0; x < 32; x++) {
        if (x < 10 || x >= 18 || y < 12 || y >= 20) expect(image[(y * 32 + x) * 4]).toBe(0);
      }
    }
    expect(image[(16 * 32 + 14) * 4]).toBe(255);
  });
});

describe('bakeLine', () => {
  it.each([0.25, 1, 2.5, 6])('is as strong as a line %d pixels wide', (width) => {
    const height = 2 * Math.ceil(width / 2 + 1);
    const image = new Uint8Array(3 * height * 4);
    bakeLine(image, 3, 0, 0, 3, height, width);
    expect(area(image) / 3).toBeCloseTo(width, 1);
  });
});
