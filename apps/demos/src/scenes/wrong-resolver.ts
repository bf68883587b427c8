import type { ContactArrays, Resolver } from '@mass/core';

/** In which ways a resolver of the gallery's own differs from `severity`, to show what comes of it. */
export interface Faults {
  /** Takes the least severe contact first, instead of the most severe. */
  readonly leastSevereFirst?: boolean;
  /** Gives back a share of every closing speed, however small: nothing comes to rest. */
  readonly restless?: boolean;
  /** How far two particles are moved along the normal, as shares of the penetration, from their inverse masses. */
  readonly moves?: (inverseMassA: number, inverseMassB: number) => readonly [number, number];
}

/** As it should be: apart, in inverse proportion to mass. */
const inProportion = (a: number, b: number) => [a / (a + b), -b / (a + b)] as const;

/** The two phases of the severity resolver, plainly written, with faults of choice: for the wrong answers. */
export function wrongResolver({ leastSevereFirst = false, restless = false, moves = inProportion }: Faults): Resolver {
  return {
    name: 'wrong',
    step({ particles, forces, sources, contacts, integrate, gravity, time }, dt) {
      const { count, x, y, vx, vy, ax, ay, inverseMass } = particles;
      forces.apply(dt, time);
      if (!integrate(particles, gravity, dt)) return false;
      sources.gather(contacts, dt);
      const { a, b, normalX, normalY, penetration, restitution } = contacts;
      const inverse = (slot: number): number => (slot < 0 ? 0 : inverseMass[slot]);
      const push = (ux: Float64Array, uy: Float64Array, slot: number, c: number, amount: number): void => {
        if (slot < 0) return;
        ux[slot] += amount * normalX[c];
        uy[slot] += amount * normalY[c];
      };

      // As fast as its weight can have made it, in two steps.
      const rest = (i: number): number => 2.02 * dt * Math.hypot(gravity.x + ax[i], gravity.y + ay[i]);
      resolve(
        contacts,
        vx,
        vy,
        () => 0,
        leastSevereFirst,
        (c, value) => {
          const bounce = !restless && -value <= rest(a[c]) ? 0 : restitution[c];
          const J = (-(1 + bounce) * value) / (inverse(a[c]) + inverse(b[c]));
          push(vx, vy, a[c], c, J * inverse(a[c]));
          push(vx, vy, b[c], c, -J * inverse(b[c]));
        },
      );

      const movedX = new Float64Array(count);
      const movedY = new Float64Array(count);
      resolve(
        contacts,
        movedX,
        movedY,
        (c) => penetration[c],
        leastSevereFirst,
        (c, value) => {
          const [moveA, moveB] = moves(inverse(a[c]), inverse(b[c]));
          push(movedX, movedY, a[c], c, -value * moveA);
          push(movedX, movedY, b[c], c, -value * moveB);
        },
      );
      for (let i = 0; i < count; i++) {
        x[i] += movedX[i];
        y[i] += movedY[i];
      }
      return true;
    },
  };
}

/** Changes one contact after the other, those whose u closes by more than they are apart, each at most twice. */
function resolve(
  { count, a, b, normalX, normalY }: ContactArrays,
  ux: Float64Array,
  uy: Float64Array,
  depth: (contact: number) => number,
  leastFirst: boolean,
  change: (contact: number, value: number) => void,
): void {
  const numberOf = (c: number): number =>
    (ux[a[c]] - (b[c] < 0 ? 0 : ux[b[c]])) * normalX[c] +
    (uy[a[c]] - (b[c] < 0 ? 0 : uy[b[c]])) * normalY[c] -
    depth(c);
  const turns = new Uint8Array(count).fill(2); // what is done wrongly may never be done
  for (;;) {
    let next = -1;
    let severity = 0;
    for (let c = 0; c < count; c++) {
      const value = numberOf(c);
      if (turns[c] === 0 || value >= -1e-9 || (next >= 0 && (leastFirst ? value <= severity : value >= severity)))
        continue;
      next = c;
      severity = value;
    }
    if (next < 0) return;
    turns[next]--;
    change(next, severity);
  }
}
