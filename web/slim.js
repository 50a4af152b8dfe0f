/** surfpath with its WebAssembly module as a file of its own, beside this one. */

import { makeCompile, makeLoad } from './instance.js';

export { ExpressionError } from './expression/error.js';
export const compileModule = makeCompile(() => new URL('./surfpath.wasm', import.meta.url));
export const load = makeLoad(compileModule);

/** @typedef {import('./instance.js').Surfpath} Surfpath */
/** @typedef {import('./surface.js').Surface} Surface */
/** @typedef {import('./path.js').Path} Path */
/** @typedef {import('./path.js').PathOptions} PathOptions */
