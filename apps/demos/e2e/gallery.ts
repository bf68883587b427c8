import { test as base, expect, type Locator, type Page } from 'playwright/test';
import type { MassOnPage } from '../src/gallery/mass.ts';
import type { RendererKind } from '../src/stage/renderers.ts';

/** Both renderers: what must hold on one must hold on the other. */
export const renderers: readonly RendererKind[] = ['canvas2d', 'pixi'];

/** A test that fails on anything in the console that is an error or a warning, and on anything that could not be loaded. */
export const test = base.extend<{ quiet: string[] }>({
  quiet: [
    async ({ page }, use) => {
      const noise: string[] = [];
      page.on('console', (message) => {
        if (message.type() === 'error' || message.type() === 'warning')
          noise.push(`${message.type()}: ${message.text()}`);
      });
      page.on('pageerror', (error) => noise.push(`thrown: ${error.message}`));
      page.on('response', (response) => {
        if (response.status() >= 400) noise.push(`${response.status()}: ${response.url()}`);
      });
      await use(noise);
      expect(noise).toEqual([]);
    },
    { auto: true },
  ],
});

export { expect };

/** Reads something of `window.mass` in the page. */
export function read<T>(page: Page, of: (mass: MassOnPage) => T): Promise<T> {
  return page.evaluate(`(${of.toString()})(window.mass)`) as Promise<T>;
}

/**
 * Opens a scene, and waits until it runs, its controls are there, and it is laid out: before that a camera knows no size, and
 * no place in the window.
 */
export async function openScene(page: Page, id: string, query = ''): Promise<void> {
  await page.goto(`scenes/${id}/${query}`);
  await page.locator('[data-choice="renderer"] input').first().waitFor();
  const renderer = new URLSearchParams(query).get('renderer') ?? 'canvas2d';
  await expect.poll(() => read(page, (mass) => mass.renderer)).toBe(renderer);
  await expect.poll(() => read(page, ({ stage }) => stage.panes.every(({ camera }) => camera.width > 0))).toBe(true);
}

/** Opens a scene and takes it back to its start, standing still. */
export async function openAtStart(page: Page, id: string, query = ''): Promise<void> {
  await openScene(page, id, query);
  await pause(page);
  await page.keyboard.press('r');
  await expect.poll(() => read(page, (mass) => mass.world.stepCount)).toBe(0);
}

/** Pauses by the space bar, if it is not paused yet. */
export async function pause(page: Page): Promise<void> {
  if (await read(page, (mass) => mass.stage.playing)) await page.keyboard.press(' ');
  await expect.poll(() => read(page, (mass) => mass.stage.playing)).toBe(false);
}

/** Waits until the world has run for so long. Unit: s. */
export async function runTo(page: Page, seconds: number): Promise<void> {
  await expect.poll(() => read(page, (mass) => mass.world.time), { timeout: 100_000 }).toBeGreaterThan(seconds);
}

/** Lets a paused scene run on, step by step and without a picture, until something holds or so much time is over. Unit: s. */
export async function skipUntil(page: Page, holds: () => Promise<boolean>, seconds = 20): Promise<void> {
  for (let time = 0; time < seconds && !(await holds()); time += 0.1) await read(page, ({ stage }) => stage.skip(0.1));
  expect(await holds(), `within ${seconds} s of the scene's time`).toBe(true);
}

/** Where a point of the world is in the window. Units: m, CSS px. */
export async function inWindow(page: Page, x: number, y: number): Promise<{ x: number; y: number }> {
  return page.evaluate(
    ([worldX, worldY]) => {
      const { camera } = window.mass as MassOnPage;
      const box = (document.querySelector('.pane') as Element).getBoundingClientRect();
      return { x: box.left + camera.toScreenX(worldX), y: box.top + camera.toScreenY(worldY) };
    },
    [x, y],
  );
}

/** The colours at points of what is seen, as #rrggbb. Units: CSS px from the left and the top of the element. */
export async function coloursAt(
  page: Page,
  element: Locator,
  points: readonly { x: number; y: number }[],
): Promise<string[]> {
  const picture = await element.screenshot();
  return page.evaluate(
    async ([data, places]) => {
      const image = new Image();
      image.src = `data:image/png;base64,${data}`;
      await image.decode();
      const canvas = document.createElement('canvas');
      canvas.width = image.width;
      canvas.height = image.height;
      const context = canvas.getContext('2d', { willReadFrequently: true }) as CanvasRenderingContext2D;
      context.drawImage(image, 0, 0);
      return places.map(({ x, y }) => {
        const [r, g, b] = context.getImageData(Math.round(x), Math.round(y), 1, 1).data;
        return `#${((r << 16) | (g << 8) | b).toString(16).padStart(6, '0')}`;
      });
    },
    [picture.toString('base64'), points] as const,
  );
}

/** How far two colours `#rrggbb` are apart, in the worst of the three channels, 0 to 255. */
export function colourDistance(a: string, b: string): number {
  const channels = (colour: string): number[] => [1, 3, 5].map((at) => Number.parseInt(colour.slice(at, at + 2), 16));
  const other = channels(b);
  return Math.max(...channels(a).map((value, n) => Math.abs(value - other[n])));
}
