import { expect, inWindow, openAtStart, pause, read, renderers, skipUntil, test } from './gallery.ts';

for (const renderer of renderers) {
  const query = renderer === 'pixi' ? '?renderer=pixi' : '';

  test(`after a long frame the balls jump where no contact rests, on ${renderer}`, async ({ page }) => {
    await openAtStart(page, 'resting-contact', query);
    await page.getByRole('button', { name: 'A long frame' }).click();
    const heights = () =>
      read(page, ({ stage }) => stage.panes.map(({ world }) => world.particleAt(3).y - world.particleAt(3).radius));
    await page.locator('#play').click();
    await expect.poll(async () => (await heights())[0]).toBeGreaterThan(0.1);
    expect((await heights())[1]).toBeLessThan(1e-6);
  });

  test(`a hook is pulled by its line, a block by its outline, on ${renderer}`, async ({ page }) => {
    for (const [id, slot, x, y] of [
      ['contact-normal', 1, -0.45, 0.35], // on the ring of the lower hook
      ['contact-order', 0, 0.9, 1.4], // near a corner of the block
    ] as const) {
      await openAtStart(page, id, query);
      const hold = await inWindow(page, x, y);
      const goal = await inWindow(page, x + 1, y + 0.4);
      await page.mouse.move(hold.x, hold.y);
      await page.mouse.down();
      await page.mouse.move(goal.x, goal.y, { steps: 4 });
      const place = () => page.evaluate((n) => window.mass?.world.particles.x[n] ?? 0, slot);
      await skipUntil(page, async () => (await place()) > 0.8, 5);
      await page.mouse.up();
    }
  });

  test(`discs that were pushed about go back into each other, on ${renderer}`, async ({ page }) => {
    await openAtStart(page, 'interpenetration', query);
    const left = () => read(page, ({ world }) => world.particleAt(0).x);
    const start = await left();
    await page.keyboard.press(' ');
    await expect.poll(left).toBeGreaterThan(start + 0.3);
    await pause(page);
    await page.keyboard.press('i');
    await expect.poll(left).toBe(start);
  });

  test(`all velocities after the hits are those of the closed form, on ${renderer}`, async ({ page }) => {
    await openAtStart(page, 'masses', query);
    await page.evaluate(() => window.mass?.stage.skip(1.5));
    const speeds = await read(page, ({ world }) => [...world.particles.vx.slice(0, 2)]);
    expect(speeds[0]).toBeCloseTo((5.25 / 7.25) * 2, 12);
    expect(speeds[1]).toBeCloseTo((12.5 / 7.25) * 2, 12);
    await page.keyboard.press('h');
    expect(await read(page, ({ world }) => world.particleAt(0).vx)).toBe(2);
  });
}
