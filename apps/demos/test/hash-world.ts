import type { World } from '@mass/core';

/** The bits of all living particles as one FNV-1a hash of 32 bits: one bit of difference anywhere changes it. */
export function hashWorld({ particles, stepCount }: World): string {
  const { count, alive, x, y, vx, vy, inverseMass, lifetime } = particles;
  let hash = 0x811c9dc5 ^ stepCount;
  const word = new Float64Array(1);
  const bytes = new Uint8Array(word.buffer);
  for (let i = 0; i < count; i++) {
    if (alive[i] === 0) continue;
    for (const value of [i, x[i], y[i], vx[i], vy[i], inverseMass[i], lifetime[i]]) {
      word[0] = value;
      for (const byte of bytes) hash = Math.imul(hash ^ byte, 0x01000193);
    }
  }
  return (hash >>> 0).toString(16).padStart(8, '0');
}
