import { HalfPlane, type Resolver, severity, World } from '@mass/core';
import type { Guide, Scene } from './scene.ts';
import { wrongResolver } from './wrong-resolver.ts';

const restitutions = [0.3, 0.5, 0.7, 0.9];
const radius = 0.13;
const gravity = 9.81;
const xOf = (lane: number): number => 0.42 * (lane - 1.5);

/** Four balls that lie on the ground. */
function ballsAtRest(resolver: Resolver) {
  const world = new World({ gravity: { x: 0, y: -gravity }, resolver });
  world.addShape(new HalfPlane());
  const balls = restitutions.map((restitution, lane) =>
    world.addParticle({ x: xOf(lane), y: radius, radius, restitution, group: lane }),
  );
  return { world, balls };
}

/** How high a ball jumps after a frame of `seconds`: what gravity built up in it turns round. Unit: m. */
const jump = (restitution: number, seconds: number): number => (restitution * gravity * seconds) ** 2 / (2 * gravity);

export const restingContact: Scene<'frame'> = {
  id: 'resting-contact',
  figure: 'Figure 16',
  title: 'Resting contact',
  summary:
    'In each frame gravity gives a ball at rest a little speed into the ground, and a restitution turns it round: the ball never lies still, and after one long frame it jumps. The cure: where the closing speed is no more than the acceleration of that very frame can have built, it is a resting contact, and nothing is given back. Lift a ball and let go: a real fall still bounces, on both sides.',
  lookFor:
    'After each long frame the balls on the left jump out of nowhere, as high as the dashes say; on the right none stirs.',
  formula: String.raw`v_s\ge\mathbf a\cdot\hat{\mathbf n}\,\Delta t\;\Rightarrow\;v_s'=0,\qquad\text{without:}\quad v_s'=e\,g\,\Delta t,\quad h=\tfrac12\,e^2 g\,\Delta t^2`,
  parameters: {
    frame: { label: 'The long frame', unit: 's', min: 0.05, max: 0.5, step: 0.01, value: 0.4, live: true },
  },
  show: { minX: -1, maxX: 1, minY: -0.25, maxY: 1.45 },
  step: 1 / 240,
  poster: 1.3,
  style: ({ series, paper }) => ({
    background: paper,
    groups: Object.fromEntries(restitutions.map((_, lane) => [lane, { fill: series[lane + 1] }])),
  }),

  build(values) {
    const wrong = ballsAtRest(wrongResolver({ restless: true }));
    const right = ballsAtRest(severity());
    const worlds = [wrong.world, right.world];
    const inHand = (): boolean => worlds.some(({ forces }) => forces.length > 0);
    let asked = false;
    let last = { time: -Infinity, frame: 0 };
    function longFrame(): void {
      if (inHand()) return; // the hand is a spring, and such a frame would be too long for it
      for (const world of worlds) world.step(values.frame);
      last = { time: right.world.time, frame: values.frame };
    }
    const words = restitutions.map((restitution, lane): Guide => {
      return { kind: 'label', x: xOf(lane), y: -0.12, text: `${restitution}`, tone: 'ink' };
    });
    const marks = (): Guide[] => {
      const age = right.world.time - last.time;
      const text = `a frame of ${last.frame} s`;
      return [
        { kind: 'label', x: -0.92, y: -0.12, text: 'e', tone: 'ink' },
        ...words,
        ...restitutions.map((restitution, lane): Guide => {
          const y = 2 * radius + jump(restitution, values.frame);
          return { kind: 'curve', points: [xOf(lane) - radius, y, xOf(lane) + radius, y], dashed: true, tone: lane };
        }),
        { kind: 'label', x: 0, y: 1.18, text: age < 1 ? text : '', tone: 'accent', opacity: Math.max(0, 1 - age) },
      ];
    };
    const act = (): void => {
      asked = true;
      longFrame();
    };
    return {
      world: wrong.world,
      label: 'Without the rule',
      beside: [{ world: right.world, label: 'With it', guides: marks }],
      actions: [{ key: 'l', label: 'A long frame', run: act }],
      beforeStep() {
        // Until somebody asks for one, there is a long frame now and then.
        if (!asked && right.world.stepCount % 720 === 120) longFrame();
      },
      guides: marks,
    };
  },

  check(run) {
    const trial = run({ frame: 0.4 });
    const worlds = [trial.setup.world, trial.setup.beside![0].world];
    const highest = worlds.map(() => restitutions.map(() => 0));
    trial.run(0.5);
    trial.press('l');
    trial.run(1.5, () => {
      for (const [
        w,
        {
          particles: { y },
        },
      ] of worlds.entries()) {
        for (const lane of restitutions.keys()) highest[w][lane] = Math.max(highest[w][lane], y[lane] - radius);
      }
    });
    return restitutions.flatMap((restitution, lane) => {
      const share = highest[0][lane] / jump(restitution, 0.4);
      return [
        {
          name: `${restitution}, without the rule: height of the jump, over e²gΔt²/2`,
          value: share,
          atLeast: 0.95,
          atMost: 1.05,
        },
        { name: `${restitution}, with it: height of the jump`, value: highest[1][lane], atMost: 1e-9 },
      ];
    });
  },
};
