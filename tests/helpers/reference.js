/**
 * Surfaces parsed and differentiated by mathjs: independent of the library's own parser, differentiation and elementary functions.
 *
 * Derivatives are symbolic where mathjs knows them, else central differences of order four.
 */
import { derivative, parse } from 'mathjs';
import { isShape, positionOnShape, rangesOfShape } from './shape-reference.js';

/** @typedef {number[]} Vector three numbers */

/**
 * A parametric surface.
 *
 * @typedef {object} ParametricReference
 * @property {'parametric'} kind
 * @property {[[number, number], [number, number]]} rectangle of u and v
 * @property {[boolean, boolean]} periodic as the definition says, or, 'auto', whether opposite edges coincide
 * @property {(place: ArrayLike<number>) => Vector} position
 * @property {(place: ArrayLike<number>) => [Vector, Vector]} tangents S_u and S_v
 */

/**
 * An implicit surface.
 *
 * @typedef {object} ImplicitReference
 * @property {'implicit'} kind
 * @property {(point: ArrayLike<number>) => number} value f
 * @property {(point: ArrayLike<number>) => Vector} gradient
 * @property {(point: ArrayLike<number>) => Vector} project onto f = 0 along gradients
 */

/** @typedef {import('./verify-path.js').Definition} Definition */

export const dot = (/** @type {Vector} */ a, /** @type {Vector} */ b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const norm = (/** @type {Vector} */ a) => Math.hypot(a[0], a[1], a[2]);
export const scale = (/** @type {Vector} */ a, /** @type {number} */ by) => a.map((x) => x * by);
export const add = (/** @type {Vector} */ a, /** @type {Vector} */ b) => a.map((x, i) => x + b[i]);
export const subtract = (/** @type {Vector} */ a, /** @type {Vector} */ b) => a.map((x, i) => x - b[i]);
export const unit = (/** @type {Vector} */ a) => scale(a, 1 / norm(a));
/** @type {(a: Vector, b: Vector) => Vector} */
export const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

/** @typedef {(place: ArrayLike<number>) => number} Evaluate */

const constants = new Map([
  ['pi', Math.PI],
  ['e', Math.E],
  ['tau', 2 * Math.PI],
]);

/** @type {Map<string, (a: number, b: number) => number>} */
const operations = new Map([
  ['add', (a, b) => a + b],
  ['subtract', (a, b) => a - b],
  ['multiply', (a, b) => a * b],
  ['divide', (a, b) => a / b],
  ['pow', (a, b) => a ** b],
  ['unaryMinus', (a) => -a],
  ['unaryPlus', (a) => a],
  /* In derivatives of mathjs. */
  ['sec', (a) => 1 / Math.cos(a)],
  ['csc', (a) => 1 / Math.sin(a)],
  ['cot', (a) => 1 / Math.tan(a)],
  ['sech', (a) => 1 / Math.cosh(a)],
]);

/**
 * A tree of mathjs as nested functions: the same numbers as its own evaluation, fifty times faster.
 *
 * @param {any} node
 * @param {string[]} variables
 * @param {Record<string, number>} parameters
 * @returns {Evaluate}
 */
function compileNode(node, variables, parameters) {
  if (node.type === 'ParenthesisNode') return compileNode(node.content, variables, parameters);
  if (node.type === 'ConstantNode') return () => Number(node.value);
  if (node.type === 'SymbolNode') {
    const index = variables.indexOf(node.name);
    if (index >= 0) return (place) => place[index];
    const value = Object.hasOwn(parameters, node.name) ? parameters[node.name] : constants.get(node.name);
    if (value !== undefined) return () => value;
  }
  const name = node.type === 'OperatorNode' ? node.fn : node.fn?.name;
  const operation = operations.get(name) ?? (Object.hasOwn(Math, name ?? '') ? Reflect.get(Math, name) : undefined);
  if (!operation || operation.length !== node.args?.length) throw new RangeError(`the reference does not know ${node}`);
  const [first, second] = node.args.map((/** @type {any} */ argument) => compileNode(argument, variables, parameters));
  return second ? (place) => operation(first(place), second(place)) : (place) => operation(first(place));
}

/**
 * Compiles an expression to a function of the named variables; outside its domain it is NaN.
 *
 * @param {string|number} expression
 * @param {string[]} variables
 * @param {Record<string, number>} [parameters]
 * @returns {Evaluate}
 */
export function compileExpression(expression, variables, parameters = {}) {
  return compileNode(parse(String(expression)), variables, parameters);
}

/**
 * The partial derivative of an expression.
 *
 * @param {string|number} expression
 * @param {number} which variable
 * @param {string[]} variables
 * @param {Record<string, number>} [parameters]
 * @returns {Evaluate}
 */
export function compileDerivative(expression, which, variables, parameters = {}) {
  try {
    return compileNode(derivative(String(expression), variables[which], { simplify: false }), variables, parameters);
  } catch {
    return differences(compileExpression(expression, variables, parameters), which);
  }
}

/**
 * @param {Evaluate} value
 * @param {number} which
 * @returns {Evaluate}
 */
function differences(value, which) {
  return (place) => {
    /* The fifth root of the precision balances rounding against the fourth-order error. */
    const step = 1e-3 * Math.max(1, Math.abs(place[which]));
    const at = (/** @type {number} */ steps) => value(Array.from(place, (x, i) => (i === which ? x + steps * step : x)));
    return (8 * (at(1) - at(-1)) - (at(2) - at(-2))) / (12 * step);
  };
}

/** @type {Map<string, ParametricReference|ImplicitReference>} */
const made = new Map();

/**
 * The reference for a definition; made once, for mathjs takes its time to differentiate.
 *
 * @param {Definition} definition of kind 'parametric' or 'implicit'
 * @returns {ParametricReference|ImplicitReference}
 */
export function referenceSurface(definition) {
  const key = JSON.stringify(definition);
  const surface = made.get(key) ?? makeReference(definition);
  made.set(key, surface);
  return surface;
}

/**
 * @param {Definition} definition
 * @returns {ParametricReference|ImplicitReference}
 */
function makeReference(definition) {
  if (definition.kind === 'parametric') return parametricReference(definition);
  if (definition.kind === 'implicit') return implicitReference(definition);
  if (isShape(definition)) return shapeReference(definition);
  throw new RangeError(`no reference for surfaces of kind ${definition.kind}`);
}

/**
 * @param {Definition} definition
 * @returns {ParametricReference}
 */
function parametricReference({ x = 'u', y = 'v', z = '0', u, v, periodic = 'auto', parameters }) {
  const variables = ['u', 'v'];
  const positions = [x, y, z].map((expression) => compileExpression(expression, variables, parameters));
  const partials = [0, 1].map((i) => [x, y, z].map((expression) => compileDerivative(expression, i, variables, parameters)));
  const ends = [u, v].map((range) => (range ?? []).map((end) => compileExpression(end, [], parameters)([])));
  const rectangle = /** @type {[[number, number], [number, number]]} */ (ends);
  const position = (/** @type {ArrayLike<number>} */ place) => positions.map((coordinate) => coordinate(place));
  return {
    kind: 'parametric',
    rectangle,
    periodic: periodic === 'auto' ? [closes(position, rectangle, 0), closes(position, rectangle, 1)] : [!!periodic.u, !!periodic.v],
    position,
    tangents: (place) => [partials[0].map((partial) => partial(place)), partials[1].map((partial) => partial(place))],
  };
}

/**
 * @param {Definition} definition of a graph, surface of revolution, tube or sweep
 * @returns {ParametricReference}
 */
function shapeReference(definition) {
  const position = positionOnShape(definition);
  const { periodic = 'auto', parameters } = definition;
  const ends = rangesOfShape(definition).map((range) => range.map((end) => compileExpression(end, [], parameters)([])));
  const rectangle = /** @type {[[number, number], [number, number]]} */ (ends);
  const partials = [0, 1].map((i) => [0, 1, 2].map((k) => differences((place) => position(place)[k], i)));
  return {
    kind: 'parametric',
    rectangle,
    periodic: periodic === 'auto' ? [closes(position, rectangle, 0), closes(position, rectangle, 1)] : [!!periodic.u, !!periodic.v],
    position,
    tangents: (place) => [partials[0].map((partial) => partial(place)), partials[1].map((partial) => partial(place))],
  };
}

/**
 * True where the two edges across a direction are the same curve, in the same sense or (a Möbius strip) the opposite one, and not a point.
 *
 * @param {(place: ArrayLike<number>) => Vector} position
 * @param {[[number, number], [number, number]]} rectangle
 * @param {number} direction
 */
function closes(position, rectangle, direction) {
  const [low, high] = rectangle[direction];
  const [start, end] = rectangle[1 - direction];
  const at = (/** @type {number} */ across, /** @type {number} */ part) => {
    const along = start + part * (end - start);
    return position(direction === 0 ? [across, along] : [along, across]);
  };
  const parts = [0.05, 0.27, 0.5, 0.81, 0.93];
  const extent = Math.max(...parts.map((part) => norm(subtract(at(low, part), at((low + high) / 2, 0.5)))));
  const same = parts.every((part) => norm(subtract(at(low, part), at(high, part))) < 1e-9 * extent);
  const turned = parts.every((part) => norm(subtract(at(low, part), at(high, 1 - part))) < 1e-9 * extent);
  const collapsed = parts.every((part) => norm(subtract(at(low, part), at(low, 0.5))) < 1e-9 * extent);
  return (same || turned) && !collapsed;
}

/**
 * @param {Definition} definition
 * @returns {ImplicitReference}
 */
function implicitReference({ f = '0', parameters }) {
  const variables = ['x', 'y', 'z'];
  const value = compileExpression(f, variables, parameters);
  const partials = [0, 1, 2].map((i) => compileDerivative(f, i, variables, parameters));
  const gradient = (/** @type {ArrayLike<number>} */ point) => partials.map((partial) => partial(point));
  const project = (/** @type {ArrayLike<number>} */ start) => {
    let point = Array.from(start);
    for (let step = 0; step < 50; step++) {
      const slope = gradient(point);
      const moved = subtract(point, scale(slope, value(point) / dot(slope, slope)));
      if (!(norm(subtract(moved, point)) > 1e-16 * norm(point))) break;
      point = moved;
    }
    return point;
  };
  return { kind: 'implicit', value, gradient, project };
}
