/** surfpath with its WebAssembly module as a file of its own, beside this one. */

import { makeCompile, makeLoad } from './instance.js';

export { ExpressionError } from './expression/error.js';
export * from './types.js';

const compile = makeCompile(() => {
  try {
    return new URL('./surfpath.wasm', import.meta.url);
  } catch {
    throw new TypeError('surfpath/slim: no import.meta.url here; pass { wasm }');
  }
});

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
