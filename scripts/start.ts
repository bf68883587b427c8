// Builds the packages and the gallery, serves the gallery, and prints its address.
import { buildAll } from './build.ts';
import { serve } from './serve.ts';

const usualPort = 4173;
const directory = await buildAll();
const { url, port } = await serve(directory, usualPort);

if (port !== usualPort) console.log(`Port ${usualPort} is in use: serving on port ${port} instead.`);
console.log(`\n  Mass gallery:  ${url}/\n\n  Press Ctrl+C to stop.`);
