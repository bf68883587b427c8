import { join } from 'node:path';
import type { Page } from 'playwright/test';
import { scenes } from '../src/scenes/index.ts';
import { expect, openScene, read, test } from './gallery.ts';

const ids = scenes.map(({ id }) => id);

for (const id of ids) {
  test(`${id} fits a phone, has what a page must have, moves, and does not jump when resized`, async ({ page }) => {
    await page.setViewportSize({ width: 360, height: 740 });
    await openScene(page, id);
    await test.step('it fits a phone', () => fitsPhone(page));
    await test.step('it has what a page must have', async () => {
      await expect(page.getByRole('heading', { level: 1 })).not.toBeEmpty();
      await expect(page.locator('.opening .look')).not.toBeEmpty();
      await expect(page.locator('.formula math')).toBeAttached();
      await expect(page.locator('.code pre')).toContainText('build(');
    });
    await test.step('it moves', () => expect.poll(() => read(page, ({ world }) => world.time)).toBeGreaterThan(0.2));
    await test.step('it does not jump when the window is resized', () => doesNotJump(page, id));
  });
}

async function fitsPhone(page: Page): Promise<void> {
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(360);
  const stage = await page.locator('#stage').boundingBox();
  expect(stage?.width).toBeGreaterThan(310);
  expect(stage?.height).toBeGreaterThan(200);
  const play = await page.locator('#play').boundingBox();
  expect(play?.height).toBeGreaterThanOrEqual(40);
}

async function doesNotJump(page: Page, id: string): Promise<void> {
  const now = () => read(page, ({ world }) => ({ time: world.time, steps: world.stepCount }));
  const before = await now();
  for (const width of [900, 500, 1100]) {
    await page.setViewportSize({ width, height: 700 });
    await expect
      .poll(() =>
        read(page, ({ camera, scene, stage }) => {
          const box = stage.panes[0].element.getBoundingClientRect();
          const left = camera.toScreenX(scene.show.minX);
          const right = camera.toScreenX(scene.show.maxX);
          const top = camera.toScreenY(scene.show.maxY);
          const bottom = camera.toScreenY(scene.show.minY);
          const inside = left > -1 && top > -1 && right < box.width + 1 && bottom < box.height + 1;
          const full = right - left > box.width - 2 || bottom - top > box.height - 2;
          const canvas = stage.panes[0].picture.canvas;
          return inside && full && Math.abs(canvas.width - box.width * devicePixelRatio) <= 1;
        }),
      )
      .toBe(true);
  }
  const after = await now();
  expect(after.steps).toBeGreaterThanOrEqual(before.steps);
  if (id === 'resting-contact') return; // its subject is a step of another length, which it takes by itself
  const step = await read(page, ({ clock }) => clock.step);
  expect(after.time - before.time).toBeCloseTo((after.steps - before.steps) * step, 6);
}

/** The world's time of thumbnail `n` of the list, from the top; 0 before it was started. */
function timeOf(page: Page, n: number): Promise<number> {
  return page.evaluate((index) => {
    const host = document.querySelectorAll<HTMLElement>('.card .thumbnail')[index];
    return window.stages?.get(host)?.setup.world.time ?? 0;
  }, n);
}

test('the list shows every scene, by chapter, and those in sight run', async ({ page }) => {
  await page.goto('./');
  await expect(page.locator('.cards:not(.featured) .card')).toHaveCount(ids.length);
  for (const id of ids) await expect(page.locator(`.cards:not(.featured) a[href="scenes/${id}/"]`)).toHaveCount(1);
  for (const link of await page.locator('.contents a').all()) {
    await expect(page.locator((await link.getAttribute('href')) ?? 'none')).toBeAttached();
  }
  for (let n = 0; n < 4; n++) await expect.poll(() => timeOf(page, n)).toBeGreaterThan(0.2);
  const last = page.locator('.card').last();
  await last.scrollIntoViewIfNeeded();
  await expect.poll(() => timeOf(page, ids.length + 3)).toBeGreaterThan(0.2);
  await last.locator('a').click();
  await expect(page.getByRole('heading', { level: 1 })).toBeVisible();
  await page.getByRole('link', { name: 'Mass' }).click();
  await expect(page.locator('.contents')).toBeVisible();
});

test('the scene at the top of the list can be played with, and its view stays', async ({ page }) => {
  await page.goto('./');
  const find = () =>
    page.evaluate(() => {
      const hero = document.querySelector<HTMLElement>('#hero') as HTMLElement;
      const stage = window.stages?.get(hero) as NonNullable<ReturnType<NonNullable<typeof window.stages>['get']>>;
      const { camera, element } = stage.panes[0];
      const { left, top } = element.getBoundingClientRect();
      const { x, y } = stage.setup.world.particleAt(12);
      return { x: left + camera.toScreenX(x), y: top + camera.toScreenY(y), scale: camera.pixelsPerMetre };
    });
  const isLaidOut = () => page.evaluate(() => [...(window.stages?.values() ?? [])][0]?.panes[0].camera.width > 0);
  await expect.poll(isLaidOut).toBe(true);
  const before = await find();
  await page.mouse.move(before.x, before.y);
  await page.mouse.down();
  await page.mouse.move(before.x + 4, before.y - 90, { steps: 4 });
  await expect.poll(async () => (await find()).y, { timeout: 60_000 }).toBeLessThan(before.y - 50);
  await page.mouse.up();
  await page.keyboard.down('Control');
  await page.mouse.wheel(0, -120);
  await page.keyboard.up('Control');
  expect((await find()).scale).toBe(before.scale);
});

test('a chapter is reached by keyboard alone', async ({ page }) => {
  await page.goto('./');
  await page.locator('.contents a').last().focus();
  await page.keyboard.press('Enter');
  await expect(page.locator('.chapter').last()).toBeInViewport();
  await page.keyboard.press('Tab');
  const card = page.locator('.cards').last().locator('a').first();
  await expect(card).toBeFocused();
  await page.keyboard.press('Enter');
  await expect(page).toHaveURL(/scenes/);
});

test('a thumbnail out of sight stands still, and only a few run at a time', async ({ page }) => {
  await page.setViewportSize({ width: 1280, height: 700 });
  await page.goto('./');
  await expect.poll(() => timeOf(page, 0)).toBeGreaterThan(0.2);
  const running = () =>
    page.evaluate(
      () => [...(window.stages?.values() ?? [])].filter(({ playing, inSight }) => playing && inSight).length,
    );
  let most = 0;
  for (const card of await page.locator('.card').all()) {
    await card.scrollIntoViewIfNeeded();
    most = Math.max(most, await running());
  }
  expect(most).toBeLessThan(10);
  await expect.poll(() => timeOf(page, ids.length + 3)).toBeGreaterThan(0.2);
  const stopped = await timeOf(page, 0);
  const late = await timeOf(page, ids.length + 3);
  await expect.poll(() => timeOf(page, ids.length + 3)).toBeGreaterThan(late + 0.5);
  expect(await timeOf(page, 0)).toBe(stopped);
  await page.evaluate(() => window.scrollTo(0, 0));
  await expect.poll(() => timeOf(page, 0)).toBeGreaterThan(stopped);
});

test('the list fits a phone', async ({ page }) => {
  await page.setViewportSize({ width: 360, height: 740 });
  await page.goto('./');
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(360);
});

test('light and dark follow the system until the reader chooses, and the choice is kept', async ({ page }) => {
  const ground = () => page.evaluate(() => getComputedStyle(document.documentElement).backgroundColor);
  await page.emulateMedia({ colorScheme: 'dark' });
  await openScene(page, 'projectiles');
  const dark = await ground();
  const fill = () => read(page, ({ stage }) => stage.style.groups?.[0].fill);
  const darkFill = await fill();
  await page.emulateMedia({ colorScheme: 'light' });
  await expect.poll(ground).not.toBe(dark);
  const light = await ground();
  await expect.poll(fill).not.toBe(darkFill);
  await page.getByRole('button', { name: 'Switch between light and dark' }).click();
  await expect.poll(ground).toBe(dark);
  await expect.poll(fill).toBe(darkFill);
  await page.reload();
  await expect.poll(ground).toBe(dark);
  await page.getByRole('button', { name: 'Switch between light and dark' }).click();
  await expect.poll(ground).toBe(light);
});

test('who asks for less motion gets none until they press play', async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await page.goto('./');
  await expect.poll(() => timeOf(page, 0)).toBeGreaterThan(1);
  expect(await page.evaluate(() => [...(window.stages?.values() ?? [])].some(({ playing }) => playing))).toBe(false);
  await openScene(page, 'projectiles');
  expect(await read(page, ({ stage }) => stage.playing)).toBe(false);
  await page.keyboard.press(' ');
  await expect.poll(() => read(page, ({ world }) => world.time)).toBeGreaterThan(0.1);
});

test('the files work from any sub-path', async ({ page }) => {
  await page.route('http://pages.test/**', (route) => {
    const { pathname } = new URL(route.request().url());
    if (!pathname.startsWith('/some/where/')) return route.fulfill({ status: 404 });
    const file = pathname.slice('/some/where/'.length);
    const dist = process.env['MASS_GALLERY'] ?? '';
    return route.fulfill({ path: join(dist, file === '' || file.endsWith('/') ? `${file}index.html` : file) });
  });
  await page.goto('http://pages.test/some/where/');
  await expect.poll(() => timeOf(page, 0)).toBeGreaterThan(0.1);
  await page.locator('.card a').first().click();
  await expect(page).toHaveURL(/some\/where\/scenes\//);
  await expect.poll(() => read(page, (mass) => mass?.world.time ?? 0)).toBeGreaterThan(0.1);
  await page.getByRole('radio', { name: 'PixiJS' }).click();
  await expect.poll(() => read(page, ({ renderer }) => renderer)).toBe('pixi');
});
