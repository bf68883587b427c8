import type { Guide } from '../scene.ts';
import { levels } from './levels.ts';
import { type Play, SPARED_POINTS } from './play.ts';
import { BALL_RADIUS, FORK } from './sling.ts';

/** How long points stay to be read. Unit: s. */
const PRIZE_TIME = 1.2;

/** The dots of a flight are smaller than this, and nothing else is. Unit: m. */
export const DOT = 0.12;

/** What is written and drawn over the world: where the ball goes, what was won, what to do. */
export function signs(play: Play, plays: boolean): Guide[] {
  const { level, number } = play;
  const hint = plays ? level.hint : 'Watch, or pull the ball back and play.';
  return [
    {
      kind: 'label',
      x: -3.1,
      y: 11.3,
      align: 'left',
      tone: 'ink',
      text: `${number + 1}/${levels.length}  ${level.name}`,
    },
    { kind: 'label', x: -3.1, y: 10.4, align: 'left', text: hint },
    ...ways(play),
    ...ballsLeft(play),
    ...prizes(play),
    ...news(play).map((text, n): Guide => ({ kind: 'label', x: 7, y: 8.6 - 0.9 * n, text, tone: 'accent' })),
  ];
}

/** Where the ball will go, and where the one before went. */
function ways({ path, lastPath, phase }: Play): Guide[] {
  const guides: Guide[] = [];
  if (phase === 'aim') guides.push({ kind: 'curve', points: lastPath, dashed: true, opacity: 0.4 });
  for (let n = 8; n < path.length; n += 8) {
    const radius = DOT - 0.01 - (0.06 * n) / 120;
    guides.push({ kind: 'circle', x: path[n], y: path[n + 1], radius, filled: true, tone: 'accent' });
  }
  return guides;
}

function ballsLeft({ throwsLeft, phase }: Play): Guide[] {
  const waiting = Math.max(0, throwsLeft - (phase === 'aim' ? 1 : 0));
  return Array.from({ length: waiting }, (_, n) => ({
    ...{ kind: 'circle', filled: true, tone: 'accent', radius: BALL_RADIUS * 0.85 },
    x: FORK.x - 0.8 - n * 0.65,
    y: BALL_RADIUS * 0.85,
  }));
}

function prizes({ prizes, world }: Play): Guide[] {
  return prizes.map(({ x, y, points, time }) => {
    const age = Math.min(1, (world.time - time) / PRIZE_TIME);
    return { kind: 'label', x, y: y + 0.4 + age, text: `+${points}`, tone: 'ink', opacity: 1 - age * age };
  });
}

function news({ phase, number, score, throwsLeft }: Play): string[] {
  const last = number === levels.length - 1;
  if (phase === 'lost') return ['Out of throws', 'Tap, or press t, to try again'];
  if (phase !== 'won') return [];
  const spared = throwsLeft > 0 ? `${throwsLeft} spared: +${throwsLeft * SPARED_POINTS}` : 'With the last throw';
  return last ? [`All five levels: ${score} points`, 'Tap, or press n, to play again'] : ['Cleared!', spared];
}
