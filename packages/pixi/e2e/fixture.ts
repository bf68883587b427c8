// Runs in the page: the same world on both renderers, and measurements of the pixels. The spec beside it bundles this file.
import { CanvasRenderer } from '@mass/canvas2d';
import { box, rod, World } from '@mass/core';
import { Camera, type Style } from '@mass/core/view';
import { Application, Graphics } from 'pixi.js';
import { PixiRenderer } from '../src/index.ts';
import { everyStyle, everything } from './everything.ts';

const width = 600;
const height = 400;

/** The discs of one column a group, of many radii, and balls in flight with trails. */
export const style: Style = {
  background: '#ffffff',
  particle: { fill: '#2563eb' },
  groups: {
    1: { stroke: '#000000', strokeWidth: 2 },
    2: { fill: null, stroke: '#dc2626', strokeWidth: 3 },
    3: { alpha: 0.5, fill: '#16a34a', stroke: '#000000' },
    4: { colorBy: { by: 'speed', from: 0, to: 8, colors: ['#2563eb', '#dc2626'] }, trail: { seconds: 0.5, width: 3 } },
    5: { fadeOut: 2 },
  },
};

function scene(): World {
  const world = new World({ gravity: { x: 0, y: -9.81 } });
  const radii = [0, 0.05, 0.1, 0.17, 0.26, 0.4, 0.6];
  for (let group = 0; group < 4; group++) {
    radii.forEach((radius, i) => {
      const x = -5.2 + i * 1.31 + (i > 5 ? 0.4 : 0);
      world.addParticle({ x, y: 3.03 - group * 1.37, radius, group, mass: Infinity });
    });
  }
  for (let i = 0; i < 6; i++) {
    world.addParticle({ x: -5, y: -3, vx: 4 + i, vy: 2 + i / 4, radius: 0.08 + 0.02 * i, group: 4 });
    world.addParticle({ x: -5 + i, y: -3.6, radius: 0.12, group: 5, mass: Infinity, lifetime: 0.9 + i * 0.4 });
  }
  return world;
}

function camera(): Camera {
  return new Camera({ pixelsPerMetre: 50, width, height });
}

function makeCanvas(wide = width, high = height): HTMLCanvasElement {
  const canvas = document.createElement('canvas');
  canvas.style.cssText = `width:${wide}px;height:${high}px;display:block`;
  document.body.append(canvas);
  return canvas;
}

async function makeApplication(pixelRatio: number, wide = width, high = height): Promise<Application> {
  const app = new Application();
  await app.init({
    width: wide,
    height: high,
    resolution: pixelRatio,
    autoDensity: true,
    autoStart: false,
    preference: 'webgl',
    backgroundAlpha: 0,
  });
  document.body.append(app.canvas);
  return app;
}

/** The pixels of a canvas, in the same task as they were drawn. */
function pixels(canvas: HTMLCanvasElement): ImageData {
  const copy = new OffscreenCanvas(canvas.width, canvas.height);
  const context = copy.getContext('2d') as OffscreenCanvasRenderingContext2D;
  context.drawImage(canvas, 0, 0);
  return context.getImageData(0, 0, copy.width, copy.height);
}

/** How far a pixel is from the white ground, 0 to 1. */
function ink({ data }: ImageData, at: number): number {
  return Math.max(255 - data[at * 4], 255 - data[at * 4 + 1], 255 - data[at * 4 + 2]) / 255;
}

/** Pixels with clear ink in `a` that have no ink at all in `b` within `reach` pixels. */
function missing(a: ImageData, b: ImageData, reach: number): number {
  let count = 0;
  for (let y = 0; y < a.height; y++) {
    for (let x = 0; x < a.width; x++) {
      if (ink(a, y * a.width + x) > 0.3 && !near(b, x, y, reach)) count++;
    }
  }
  return count;
}

function near(image: ImageData, x: number, y: number, reach: number): boolean {
  const span = Math.ceil(reach);
  for (let dy = -span; dy <= span; dy++) {
    for (let dx = -span; dx <= span; dx++) {
      const inside = x + dx >= 0 && y + dy >= 0 && x + dx < image.width && y + dy < image.height;
      if (inside && dx * dx + dy * dy <= reach * reach && ink(image, (y + dy) * image.width + x + dx) > 0.1)
        return true;
    }
  }
  return false;
}

/** Centre and amount of the ink in a square around a place, in CSS px. */
function blot(
  image: ImageData,
  x: number,
  y: number,
  half: number,
  pixelRatio: number,
): { x: number; y: number; area: number } {
  let sum = 0;
  let sumX = 0;
  let sumY = 0;
  for (let py = Math.floor((y - half) * pixelRatio); py < (y + half) * pixelRatio; py++) {
    for (let px = Math.floor((x - half) * pixelRatio); px < (x + half) * pixelRatio; px++) {
      const weight = ink(image, py * image.width + px);
      sum += weight;
      sumX += weight * (px + 0.5);
      sumY += weight * (py + 0.5);
    }
  }
  return { x: sumX / sum / pixelRatio, y: sumY / sum / pixelRatio, area: sum / pixelRatio ** 2 };
}

/** Draws a scene with both and measures how they differ. Lengths in CSS px, `missing` in device pixels. */
export async function compare(pixelRatio: number) {
  const app = await makeApplication(pixelRatio);
  const canvas = makeCanvas();
  const view = camera();
  const world = scene();
  const renderers = [
    new CanvasRenderer(canvas, { style }),
    new PixiRenderer(app.stage, { style, renderer: app.renderer }),
  ];
  for (const renderer of renderers) renderer.resize(width, height, pixelRatio);
  for (let i = 0; i < 40; i++) {
    world.step(1 / 60);
    for (const renderer of renderers) renderer.render(world, view, 0.5);
  }
  app.render();
  const a = pixels(canvas);
  const b = pixels(app.canvas);
  let fromTruth = 0;
  let fromEachOther = 0;
  let areas = 0;
  for (let i = 0; i < 28; i++) {
    const { x, y, radius } = world.particleAt(i);
    const half = Math.max(2, radius * 50) + 2;
    const truth = { x: view.toScreenX(x), y: view.toScreenY(y) };
    const one = blot(a, truth.x, truth.y, half, pixelRatio);
    const other = blot(b, truth.x, truth.y, half, pixelRatio);
    fromTruth = Math.max(
      fromTruth,
      Math.hypot(one.x - truth.x, one.y - truth.y),
      Math.hypot(other.x - truth.x, other.y - truth.y),
    );
    fromEachOther = Math.max(fromEachOther, Math.hypot(one.x - other.x, one.y - other.y));
    areas = Math.max(areas, Math.abs(one.area - other.area) / (2 * Math.PI * half));
  }
  const reach = 1.5 * pixelRatio;
  return {
    sizes: [a.width, a.height, b.width, b.height],
    missing: [missing(a, b, reach), missing(b, a, reach), edges(a, b, reach), edges(b, a, reach)],
    fromTruth,
    fromEachOther,
    areas,
  };
}

/** Draws discs larger than any in the texture, after a zoom through more sizes than it has room for. */
export async function compareLarge(pixelRatio: number) {
  const app = await makeApplication(pixelRatio);
  const canvas = makeCanvas();
  const view = camera();
  const world = new World();
  for (let i = 0; i < 30; i++)
    world.addParticle({ x: (i % 10) - 5, y: 3.5 - i / 10, radius: 0.05 + 0.013 * i, group: 1 + (i % 2) });
  world.addParticle({ x: 3, y: -5, radius: 4.5, group: 0 });
  world.addParticle({ x: -4, y: -5.5, radius: 4.2, group: 1 });
  const renderers = [
    new CanvasRenderer(canvas, { style }),
    new PixiRenderer(app.stage, { style, renderer: app.renderer }),
  ];
  for (const renderer of renderers) renderer.resize(width, height, pixelRatio);
  for (let i = 0; i < 60; i++) {
    view.zoomAt(300, 50, 1.08);
    renderers[1].render(world, view, 1);
    app.render();
  }
  view.fit({ minX: -6, maxX: 6, minY: -4, maxY: 4 });
  for (const renderer of renderers) renderer.render(world, view, 1);
  app.render();
  const a = pixels(canvas);
  const b = pixels(app.canvas);
  return [missing(a, b, 1.5 * pixelRatio), missing(b, a, 1.5 * pixelRatio), edges(a, b, 1.5 * pixelRatio)];
}

/** Pixels of clearly another colour in `b` than any within `reach` pixels of the same place in `a`. */
function edges(a: ImageData, b: ImageData, reach: number): number {
  let count = 0;
  const span = Math.ceil(reach);
  for (let y = span; y < a.height - span; y++) {
    for (let x = span; x < a.width - span; x++) if (!sameNear(a, b, x, y, span)) count++;
  }
  return count;
}

function sameNear(a: ImageData, b: ImageData, x: number, y: number, span: number): boolean {
  const at = (y * b.width + x) * 4;
  for (let dy = -span; dy <= span; dy++) {
    for (let dx = -span; dx <= span; dx++) {
      const other = ((y + dy) * a.width + x + dx) * 4;
      let distance = 0;
      for (let channel = 0; channel < 3; channel++) {
        distance = Math.max(distance, Math.abs(a.data[other + channel] - b.data[at + channel]));
      }
      if (distance < 100) return true; // soft edges differ by some
    }
  }
  return false;
}

let draws = 0;
const live = new Set<unknown>();

/** From here on, counts what WebGL is asked to draw and what it keeps. */
export function countWebGL(): void {
  const prototype = WebGL2RenderingContext.prototype as unknown as Record<string, (...values: unknown[]) => unknown>;
  const wrap = (name: string, after: (result: unknown, first: unknown) => void): void => {
    const original = prototype[name];
    prototype[name] = function (this: unknown, ...values: unknown[]): unknown {
      const result = original.apply(this, values);
      after(result, values[0]);
      return result;
    };
  };
  for (const name of ['drawElements', 'drawArrays', 'drawElementsInstanced', 'drawArraysInstanced']) {
    wrap(name, () => draws++);
  }
  for (const kind of ['Texture', 'Buffer', 'VertexArray', 'Framebuffer', 'Renderbuffer']) {
    wrap(`create${kind}`, (made) => live.add(made));
    wrap(`delete${kind}`, (_, gone) => live.delete(gone));
  }
}

/** Draw calls of one frame of so many particles, outlined and with trails or not. */
export async function drawCalls(count: number, decorated: boolean): Promise<number[]> {
  const app = await makeApplication(1);
  const world = new World();
  for (let i = 0; i < count; i++) {
    world.addParticle({
      x: ((i % 100) - 50) / 10,
      y: Math.floor(i / 100) / 20 - 2,
      vx: 1,
      radius: (i % 7) / 100,
      group: i % 3,
    });
  }
  const plain: Style = { particle: { fill: '#2563eb' }, groups: { 1: { fill: '#dc2626' }, 2: { fill: '#16a34a' } } };
  const rich: Style = { ...plain, particle: { stroke: '#000000', trail: { seconds: 0.2, points: 4 } } };
  const renderer = new PixiRenderer(app.stage, { style: decorated ? rich : plain, renderer: app.renderer });
  const calls: number[] = [];
  for (let frame = 0; frame < 5; frame++) {
    world.step(1 / 60);
    renderer.render(world, camera(), 1);
    draws = 0;
    app.render();
    calls.push(draws);
  }
  app.destroy(true);
  return calls;
}

/** Draw calls of one frame of so many links, and of one of everything. */
export async function drawCallsOfLinks(count: number): Promise<number[]> {
  const app = await makeApplication(1);
  const world = new World();
  const particles = Array.from({ length: count + 1 }, (_, i) =>
    world.addParticle({ x: (i % 100) / 10 - 5, y: i / 2000 }),
  );
  for (let i = 0; i < count; i++) world.addLink(rod(particles[i], particles[i + 1]));
  const calls: number[] = [];
  const renderer = new PixiRenderer(app.stage, { renderer: app.renderer });
  for (const each of [world, everything()]) {
    each.step(1e-3);
    renderer.style = each === world ? {} : everyStyle(false, true);
    renderer.render(each, camera(), 1);
    draws = 0;
    app.render();
    calls.push(draws);
  }
  app.destroy(true);
  return calls;
}

/** What is left after a renderer was made, used and destroyed, several times over. */
export async function leftovers(times: number) {
  const app = await makeApplication(1);
  const own = new Graphics().circle(10, 10, 5).fill('#123456');
  app.stage.addChild(own);
  const left: { live: number; textures: number; children: number }[] = [];
  for (let n = 0; n < times; n++) {
    const world = scene();
    const renderer = new PixiRenderer(app.stage, { style, renderer: app.renderer });
    const sprite = new Graphics().rect(0, 0, 4, 4).fill('#000000');
    const all = everything();
    renderer.bind(world.particleAt(0), sprite);
    for (let i = 0; i < 30; i++) {
      world.step(1 / 60);
      if (i % 10 === 5) {
        renderer.style = everyStyle(false, true);
        all.step(1 / 60);
        renderer.render(all, camera(), 1);
        app.render();
        renderer.style = style;
        renderer.bind(world.particleAt(0), sprite);
      }
      if (i === 10) for (let more = 0; more < 500; more++) world.addParticle({ x: 0, y: 0, radius: more / 500 });
      renderer.render(world, camera(), 1);
      app.render();
    }
    renderer.destroy();
    renderer.destroy();
    if (sprite.destroyed || sprite.parent !== null) throw new Error("the game's own drawing was not given back");
    sprite.destroy();
    app.render();
    const { managedTextures } = app.renderer.texture as unknown as { managedTextures: readonly unknown[] };
    left.push({
      live: live.size,
      textures: managedTextures.filter(Boolean).length,
      children: app.stage.children.length,
    });
  }
  return left;
}

/** Where a bound drawing of each renderer is, beside where the camera sees its particle, through fall, removal and reuse. */
export async function follow() {
  const app = await makeApplication(1);
  const view = camera();
  const world = new World({ gravity: { x: 0, y: -9.81 } });
  const particle = world.addParticle({ x: -2, y: 3, vx: 2, radius: 0.3 });
  const onCanvas = new CanvasRenderer(makeCanvas());
  const onPixi = new PixiRenderer(app.stage, { renderer: app.renderer });
  for (const renderer of [onCanvas, onPixi]) renderer.resize(width, height, 1);
  const drawn: number[] = [];
  onCanvas.bind(particle, (context, x, y, radius) => {
    drawn.splice(0, 3, x, y, radius);
    context.fillStyle = '#ff0000';
    context.fillRect(x - radius, y - radius, 2 * radius, 2 * radius);
  });
  const sprite = new Graphics().rect(-15, -15, 30, 30).fill('#ff0000');
  sprite.scale.set(1.5);
  onPixi.bind(particle, sprite);
  const body = world.addBody(box({ x: 1, y: 2, width: 1, height: 0.5, angularVelocity: 3 }));
  const crate = new Graphics().rect(-25, -12, 50, 25).fill('#00ff00');
  const turned: number[] = [];
  onPixi.bind(body, crate);
  onCanvas.bind(body, (_, x, y, angle) => turned.splice(0, 3, x, y, angle));
  const apart: number[] = [];
  for (let i = 0; i < 30; i++) {
    world.step(1 / 60);
    onCanvas.render(world, view, 1);
    onPixi.render(world, view, 1);
    apart.push(Math.hypot(turned[0] - crate.x, turned[1] - crate.y), Math.abs(turned[2] - crate.rotation));
    apart.push(
      Math.hypot(crate.x - view.toScreenX(body.x), crate.y - view.toScreenY(body.y)),
      Math.abs(crate.rotation + body.angle),
    );
    const x = view.toScreenX(particle.x);
    const y = view.toScreenY(particle.y);
    apart.push(Math.hypot(drawn[0] - x, drawn[1] - y), Math.hypot(sprite.x - x, sprite.y - y));
  }
  app.render();
  const { scale, parent } = sprite;
  const held = { scale: scale.x, parented: parent !== null };
  particle.remove();
  body.remove();
  world.addParticle({ x: 0, y: 0 });
  drawn.length = 0;
  onCanvas.render(world, view, 1);
  onPixi.render(world, view, 1);
  app.render();
  return {
    apart: Math.max(...apart),
    ...held,
    afterwards: { drawn: drawn.length, parented: sprite.parent !== null || crate.parent !== null },
  };
}

/** Draws one of everything with both renderers. */
async function drawEverything(pixelRatio: number, dark: boolean, arrows: boolean) {
  const app = await makeApplication(pixelRatio, 900, 600);
  const canvas = makeCanvas(900, 600);
  const view = new Camera({ pixelsPerMetre: 50, width: 900, height: 600 });
  const world = everything();
  const style = everyStyle(dark, arrows);
  const renderers = [
    new CanvasRenderer(canvas, { style }),
    new PixiRenderer(app.stage, { style, renderer: app.renderer }),
  ];
  for (const renderer of renderers) renderer.resize(900, 600, pixelRatio);
  for (let i = 0; i < 20; i++) {
    world.step(1 / 60);
    for (const renderer of renderers) renderer.render(world, view, 0.5);
  }
  app.render();
  return { canvas, app };
}

/** How the two differ where one of everything is drawn: ink and colours that the other lacks, in device pixels. */
export async function compareEverything(pixelRatio: number, dark: boolean): Promise<number[]> {
  const { canvas, app } = await drawEverything(pixelRatio, dark, true);
  const a = pixels(canvas);
  const b = pixels(app.canvas);
  const reach = 1.5 * pixelRatio;
  if (dark) return [edges(a, b, reach), edges(b, a, reach)]; // there the ground is ink too
  return [missing(a, b, reach), missing(b, a, reach), edges(a, b, reach), edges(b, a, reach)];
}

/** The two pictures, for the eye. */
export async function show(pixelRatio: number, dark: boolean, arrows: boolean): Promise<string[]> {
  const { canvas, app } = await drawEverything(pixelRatio, dark, arrows);
  app.render();
  return [canvas.toDataURL(), app.canvas.toDataURL()];
}
