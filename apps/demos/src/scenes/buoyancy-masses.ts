import { Buoyancy, HalfPlane, inRegion, insideBox, type Particle, severity, World } from '@mass/core';
import { addFloat, draught, outline, restingHeight, Stillness, wood } from './floats.ts';
import type { Guide, Scene } from './scene.ts';

const lanes = [1, 2, 3, 4, 5, 6, 7, 8];
const depth = 4;
const top = 1.9;
const g = 9.81;
const xOf = (lane: number): number => 1.8 * (lane - 4.5);

export const buoyancyMasses: Scene<'step' | 'density' | 'drag'> = {
  id: 'buoyancy-masses',
  figure: 'Figure 10',
  title: 'Growing mass',
  summary:
    'Eight boxes of one volume, a cubic metre, each heavier than the one before by the same mass. Each goes down until it displaces its own weight, so that equal steps of mass are equal steps down: the lower edges lie on one straight line, which ends where a box is as heavy as all the liquid that it can displace. Whatever is heavier sinks. Take hold of a box, push it under and let go.',
  lookFor: 'Equal steps in mass are equal steps in depth, until a box outweighs the liquid and sinks.',
  formula: String.raw`\rho\,A\,h\,g=m\,g\qquad\Rightarrow\qquad h=\frac{m}{\rho\,A};\qquad m>\rho\,V:\ \text{it sinks}`,
  parameters: {
    step: { label: 'From box to box', unit: 'kg', min: 50, max: 300, step: 10, value: 150 },
    density: { label: 'Density of the liquid', unit: 'kg/m³', min: 600, max: 1400, step: 10, value: 1000 },
    drag: { label: 'Drag of the liquid', unit: 'N·s/m', min: 0, max: 2000, step: 50, value: 700 },
  },
  show: { minX: -7.9, maxX: 7.9, minY: -depth - 0.6, maxY: 3.4 },
  style: (palette) => ({ particle: { fill: wood(palette) } }),

  build({ step, density, drag }) {
    const world = new World({ resolver: severity(), gravity: { x: 0, y: -g } });
    const liquid = new Buoyancy({ level: 0, density, g, k1: drag });
    world.addForce(inRegion(liquid, insideBox({ minY: -depth })));
    world.addShape(new HalfPlane({ point: { x: 0, y: -depth } }));
    const floats = lanes.map((lane) => ({ mass: lane * step, width: 1, height: 1 }));
    const still = new Stillness(3);
    let boxes: Particle[] = [];
    const drop = (): void => {
      for (const box of boxes) if (box.alive) box.remove();
      boxes = floats.map((float, n) => addFloat(world, [liquid], float, { x: xOf(lanes[n]), y: top }));
    };
    drop();

    const last = Math.min(8.4, density / step);
    const marks: Guide[] = [
      { kind: 'label', x: -7.7, y: 3, text: 'kg', align: 'left' },
      {
        kind: 'curve',
        points: [xOf(0.4), (-0.4 * step) / density, xOf(last), (-last * step) / density],
        tone: 'accent',
      },
      ...floats.map((float, n) => outline(xOf(lanes[n]), restingHeight(float, density, depth), float)),
      ...floats.map(({ mass }, n): Guide => {
        return { kind: 'label', x: xOf(lanes[n]), y: 3, text: `${mass}`, tone: 'ink' };
      }),
    ];
    return {
      world,
      actions: [{ key: 'd', label: 'Drop again', run: drop }],
      beforeStep(dt) {
        if (still.has(world, dt)) drop();
      },
      guides: () => marks,
      readouts: () => [
        { label: 'Most that floats', value: density, unit: 'kg', digits: 0 },
        { label: 'Each step down', value: draught(floats[0], density), unit: 'm' },
      ],
    };
  },

  check(run) {
    const trial = run({ drag: 2000 });
    for (let n = 0; n < 3600; n++) trial.setup.world.step(1 / 60); // the world alone: nothing is dropped anew
    return lanes.map((lane) => {
      const lower = trial.setup.world.particleAt(lane - 1).y - 0.5;
      return lane < 7
        ? {
            name: `${150 * lane} kg: depth as a share of m / (ρ·A)`,
            value: -lower / (0.15 * lane),
            atLeast: 1 - 1e-6,
            atMost: 1 + 1e-6,
          }
        : { name: `${150 * lane} kg: height over the ground`, value: lower + depth, atLeast: -1e-3, atMost: 1e-3 };
    });
  },
};
