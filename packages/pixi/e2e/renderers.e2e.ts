// Both renderers in a real browser: the same things at the same places, one draw call, nothing left behind.
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';
import { expect, type Page, test } from 'playwright/test';
import type * as Fixture from './fixture.ts';

declare const fixture: typeof Fixture;

let script: string;
let said: string[];

test.beforeAll(async () => {
  const { outputFiles } = await build({
    entryPoints: [fileURLToPath(new URL('fixture.ts', import.meta.url))],
    bundle: true,
    write: false,
    format: 'iife',
    globalName: 'fixture',
  });
  script = outputFiles[0].text;
});

async function open(page: Page): Promise<void> {
  said = [];
  page.on('console', (message) => {
    // Reading pixels back, as these tests do, is slow, and the driver says so.
    const driver = /GL Driver Message|GPU stall|willReadFrequently/.test(message.text());
    if (['warning', 'error'].includes(message.type()) && !driver) said.push(message.text());
  });
  page.on('pageerror', (error) => said.push(String(error)));
  await page.setContent('<!doctype html><body style="margin:0"></body>');
  await page.addScriptTag({ content: script });
}

test.afterEach(() => expect(said).toEqual([]));

for (const pixelRatio of [1, 2]) {
  test.describe(`at ${pixelRatio} device pixels to a CSS pixel`, () => {
    test.use({ deviceScaleFactor: pixelRatio });

    test('both draw the same things at the same places', async ({ page }) => {
      await open(page);
      const result = await page.evaluate((ratio) => fixture.compare(ratio), pixelRatio);
      const [width, height] = [600 * pixelRatio, 400 * pixelRatio];
      expect(result.sizes).toEqual([width, height, width, height]);
      expect(result.missing, 'ink or colour that the other lacks within 1.5 px').toEqual([0, 0, 0, 0]);
      expect(result.fromTruth, 'centre of a disc from where the camera sees it, px').toBeLessThan(0.25);
      expect(result.fromEachOther, 'centres of a disc on the two, px').toBeLessThan(0.25);
      expect(result.areas, 'radii of a disc on the two, px').toBeLessThan(0.25);
    });

    test('links, springs, shapes, liquids, bodies, arrows and contacts look the same on both', async ({ page }) => {
      await open(page);
      expect(await page.evaluate((ratio) => fixture.compareEverything(ratio, false), pixelRatio)).toEqual([0, 0, 0, 0]);
      expect(await page.evaluate((ratio) => fixture.compareEverything(ratio, true), pixelRatio)).toEqual([0, 0]);
    });

    test('large discs are as sharp, after any zoom', async ({ page }) => {
      await open(page);
      expect(await page.evaluate((ratio) => fixture.compareLarge(ratio), pixelRatio)).toEqual([0, 0, 0]);
    });
  });
}

test('10 000 particles are one draw call, outlines and trails included', async ({ page }) => {
  await open(page);
  await page.evaluate(() => fixture.countWebGL());
  expect(await page.evaluate(() => fixture.drawCalls(10_000, false))).toEqual([1, 1, 1, 1, 1]);
  expect(await page.evaluate(() => fixture.drawCalls(10_000, true))).toEqual([1, 1, 1, 1, 1]);
});

test('5 000 links are one draw call more; one of everything is five', async ({ page }) => {
  await open(page);
  await page.evaluate(() => fixture.countWebGL());
  expect(await page.evaluate(() => fixture.drawCallsOfLinks(5000))).toEqual([2, 5]);
});

test('destroy leaves the container as it was, and nothing on the graphics card', async ({ page }) => {
  await open(page);
  await page.evaluate(() => fixture.countWebGL());
  const [first, ...rest] = await page.evaluate(() => fixture.leftovers(4));
  expect(first.children).toBe(1);

  for (const each of rest) expect(each).toEqual(first);
});

test("a game's own drawing follows its particle and goes with it", async ({ page }) => {
  await open(page);
  expect(await page.evaluate(() => fixture.follow())).toEqual({
    apart: 0,
    scale: 1.5,
    parented: true,
    afterwards: { drawn: 0, parented: false },
  });
});
