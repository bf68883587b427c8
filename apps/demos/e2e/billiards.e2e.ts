import type { Page } from 'playwright/test';
import { expect, inWindow, openAtStart, read, renderers, test } from './gallery.ts';

/** Velocity of the cue ball, which is laid last. */
function cueBall(page: Page): Promise<{ vx: number; vy: number }> {
  return read(page, ({ world: { particles } }) => ({ vx: particles.vx[15], vy: particles.vy[15] }));
}

for (const renderer of renderers) {
  test(`a pull back from the cue ball shoots it the other way, on ${renderer}`, async ({ page }) => {
    await openAtStart(page, 'billiards', renderer === 'pixi' ? '?renderer=pixi' : '');
    const from = await inWindow(page, -0.5, 0);
    const to = await inWindow(page, -0.7, -0.15);
    await page.mouse.move(from.x, from.y);
    await page.mouse.down();
    await page.mouse.move((from.x + to.x) / 2, (from.y + to.y) / 2);
    await page.mouse.move(to.x, to.y);
    await page.mouse.up();
    // Half of the longest pull is half of the fastest shot.
    const { vx, vy } = await cueBall(page);
    expect(vx).toBeCloseTo(3.2, 1);
    expect(vy).toBeCloseTo(2.4, 1);
  });

  test(`the arrow keys aim and Enter shoots, on ${renderer}`, async ({ page }) => {
    await openAtStart(page, 'billiards', renderer === 'pixi' ? '?renderer=pixi' : '');
    const before = await cueBall(page);
    await page.keyboard.press('ArrowDown');
    await page.keyboard.press('ArrowDown');
    for (let n = 0; n < 5; n++) await page.keyboard.press('ArrowLeft');
    await page.keyboard.press('Enter');
    const after = await cueBall(page);
    expect(Math.hypot(before.vx, before.vy) - Math.hypot(after.vx, after.vy)).toBeCloseTo(1, 9);
    expect(Math.atan2(after.vy, after.vx) - Math.atan2(before.vy, before.vx)).toBeCloseTo(0.1, 9);
  });
}
