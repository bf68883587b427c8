import { wrong } from '../math/checks.ts';
import { Particle } from './particle.ts';
import type { ParticleStore } from './particle-store.ts';

/** A particle of any world. */
export function requireParticle(where: string, particle: Particle): void {
  if (!(particle instanceof Particle)) {
    throw wrong(where, 'a particle must be what World.addParticle returned', particle);
  }
}

/** Throws the error that says why a particle is not one of this store's, if it is not. */
export function requireMember(where: string, particle: Particle, store: ParticleStore): void {
  requireParticle(where, particle);
  if (!particle.isIn(store)) {
    const why = particle.alive ? 'it lives in another world' : 'it was removed';
    throw new Error(`${where}: the particle must be in this world; ${why}.`);
  }
}

/** The same for a list, and a copy of it. */
export function requireMembers(where: string, particles: Iterable<Particle>, store: ParticleStore): Particle[] {
  if (typeof particles !== 'object' || typeof particles?.[Symbol.iterator] !== 'function') {
    throw wrong(where, 'particles must be a list of particles', particles, 'Put it in [ ].');
  }
  const members = [...particles];
  for (const particle of members) requireMember(where, particle, store);
  return members;
}
