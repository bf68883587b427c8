// Every scene on both renderers, as a reader uses it: it opens, moves, is drawn, is dragged, its sliders and keys work, it
// begins anew. One page load for each scene and renderer; the fixture fails a test on anything in the console.
import type { Page } from 'playwright/test';
import { scenes } from '../src/scenes/index.ts';
import type { Scene } from '../src/scenes/scene.ts';
import type { RendererKind } from '../src/stage/renderers.ts';
import { expect, openScene, pause, read, renderers, test } from './gallery.ts';

/** A machine may be slow; what is expected stays the same. Unit: ms. */
const patience = { timeout: 60_000 };

for (const renderer of renderers) {
  for (const scene of scenes) {
    test(`${scene.id} works on ${renderer}`, async ({ page }) => {
      test.setTimeout(300_000);
      await openScene(page, scene.id, renderer === 'pixi' ? '?renderer=pixi' : '');
      await test.step('it moves', () => moves(page));
      await test.step('it can be dragged', () => isDragged(page));
      for (const name of Object.keys(scene.parameters)) {
        await test.step(`the slider of ${name} works`, () => sliderWorks(page, scene, name));
      }
      await test.step('its keys work', () => keysWork(page));
      await test.step('it begins anew', () => beginsAnew(page));
      await test.step('it is drawn, by PixiJS as by Canvas 2D', () => isDrawn(page, renderer));
    });
  }
}

async function moves(page: Page): Promise<void> {
  const { time, frames } = await read(page, ({ world, frames }) => ({ time: world.time, frames }));
  await expect.poll(() => read(page, ({ world }) => world.time), patience).toBeGreaterThan(time + 0.1);
  await expect.poll(() => read(page, ({ frames }) => frames), patience).toBeGreaterThan(frames);
}

/** Pictures are compared cell by cell, since edges are smoothed differently: so many cells in a row. */
const RASTER = 48;

/** There is ink, and where PixiJS draws, Canvas 2D has it in the same places in the same paused state. */
async function isDrawn(page: Page, renderer: RendererKind): Promise<void> {
  await pause(page);
  const { drawnBy, own, other, failed } = await page.evaluate(async (columns) => {
    const { stage } = window.mass as NonNullable<typeof window.mass>;
    // Trails are what was drawn before: both renderers draw the same second from its start.
    const play = (): void => {
      stage.reset();
      for (let n = 0; n < 20; n++) {
        stage.skip(0.05);
        for (const pane of stage.panes) pane.picture.draw(pane.world, pane.camera, 1);
      }
    };
    // Drawn and read in one task: a WebGL canvas is empty again after it was painted.
    const ink = (): number[][] =>
      stage.panes.map(({ picture: { canvas } }) => {
        const { width, height } = canvas;
        const rows = Math.max(1, Math.round((columns * height) / width));
        const copy = new OffscreenCanvas(width, height);
        const context = copy.getContext('2d', { willReadFrequently: true }) as OffscreenCanvasRenderingContext2D;
        context.drawImage(canvas, 0, 0);
        const { data } = context.getImageData(0, 0, width, height);
        const cells: number[] = new Array(columns * rows).fill(0);
        for (let y = 0; y < height; y++) {
          for (let x = 0; x < width; x++) {
            const cell = Math.floor((y * rows) / height) * columns + Math.floor((x * columns) / width);
            cells[cell] += data[4 * (y * width + x) + 3] / 255;
          }
        }
        return cells.map((sum) => sum / ((width / columns) * (height / rows)));
      });
    const drawnBy = stage.renderer;
    play();
    const own = ink();
    if (drawnBy === 'canvas2d') return { drawnBy, own, other: own, failed: stage.failed };
    await stage.useRenderer('canvas2d');
    play();
    return { drawnBy, own, other: ink(), failed: stage.failed };
  }, RASTER);
  expect({ drawnBy, failed }).toEqual({ drawnBy: renderer, failed: false });
  for (const [pane, cells] of own.entries()) {
    const total = cells.reduce((sum, ink) => sum + ink, 0);
    const apart = cells.reduce((sum, ink, n) => sum + Math.abs(ink - other[pane][n]), 0);
    expect(total, 'ink, in cells').toBeGreaterThan(0.5);
    expect(apart / total, 'share of the ink that is elsewhere').toBeLessThan(0.12);
  }
}

/** A particle in the page: whose, where it is drawn, and whether anything but weight and liquid holds it. */
interface Grip {
  readonly pane: number;
  readonly slot: number;
  /** Units: CSS px of the window. */
  readonly x: number;
  readonly y: number;
  readonly free: boolean;
  /** Where there is room to drag it to. */
  readonly goal: { readonly x: number; readonly y: number };
}

/**
 * Takes a movable particle where it is drawn, drags it up and towards the middle, or across the link that holds it, and lets
 * it go. One that is free comes to within 10 CSS px of the pointer. One that links, springs or its body hold comes as near, or
 * moves towards it by 4 px and more.
 */
async function isDragged(page: Page): Promise<void> {
  await pause(page);
  await page.keyboard.press('r');
  await page.evaluate(() => window.scrollTo(0, 0));
  // Some scenes let things in one after the other.
  for (let n = 0; n < 5 && !(await findGrip(page)); n++) await read(page, ({ stage }) => stage.skip(0.5));
  const grip = await findGrip(page);
  if (!grip) throw new Error('A scene must have something in sight that can be dragged; it has nothing.');
  const { pane, goal } = grip;
  await page.mouse.move(grip.x, grip.y);
  await page.mouse.down();
  const slot = await heldIn(page, pane);
  expect(slot, 'the pointer holds a particle').toBeGreaterThanOrEqual(0);
  const start = await placeAfter(page, 0, pane, slot);
  if (grip.free) {
    await page.mouse.move(goal.x, goal.y, { steps: 2 });
    let left = distance(start, goal);
    for (let n = 0; n < 200 && left >= 10; n++) left = distance(await placeAfter(page, 0.05, pane, slot), goal);
    expect(left, 'px from the pointer, after 10 s').toBeLessThan(10);
  } else {
    // The ground may be in the way on one side, but not on both: the pointer goes to and fro.
    const goals = [{ x: 2 * start.x - goal.x, y: 2 * start.y - goal.y }, goal];
    const nearer = async (): Promise<boolean> => {
      const [to] = goals.reverse();
      await page.mouse.move(to.x, to.y, { steps: 2 });
      return distance(await placeAfter(page, 0.5, pane, slot), to) < Math.max(10, distance(start, to) - 4);
    };
    const message = `particle ${slot} moves towards the pointer`;
    await expect.poll(nearer, { ...patience, intervals: [0], message }).toBe(true);
  }
  await page.mouse.up();
  expect(await heldIn(page, pane), 'the hand is empty').toBe(-1);
  await goesOn(page);
}

function distance(a: { x: number; y: number }, b: { x: number; y: number }): number {
  return Math.hypot(a.x - b.x, a.y - b.y);
}

/** What is in the hand, as its slot; -1 for nothing. */
function heldIn(page: Page, pane: number): Promise<number> {
  return page.evaluate((index) => {
    for (const force of window.mass?.stage.panes[index].world.forces ?? []) {
      if ('moveTo' in force && 'held' in force) return (force.held as { slot: number } | undefined)?.slot ?? -1;
    }
    return -1;
  }, pane);
}

/** Where a particle is drawn when the paused scene has run on. Units: s, CSS px of the window. */
function placeAfter(page: Page, seconds: number, pane: number, slot: number): Promise<{ x: number; y: number }> {
  return page.evaluate(
    ([time, index, at]) => {
      const { stage } = window.mass as NonNullable<typeof window.mass>;
      stage.skip(time);
      const { camera, element, world } = stage.panes[index];
      const { left, top } = element.getBoundingClientRect();
      const { x, y } = world.particles;
      return { x: left + camera.toScreenX(x[at]), y: top + camera.toScreenY(y[at]) };
    },
    [seconds, pane, slot] as const,
  );
}

/** The movable particle that is best to take: free if there is one, and near the middle of the picture. */
function findGrip(page: Page): Promise<Grip | undefined> {
  return page.evaluate(() => {
    const grips: (Grip & { readonly rank: number })[] = [];
    for (const [pane, { world, camera, element }] of (window.mass?.stage.panes ?? []).entries()) {
      const { left, top, width, height } = element.getBoundingClientRect();
      // What holds a particle: the other end of its first link, or its body.
      const holders = new Map<number, { readonly x: number; readonly y: number } | undefined>();
      for (const { a, b } of world.links) {
        if ('slot' in a && !holders.has(a.slot)) holders.set(a.slot, b);
        if ('slot' in b && !holders.has(b.slot)) holders.set(b.slot, a);
      }
      for (const body of world.bodies) for (const { slot } of body.particles) holders.set(slot, undefined);
      // Springs and bungees do not tell which particles they hold: where there are any, all may be held.
      const sprung = world.forces.some((force) => 'add' in force && 'count' in force);
      const { count, alive, inverseMass, lifetime, x, y } = world.particles;
      for (let slot = 0; slot < count; slot++) {
        // What is gone within half a second is not worth taking.
        if (alive[slot] === 0 || inverseMass[slot] === 0 || lifetime[slot] < 0.5) continue;
        if (window.mass?.setup.takes?.(world.particleAt(slot)) === false) continue;
        const [px, py] = [camera.toScreenX(x[slot]), camera.toScreenY(y[slot])];
        if (px < 12 || px > width - 12 || py < 60 || py > height - 12) continue;
        const free = !sprung && !holders.has(slot);
        const rank = (free ? 0 : 1e6) + Math.hypot(px - width / 2, py - height / 2);
        let [dx, dy] = [width / 2 < px ? -40 : 40, -45];
        // Along a link nothing moves, however hard it is pulled: what hangs on one is pulled across it, and up.
        const holder = holders.get(slot);
        if (holder) {
          const [rx, ry] = [camera.toScreenX(holder.x) - px, camera.toScreenY(holder.y) - py];
          const scale = (rx * dy < ry * dx ? -60 : 60) / Math.max(1, Math.hypot(rx, ry));
          [dx, dy] = [-ry * scale, rx * scale];
        }
        const goal = { x: left + px + dx, y: top + py + dy };
        grips.push({ pane, slot, x: left + px, y: top + py, free, goal, rank });
      }
    }
    return grips.sort((a, b) => a.rank - b.rank)[0];
  });
}

/** Time passes, by itself or after the space bar, and nothing has failed. */
async function goesOn(page: Page): Promise<void> {
  if (!(await read(page, ({ stage }) => stage.playing))) await page.locator('#play').click();
  const state = await page.evaluate(async (limit) => {
    const mass = window.mass as NonNullable<typeof window.mass>;
    const { stepCount } = mass.world;
    const until = performance.now() + limit;
    while (mass.world.stepCount === stepCount && performance.now() < until) await new Promise(requestAnimationFrame);
    const { playing, failed } = mass.stage;
    const fault = document.querySelector('[role="alert"]')?.checkVisibility();
    return { passes: mass.world.stepCount !== stepCount, playing, failed, fault };
  }, patience.timeout);
  expect(state).toEqual({ passes: true, playing: true, failed: false, fault: false });
}

/** One press of an arrow key: the value and the address change, and the scene goes on, in a new world unless the value is live. */
async function sliderWorks(page: Page, scene: Scene, name: string): Promise<void> {
  const { label, max, live = false } = scene.parameters[name];
  const slider = page.getByRole('slider', { name: label, exact: true });
  const value = (): Promise<number> => page.evaluate((key) => window.mass?.values[key] ?? Number.NaN, name);
  const before = await page.evaluate((key) => {
    Object.assign(window, { worldBefore: window.mass?.world });
    return window.mass?.values[key] ?? Number.NaN;
  }, name);
  await slider.focus();
  await page.keyboard.press(before < max ? 'ArrowRight' : 'ArrowLeft');
  await expect.poll(value, patience).not.toBe(before);
  const now = await value();
  await expect(page).toHaveURL((url) => url.searchParams.get(name) === String(now));
  const stayed = await page.evaluate(() => (window as { worldBefore?: unknown }).worldBefore === window.mass?.world);
  expect(stayed, live ? 'a live value leaves the world' : 'a value makes a new world').toBe(live);
  await goesOn(page);
}

/** Each of the scene's own keys does something or nothing, but no harm. */
async function keysWork(page: Page): Promise<void> {
  await page.evaluate(() => (document.activeElement as HTMLElement | null)?.blur());
  const keys = await read(page, ({ setup }) => setup.actions?.map(({ key }) => key) ?? []);
  expect(await page.locator('[data-key]').count()).toBe(keys.length);
  for (const key of keys) {
    await page.keyboard.press(key);
    await goesOn(page);
  }
}

async function beginsAnew(page: Page): Promise<void> {
  await pause(page);
  await page.keyboard.press('r');
  await expect.poll(() => read(page, ({ world }) => world.stepCount)).toBe(0);
  await goesOn(page);
}
