// Hand-written Verlet, as tutorials have it: positions and the positions before; constraints move points. Several small steps of
// one pass each. No friction, no rotation, no sleep.
import type { Engine, Simulation } from '../engine.ts';
import type { Scene } from '../scene.ts';

const SUB_STEPS = 8;

function build(scene: Scene, effort: number): Simulation {
  const { discs, links, container, gravity } = scene;
  const subSteps = SUB_STEPS * effort;
  const h = scene.dt / subSteps;
  const count = discs.length;
  const x = Float64Array.from(discs, (disc) => disc.x);
  const y = Float64Array.from(discs, (disc) => disc.y);
  const oldX = Float64Array.from(discs, (disc) => disc.x - (disc.vx ?? 0) * h);
  const oldY = Float64Array.from(discs, (disc) => disc.y - (disc.vy ?? 0) * h);
  const radius = Float64Array.from(discs, (disc) => disc.radius);
  const inverse = Float64Array.from(discs, (disc) => (disc.fixed ? 0 : 1 / disc.mass));
  const cell = 2 * radius.reduce((most, r) => Math.max(most, r), 0);
  const grid = new Map<number, number[]>();
  const k1 = scene.drag?.k1 ?? 0;

  function move(): void {
    for (let i = 0; i < count; i++) {
      if (inverse[i] === 0) continue;
      const kept = 1 - k1 * inverse[i] * h;
      const dx = (x[i] - oldX[i]) * kept;
      const dy = (y[i] - oldY[i]) * kept - gravity * h * h;
      oldX[i] = x[i];
      oldY[i] = y[i];
      x[i] += dx;
      y[i] += dy;
    }
  }

  /** Moves two points along the line between them until their distance is what is asked for. */
  function part(a: number, b: number, distance: number, wanted: number): void {
    const share = (distance - wanted) / (distance * (inverse[a] + inverse[b]) || 1);
    const dx = (x[b] - x[a]) * share;
    const dy = (y[b] - y[a]) * share;
    x[a] += dx * inverse[a];
    y[a] += dy * inverse[a];
    x[b] -= dx * inverse[b];
    y[b] -= dy * inverse[b];
  }

  function collide(): void {
    grid.clear();
    for (let i = 0; i < count; i++) {
      const column = Math.floor(x[i] / cell);
      const row = Math.floor(y[i] / cell);
      for (let near = 0; near < 9; near++) {
        const others = grid.get((column + (near % 3) - 1) * 1_000_003 + row + Math.floor(near / 3) - 1);
        for (const j of others ?? []) {
          const distance = Math.sqrt((x[j] - x[i]) ** 2 + (y[j] - y[i]) ** 2);
          if (distance < radius[i] + radius[j]) part(i, j, distance, radius[i] + radius[j]);
        }
      }
      const key = column * 1_000_003 + row;
      const here = grid.get(key);
      if (here) here.push(i);
      else grid.set(key, [i]);
    }
  }

  function contain({ left, right, floor }: { left: number; right: number; floor: number }): void {
    for (let i = 0; i < count; i++) {
      x[i] = Math.min(Math.max(x[i], left + radius[i]), right - radius[i]);
      y[i] = Math.max(y[i], floor + radius[i]);
    }
  }

  return {
    step() {
      for (let s = 0; s < subSteps; s++) {
        move();
        for (const { a, b, length } of links) part(a, b, Math.sqrt((x[a] - x[b]) ** 2 + (y[a] - y[b]) ** 2), length);
        if (scene.collide) collide();
        if (container) contain(container);
      }
    },
    readPositions(into) {
      for (let i = 0; i < count; i++) {
        into[2 * i] = x[i];
        into[2 * i + 1] = y[i];
      }
    },
    readVelocities(into) {
      for (let i = 0; i < count; i++) {
        into[2 * i] = (x[i] - oldX[i]) / h;
        into[2 * i + 1] = (y[i] - oldY[i]) / h;
      }
    },
  };
}

export const verlet: Engine = {
  id: 'verlet',
  language: 'TypeScript',
  settings: ['some 80 lines by hand, `src/engines/verlet.ts`; 8 sub-steps of one pass'],
  cannot: { crates: 'no rigid bodies', bars: 'no shapes but the box around', sleep: 'no sleep' },
  load: async () => build,
};
