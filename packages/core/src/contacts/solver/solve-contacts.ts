import type { ParticleArrays } from '../../particles/particle-arrays.ts';
import { type ContactBuffer, SCENERY } from '../contact-buffer.ts';
import { partingSpeed, push } from './contact-place.ts';
import type { ContactRows } from './contact-rows.ts';
import type { RigidMotion } from './rigid-motion.ts';
import type { Softness } from './softness.ts';

/** Two things that are in each other part no faster than this. Unit: m/s. */
export const FASTEST_PUSH = 10;

/** How much deeper is much, as a share of the radius. */
const DEEPER = 0.1;

/** How deep in scenery something may be, as a share of the radius: its centre stays in front, on a thin wall or it would come out behind. */
const DEEPEST = 0.9;
/** And a point is never less in front than this, whatever the rounding. Unit: m. */
const ROUNDING = 1e-9;

/**
 * A contact that held an impulse already and is almost calm is corrected by this much more than it asks for: piles come to rest in a
 * fraction of the time (successive over-relaxation, D. M. Young, 1950). More makes tall columns swing, and so it does in hits.
 */
export const OVER_RELAXATION = 1.2;

/**
 * One pass over rows (projected Gauss-Seidel). An open gap may close within the small step and no more; a penetration is undone
 * softly, if the contact lasted from the step before; a hit is stopped at once. Friction holds up to its coefficient times the normal impulse, and then slides.
 * Reads the contacts, the rows, x, y, inverseMass. Writes vx, vy, the impulses of the rows; adds to those of the contacts.
 * @param calm - Speed along the normal below which a contact is calm. Unit: m/s.
 */
export function solveContacts(
  { a, normalX, normalY, friction, surfaceSpeed, impulse, tangentImpulse }: ContactBuffer,
  { second, offset, mass, lasting, closing, normal, tangent, fallX, fallY }: ContactRows,
  start: number,
  end: number,
  { x, y, vx, vy, inverseMass }: ParticleArrays,
  { biasRate, massScale, impulseScale }: Softness,
  h: number,
  calm: number,
): void {
  const perStep = 1 / h;
  const kept = 1 - impulseScale;
  for (let r = start; r < end; r++) {
    const i = a[r];
    const j = second[r];
    const nx = normalX[r];
    const ny = normalY[r];
    const ux = vx[i] - vx[j];
    const uy = vy[i] - vy[j];
    const gap = offset[r] + (x[i] - x[j]) * nx + (y[i] - y[j]) * ny;
    const before = normal[r];
    const speed = ux * nx + uy * ny;
    const response = before > 0 && speed < calm && speed > -calm ? OVER_RELAXATION * mass[r] : mass[r];
    const soft = gap <= 0 && lasting[r] === 1;
    const rate = gap > 0 ? gap * perStep : Math.max(gap * biasRate, -FASTEST_PUSH);
    const wanted = (soft ? before * kept : before) - response * (soft ? massScale : 1) * (speed + rate);
    const after = Math.max(wanted, 0);
    if (before === 0 && after > 0) {
      // As it was before gravity acted in this small step: so what bounces never gains by it.
      const falls = (inverseMass[i] === 0 ? 0 : 1) - (inverseMass[j] === 0 ? 0 : 1);
      closing[r] = Math.min(closing[r], speed - falls * (fallX * nx + fallY * ny));
    }
    normal[r] = after;
    impulse[r] += after;
    let px = (after - before) * nx;
    let py = (after - before) * ny;
    const mu = friction[r];
    if (mu !== 0) {
      const held = tangent[r];
      const most = mu * after;
      const sliding = ux * ny - uy * nx - surfaceSpeed[r];
      const grip = Math.max(-most, Math.min(most, held - mass[r] * sliding));
      tangent[r] = grip;
      tangentImpulse[r] += grip;
      px += (grip - held) * ny;
      py -= (grip - held) * nx;
    }
    const wi = inverseMass[i];
    const wj = inverseMass[j];
    vx[i] += px * wi;
    vy[i] += py * wi;
    vx[j] -= px * wj;
    vy[j] -= py * wj;
  }
}

/**
 * Takes back the speed at which two were pushed out of each other, where the contact holds nothing any more that a pass could lessen: two
 * that were in each other do not fly apart. The impulses of the last small step are taken off the sums: the pass that follows counts
 * them again. Reads the contacts, the rows, inverseMass. Writes vx, vy.
 * @param biasRate - Share of a penetration that was undone in a second. Unit: 1/s.
 */
export function takeBackPush(
  contacts: ContactBuffer,
  rows: ContactRows,
  bodies: RigidMotion | undefined,
  particles: ParticleArrays,
  biasRate: number,
): void {
  const { count, normalX, normalY, penetration, impulse, tangentImpulse } = contacts;
  const { second, mass, normal, tangent } = rows;
  const { vx, vy } = particles;
  for (let r = 0; r < count; r++) {
    impulse[r] -= normal[r];
    tangentImpulse[r] -= tangent[r];
    const depth = penetration[r];
    if (normal[r] > 0 || impulse[r] === 0 || depth <= 0) continue;
    const speed = partingSpeed(contacts, second, particles, r);
    if (speed <= 0) continue;
    const J = mass[r] * Math.min(speed, depth * biasRate, FASTEST_PUSH);
    push(contacts, rows, bodies, r, -J * normalX[r], -J * normalY[r], particles, vx, vy);
  }
}

/**
 * Gives back a share of the closing speed with which two hit each other in the step. Reads the rows, x, y, inverseMass.
 * Writes vx, vy, and the contacts' impulses.
 * @param resting - Closing speed up to which a contact rests. Unit: m/s.
 */
export function giveBack(
  contacts: ContactBuffer,
  rows: ContactRows,
  bodies: RigidMotion | undefined,
  particles: ParticleArrays,
  resting: number,
): void {
  const { count, normalX, normalY, restitution, impulse } = contacts;
  const { second, mass, closing } = rows;
  const { vx, vy } = particles;
  for (let r = 0; r < count; r++) {
    if (restitution[r] === 0 || closing[r] >= -resting || impulse[r] === 0) continue;
    const speed = partingSpeed(contacts, second, particles, r);
    // No more than its share of the impulse that stopped the hit (Poisson): where several hit at once, more would add energy.
    const J = Math.min(restitution[r] * impulse[r], -mass[r] * (speed + restitution[r] * closing[r]));
    if (J <= 0) continue;
    impulse[r] += J;
    if (rows.lasting[r] === 0) rows.normal[r] = rows.tangent[r] = 0; // what came and bounces holds nothing
    push(contacts, rows, bodies, r, J * normalX[r], J * normalY[r], particles, vx, vy);
  }
}

/**
 * Takes out of scenery, by position alone, what is much deeper in it than it was when the step began, or as deep as its centre. Reads the
 * rows, radius. Writes x, y. Returns whether something was.
 * @param start - First row.
 * @param end - After the last row.
 */
export function keepOut(
  { a, b, normalX, normalY, penetration, margin }: ContactBuffer,
  { offset, mass }: ContactRows,
  start: number,
  end: number,
  { x, y, radius }: ParticleArrays,
): boolean {
  let any = false;
  for (let r = start; r < end; r++) {
    if (b[r] !== SCENERY) continue;
    const i = a[r];
    const deep = Math.max(penetration[r], 0) + DEEPER * radius[i] + margin / 8;
    const depth = Math.min(deep, DEEPEST * radius[i] - ROUNDING);
    const deeper = -depth - (offset[r] + x[i] * normalX[r] + y[i] * normalY[r]);
    if (deeper <= 0 || mass[r] === 0) continue;
    any = true;
    x[i] += deeper * normalX[r];
    y[i] += deeper * normalY[r];
  }
  return any;
}
