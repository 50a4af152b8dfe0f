/** How length is measured where space does not do it alone: densities and metric tensors, checked and compiled into what the solver reads. */

import { refuse } from '../arguments.js';
import { checkExpression } from '../definition.js';
import { compile, evaluateConstant } from '../expression/compile.js';

/** @typedef {import('../expression/compile.js').Compiled} Compiled */

/** enum sp_surface_metric of wasm/surface.h */
export const METRIC = { induced: 0, density: 1, tensor: 2 };

/** What a `metric` holds: as callers name its entries, and in the order in which the solver reads them. @type {Record<string, { entries: string[], order: string[] }>} */
const TENSOR = {
  parametric: { entries: ['E', 'F', 'G'], order: ['E', 'F', 'G'] },
  implicit: { entries: ['xx', 'xy', 'xz', 'yy', 'yz', 'zz'], order: ['xx', 'xy', 'yy', 'xz', 'yz', 'zz'] },
};

/**
 * What measures length besides space. isOwn: the E, F and G that space induces, in its place, on a parametric surface.
 * @typedef {{ density?: import('../definition.js').Expression, metric?: Record<string, import('../definition.js').Expression>, isOwn?: boolean }} Measure
 */

/** @param {string} kind @param {any} definition @returns {Measure} a copy */
export function readMeasure(kind, { density, metric }) {
  if (kind === 'metric') {
    if (density !== undefined || metric !== undefined)
      throw new RangeError(`${kind}: a surface given by E, F and G takes no density or metric; multiply E, F and G by ρ² instead`);
    return {};
  }
  if (density !== undefined) checkExpression(kind, 'density', density);
  if (metric === undefined) return { density };
  const { entries } = TENSOR[kind === 'implicit' ? kind : 'parametric'];
  const what = `{ ${entries.join(', ')} }`;
  if (typeof metric !== 'object' || metric === null) refuse(`${kind}: metric`, what, metric);
  for (const name of entries) {
    if (metric[name] === undefined) throw new TypeError(`${kind}: metric must be ${what}; ${name} is missing`);
    checkExpression(kind, `metric.${name}`, metric[name]);
  }
  return { density, metric: { ...metric } };
}

/**
 * By how much all lengths are those of space multiplied, where that is the same everywhere; 0: it is not, or not by a positive number.
 * @param {Measure} measure @param {Record<string, number>} parameters @param {import('../expression/compile.js').Apply} apply
 */
export function factorOf({ density = 1, metric }, parameters, apply) {
  const read = (/** @type {import('../definition.js').Expression} */ source) => evaluateConstant(source, parameters, apply);
  try {
    const factor = read(density);
    const [xx, xy, yy, xz, yz, zz] = metric ? TENSOR.implicit.order.map((name) => read(metric[name])) : [1, 0, 1, 0, 0, 1];
    const isSpace = xx === yy && xx === zz && [xy, xz, yz].every((x) => x === 0);
    const root = Math.sqrt(factor * Math.abs(factor) * xx);
    return isSpace && root > 0 && root < Infinity ? root : 0;
  } catch {
    /* Coordinates are no constants; nor are E, F and G what an implicit surface has. */
    return 0;
  }
}

/** S_u·S_u, S_u·S_v and S_v·S_v as nodes. @param {import('../expression/compile.js').Formulas} formulas @param {number[]} position nodes of x, y, z @param {string[]} variables */
function induced({ graph, slope }, position, variables) {
  const [a, b] = variables.map((variable) => position.map((node) => slope(node, variable)));
  return [
    [a, a],
    [a, b],
    [b, b],
  ].map(([p, q]) => p.map((node, i) => graph.multiply(node, q[i])).reduce((sum, node) => graph.add(sum, node)));
}

/** What a shape gives, as nodes. @param {import('./shapes.js').Shape} shape @param {import('../expression/compile.js').Formulas} formulas @param {readonly number[] | null} reference of a frame */
export const shapeNodes = ({ outputs, names, variables }, formulas, reference) =>
  typeof outputs === 'function' ? outputs(formulas, reference) : outputs.map((source, i) => formulas.read(source, names[i], variables));

/** The square of a density, with its sign, as a node; 1 without. @param {import('../expression/compile.js').Formulas} formulas @param {Measure} measure @param {string[]} variables @param {Record<string, number>} known */
export function squareOf({ graph, read }, { density }, variables, known) {
  const factor = density === undefined ? graph.one : read(density, 'density', variables, known);
  return graph.multiply(factor, graph.absolute(factor));
}

/**
 * The nodes of a shape, and of what measures length on it. Formulas are over u, v, the shape's own
 * variables, and, a density's, x, y and z; over x, y, z on an implicit surface.
 * @param {'parametric' | 'implicit' | 'metric'} kind @param {Measure} measure @param {import('./shapes.js').Shape} shape @param {readonly number[] | null} reference of a frame
 * @param {import('../expression/compile.js').Formulas} formulas @returns {{ shaped: number[], measured: number[] }}
 */
export function nodesOf(kind, measure, shape, reference, formulas) {
  const { graph, read } = formulas;
  const { metric, isOwn } = measure;
  const { variables, lifted } = shape;
  const known = (/** @type {Record<string, number>} */ nodes) =>
    Object.fromEntries(Object.entries(nodes).filter(([name]) => !variables.includes(name)));
  /** @type {Record<string, number>} */
  const places = lifted ? lifted.places(formulas) : kind === 'implicit' ? {} : { u: graph.variable(0), v: graph.variable(1) };
  const shaped = shapeNodes(shape, formulas, reference);
  const [x, y, z] = shaped;
  const everything = kind === 'implicit' ? places : { ...places, x, y, z };
  const square = squareOf(formulas, measure, variables, known(everything));
  const entry = (/** @type {string} */ name) => read(/** @type {any} */ (metric)[name], `metric.${name}`, variables, known(places));
  const written = metric && TENSOR[kind].order.map(entry);
  const own = written && lifted ? lifted.pullBack(formulas, written) : written;
  const tensor = isOwn ? induced(formulas, shaped, variables) : (own ?? [graph.one]);
  return { shaped, measured: tensor.map((component) => graph.multiply(component, square)) };
}

/**
 * Compiles what measures length, if it is not space alone: the function `jet` of wasm/surface.h for that metric.
 * @param {'parametric' | 'implicit' | 'metric'} kind @param {Measure} measure @param {import('./shapes.js').Shape} shape @param {readonly number[] | null} reference of a frame
 * @param {Record<string, number>} parameters @param {import('../expression/compile.js').Apply} apply @param {import('../expression/creases.js').Creases} [creases]
 * @returns {{ code: number, compiled: Compiled } | null}
 */
export function compileMetric(kind, measure, shape, reference, parameters, apply, creases) {
  const { density, metric, isOwn } = measure;
  if (density === undefined && metric === undefined && !isOwn) return null;
  const { names, variables } = shape;
  const compiled = compile({
    outputs: (formulas) => {
      const { shaped, measured } = nodesOf(kind, measure, shape, reference, formulas);
      return kind === 'parametric' && measured.length > 1 ? measured : [...shaped, ...measured];
    },
    names,
    variables,
    parameters,
    valueOrder: 0,
    apply,
    creases,
  });
  return { code: metric || isOwn ? METRIC.tensor : METRIC.density, compiled };
}
