/** One page in Firefox and in WebKitGTK, each by the protocol that it speaks: WebDriver BiDi, and plain WebDriver. Both need a screen: one in memory. */

import { spawn } from 'node:child_process';
import { mkdtemp, rm } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

// Without types of its own.
const { WebSocket } = createRequire(import.meta.url)('ws');

/**
 * @typedef {object} Engine
 * @property {string} name
 * @property {(url: string) => Promise<void>} open
 * @property {(script: string) => Promise<any>} evaluate an expression, or an await of one; its value comes as JSON
 * @property {(path: [number, number][]) => Promise<void>} drag by mouse, along places of the window
 * @property {() => Promise<void>} close
 */

const PATIENCE = 60_000;

/** Starts a program in a process group of its own, and gives what a line of its output matches. @param {string[]} command @param {RegExp} pattern @param {Record<string, string>} [environment] */
async function start([program, ...options], pattern, environment = {}) {
  const child = spawn(program, options, { env: { ...process.env, ...environment }, detached: true });
  const end = () => {
    try {
      process.kill(-(/** @type {number} */ (child.pid)), 'SIGKILL');
    } catch {
      // It has ended by itself.
    }
  };
  process.once('exit', end);
  const found = await new Promise((resolve, reject) => {
    let output = '';
    const timer = setTimeout(() => reject(new Error(`${program} says nothing in time: ${output}`)), PATIENCE);
    const read = (/** @type {Buffer} */ data) => {
      output += data;
      const match = pattern.exec(output);
      if (!match) return;
      clearTimeout(timer);
      resolve(match[1]);
    };
    child.stdout.on('data', read);
    child.stderr.on('data', read);
    child.on('error', reject);
  }).catch((error) => {
    end();
    throw error;
  });
  return { found: /** @type {string} */ (found), end };
}

/** A screen in memory. @returns {Promise<{ display: string, end: () => void }>} */
async function startScreen() {
  // It writes the number that it chose to the file descriptor named.
  const { found, end } = await start(['Xvfb', '-displayfd', '1', '-screen', '0', '1280x900x24', '-nolisten', 'tcp'], /^(\d+)\n/m);
  return { display: `:${found}`, end };
}

/** A drag as the actions of a mouse, the same in both protocols. @param {[number, number][]} path */
function mouseActions([[x, y], ...path]) {
  const move = (/** @type {[number, number]} */ [toX, toY]) => ({
    type: 'pointerMove',
    x: Math.round(toX),
    y: Math.round(toY),
    duration: 30,
  });
  const actions = [move([x, y]), { type: 'pointerDown', button: 0 }, ...path.map(move), { type: 'pointerUp', button: 0 }];
  return [{ type: 'pointer', id: 'mouse', parameters: { pointerType: 'mouse' }, actions }];
}

/** @returns {Promise<Engine>} */
export async function openFirefox() {
  const screen = await startScreen();
  const profile = await mkdtemp(join(tmpdir(), 'surfpath-firefox-'));
  const { found, end } = await start(
    ['firefox-esr', '--no-remote', '--profile', profile, '--width', '1280', '--height', '900', '--remote-debugging-port', '0'],
    /WebDriver BiDi listening on (ws:\/\/\S+)/,
    { DISPLAY: screen.display, MOZ_WEBRENDER: '0' },
  );
  const socket = new WebSocket(`${found}/session`, { perMessageDeflate: false });
  await new Promise((resolve, reject) => socket.on('open', resolve).on('error', reject));
  const ask = asker(socket);
  await ask('session.new', { capabilities: {} });
  const { contexts } = await ask('browsingContext.getTree', {});
  const { context } = contexts[0];
  return {
    name: 'Firefox',
    open: (url) => ask('browsingContext.navigate', { context, url, wait: 'complete' }),
    async evaluate(script) {
      const expression = `(async () => JSON.stringify(await (${script})) ?? 'null')()`;
      const { result, exceptionDetails } = await ask('script.evaluate', { expression, target: { context }, awaitPromise: true });
      if (exceptionDetails) throw new Error(exceptionDetails.text);
      return JSON.parse(result.value);
    },
    drag: (path) => ask('input.performActions', { context, actions: mouseActions(path) }),
    async close() {
      socket.close();
      end();
      screen.end();
      await rm(profile, { recursive: true, force: true, maxRetries: 5, retryDelay: 200 });
    },
  };
}

/** Commands over a socket, answered by their number. @param {any} socket a WebSocket */
function asker(socket) {
  let last = 0;
  /** @type {Map<number, { resolve: (value: any) => void, reject: (reason: Error) => void }>} */
  const waiting = new Map();
  socket.on('message', (/** @type {unknown} */ data) => {
    const { id, type, result, message } = JSON.parse(String(data));
    const asked = waiting.get(id);
    waiting.delete(id);
    if (type === 'error') asked?.reject(new Error(message));
    else asked?.resolve(result);
  });
  return (/** @type {string} */ method, /** @type {object} */ params) => {
    const id = ++last;
    socket.send(JSON.stringify({ id, method, params }));
    return /** @type {Promise<any>} */ (new Promise((resolve, reject) => waiting.set(id, { resolve, reject })));
  };
}

/** @returns {Promise<Engine>} */
export async function openWebKit() {
  const screen = await startScreen();
  const port = 20_000 + (process.pid % 20_000);
  const { end } = await start(['sh', '-c', `WebKitWebDriver --port=${port} & sleep 1; echo started; wait`], /(started)/, {
    DISPLAY: screen.display,
    WEBKIT_DISABLE_SANDBOX_THIS_IS_DANGEROUS: '1',
    LIBGL_ALWAYS_SOFTWARE: '1',
  });
  const ask = async (/** @type {string} */ method, /** @type {string} */ path, /** @type {object} */ body = {}) => {
    const options = method === 'POST' ? { body: JSON.stringify(body) } : {};
    const response = await fetch(`http://127.0.0.1:${port}${path}`, { method, ...options });
    const { value } = /** @type {any} */ (await response.json());
    if (value?.error) throw new Error(`${value.error}: ${value.message}`);
    return value;
  };
  const binary = '/usr/lib/x86_64-linux-gnu/webkit2gtk-4.1/MiniBrowser';
  const capabilities = { alwaysMatch: { 'webkitgtk:browserOptions': { binary, args: ['--automation'] } } };
  const { sessionId } = await ask('POST', '/session', { capabilities });
  const session = `/session/${sessionId}`;
  await ask('POST', `${session}/timeouts`, { script: PATIENCE, pageLoad: PATIENCE });
  await ask('POST', `${session}/window/rect`, { width: 1280, height: 900 }).catch(() => {});
  return {
    name: 'WebKit',
    open: (url) => ask('POST', `${session}/url`, { url }),
    async evaluate(script) {
      const call = `const done = arguments[0]; (async () => (${script}))().then((value) => done(JSON.stringify({ value })), (error) => done(JSON.stringify({ error: String(error) })))`;
      const { value, error } = JSON.parse(await ask('POST', `${session}/execute/async`, { script: call, args: [] }));
      if (error) throw new Error(error);
      return value;
    },
    drag: (path) => ask('POST', `${session}/actions`, { actions: mouseActions(path) }),
    async close() {
      await ask('DELETE', session).catch(() => {});
      end();
      screen.end();
    },
  };
}
