import type { Page } from 'playwright/test';
import type { Point } from '../src/scenes/scene.ts';
import { expect, inWindow, openAtStart, pause, read, renderers, skipUntil, test } from './gallery.ts';

const fork = { x: 0, y: 2.7 };

/** A number under the picture, as the scene tells it. */
function reading(page: Page, label: string): Promise<number> {
  return page.evaluate(
    (name) => window.mass?.setup.readouts?.().find((each) => each.label === name)?.value ?? Number.NaN,
    label,
  );
}

/** Lets the paused game run until a number is reached. */
function becomes(page: Page, label: string, value: number): Promise<void> {
  return skipUntil(page, async () => (await reading(page, label)) === value);
}

/** Lets the paused game run until there is a ball to be thrown: it is the one that is pinned. */
function ballIsThere(page: Page): Promise<void> {
  return skipUntil(page, () =>
    read(page, ({ world: { particles } }) =>
      particles.group.slice(0, particles.count).some((group, i) => group === 1 && particles.inverseMass[i] === 0),
    ),
  );
}

/** Pulls the ball back by the mouse, and lets go. Unit: m. */
async function throwByMouse(page: Page, pull: Point): Promise<void> {
  await ballIsThere(page);
  const from = await inWindow(page, fork.x, fork.y);
  const to = await inWindow(page, fork.x + pull.x, fork.y + pull.y);
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(to.x, to.y, { steps: 5 });
  await page.mouse.up();
}

for (const renderer of renderers) {
  const query = (level: number) => `?level=${level}${renderer === 'pixi' ? '&renderer=pixi' : ''}`;

  test(`a throw by mouse wins a level, and the next one comes, on ${renderer}`, async ({ page }) => {
    await openAtStart(page, 'game', query(1));
    await throwByMouse(page, { x: -1.77, y: -1.2 });
    await becomes(page, 'Throws left', 2);
    await becomes(page, 'Targets left', 0);
    expect(await reading(page, 'Score')).toBe(400);
    await becomes(page, 'Level', 2);
    await becomes(page, 'Targets left', 6);
    await expect(page.locator('#statistics')).toContainText('Score 400');
  });

  test(`keys aim and throw, on ${renderer}`, async ({ page }) => {
    await openAtStart(page, 'game', query(2));
    const ball = () =>
      read(page, ({ world }) => {
        const slot = world.particles.group.indexOf(1);
        return { x: world.particleAt(slot).x, y: world.particleAt(slot).y };
      });
    expect(await ball()).toEqual(fork);
    await page.keyboard.press('ArrowUp');
    const first = await ball();
    expect(first.x).toBeLessThan(-1);
    await page.keyboard.press('ArrowUp');
    const stronger = await ball();
    expect(Math.hypot(stronger.x, stronger.y - fork.y)).toBeGreaterThan(Math.hypot(first.x, first.y - fork.y) * 1.04);
    await page.keyboard.press('ArrowLeft');
    expect((await ball()).y).toBeLessThan(stronger.y);
    await page.keyboard.press('ArrowRight');
    await page.keyboard.press('ArrowRight');
    expect((await ball()).y).toBeGreaterThan(stronger.y);
    await page.keyboard.press('ArrowUp');
    await page.keyboard.press('ArrowUp');
    await page.keyboard.press('Enter');
    await becomes(page, 'Throws left', 1);
    await skipUntil(page, async () => (await reading(page, 'Score')) >= 100);
    await page.keyboard.press('t');
    await becomes(page, 'Targets left', 6);
    expect(await reading(page, 'Score')).toBe(0);
    await page.keyboard.press('n');
    await becomes(page, 'Level', 3);
    await page.keyboard.press('r');
    await becomes(page, 'Level', 2);
  });

  test(`until somebody plays, it plays by itself, on ${renderer}`, async ({ page }) => {
    await openAtStart(page, 'game', query(4));
    await becomes(page, 'Targets left', 0);
    expect(await read(page, ({ stage }) => stage.failed)).toBe(false);
    await becomes(page, 'Level', 5);
    // The first touch begins the game, with nothing won yet and at the level that was chosen.
    const beside = await inWindow(page, 6, 8);
    await page.mouse.click(beside.x, beside.y);
    await becomes(page, 'Level', 4);
    expect(await reading(page, 'Score')).toBe(0);
  });
}

test('out of throws, a tap tries again', async ({ page }) => {
  await openAtStart(page, 'game', '?level=2');
  for (let left = 1; left >= 0; left--) {
    await throwByMouse(page, { x: -0.3, y: -1 });
    await becomes(page, 'Throws left', left);
  }
  const lost = () =>
    read(page, ({ setup }) => (setup.guides?.() ?? []).some((each) => 'text' in each && /^Out of/.test(each.text)));
  await skipUntil(page, lost);
  expect(await reading(page, 'Targets left')).toBe(6);
  const beside = await inWindow(page, 6, 8);
  await page.mouse.click(beside.x, beside.y);
  await becomes(page, 'Throws left', 2);
});

test('a pull of no length throws nothing, and the keys of a slider stay its own', async ({ page }) => {
  await openAtStart(page, 'game');
  await throwByMouse(page, { x: 0.05, y: 0 });
  expect(await reading(page, 'Throws left')).toBe(3);
  await page.getByRole('slider', { name: 'Begin with level' }).focus();
  await page.keyboard.press('ArrowRight');
  await becomes(page, 'Level', 2);
  expect(
    await read(page, ({ setup }) => setup.guides?.().some((guide) => guide.kind === 'circle' && guide.radius < 0.12)),
  ).toBe(false);
  await page.getByRole('button', { name: 'Play' }).focus();
  await page.keyboard.press('Enter');
  expect(await read(page, ({ stage }) => stage.playing)).toBe(true);
  expect(await reading(page, 'Throws left')).toBe(2);
  await pause(page);
});

test.describe('by touch', () => {
  test.use({ hasTouch: true, viewport: { width: 390, height: 844 } });

  test('a finger pulls the ball back and lets go, and the page does not scroll', async ({ page, context }) => {
    await openAtStart(page, 'game', '?level=2');
    const touch = await context.newCDPSession(page);
    const from = await inWindow(page, fork.x, fork.y);
    const to = await inWindow(page, fork.x - 1.92, fork.y - 0.94);
    await touch.send('Input.dispatchTouchEvent', { type: 'touchStart', touchPoints: [from] });
    await expect(page.locator('.pane')).toHaveClass(/grabbing/);
    for (let n = 1; n <= 8; n++) {
      const at = { x: from.x + ((to.x - from.x) * n) / 8, y: from.y + ((to.y - from.y) * n) / 8 };
      await touch.send('Input.dispatchTouchEvent', { type: 'touchMove', touchPoints: [at] });
    }
    await touch.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] });
    await becomes(page, 'Throws left', 1);
    await becomes(page, 'Targets left', 0);
    expect(await page.evaluate(() => window.scrollY)).toBe(0);
  });
});
