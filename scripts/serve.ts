import { createServer } from 'node:http';
import type { AddressInfo } from 'node:net';
import getPort from 'get-port';
import sirv from 'sirv';

/** A running server: its address, with no slash at the end, and how to end it. */
export interface Serving {
  readonly url: string;
  readonly port: number;
  close(): Promise<void>;
}

/** Serves a folder of static files on this machine alone. Takes any free port when the wanted one is in use, or when it is 0. */
export async function serve(directory: string, wantedPort = 0): Promise<Serving> {
  const port = await getPort(wantedPort > 0 ? { port: wantedPort } : {});
  // `dev` reads the folder at each request, so that a rebuild shows at once and nothing stale is cached.
  const handle = sirv(directory, { dev: true, etag: true });
  const server = createServer((request, response) => {
    handle(request, response, () => {
      response.statusCode = 404;
      response.end(`Not found: ${request.url}\n`);
    });
  });
  await new Promise<void>((resolve, reject) => {
    server.once('error', reject);
    server.listen(port, '127.0.0.1', resolve);
  });
  const actual = (server.address() as AddressInfo).port;
  return {
    url: `http://localhost:${actual}`,
    port: actual,
    close: () =>
      new Promise((resolve, reject) => {
        server.close((error) => (error ? reject(error) : resolve()));
        server.closeAllConnections();
      }),
  };
}
