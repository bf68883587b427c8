import { Buoyancy, Springs, travellingWave, World } from '@mass/core';
import { addFloat, wood } from './floats.ts';
import type { Scene } from './scene.ts';

const count = 25;
const bright = 12;
const step = 1 / 60;
const g = 9.81;
/** A float draws half its height. */
const float = { mass: 800, width: 0.8, height: 2 };

/** How firmly a float is led, most at the ends: what the reader stirs up runs out there and does not come back. Unit: 1/s. */
function lead(n: number): number {
  const inwards = Math.min(n, count - 1 - n) / 7;
  return inwards < 1 ? 6 * (1 - inwards) * (1 - inwards) : 0;
}

/** How a wave of a length runs along the floats: its period and its speed. Units: N/m, m, s, m/s. */
function runOf(stiffness: number, length: number): { period: number; speed: number } {
  const sine = travellingWave({ amplitude: 1, length: 2 * length, speed: 0 })(1, 0); // sin π/λ, to the bit everywhere
  const omega = Math.sqrt((1000 * float.width * g + 4 * stiffness * sine * sine) / float.mass);
  return { period: (2 * Math.PI) / omega, speed: (omega * length) / (2 * Math.PI) };
}

export const buoyancyWaves: Scene<'length' | 'height' | 'stiffness'> = {
  id: 'buoyancy-waves',
  figure: 'Figure 12',
  title: 'Floats joined make waves',
  summary:
    'A row of floats, each joined to the next by a spring. The first is moved up and down; each pulls the next along, a little late, and a wave runs down the row, over water that lies still. Buoyancy pulls a float back to its place and the springs to its neighbours; both together give the wave its speed. The dotted line is the closed form. Take hold of a float and make waves of your own: they run out at the ends, which are led along it.',
  lookFor: 'The wave runs to the right, yet no float does: watch the bright one, which only bobs.',
  formula: String.raw`\omega^2=\frac{\rho\,A\,g}{m}+\frac{4k}{m}\sin^2\frac{\pi a}{\lambda},\qquad y(x,t)=y_0\sin\Bigl(\frac{2\pi x}{\lambda}-\omega t\Bigr)`,
  parameters: {
    length: { label: 'Wavelength', unit: 'm', min: 4, max: 16, step: 0.5, value: 8 },
    height: { label: 'Height of the wave', unit: 'm', min: 0.1, max: 0.9, step: 0.05, value: 0.65, live: true },
    stiffness: { label: 'Stiffness of the springs', unit: 'kN/m', min: 4, max: 40, step: 1, value: 16 },
  },
  show: { minX: -1.2, maxX: count + 0.2, minY: -4.2, maxY: 3.6 },
  step,
  style: (palette) => ({
    particle: { fill: wood(palette) },
    groups: { 1: { fill: palette.accent } },
    springs: { color: '#7a5a2a', coils: 3, diameter: 10 },
    pins: null,
  }),

  build(values) {
    const world = new World({ gravity: { x: 0, y: -g } });
    const stiffness = 1000 * values.stiffness;
    const { period, speed } = runOf(stiffness, values.length);
    const wave = travellingWave({ amplitude: 1, length: values.length, speed });
    const height = (n: number, time = world.time): number => values.height * wave(n, time);
    // Velocities are those of the middle of the step before: semi-implicit steps leap over positions.
    const rise = (n: number): number => {
      return ((-2 * Math.PI * values.height) / period) * wave(n + values.length / 4, world.time - step / 2);
    };
    const water = world.addForce(new Buoyancy({ level: 0, density: 1000, g }));
    const springs = world.addForce(new Springs());
    const floats = Array.from({ length: count }, (_, n) => {
      const box = addFloat(world, [water], float, { x: n, y: height(n), group: n === bright ? 1 : 0 });
      box.vy = rise(n);
      // Springs without a length of their own pull in proportion, across as well as along.
      if (n > 0) springs.add(world.particleAt(n - 1), box, { stiffness, restLength: 0 });
      return box;
    });
    const ends = [0, count - 1];
    for (const n of ends) floats[n].mass = Infinity;

    return {
      world,
      beforeStep(dt) {
        for (const n of ends) {
          Object.assign(floats[n], { y: height(n), vy: (height(n, world.time + dt) - height(n)) / dt });
        }
        for (const [n, box] of floats.entries()) {
          const firm = lead(n) * float.mass;
          if (firm > 0) box.applyForce(-firm * box.vx, firm * (rise(n) - box.vy));
        }
      },
      guides() {
        const points: number[] = [];
        for (let x = 0; x <= count - 1; x += 0.25) points.push(x, height(x) + float.height / 2);
        return [{ kind: 'curve', points, dashed: true, tone: 'ink' }];
      },
      readouts: () => [
        { label: 'Period', value: period, unit: 's' },
        { label: 'Speed of the wave', value: speed, unit: 'm/s' },
      ],
    };
  },

  check(run) {
    const trial = run();
    const { world } = trial.setup;
    trial.run(20);
    const wave = travellingWave({ amplitude: 0.65, length: 8, speed: runOf(16_000, 8).speed });
    let off = 0;
    let sideways = 0;
    trial.run(10, () => {
      for (let n = 0; n < count; n++) {
        off = Math.max(off, Math.abs(world.particleAt(n).y - wave(n, world.time)));
        sideways = Math.max(sideways, Math.abs(world.particleAt(n).x - n));
      }
    });
    return [
      {
        name: 'furthest that a float is off the closed form, as a share of the height',
        value: off / 0.65,
        atMost: 0.01,
      },
      { name: 'furthest that a float travels, m', value: sideways, atMost: 1e-9 },
    ];
  },
};
