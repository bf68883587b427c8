import { type ContactBuffer, requireUnitNormal, SCENERY } from '../contacts/contact-buffer.ts';
import { requireFinite, requireNonNegative, requireShare } from '../math/checks.ts';
import type { ParticleArrays } from '../particles/particle-arrays.ts';
import type { Shape, SurfaceReport } from './shape.ts';

/** Contacts are reported when the gap is below this share of the radius: a little early, so that rest is quiet. */
export const EARLY_SHARE = 0.01;

/** Finds the contacts of particles with scenery. */
export class ShapeContacts implements SurfaceReport {
  #contacts: ContactBuffer | undefined;
  #slot = 0;
  #radius = 0;
  #restitution = 0;
  #friction = 0;
  #surfaceSpeed = 0;

  /** Reads alive, x, y, radius, restitution, inverseMass. Adds contacts of all movable particles with one shape. */
  find(shape: Shape, particles: ParticleArrays, contacts: ContactBuffer): void {
    const { count, x, y, radius, restitution, friction, inverseMass } = particles;
    const { minX, minY, maxX, maxY } = shape;
    requireShare('Shape', 'restitution', shape.restitution);
    requireNonNegative('Shape', 'friction', shape.friction ?? 0, '');
    requireFinite('Shape', 'surfaceSpeed', shape.surfaceSpeed ?? 0, 'metres per second');
    this.#contacts = contacts;
    this.#surfaceSpeed = shape.surfaceSpeed ?? 0;
    for (let i = 0; i < count; i++) {
      if (inverseMass[i] === 0) continue;
      const reach = radius[i] * (1 + EARLY_SHARE);
      const px = x[i];
      const py = y[i];
      if (px < minX - reach || px > maxX + reach || py < minY - reach || py > maxY + reach) continue;
      this.#slot = i;
      this.#radius = radius[i];
      this.#restitution = Math.max(restitution[i], shape.restitution);
      this.#friction = Math.sqrt(friction[i] * (shape.friction ?? 0));
      shape.findSurface(px, py, reach, this);
    }
  }

  add(distance: number, normalX: number, normalY: number): void {
    requireFinite('SurfaceReport.add', 'distance', distance, 'metres');
    requireUnitNormal('SurfaceReport.add', normalX, normalY);
    this.#contacts?.push(
      this.#slot,
      SCENERY,
      normalX,
      normalY,
      this.#radius - distance,
      this.#restitution,
      this.#friction,
      this.#surfaceSpeed,
    );
  }
}
