/**
 * A surface around one of its poles, over a plane: as far from its origin as a place is from the pole, in the direction that the coordinate around it tells. There the pole is a place like any other.
 * Compiled when somebody asks for it. MATH.md, "Creases at poles". Knows nothing of paths.
 */

import { ATAN2, COS, SIN } from '../expression/functions.js';
import { shapeNodes } from './metric.js';
import { edgeOf } from './rectangle.js';

/** @typedef {import('./shapes.js').Shape} Shape */
/** @typedef {import('../expression/compile.js').Formulas} Formulas */
/** @typedef {import('./domain.js').Domain} Domain */
/** @typedef {(code: number, x: number, y: number) => number} Apply one of the functions of formulas */

/** No formula can name these. */
const PLANE = ['p ', 'q '];
/** So far from the origin derivatives are taken there: what is infinite cancels to the bit, as it is powers of two. */
const MIDDLE = 2 ** -500;

/** What is around a pole: its coordinates, where it is, which way from there, how far, and how far around. @param {Domain} domain @param {number} pole */
function around({ lower, upper }, pole) {
  const { across, along, side } = edgeOf(pole);
  const turn = (upper[along] - lower[along]) / (2 * Math.PI);
  return { across, along, turn, at: (side ? upper : lower)[across], away: side ? -1 : 1, far: upper[across] - lower[across] };
}

/** E, F and G as they measure over the plane. @param {Formulas} formulas @param {number[]} tensor @param {number[]} places nodes of u and v */
function pulledBack({ graph, slope }, [e, f, g], [u, v]) {
  const times = (/** @type {number[]} */ ...nodes) => nodes.reduce((product, node) => graph.multiply(product, node));
  const slopes = PLANE.map((name) => [slope(u, name), slope(v, name)]);
  const pairs = [
    [0, 0],
    [0, 1],
    [1, 1],
  ];
  return pairs.map(([i, j]) => {
    const [[a, b], [c, d]] = [slopes[i], slopes[j]];
    return [times(a, c, e), times(a, d, f), times(b, c, f), times(b, d, g)].reduce((sum, node) => graph.add(sum, node));
  });
}

/**
 * A shape over that plane; null: along a curve it has no formulas that could be.
 * @param {Shape} shape @param {Domain} domain @param {number} pole @param {boolean} isAbstract whether it is E, F and G @returns {Shape | null}
 */
export function flattenShape(shape, domain, pole, isAbstract) {
  const { across, turn, at, away, far } = around(domain, pole);
  const { variables } = shape;
  if (shape.curve) return null;
  const places = (/** @type {Formulas} */ { graph }) => {
    const [p, q] = [graph.variable(0), graph.variable(1)];
    const beside = graph.add(p, graph.constant(MIDDLE));
    const radius = graph.squareRoot(graph.add(graph.multiply(beside, beside), graph.multiply(q, q)));
    const angle = graph.call(ATAN2, q, beside);
    /* What is written with these in polar coordinates is as exact as if it were written in p and q. */
    for (const [circular, part, whole] of [
      [COS, beside, p],
      [SIN, q, q],
    ]) {
      const quotient = graph.divide(part, radius);
      graph.equate(graph.call(circular, angle), quotient);
      graph.equate(graph.multiply(radius, quotient), whole);
    }
    const nodes = [
      graph.multiply(graph.constant(turn), angle),
      graph.add(graph.constant(at), graph.multiply(graph.constant(away), radius)),
    ];
    if (across === 0) nodes.reverse();
    return nodes;
  };
  const pullBack = (/** @type {Formulas} */ formulas, /** @type {number[]} */ tensor) => pulledBack(formulas, tensor, places(formulas));
  const range = /** @type {[number, number]} */ ([-far, far]);
  return {
    variables: PLANE,
    names: shape.names,
    ranges: PLANE.map((name) => [name, range]),
    outputs(formulas, reference) {
      const nodes = places(formulas);
      const known = (/** @type {string[]} */ names) =>
        Object.fromEntries(names.map((name) => [name, nodes[name === 'u' ? 0 : variables.indexOf(name)]]));
      const read = /** @type {Formulas['read']} */ (
        (source, name, names, more = {}) => formulas.read(source, name, [], { ...known(names), ...more })
      );
      const outputs = shapeNodes(shape, { ...formulas, read }, reference);
      return isAbstract ? pullBack(formulas, outputs) : outputs;
    },
    lifted: {
      places: (formulas) => {
        const [u, v] = places(formulas);
        return { u, v, [variables[0]]: u, [variables[1]]: v };
      },
      pullBack,
    },
  };
}

/** Places of the rectangle over the plane around a pole. @param {Domain} domain @param {number} pole @param {ArrayLike<number>} places u v of each @param {Apply} apply */
export function intoPlane(domain, pole, places, apply) {
  const { across, along, turn, at } = around(domain, pole);
  return Float64Array.from({ length: places.length }, (_, k) => {
    const first = k - (k & 1);
    const angle = places[first + along] / turn;
    return Math.abs(places[first + across] - at) * apply(k & 1 ? SIN : COS, angle, 0);
  });
}

/**
 * A path over the plane in the rectangle: each place in the turn of the one before, at a pole in its direction; its ends are the given ones, the second by whole turns.
 * @param {Domain} domain @param {number} pole @param {ArrayLike<number>} places @param {number[][]} ends @param {Apply} apply
 */
export function outOfPlane(domain, pole, places, ends, apply) {
  const { across, along, turn, at, away } = around(domain, pole);
  const period = 2 * Math.PI * turn;
  const lifted = new Float64Array(places.length);
  const last = places.length - 2;
  let before = ends[0][along];
  for (let k = 0; k <= last; k += 2) {
    const [p, q] = [places[k], places[k + 1]];
    const radius = Math.sqrt(p * p + q * q);
    const end = ends[k === 0 ? 0 : k === last ? 1 : 2];
    if (radius > 0) {
      const angle = end ? end[along] : turn * apply(ATAN2, q, p);
      before = angle + period * Math.round((before - angle) / period);
    }
    lifted[k + along] = before;
    lifted[k + across] = end ? end[across] : at + away * radius;
  }
  return lifted;
}
