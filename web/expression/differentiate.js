/* Forward differentiation: a postfix program becomes nodes for its value and its first and second derivatives, all in one graph.
 *
 * Every step of the program turns the jets of its operands into the jet of its result. What is zero is never built. */

import { ATAN2, HYPOT, LOG, POW, rules } from './functions.js';

/** @typedef {import('./graph.js').Graph} Graph */
/** @typedef {import('./postfix.js').Instruction} Instruction */

/**
 * Nodes of a value, of its first derivatives variable by variable, and of its second derivatives in upper-triangular order (uu, uv, vv).
 * Where creases are looked for, `factors`: of a product; `isFixed`: variables are not in it, whatever side it is written for.
 * @typedef {{ value: number, first: number[], second: number[], factors?: Jet[], isFixed?: boolean }} Jet
 */

/**
 * Adds the value of a program and its derivatives to a graph.
 * @param {Graph} graph
 * @param {Instruction[]} program
 * @param {number} variableCount
 * @param {0 | 1 | 2} order of the highest derivatives wanted
 * @param {Jet[]} [known] what the program's known values are
 * @param {import('./creases.js').Creases} [creases] which of its functions have
 * @returns {Jet}
 */
export function differentiate(graph, program, variableCount, order, known = [], creases = undefined) {
  const calculus = new Calculus(graph, order === 0 ? 0 : variableCount, order === 2);
  const isSplit = program.some(({ name }) => name === 'abs' || name === 'sign');
  const fixed = (/** @type {number} */ node) => (isSplit ? { ...calculus.constant(node), isFixed: true } : calculus.constant(node));
  /** @type {Jet[]} */
  const stack = [];
  for (const { kind, name, value } of program) {
    if (kind === 'number') stack.push(fixed(graph.constant(value)));
    else if (kind === 'parameter') stack.push(fixed(graph.parameter(value)));
    else if (kind === 'variable') stack.push(calculus.variable(value));
    else if (kind === 'known') stack.push(known[value]);
    else {
      const operands = stack.splice(stack.length - value);
      stack.push(creases ? creases.call(graph, calculus, name, operands, isSplit) : calculus.call(name, operands));
    }
  }
  return stack[0];
}

/** A length of more is that of a length and the rest: it has a pair of every two. */
const MOST_PARTS = 4;

/** The rules of differentiation, on jets. */
export class Calculus {
  /** The pairs of variables of the second derivatives. @type {[number, number][]} */ #pairs = [];
  /** What the lengths are made of, by value. @type {Map<number, Jet[]>} */ #lengths = new Map();
  #g;
  #variables;

  /** @param {Graph} graph @param {number} variableCount @param {boolean} withSecond */
  constructor(graph, variableCount, withSecond) {
    this.#g = graph;
    this.#variables = Array.from({ length: variableCount }, (_, i) => i);
    if (withSecond)
      this.#pairs = this.#variables.flatMap((i) => this.#variables.slice(i).map((j) => /** @type {[number, number]} */ ([i, j])));
  }

  /** @param {number} value @returns {Jet} */
  constant(value) {
    return this.#jet(
      value,
      () => this.#g.zero,
      () => this.#g.zero,
    );
  }

  /** @param {number} index @returns {Jet} */
  variable(index) {
    return this.#jet(
      this.#g.variable(index),
      (i) => (i === index ? this.#g.one : this.#g.zero),
      () => this.#g.zero,
    );
  }

  /** @param {string} name @param {Jet[]} operands @returns {Jet} */
  call(name, operands) {
    const [a, b] = operands;
    switch (name) {
      case 'add':
        return this.#linear((x, y) => this.#g.add(x, y), a, b);
      case 'subtract':
        return this.#linear((x, y) => this.#g.subtract(x, y), a, b);
      case 'negate':
        return this.#linear((x) => this.#g.negate(x), a, a);
      case 'multiply':
        return this.#multiply(a, b);
      case 'divide':
        return this.#divide(a, b);
      case 'pow':
        return this.#power(a, b);
      case 'atan2':
        return this.#atan2(a, b);
      case 'hypot':
        return b ? operands.reduce((length, next) => this.#hypot(length, next)) : this.#unary('abs', a);
      case 'min':
        return operands.reduce((least, next) => this.#minimum(least, next));
      case 'max':
        return operands.reduce((most, next) => this.#maximum(most, next));
      default:
        return this.#unary(name, a);
    }
  }

  /** @param {number} value @param {(i: number) => number} first @param {(i: number, j: number, k: number) => number} second k: position of the pair i, j @returns {Jet} */
  #jet(value, first, second) {
    return { value, first: this.#variables.map(first), second: this.#pairs.map(([i, j], k) => second(i, j, k)) };
  }

  /** @param {Jet} jet */
  #isConstant(jet) {
    return jet.first.every((derivative) => derivative === this.#g.zero);
  }

  /** @param {(x: number, y: number) => number} operation @param {Jet} a @param {Jet} b */
  #linear(operation, a, b) {
    return this.#jet(
      operation(a.value, b.value),
      (i) => operation(a.first[i], b.first[i]),
      (_i, _j, k) => operation(a.second[k], b.second[k]),
    );
  }

  /** (ab)'' = a''b + a'b' + b'a' + ab''. @param {Jet} a @param {Jet} b */
  #multiply(a, b) {
    if (a.value === b.value) return this.#integerPower(a, 2);
    const g = this.#g;
    return this.#jet(
      g.multiply(a.value, b.value),
      (i) => g.add(g.multiply(a.first[i], b.value), g.multiply(a.value, b.first[i])),
      (i, j, k) => g.add(g.add(g.multiply(a.second[k], b.value), g.multiply(a.value, b.second[k])), this.#cross(a, b, i, j)),
    );
  }

  /** a_i b_j + a_j b_i. @param {Jet} a @param {Jet} b @param {number} i @param {number} j */
  #cross(a, b, i, j) {
    return this.#g.add(this.#g.multiply(a.first[i], b.first[j]), this.#g.multiply(a.first[j], b.first[i]));
  }

  /** From a = qb: q' = (a' - qb') / b, q'' = (a'' - q'b' - b'q' - qb'') / b. @param {Jet} a @param {Jet} b */
  #divide(a, b) {
    const g = this.#g;
    const q = this.constant(g.divide(a.value, b.value));
    if (this.#isConstant(a) && this.#isConstant(b)) return q;
    const inverse = g.divide(g.one, b.value);
    q.first = this.#variables.map((i) => g.multiply(g.subtract(a.first[i], g.multiply(q.value, b.first[i])), inverse));
    return this.#jet(
      q.value,
      (i) => q.first[i],
      (i, j, k) => g.multiply(g.subtract(g.subtract(a.second[k], g.multiply(q.value, b.second[k])), this.#cross(q, b, i, j)), inverse),
    );
  }

  /** @param {Jet} a @param {Jet} b */
  #power(a, b) {
    const g = this.#g;
    const exponent = g.integerExponent(b.value);
    if (exponent !== undefined) return this.#integerPower(a, exponent);
    if (g.numberOf(b.value) === 0.5) return this.#unary('sqrt', a);
    return this.#isConstant(b) ? this.#constantPower(a, b.value) : this.#generalPower(a, b);
  }

  /** @param {Jet} a @param {number} n */
  #integerPower(a, n) {
    const g = this.#g;
    const value = g.integerPower(a.value, n);
    const times = (/** @type {number} */ factor, /** @type {number} */ node) => g.multiply(g.constant(factor), node);
    if (n >= 0) {
      return this.#chain(
        a,
        value,
        () => (n === 0 ? g.zero : times(n, g.integerPower(a.value, n - 1))),
        () => (n < 2 ? g.zero : times(n * (n - 1), g.integerPower(a.value, n - 2))),
      );
    }
    const inverse = () => g.divide(g.one, a.value);
    return this.#chain(
      a,
      value,
      () => times(n, g.multiply(value, inverse())),
      () => times(n * (n - 1), g.multiply(value, g.integerPower(inverse(), 2))),
    );
  }

  /** The exponent does not depend on the variables: no logarithm. @param {Jet} a @param {number} exponent */
  #constantPower(a, exponent) {
    const g = this.#g;
    const once = g.subtract(exponent, g.one);
    const factor = g.multiply(exponent, once);
    const term = (/** @type {number} */ coefficient, /** @type {number} */ power) =>
      g.whereNonzero(coefficient, g.multiply(coefficient, g.power(a.value, power)));
    return this.#chain(
      a,
      g.power(a.value, exponent),
      () => term(exponent, once),
      () => term(factor, g.subtract(exponent, g.constant(2))),
    );
  }

  /** a^b with both depending on the variables; the logarithm of a base of 0 counts as 0, for 0^b stays 0 under changes of b. @param {Jet} a @param {Jet} b */
  #generalPower(a, b) {
    const g = this.#g;
    const value = g.call(POW, a.value, b.value);
    const logarithm = g.whereNonzero(a.value, g.call(LOG, a.value));
    const below = g.call(POW, a.value, g.subtract(b.value, g.one));
    const slopeA = g.multiply(b.value, below);
    const slopeB = g.multiply(value, logarithm);
    const factor = g.multiply(b.value, g.subtract(b.value, g.one));
    return this.#chainTwo(a, b, value, {
      a: slopeA,
      b: slopeB,
      aa: g.whereNonzero(factor, g.multiply(factor, g.call(POW, a.value, g.subtract(b.value, g.constant(2))))),
      ab: g.add(below, g.multiply(slopeA, logarithm)),
      bb: g.multiply(slopeB, logarithm),
    });
  }

  /** The angle of (x, y): with p = x/r² and q = y/r² its derivatives are p and -q, then -2pq, q² - p² and 2pq. @param {Jet} y @param {Jet} x */
  #atan2(y, x) {
    const g = this.#g;
    const value = g.call(ATAN2, y.value, x.value);
    if (this.#isConstant(y) && this.#isConstant(x)) return this.constant(value);
    const squaredRadius = g.add(g.integerPower(x.value, 2), g.integerPower(y.value, 2));
    const p = g.divide(x.value, squaredRadius);
    const q = g.divide(y.value, squaredRadius);
    const twice = g.multiply(g.constant(2), g.multiply(p, q));
    return this.#chainTwo(y, x, value, {
      a: p,
      b: g.negate(q),
      aa: g.negate(twice),
      ab: g.multiply(g.subtract(q, p), g.add(q, p)),
      bb: twice,
    });
  }

  /**
   * The length h of (a, b, …): with the units p = a/h, q = b/h, … h' = pa' + qb' + … and, by Lagrange's identity, which does not cancel,
   * h'' = w'w'/h + … + pa'' + qb'' + …, w' = pb' - qa' for each two. An operand that is a length itself counts as its own operands: where it is 0 it has no
   * derivatives, but h has.
   * @param {Jet} a @param {Jet} b
   */
  #hypot(a, b) {
    const g = this.#g;
    const value = g.call(HYPOT, a.value, b.value);
    const all = [a, b].flatMap((operand) => this.#lengths.get(operand.value) ?? [operand]);
    const parts = all.length > MOST_PARTS ? [a, b] : all;
    this.#lengths.set(value, parts);
    const units = parts.map((part) => g.divide(part.value, value));
    const along = (/** @type {(part: Jet) => number} */ of) =>
      units.map((unit, k) => g.multiply(unit, of(parts[k]))).reduce((x, y) => g.add(x, y));
    const across = (/** @type {number} */ k, /** @type {number} */ l, /** @type {number} */ i) =>
      g.subtract(g.multiply(units[k], parts[l].first[i]), g.multiply(units[l], parts[k].first[i]));
    return this.#jet(
      value,
      (i) => along((part) => part.first[i]),
      (i, j, at) => {
        let sum = g.zero;
        for (let l = 1; l < parts.length; l++) for (let k = 0; k < l; k++) sum = g.add(sum, g.multiply(across(k, l, i), across(k, l, j)));
        return g.add(
          g.divide(sum, value),
          along((part) => part.second[at]),
        );
      },
    );
  }

  /** Equal arguments: the derivatives of the second. @param {Jet} a @param {Jet} b */
  #minimum(a, b) {
    return this.#choose(this.#g.minimum(a.value, b.value), a, b, a, b);
  }

  /** @param {Jet} a @param {Jet} b */
  #maximum(a, b) {
    return this.#choose(this.#g.maximum(a.value, b.value), b, a, a, b);
  }

  /** Derivatives of `yes` where less < more, else of `no`. @param {number} value @param {Jet} less @param {Jet} more @param {Jet} yes @param {Jet} no */
  #choose(value, less, more, yes, no) {
    const select = (/** @type {number} */ x, /** @type {number} */ y) => this.#g.select(less.value, more.value, x, y);
    return this.#jet(
      value,
      (i) => select(yes.first[i], no.first[i]),
      (_i, _j, k) => select(yes.second[k], no.second[k]),
    );
  }

  /** @param {string} name @param {Jet} a */
  #unary(name, a) {
    const rule = /** @type {import('./functions.js').Rule} */ (rules.get(name));
    const x = a.value;
    const value = rule.value(this.#g, x);
    const slope = () => rule.slope(this.#g, x, value);
    return this.#chain(a, value, slope, () => rule.curvature(this.#g, x, value, slope()));
  }

  /** f(a)'' = f''a'a' + f'a''. @param {Jet} a @param {number} value @param {() => number} slopeOf @param {() => number} curvatureOf */
  #chain(a, value, slopeOf, curvatureOf) {
    if (this.#isConstant(a)) return this.constant(value);
    const g = this.#g;
    const slope = slopeOf();
    const curvature = this.#pairs.length > 0 ? curvatureOf() : g.zero;
    return this.#jet(
      value,
      (i) => g.multiply(slope, a.first[i]),
      (i, j, k) => g.add(g.multiply(curvature, g.multiply(a.first[i], a.first[j])), g.multiply(slope, a.second[k])),
    );
  }

  /** The same for a function of two arguments. @param {Jet} a @param {Jet} b @param {number} value @param {{ a: number, b: number, aa: number, ab: number, bb: number }} f its partial derivatives */
  #chainTwo(a, b, value, f) {
    const g = this.#g;
    const pair = (/** @type {number} */ x, /** @type {number} */ y) => g.add(g.multiply(f.a, x), g.multiply(f.b, y));
    return this.#jet(
      value,
      (i) => pair(a.first[i], b.first[i]),
      (i, j, k) => {
        const squares = g.add(g.multiply(f.aa, g.multiply(a.first[i], a.first[j])), g.multiply(f.bb, g.multiply(b.first[i], b.first[j])));
        return g.add(g.add(squares, g.multiply(f.ab, this.#cross(a, b, i, j))), pair(a.second[k], b.second[k]));
      },
    );
  }
}
