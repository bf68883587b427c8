import type { Engine, Simulation } from '../engine.ts';
import type { Scene } from '../scene.ts';

/** Pixels a metre. */
const SCALE = 100;
const ITERATIONS = 5;
const CELL = 64;
const WHITE = { r: 1, g: 1, b: 1, a: 1 };

/** What is used of the package, whose own types Node's way of finding modules does not find. */
export interface Party {
  readonly Engine: new (options: {
    canvas: HTMLCanvasElement;
    forces: Force[];
    render: Force[];
    runtime: 'cpu';
    constrainIterations: number;
    cellSize: number;
  }) => {
    setCamera(x: number, y: number): void;
    setParticles(particles: readonly object[]): void;
  };
  readonly Module: abstract new () => Force;
  readonly ModuleRole: { readonly Force: string };
  readonly Environment: new (options: { gravityStrength: number; gravityDirection: 'down'; friction: number }) => Force;
  readonly Boundary: new (options: { restitution: number; friction: number }) => Force;
  readonly Collisions: new (options: { restitution: number }) => Force;
  readonly Joints: new (options: { joints: readonly object[] }) => Force;
}

interface Force {
  isEnabled(): boolean;
}

/** What its `Engine` hides: there is no public way to take one step without a display. */
export interface Inside {
  readonly particles: readonly { readonly position: Point; readonly velocity: Point }[];
  update(dt: number): void;
}

interface Point {
  x: number;
  y: number;
}

interface Moving {
  readonly acceleration: Point;
  readonly velocity: Point;
  readonly mass: number;
}

/** A canvas, as far as an engine that never draws looks at it. */
function blankCanvas(width: number, height: number): HTMLCanvasElement {
  return { width, height, getContext: () => null } as unknown as HTMLCanvasElement;
}

/** A force of the user's own, as its documentation has it. */
function ownDrag(party: Party, k1: number): Force {
  class OwnDrag extends party.Module {
    readonly name = 'drag' as const;
    readonly role = party.ModuleRole.Force;
    readonly inputs = {};
    webgpu() {
      return {};
    }
    cpu() {
      return {
        apply({ particle: { acceleration, velocity, mass } }: { particle: Moving }) {
          acceleration.x -= (k1 / mass) * velocity.x;
          acceleration.y -= (k1 / mass) * velocity.y;
        },
      };
    }
  }
  return new OwnDrag();
}

function forcesOf(party: Party, { container, collide, links, drag, ...scene }: Scene): Force[] {
  const { restitution, friction } = scene;
  const joints = links.map(({ a, b, length }) => ({ aIndex: a, bIndex: b, restLength: length * SCALE }));
  const airFriction = drag?.by === 'engine' ? drag.k1 : 0;
  const gravityStrength = scene.gravity * SCALE;
  return [
    new party.Environment({ gravityStrength, gravityDirection: 'down', friction: airFriction }),
    ...(drag?.by === 'function' ? [ownDrag(party, drag.k1)] : []),
    ...(container ? [new party.Boundary({ restitution, friction })] : []),
    ...(collide ? [new party.Collisions({ restitution })] : []),
    ...(links.length > 0 ? [new party.Joints({ joints })] : []),
  ];
}

function build(party: Party, scene: Scene, effort: number): Simulation {
  const { discs, container } = scene;
  const xs = discs.map(({ x }) => x);
  const left = container?.left ?? Math.min(...xs) - 1;
  const right = container?.right ?? Math.max(...xs) + 1;
  const floor = container?.floor ?? Math.min(...discs.map(({ y }) => y)) - 1;
  const top = discs.reduce((most, { y }) => Math.max(most, y), 0) + 1;
  const [width, height] = [(right - left) * SCALE, (top - floor) * SCALE];
  const engine = new party.Engine({
    canvas: blankCanvas(width, height),
    forces: forcesOf(party, scene),
    render: [],
    runtime: 'cpu',
    constrainIterations: ITERATIONS * effort,
    cellSize: Math.max(CELL, Math.sqrt((width * height) / discs.length)), // its grid spans its world, empty or not
  });
  engine.setCamera(width / 2, height / 2); // its world is what the camera sees, and its y points down
  engine.setParticles(
    discs.map(({ x, y, vx = 0, vy = 0, radius, mass, fixed }) => ({
      position: { x: (x - left) * SCALE, y: height - (y - floor) * SCALE },
      velocity: { x: vx * SCALE, y: -vy * SCALE },
      ...{ size: radius * SCALE, mass: fixed ? -1 : mass, color: WHITE },
    })),
  );
  const inside = (engine as unknown as { engine: Inside }).engine;
  return {
    step: () => inside.update(scene.dt),
    readPositions(into) {
      inside.particles.forEach(({ position: { x, y } }, i) => {
        into[2 * i] = left + x / SCALE;
        into[2 * i + 1] = floor + (height - y) / SCALE;
      });
    },
    readVelocities(into) {
      inside.particles.forEach(({ velocity: { x, y } }, i) => {
        into[2 * i] = x / SCALE;
        into[2 * i + 1] = -y / SCALE;
      });
    },
  };
}

export const party: Engine = {
  id: 'party',
  package: '@cazala/party',
  language: 'TypeScript',
  settings: [
    'its runtime for the CPU, without a display: steps are taken by a method that it keeps private',
    '100 pixels a metre; 5 constraint iterations, its default, cells of 64 pixels, as it recommends for discs of this size, or larger where these are few',
    'links are `Joints` with their defaults; it has friction against the boundary alone',
  ],
  cannot: { crates: 'no rigid bodies', bars: 'no shapes but the box around', sleep: 'no sleep' },
  async load() {
    const module = (await import('@cazala/party')) as unknown as Party;
    return (scene, effort) => build(module, scene, effort);
  },
};
