/** surfpath with its WebAssembly module as a file of its own, beside this one. */

import { makeLoad } from './instance.js';

export { ExpressionError } from './expression/error.js';
export const load = makeLoad(() => new URL('./surfpath.wasm', import.meta.url));

/** @typedef {import('./instance.js').Surfpath} Surfpath */
/** @typedef {import('./surface.js').Surface} Surface */
/** @typedef {import('./path.js').Path} Path */
/** @typedef {import('./path.js').PathOptions} PathOptions */
