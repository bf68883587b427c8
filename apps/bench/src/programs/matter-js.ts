import Matter from 'matter-js';

const engine = Matter.Engine.create();
const walls = [
  Matter.Bodies.rectangle(0, 50, 400, 100, { isStatic: true }),
  Matter.Bodies.rectangle(-150, -400, 100, 1000, { isStatic: true }),
  Matter.Bodies.rectangle(150, -400, 100, 1000, { isStatic: true }),
];
const discs = [-50, -110, -170].map((y) => Matter.Bodies.circle(0, y, 25));
Matter.Composite.add(engine.world, [...walls, ...discs]);
Matter.Engine.update(engine, 1000 / 60);
export const heights = discs.map(({ position }) => position.y);
