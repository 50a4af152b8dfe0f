/**
 * A small static server for the page as `make site` builds it: a free port of the loopback interface, a strict Content-Security-Policy, that folder's files
 * only. Run as a program it prints the address; a test imports `serve` and closes the server itself.
 */

import { realpathSync } from 'node:fs';
import { readFile, realpath } from 'node:fs/promises';
import { createServer } from 'node:http';
import { extname, join, sep } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';

const SITE = fileURLToPath(new URL('../build/site', import.meta.url));
/** A sub-path, as on a server with many pages: nothing of the page may be named from the root. */
const BASE = '/surfpath/';
const TYPES = new Map([
  ['.html', 'text/html; charset=utf-8'],
  ['.css', 'text/css; charset=utf-8'],
  ['.js', 'text/javascript; charset=utf-8'],
  ['.svg', 'image/svg+xml'],
  ['.webp', 'image/webp'],
]);

/** What the page needs, and nothing else. */
export const POLICY = [
  "default-src 'none'",
  "script-src 'self' 'wasm-unsafe-eval'",
  "style-src 'self'",
  "img-src 'self' blob:",
  "connect-src 'self'",
  "worker-src 'self'",
].join('; ');

/**
 * The file behind a request, or null: only existing files of the site, whatever dots, escapes or links the address holds.
 * @param {string} address path and query as the browser sent them
 * @returns {Promise<string | null>}
 */
async function findFile(address) {
  try {
    const path = decodeURIComponent(new URL(address, 'http://localhost').pathname);
    if (!path.startsWith(BASE)) return null;
    const root = await realpath(SITE);
    const file = await realpath(join(root, path.slice(BASE.length) || 'index.html'));
    return file.startsWith(root + sep) && TYPES.has(extname(file)) ? file : null;
  } catch {
    return null;
  }
}

/** @param {import('node:http').IncomingMessage} request @param {import('node:http').ServerResponse} response */
async function answer(request, response) {
  const address = request.url ?? '/';
  if (request.method !== 'GET' && request.method !== 'HEAD') return response.writeHead(405, { Allow: 'GET, HEAD' }).end();
  if (/^\/(?:\?.*)?$|^\/surfpath$/.test(address)) return response.writeHead(302, { Location: BASE }).end();
  const file = await findFile(address);
  const content = file && (await readFile(file).catch(() => null));
  if (!file || !content) return response.writeHead(404, { 'Content-Type': 'text/plain; charset=utf-8' }).end('There is no such file.\n');
  response.writeHead(200, {
    'Content-Type': TYPES.get(extname(file)),
    'Content-Length': content.length,
    'Content-Security-Policy': POLICY,
    'Cross-Origin-Opener-Policy': 'same-origin',
    'Cross-Origin-Embedder-Policy': 'require-corp',
    'X-Content-Type-Options': 'nosniff',
    'Cache-Control': 'no-cache',
  });
  return response.end(request.method === 'HEAD' ? undefined : content);
}

/**
 * Starts the server.
 * @param {number} [port] default: any free one
 * @returns {Promise<{ address: string, close: () => Promise<void> }>}
 */
export function serve(port = 0) {
  const server = createServer(answer);
  return new Promise((resolve, reject) => {
    server.once('error', reject);
    server.listen(port, '127.0.0.1', () => {
      const bound = /** @type {import('node:net').AddressInfo} */ (server.address());
      const close = () =>
        new Promise((/** @type {(value: void) => void} */ closed) => {
          server.close(() => closed());
          server.closeAllConnections();
        });
      resolve({ address: `http://127.0.0.1:${bound.port}${BASE}`, close });
    });
  });
}

if (process.argv[1] && import.meta.url === pathToFileURL(realpathSync(process.argv[1])).href) {
  const { address } = await serve(Number(process.env.PORT ?? 0));
  console.log(`surfpath: the page is at ${address} (Ctrl+C ends it)`);
}
