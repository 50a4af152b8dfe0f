/** The face of a pool: a surface's questions, asked of workers. Checks what can be checked without a solver; what a worker throws is thrown here again. */

import { allFields, checkOptions, describe, isNamed, refuse, refuseReceiver, wholeNumber } from '../arguments.js';
import { readPairNumbers, readPairOptions } from '../batch.js';
import { ASYNC_DISPOSE, DISPOSE } from '../dispose.js';
import { makePath } from '../path.js';
import { Crew } from './crew.js';
import { Job } from './job.js';
import { emptyPath } from './result.js';
import { NOT_FINITE } from './status.js';
import { countProcessors, startThread } from './thread.js';
import { unpackError, writeDefinition } from './wire.js';

/** @typedef {import('../path.js').Path} Path */
/** @typedef {import('../path.js').PathOptions} PathOptions */
/** @typedef {import('../path.js').PairOptions} PairOptions */
/** @typedef {import('../path.js').GeodesicsOptions} GeodesicsOptions */
/** @typedef {import('../mesh/field.js').FieldOptions} FieldOptions */
/** @typedef {import('../mesh/field.js').DistanceField} DistanceField */
/** @typedef {import('../instance.js').AnyDefinition} AnyDefinition */
/** @typedef {import('./worker.js').Question['method']} Method */

/**
 * @typedef {object} PoolSettings
 * @property {number} [workers] how many at most, 1 … 256; default: as many as the machine has processors
 * @property {URL | string} [worker] where worker.js is; default: beside pool.js
 */
/**
 * @typedef {object} Cancellable
 * @property {AbortSignal} [signal] aborting it rejects the call with its reason, and frees the workers within 50 ms
 */
/** @typedef {{ done: number, total: number }} Pairs so many of so many are solved */
/**
 * @typedef {object} Progress
 * @property {(progress: Pairs) => void} [onProgress] called after each chunk of pairs, never after the call is settled
 */

/** The entry that the pool belongs to. @typedef {Pick<typeof import('../index.js'), 'compileModule' | 'ExpressionError' | 'load'>} Entry */

const MOST_WORKERS = 256;

/** @param {PoolSettings | undefined} settings */
function readSettings(settings) {
  const caller = 'createPool';
  const { workers, worker } = checkOptions(caller, settings, ['workers', 'worker']);
  if (workers !== undefined) wholeNumber(caller, 'workers', workers, 1, MOST_WORKERS);
  return { workers, script: worker === undefined ? undefined : readScript(caller, worker) };
}

/** @param {string} caller @param {any} worker */
function readScript(caller, worker) {
  const text = typeof worker === 'string' ? worker : worker?.href;
  try {
    if (typeof text === 'string') return new URL(text, globalThis.location?.href);
  } catch {}
  const advice = text && !globalThis.location ? `; of a path make one with new URL(${describe(text)}, import.meta.url)` : '';
  throw new TypeError(`${caller}: options.worker must be the URL of worker.js, not ${describe(worker)}${advice}`);
}

/**
 * Takes what concerns the pool out of a call's options.
 * @param {string} caller @param {any} given @param {boolean} isBatch whether it has progress
 * @returns {{ signal?: AbortSignal, onProgress?: (progress: Pairs) => void, options: any }}
 */
function readCall(caller, given, isBatch) {
  if (!isNamed(given)) return { options: given };
  const { signal, ...others } = allFields(given);
  if (signal !== undefined && (typeof signal?.aborted !== 'boolean' || typeof signal.addEventListener !== 'function'))
    refuse(`${caller}: options.signal`, 'an AbortSignal', signal);
  if (!isBatch) return { signal, options: others };
  const { onProgress, ...options } = others;
  if (onProgress !== undefined && typeof onProgress !== 'function') refuse(`${caller}: options.onProgress`, 'a function', onProgress);
  return { signal, onProgress, options };
}

/** Throws what a surface has thrown; where that names the options it takes, with those that the pool takes besides. @param {string} own @returns {(error: unknown) => never} */
const naming = (own) => (error) => {
  if (error instanceof TypeError) error.message = error.message.replace(/; the options are .*$/, `$&, ${own}`);
  throw error;
};
const [ofOne, ofBatch] = [naming('signal'), naming('signal, onProgress')];

/** How to end the calls that share a signal: one listener for all, as Node.js takes more than ten on one signal for a leak, and says so. @extends {Set<() => void>} */
class Calls extends Set {
  handleEvent() {
    for (const abort of this) abort();
  }
}

/** Made by `createPool`. Every method answers as the surface's method of the same name does on the main thread, to the bit, and rejects with what that throws. */
export class Pool {
  /** What a console shows: bundling shortens the name of the class itself. */
  static name = 'WorkerPool';
  #entry;
  #crew;
  /** @type {WeakMap<AbortSignal, Calls>} */ #calls = new WeakMap();
  #disposed = false;

  /** @param {Entry} entry @param {PoolSettings} [settings] */
  constructor(entry, settings) {
    const { workers, script } = readSettings(settings);
    this.#entry = entry;
    this.#crew = new Crew({
      prepare: async () => ({ module: await entry.compileModule(), most: workers ?? countProcessors() }),
      start: (listener) => startThread(script, listener),
    });
  }

  /**
   * The lengths of the shortest paths of many pairs of points.
   * @param {AnyDefinition} definition as for `surfpath.surface`
   * @param {ArrayLike<number>} pairs u v u v, or x y z x y z; copied at once
   * @param {PairOptions & Cancellable & Progress} [options]
   * @returns {Promise<Float64Array>} in the order of the pairs; NaN for a pair without a path, and for one that two workers died of
   */
  async lengths(definition, pairs, options) {
    const method = Pool.#enter(this, 'lengths', definition);
    const make = (/** @type {number} */ total) => new Float64Array(total);
    return this.#solvePairs(method, { definition, pairs, options }, make, Number.NaN).catch(ofBatch);
  }

  /**
   * The shortest paths of many pairs of points.
   * @param {AnyDefinition} definition @param {ArrayLike<number>} pairs @param {PairOptions & Cancellable & Progress} [options]
   * @returns {Promise<Path[]>} in the order of the pairs; status `worker-died`: two workers ended while they solved this pair
   */
  async shortestPaths(definition, pairs, options) {
    const method = Pool.#enter(this, 'shortestPaths', definition);
    const make = (/** @type {number} */ total) => new Array(total);
    const lost = { ...makePath(emptyPath(NOT_FINITE)), status: 'worker-died' };
    return this.#solvePairs(method, { definition, pairs, options }, make, lost).catch(ofBatch);
  }

  /**
   * The shortest path between two points.
   * @param {AnyDefinition} definition @param {ArrayLike<number>} from @param {ArrayLike<number>} to @param {PathOptions & Cancellable} [options]
   * @returns {Promise<Path>}
   */
  async shortestPath(definition, from, to, options) {
    const method = Pool.#enter(this, 'shortestPath', definition);
    return this.#ask(method, definition, [from, to], options).catch(ofOne);
  }

  /**
   * All locally shortest paths between two points that a graph search finds.
   * @param {AnyDefinition} definition @param {ArrayLike<number>} from @param {ArrayLike<number>} to
   * @param {GeodesicsOptions & Cancellable} [options]
   * @returns {Promise<Path[]>}
   */
  async geodesics(definition, from, to, options) {
    const method = Pool.#enter(this, 'geodesics', definition);
    return this.#ask(method, definition, [from, to], options).catch(ofOne);
  }

  /**
   * How far all of a surface is from a point.
   * @param {AnyDefinition} definition @param {ArrayLike<number>} from @param {FieldOptions & Cancellable} [options]
   * @returns {Promise<DistanceField>}
   */
  async distanceField(definition, from, options) {
    const method = Pool.#enter(this, 'distanceField', definition);
    return this.#ask(method, definition, [from], options).catch(ofOne);
  }

  /** Ends all workers, and rejects what is under way. Using the pool afterwards throws. @returns {Promise<void>} when the workers have ended */
  async dispose() {
    Pool.#check(this, 'dispose');
    this.#disposed = true;
    await this.#crew.dispose(new Error('surfpath: this pool was disposed'));
  }

  /** As {@link dispose}, not waited for: for `using`. */
  [DISPOSE]() {
    this.dispose();
  }

  /** As {@link dispose}: for `await using`. */
  [ASYNC_DISPOSE]() {
    return this.dispose();
  }

  /**
   * @template {Float64Array | Path[]} Results
   * @param {'lengths' | 'shortestPaths'} method
   * @param {{ definition: AnyDefinition, pairs: ArrayLike<number>, options: any }} call
   * @param {(total: number) => Results} make @param {any} lost result of a pair that two workers died of
   * @returns {Promise<Results>}
   */
  async #solvePairs(method, { definition, pairs, options: given }, make, lost) {
    const { signal, onProgress, options } = readCall(method, given, true);
    readPairOptions(method, options);
    const variables = definition?.kind === 'implicit' ? ['x', 'y', 'z'] : ['u', 'v'];
    const all = readIfRight(method, pairs, variables);
    const width = 2 * variables.length;
    if (!all?.length) return this.#ask(method, definition, [pairs], options && { ...options, signal });
    const results = make(all.length / width);
    return this.#run({ method, definition, args: [all, options], signal }, (text, [numbers, wanted]) => ({
      total: results.length,
      isBatch: true,
      ask: (first, count) => ({ definition: text, method, args: [numbers.slice(width * first, width * (first + count)), wanted] }),
      store: (first, values) => {
        for (let i = 0; i < values.length; i++) results[first + i] = values[i];
      },
      lose: (pair) => {
        results[pair] = lost;
      },
      result: () => results,
      onProgress,
    }));
  }

  /** One question that is not cut into pieces. @param {Method} method @param {AnyDefinition} definition @param {unknown[]} places @param {any} given options */
  async #ask(method, definition, places, given) {
    const { signal, options } = readCall(method, given, false);
    /** @type {any} */ let value;
    return this.#run({ method, definition, args: [...places, options], signal }, (text, args) => ({
      total: 1,
      isBatch: false,
      ask: () => ({ definition: text, method, args }),
      store: (_, found) => {
        value = found;
      },
      lose: () => {
        throw new Error(`${method}: two workers ended while they computed this`);
      },
      result: () => value,
      onProgress: undefined,
    }));
  }

  /**
   * Has a call answered by the workers. What cannot be posted to them is answered here: as a rule by the exception that it deserves.
   * @param {{ method: Method, definition: AnyDefinition, args: any[], signal: AbortSignal | undefined }} call
   * @param {(text: string, args: any[]) => Omit<import('./job.js').Task, 'unpack'>} plan with the definition and the arguments as they are now
   */
  async #run({ method, definition, args, signal }, plan) {
    if (signal?.aborted) throw signal.reason;
    const now = freeze(definition, args);
    if (!now) return this.#answerHere(method, definition, args);
    const unpack = (/** @type {import('./wire.js').PackedError} */ error) => unpackError(error, this.#entry.ExpressionError);
    const job = new Job({ ...plan(now.text, now.args), unpack });
    const abort = () => {
      job.reject(signal?.reason);
      this.#crew.drop(job);
    };
    const forget = signal && this.#listen(signal, abort);
    this.#crew.add(job);
    try {
      return await job.promise;
    } finally {
      forget?.();
    }
  }

  /** @param {AbortSignal} signal @param {() => void} abort @returns {() => void} listens no more */
  #listen(signal, abort) {
    const calls = this.#calls.get(signal) ?? new Calls();
    if (calls.size === 0) {
      this.#calls.set(signal, calls);
      signal.addEventListener('abort', calls);
    }
    calls.add(abort);
    return () => {
      calls.delete(abort);
      if (calls.size === 0) signal.removeEventListener('abort', calls);
    };
  }

  /** @param {Method} method @param {AnyDefinition} definition @param {any[]} args */
  async #answerHere(method, definition, args) {
    const surfpath = await this.#entry.load();
    try {
      const surface = surfpath.surface(definition);
      /* What it ignores cannot be posted either: better refused than computed here, where the page waits for it. */
      writeDefinition(definition);
      return /** @type {any} */ (surface)[method](...args);
    } finally {
      surfpath.dispose();
    }
  }

  /** Throws where a method has lost its pool. @param {Pool} pool @param {string} method */
  static #check(pool, method) {
    if (!(#crew in Object(pool))) refuseReceiver(method, 'a pool', 'pool');
  }

  /**
   * Throws where a method has lost its pool, the pool is gone, or it is asked about something that a worker cannot make.
   * @template {Method} M @param {Pool} pool @param {M} method @param {any} definition @returns {M}
   */
  static #enter(pool, method, definition) {
    Pool.#check(pool, method);
    if (pool.#disposed) throw new Error(`${method}: this pool was disposed`);
    if (typeof definition?.shortestPath === 'function')
      throw new TypeError(`${method}: workers make their surfaces themselves: pass the definition, not a Surface`);
    return method;
  }
}

/** Copies, which the caller does not change any more; null: they cannot be copied. @param {AnyDefinition} definition @param {any[]} args */
function freeze(definition, args) {
  for (const see of [(/** @type {any[]} */ given) => given, plain])
    try {
      return { text: writeDefinition(definition), args: structuredClone(see(args)) };
    } catch {}
  return null;
}

/** Pairs; null: wrong ones, or those of a definition that has a mistake itself, which a worker tells. @param {Method} method @param {ArrayLike<number>} pairs @param {string[]} variables */
function readIfRight(method, pairs, variables) {
  try {
    return readPairNumbers(method, pairs, variables);
  } catch {
    return null;
  }
}

/** What is behind the Proxies by which frameworks watch arrays and objects: these cannot be cloned. @param {any} value @returns {any} */
function plain(value) {
  if (Array.isArray(value)) return value.map(plain);
  return isNamed(value) ? Object.fromEntries(Object.entries(value).map(([name, one]) => [name, plain(one)])) : value;
}
