import {
  DiscContacts,
  type ForceGenerator,
  type Particle,
  type ParticleArrays,
  Polygon,
  Random,
  type Shape,
  shapeFinder,
  type World,
} from '@mass/core';
import type { Point } from './scene.ts';

/** Half the length and half the width of the cloth between the cushions. Unit: m. */
export const half: Point = { x: 0.99, y: 0.495 };
/** Of a ball, as in pool. Units: m, kg. */
export const radius = 0.02858;
export const mass = 0.17;
/** Radius of a pocket. Unit: m. */
export const pocketRadius = 0.056;
/** Depth of the cushions. Unit: m. */
export const cushion = 0.045;

const corner = 0.072;
const side = 0.062;
const foot = 0.5;
const loose = 3e-4;

export const pockets: readonly Point[] = [-1, 0, 1].flatMap((x) =>
  [-1, 1].map((y) => ({
    x: x * (half.x + 0.014),
    y: y * (half.y + (x === 0 ? 0.04 : 0.014)),
  })),
);

/** Resistance of the cloth: a deceleration, until the ball stands. Unit: m/s². */
export class Cloth implements ForceGenerator {
  deceleration = 0;

  /** Reads vx, vy, mass, inverseMass. Adds to fx, fy. */
  apply({ count, alive, vx, vy, mass, inverseMass, fx, fy }: ParticleArrays, _: unknown, dt: number): void {
    for (let i = 0; i < count; i++) {
      if (alive[i] === 0 || inverseMass[i] === 0) continue;
      const speed = Math.sqrt(vx[i] * vx[i] + vy[i] * vy[i]);
      if (speed === 0) continue;
      const force = (mass[i] * Math.min(this.deceleration, speed / dt)) / speed;
      fx[i] -= force * vx[i];
      fy[i] -= force * vy[i];
    }
  }
}

/** A shape that is there to be seen: nothing touches it. */
class Sheet implements Shape {
  readonly finder = shapeFinder;
  readonly restitution = 0;
  readonly minX: number;
  readonly minY: number;
  readonly maxX: number;
  readonly maxY: number;
  /** For drawing. Unit: m. */
  readonly outline: readonly Point[];

  constructor(x: number, y: number) {
    this.minX = -x;
    this.minY = -y;
    this.maxX = x;
    this.maxY = y;
    this.outline = [
      { x: -x, y: -y },
      { x, y: -y },
      { x, y },
      { x: -x, y },
    ];
  }

  findSurface(): void {
    // It has none.
  }
}

/** A frame, a cloth, six cushions, and balls that collide. */
export function layTable(world: World, restitution: number): void {
  const back = cushion;
  const { x, y } = half;
  world.addShape(new Sheet(x + 0.115, y + 0.115));
  world.addShape(new Sheet(x + back, y + back));
  for (const s of [-1, 1]) {
    for (const t of [-1, 1]) {
      const along = [
        { x: s * side, y: t * y },
        { x: s * (x - corner), y: t * y },
        { x: s * (x - corner + back), y: t * (y + back) },
        { x: s * (side - 0.012), y: t * (y + back) },
      ];
      world.addShape(new Polygon({ points: along, restitution }));
    }
    const across = [
      { x: s * x, y: -(y - corner) },
      { x: s * x, y: y - corner },
      { x: s * (x + back), y: y - corner + back },
      { x: s * (x + back), y: -(y - corner + back) },
    ];
    world.addShape(new Polygon({ points: across, restitution }));
  }
  world.addContactGenerator(new DiscContacts());
}

/** The cue ball at rest, as group 16. */
export function layCueBall(world: World, restitution: number, y: number): Particle {
  return world.addParticle({ x: -foot, y, mass, radius, restitution, group: 16 });
}

/** Fifteen balls in a triangle, groups 1 to 15, laid by hand, some tenths of a millimetre apart; `mirror` -1 the other way. */
export function layRack(world: World, restitution: number, seed: number, mirror: 1 | -1 = 1): Particle[] {
  const random = new Random(seed);
  const numbers = [1, 9, 2, 10, 8, 3, 11, 4, 12, 5, 6, 13, 7, 14, 15];
  const apart = 2 * radius + loose;
  const shift = (): number => random.between(-loose / 3, loose / 3);
  const places: Point[] = [];
  for (let row = 0; row < 5; row++) {
    for (let n = 0; n <= row; n++) {
      places.push({ x: foot + row * apart * Math.sqrt(0.75) + shift(), y: mirror * ((n - row / 2) * apart + shift()) });
    }
  }
  return places.map((place, n) => world.addParticle({ ...place, mass, radius, restitution, group: numbers[n] }));
}

/** Sum of the kinetic energies. Unit: J. */
export function energyOf(balls: readonly Particle[]): number {
  return balls.reduce((sum, { vx, vy }) => sum + (mass * (vx * vx + vy * vy)) / 2, 0);
}

/** Whether a ball has no ground under it. */
export function isPotted({ x, y }: Point): boolean {
  return (
    Math.abs(x) > half.x + cushion ||
    Math.abs(y) > half.y + cushion ||
    pockets.some((pocket) => Math.hypot(pocket.x - x, pocket.y - y) < pocketRadius)
  );
}

/** What a ball that rolls from a place in a direction comes to first: where it is then, and the ball that it meets. */
export function firstHit(
  from: Point,
  ux: number,
  uy: number,
  balls: readonly Particle[],
): { at: Point; ball?: Particle } {
  const wall = (place: number, along: number, end: number): number =>
    along === 0 ? Infinity : ((along > 0 ? end - radius : radius - end) - place) / along;
  let way = Math.max(0, Math.min(wall(from.x, ux, half.x), wall(from.y, uy, half.y)));
  let met: Particle | undefined;
  for (const ball of balls) {
    const dx = ball.x - from.x;
    const dy = ball.y - from.y;
    const ahead = dx * ux + dy * uy;
    const room = 4 * radius * radius - (dx * uy - dy * ux) ** 2;
    if (ahead <= 0 || room <= 0 || ahead - Math.sqrt(room) >= way) continue;
    way = ahead - Math.sqrt(room);
    met = ball;
  }
  const at = { x: from.x + ux * way, y: from.y + uy * way };
  return met ? { at, ball: met } : { at };
}

/** A shot that may pot a ball, or at least meets one: its direction, and how far it is turned off the pocket. */
export function chooseShot(cue: Point, balls: readonly Particle[]): { angle: number; speed: number } {
  let best = { angle: 0, speed: 3, worth: -1 };
  for (const ball of balls) {
    const others = balls.filter((other) => other !== ball);
    for (const pocket of pockets) {
      const far = Math.hypot(pocket.x - ball.x, pocket.y - ball.y);
      const [px, py] = [(pocket.x - ball.x) / far, (pocket.y - ball.y) / far];
      const ghost = { x: ball.x - 2 * radius * px, y: ball.y - 2 * radius * py };
      const way = Math.hypot(ghost.x - cue.x, ghost.y - cue.y);
      const [ux, uy] = [(ghost.x - cue.x) / way, (ghost.y - cue.y) / way];
      const cut = ux * px + uy * py;
      if (cut < 0.3 || firstHit(cue, ux, uy, balls).ball !== ball) continue;
      const end = firstHit(ball, px, py, others);
      if (end.ball && Math.hypot(end.at.x - ball.x, end.at.y - ball.y) < far - pocketRadius) continue;
      const worth = cut / (0.3 + way + far);
      if (worth > best.worth) best = { angle: Math.atan2(uy, ux), speed: 1.6 + (1.3 * (way + far)) / cut, worth };
    }
  }
  if (best.worth < 0 && balls.length > 0) {
    best.angle = Math.atan2(balls[0].y - cue.y, balls[0].x - cue.x);
  }
  return best;
}
