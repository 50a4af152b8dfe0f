/** Pages made by a test, served beside the built library and both releases of three.js: a free port of the loopback interface, a strict policy. */

import { createHash } from 'node:crypto';
import { readFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import { extname, join, normalize } from 'node:path';
import { fileURLToPath } from 'node:url';

const ROOT = fileURLToPath(new URL('../..', import.meta.url));
const FILES = /^\/(dist|web|node_modules\/three|node_modules\/three-previous)\/[\w/.-]+$/;
const TYPES = new Map([
  ['.js', 'text/javascript; charset=utf-8'],
  ['.wasm', 'application/wasm'],
]);

/** The policy for a page: no inline styles, of inline scripts those that the page holds. @param {string} html */
function policy(html) {
  const scripts = [...html.matchAll(/<script(?![^>]*\bsrc=)[^>]*>(.*?)<\/script>/gs)];
  const hashes = scripts.map(([, script]) => `'sha256-${createHash('sha256').update(script).digest('base64')}'`);
  const sources = ["'self'", "'wasm-unsafe-eval'", ...hashes].join(' ');
  return `default-src 'none'; script-src ${sources}; style-src 'self'; img-src 'self'; connect-src 'self'; worker-src 'self'; base-uri 'none'; form-action 'none'`;
}

/**
 * @param {Record<string, string>} pages HTML by name: 'one' is at /one
 * @returns {Promise<{ address: string, close: () => Promise<void> }>} address: without a slash at its end
 */
export function serveSite(pages) {
  const server = createServer(async ({ url = '/' }, response) => {
    const path = normalize(new URL(url, 'http://localhost').pathname);
    const page = Object.hasOwn(pages, path.slice(1)) ? pages[path.slice(1)] : null;
    const file = page === null && FILES.test(path) ? await readFile(join(ROOT, path)).catch(() => null) : null;
    const type = page === null ? TYPES.get(extname(path)) : 'text/html; charset=utf-8';
    if (path === '/favicon.ico') response.writeHead(204).end();
    else if (page === null && !file) response.writeHead(404).end();
    else
      response
        .writeHead(200, { 'Content-Type': type ?? 'text/plain', ...(page === null ? {} : { 'Content-Security-Policy': policy(page) }) })
        .end(page ?? file);
  });
  return new Promise((resolve, reject) => {
    server.once('error', reject);
    server.listen(0, '127.0.0.1', () => {
      const { port } = /** @type {import('node:net').AddressInfo} */ (server.address());
      const close = () =>
        new Promise((/** @type {(value: void) => void} */ closed) => {
          server.close(() => closed());
          server.closeAllConnections();
        });
      resolve({ address: `http://127.0.0.1:${port}`, close });
    });
  });
}
