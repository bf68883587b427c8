import type { Point } from '../src/scenes/scene.ts';
import { expect, inWindow, openAtStart, openScene, pause, read, renderers, test } from './gallery.ts';

const coefficients = [0, 0.25, 0.5, 1, 2, 4, 8];

for (const renderer of renderers) {
  const query = renderer === 'pixi' ? '?renderer=pixi' : '';

  test(`balls part, and reach m·g / k1, on ${renderer}`, async ({ page }) => {
    await openAtStart(page, 'force-generators', query);
    const balls = await read(page, ({ stage, world }) => {
      stage.skip(3);
      return [0, 1, 2, 3, 4, 5, 6].map((slot) => ({ y: world.particleAt(slot).y, v: -world.particleAt(slot).vy }));
    });
    for (const lane of [4, 5, 6]) expect(balls[lane].v / (9.81 / coefficients[lane])).toBeCloseTo(1, 2);
    for (const lane of [4, 5, 6]) expect(Math.abs(balls[lane].v / (9.81 / coefficients[lane]) - 1)).toBeLessThan(0.01);
    for (let lane = 1; lane < 7; lane++) expect(balls[lane].y).toBeGreaterThan(balls[lane - 1].y);
  });

  test(`a ball follows the mouse and is let go, on ${renderer}`, async ({ page }) => {
    await openAtStart(page, 'force-generators', query);
    const ball = await inWindow(page, 19.5, 19);
    await page.mouse.move(ball.x, ball.y);
    await page.mouse.down();
    const goal = await inWindow(page, 16, 10);
    await page.mouse.move(goal.x, goal.y, { steps: 4 });
    await page.keyboard.press(' ');
    const distance = () =>
      read(page, ({ world }) => Math.hypot(world.particleAt(6).x - 16, world.particleAt(6).y - 10));
    await expect.poll(distance, { timeout: 60_000 }).toBeLessThan(0.3);
    await page.mouse.up();
    await expect.poll(() => read(page, ({ world }) => world.particleAt(6).y), { timeout: 60_000 }).toBeLessThan(9);
  });
}

test.describe('by touch', () => {
  test.use({ hasTouch: true, viewport: { width: 390, height: 740 } });

  test('a finger on a ball takes it, a finger beside it scrolls the page', async ({ page, context }) => {
    await openAtStart(page, 'force-generators');
    const touch = await context.newCDPSession(page);
    const start = (at: Point) => touch.send('Input.dispatchTouchEvent', { type: 'touchStart', touchPoints: [at] });
    const move = async (from: Point, to: Point): Promise<void> => {
      for (let n = 1; n <= 8; n++) {
        const at = { x: from.x + ((to.x - from.x) * n) / 8, y: from.y + ((to.y - from.y) * n) / 8 };
        await touch.send('Input.dispatchTouchEvent', { type: 'touchMove', touchPoints: [at] });
      }
    };
    const lift = () => touch.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] });

    const ball = await inWindow(page, 0, 19);
    await start(ball);
    await expect(page.locator('.pane')).toHaveClass(/grabbing/);
    await move(ball, { x: ball.x, y: ball.y - 90 });
    await page.keyboard.press(' ');
    await expect.poll(() => read(page, ({ world }) => world.particleAt(3).y), { timeout: 60_000 }).toBeGreaterThan(20);
    await lift();
    expect(await page.evaluate(() => window.scrollY)).toBe(0);

    await pause(page);
    const beside = await inWindow(page, -25, 8);
    await start(beside);
    await move(beside, { x: beside.x, y: beside.y - 160 });
    await lift();
    await expect.poll(() => page.evaluate(() => window.scrollY)).toBeGreaterThan(60);
  });
});

test('a wheel scrolls the page, and zooms only with Ctrl', async ({ page }) => {
  await openScene(page, 'force-generators');
  const place = await inWindow(page, 0, 10);
  await page.mouse.move(place.x, place.y);
  const scale = await read(page, ({ camera }) => camera.pixelsPerMetre);
  await page.mouse.wheel(0, 120);
  await expect.poll(() => page.evaluate(() => window.scrollY)).toBeGreaterThan(0);
  expect(await read(page, ({ camera }) => camera.pixelsPerMetre)).toBe(scale);
  await page.evaluate(() => window.scrollTo(0, 0));
  await page.keyboard.down('Control');
  await page.mouse.wheel(0, -120);
  await page.keyboard.up('Control');
  await expect.poll(() => read(page, ({ camera }) => camera.pixelsPerMetre)).toBeGreaterThan(scale);
  await page.getByRole('button', { name: 'Fit the view' }).click();
  expect(await read(page, ({ camera }) => camera.pixelsPerMetre)).toBe(scale);
});
