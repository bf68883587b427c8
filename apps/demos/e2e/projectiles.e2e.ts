import { colourDistance, coloursAt, expect, openAtStart, pause, read, renderers, runTo, test } from './gallery.ts';

/** The thesis's table at 20 pixels a metre, y up: apart from the scene's own, so that neither can be wrong unseen. */
const table = [
  { v: [17.5, 0], a: [0, -0.5], damping: 0.99 },
  { v: [20, 15], a: [0, -10], damping: 0.99 },
  { v: [12.5, 0], a: [0, 1.5], damping: 0.9 },
  { v: [50, 0], a: [0, 0], damping: 0.99 },
];

/** One coordinate of projectile motion with damping: v' = a + λ·v, λ = ln d. */
function travelled(v: number, a: number, damping: number, t: number): number {
  const lambda = Math.log(damping);
  return ((v + a / lambda) * (Math.exp(lambda * t) - 1)) / lambda - (a * t) / lambda;
}

interface Sighting {
  time: number;
  kind: number;
  x: number;
  y: number;
}

for (const renderer of renderers) {
  test(`keys 1 to 4 fire four arcs that keep to their closed form, on ${renderer}`, async ({ page }) => {
    await openAtStart(page, 'projectiles', renderer === 'pixi' ? '?renderer=pixi' : '');
    for (const key of ['1', '2', '3', '4']) await page.keyboard.press(key);
    expect(await read(page, (mass) => mass.world.particleCount)).toBe(4);

    // A witness in the page notes where everything is at each frame.
    const sightings = await page.evaluateHandle(() => {
      const seen: Sighting[] = [];
      const look = (): void => {
        const { world } = window.mass as NonNullable<typeof window.mass>;
        const { count, alive, x, y, group } = world.particles;
        for (let i = 0; i < count; i++) {
          if (alive[i] === 1) seen.push({ time: world.time, kind: group[i], x: x[i], y: y[i] });
        }
        requestAnimationFrame(look);
      };
      look();
      return seen;
    });
    await page.keyboard.press(' ');
    await runTo(page, 3.5);
    const seen = await sightings.jsonValue();

    for (const [kind, { v, a, damping }] of table.entries()) {
      const flight = seen.filter((sighting) => sighting.kind === kind && sighting.time < 3.9);
      expect(new Set(flight.map(({ time }) => time)).size, `sightings of kind ${kind}`).toBeGreaterThan(5);
      let flown = 0;
      let last = flight[0];
      expect(Math.hypot(last.x, last.y), 'all leave one point').toBe(0);
      for (const sighting of flight) {
        flown += Math.hypot(sighting.x - last.x, sighting.y - last.y);
        last = sighting;
        const x = travelled(v[0], a[0], damping, sighting.time);
        const y = travelled(v[1], a[1], damping, sighting.time);
        const error = Math.hypot(sighting.x - x, sighting.y - y);
        expect(error, `kind ${kind} at ${sighting.time} s`).toBeLessThanOrEqual(0.01 * flown);
      }
    }
    const heights = [0, 1, 2, 3].map((kind) => seen.filter((each) => each.kind === kind).map(({ y }) => y));
    expect(Math.min(...heights[0])).toBeLessThan(-2);
    expect(Math.max(...heights[1])).toBeGreaterThan(10);
    expect(Math.max(...heights[2])).toBeGreaterThan(7);
    expect(heights[3].every((y) => y === 0)).toBe(true);
  });

  test(`what flies is seen where it is, on ${renderer}`, async ({ page }) => {
    await openAtStart(page, 'projectiles', renderer === 'pixi' ? '?renderer=pixi' : '');
    for (const key of ['1', '2', '3']) await page.keyboard.press(key);
    await page.keyboard.press(' ');
    await runTo(page, 1);
    await pause(page);
    await page.keyboard.press('.');
    const discs = await read(page, ({ world, camera, stage }) =>
      [0, 1, 2].map((slot) => {
        const { x, y, radius, group } = world.particleAt(slot);
        const size = Math.max(4, radius * camera.pixelsPerMetre);
        return {
          x: camera.toScreenX(x),
          y: camera.toScreenY(y) - size * 0.6,
          fill: stage.style.groups?.[group].fill ?? '',
        };
      }),
    );
    await expect(async () => {
      const colours = await coloursAt(page, page.locator('.pane'), discs);
      for (const [n, colour] of colours.entries())
        expect(colourDistance(colour, discs[n].fill), colour).toBeLessThan(24);
    }).toPass();
  });
}

test('buttons fire as keys do, and the readings follow', async ({ page }) => {
  await openAtStart(page, 'projectiles');
  for (const name of ['Pistol', 'Artillery', 'Fireball', 'Laser']) await page.getByRole('button', { name }).click();
  const groups = await read(page, ({ world }) => [...world.particles.group.slice(0, world.particles.count)]);
  expect(groups).toEqual([0, 1, 2, 3]);
  await expect(page.locator('#statistics')).toContainText('Particles 4');
});
