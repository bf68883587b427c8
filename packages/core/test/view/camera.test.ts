import { describe, expect, it } from 'vitest';
import { Camera } from '../../src/view/index.ts';

function camera(): Camera {
  return new Camera({ x: 3, y: -2, pixelsPerMetre: 40, width: 800, height: 600 });
}

describe('Camera', () => {
  it('puts its centre in the middle of the viewport', () => {
    expect(camera().toScreenX(3)).toBe(400);
    expect(camera().toScreenY(-2)).toBe(300);
  });

  it('flips y: up in the world is up on the screen, where y runs down', () => {
    expect(camera().toScreenY(-1)).toBe(260);
    expect(camera().toScreenX(4)).toBe(440);
  });

  it('goes to the screen and back without loss', () => {
    const view = camera();
    for (const value of [-17.3, 0, 2.5, 1e4]) {
      expect(view.toWorldX(view.toScreenX(value))).toBeCloseTo(value, 9);
      expect(view.toWorldY(view.toScreenY(value))).toBeCloseTo(value, 9);
    }
  });

  it('moves what is seen with the pointer', () => {
    const view = camera();
    const x = view.toWorldX(100);
    const y = view.toWorldY(100);
    view.pan(30, -20);
    expect(view.toScreenX(x)).toBeCloseTo(130, 9);
    expect(view.toScreenY(y)).toBeCloseTo(80, 9);
  });

  it.each([0.5, 1, 1.1, 20])('zooms by %d about a point that stays', (factor) => {
    const view = camera();
    const x = view.toWorldX(123);
    const y = view.toWorldY(456);
    view.zoomAt(123, 456, factor);
    expect(view.pixelsPerMetre).toBeCloseTo(40 * factor, 9);
    expect(view.toScreenX(x)).toBeCloseTo(123, 9);
    expect(view.toScreenY(y)).toBeCloseTo(456, 9);
  });

  it('zooms without end and stays finite', () => {
    const view = camera();
    for (let i = 0; i < 2000; i++) view.zoomAt(10, 10, 2);
    expect(view.pixelsPerMetre).toBe(1e9);
    for (let i = 0; i < 2000; i++) view.zoomAt(10, 10, 0.5);
    expect(view.pixelsPerMetre).toBe(1e-6);
    expect(Number.isFinite(view.x)).toBe(true);
  });

  it('fits a box: all of it is seen, centred, and one side touches the padding', () => {
    const view = camera();
    view.fit({ minX: -10, minY: 0, maxX: 10, maxY: 5 }, 20);
    expect(view.toScreenX(-10)).toBeCloseTo(20, 9);
    expect(view.toScreenX(10)).toBeCloseTo(780, 9);
    expect(view.toScreenY(2.5)).toBeCloseTo(300, 9);
    expect(view.toScreenY(5)).toBeGreaterThan(20);
  });

  it('keeps a fitted box in view through a resize, until it is moved', () => {
    const view = camera();
    view.fit({ minX: -10, minY: 0, maxX: 10, maxY: 5 });
    view.resize(400, 600);
    expect(view.toScreenX(-10)).toBeCloseTo(0, 9);
    expect(view.toScreenX(10)).toBeCloseTo(400, 9);
    view.pan(10, 0);
    const { x, pixelsPerMetre } = view;
    view.resize(900, 300);
    expect(view.x).toBe(x);
    expect(view.pixelsPerMetre).toBe(pixelsPerMetre);
  });

  it('keeps its scale while the viewport is hidden', () => {
    const view = camera();
    view.fit({ minX: -10, minY: 0, maxX: 10, maxY: 5 }, 30);
    const { pixelsPerMetre } = view;
    view.resize(0, 0);
    expect(view.pixelsPerMetre).toBe(pixelsPerMetre);
    view.resize(800, 600);
    expect(view.pixelsPerMetre).toBe(pixelsPerMetre);
  });

  it('fits a flat box by its longer side', () => {
    const view = camera();
    view.fit({ minX: 0, minY: 4, maxX: 8, maxY: 4 });
    expect(view.pixelsPerMetre).toBe(100);
  });

  it('refuses what would draw nothing, and says so', () => {
    expect(() => new Camera({ pixelsPerMetre: 0 })).toThrow(
      'Camera.pixelsPerMetre: pixelsPerMetre must be a positive, finite number of pixels per metre; got 0.',
    );
    expect(() => camera().zoomAt(0, 0, Number.NaN)).toThrow(RangeError);
    expect(() => camera().pan(Number.NaN, 0)).toThrow(RangeError);
    expect(() => camera().resize(-1, 5)).toThrow(RangeError);
    expect(() => camera().fit({ minX: 1, minY: 1, maxX: 1, maxY: 1 })).toThrow('longer side');
    expect(() => camera().fit({ minX: 2, minY: 1, maxX: 1, maxY: 1 })).toThrow(RangeError);
  });
});
