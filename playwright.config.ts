import { defineConfig } from 'playwright/test';
import { browserArgs } from './scripts/browser.ts';

// The global setup builds the gallery, serves it and finds the browser; workers read both from the environment.
const { MASS_GALLERY_URL: baseURL, MASS_BROWSER: executablePath } = process.env;
// Each run has a folder of its own for what failed: the next one, or one at the same time, does not clear it away.
process.env.MASS_RUN ??= `${process.pid}`;

export default defineConfig({
  testDir: '.',
  testMatch: '**/*.e2e.ts',
  globalSetup: './scripts/playwright-setup.ts',
  outputDir: `./test-results/${process.env.MASS_RUN}`,
  preserveOutput: 'failures-only',
  fullyParallel: true,
  forbidOnly: Boolean(process.env.CI),
  retries: 0,
  // WebGL is drawn by the processor here: it is slow, and more workers than cores would starve each other.
  workers: 2,
  timeout: 240_000,
  expect: { timeout: 60_000 },
  reporter: [['list']],
  use: {
    ...(baseURL && { baseURL: `${baseURL}/` }),
    browserName: 'chromium',
    headless: true,
    viewport: { width: 1280, height: 800 },
    screenshot: 'only-on-failure',
    // What was done and said, without films of it: those slow down what passes. `--trace on` makes them.
    trace: { mode: 'retain-on-failure', screenshots: false, snapshots: false },
    launchOptions: { args: [...browserArgs], ...(executablePath && { executablePath }) },
  },
});
