import * as party from '@cazala/party';
import type { Inside, Party } from '../engines/party.ts';

const { Engine, Environment, Boundary, Collisions } = party as unknown as Party;
const canvas = { width: 200, height: 400, getContext: () => null } as unknown as HTMLCanvasElement;
const forces = [
  new Environment({ gravityStrength: 981, gravityDirection: 'down', friction: 0 }),
  new Boundary({ restitution: 0, friction: 0.1 }),
  new Collisions({ restitution: 0 }),
];
const engine = new Engine({ canvas, forces, render: [], runtime: 'cpu', constrainIterations: 5, cellSize: 64 });
engine.setParticles(
  [50, 110, 170].map((y) => ({
    position: { x: 0, y },
    velocity: { x: 0, y: 0 },
    ...{ size: 25, mass: 1, color: { r: 1, g: 1, b: 1, a: 1 } },
  })),
);
const inside = (engine as unknown as { engine: Inside }).engine;
inside.update(1 / 60);
export const heights = inside.particles.map(({ position }) => position.y);
