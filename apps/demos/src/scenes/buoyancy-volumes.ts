import { Buoyancy, HalfPlane, inRegion, insideBox, type Particle, Random, severity, World } from '@mass/core';
import { addFloat, draught, type Float, outline, restingHeight, Stillness, wood } from './floats.ts';
import { PeriodMeter } from './period-meter.ts';
import type { Guide, Scene } from './scene.ts';

const count = 8;
const depth = 4;
const top = 2.4;
const g = 9.81;
const xOf = (lane: number): number => 1.9 * (lane - (count - 1) / 2);

export const buoyancyVolumes: Scene<'mass' | 'density' | 'drag'> = {
  id: 'buoyancy-volumes',
  figure: 'Figure 9',
  title: 'Random volumes',
  summary:
    'Eight boxes of one mass and random volumes, 1 m thick, fall from one height into one liquid. Each displaces its own weight, if it can: what is bulky floats high, what is small deep, and what is denser than the liquid sinks. The dotted boxes are where the closed form has them at rest. Take hold of a box, push it under and let go.',
  lookFor: 'All boxes weigh the same: the smaller, the deeper it floats, and the smallest sink.',
  formula: String.raw`\text{afloat: }\rho\,A\,h\,g=m\,g\quad\Rightarrow\quad h=\frac{m}{\rho\,A},\qquad\text{bobbing: }T=2\pi\sqrt{\frac{m}{\rho\,A\,g}}=2\pi\sqrt{\frac{h}{g}}`,
  parameters: {
    mass: { label: 'Each box', unit: 'kg', min: 200, max: 1200, step: 20, value: 640 },
    density: { label: 'Density of the liquid', unit: 'kg/m³', min: 600, max: 1400, step: 10, value: 1000 },
    drag: { label: 'Drag of the liquid', unit: 'N·s/m', min: 0, max: 2000, step: 50, value: 800 },
  },
  show: { minX: -8.5, maxX: 8.3, minY: -depth - 0.6, maxY: 3.6 },
  style: (palette) => ({ particle: { fill: wood(palette) } }),

  build({ mass, density, drag }, seed) {
    const world = new World({ resolver: severity(), gravity: { x: 0, y: -g } });
    const random = new Random(seed);
    const liquid = new Buoyancy({ level: 0, density, g, k1: drag });
    world.addForce(inRegion(liquid, insideBox({ minY: -depth })));
    world.addShape(new HalfPlane({ point: { x: 0, y: -depth } }));
    const still = new Stillness(3);
    let boxes: { float: Float; particle: Particle }[] = [];
    let marks: Guide[] = [];

    function drop(): void {
      for (const { particle } of boxes) if (particle.alive) particle.remove();
      boxes = Array.from({ length: count }, (_, lane) => {
        const side = random.between(0.55, 1.3);
        const float = { mass, width: side, height: side };
        return { float, particle: addFloat(world, [liquid], float, { x: xOf(lane), y: top }) };
      });
      const unit: Guide = { kind: 'label', x: -8.3, y: 3.25, text: 'm³', align: 'left' };
      const lanes = boxes.flatMap(({ float }, lane): Guide[] => [
        outline(xOf(lane), restingHeight(float, density, depth), float),
        { kind: 'label', x: xOf(lane), y: 3.25, text: `${(float.width * float.height).toFixed(2)}`, tone: 'ink' },
      ]);
      marks = [unit, ...lanes];
    }
    drop();

    return {
      world,
      actions: [{ key: 'd', label: 'Drop others', run: drop }],
      beforeStep(dt) {
        if (still.has(world, dt)) drop();
      },
      guides: () => marks,
      readouts: () => [
        { label: 'Needed to float', value: mass / density, unit: 'm³' },
        {
          label: 'Afloat',
          value: boxes.filter(({ float }) => draught(float, density) < float.height).length,
          digits: 0,
        },
      ],
    };
  },

  check(run) {
    const trial = run({ drag: 2000 });
    for (let n = 0; n < 3600; n++) trial.setup.world.step(1 / 60); // the world alone: nothing is dropped anew
    const { world } = trial.setup;
    const bob = run({ drag: 0 });
    const findings = [];
    let sunk = 0;
    for (let lane = 0; lane < count; lane++) {
      const { y, radius } = world.particleAt(lane);
      const float = { mass: 640, width: 2 * radius, height: 2 * radius };
      const off = Math.abs(y - restingHeight(float, 1000, depth));
      const floats = draught(float, 1000) < float.height;
      if (!floats) sunk++;
      findings.push({ name: `box ${lane}: off its place at rest, m`, value: off, atMost: floats ? 1e-6 : 1e-3 });
      if (floats)
        Object.assign(bob.setup.world.particleAt(lane), { y: restingHeight(float, 1000, depth) + 0.02, vy: 0 });
    }
    const meters = Array.from({ length: count }, () => new PeriodMeter());
    bob.run(20, () => {
      for (const [lane, meter] of meters.entries()) {
        const { y, radius } = bob.setup.world.particleAt(lane);
        meter.add(bob.setup.world.time, y - radius + 0.32 / radius);
      }
    });
    for (const [lane, { period }] of meters.entries()) {
      const { radius } = world.particleAt(lane);
      const exact = 2 * Math.PI * Math.sqrt(0.32 / radius / g);
      if (4 * radius * radius < 0.66) continue;
      findings.push({ name: `box ${lane}: bob as a share of T`, value: period / exact, atLeast: 0.99, atMost: 1.01 });
    }
    return [...findings, { name: 'boxes that sink', value: sunk, atLeast: 1, atMost: count - 1 }];
  },
};
