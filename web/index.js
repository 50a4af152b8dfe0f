/** surfpath: shortest paths on smooth curved surfaces. The default entry: the WebAssembly module is inlined, compressed. */

import text from '../dist/wasm.js';
import { makeCompile, makeLoad } from './instance.js';
import { unpack } from './runtime/unpack.js';

export { ExpressionError } from './expression/error.js';

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

/** @typedef {import('./instance.js').Surfpath} Surfpath */
/** @typedef {import('./instance.js').AnyDefinition} AnyDefinition */
/** @typedef {import('./surface.js').Surface} Surface */
/** @typedef {import('./definition.js').Expression} Expression */
/** @typedef {import('./definition.js').ParametricDefinition} ParametricDefinition */
/** @typedef {import('./definition.js').ImplicitDefinition} ImplicitDefinition */
/** @typedef {import('./definition.js').MetricDefinition} MetricDefinition */
/** @typedef {import('./shapes.js').GraphDefinition} GraphDefinition */
/** @typedef {import('./shapes.js').RevolutionDefinition} RevolutionDefinition */
/** @typedef {import('./shapes.js').TubeDefinition} TubeDefinition */
/** @typedef {import('./shapes.js').SweepDefinition} SweepDefinition */
/** @typedef {import('./path.js').Path} Path */
/** @typedef {import('./path.js').PathOptions} PathOptions */
/** @typedef {import('./path.js').PairOptions} PairOptions */
/** @typedef {import('./path.js').GeodesicsOptions} GeodesicsOptions */
/** @typedef {import('./path.js').Status} Status */
/** @typedef {import('./trace.js').TraceOptions} TraceOptions */
/** @typedef {import('./mesh.js').Mesh} Mesh */
/** @typedef {import('./field.js').FieldOptions} FieldOptions */
/** @typedef {import('./field.js').DistanceField} DistanceField */
