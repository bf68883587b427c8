import { expect, inWindow, openAtStart, openScene, pause, read, renderers, test } from './gallery.ts';

for (const renderer of renderers) {
  const query = renderer === 'pixi' ? '&renderer=pixi' : '';

  test(`a rocket bursts into stars, and they burst again, on ${renderer}`, async ({ page }) => {
    await openAtStart(page, 'fireworks', `?sparks=500&rate=0${query}`);
    await page.keyboard.press('2');
    const aloft = await page.evaluateHandle(() => {
      const seen = { rockets: 0, stars: 0, sparks: 0 };
      const look = (): void => {
        const { count, alive, group } = (window.mass as NonNullable<typeof window.mass>).world.particles;
        for (let i = 0; i < count; i++) {
          if (alive[i] !== 1 || group[i] % 10 !== 2) continue;
          seen[group[i] < 10 ? 'rockets' : group[i] > 50 ? 'sparks' : 'stars']++;
        }
        requestAnimationFrame(look);
      };
      look();
      return seen;
    });
    await page.keyboard.press(' ');
    await expect.poll(async () => (await aloft.jsonValue()).rockets, { timeout: 60_000 }).toBeGreaterThan(0);
    await expect.poll(async () => (await aloft.jsonValue()).stars, { timeout: 60_000 }).toBeGreaterThan(10);
    await expect.poll(async () => (await aloft.jsonValue()).sparks, { timeout: 60_000 }).toBeGreaterThan(100);
  });

  test(`10 000 sparks animate, on ${renderer}`, async ({ page }) => {
    await openScene(page, 'fireworks', `?sparks=10000&rate=3${query}`);
    await expect
      .poll(() => read(page, ({ world }) => world.particleCount), { timeout: 100_000 })
      .toBeGreaterThan(10_000);
    const before = await read(page, ({ world, frames }) => ({ time: world.time, frames }));
    await expect.poll(() => read(page, ({ frames }) => frames), { timeout: 60_000 }).toBeGreaterThan(before.frames + 5);
    expect(await read(page, ({ world }) => world.time)).toBeGreaterThan(before.time);
    expect(await read(page, ({ stage }) => stage.failed)).toBe(false);
  });

  test(`a click sets one off where it was made, on ${renderer}`, async ({ page }) => {
    await openAtStart(page, 'fireworks', `?sparks=500&rate=0${query}`);
    const place = await inWindow(page, 9, 12);
    await page.mouse.click(place.x, place.y);
    await expect.poll(() => read(page, ({ world }) => world.particleCount)).toBe(2);
    const { x, y } = await read(page, ({ world }) => ({ x: world.particleAt(1).x, y: world.particleAt(1).y }));
    expect(Math.hypot(x - 9, y - 12)).toBeLessThan(0.1);
  });

  test(`a rocket bursts where it is held, and a click on one sets another off, on ${renderer}`, async ({ page }) => {
    await openAtStart(page, 'fireworks', `?sparks=500&rate=0${query}`);
    const rocketInWindow = async () => {
      // What was in the sky before is gone when the rocket rises.
      await read(page, ({ stage }) => stage.skip(6));
      await page.keyboard.press('2');
      const { x, y } = await read(page, ({ stage, world: { particles } }) => {
        stage.skip(0.5);
        const slot = particles.group.findIndex((group, n) => group === 2 && particles.alive[n] === 1);
        return { x: particles.x[slot], y: particles.y[slot] };
      });
      return inWindow(page, x, y);
    };
    const held = await rocketInWindow();
    const goal = await inWindow(page, -12, 18);
    await page.mouse.move(held.x, held.y);
    await page.mouse.down();
    await page.mouse.move(goal.x, goal.y, { steps: 3 });
    const stars = await read(page, ({ stage, world: { particles } }) => {
      for (let n = 0; n < 120; n++) {
        stage.skip(1 / 60);
        const { count, alive, group, x, y } = particles;
        const seen = Array.from({ length: count }, (_, slot) => slot).filter((i) => alive[i] === 1 && group[i] === 22);
        if (seen.length > 0) return seen.map((i) => Math.hypot(x[i] + 12, y[i] - 18));
      }
      return [];
    });
    await page.mouse.up();
    expect(stars.length).toBeGreaterThan(5);
    expect(Math.max(...stars)).toBeLessThan(1);

    const clicked = await rocketInWindow();
    await page.mouse.click(clicked.x, clicked.y);
    expect(await read(page, ({ world }) => world.particleCount)).toBe(2);
  });
}

test('another seed is another show, the same seed the same', async ({ page }) => {
  const skyOf = async (seed: string): Promise<number[]> => {
    const field = page.getByLabel('Seed');
    await field.fill(seed);
    await field.press('Enter');
    await expect.poll(() => read(page, (mass) => String(mass.seed))).toBe(seed);
    await field.blur();
    return read(page, ({ stage, world }) => {
      stage.skip(3);
      return [...world.particles.x.slice(0, 50)];
    });
  };
  await openScene(page, 'fireworks', '?sparks=500');
  await pause(page);
  const one = await skyOf('5');
  const two = await skyOf('6');
  expect(two).not.toEqual(one);
  expect(await skyOf('5')).toEqual(one);
  await expect(page).toHaveURL(/[?&]seed=5/);
});
