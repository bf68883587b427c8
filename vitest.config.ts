import { defineConfig } from 'vitest/config';

/** Two projects: `unit` is the laws and the scenes; `repository` packs, installs and bundles what is published, and takes its time. */
export default defineConfig({
  test: {
    allowOnly: !process.env.CI,
    projects: [
      {
        test: {
          name: 'unit',
          include: ['{packages,apps}/*/test/**/*.test.ts'],
          testTimeout: 120_000, // nothing is timed: a busy machine must not make a scene fail
        },
      },
      {
        test: {
          name: 'repository',
          include: ['tests/**/*.test.ts'],
          testTimeout: 300_000,
          hookTimeout: 300_000,
        },
      },
    ],
  },
});
