/** Shapes: what every kind of definition is made of. Graphs, surfaces of revolution, tubes and sweeps become parametric surfaces here, put together
 * as nodes of the graph in which formulas are differentiated, so that their derivatives are exact. Knows nothing of paths. */

import { checkDefinition, checkExpressions, readRange } from '../definition.js';
import { compile, evaluateConstant } from '../expression/compile.js';
import { COS, SIN } from '../expression/functions.js';
import { frameAlong } from './frame.js';
import { SHAPE } from './kind.js';
import { componentsOf } from './reference.js';

/** @typedef {import('../definition.js').Expression} Expression */
/** @typedef {import('../expression/compile.js').Formulas} Formulas */
/** @typedef {import('./reference.js').Curve} Curve */
/** @typedef {readonly [Expression, Expression]} Range */

/**
 * @typedef {object} Common what every shape takes besides
 * @property {'auto' | { u?: boolean, v?: boolean }} [periodic] as in a parametric definition
 * @property {Readonly<Record<string, number>>} [parameters]
 * @property {Expression} [density] as in a parametric definition: over u, v, x, y, z of the surface that is written, and over the shape's own variables
 * @property {{ E: Expression, F: Expression, G: Expression }} [metric] as in a parametric definition, over u, v and the shape's own variables
 */
/**
 * @typedef {object} GraphOnly z(x, y); u and v are x and y
 * @property {Expression} z over x and y
 * @property {Range} x
 * @property {Range} y
 */
/**
 * @typedef {object} RevolutionOnly a profile turned about the z axis; u is the angle, v is t
 * @property {Expression} r distance from the axis, over t
 * @property {Expression} z height, over t
 * @property {Range} t
 */
/**
 * @typedef {object} TubeOnly circles across a curve; u is the angle, counter-clockwise seen against the curve, from 0 on its left; v is t
 * @property {readonly [Expression, Expression, Expression]} centreline over t, nowhere standing still
 * @property {Expression} radius over t and, where it is not round, u
 * @property {Range} t
 * @property {readonly [Expression, Expression, Expression]} [reference] "up", over t: a direction nowhere along the centreline; default: one that is found
 */
/**
 * @typedef {object} SweepOnly a profile carried along a path; u is s, v is t
 * @property {readonly [Expression, Expression]} profile over s (and t, if it changes on the way): how far to the left of the path, and how far up
 * @property {readonly [Expression, Expression, Expression]} path over t, nowhere standing still
 * @property {Range} s
 * @property {Range} t
 * @property {readonly [Expression, Expression, Expression]} [reference] "up", over t: a direction nowhere along the path; default: one that is found
 */
/** @typedef {GraphOnly & Common} GraphDefinition */
/** @typedef {RevolutionOnly & Common} RevolutionDefinition */
/** @typedef {TubeOnly & Common} TubeDefinition */
/** @typedef {SweepOnly & Common} SweepDefinition */

/** @typedef {(formulas: Formulas, reference: readonly number[] | null) => number[]} Construction nodes of x, y, z; with the reference direction that was found */
/**
 * @typedef {object} Shape
 * @property {string[]} variables
 * @property {string[]} names of the outputs
 * @property {[string, Range][]} ranges of the variables, with what the caller calls them; none for implicit surfaces
 * @property {Expression[] | Construction} outputs
 * @property {Curve} [curve] along which something is carried
 * @property {{ places: (formulas: Formulas) => Record<string, number>, pullBack: (formulas: Formulas, tensor: number[]) => number[] }} [lifted] where its variables are not those of formulas: nodes of these, and E, F and G
 *   of these as they measure over its own
 */

const POSITION = ['x', 'y', 'z'];
const TENSOR = ['E', 'F', 'G'];

/** @type {Record<string, (kind: string, definition: any) => Shape>} */
const SHAPES = {
  implicit(kind, definition) {
    checkDefinition(kind, definition, ['f'], ['f']);
    return { variables: POSITION, names: ['f'], ranges: [], outputs: [definition.f] };
  },
  parametric(kind, definition) {
    checkDefinition(kind, definition, [...POSITION, 'u', 'v'], POSITION);
    const outputs = POSITION.map((name) => definition[name]);
    return { variables: ['u', 'v'], names: POSITION, ranges: rangesOf(kind, definition, ['u', 'v']), outputs };
  },
  metric(kind, definition) {
    checkDefinition(kind, definition, [...TENSOR, 'u', 'v'], TENSOR);
    const outputs = TENSOR.map((name) => definition[name]);
    return { variables: ['u', 'v'], names: TENSOR, ranges: rangesOf(kind, definition, ['u', 'v']), outputs };
  },
  graph(kind, definition) {
    checkDefinition(kind, definition, ['z', 'x', 'y'], ['z']);
    return { variables: ['x', 'y'], names: POSITION, ranges: rangesOf(kind, definition, ['x', 'y']), outputs: ['x', 'y', definition.z] };
  },
  revolution(kind, definition) {
    checkDefinition(kind, definition, ['r', 'z', 't'], ['r', 'z']);
    const { r, z } = definition;
    return turning(kind, definition, ({ graph, read }) => {
      const [radius, height] = [read(r, 'r', ['t']), read(z, 'z', ['t'])];
      return [...around(graph, radius, read('u', 'u', ['u'])), height];
    });
  },
  tube(kind, definition) {
    checkDefinition(kind, definition, ['centreline', 'radius', 't'], ['radius']);
    const curve = curveOf(kind, definition, 'centreline');
    const { radius } = definition;
    const carried = carriedAlong(curve, ({ graph, read }) => around(graph, read(radius, 'radius', ['u', 't']), graph.variable(0)));
    return { ...turning(kind, definition, carried), curve };
  },
  sweep(kind, definition) {
    checkDefinition(kind, definition, ['profile', 'path', 's', 't'], []);
    checkExpressions(kind, 'profile', definition.profile, 2);
    const curve = curveOf(kind, definition, 'path');
    const profile = [...definition.profile];
    const outputs = carriedAlong(curve, ({ read }) => profile.map((source, i) => read(source, `profile[${i}]`, ['s', 't'])));
    return { variables: ['s', 't'], names: POSITION, ranges: rangesOf(kind, definition, ['s', 't']), outputs, curve };
  },
};

/** The kinds that are parametric surfaces, however they are written. */
export const PARAMETRIC_KINDS = Object.freeze(Object.keys(SHAPES).filter((kind) => kind !== 'implicit' && kind !== 'metric'));
/** Checks a definition and says how to compile it. @param {string} kind @param {unknown} definition @returns {Shape} */
export const readShape = (kind, definition) => SHAPES[kind](kind, definition);

/**
 * Compiles a shape, as space measures it.
 * @param {'parametric' | 'implicit' | 'metric'} kind @param {Shape} shape @param {readonly number[] | null} reference of a frame
 * @param {Record<string, number>} parameters @param {import('../expression/compile.js').Apply} apply @param {import('../expression/creases.js').Creases} creases
 */
export const compileShape = (kind, { outputs, names, variables }, reference, parameters, apply, creases) =>
  compile({
    outputs: typeof outputs === 'function' ? (formulas) => outputs(formulas, reference) : outputs,
    ...{ names, variables, parameters, apply, creases },
    valueOrder: SHAPE[kind].valueOrder,
  });

/** @param {string} kind @param {any} definition @param {string[]} names @returns {[string, Range][]} copies */
function rangesOf(kind, definition, names) {
  return names.map((name) => [name, readRange(kind, definition[name], name)]);
}

/** A shape over a full turn and a range of t. @param {string} kind @param {any} definition @param {Construction} outputs @returns {Shape} */
function turning(kind, definition, outputs) {
  const ranges = rangesOf(kind, definition, ['t']);
  return { variables: ['u', 't'], names: POSITION, ranges: [['u', [0, 2 * Math.PI]], ...ranges], outputs };
}

/** r cos u, r sin u. @param {import('../expression/graph.js').Graph} graph @param {number} radius @param {number} angle */
function around(graph, radius, angle) {
  return [COS, SIN].map((circular) => graph.multiply(radius, graph.call(circular, angle)));
}

/** @param {string} kind @param {any} definition @param {string} name @returns {Curve} copies */
function curveOf(kind, definition, name) {
  checkExpressions(kind, name, definition[name], 3);
  const { reference = [] } = definition;
  if (definition.reference !== undefined) checkExpressions(kind, 'reference', reference, 3);
  return { name, sources: [...definition[name]], reference: [...reference] };
}

/** A point of the curve, plus so much to the left of it and so much up. @param {Curve} curve @param {(formulas: Formulas) => number[]} profile @returns {Construction} */
function carriedAlong({ name, sources, reference }, profile) {
  return (formulas, found) => {
    const { graph, read } = formulas;
    const curve = componentsOf(name).map((component, i) => read(sources[i], component, ['t']));
    const upwards = componentsOf('reference').map((component, i) => read((found ?? reference)[i], component, ['t']));
    const { left, up } = frameAlong(formulas, curve, upwards);
    const [x, y] = profile(formulas);
    return curve.map((node, i) => graph.add(node, graph.add(graph.multiply(x, left[i]), graph.multiply(y, up[i]))));
  };
}

/**
 * The rectangle of a shape, as its parameters make it.
 * @param {string} caller @param {Shape} shape @param {Record<string, number>} parameters @param {import('../expression/compile.js').Apply} apply
 * @returns {import('./seams.js').Asked}
 */
export function evaluateRanges(caller, { ranges }, parameters, apply) {
  const [lower, upper] = [
    [0, 0],
    [0, 0],
  ];
  for (const [j, [name, ends]] of ranges.entries()) {
    const range = ends.map((end) => evaluateConstant(end, parameters, apply, name));
    if (!range.every(Number.isFinite) || !(range[0] < range[1]))
      throw new RangeError(`${caller}: ${name} must be a range of two numbers, the smaller first, not [${range}]`);
    [lower[j], upper[j]] = range;
  }
  return { lower, upper, caller };
}
