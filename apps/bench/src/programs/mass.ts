import { DiscContacts, HalfPlane, World } from '@mass/core';

const world = new World({ gravity: { x: 0, y: -9.81 } });
world.addShape(new HalfPlane());
world.addShape(new HalfPlane({ point: { x: -1, y: 0 }, normal: { x: 1, y: 0 } }));
world.addShape(new HalfPlane({ point: { x: 1, y: 0 }, normal: { x: -1, y: 0 } }));
world.addContactGenerator(new DiscContacts());
const discs = [0.5, 1.1, 1.7].map((y) => world.addParticle({ x: 0, y, radius: 0.25, mass: 1 }));
world.step(1 / 60);
export const heights = discs.map(({ y }) => y);
