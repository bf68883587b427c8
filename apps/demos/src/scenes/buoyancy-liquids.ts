import { Box, Buoyancy, HalfPlane, inRegion, insideBox, type Particle, severity, World } from '@mass/core';
import { addFloat, outline, restingHeight, wood } from './floats.ts';
import { PeriodMeter } from './period-meter.ts';
import type { Guide, Scene } from './scene.ts';

const liquids = [
  { name: 'petrol', density: 740 },
  { name: 'olive oil', density: 910 },
  { name: 'water', density: 1000 },
  { name: 'glycerine', density: 1260 },
  { name: 'mercury', density: 13_600 },
];
const depth = 3;
const g = 9.81;
const wide = 2.8;
const wall = 0.24;
const xOf = (basin: number): number => wide * (basin - 2);

export const buoyancyLiquids: Scene<'mass' | 'drag'> = {
  id: 'buoyancy-liquids',
  figure: 'Figure 11',
  title: 'Liquids of different density',
  summary:
    'One and the same box, a cubic metre, in five liquids. The denser the liquid, the less of it weighs as much as the box, and the higher the box floats; in a liquid that is lighter than itself it sinks. The dotted boxes are where the closed form has it at rest. Drag grows with the density too. Each liquid acts in its own basin alone: lift a box over the wall into the next.',
  lookFor:
    'The same box sinks in petrol, floats low in water and stands on mercury as if on ice; lift it from basin to basin.',
  formula: String.raw`h=\frac{m}{\rho\,A}\quad\text{if}\quad\rho>\frac{m}{V},\qquad T=2\pi\sqrt{\frac{m}{\rho\,A\,g}}`,
  parameters: {
    mass: { label: 'The box', unit: 'kg', min: 100, max: 1300, step: 10, value: 850 },
    drag: { label: 'Drag of water', unit: 'N·s/m', min: 0, max: 2000, step: 50, value: 600 },
  },
  show: { minX: -7.3, maxX: 7.3, minY: -depth - 0.5, maxY: 3.9 },
  style: (palette) => ({
    particle: { fill: wood(palette) },
    liquids: {
      alpha: palette.dark ? 0.3 : 0.26,
      colorBy: {
        by: 'density',
        from: 740,
        to: 1400,
        colors: [6, 7, 1, 5, 5, 0].map((n) => palette.series[n]),
      },
    },
  }),

  build({ mass, drag }) {
    const world = new World({ resolver: severity(), gravity: { x: 0, y: -g } });
    world.addShape(new HalfPlane({ point: { x: 0, y: -depth } }));
    const waters = liquids.map(({ density }, basin) => {
      const water = new Buoyancy({ level: 0, density, g, k1: (drag * density) / 1000 });
      const [minX, maxX] = [xOf(basin) - (wide - wall) / 2, xOf(basin) + (wide - wall) / 2];
      world.addForce(inRegion(water, insideBox({ minX, maxX, minY: -depth })));
      return water;
    });
    for (let n = 0; n <= liquids.length; n++) {
      world.addShape(new Box({ centre: { x: xOf(n - 0.5), y: (0.6 - depth) / 2 }, width: wall, height: depth + 0.6 }));
    }
    const float = { mass, width: 1, height: 1 };
    const boxes: Particle[] = liquids.map((_, basin) => addFloat(world, waters, float, { x: xOf(basin), y: 1.3 }));
    const back = (): void => {
      for (const [basin, box] of boxes.entries()) Object.assign(box, { x: xOf(basin), y: 1.3, vx: 0, vy: 0 });
    };

    const marks = liquids.flatMap(({ name, density }, basin): Guide[] => [
      { kind: 'label', x: xOf(basin), y: 3.5, text: name, tone: 'ink' },
      { kind: 'label', x: xOf(basin), y: 2.9, text: `ρ = ${density}` },
      outline(xOf(basin), restingHeight(float, density, depth), float),
    ]);
    return {
      world,
      actions: [{ key: 'd', label: 'Drop again', run: back }],
      guides: () => marks,
      readouts: () => [
        { label: 'Density of the box', value: mass, unit: 'kg/m³', digits: 0 },
        { label: 'Under water', value: 100 * waters[2].submergedShare(boxes[2]), unit: '%', digits: 1 },
      ],
    };
  },

  check(run) {
    const trial = run({ drag: 2000 });
    trial.run(60);
    const bob = run({ drag: 0 });
    const findings = [
      { name: 'petrol: lower edge', value: trial.setup.world.particleAt(0).y - 0.5, atMost: 1e-3 - depth },
    ];
    for (const [basin, { name, density }] of liquids.entries()) {
      if (density < 850) continue;
      const rest = 0.5 - 850 / density;
      const { y } = trial.setup.world.particleAt(basin);
      findings.push({ name: `${name}: off m / (ρ·A), m`, value: Math.abs(y - rest), atMost: 1e-6 });
      const box = bob.setup.world.particleAt(basin);
      Object.assign(box, { y: rest + 0.03, vy: 0 });
      const meter = new PeriodMeter();
      bob.run(10, () => meter.add(bob.setup.world.time, box.y - rest));
      const share = meter.period / (2 * Math.PI * Math.sqrt(850 / density / g));
      findings.push({ name: `${name}: bob off its period, as a share`, value: Math.abs(share - 1), atMost: 0.01 });
    }
    return findings;
  },
};
