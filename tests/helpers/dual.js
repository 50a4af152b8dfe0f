/* Second-order dual numbers: an independent check of the differentiated graph. Evaluates a parsed expression number by number with Math.*,
 * carrying the gradient and the Hessian along; each function's derivatives are the textbook's, not those of functions.js. */

/** @typedef {{ value: number, gradient: number[], hessian: number[][] }} Dual */
/** @typedef {import('../../web/expression/postfix.js').Instruction} Instruction */

/** f, f', f'' of functions of one argument. @type {Record<string, (x: number) => [number, number, number]>} */
const FUNCTIONS = {
  abs: (x) => [Math.abs(x), Math.sign(x), 0],
  sign: (x) => [Math.sign(x), 0, 0],
  floor: (x) => [Math.floor(x), 0, 0],
  sqrt: (x) => [Math.sqrt(x), 0.5 * x ** -0.5, -0.25 * x ** -1.5],
  cbrt: (x) => [Math.cbrt(x), 1 / (3 * Math.cbrt(x) ** 2), -2 / (9 * Math.cbrt(x) ** 5)],
  exp: (x) => [Math.exp(x), Math.exp(x), Math.exp(x)],
  log: (x) => [Math.log(x), x < 0 ? Number.NaN : 1 / x, x < 0 ? Number.NaN : -1 / (x * x)],
  sin: (x) => [Math.sin(x), Math.cos(x), -Math.sin(x)],
  cos: (x) => [Math.cos(x), -Math.sin(x), -Math.cos(x)],
  tan: (x) => [Math.tan(x), 1 / Math.cos(x) ** 2, (2 * Math.sin(x)) / Math.cos(x) ** 3],
  asin: (x) => [Math.asin(x), (1 - x * x) ** -0.5, x * (1 - x * x) ** -1.5],
  acos: (x) => [Math.acos(x), -((1 - x * x) ** -0.5), -x * (1 - x * x) ** -1.5],
  atan: (x) => [Math.atan(x), 1 / (1 + x * x), (-2 * x) / (1 + x * x) ** 2],
  sinh: (x) => [Math.sinh(x), Math.cosh(x), Math.sinh(x)],
  cosh: (x) => [Math.cosh(x), Math.sinh(x), Math.cosh(x)],
  log2: (x) => (x < 0 ? [Number.NaN, Number.NaN, Number.NaN] : [Math.log2(x), 1 / (x * Math.LN2), -1 / (x * x * Math.LN2)]),
  log10: (x) => (x < 0 ? [Number.NaN, Number.NaN, Number.NaN] : [Math.log10(x), 1 / (x * Math.LN10), -1 / (x * x * Math.LN10)]),
  asinh: (x) => [Math.asinh(x), (1 + x * x) ** -0.5, -x * (1 + x * x) ** -1.5],
  acosh: (x) => [Math.acosh(x), x < 1 ? Number.NaN : (x * x - 1) ** -0.5, -x * (x * x - 1) ** -1.5],
  atanh: (x) => [Math.atanh(x), 1 / (1 - x * x), (2 * x) / (1 - x * x) ** 2],
  tanh: (x) => [Math.tanh(x), 1 / Math.cosh(x) ** 2, (-2 * Math.tanh(x)) / Math.cosh(x) ** 2],
};

/**
 * Evaluates a program with first and second derivatives.
 * @param {Instruction[]} program
 * @param {number[]} point the variables
 * @param {number[]} [parameters]
 * @returns {Dual}
 */
export function evaluateDual(program, point, parameters = []) {
  const count = point.length;
  /** @type {Dual[]} */
  const stack = [];
  for (const { kind, name, value } of program) {
    if (kind === 'number') stack.push(constant(value, count));
    else if (kind === 'parameter') stack.push(constant(parameters[value], count));
    else if (kind === 'variable') stack.push(variable(point, value));
    else stack.push(apply(name, stack.splice(stack.length - value)));
  }
  return stack[0];
}

/** @param {Instruction[]} program @param {number[]} point @param {number[]} [parameters] @returns {number} the value alone */
export function evaluateNumber(program, point, parameters = []) {
  const numbers = program.map((instruction) =>
    instruction.kind === 'variable'
      ? { ...instruction, kind: /** @type {const} */ ('number'), value: point[instruction.value] }
      : instruction,
  );
  return evaluateDual(numbers, [], parameters).value;
}

/** @param {number} value @param {number} count @returns {Dual} */
function constant(value, count) {
  return { value, gradient: Array(count).fill(0), hessian: Array.from({ length: count }, () => Array(count).fill(0)) };
}

/** @param {number[]} point @param {number} index */
function variable(point, index) {
  const dual = constant(point[index], point.length);
  dual.gradient[index] = 1;
  return dual;
}

/** @param {string} name @param {Dual[]} operands @returns {Dual} */
function apply(name, operands) {
  const [a, b] = operands;
  if (name === 'add') return two(a, b, a.value + b.value, { a: 1, b: 1 });
  if (name === 'subtract') return two(a, b, a.value - b.value, { a: 1, b: -1 });
  if (name === 'negate') return one(a, -a.value, -1, 0);
  if (name === 'multiply') return two(a, b, a.value * b.value, { a: b.value, b: a.value, ab: 1 });
  if (name === 'divide') return divide(a, b);
  if (name === 'atan2') return arctangent(a, b);
  if (name === 'pow') return power(a, b);
  if (name === 'hypot') return b ? operands.reduce(length) : one(a, ...FUNCTIONS.abs(a.value));
  if (name === 'min') return operands.reduce((x, y) => (Number.isNaN(x.value) || x.value < y.value ? x : y));
  if (name === 'max') return operands.reduce((x, y) => (Number.isNaN(x.value) || x.value > y.value ? x : y));
  return one(a, ...FUNCTIONS[name](a.value));
}

/** @param {Dual} a @param {Dual} b */
function divide(a, b) {
  const [x, y] = [a.value, b.value];
  return two(a, b, x / y, { a: 1 / y, b: -x / y ** 2, ab: -1 / y ** 2, bb: (2 * x) / y ** 3 });
}

/** @param {Dual} a @param {Dual} b */
function arctangent(a, b) {
  const [y, x] = [a.value, b.value];
  const square = x * x + y * y;
  return two(a, b, Math.atan2(y, x), {
    a: x / square,
    b: -y / square,
    aa: (-2 * x * y) / square ** 2,
    ab: (y * y - x * x) / square ** 2,
    bb: (2 * x * y) / square ** 2,
  });
}

/** @param {Dual} a @param {Dual} b */
function length(a, b) {
  const [x, y] = [a.value, b.value];
  const value = Math.hypot(x, y);
  return two(a, b, value, { a: x / value, b: y / value, aa: y ** 2 / value ** 3, ab: (-x * y) / value ** 3, bb: x ** 2 / value ** 3 });
}

/** @param {Dual} a @param {Dual} b */
function power(a, b) {
  const [x, n] = [a.value, b.value];
  const term = (/** @type {number} */ factor, /** @type {number} */ exponent) => (factor === 0 ? 0 : factor * x ** exponent);
  const [value, slope, curvature] = [x ** n, term(n, n - 1), term(n * (n - 1), n - 2)];
  if ([b.gradient, ...b.hessian].flat().every((component) => component === 0)) return one(a, value, slope, curvature);
  const logarithm = Math.log(x);
  return two(a, b, value, {
    a: slope,
    b: value * logarithm,
    aa: curvature,
    ab: x ** (n - 1) * (1 + n * logarithm),
    bb: value * logarithm ** 2,
  });
}

/** f(a). Constants have no derivatives, however steep f is. @param {Dual} a @param {number} value @param {number} slope @param {number} curvature @returns {Dual} */
function one(a, value, slope, curvature) {
  return two(a, constant(0, a.gradient.length), value, { a: slope, aa: curvature });
}

/**
 * f(a, b) by its partial derivatives.
 * @param {Dual} a
 * @param {Dual} b
 * @param {number} value
 * @param {{ a?: number, b?: number, aa?: number, ab?: number, bb?: number }} f
 * @returns {Dual}
 */
function two(a, b, value, f) {
  const product = (/** @type {number | undefined} */ factor, /** @type {number} */ x) => (x === 0 ? 0 : (factor ?? 0) * x);
  const gradient = a.gradient.map((_, i) => product(f.a, a.gradient[i]) + product(f.b, b.gradient[i]));
  const entry = (/** @type {number} */ i, /** @type {number} */ j) =>
    product(f.a, a.hessian[i][j]) +
    product(f.b, b.hessian[i][j]) +
    product(f.aa, a.gradient[i] * a.gradient[j]) +
    product(f.ab, a.gradient[i] * b.gradient[j] + a.gradient[j] * b.gradient[i]) +
    product(f.bb, b.gradient[i] * b.gradient[j]);
  return { value, gradient, hessian: gradient.map((_, i) => gradient.map((_, j) => entry(i, j))) };
}
