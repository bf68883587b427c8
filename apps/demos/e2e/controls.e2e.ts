import { expect, openAtStart, openScene, pause, read, test } from './gallery.ts';

test('space pauses and plays, a full stop steps, r resets', async ({ page }) => {
  await openScene(page, 'force-generators');
  expect(await read(page, ({ stage }) => stage.playing)).toBe(true);
  await pause(page);
  const steps = await read(page, ({ world }) => world.stepCount);
  await page.keyboard.press('.');
  await page.keyboard.press('.');
  expect(await read(page, ({ world }) => world.stepCount)).toBe(steps + 2);
  await page.keyboard.press('r');
  expect(await read(page, ({ world }) => world.stepCount)).toBe(0);
  await page.keyboard.press(' ');
  await expect.poll(() => read(page, ({ world }) => world.stepCount)).toBeGreaterThan(3);
});

test('buttons do the same', async ({ page }) => {
  await openScene(page, 'force-generators');
  await page.getByRole('button', { name: 'Pause' }).click();
  const steps = await read(page, ({ world }) => world.stepCount);
  await page.getByRole('button', { name: 'Step' }).click();
  expect(await read(page, ({ world }) => world.stepCount)).toBe(steps + 1);
  await page.getByRole('button', { name: 'Reset' }).click();
  expect(await read(page, ({ world }) => world.stepCount)).toBe(0);
  await page.getByRole('button', { name: 'Play' }).click();
  await expect.poll(() => read(page, ({ world }) => world.stepCount)).toBeGreaterThan(3);
});

test('the speed is the share of real time that passes', async ({ page }) => {
  await openScene(page, 'projectiles');
  await page.getByRole('radio', { name: '0.25×' }).click();
  expect(await read(page, ({ stage }) => stage.speed)).toBe(0.25);
  await page.getByRole('radio', { name: '2×' }).click();
  expect(await read(page, ({ stage }) => stage.speed)).toBe(2);
});

test('a slider changes the scene and the address, and the address the scene', async ({ page }) => {
  await openScene(page, 'force-generators', '?mass=2');
  expect(await read(page, ({ values }) => values['mass'])).toBe(2);
  const gravity = page.getByRole('slider', { name: 'Gravity' });
  await gravity.focus();
  for (let n = 0; n < 3; n++) await page.keyboard.press('ArrowRight');
  await expect.poll(() => read(page, ({ values }) => values['gravity'].toFixed(2))).toBe('9.84');
  expect(await read(page, ({ world }) => world.gravity.y.toFixed(2))).toBe('-9.84');
  await expect(page).toHaveURL(/gravity=9\.84/);
  await expect(page).toHaveURL(/mass=2/);
  await page.reload();
  await openScene(page, 'force-generators', new URL(page.url()).search);
  expect(await read(page, ({ world }) => world.gravity.y.toFixed(2))).toBe('-9.84');
});

test('a live slider does not start the scene anew', async ({ page }) => {
  await openScene(page, 'projectiles');
  await expect.poll(() => read(page, ({ world }) => world.stepCount)).toBeGreaterThan(5);
  await page.getByRole('slider', { name: 'Muzzle speed' }).focus();
  await page.keyboard.press('ArrowLeft');
  await expect.poll(() => read(page, ({ values }) => values['speed'].toFixed(2))).toBe('0.95');
  expect(await read(page, ({ world }) => world.stepCount)).toBeGreaterThan(5);
  await expect(page).toHaveURL(/speed=0\.95/);
});

test('the renderer is changed while the scene runs, and kept in the address', async ({ page }) => {
  await openScene(page, 'projectiles');
  expect(new URL(page.url()).search).toBe('');
  await page.getByRole('radio', { name: 'PixiJS' }).click();
  await expect.poll(() => read(page, ({ renderer }) => renderer)).toBe('pixi');
  await expect(page).toHaveURL(/\?renderer=pixi$/);
  const time = await read(page, ({ world }) => world.time);
  await expect.poll(() => read(page, ({ world }) => world.time)).toBeGreaterThan(time);
  await page.getByRole('radio', { name: 'Canvas 2D' }).click();
  await expect.poll(() => read(page, ({ renderer }) => renderer)).toBe('canvas2d');
  await expect(page).toHaveURL(/\/projectiles\/$/);
});

test('PixiJS is loaded only when it is chosen', async ({ page }) => {
  const scripts: string[] = [];
  const weight = (): number => scripts.reduce((sum, script) => sum + script.length, 0);
  page.on('response', async (response) => {
    if (response.url().endsWith('.js')) scripts.push(await response.text());
  });
  // A name that PixiJS gives its objects: it stands in the minified code, too.
  const pixi = (): number => scripts.filter((script) => script.includes('"ParticleContainer"')).length;
  await openScene(page, 'projectiles');
  expect(scripts.length).toBeGreaterThan(1);
  expect(pixi()).toBe(0);
  // No PixiJS, no scene but its own, no part of the engine that the scene does not use.
  expect(weight()).toBeLessThan(250_000);
  await page.getByRole('radio', { name: 'PixiJS' }).click();
  await expect.poll(() => read(page, ({ renderer }) => renderer)).toBe('pixi');
  expect(pixi()).toBeGreaterThan(0);
});

test('everything can be done without a mouse', async ({ page }) => {
  await openScene(page, 'projectiles');
  const reached = new Set<string>();
  let changed = false;
  for (let n = 0; n < 40 && !changed; n++) {
    await page.keyboard.press('Tab');
    const focus = await page.evaluate(() => {
      let element = document.activeElement;
      while (element?.shadowRoot?.activeElement) element = element.shadowRoot.activeElement;
      const host = document.activeElement;
      const outlined = (each: Element | null): boolean =>
        each !== null && getComputedStyle(each).outlineStyle !== 'none';
      const rings = [element, host, element?.querySelector('[part~="thumb"]') ?? null];
      return {
        name: host?.getAttribute('aria-label') ?? (host?.closest('label') ?? host)?.textContent?.trim() ?? '',
        tag: host instanceof HTMLInputElement ? host.type : (host?.localName ?? ''),
        ring: rings.some(outlined),
      };
    });
    reached.add(`${focus.tag} ${focus.name}`);
    if (focus.tag === 'button' && focus.name === 'Pause') {
      await page.keyboard.press('Enter');
      expect(await read(page, ({ stage }) => stage.playing)).toBe(false);
      expect(focus.ring).toBe(true);
    }
    if (focus.tag === 'radio' && focus.name === 'Canvas 2D') {
      expect(focus.ring).toBe(true);
      await page.keyboard.press('ArrowRight');
      changed = true;
    }
  }
  await expect.poll(() => read(page, ({ renderer }) => renderer)).toBe('pixi');
  for (const tag of ['a', 'button', 'wa-slider', 'radio']) {
    expect(
      [...reached].some((each) => each.startsWith(`${tag} `)),
      tag,
    ).toBe(true);
  }
});

test('a key does not fire while somebody types', async ({ page }) => {
  await openAtStart(page, 'projectiles');
  await page.getByLabel('Seed').click();
  await page.keyboard.type('1');
  expect(await read(page, ({ world }) => world.particleCount)).toBe(0);
});

test('a frame that took long is not caught up with', async ({ page }) => {
  await openScene(page, 'force-generators');
  await expect.poll(() => read(page, ({ world }) => world.stepCount)).toBeGreaterThan(0);
  const ahead = await page.evaluate(async () => {
    const { world } = window.mass as NonNullable<typeof window.mass>;
    const before = world.time;
    const started = performance.now();
    while (performance.now() - started < 3000);
    await new Promise(requestAnimationFrame);
    return world.time - before;
  });
  expect(ahead).toBeLessThan(0.5);
});

test('an error in a step is shown, stops the scene, and a reset mends it', async ({ page }) => {
  await openScene(page, 'force-generators');
  await read(page, ({ world }) => {
    world.addForce({
      apply() {
        throw new Error('a hole in space');
      },
    });
  });
  const fault = page.getByRole('alert');
  await expect(fault).toContainText('a hole in space');
  expect(await read(page, ({ stage }) => stage.playing)).toBe(false);
  await page.keyboard.press('r');
  await expect(fault).toBeHidden();
  await expect.poll(() => read(page, ({ world }) => world.stepCount)).toBeGreaterThan(0);
});
