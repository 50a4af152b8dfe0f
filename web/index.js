/** surfpath: shortest paths on smooth curved surfaces. The default entry: the WebAssembly module is inlined, compressed. */

import text from '../dist/wasm.js';
import { makeCompile, makeLoad } from './instance.js';
import { unpack } from './runtime/unpack.js';

export { ExpressionError } from './expression/error.js';
export * from './types.js';

const compile = makeCompile(() => unpack(text));

/**
 * The solver's module, compiled: it can be posted to a worker, and loaded there by `load({ wasm: module })`. Cached.
 * @type {(options?: import('./instance.js').LoadOptions) => Promise<WebAssembly.Module>}
 */
export const compileModule = (options) => compile('compileModule', options);
/**
 * Loads the solver. Each call gives a new, independent instance; the compiled module is cached. Rejects, in words, without WebAssembly SIMD.
 * @type {(options?: import('./instance.js').LoadOptions) => Promise<import('./instance.js').Surfpath>}
 */
export const load = makeLoad(compile);
