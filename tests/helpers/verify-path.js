/**
 * Says whether a path is a geodesic, without the solver, its compiler or its derivatives.
 *
 * Ends, surface, rectangle, length, spacing, sheets and lifts are judged here, geodesic curvature in path-curvature.js.
 */
import { checkCurvature } from './path-curvature.js';
import { add, cross, dot, norm, referenceSurface, scale, subtract, unit } from './reference.js';

/** Largest distance to the surface, relative to the size of the coordinates. */
const SURFACE_TOLERANCE = 1e-10;

/** @typedef {string|number} Expression */

/**
 * A surface as the library takes it.
 *
 * @typedef {object} Definition
 * @property {string} kind
 * @property {Expression} [x]
 * @property {Expression} [y]
 * @property {Expression} [z]
 * @property {readonly [Expression, Expression]} [u]
 * @property {readonly [Expression, Expression]} [v]
 * @property {'auto'|{ u?: boolean, v?: boolean }} [periodic]
 * @property {Expression} [f]
 * @property {readonly (readonly [number, number])[]} [bounds]
 * @property {Record<string, number>} [parameters]
 * @property {Expression} [density]
 * @property {Expression} [E]
 * @property {Expression} [F]
 * @property {Expression} [G]
 */

/** @typedef {{ points: ArrayLike<number>, parameters?: ArrayLike<number>|null, length: number }} PathData the fields of a Path that are looked at */

/**
 * What is asked of the path, and how strictly.
 *
 * @typedef {object} Demands
 * @property {number[]} [from] where it starts: u v or x y z; unchecked without
 * @property {number[]} [to] where it ends
 * @property {number} [tolerance] largest geodesic curvature times length that counts as none, 1e-4 (it costs a relative length of about 1e-9)
 * @property {number} [lengthTolerance] largest relative difference between `length` and the sum of the chords, 1e-12
 * @property {boolean} [equalChords] whether the chords must be equal up to their own curvature, true
 */

/** @typedef {{ check: string, at: number, figure: number, limit: number }} Violation what failed, at which point, by how much */

/** @typedef {import('./reference.js').Vector} Vector */

/**
 * @typedef {object} Context
 * @property {import('./reference.js').ParametricReference|import('./reference.js').ImplicitReference} surface
 * @property {Vector[]} points
 * @property {number[][]} places u v of each point, empty for implicit
 * @property {Vector[]} chords
 * @property {Vector[]} normals unit normals of the surface
 * @property {number} length sum of the chords
 * @property {number} size largest coordinate
 * @property {(check: string, at: number, figure: number, limit: number) => void} demand records a violation unless figure <= limit
 */

/**
 * Verifies a path on a parametric or implicit surface without density.
 *
 * @param {Definition} definition
 * @param {PathData} path
 * @param {Demands} [demands]
 * @returns {Violation[]} empty for a geodesic; `check` is one of finite, count, start, end, surface, rectangle, length, spacing, sheet, lift, curvature, edge
 */
export function verifyPath(definition, path, demands = {}) {
  if (definition.density !== undefined) throw new RangeError('verifyPath knows no densities');
  /** @type {Violation[]} */
  const violations = [];
  const surface = referenceSurface(definition);
  const points = split(path.points, 3);
  const places = surface.kind === 'parametric' ? split(path.parameters ?? [], 2) : [];
  const numbers = [...Array.from(path.points), ...places.flat(), path.length];
  const bad = numbers.findIndex((number) => !Number.isFinite(number));
  if (bad >= 0) return [{ check: 'finite', at: bad, figure: numbers[bad], limit: 0 }];
  const counted = points.length >= 2 && path.points.length % 3 === 0 && (surface.kind === 'implicit' || places.length === points.length);
  if (!counted) return [{ check: 'count', at: places.length, figure: path.points.length, limit: 3 * places.length }];
  const chords = points.slice(1).map((point, i) => subtract(point, points[i]));
  const context = {
    surface,
    points,
    places,
    chords,
    normals: points.map((point, i) => normalAt(surface, point, places[i])),
    length: chords.reduce((sum, chord) => sum + norm(chord), 0),
    size: Math.max(...Array.from(path.points, Math.abs)),
    demand: (/** @type {string} */ check, /** @type {number} */ at, /** @type {number} */ figure, /** @type {number} */ limit) => {
      if (!(figure <= limit)) violations.push({ check, at, figure, limit });
    },
  };
  checkEnds(context, demands);
  checkSurface(context);
  context.demand('length', 0, Math.abs(path.length - context.length), (demands.lengthTolerance ?? 1e-12) * context.length);
  if (context.length === 0) return violations;
  if (demands.equalChords ?? true) checkSpacing(context);
  if (surface.kind === 'implicit') checkSheets(context, surface);
  else checkLifts(context, surface);
  checkCurvature(context, demands.tolerance ?? 1e-4);
  return violations;
}

/**
 * @param {ArrayLike<number>} numbers
 * @param {number} width
 */
function split(numbers, width) {
  return Array.from({ length: Math.floor(numbers.length / width) }, (_, i) =>
    Array.from({ length: width }, (_, j) => numbers[width * i + j]),
  );
}

/**
 * @param {Context['surface']} surface
 * @param {Vector} point
 * @param {number[]} place
 */
function normalAt(surface, point, place) {
  return unit(surface.kind === 'implicit' ? surface.gradient(point) : cross(...surface.tangents(place)));
}

/**
 * Ends exactly where asked; implicit: no further from there than the surface is.
 *
 * @param {Context} context
 * @param {Demands} demands
 */
function checkEnds({ surface, points, places, size, demand }, { from, to }) {
  const last = points.length - 1;
  for (const [check, at, wanted] of /** @type {const} */ ([
    ['start', 0, from],
    ['end', last, to],
  ])) {
    if (!wanted) continue;
    if (surface.kind === 'implicit') {
      const distance = Math.abs(surface.value(wanted)) / norm(surface.gradient(wanted));
      demand(check, at, norm(subtract(points[at], wanted)), 2 * distance + 1e-12 * size);
    } else {
      demand(check, at, norm(subtract(points[at], surface.position(wanted))), 1e-12 * size);
      if (!surface.periodic.some(Boolean)) demand(check, at, Math.max(...wanted.map((x, i) => Math.abs(places[at][i] - x))), 0);
    }
  }
}

/**
 * Every point on the surface, every parameter in the closed rectangle.
 *
 * @param {Context} context
 */
function checkSurface({ surface, points, places, size, demand }) {
  points.forEach((point, at) => {
    if (surface.kind === 'implicit') {
      demand('surface', at, Math.abs(surface.value(point)) / norm(surface.gradient(point)), SURFACE_TOLERANCE * size);
      return;
    }
    demand('surface', at, norm(subtract(point, surface.position(places[at]))), SURFACE_TOLERANCE * size);
    for (const i of [0, 1]) {
      const [low, high] = surface.rectangle[i];
      if (!surface.periodic[i]) demand('rectangle', at, Math.max(low - places[at][i], places[at][i] - high), 0);
    }
  });
}

/**
 * Chords of equal arcs differ by a 24th of the square of their turn; half that square leaves room for an edge.
 *
 * @param {Context} context
 */
function checkSpacing({ chords, length, size, demand }) {
  const lengths = chords.map(norm);
  const mean = length / chords.length;
  const turn = Math.max(0, ...chords.slice(1).map((chord, i) => norm(subtract(unit(chord), unit(chords[i])))));
  lengths.forEach((one, at) => {
    demand('spacing', at, Math.abs(one / mean - 1), 0.5 * turn ** 2 + 1e-6 + (1e-15 * size) / mean);
  });
}

/**
 * A chord must stay with the sheet that its ends lie on.
 *
 * @param {Context} context
 * @param {import('./reference.js').ImplicitReference} surface
 */
function checkSheets({ points, chords, normals, demand }, surface) {
  chords.forEach((chord, at) => {
    const middle = scale(add(points[at], points[at + 1]), 0.5);
    demand('sheet', at, norm(subtract(surface.project(middle), middle)), 0.35 * norm(chord));
    demand('sheet', at, -dot(normals[at], normals[at + 1]), -0.2);
  });
}

/**
 * The straight line in the parameters under each chord must not be much longer: else it goes around something that the chord cuts.
 *
 * @param {Context} context
 * @param {import('./reference.js').ParametricReference} surface
 */
function checkLifts({ places, chords, size, demand }, surface) {
  const samples = 16;
  chords.forEach((chord, at) => {
    let length = 0;
    let last = surface.position(places[at]);
    for (let i = 1; i <= samples; i++) {
      const next = surface.position(places[at].map((start, j) => start + (i / samples) * (places[at + 1][j] - start)));
      length += norm(subtract(next, last));
      last = next;
    }
    demand('lift', at, length, 2 * norm(chord) + 1e-13 * size);
  });
}
