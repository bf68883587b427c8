import { expect, test } from './gallery.ts';

test('the benchmarks are found from the list, fit a phone, and show each engine beside Mass', async ({ page }) => {
  await page.setViewportSize({ width: 360, height: 740 });
  await page.goto('./');
  await page.getByRole('link', { name: 'Benchmarks' }).click();
  await expect(page.getByRole('heading', { level: 1 })).toHaveText('Beside other engines');
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(360);
  const pile = page.getByRole('region', { name: 'Pile of discs in a box' });
  await expect(pile.getByRole('rowheader', { name: 'mass', exact: true }).first()).toBeVisible();
  await expect(pile.getByRole('rowheader', { name: 'box2d3-wasm', exact: true }).first()).toBeVisible();
  await expect(page.locator('.chart .line.own').first()).toBeVisible();
  await expect(page.locator('.settings li')).not.toHaveCount(0);
});

test('the benchmarks are switched between light and dark', async ({ page }) => {
  await page.goto('benchmarks/');
  const colour = () => page.evaluate(() => getComputedStyle(document.documentElement).backgroundColor);
  const before = await colour();
  await page.locator('#theme').click();
  await expect.poll(colour).not.toBe(before);
});
