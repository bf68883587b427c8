import { expect, inWindow, openAtStart, openScene, pause, read, renderers, skipUntil, test } from './gallery.ts';

for (const renderer of renderers) {
  const query = renderer === 'pixi' ? '?renderer=pixi' : '';

  test(`a mass on a spring follows the mouse and swings on, on ${renderer}`, async ({ page }) => {
    await openAtStart(page, 'springs-amplitude', query);
    const bob = await inWindow(page, 6, 1.8);
    await page.mouse.move(bob.x, bob.y);
    await page.mouse.down();
    const goal = await inWindow(page, 2, 1.8);
    await page.mouse.move(goal.x, goal.y, { steps: 4 });
    await page.keyboard.press(' ');
    const x = () => read(page, ({ world }) => world.particleAt(3).x);
    await expect.poll(async () => Math.abs((await x()) - 2), { timeout: 60_000 }).toBeLessThan(0.5);
    await page.mouse.up();
    await expect.poll(x, { timeout: 60_000 }).toBeLessThan(0);
  });

  test(`a box that was lifted out of petrol floats in oil, on ${renderer}`, async ({ page }) => {
    await openAtStart(page, 'buoyancy-liquids', query);
    const { x, y } = await read(page, ({ world }) => ({ x: world.particleAt(0).x, y: world.particleAt(0).y }));
    const box = await inWindow(page, x, y);
    await page.mouse.move(box.x, box.y);
    await page.mouse.down();
    await page.keyboard.press(' ');
    const over = await inWindow(page, x, 2.4);
    await page.mouse.move(over.x, over.y, { steps: 4 });
    const beyond = await inWindow(page, x + 2.8, 2.4);
    await page.mouse.move(beyond.x, beyond.y, { steps: 8 });
    await expect
      .poll(() => read(page, ({ world }) => world.particleAt(0).x), { timeout: 60_000 })
      .toBeGreaterThan(x + 2.5);
    await page.mouse.up();
    await pause(page);
    // It draws 850 / 910 of its height there; in petrol it would lie on the ground.
    const unrest = () =>
      read(page, ({ world }) => Math.abs(world.particleAt(0).y - 0.5 + 850 / 910) + Math.abs(world.particleAt(0).vy));
    await skipUntil(page, async () => (await unrest()) < 0.1, 60);
  });
}

test('a heavier block is lifted as much under water, and sinks where it outweighs the water', async ({ page }) => {
  await openScene(page, 'buoyancy-explained', '?mass=1.2');
  await expect.poll(() => read(page, ({ world }) => world.particleAt(1).y), { timeout: 60_000 }).toBeLessThan(-0.1);
  await expect(page.locator('#statistics')).toContainText('right 10.00 N');
});

test('a longer wave takes another period', async ({ page }) => {
  await openScene(page, 'buoyancy-waves');
  const period = () => read(page, ({ setup }) => setup.readouts?.()[0].value ?? 0);
  const before = await period();
  await page.getByRole('slider', { name: 'Wavelength' }).focus();
  for (let n = 0; n < 4; n++) await page.keyboard.press('ArrowRight');
  await expect.poll(() => read(page, ({ values }) => values['length'])).toBe(10);
  expect(await period()).toBeGreaterThan(before * 1.05);
});
