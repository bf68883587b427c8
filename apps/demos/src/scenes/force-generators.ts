import { Drag, type Particle, World } from '@mass/core';
import type { Guide, Scene } from './scene.ts';

const coefficients = [0, 0.25, 0.5, 1, 2, 4, 8];
const top = 19;
const period = 6;
const flash = 0.25;
const xOf = (lane: number): number => (lane - 3) * 6.5;

/** How far a ball has fallen after a time, from m·v' = m·g - k1·v. Units: m, s. */
function fallen(g: number, mass: number, k1: number, t: number): number {
  const tau = mass / k1;
  return k1 === 0 ? (g * t * t) / 2 : g * tau * (t + tau * Math.expm1(-t / tau));
}

export const forceGenerators: Scene<'gravity' | 'mass'> = {
  id: 'force-generators',
  figure: 'Figure 5',
  title: 'Force generators',
  summary:
    'Seven equal balls fall under one gravity, each with a drag of its own. Drag grows with the speed until it balances the pull: at m·g / k₁ a ball speeds up no more, and its colour changes. The dashes are the closed form at every quarter of a second, drawn beforehand; the dots are where the ball was. Take hold of a ball and pull.',
  lookFor:
    'The balls leave together and part at once; where the dashes follow at equal distances, a ball has reached its terminal velocity.',
  formula: String.raw`m\,\dot v=m\,g-k_1\,v\qquad\Rightarrow\qquad v(t)=\frac{m\,g}{k_1}\Bigl(1-e^{-k_1 t/m}\Bigr)`,
  parameters: {
    gravity: { label: 'Gravity', unit: 'm/s²', min: 1, max: 25, step: 0.01, value: 9.81 },
    mass: { label: 'Mass of each ball', unit: 'kg', min: 0.25, max: 4, step: 0.25, value: 1 },
  },
  show: { minX: -28, maxX: 23, minY: -0.5, maxY: 23.6 },
  style: ({ series, accent }) => ({
    particle: { fill: series[0], minRadius: 5, trail: { seconds: 0.25, width: 4 } },
    groups: { 1: { fill: accent } },
  }),

  build({ gravity, mass }) {
    const world = new World({ gravity: { x: 0, y: -gravity } });
    const drags = coefficients.map((k1) => world.addForce(new Drag({ k1 }), []));
    let balls: Particle[] = [];
    let dots: Guide[] = [];
    let released = 0;

    function release(): void {
      for (const ball of balls) ball.remove();
      balls = coefficients.map((_, lane) => world.addParticle({ x: xOf(lane), y: top, mass, radius: 0.6 }));
      for (const [lane, ball] of balls.entries()) world.addForce(drags[lane], [ball]);
      dots = [];
      released = world.stepCount;
    }
    release();

    const rows: Guide[] = [
      { kind: 'label', x: -27.5, y: 22.6, text: 'k₁', align: 'left' },
      { kind: 'label', x: -27.5, y: 20.9, text: 'm·g / k₁', align: 'left' },
    ];
    const lanes = coefficients.flatMap((k1, lane): Guide[] => [
      { kind: 'label', x: xOf(lane), y: 22.6, text: `${k1}`, tone: 'ink' },
      { kind: 'label', x: xOf(lane), y: 20.9, text: k1 === 0 ? '∞' : ((mass * gravity) / k1).toFixed(1), tone: 'ink' },
      ...Array.from({ length: period / flash }, (_, n) => top - fallen(gravity, mass, k1, n * flash))
        .filter((y) => y > 0)
        .map((y): Guide => ({ kind: 'curve', points: [xOf(lane) - 1, y, xOf(lane) + 1, y], opacity: 0.6 })),
    ]);

    return {
      world,
      actions: [{ key: 'd', label: 'Drop again', run: release }],
      beforeStep(dt) {
        const step = world.stepCount - released;
        if (step >= Math.round(period / dt)) release();
        for (const [lane, { x, y, vy, group }] of balls.entries()) {
          const limit = (mass * gravity) / coefficients[lane];
          balls[lane].group = limit < Infinity && Math.abs(vy + limit) <= 0.01 * limit ? 1 : 0;
          if (step % Math.round(flash / dt) !== 0 || y < 0) continue;
          dots.push({ kind: 'circle', x, y, radius: 0.17, filled: true, tone: group === 1 ? 'accent' : 'quiet' });
        }
      },
      guides: () => [...rows, ...lanes, ...dots],
    };
  },

  check(run) {
    const trial = run();
    trial.run(period - 0.1);
    return coefficients.map((k1, lane) => {
      const speed = -trial.setup.world.particleAt(lane).vy;
      return k1 < 1
        ? { name: `k1 = ${k1}: speed, which still grows`, value: speed, atLeast: 15 }
        : { name: `k1 = ${k1}: speed as a share of m·g / k1`, value: (speed * k1) / 9.81, atLeast: 0.99, atMost: 1.01 };
    });
  },
};
