import { Buoyancy, bungee, Gravity, HalfPlane, inRegion, insideBox, type Particle, severity, World } from '@mass/core';
import { addFloat, Stillness, wood } from './floats.ts';
import type { Guide, Scene, Setup } from './scene.ts';

const g = 10;
const depth = 0.17;
const metresPerNewton = 0.0052;
const cord = { short: 0.075, speed: 0.05 };

/** An arrow for a force up or down, with its number. */
function force(
  name: string,
  x: number,
  y: number,
  newtons: number,
  side: 'left' | 'right',
  tone: 'accent' | 'ink',
): Guide[] {
  if (Math.abs(newtons) < 0.05) return [];
  const to = { x, y: y + newtons * metresPerNewton };
  const text = `${name} ${Math.abs(newtons).toFixed(1)} N`;
  const away = side === 'left' ? 0.009 : -0.009;
  return [
    { kind: 'arrow', from: { x, y }, to, tone, bold: true },
    { kind: 'label', x: x + away, y: (y + to.y) / 2, text, align: side, tone },
  ];
}

export const buoyancyExplained: Scene<'mass' | 'volume' | 'density'> = {
  id: 'buoyancy-explained',
  figure: 'Figure 8',
  title: 'Buoyancy, explained',
  summary:
    'The water lifts with the weight of what is displaced. A litre wholly under water is lifted with 10 N, whatever is in it. This block of half a kilogram weighs 5 N: a cord holds it down with the other 5 N. Let go and it rises until only half of it is under; there the lift is 5 N too, and it floats. Both blocks are alike, 1 m long, seen from their ends; g is 10 m/s².',
  lookFor: 'Wholly under water the block is lifted with 10 N; afloat with 5 N, which is its weight.',
  formula: String.raw`F=\rho\,V g\,d,\qquad d=\text{share under water}\in[0,1];\qquad\text{afloat: }F=m\,g`,
  parameters: {
    mass: { label: 'Mass', unit: 'kg', min: 0.1, max: 1.4, step: 0.05, value: 0.5 },
    volume: { label: 'Volume', unit: 'litres', min: 0.5, max: 1.4, step: 0.1, value: 1 },
    density: { label: 'Density of the liquid', unit: 'kg/m³', min: 700, max: 1300, step: 10, value: 1000 },
  },
  show: { minX: -0.19, maxX: 0.19, minY: -0.19, maxY: 0.095 },
  style: (palette) => ({
    particle: { fill: wood(palette) },
    bungees: { width: 2.5 },
  }),

  build({ mass, volume, density }) {
    const world = new World({ resolver: severity() });
    const water = new Buoyancy({ level: 0, density, g, k1: 14 });
    world.addForce(new Gravity({ x: 0, y: -g }));
    world.addForce(inRegion(water, insideBox({ minY: -depth })));
    world.addShape(new HalfPlane({ point: { x: 0, y: -depth } }));
    const side = Math.sqrt(volume / 1000);
    const block = { mass, width: side, height: side };
    const held = addFloat(world, [water], block, { x: -0.08, y: cord.short + 0.0125 - depth });
    const free = addFloat(world, [water], block, { x: 0.09, y: 0.06 });
    const line = world.addForce(
      bungee({ x: -0.08, y: -depth }, held, { stiffness: 400, restLength: cord.short, damping: 3 }),
    );
    const still = new Stillness(2.5);
    let pulling = true;
    const turn = (): void => {
      pulling = !pulling;
    };

    function forcesOn(block: Particle): Guide[] {
      const { x, y } = block;
      const share = Math.round(100 * water.submergedShare(block));
      const guides: Guide[] = [
        ...force('lift', x, y + side / 2, water.force(block), 'left', 'accent'),
        ...force('weight', x - side / 4, y - side / 2, -mass * g, 'right', 'ink'),
        { kind: 'label', x: x + side / 2 + 0.008, y: y + side * 0.3, text: `${share} % under`, align: 'left' },
      ];
      if (block === held) {
        guides.push({ kind: 'circle', x, y, radius: 0.0022, filled: true });
        guides.push(...force('cord', x + side / 4, y - side / 2, -line.force, 'left', 'ink'));
      }
      return guides;
    }

    return {
      world,
      actions: [{ key: 'c', label: 'Let go or pull', run: turn }],
      beforeStep(dt) {
        if (still.has(world, dt)) turn();
        // The winch winds the cord in slowly, and lets it run freely.
        line.restLength = pulling
          ? Math.max(cord.short, line.restLength - cord.speed * dt)
          : Math.max(line.restLength, line.length);
      },
      guides: () => [...forcesOn(held), ...forcesOn(free)],
      readouts: () => [
        { label: 'Lift, left', value: water.force(held), unit: 'N' },
        { label: 'right', value: water.force(free), unit: 'N' },
        { label: 'Weight', value: mass * g, unit: 'N' },
      ],
    };
  },

  check(run) {
    const newtons = ({ readouts }: Setup, label: string): number => {
      return readouts?.().find((each) => each.label === label)?.value ?? Number.NaN;
    };
    const trial = run();
    trial.run(2.4);
    const under = newtons(trial.setup, 'Lift, left');
    const afloat = run();
    for (let n = 0; n < 6; n++) afloat.run(2);
    const { world } = afloat.setup;
    return [
      { name: 'lift wholly under water, N', value: under, atLeast: 10 - 1e-9, atMost: 10 + 1e-9 },
      { name: 'speed of the block under water', value: Math.abs(trial.setup.world.particleAt(0).vy), atMost: 1e-3 },
      { name: 'lift afloat, N', value: newtons(afloat.setup, 'right'), atLeast: 5 - 1e-9, atMost: 5 + 1e-9 },
      { name: 'height of its middle, m', value: world.particleAt(1).y, atLeast: -1e-9, atMost: 1e-9 },
    ];
  },
};
