import { type End, particleOf } from '../particles/end.ts';
import type { Camera } from './camera.ts';
import type { DrawList } from './draw-list.ts';
import type { ViewedWorld } from './viewed-world.ts';

const none = new Float64Array(0);

/** What is needed to draw one frame, set anew for each. */
export class Frame {
  /** Screen position by slot, between the last two steps. Unit: CSS px. */
  x: Float64Array = none;
  y: Float64Array = none;
  /** Radius of the disc by slot, for those that are drawn. Unit: CSS px. */
  radius: Float64Array = none;
  /** Where the origin of the world is. Unit: CSS px. */
  left = 0;
  top = 0;
  /** Unit: CSS px per m. */
  scale = 1;
  width = 0;
  height = 0;
  alpha = 1;
  /** Between the times of the last two steps. Unit: s. */
  time = 0;
  /** The way in which things hang, on the screen: a unit vector. */
  hangX = 0;
  hangY = 1;
  /** The body that each slot belongs to, counted from 1, of those whose outline is drawn in its place; 0 for none. */
  bodyOf: Uint32Array = new Uint32Array(0);

  set(world: ViewedWorld, discs: DrawList, camera: Camera, alpha: number): void {
    this.x = discs.x;
    this.y = discs.y;
    this.radius = discs.radius;
    this.left = camera.toScreenX(0);
    this.top = camera.toScreenY(0);
    this.scale = camera.pixelsPerMetre;
    this.width = camera.width;
    this.height = camera.height;
    this.alpha = alpha;
    const { x, y } = world.gravity;
    const g = Math.sqrt(x * x + y * y);
    this.hangX = g > 0 ? x / g : 0;
    this.hangY = g > 0 ? -y / g : 1;
  }

  /** Where an end of a link or spring is. Unit: CSS px. */
  endX(end: End): number {
    const particle = particleOf(end);
    return particle ? this.x[particle.slot] : this.left + end.x * this.scale;
  }

  endY(end: End): number {
    const particle = particleOf(end);
    return particle ? this.y[particle.slot] : this.top - end.y * this.scale;
  }

  /** Whether all within `margin` of the line between two places is out of sight. */
  misses(x0: number, y0: number, x1: number, y1: number, margin: number): boolean {
    return (
      Math.max(x0, x1) < -margin ||
      Math.max(y0, y1) < -margin ||
      Math.min(x0, x1) > this.width + margin ||
      Math.min(y0, y1) > this.height + margin
    );
  }
}
