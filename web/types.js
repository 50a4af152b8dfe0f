/** The types that both entries hand on. */

/** @typedef {import('./instance.js').Surfpath} Surfpath */
/** @typedef {import('./instance.js').LoadOptions} LoadOptions */
/** @typedef {import('./instance.js').AnyDefinition} AnyDefinition */
/** @typedef {import('./surface.js').Surface} Surface */
/** @typedef {import('./definition.js').Expression} Expression */
/** @typedef {import('./definition.js').ParametricDefinition} ParametricDefinition */
/** @typedef {import('./definition.js').ImplicitDefinition} ImplicitDefinition */
/** @typedef {import('./definition.js').MetricDefinition} MetricDefinition */
/** @typedef {import('./manifold/shapes.js').GraphDefinition} GraphDefinition */
/** @typedef {import('./manifold/shapes.js').RevolutionDefinition} RevolutionDefinition */
/** @typedef {import('./manifold/shapes.js').TubeDefinition} TubeDefinition */
/** @typedef {import('./manifold/shapes.js').SweepDefinition} SweepDefinition */
/** @typedef {import('./path.js').Path} Path */
/** @typedef {import('./path.js').PathOptions} PathOptions */
/** @typedef {import('./path.js').PairOptions} PairOptions */
/** @typedef {import('./path.js').GeodesicsOptions} GeodesicsOptions */
/** @typedef {import('./path.js').Status} Status */
/** @typedef {import('./runtime/result.js').Iterate} Iterate */
/** @typedef {import('./trace.js').TraceOptions} TraceOptions */
/** @typedef {import('./mesh/mesh.js').Mesh} Mesh */
/** @typedef {import('./mesh/field.js').FieldOptions} FieldOptions */
/** @typedef {import('./mesh/field.js').DistanceField} DistanceField */

export {};
