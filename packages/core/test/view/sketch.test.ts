import { describe, expect, it } from 'vitest';
import {
  Box,
  Bungees,
  Buoyancy,
  box,
  bungee,
  cable,
  Disc,
  DistanceLink,
  ForceProbe,
  Gravity,
  HalfPlane,
  inRegion,
  insideBox,
  Polygon,
  Polyline,
  rod,
  Segment,
  type Shape,
  Springs,
  severity,
  shapeFinder,
  spring,
  travellingWave,
  World,
} from '../../src/index.ts';
import { Camera, DrawList, Palette, type PathList, pathKinds, Sketch, type Style } from '../../src/view/index.ts';

const none = new Uint8Array(64);

/** A world of 20 by 10 m on a view of 200 by 100 px, the origin in its middle. */
function view(world: World, style: Style = {}) {
  const camera = new Camera({ pixelsPerMetre: 10, width: 200, height: 100 });
  const palette = new Palette(style);
  const sketch = new Sketch(style, palette);
  const discs = new DrawList();
  const draw = (alpha = 1) => {
    discs.update(world, palette, camera, alpha, sketch.hide(world, none, none));
    sketch.update(world, discs, camera, alpha);
    return sketch;
  };
  return { camera, sketch, discs, draw };
}

function draw(world: World, style: Style = {}, alpha = 1): Sketch {
  return view(world, style).draw(alpha);
}

/** The points of a path, rounded to a tenth of a pixel. */
function path(list: PathList, p: number): number[] {
  return [...list.points.subarray(list.starts[p], list.starts[p + 1])].map((value) => Math.round(value * 10) / 10 + 0);
}

function kinds(list: PathList): string[] {
  return Array.from({ length: list.count }, (_, p) => Object.keys(pathKinds)[list.kinds[p]]);
}

function colors(list: PathList): string[] {
  return list.paints.slice(0, list.count).map(({ color }) => color);
}

describe('links', () => {
  it('are drawn between the last two steps', () => {
    const world = new World({ resolver: severity() });
    world.addLink(rod(world.addParticle({ x: 0, y: 0, vx: 2 }), world.addParticle({ x: 4, y: 0, vx: 2 })));
    world.step(1);
    expect(path(draw(world, {}, 0.5).below, 0)).toEqual([110, 50, 150, 50]);
  });

  it('are looked up by kind', () => {
    const world = new World({ resolver: severity() });
    const [a, b, c] = [0, 1, 2].map((x) => world.addParticle({ x, y: 0 }));
    world.addLink(rod(a, b));
    world.addLink(cable(b, c));
    world.addLink(new DistanceLink('tow', a, c, { kind: 'tow', minLength: 2, maxLength: 2 }));
    world.addLink({ a, b: { x: 0, y: 3 }, addContacts() {} });
    const links = { rod: { color: '#110000' }, cable: null, tow: { color: '#220000', width: 7 } };
    const { below } = draw(world, { links, pins: null });
    expect(colors(below).slice(0, 2)).toEqual(['#110000', '#220000']);
    expect(below.paints[1].width).toBe(7);
    expect(below.count).toBe(3);
    expect(draw(world, { links: null }).below.count).toBe(0);
  });

  it('hang where they are slack, and not where they are taut', () => {
    const world = new World({ resolver: severity(), gravity: { x: 0, y: -9.81 } });
    const bob = world.addParticle({ x: 4, y: 0 });
    const line = world.addLink(cable({ x: 0, y: 0 }, bob));
    expect(path(draw(world).below, 0).length).toBe(4);
    line.setLength(0, 5);
    const hanging = path(draw(world).below, 0);
    expect(hanging.length).toBeGreaterThan(8);
    expect(Math.max(...hanging.filter((_, k) => k % 2 === 1))).toBeGreaterThan(60);
  });

  it('are coloured by strain: too long, too short, or neither', () => {
    const ramp = { by: 'strain', from: -0.5, to: 0.5, colors: ['#0000ff', '#000000', '#ff0000'] } as const;
    const colorAt = (x: number, minLength: number, maxLength: number): string => {
      const world = new World();
      const bob = world.addParticle({ x, y: 0 });
      world.addLink(new DistanceLink('strut', { x: 0, y: 0 }, bob, { kind: 'strut', minLength, maxLength }));
      return colors(draw(world, { links: { strut: { colorBy: ramp } }, pins: null }).below)[0];
    };
    expect(colorAt(6, 0, 4)).toBe('#ff0000');
    expect(colorAt(2, 4, 5)).toBe('#0000ff');
    expect([colorAt(4.5, 4, 5), colorAt(4, 4, 4), colorAt(9, 0, Infinity)]).toEqual(Array(3).fill(colorAt(4, 4, 4)));
    expect(Number.parseInt(colorAt(4, 4, 4).slice(1), 16) & 0xf0f0f0).toBe(0);
  });

  it('out of sight cost nothing', () => {
    const world = new World({ resolver: severity() });
    world.addLink(rod(world.addParticle({ x: 50, y: 0 }), world.addParticle({ x: 54, y: 0 })));
    world.addLink(rod(world.addParticle({ x: -50, y: 0 }), world.addParticle({ x: 54, y: 0 })));
    expect(draw(world).below.count).toBe(1);
  });
});

describe('springs', () => {
  it('are found in a batch, alone, and within what limits them', () => {
    const world = new World({ resolver: severity() });
    const bob = world.addParticle({ x: 0, y: 0 });
    const batch = world.addForce(new Springs());
    batch.add({ x: 0, y: 3 }, bob, { stiffness: 1 });
    batch.add({ x: 1, y: 3 }, bob, { stiffness: 1 });
    world.addForce(spring({ x: 2, y: 3 }, bob, { stiffness: 1 }));
    world.addForce(bungee({ x: 3, y: 3 }, bob, { stiffness: 1 }));
    const { below } = draw(world, { pins: null, springs: { color: '#110000' }, bungees: { color: '#220000' } });
    expect(colors(below)).toEqual(['#110000', '#110000', '#110000', '#220000']);
    expect(draw(world, { pins: null, springs: null }).below.count).toBe(1);
  });

  it('are gone with their particle at once', () => {
    const world = new World({ resolver: severity() });
    const bob = world.addParticle({ x: 0, y: 0 });
    world.addForce(new Springs()).add({ x: 0, y: 3 }, bob, { stiffness: 1 });
    bob.remove();
    expect(draw(world).below.count).toBe(0);
  });

  it('are coloured by strain, force or stiffness', () => {
    const color = (by: 'strain' | 'force' | 'stiffness', from: number, to: number): string => {
      const world = new World({ resolver: severity() });
      const bob = world.addParticle({ x: 0, y: 0 });
      world.addForce(new Springs()).add({ x: 0, y: 3 }, bob, { stiffness: 5, restLength: 2 });
      const ramp = { by, from, to, colors: ['#000000', '#ffffff'] };
      return draw(world, { springs: { colorBy: ramp } }).below.paints[0].color;
    };
    expect(color('strain', 0, 0.4)).toBe('#ffffff');
    expect(color('strain', 0.6, 1)).toBe('#000000');
    expect(color('force', 4, 4.9)).toBe('#ffffff');
    expect(color('force', 5.1, 6)).toBe('#000000');
    expect(color('stiffness', 4, 4.9)).toBe('#ffffff');
    expect(color('stiffness', 5.1, 6)).toBe('#000000');
  });

  it('as bungees grow thinner as they are stretched', () => {
    const width = (length: number): number => {
      const world = new World({ resolver: severity() });
      const bob = world.addParticle({ x: 0, y: 3 - length });
      world.addForce(new Bungees()).add({ x: 0, y: 3 }, bob, { stiffness: 5, restLength: 2 });
      return draw(world, { bungees: { width: 4 } }).below.paints[0].width;
    };
    expect(width(2)).toBe(4);
    expect(width(1)).toBe(4);
    expect(width(3)).toBeLessThan(3.5);
    expect(width(4)).toBeLessThan(width(3));
  });
});

describe('pins', () => {
  it('mark fixed points, and particles that cannot move, once', () => {
    const world = new World({ resolver: severity() });
    const post = world.addParticle({ x: 0, y: 2, mass: Infinity });
    const bob = world.addParticle({ x: 0, y: 0 });
    world.addLink(rod(post, bob));
    world.addLink(cable(post, bob));
    world.addLink(rod(bob, { x: 3, y: 0 }));
    const rings = kinds(draw(world).below).filter((kind) => kind === 'ring');
    expect(rings.length).toBe(2);
    expect(kinds(draw(world, { pins: null }).below)).not.toContain('ring');
  });
});

describe('shapes', () => {
  const only = (shape: Shape, style: Style['shapes'] = { hatch: null }): PathList => {
    const world = new World({ resolver: severity() });
    world.addShape(shape);
    return draw(world, { shapes: style }).ground;
  };

  it('are filled, hatched and outlined', () => {
    const solid: Shape = new Box({ centre: { x: 0, y: 0 }, width: 4, height: 2 });
    expect(kinds(only(solid))).toEqual(['fill', 'ring']);
    expect(path(only(solid), 0)).toEqual([80, 60, 120, 60, 120, 40, 80, 40]);
    const hatched = kinds(only(solid, {}));
    expect([hatched[0], hatched.at(-1)]).toEqual(['fill', 'ring']);
    expect(hatched.filter((kind) => kind === 'line').length).toBeGreaterThan(3);
    expect(only(solid, { fill: null, hatch: null, stroke: null }).count).toBe(0);
  });

  it('without end reach past the edges of the view, on the solid side', () => {
    const ground = only(new HalfPlane({ point: { x: 0, y: -2 } }));
    expect(kinds(ground)).toEqual(['fill', 'line']);
    const ys = path(ground, 0).filter((_, k) => k % 2 === 1);
    expect([Math.min(...ys), Math.max(...ys)]).toEqual([70, 108]);
    const [x0, , x1] = path(ground, 1);
    expect(Math.min(x0, x1)).toBeLessThan(0);
    expect(Math.max(x0, x1)).toBeGreaterThan(200);
    expect(only(new HalfPlane({ point: { x: 0, y: -8 } })).count).toBe(0);
  });

  it('are discs, polygons, walls thin and thick', () => {
    const points = [
      { x: -2, y: 0 },
      { x: 0, y: 1 },
      { x: 2, y: 0 },
    ];
    expect(kinds(only(new Disc({ centre: { x: 1, y: 1 }, radius: 1 })))).toEqual(['fill', 'ring']);
    expect(kinds(only(new Polygon({ points })))).toEqual(['fill', 'ring']);
    expect(kinds(only(new Segment({ a: points[0], b: points[1] })))).toEqual(['line']);
    expect(kinds(only(new Segment({ a: points[0], b: points[1], thickness: 1 })))).toEqual(['fill', 'ring']);
    expect(kinds(only(new Polyline({ points })))).toEqual(['line']);
    expect(kinds(only(new Polyline({ points, closed: true })))).toEqual(['ring']);
    expect(kinds(only(new Polyline({ points, thickness: 1 })))).toEqual(['fill', 'ring']);
    expect(kinds(only(new Polyline({ points, thickness: 1, closed: true })))).toEqual(['fill', 'ring', 'ring']);
  });

  it("of a game's own are drawn by the outline that they tell, or not at all", () => {
    const own = { finder: shapeFinder, restitution: 0, minX: -1, minY: -1, maxX: 1, maxY: 1, findSurface() {} };
    expect(only(own).count).toBe(0);
    const outline = [
      { x: 0, y: 0 },
      { x: 1, y: 0 },
      { x: 0, y: 1 },
    ];
    expect(path(only({ ...own, outline } as Shape), 0)).toEqual([100, 50, 110, 50, 100, 40]);
  });

  it('are drawn anew only when the camera or they have changed', () => {
    const world = new World({ resolver: severity() });
    world.addShape(new HalfPlane());
    const { camera, sketch, draw } = view(world);
    draw();
    const { version } = sketch.ground;
    for (let n = 0; n < 5; n++) {
      world.step(1 / 60);
      draw();
    }
    expect(sketch.ground.version).toBe(version);
    camera.pan(1, 0);
    draw();
    expect(sketch.ground.version).toBe(version + 1);
    world.addShape(new Disc({ centre: { x: 1, y: 1 }, radius: 1 }));
    draw();
    expect(sketch.ground.version).toBe(version + 2);
  });
});

describe('liquids', () => {
  it('fill the view below their level, or the box that they are limited to', () => {
    const world = new World({ resolver: severity() });
    world.addForce(new Buoyancy({ level: -1 }), []);
    const { ground } = draw(world);
    expect(kinds(ground)).toEqual(['strip', 'line']);
    expect(path(ground, 0)).toEqual([-8, 60, -8, 108, 208, 60, 208, 108]);
    const tank = new World({ resolver: severity() });
    tank.addForce(inRegion(new Buoyancy({ level: 1 }), insideBox({ minX: -2, maxX: 3, minY: -4 })), []);
    expect(path(draw(tank).ground, 0)).toEqual([80, 40, 80, 90, 130, 40, 130, 90]);
  });

  it('that wave are looked at all along, at the time that is drawn', () => {
    const world = new World({ resolver: severity() });
    world.addForce(new Buoyancy({ level: travellingWave({ amplitude: 1, length: 8, speed: 2 }) }), []);
    const { draw } = view(world);
    draw();
    world.step(0.5);
    const { ground } = draw(0.5);
    const line = path(ground, 1);
    expect(line.length).toBeGreaterThan(80);
    for (let k = 0; k < line.length; k += 2) {
      const x = (line[k] - 100) / 10;
      expect(line[k + 1]).toBeCloseTo(50 - 10 * Math.sin((2 * Math.PI * (x - 2 * 0.25)) / 8), 0);
    }
  });

  it('are coloured by density', () => {
    const world = new World({ resolver: severity() });
    world.addForce(new Buoyancy({ density: 800 }), []);
    const ramp = { by: 'density', from: 900, to: 1000, colors: ['#112233', '#ffffff'] } as const;
    expect(colors(draw(world, { liquids: { colorBy: ramp } }).ground)).toEqual(['#112233', '#112233']);
  });

  it('show a particle that has a hull as the box that floats', () => {
    const world = new World({ resolver: severity() });
    const water = world.addForce(new Buoyancy(), []);
    const float = world.addParticle({ x: 1, y: 0, radius: 3 });
    water.setHull(float, { volume: 2, maxDepth: 0.5 });
    const shown = view(world);
    expect(path(shown.draw().below, 0)).toEqual([100, 45, 120, 45, 120, 55, 100, 55]);
    expect(shown.discs.starts.at(-1)).toBe(0);
    const disc = view(world, { liquids: { hulls: false } });
    expect(disc.draw().below.count).toBe(0);
    expect(disc.discs.starts.at(-1)).toBe(1);
  });

  it('that stand still are drawn once', () => {
    const world = new World({ resolver: severity() });
    const water = world.addForce(new Buoyancy(), []);
    const { sketch, draw } = view(world);
    for (let n = 0; n < 3; n++) {
      world.step(1 / 60);
      draw();
    }
    expect(sketch.ground.version).toBe(1);
    water.level = 2;
    draw();
    expect(sketch.ground.version).toBe(2);
  });
});

describe('bodies', () => {
  const boxed = (style: Style = {}) => {
    const world = new World({ resolver: severity() });
    const body = world.addBody(box({ x: 0, y: 0, width: 4, height: 2, radius: 0.5, angle: Math.PI / 2, group: 3 }));
    return { world, body, ...view(world, { groups: { 3: { fill: '#123456' } }, ...style }) };
  };

  it('are outlines in place of their discs and links, in the colour of their group', () => {
    const { draw, discs } = boxed();
    const { below } = draw();
    expect(kinds(below)).toEqual(['fill', 'ring', 'line']);
    expect(colors(below)).toEqual(['#123456', '#123456', '#123456']);
    expect(discs.starts.at(-1)).toBe(0);
    const xs = path(below, 0).filter((_, k) => k % 2 === 0);
    expect([Math.min(...xs), Math.max(...xs)]).toEqual([85, 115]);
  });

  it('have a mark that shows how they are turned', () => {
    const [x0, y0, x1, y1] = path(boxed().draw().below, 2);
    expect([x0, y0]).toEqual([100, 50]);
    expect(x1).toBeCloseTo(100, 0);
    expect(y1).toBeLessThan(45);
  });

  it('show what they are made of where a style asks for it, or once they are broken', () => {
    const skeleton = boxed({ bodies: { skeleton: true } });
    expect(kinds(skeleton.draw().below).length).toBe(3 + 6);
    expect(skeleton.discs.starts.at(-1)).toBe(4);
    const hidden = boxed({ bodies: null });
    expect(kinds(hidden.draw().below).length).toBe(6);
    const broken = boxed();
    broken.body.particles[0].remove();
    expect(kinds(broken.draw().below)).toEqual(['line', 'line', 'line']);
    expect(broken.discs.starts.at(-1)).toBe(3);
  });

  it('leave their place to what a game draws', () => {
    const { world, body, sketch, discs, camera } = boxed();
    const bound = new Uint8Array(64);
    for (const { slot } of body.particles) bound[slot] = 1;
    discs.update(world, new Palette({}), camera, 1, sketch.hide(world, none, bound));
    sketch.update(world, discs, camera, 1);
    expect(sketch.below.count).toBe(0);
    expect(discs.starts.at(-1)).toBe(0);
  });
});

describe('arrows and contacts', () => {
  const falling = (style: Style): Sketch => {
    const world = new World({ resolver: severity() });
    world.addForce(new Gravity({ x: 0, y: -10 }));
    world.addForce(new ForceProbe());
    world.addParticle({ x: 0, y: 0, mass: 2, vx: 3 });
    world.addShape(new HalfPlane({ point: { x: 0, y: -1 } }));
    world.addParticle({ x: 4, y: 0.001 - 1 + 0.5, radius: 0.5, vy: -1 });
    world.step(1e-3);
    return draw(world, { shapes: null, ...style });
  };

  it('are drawn where a style asks for them alone', () => {
    expect(falling({}).above.count).toBe(0);
    expect(falling({ velocities: null, forces: null, contacts: null }).above.count).toBe(0);
  });

  it('show velocities', () => {
    const { above } = falling({ velocities: { scale: 1 } });
    const [tipX, tipY] = path(above, 1);
    expect(tipX).toBeCloseTo(130, 0);
    expect(tipY).toBeCloseTo(50, 0);
  });

  it('show the forces that a probe has seen', () => {
    const { above } = falling({ forces: { scale: 0.1 } });
    expect(path(above, 1).slice(0, 2)).toEqual([100, 70]);
  });

  it('show contacts with their normal and impulse, and no links', () => {
    expect(kinds(falling({ contacts: { scale: 0 } }).above)).toEqual(['line', 'fill']);
    const { above } = falling({ contacts: {} });
    expect(kinds(above)).toEqual(['line', 'line', 'fill', 'fill']);
    const [x0, y0, x1, y1] = path(above, 0);
    expect([x0, Math.round(y0)]).toEqual([140, 60]);
    expect([x1, Math.round(y1)]).toEqual([140, 46]);
    const world = new World({ resolver: severity() });
    world.addLink(rod(world.addParticle({ x: 0, y: 0 }), world.addParticle({ x: 1, y: 0 })));
    world.step(1e-3);
    expect(draw(world, { contacts: {} }).above.count).toBe(0);
  });

  it('are one for each body, from its centre', () => {
    const world = new World({ resolver: severity() });
    world.addBody(box({ x: 0, y: 0, width: 2, height: 2, vx: 2, angularVelocity: 1 }));
    const { above } = draw(world, { velocities: { scale: 1 } });
    expect(kinds(above)).toEqual(['line', 'fill']);
    expect(path(above, 0).slice(0, 2)).toEqual([100, 50]);
    expect(path(above, 1).slice(0, 2)).toEqual([120, 50]);
  });
});
