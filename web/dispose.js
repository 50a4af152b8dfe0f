/// <reference lib="esnext.disposable" preserve="true" />
/** The names under which `using` and `await using` let go of things; an engine that does not know them gets symbols that nobody asks for. */

/** @type {typeof Symbol.dispose} */
export const DISPOSE = Symbol.dispose ?? /** @type {any} */ (Symbol());

/** @type {typeof Symbol.asyncDispose} */
export const ASYNC_DISPOSE = Symbol.asyncDispose ?? /** @type {any} */ (Symbol());
