/** Pages of consumers in headless Chromium: served from the loopback interface under a strict policy, and asking nobody else for anything. */

import { readFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import { extname, join } from 'node:path';
import { openBrowser, openPage } from '../helpers/page.js';

const TYPES = new Map([
  ['.html', 'text/html; charset=utf-8'],
  ['.js', 'text/javascript; charset=utf-8'],
  ['.wasm', 'application/wasm'],
]);
const POLICY = "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; worker-src 'self'; connect-src 'self'; base-uri 'none'";

/**
 * Serves the files of a folder on a free port.
 * @param {string} folder
 * @param {string} policy Content-Security-Policy
 */
async function serveFolder(folder, policy) {
  const server = createServer(async (request, response) => {
    const path = new URL(request.url ?? '/', 'http://localhost').pathname;
    if (path === '/favicon.ico') return response.writeHead(204).end();
    const file = join(folder, path.endsWith('/') ? `${path}index.html` : path);
    const content = await readFile(file).catch(() => null);
    if (content === null) return response.writeHead(404).end();
    const type = TYPES.get(extname(file)) ?? 'application/octet-stream';
    response.writeHead(200, { 'Content-Type': type, 'Content-Security-Policy': policy, 'X-Content-Type-Options': 'nosniff' }).end(content);
  });
  await new Promise((resolve) => server.listen(0, '127.0.0.1', () => resolve(null)));
  const { port } = /** @type {import('node:net').AddressInfo} */ (server.address());
  const close = () => {
    server.close();
    server.closeAllConnections();
  };
  return { address: `http://127.0.0.1:${port}/`, close };
}

/** Opens the browser. `visit` gives what a page shows in its <output>, and throws if the page complained or asked another server. */
export async function openPages() {
  const browser = await openBrowser();

  /** @param {string} address @returns {Promise<string>} */
  async function visit(address) {
    /** @type {string[]} */
    const foreign = [];
    const listen = (/** @type {import('playwright-core').Request} */ request) => {
      if (new URL(request.url()).host !== new URL(address).host) foreign.push(request.url());
    };
    browser.context.on('request', listen);
    const { page, complaints } = await openPage(browser.context, address);
    const done = await page.waitForSelector('output[data-done]', { state: 'attached', timeout: 30_000 }).catch(() => null);
    const shown = done ? await page.textContent('output') : 'nothing within 30 s';
    await page.close();
    browser.context.off('request', listen);
    if (complaints.length > 0 || foreign.length > 0 || !done) throw new Error([shown, ...complaints, ...foreign].join('\n'));
    return String(shown);
  }

  /** @param {string} folder @param {string} [policy] */
  async function visitFolder(folder, policy = POLICY) {
    const server = await serveFolder(folder, policy);
    try {
      return await visit(server.address);
    } finally {
      server.close();
    }
  }

  return { visit, visitFolder, close: browser.close };
}
