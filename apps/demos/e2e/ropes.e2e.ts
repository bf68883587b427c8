// Cloth, bridge and ball, by hand: what a reader pulls at tears, what is cut falls.
import { expect, inWindow, openAtStart, read, renderers, test } from './gallery.ts';

for (const renderer of renderers) {
  test(`cloth tears under the pointer, and a click cuts it, on ${renderer}`, async ({ page }) => {
    await openAtStart(page, 'cloth', `?size=24&wind=0&renderer=${renderer}`);
    const threads = (): Promise<number> => read(page, ({ world }) => world.links.length);
    const whole = await threads();
    const knot = await read(page, ({ world }) => ({ x: world.particles.x[156], y: world.particles.y[156] }));
    const from = await inWindow(page, knot.x, knot.y);
    const to = await inWindow(page, knot.x + 0.4, -1.5);
    await page.mouse.move(from.x, from.y);
    await page.mouse.down();
    await page.mouse.move(to.x, to.y, { steps: 5 });
    await read(page, ({ stage }) => stage.skip(1.5));
    await page.mouse.up();
    const torn = await threads();
    expect(torn, 'threads left by the hand').toBeLessThan(whole - 3);

    const other = await read(page, ({ world }) => ({ x: world.particles.x[100], y: world.particles.y[100] }));
    const at = await inWindow(page, other.x, other.y);
    await page.mouse.click(at.x, at.y);
    expect(await threads(), 'threads left by a click').toBeLessThan(torn);
  });
}

test('the bridge falls when its ropes are cut, and the ball with it', async ({ page }) => {
  await openAtStart(page, 'rope-bridge');
  await read(page, ({ stage }) => stage.skip(2));
  await page.keyboard.press('c');
  await read(page, ({ stage }) => stage.skip(6));
  expect(await read(page, ({ world }) => world.particleAt(2).y), 'height of the ball, m').toBeLessThan(-2);
});

test('the wall stands until the ball comes, and can be built again', async ({ page }) => {
  await openAtStart(page, 'wrecking-ball');
  const height = (): Promise<number> => {
    return read(page, ({ world }) => Math.max(...world.bodies.filter((each) => each.closed).map(({ y }) => y)));
  };
  const before = await height();
  await read(page, ({ stage }) => stage.skip(1));
  expect(await height()).toBeCloseTo(before, 1);
  await read(page, ({ stage }) => stage.skip(5));
  expect(await height()).toBeLessThan(before - 0.5);
  await page.keyboard.press('b');
  expect(await height()).toBeCloseTo(before, 1);
});
