import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { findBrowser } from './browser.ts';
import { buildGallery } from './build.ts';
import { serve } from './serve.ts';

/**
 * Builds the gallery into a folder of this run's own, so that runs at the same time do not meet, serves it on a free port,
 * and finds the browser. Returns what ends the server and removes the folder after the last test.
 */
export default async function setup(): Promise<() => Promise<void>> {
  process.env.MASS_BROWSER = await findBrowser();
  const folder = mkdtempSync(join(tmpdir(), 'mass-gallery-'));
  process.env.MASS_GALLERY = await buildGallery(join(folder, 'gallery'));
  const { url, close } = await serve(process.env.MASS_GALLERY);
  process.env.MASS_GALLERY_URL = url;
  console.log(`Testing the gallery at ${url} in ${process.env.MASS_BROWSER}`);
  return async () => {
    await close();
    rmSync(folder, { recursive: true, force: true });
  };
}
