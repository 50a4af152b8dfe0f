/** surfpath/pool: paths computed in workers, many at once, off the page's own thread. The entry: joins the pool to the default entry's solver. */

import { compileModule, ExpressionError, load } from './index.js';
import { Pool } from './runtime/pool.js';

/** @typedef {Pool} WorkerPool */
/** @typedef {import('./runtime/pool.js').PoolSettings} PoolSettings */
/** @typedef {import('./runtime/pool.js').Cancellable} Cancellable */
/** @typedef {import('./runtime/pool.js').Progress} Progress */
/** @typedef {import('./instance.js').AnyDefinition} AnyDefinition */
/** @typedef {import('./path.js').Path} Path */
/** @typedef {import('./path.js').PathOptions} PathOptions */
/** @typedef {import('./path.js').PairOptions} PairOptions */
/** @typedef {import('./path.js').GeodesicsOptions} GeodesicsOptions */
/** @typedef {import('./mesh/field.js').DistanceField} DistanceField */

/**
 * Makes a pool of workers. They start when they are first needed, and stay until `dispose`; idle ones do not keep Node.js from exiting.
 * @param {PoolSettings} [settings]
 * @returns {Pool}
 */
export function createPool(settings) {
  return new Pool({ compileModule, ExpressionError, load }, settings);
}
