import { cable, type DistanceLink, HalfPlane, type Particle, rod, severity, World } from '@mass/core';
import type { Guide, Scene } from './scene.ts';

const g = 9.81;
const degree = Math.PI / 180;
const ballMass = 4;
const winch = { x: -3.3, y: 0, speed: 2.4, shortest: 0.5 };

export const rodsAndCables: Scene<'counterweight' | 'sling' | 'release'> = {
  id: 'rods-and-cables',
  figure: 'Figure 25',
  title: 'A trebuchet',
  summary:
    'Frame, arm and counterweight are rods; the sling and the rope of the winch are cables. The winch pulls the arm down, the trigger lets it go, the weight falls, the sling whips round, and lets go of the stone when it flies at the angle asked for. From there the dotted parabola is the closed form. A longer sling throws farther, until it comes round too late.',
  lookFor: 'The cable drags the stone along the ground, whips it round, and lets go onto the dotted parabola.',
  formula: String.raw`\tfrac12\,m\,v^2=\eta\;M g\,\Delta h,\qquad y(x)=y_0+x\tan\alpha-\frac{g\,x^2}{2\,v^2\cos^2\alpha}`,
  parameters: {
    counterweight: { label: 'Counterweight', unit: 'kg', min: 45, max: 80, step: 5, value: 70 },
    sling: { label: 'Length of the sling', unit: 'm', min: 1.2, max: 2.6, step: 0.1, value: 2.2 },
    release: { label: 'Lets go at', unit: '°', min: 10, max: 70, step: 5, value: 40, live: true },
  },
  show: { minX: -6.7, maxX: 27.2, minY: -1.5, maxY: 13.3 },
  step: 1 / 480,
  poster: 1.35,
  style: ({ ink, accent, series, quiet, paper }) => ({
    particle: { fill: quiet, stroke: paper, strokeWidth: 1 },
    groups: {
      1: { fill: series[0], stroke: ink, strokeWidth: 1.5 },
      2: { fill: accent, minRadius: 4, trail: { seconds: 0.9, width: 5 } },
    },
    links: { rod: { width: 4 }, cable: { width: 1.75, color: accent } },
  }),

  build(values) {
    const { counterweight, sling } = values;
    const world = new World({ gravity: { x: 0, y: -g }, resolver: severity({ iterations: 600 }) });
    world.addShape(new HalfPlane({ point: { x: 0, y: 0 } }));
    const node = (x: number, y: number, mass: number, radius: number, group = 0): Particle =>
      world.addParticle({ x, y, mass, radius, group, damping: group === 1 ? 0.7 : 1 });
    const axle = node(0, 3, 30, 0.14);
    const feet = [node(-1.3, 0.1, Infinity, 0.1), node(1.3, 0.1, Infinity, 0.1)];
    // The arm as it lies when it is wound down: the tip just above the ground, the axle below the beam.
    const low = Math.asin(2.7 / 4.2);
    const along = (way: number, up: number) => ({
      x: way * Math.cos(low) - up * Math.sin(low),
      y: 3 + way * Math.sin(low) + up * Math.cos(low),
    });
    const [tipAt, buttAt] = [along(-4.2, 0), along(1.1, 0)];
    const tip = node(tipAt.x, tipAt.y, 3, 0.07);
    const butt = node(buttAt.x, buttAt.y, 12, 0.1);
    const kingAt = along(0.05, 0.55);
    const king = node(kingAt.x, kingAt.y, 4, 0.07);
    const weight = node(butt.x, butt.y - 0.95, counterweight, 0.2 + 0.04 * Math.sqrt(counterweight), 1);
    const bars: DistanceLink[] = [];
    for (const [a, b] of [
      [axle, feet[0]],
      [axle, feet[1]],
      [axle, tip],
      [axle, butt],
      [axle, king],
      [king, tip],
      [king, butt],
      [butt, weight],
    ]) {
      bars.push(world.addLink(rod(a, b)));
    }

    let stone: Particle;
    let thong: DistanceLink | undefined;
    let rope: DistanceLink | undefined;
    let thrown: { x: number; y: number; vx: number; vy: number; time: number } | undefined;
    let landed = 0;
    let loaded = 0;
    let farthest = 0;
    let share = 0;
    let height = 0;
    let marks: number[] = [];

    function loadStone(): void {
      if (stone?.alive) stone.remove();
      stone = world.addParticle({
        x: tip.x + sling - 0.02,
        y: 0.2,
        mass: ballMass,
        radius: 0.2,
        group: 2,
        restitution: 0.2,
      });
      thong = world.addLink(cable(tip, stone, { maxLength: sling }));
      thrown = undefined;
      landed = 0;
      height = weight.y;
    }
    loadStone();

    const strain = (): number => Math.max(...bars.map((bar) => Math.abs(bar.strain)), thong?.strain ?? 0);

    /** The sling lets go once the stone flies forward and no steeper than was asked for. */
    function letGo(): void {
      const { x, y, vx, vy } = stone;
      if (!thong || rope || !(vx > 0 && y > 3 && vy < vx * Math.tan(values.release * degree))) return;
      world.removeLink(thong);
      thong = undefined;
      thrown = { x, y, vx, vy, time: world.time };
      share = (ballMass * (vx * vx + vy * vy)) / 2 / (counterweight * g * (height - weight.y));
    }

    function land(): void {
      if (landed > 0 || !thrown || stone.y > stone.radius * 1.02) return;
      landed = world.time;
      farthest = stone.x;
      marks = [...marks.slice(-4), stone.x];
      stone.damping = 0.02;
    }

    /** After the throw the winch pulls the tip down; once it is there, the next stone is laid in. */
    function wind(dt: number): void {
      const swung = !thong && world.time - (landed || world.time) > 1.2;
      if (!rope && swung) rope = world.addLink(cable(winch, tip));
      if (!rope) return;
      const length = rope.maxLength - winch.speed * dt;
      rope.setLength(0, Math.max(winch.shortest, length));
      if (length > winch.shortest) return;
      if (!thong) {
        loadStone();
        loaded = world.time;
      }
      if (world.time - loaded < 0.5) return;
      world.removeLink(rope);
      rope = undefined;
    }

    return {
      world,
      beforeStep(dt) {
        letGo();
        land();
        wind(dt);
      },
      guides: () => [
        ...[0, 5, 10, 15, 20, 25].map((x): Guide => ({ kind: 'label', x, y: -0.75, text: `${x} m` })),
        ...marks.map((x, n): Guide => {
          return { kind: 'circle', x, y: 0, radius: 0.12, filled: true, tone: 'accent', opacity: 0.2 + 0.15 * n };
        }),
        ...(thrown ? [{ kind: 'curve', points: parabola(thrown), dashed: true } as const] : []),
      ],
      readouts: () => [
        { label: 'Range', value: farthest, unit: 'm', digits: 1 },
        { label: 'Of the fall’s energy in the stone', value: 100 * share, unit: '%', digits: 0 },
        { label: 'Greatest strain', value: 100 * strain(), unit: '%', digits: 2 },
      ],
    };
  },

  check(run) {
    const trial = run();
    const { world } = trial.setup;
    const stone = world.particleAt(7);
    let strain = 0;
    let slid = 0;
    trial.run(4, () => {
      for (const link of world.links as readonly DistanceLink[]) strain = Math.max(strain, Math.abs(link.strain));
      if (stone.y < 0.21 && stone.x < 5) slid = Math.max(slid, stone.x + 3.3);
    });
    const drawn = (trial.setup.guides?.() ?? []).find((guide) => guide.kind === 'curve');
    const points = Array.from(drawn?.kind === 'curve' ? drawn.points : []);
    const range = trial.setup.readouts?.()[0].value ?? Number.NaN;
    for (let n = 0; n < 8; n++) trial.run(2);
    const landings = (trial.setup.guides?.() ?? []).filter(({ kind }) => kind === 'circle').length;
    return [
      { name: 'throws in 20 s', value: landings, atLeast: 2 },
      { name: 'range, m', value: range, atLeast: 15, atMost: 27 },
      { name: 'strain', value: strain, atMost: 0.001 },
      {
        name: 'landing, off the parabola, m',
        value: Math.abs(range - points[points.length - 2]),
        atMost: 0.05,
      },
      { name: 'how far the cable drags the stone along the ground, m', value: slid, atLeast: 0.5 },
    ];
  },
};

/** The flight of a stone to the ground. */
function parabola({ x, y, vx, vy }: { x: number; y: number; vx: number; vy: number }): number[] {
  const time = (vy + Math.sqrt(vy * vy + 2 * g * (y - 0.2))) / g;
  const at = Array.from({ length: 61 }, (_, n) => (n / 60) * time);
  return at.flatMap((t) => [x + vx * t, y + vy * t - (g * t * t) / 2]);
}
