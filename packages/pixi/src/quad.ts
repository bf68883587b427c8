import type { IParticle, Texture } from 'pixi.js';

/** One textured rectangle in a `ParticleContainer`, centred on its position: half a kilobyte less than a pixi `Particle`. */
export class Quad implements IParticle {
  x = 0;
  y = 0;
  scaleX = 1;
  scaleY = 1;
  anchorX = 0.5;
  anchorY = 0.5;
  rotation = 0;
  color = 0;
  texture: Texture;

  constructor(texture: Texture) {
    this.texture = texture;
  }
}
