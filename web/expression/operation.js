/* The operations of the graph, one instruction of WebAssembly or one function of the solver each. */

/** What a node does. From `call` on: the elementary function of number `operation - Operation.call`. Comparison masks are all-ones bit patterns. */
export const Operation = Object.freeze({
  constant: 0, // left: index into `values`
  variable: 1, // left: index of the variable
  parameter: 2, // left: index of the parameter
  add: 3,
  subtract: 4,
  multiply: 5,
  divide: 6,
  negate: 7,
  absolute: 8,
  squareRoot: 9,
  floor: 10,
  minimum: 11, // NaN if either is, and -0 < +0, as f64x2.min and Math.min
  maximum: 12,
  less: 13, // mask: left < right
  and: 14, // bitwise
  andNot: 15, // left & ~right
  or: 16,
  call: 17,
});
