/** What runs in a worker of a pool: one instance of the solver, the surfaces that it was last asked about, one question at a time. */

import { Surfpath } from '../instance.js';
import { packError, readDefinition } from './wire.js';

/** Surfaces that are kept: each may hold graphs of some tens of megabytes. */
const KEPT = 4;

/**
 * @typedef {object} Question a method of a surface, and its arguments
 * @property {string} definition as written by writeDefinition
 * @property {'lengths' | 'shortestPaths' | 'shortestPath' | 'geodesics' | 'distanceField'} method
 * @property {any[]} args
 */
/** @typedef {{ value?: any, error?: import('./wire.js').PackedError, milliseconds: number }} Answer */

/** @type {Surfpath} */ let surfpath;
/** @type {Map<string, import('../surface.js').Surface>} by definition, the longest unused first */
const surfaces = new Map();

/** @param {string} definition */
function findSurface(definition) {
  const surface = surfaces.get(definition) ?? surfpath.surface(readDefinition(definition));
  surfaces.delete(definition);
  surfaces.set(definition, surface);
  for (const [oldest, unused] of surfaces) {
    if (surfaces.size <= KEPT) break;
    unused.dispose();
    surfaces.delete(oldest);
  }
  return surface;
}

/** @param {Question} question @returns {Answer} */
function answer({ definition, method, args }) {
  const start = performance.now();
  try {
    const surface = /** @type {any} */ (findSurface(definition));
    return { value: surface[method](...args), milliseconds: performance.now() - start };
  } catch (error) {
    return { error: packError(error), milliseconds: performance.now() - start };
  }
}

/** The first message brings the compiled solver; every other one is a question. @param {{ module: WebAssembly.Module } | Question} message */
function hear(message) {
  if (!('module' in message)) return answer(message);
  surfpath = new Surfpath(message.module);
  return { ready: true };
}

/* Not by `import`, which would have to be awaited: in a page the listener must be there when this script has run. */
const threads = globalThis.process?.getBuiltinModule?.('node:worker_threads');
const port = threads?.parentPort ?? /** @type {any} */ (globalThis);
port.addEventListener('message', (/** @type {{ data: any }} */ { data }) => port.postMessage(hear(data)));
port.start?.();
