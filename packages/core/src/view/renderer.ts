import type { Body } from '../bodies/body.ts';
import type { Particle } from '../particles/particle.ts';
import type { Camera } from './camera.ts';
import type { Style } from './style.ts';
import type { ViewedWorld } from './viewed-world.ts';

/**
 * What draws a world. It reads and never writes the world, and keeps no clock: the game calls `render` once a frame.
 * `Drawing` is what a game binds to a particle in place of its disc, `BodyDrawing` what it binds to a body in place of its
 * outline: a function for one renderer, a sprite for another.
 */
export interface Renderer<Drawing = never, BodyDrawing = Drawing> {
  /** How the world looks; setting it takes effect with the next `render`. */
  style: Style;
  /** Draws the world as seen by the camera; `alpha`, 0 to 1, is the share of the way from the previous step to this one. */
  render(world: ViewedWorld, camera: Camera, alpha: number): void;
  /** A new size in CSS px, and the device pixels in each, 1 if left out. What is shown changes with the next `render`. */
  resize(width: number, height: number, pixelRatio?: number): void;
  /** Draws `drawing` where the particle is, in place of its disc, until it is unbound or the particle removed. */
  bind(particle: Particle, drawing: Drawing): void;
  /** Draws `drawing` where the body is, turned as it is, in place of its outline, particles and links. */
  bind(body: Body, drawing: BodyDrawing): void;
  /** Back to the disc or outline. Nothing happens when nothing was bound. */
  unbind(target: Particle | Body): void;
  /** Frees all that the renderer made. Calling it twice is harmless; `render` afterwards is an error. */
  destroy(): void;
}
