import { wins } from './game/check.ts';
import { BALL, BURST, CHAIN, DROP, DUST, EMBER, SLING, SPARK, SPLASH, TARGET, WEIGHT } from './game/groups.ts';
import { levels } from './game/levels.ts';
import { Play } from './game/play.ts';
import { Player } from './game/player.ts';
import { signs } from './game/signs.ts';
import type { Scene } from './scene.ts';

export const game: Scene<'level' | 'mass'> = {
  id: 'game',
  figure: 'Figure 28',
  title: 'A game',
  summary:
    'Five levels, each of it made of what the scenes before it showed: bands that pull, rods that break, pendulums, a cable to cut, wind and water. The engine knows nothing of a game: the game adds particles, links and forces, and hears of hits by events. The dots are no drawing of a formula: a second world throws the ball first. All else that is not nailed down can be taken hold of and dragged: that wins a level, too, though not by skill.',
  lookFor:
    'Pull the ball back and let go, or press the arrow keys and Enter; the dots are the first second of its flight.',
  formula: String.raw`\tfrac12\,m\,v^2\approx2\cdot\tfrac12\,k\,d^2\qquad\Rightarrow\qquad v\approx d\,\sqrt{\frac{2k}{m}}`,
  parameters: {
    level: { label: 'Begin with level', min: 1, max: levels.length, step: 1, value: 1 },
    mass: { label: 'Mass of a ball', unit: 'kg', min: 0.6, max: 1.4, step: 0.1, value: 1 },
  },
  show: { minX: -3.5, maxX: 17.5, minY: -1, maxY: 12 },
  poster: 2.6,
  style: ({ accent, ink, quiet, paper, series, dark }) => ({
    particle: { minRadius: 1 },
    groups: {
      [BALL]: { fill: accent, fadeOut: 0.6, trail: { seconds: 0.3, width: 6, alpha: 0.35 } },
      [TARGET]: { fill: paper, stroke: series[4], strokeWidth: 5.5, minRadius: 7.5 },
      [WEIGHT]: { fill: series[0], stroke: ink, strokeWidth: 2 },
      [CHAIN]: { fill: series[3], minRadius: 2.5 },
      [SLING]: { fill: dark ? '#a07a52' : '#8a5a2b' },
      [DUST]: { fill: quiet, alpha: 0.5, minRadius: 0.8, trail: { seconds: 0.16, width: 1.2, points: 3, alpha: 0.5 } },
      [BURST]: { fill: series[4], minRadius: 0.5 },
      [SPARK]: { fill: series[3], minRadius: 1.2, fadeOut: 0.4, trail: { seconds: 0.1, width: 2, points: 4 } },
      [EMBER]: { fill: series[4], minRadius: 1.7, fadeOut: 0.5 },
      [SPLASH]: { fill: series[1], minRadius: 0.5 },
      [DROP]: { fill: series[1], minRadius: 1.8, fadeOut: 0.3 },
    },
    links: { rod: { color: quiet, width: 2.5 }, cable: { color: series[3], width: 2 } },
    bungees: { color: accent, width: 4, alpha: 0.85 },
    pins: { radius: 4 },
    bodies: { mark: false, fillAlpha: 1, strokeWidth: 0 },
    liquids: { hulls: false },
  }),

  build({ level, mass }, seed) {
    const play = new Play(level - 1, mass, seed);
    const player = new Player(play);
    return {
      world: play.world,
      actions: player.actions,
      pointer: player,
      takes: (particle) => play.takes(particle),
      tap: () => player.goOn(),
      beforeStep: (dt) => player.beforeStep(dt),
      guides: () => signs(play, player.plays),
      readouts: () => [
        { label: 'Level', value: play.number + 1, digits: 0 },
        { label: 'Score', value: play.score, digits: 0 },
        { label: 'Targets left', value: play.targets.size, digits: 0 },
        { label: 'Throws left', value: play.throwsLeft, digits: 0 },
      ],
    };
  },

  check: (run) => levels.flatMap((level, n) => wins(level, run({ level: n + 1 }), run({ level: n + 1 }))),
};
