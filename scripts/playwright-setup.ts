import { findBrowser } from './browser.ts';
import { buildGallery } from './build.ts';
import { serve } from './serve.ts';

/** Builds the gallery, serves it on a free port, and finds the browser. Returns what ends the server after the last test. */
export default async function setup(): Promise<() => Promise<void>> {
  process.env.MASS_BROWSER = await findBrowser();
  const { url, close } = await serve(await buildGallery());
  process.env.MASS_GALLERY_URL = url;
  console.log(`Testing the gallery at ${url} in ${process.env.MASS_BROWSER}`);
  return close;
}
