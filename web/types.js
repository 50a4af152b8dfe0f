/** The types that both entries hand on. */

/** @typedef {import('./instance.js').Surfpath} Surfpath */
/** @typedef {import('./instance.js').LoadOptions} LoadOptions */
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
/** @typedef {import('./runtime/result.js').Iterate} Iterate */
/** @typedef {import('./trace.js').TraceOptions} TraceOptions */
/** @typedef {import('./mesh.js').Mesh} Mesh */
/** @typedef {import('./field.js').FieldOptions} FieldOptions */
/** @typedef {import('./field.js').DistanceField} DistanceField */

export {};
