/* The operations of the graph, one instruction of WebAssembly or one function of the solver each: constants, which the bundler writes as numbers. */

export const constant = 0; // left: index into `values`
export const variable = 1; // left: index of the variable
export const parameter = 2; // left: index of the parameter
export const add = 3;
export const subtract = 4;
export const multiply = 5;
export const divide = 6;
export const negate = 7;
export const absolute = 8;
export const squareRoot = 9;
export const floor = 10;
export const minimum = 11; // NaN if either is, and -0 < +0, as f64x2.min and Math.min
export const maximum = 12;
export const less = 13; // mask, all ones or all zeros: left < right
export const and = 14; // bitwise
export const andNot = 15; // left & ~right
export const or = 16;
export const call = 17; // from here on: the elementary function of number `operation - call`
