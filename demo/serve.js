/**
 * A small static server for the page: a free port of the loopback interface, a strict Content-Security-Policy, this project's files only.
 * Run as a program it prints the address; a test imports `serve` and closes the server itself.
 */

import { createHash } from 'node:crypto';
import { readFileSync, realpathSync } from 'node:fs';
import { readFile, realpath } from 'node:fs/promises';
import { createServer } from 'node:http';
import { extname, join, sep } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';

const ROOT = realpathSync(fileURLToPath(new URL('..', import.meta.url)));
const SERVED = ['demo', 'dist', 'web', join('node_modules', 'three')];
const TYPES = new Map([
  ['.html', 'text/html; charset=utf-8'],
  ['.css', 'text/css; charset=utf-8'],
  ['.js', 'text/javascript; charset=utf-8'],
  ['.json', 'application/json; charset=utf-8'],
  ['.map', 'application/json; charset=utf-8'],
  ['.svg', 'image/svg+xml'],
  ['.png', 'image/png'],
  ['.wasm', 'application/wasm'],
]);

/** The policy's name for the inline import map: without its hash no browser would follow the map. */
function importMapHash() {
  const page = readFileSync(join(ROOT, 'demo', 'index.html'), 'utf8');
  const map = /<script type="importmap">([\s\S]*?)<\/script>/.exec(page)?.[1] ?? '';
  return `'sha256-${createHash('sha256').update(map).digest('base64')}'`;
}

function policy() {
  return [
    "default-src 'none'",
    `script-src 'self' 'wasm-unsafe-eval' ${importMapHash()}`,
    "style-src 'self'",
    "img-src 'self'",
    "connect-src 'self'",
    "base-uri 'none'",
    "form-action 'none'",
    "frame-ancestors 'none'",
  ].join('; ');
}

/**
 * The file behind a request, or null: only existing files of the served folders, whatever dots, escapes or links the address holds.
 * @param {string} address path and query as the browser sent them
 * @returns {Promise<string | null>}
 */
async function findFile(address) {
  try {
    const path = decodeURIComponent(new URL(address, 'http://localhost').pathname);
    const file = await realpath(join(ROOT, path.endsWith('/') ? `${path}index.html` : path));
    const folders = await Promise.all(SERVED.map((folder) => realpath(join(ROOT, folder))));
    return folders.some((folder) => file.startsWith(folder + sep)) && TYPES.has(extname(file)) ? file : null;
  } catch {
    return null;
  }
}

/** @param {import('node:http').IncomingMessage} request @param {import('node:http').ServerResponse} response */
async function answer(request, response) {
  const address = request.url ?? '/';
  if (request.method !== 'GET' && request.method !== 'HEAD') return response.writeHead(405, { Allow: 'GET, HEAD' }).end();
  if (/^\/(?:\?.*)?$|^\/demo$/.test(address)) return response.writeHead(302, { Location: '/demo/' }).end();
  const file = await findFile(address);
  const content = file && (await readFile(file).catch(() => null));
  if (!file || !content) return response.writeHead(404, { 'Content-Type': 'text/plain; charset=utf-8' }).end('There is no such file.\n');
  response.writeHead(200, {
    'Content-Type': TYPES.get(extname(file)),
    'Content-Length': content.length,
    'Content-Security-Policy': policy(),
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
      resolve({ address: `http://127.0.0.1:${bound.port}/demo/`, close });
    });
  });
}

if (process.argv[1] && import.meta.url === pathToFileURL(realpathSync(process.argv[1])).href) {
  const { address } = await serve(Number(process.env.PORT ?? 0));
  console.log(`surfpath: the page is at ${address} (Ctrl+C ends it)`);
}
