import { requireFinite, requireNonNegative, requireOrdered, requirePositive } from '../math/checks.ts';
import type { Bounds } from './bounds.ts';

/** What a camera starts with; every field may be left out. */
export interface CameraOptions {
  /** Centre of the view. Unit: m. @default 0 */
  readonly x?: number;
  /** Centre of the view, up. Unit: m. @default 0 */
  readonly y?: number;
  /** Scale. Unit: CSS px per m. @default 50 */
  readonly pixelsPerMetre?: number;
  /** Width of the viewport. Unit: CSS px. @default 0 */
  readonly width?: number;
  /** Height of the viewport. Unit: CSS px. @default 0 */
  readonly height?: number;
}

const SMALLEST_SCALE = 1e-6;
const LARGEST_SCALE = 1e9;

/**
 * From the world (metres, y up) to the screen (CSS pixels, y down, 0 at the top left) and back. The one place where y is
 * flipped. Renderers read it; the game moves it.
 */
export class Camera {
  #x = 0;
  #y = 0;
  #scale = 50;
  #width = 0;
  #height = 0;
  #fitted: Bounds | null = null;
  #padding = 0;

  constructor({ x = 0, y = 0, pixelsPerMetre = 50, width = 0, height = 0 }: CameraOptions = {}) {
    this.x = x;
    this.y = y;
    this.pixelsPerMetre = pixelsPerMetre;
    this.resize(width, height);
  }

  /** Centre of the view. Setting it ends a fit. Unit: m. */
  get x(): number {
    return this.#x;
  }
  set x(value: number) {
    requireFinite('Camera.x', 'x', value, 'metres');
    this.#x = value;
    this.#fitted = null;
  }

  /** Centre of the view, up. Setting it ends a fit. Unit: m. */
  get y(): number {
    return this.#y;
  }
  set y(value: number) {
    requireFinite('Camera.y', 'y', value, 'metres');
    this.#y = value;
    this.#fitted = null;
  }

  /** Scale. Setting it ends a fit. Unit: CSS px per m. */
  get pixelsPerMetre(): number {
    return this.#scale;
  }
  set pixelsPerMetre(value: number) {
    requirePositive('Camera.pixelsPerMetre', 'pixelsPerMetre', value, 'pixels per metre');
    this.#scale = value;
    this.#fitted = null;
  }

  /** Width of the viewport; set by `resize`. Unit: CSS px. */
  get width(): number {
    return this.#width;
  }

  /** Height of the viewport; set by `resize`. Unit: CSS px. */
  get height(): number {
    return this.#height;
  }

  /** Screen position of a world position. Unit: CSS px from the left. */
  toScreenX(x: number): number {
    return (x - this.#x) * this.#scale + this.#width / 2;
  }

  /** Screen position of a world position. Unit: CSS px from the top. */
  toScreenY(y: number): number {
    return (this.#y - y) * this.#scale + this.#height / 2;
  }

  /** World position of a screen position. Unit: m. */
  toWorldX(screenX: number): number {
    return (screenX - this.#width / 2) / this.#scale + this.#x;
  }

  /** World position of a screen position. Unit: m, up. */
  toWorldY(screenY: number): number {
    return (this.#height / 2 - screenY) / this.#scale + this.#y;
  }

  /**
   * Shows all of `bounds`, centred, as large as fits with `padding` CSS px left free on each side, and keeps showing it
   * through `resize` until the camera is moved. One side of the box may be 0, not both.
   */
  fit(bounds: Bounds, padding = 0): void {
    const { minX, minY, maxX, maxY } = bounds;
    requireFinite('Camera.fit', 'minX', minX, 'metres');
    requireFinite('Camera.fit', 'minY', minY, 'metres');
    requireFinite('Camera.fit', 'maxX', maxX, 'metres');
    requireFinite('Camera.fit', 'maxY', maxY, 'metres');
    requireOrdered('Camera.fit', 'x', minX, maxX, 'm');
    requireOrdered('Camera.fit', 'y', minY, maxY, 'm');
    requirePositive('Camera.fit', 'the longer side of bounds', Math.max(maxX - minX, maxY - minY), 'metres');
    requireNonNegative('Camera.fit', 'padding', padding, 'pixels');
    this.#fitted = { minX, minY, maxX, maxY };
    this.#padding = padding;
    this.#refit(this.#fitted);
  }

  /** Moves what is seen by so many CSS px, as a drag does: right and down are positive. Ends a fit. */
  pan(dxPixels: number, dyPixels: number): void {
    requireFinite('Camera.pan', 'dxPixels', dxPixels, 'pixels');
    requireFinite('Camera.pan', 'dyPixels', dyPixels, 'pixels');
    this.x = this.#x - dxPixels / this.#scale;
    this.y = this.#y + dyPixels / this.#scale;
  }

  /** Enlarges by `factor` (above 1: nearer); what is under the screen point stays under it. Ends a fit. */
  zoomAt(screenX: number, screenY: number, factor: number): void {
    requireFinite('Camera.zoomAt', 'screenX', screenX, 'pixels');
    requireFinite('Camera.zoomAt', 'screenY', screenY, 'pixels');
    requirePositive('Camera.zoomAt', 'factor', factor, '', 'Above 1 comes nearer, below 1 goes away.');
    const worldX = this.toWorldX(screenX);
    const worldY = this.toWorldY(screenY);
    this.pixelsPerMetre = Math.min(LARGEST_SCALE, Math.max(SMALLEST_SCALE, this.#scale * factor));
    this.x = this.#x + worldX - this.toWorldX(screenX);
    this.y = this.#y + worldY - this.toWorldY(screenY);
  }

  /**
   * A new size of the viewport, in CSS px; 0 while it is hidden. A fitted view is fitted anew, any other keeps its centre
   * and its scale.
   */
  resize(width: number, height: number): void {
    requireNonNegative('Camera.resize', 'width', width, 'pixels');
    requireNonNegative('Camera.resize', 'height', height, 'pixels');
    this.#width = width;
    this.#height = height;
    if (this.#fitted) this.#refit(this.#fitted);
  }

  #refit({ minX, minY, maxX, maxY }: Bounds): void {
    this.#x = (minX + maxX) / 2;
    this.#y = (minY + maxY) / 2;
    const width = Math.max(this.#width - 2 * this.#padding, this.#width / 2);
    const height = Math.max(this.#height - 2 * this.#padding, this.#height / 2);
    const scale = Math.min(width / (maxX - minX), height / (maxY - minY));
    if (scale > 0) this.#scale = scale; // a hidden viewport keeps the scale that it had
  }
}
