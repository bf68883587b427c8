import type Rapier from '@dimforge/rapier2d-compat';
import type { Effort, Engine, Simulation } from '../engine.ts';
import type { Scene } from '../scene.ts';
import { barsOf, dampingOf, simulationOf } from './rigid-bodies.ts';

const ITERATIONS = 4;

function build(rapier: typeof Rapier, scene: Scene, effort: Effort): Simulation {
  const { RigidBodyDesc, ColliderDesc, JointData } = rapier;
  const world = new rapier.World({ x: 0, y: -scene.gravity });
  world.timestep = scene.dt;
  world.numSolverIterations = ITERATIONS * effort;
  const { friction, restitution } = scene;

  for (const { x, y, width, height } of barsOf(scene)) {
    const body = world.createRigidBody(RigidBodyDesc.fixed().setTranslation(x, y));
    const desc = ColliderDesc.cuboid(width / 2, height / 2)
      .setFriction(friction)
      .setRestitution(restitution);
    world.createCollider(desc, body);
  }
  const discs = scene.discs.map(({ x, y, vx = 0, vy = 0, radius, mass, fixed = false, fast = false }) => {
    const desc = fixed ? RigidBodyDesc.fixed() : RigidBodyDesc.dynamic();
    desc.setTranslation(x, y).setLinvel(vx, vy).setLinearDamping(dampingOf(scene, mass));
    desc.setCanSleep(scene.sleep).setCcdEnabled(fast);
    if (!scene.collide) return world.createRigidBody(desc.setAdditionalMass(mass));
    const body = world.createRigidBody(desc);
    const ball = ColliderDesc.ball(radius).setMass(mass).setFriction(friction).setRestitution(restitution);
    world.createCollider(ball, body);
    return body;
  });
  const crates = scene.crates.map(({ x, y, size, mass }) => {
    const body = world.createRigidBody(RigidBodyDesc.dynamic().setTranslation(x, y).setCanSleep(scene.sleep));
    const desc = ColliderDesc.cuboid(size / 2, size / 2)
      .setMass(mass)
      .setFriction(friction);
    world.createCollider(desc.setRestitution(restitution), body);
    return body;
  });
  const centre = { x: 0, y: 0 };
  for (const { a, b, length } of scene.links) {
    world.createImpulseJoint(JointData.rope(length, centre, centre), discs[a], discs[b], true);
  }
  const force = { x: 0, y: 0 };
  return simulationOf<(typeof discs)[number]>({
    ...{ scene, discs, crates },
    step: () => world.step(),
    position(body, into) {
      const { x, y } = body.translation();
      into.x = x;
      into.y = y;
    },
    velocity(body, into) {
      const { x, y } = body.linvel();
      into.x = x;
      into.y = y;
    },
    rotation(body, into) {
      const angle = body.rotation();
      into.cos = Math.cos(angle);
      into.sin = Math.sin(angle);
    },
    push(body, fx, fy) {
      force.x = fx;
      force.y = fy;
      body.resetForces(false);
      body.addForce(force, true);
    },
  });
}

const settings = [
  'the defaults of `World`, 4 solver iterations',
  'walls are cuboids 10 m thick',
  'links are `JointData.rope`, which has a greatest length and no least: there is no rigid distance joint',
  'where nothing collides discs have no collider; fast discs have CCD enabled',
];

export const rapier: Engine = {
  id: 'rapier2d-compat',
  package: '@dimforge/rapier2d-compat',
  language: 'WASM',
  settings,
  async load() {
    const { default: module } = await import('@dimforge/rapier2d-compat');
    await module.init();
    return (scene, effort) => build(module, scene, effort);
  },
};

export const rapierSimd: Engine = {
  id: 'rapier2d-simd-compat',
  package: '@dimforge/rapier2d-simd-compat',
  language: 'WASM',
  settings,
  async load() {
    const { default: module } = await import('@dimforge/rapier2d-simd-compat');
    await module.init();
    return (scene, effort) => build(module as unknown as typeof Rapier, scene, effort);
  },
};
