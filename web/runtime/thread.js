/** Threads: a module worker in a page, a worker thread in Node.js, with the same few verbs. Knows nothing of what they compute. */

/**
 * @typedef {object} Thread
 * @property {(message: unknown) => void} post messages arrive in this order
 * @property {() => Promise<unknown>} end at once, whatever it is doing; its listener hears nothing of it
 * @property {(wanted: boolean) => void} hold whether it keeps Node.js from exiting
 */

/**
 * @typedef {object} Listener
 * @property {(message: any) => void} message
 * @property {(error: Error | null) => void} death it ended by itself; null: without a word
 */

/**
 * Modules of Node.js, which Deno and Bun have too; null in pages, which have workers (jsdom and happy-dom, whose tests run in Node.js, do not). Not by `import`, behind which every bundler for pages would look.
 * @type {((name: string) => any) | null}
 */
const getModule = typeof document === 'undefined' || typeof Worker === 'undefined' ? (globalThis.process?.getBuiltinModule ?? null) : null;

/** How many threads can run at the same time. */
export function countProcessors() {
  return globalThis.navigator?.hardwareConcurrency || getModule?.('node:os').availableParallelism() || 1;
}

/**
 * Starts a thread.
 * @param {URL | undefined} script default: worker.js beside this file
 * @param {Listener} listener
 * @returns {Thread}
 */
export function startThread(script, listener) {
  const place = script ?? findScript();
  return getModule ? startNodeThread(getModule('node:worker_threads').Worker, place, listener) : startPageWorker(place, listener);
}

function findScript() {
  try {
    // Bundlers find the file by exactly this expression, and copy it as it is: within `new Worker(…)` they would bundle it again, once for each kind of worker.
    return new URL('./worker.js', import.meta.url);
  } catch {
    throw new TypeError('createPool: no import.meta.url here; pass { worker }');
  }
}

/** @param {URL} script @param {Listener} listener @returns {Thread} */
function startPageWorker(script, { message, death }) {
  const worker = new Worker(script, { type: 'module' });
  const fail = (/** @type {string} */ text) => {
    worker.terminate();
    death(new Error(text));
  };
  worker.onmessage = ({ data }) => message(data);
  worker.onmessageerror = () => fail('its message cannot be read');
  worker.onerror = (event) => {
    event.preventDefault();
    fail(event.message || `the script ${script} cannot be loaded`);
  };
  return { post: (given) => worker.postMessage(given), end: async () => worker.terminate(), hold() {} };
}

/** @param {any} Worker of Node.js @param {URL} script @param {Listener} listener @returns {Thread} */
function startNodeThread(Worker, script, { message, death }) {
  /* Without the flags of this process, some of which no thread takes. */
  const worker = new Worker(script, { execArgv: [] });
  const exit = () => death(null);
  worker.on('message', message);
  worker.on('error', death);
  worker.on('exit', exit);
  const end = () => {
    worker.off('message', message);
    worker.off('exit', exit);
    return worker.terminate();
  };
  return {
    post: (/** @type {unknown} */ given) => worker.postMessage(given),
    end,
    hold: (/** @type {boolean} */ wanted) => (wanted ? worker.ref() : worker.unref()),
  };
}
