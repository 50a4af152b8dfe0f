/**
 * A page in any browser, without a driver: the page posts what it has to say to the server that it came from. For Chromium, Firefox and WebKitGTK
 * as Debian has them.
 */
import { spawn } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { createServer } from 'node:http';
import { tmpdir } from 'node:os';
import { extname, join, normalize } from 'node:path';
import { fileURLToPath } from 'node:url';
import { ARGUMENTS } from './page.js';

/** @typedef {{ command: string, arguments: (folder: string, address: string) => string[] }} Browser */

const ROOT = fileURLToPath(new URL('../..', import.meta.url));
const TYPES = /** @type {Record<string, string>} */ ({ '.html': 'text/html', '.js': 'text/javascript', '.wasm': 'application/wasm' });

/** Runs a command on a display of its own. @param {string} command @param {string[]} parameters */
const onDisplay = (command, parameters) => ['-a', command, ...parameters];

/** @type {Record<string, Browser>} */
export const BROWSERS = {
  chromium: {
    command: '/usr/bin/chromium',
    arguments: (folder, address) => ['--headless', `--user-data-dir=${folder}`, ...ARGUMENTS, address],
  },
  firefox: { command: 'firefox-esr', arguments: (folder, address) => ['--headless', '--no-remote', '--profile', folder, address] },
  webkit: { command: 'xvfb-run', arguments: (_, address) => onDisplay(miniBrowser(), [address]) },
};

function miniBrowser() {
  const folder = '/usr/lib';
  for (const machine of ['x86_64-linux-gnu', 'aarch64-linux-gnu']) {
    const path = `${folder}/${machine}/webkit2gtk-4.1/MiniBrowser`;
    try {
      readFileSync(path);
      return path;
    } catch {}
  }
  throw new Error('there is no MiniBrowser; install webkit2gtk-driver');
}

/**
 * Opens a page of the repository in a browser and waits for what it posts to /answer.
 * @param {keyof typeof BROWSERS} name @param {string} path of the page from the root of the repository @param {number} [milliseconds]
 * @returns {Promise<any>}
 */
export async function askPage(name, path, milliseconds = 600_000) {
  const folder = mkdtempSync(join(tmpdir(), 'surfpath-browser-'));
  const { address, answer, close } = await serveAndListen();
  const environment = { ...process.env, HOME: folder, WEBKIT_DISABLE_SANDBOX_THIS_IS_DANGEROUS: '1', LIBGL_ALWAYS_SOFTWARE: '1' };
  const browser = BROWSERS[name];
  // A group of its own, so that all that it starts ends with it.
  const child = spawn(browser.command, browser.arguments(folder, address + path), { detached: true, stdio: 'ignore', env: environment });
  /** @type {NodeJS.Timeout | undefined} */ let timer;
  try {
    return await Promise.race([
      answer,
      new Promise((_, reject) => {
        child.once('error', reject);
        child.once('exit', (code) => reject(new Error(`${name} ended with ${code}`)));
        timer = setTimeout(() => reject(new Error(`${name} did not answer in ${milliseconds / 1000} s`)), milliseconds);
      }),
    ]);
  } finally {
    clearTimeout(timer);
    child.removeAllListeners();
    await endGroup(child);
    close();
    rmSync(folder, { recursive: true, force: true, maxRetries: 5, retryDelay: 200 });
  }
}

/** @param {import('node:child_process').ChildProcess} child */
async function endGroup(child) {
  if (child.pid === undefined || child.exitCode !== null) return;
  const ended = new Promise((resolve) => child.once('exit', resolve));
  process.kill(-child.pid, 'SIGTERM');
  const hard = setTimeout(() => child.pid && process.kill(-child.pid, 'SIGKILL'), 5000);
  await ended;
  clearTimeout(hard);
}

/** Serves the repository on a free loopback port. */
async function serveAndListen() {
  /** @type {(answer: any) => void} */ let tell = () => {};
  const answer = new Promise((resolve) => {
    tell = resolve;
  });
  const server = createServer((request, response) => {
    if (request.method === 'POST') {
      /** @type {Buffer[]} */ const pieces = [];
      request.on('data', (piece) => pieces.push(piece));
      request.on('end', () => {
        response.end();
        tell(JSON.parse(String(Buffer.concat(pieces))));
      });
      return;
    }
    const path = normalize(new URL(request.url ?? '/', 'http://localhost').pathname);
    try {
      const body = readFileSync(join(ROOT, path));
      response.writeHead(200, { 'content-type': TYPES[extname(path)] ?? 'application/octet-stream' }).end(body);
    } catch {
      response.writeHead(404).end();
    }
  });
  await new Promise((resolve) => server.listen(0, '127.0.0.1', () => resolve(undefined)));
  const { port } = /** @type {import('node:net').AddressInfo} */ (server.address());
  const close = () => {
    server.closeAllConnections();
    server.close();
  };
  return { address: `http://127.0.0.1:${port}`, answer, close };
}
