// The reader's hand: two fingers, drags that are the scene's own, worlds side by side, what throws.
import type { Page } from 'playwright/test';
import type { MassOnPage } from '../src/gallery/mass.ts';
import type { Point } from '../src/scenes/scene.ts';
import { expect, inWindow, openAtStart, openScene, read, test } from './gallery.ts';

/** Fingers on the page, as the browser's own input. */
async function fingersOn(page: Page): Promise<(type: 'Start' | 'Move' | 'End', at: readonly Point[]) => Promise<void>> {
  const session = await page.context().newCDPSession(page);
  return async (type, at) => {
    const touchPoints = at.map(({ x, y }, id) => ({ x, y, id }));
    await session.send('Input.dispatchTouchEvent', { type: `touch${type}`, touchPoints });
  };
}

test.describe('two fingers', () => {
  test.use({ hasTouch: true, viewport: { width: 390, height: 740 } });

  test('zoom the scene about the point between them, and the view can be fitted again', async ({ page }) => {
    await openAtStart(page, 'force-generators');
    const touch = await fingersOn(page);
    const scale = () => read(page, ({ camera }) => camera.pixelsPerMetre);
    const before = await scale();
    const middle = await inWindow(page, 4, 8);
    const apart = (by: number): Point[] => [
      { x: middle.x - by, y: middle.y },
      { x: middle.x + by, y: middle.y },
    ];
    await touch('Start', apart(20));
    for (const by of [25, 30, 35, 40]) await touch('Move', apart(by));
    await touch('End', []);
    await expect.poll(async () => (await scale()) / before).toBeCloseTo(2, 1);
    const now = await inWindow(page, 4, 8);
    expect(Math.hypot(now.x - middle.x, now.y - middle.y)).toBeLessThan(2);
    expect(await page.evaluate(() => [window.scrollY, window.visualViewport?.scale])).toEqual([0, 1]);

    await touch('Start', apart(40));
    for (const by of [35, 30, 25, 20]) await touch('Move', apart(by));
    await touch('End', []);
    await expect.poll(async () => (await scale()) / before).toBeCloseTo(1, 1);
    await page.getByRole('button', { name: 'Fit the view' }).click();
    expect(await scale()).toBe(before);
  });

  test('let go of what one of them held', async ({ page }) => {
    await openAtStart(page, 'force-generators');
    const touch = await fingersOn(page);
    const ball = await inWindow(page, 0, 19);
    const forces = () => read(page, ({ world }) => world.forces.length);
    const before = await forces();
    await touch('Start', [ball]);
    await expect.poll(forces).toBe(before + 1);
    await touch('Start', [ball, { x: ball.x, y: ball.y + 80 }]);
    await expect.poll(forces).toBe(before);
    await touch('End', []);
  });
});

test("a drag where nothing is to be taken is the scene's own: down, move, up, in metres", async ({ page }) => {
  await openAtStart(page, 'force-generators');
  await page.evaluate(() => {
    const seen: [string, number, number][] = [];
    const note = (what: string) => (at: { x: number; y: number }) => {
      seen.push([what, at.x, at.y]);
      return true;
    };
    Object.assign((window.mass as MassOnPage).setup, {
      pointer: { down: note('down'), move: note('move'), up: note('up') },
      seen,
    });
  });
  const from = await inWindow(page, -20, 5);
  const to = await inWindow(page, -10, 9);
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(to.x, to.y, { steps: 3 });
  await page.mouse.up();
  const seen = await read(page, ({ setup }) => (setup as unknown as { seen: [string, number, number][] }).seen);
  expect(seen.map(([what]) => what)).toEqual(['down', 'move', 'move', 'move', 'up']);
  const metre = await read(page, ({ camera }) => camera.pixelsPerMetre);
  for (const [[, x, y], goal] of [
    [seen[0], { x: -20, y: 5 }],
    [seen[4], { x: -10, y: 9 }],
  ] as const) {
    expect(Math.hypot(x - goal.x, y - goal.y) * metre, 'px').toBeLessThan(1.5);
  }
});

test('worlds side by side: each has its heading, its pane and its hand, and one camera moves both', async ({
  page,
}) => {
  await openAtStart(page, 'interpenetration');
  const labels = await read(page, ({ setup }) => [setup.label, ...(setup.beside ?? []).map(({ label }) => label)]);
  expect(labels.length).toBeGreaterThan(1);
  await expect(page.locator('.pane-label')).toHaveText(labels as string[]);
  const right = await page.evaluate(() => {
    const { camera, element, world } = (window.mass as MassOnPage).stage.panes[1];
    const { left, top } = element.getBoundingClientRect();
    const slot = world.particles.inverseMass.findIndex((inverse) => inverse > 0);
    const { x, y } = world.particleAt(slot);
    return { x: left + camera.toScreenX(x), y: top + camera.toScreenY(y) };
  });
  const forces = () => read(page, ({ stage }) => stage.panes.map(({ world }) => world.forces.length));
  const before = await forces();
  await page.mouse.move(right.x, right.y);
  await page.mouse.down();
  expect(await forces()).toEqual([before[0], before[1] + 1]);
  await page.mouse.up();
  expect(await forces()).toEqual(before);

  const scales = () => read(page, ({ stage }) => stage.panes.map(({ camera }) => camera.pixelsPerMetre));
  const [scale] = await scales();
  await page.keyboard.down('Control');
  await page.mouse.wheel(0, -120);
  await page.keyboard.up('Control');
  await expect.poll(async () => (await scales())[0]).toBeGreaterThan(scale);
  const [first, second] = await scales();
  expect(second).toBe(first);
});

/** What throws, in a scene that was fine, and what brings it about. */
const faults: readonly [what: string, spoil: (mass: MassOnPage) => void, trigger: (page: Page) => Promise<void>][] = [
  [
    'its guides',
    ({ setup }) => {
      Object.assign(setup, {
        guides: () => {
          throw new Error('broken on purpose');
        },
      });
    },
    (page) => page.keyboard.press('.'),
  ],
  [
    'a key of its own',
    ({ setup }) => {
      for (const action of setup.actions ?? []) {
        Object.assign(action, {
          run: () => {
            throw new Error('broken on purpose');
          },
        });
      }
    },
    (page) => page.locator('[data-key]').first().click(),
  ],
  [
    'a drag of its own',
    ({ setup }) => {
      Object.assign(setup, {
        pointer: {
          down: () => {
            throw new Error('broken on purpose');
          },
        },
      });
    },
    async (page) => {
      const { x, y } = await inWindow(page, -20, 5);
      await page.mouse.click(x, y);
    },
  ],
];

for (const [what, spoil, trigger] of faults) {
  test(`a scene of which ${what} throws says so, and a reset mends it`, async ({ page }) => {
    await openScene(page, 'force-generators');
    await read(page, spoil);
    await trigger(page);
    const fault = page.getByRole('alert');
    await expect(fault).toContainText('broken on purpose');
    expect(await read(page, ({ stage }) => stage.playing)).toBe(false);
    await page.getByRole('button', { name: 'Reset' }).click();
    await expect(fault).toBeHidden();
    await expect.poll(() => read(page, ({ world }) => world.stepCount)).toBeGreaterThan(3);
  });
}

test('a scene whose build throws at some value says so, and goes on at another', async ({ page }) => {
  await openScene(page, 'force-generators');
  await read(page, ({ scene }) => {
    const build = scene.build;
    Object.assign(scene, {
      build: (...[values, seed]: Parameters<typeof build>) => {
        if (values['mass'] > 1) throw new Error('too heavy');
        return build(values, seed);
      },
    });
  });
  const mass = page.getByRole('slider', { name: 'Mass' });
  await mass.focus();
  await page.keyboard.press('ArrowRight');
  const fault = page.getByRole('alert');
  await expect(fault).toContainText('too heavy');
  await page.keyboard.press('ArrowLeft');
  await expect(fault).toBeHidden();
  await expect.poll(() => read(page, ({ stage }) => stage.playing)).toBe(true);
});
