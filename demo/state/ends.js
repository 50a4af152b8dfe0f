/** The ends of a path and the points on its way: what is wrong with them, and where to put them instead. */

import { coordinates } from './definition.js';
import { boxOf } from '../../web/view/origin.js';
import { diagonalOf, gap, isWithin } from '../../web/vector.js';

/** @typedef {import('surfpath').Surface} Surface */
/** @typedef {import('../compute/drawable.js').SurfaceMesh} SurfaceMesh */
/** @typedef {{ end: number, coordinate: number, message: string }} EndProblem end: A, B, then the points on the way; −1: none of them alone is at fault */

/** @typedef {'far' | 'near' | 'lost'} Why ends are moved: they are outside what is seen, one dot in it, or not on the surface */

/** In a direction that closes, as the library has it. */
const MOST_TURNS = 1e9;

/** Ends that are nearer to each other, in parts of the radius of what is seen, are one dot there. */
const DOT = 0.02;

/** What a point is called: A, B, then the points on the way by number. @param {number} index */
export const letterOf = (index) => (index < 2 ? 'AB'[index] : String(index - 1));

/** @param {number} index */
export const nameOf = (index) => (index < 2 ? letterOf(index) : `Point ${letterOf(index)}`);

/** @param {import('./kinds.js').Kind} kind @param {Surface} surface @param {number[][]} points A, B, then the points on the way @returns {EndProblem | null} */
export function findBadEnd(kind, { domain }, points) {
  for (const [end, point] of points.entries())
    for (const [coordinate, name] of coordinates(kind).entries()) {
      const axis = coordinate === 0 ? 'u' : 'v';
      const value = point[coordinate];
      if (!Number.isFinite(value)) return { end, coordinate, message: `${nameOf(end)} needs a number for ${name}, such as 0.5 or pi/2.` };
      if (!domain) continue;
      const range = domain[axis];
      const slack = (domain.periodic[axis] ? MOST_TURNS : 1e-12) * (range[1] - range[0]);
      if (value < range[0] - slack || value > range[1] + slack)
        return {
          end,
          coordinate,
          message: `${name} of ${nameOf(end)} must lie between ${shorten(range[0], range)} and ${shorten(range[1], range)}.`,
        };
    }
  return null;
}

/** A number of a range for the reader, and for an input: five digits after those that are the same in all of the range. @param {number} x @param {readonly number[]} range */
export function shorten(x, [low, high]) {
  const same = Math.max(Math.ceil(Math.log10(Math.abs(x) / (high - low))), 0);
  return String(Number(x.toPrecision(Math.min(5 + same, 17))));
}

/** From where to where each coordinate of a surface's points goes. @param {Surface} surface @param {any} definition of it @returns {number[][]} */
export const rangesOf = ({ domain }, { bounds }) => (domain ? [domain.u, domain.v] : bounds);

/** Share of its box's diagonal from which an implicit surface is too far from a point: the library's. */
const FAR = 0.1;

/**
 * A point as one of a surface: an implicit one is so near that it can be moved there, downhill. Null: it is not on the surface.
 * @param {Surface} drawn @param {any} definition of it @param {number[]} point
 */
export function onto(drawn, { bounds }, point) {
  if (drawn.kind !== 'implicit') return placeOf(drawn, point) && point;
  try {
    const place = drawn.project(point, point);
    return gap(place, point) <= FAR * diagonalOf(bounds.flat()) ? place : null;
  } catch {
    return null;
  }
}

/** Whether a point lies on a surface. @param {Surface} drawn @param {any} definition of it @param {number[]} point */
export const isOnSurface = (drawn, definition, point) => onto(drawn, definition, point) !== null;

/** Where a point of the surface lies in space; null if it lies nowhere. @param {Surface} drawn @param {number[]} point */
export function placeOf(drawn, point) {
  if (!point.every(Number.isFinite)) return null;
  const place = drawn.kind === 'implicit' ? point : Array.from(drawn.evaluate(point).subarray(0, 3));
  return place.every(Number.isFinite) ? place : null;
}

/**
 * Each end that is not on a surface, or not where it is seen, moved to the nearest vertex of its mesh; both to places at random, where there is no nearest, or they
 * would be one dot.
 * @param {import('./kinds.js').Kind} kind @param {{ surface: Surface, drawn: Surface, mesh: SurfaceMesh }} shown @param {any} definition @param {number[][]} ends
 * @param {number[][]} [seen] from and to along each axis
 */
export function mendEnds(kind, { surface, drawn, mesh }, definition, ends, seen = []) {
  const isGood = (/** @type {number[]} */ end) => {
    if (findBadEnd(kind, surface, [end]) || !isOnSurface(drawn, definition, end)) return false;
    return isWithin(placeOf(drawn, end) ?? [], seen);
  };
  const [from, to] = ends.map((end) => (isGood(end) ? end : nearestVertex(surface, mesh, end, isGood)));
  if (!from || !to || areOneDot(drawn, mesh, [from, to], seen)) return chooseEnds(surface, mesh, seen);
  return [from, to];
}

/** Half the diagonal of what is seen of a surface. @param {SurfaceMesh} mesh @param {number[][]} seen from and to along each axis */
export function radiusOf({ positions }, seen) {
  const isWhole = !seen.flat().some(Number.isFinite);
  return boxOf(isWhole ? positions : positions.filter((_, i) => isWithin(positions.subarray(i - (i % 3)), seen))).radius;
}

/** Whether ends are one dot in the view; not, where one has no place. @param {Surface} drawn @param {SurfaceMesh} mesh @param {number[][]} ends @param {number[][]} seen from and to along each axis */
export function areOneDot(drawn, mesh, ends, seen) {
  const [from, to] = ends.map((end) => placeOf(drawn, end) ?? []);
  return gap(from, to) < DOT * radiusOf(mesh, seen);
}

/** @param {Surface} surface @param {SurfaceMesh} mesh @param {number[]} point @param {(vertex: number[]) => boolean} isGood */
function nearestVertex(surface, mesh, point, isGood) {
  const [dimension, places] = coordinatesOf(surface, mesh);
  /** @type {number[] | null} */ let nearest = null;
  let least = Infinity;
  for (const vertex of mesh.indices) {
    let distance = 0;
    for (let k = 0; k < dimension; k++) distance += (places[dimension * vertex + k] - point[k]) ** 2;
    if (!(distance < least)) continue;
    const candidate = pointAt(surface, mesh, vertex);
    if (isGood(candidate)) [nearest, least] = [candidate, distance];
  }
  return nearest;
}

/** That ends were moved by the page; null: none was. @param {number[][]} before @param {number[][]} now @param {Why} [why] */
export function describeMoved(before, now, why = 'lost') {
  const names = now.flatMap((end, i) => (end.every((x, k) => x === before[i][k]) ? [] : [letterOf(i)]));
  if (names.length === 0) return null;
  const [they, were] = names.length > 1 ? ['they', 'were'] : ['it', 'was'];
  const reasons = {
    far: ` to where the surface is seen: ${they} lay far outside.`,
    near: ' apart: they were one dot.',
    lost: `: there is no surface where ${they} ${were}.`,
  };
  return `${names.join(' and ')} ${were} moved${reasons[why]}`;
}

/** Whether an end lies where it cannot be seen. @param {number[][]} places of the ends @param {number[][]} seen from and to along each axis */
export const areFar = (places, seen) => !places.every((place) => isWithin(place, seen));

/** That an end cannot be seen; null: all can. @param {number[][]} places of the ends @param {number[][]} seen from and to along each axis */
export const describeFar = (places, seen) => (areFar(places, seen) ? 'An end lies far outside what is seen: change it.' : null);

/**
 * Two points of the surface at random, not too near to each other, that a path was found between, unless twenty pairs have none.
 * @param {Surface} surface @param {SurfaceMesh} mesh @param {number[][]} [seen] from and to along each axis
 * @returns {number[][]}
 */
export function chooseEnds(surface, mesh, seen = []) {
  const inside = mesh.indices.filter((i) => isWithin(placeAt(mesh, i), seen));
  // What is seen may be narrower than its rounding to 32 bits.
  const vertices = inside.length > 0 ? inside : mesh.indices;
  let ends = randomPair(surface, mesh, vertices);
  for (let i = 0; i < 20 && !isJoined(surface, ends); i++) ends = randomPair(surface, mesh, vertices);
  return ends;
}

/** @param {SurfaceMesh} mesh @param {number} vertex */
const placeAt = ({ positions }, vertex) => positions.subarray(3 * vertex, 3 * vertex + 3);

/** @param {Surface} surface @param {number[][]} ends */
function isJoined(surface, ends) {
  try {
    return surface.shortestPath(ends[0], ends[1], { points: 16, algorithm: 'polyline', start: 'straight' }).converged;
  } catch {
    return false;
  }
}

/** The farthest but one of six random pairs. @param {Surface} surface @param {SurfaceMesh} mesh @param {Uint32Array} vertices to choose from */
function randomPair(surface, mesh, vertices) {
  const pick = () => vertices[Math.floor(Math.random() * vertices.length)];
  const apart = (/** @type {number[]} */ [a, b]) => gap(placeAt(mesh, a), placeAt(mesh, b));
  const pairs = Array.from({ length: 6 }, () => [pick(), pick()]).sort((one, other) => apart(one) - apart(other));
  return pairs[4].map((vertex) => pointAt(surface, mesh, vertex));
}

/** What points of a surface are given by, of each vertex, and how many numbers these are. @param {Surface} surface @param {SurfaceMesh} mesh @returns {[number, Float64Array]} */
const coordinatesOf = ({ domain }, { parameters, positions }) => (domain && parameters ? [2, parameters] : [3, positions]);

/** A vertex as a point of the surface, in few digits: thousandths, or of what is small, less. @param {Surface} surface @param {SurfaceMesh} mesh @param {number} vertex */
function pointAt(surface, mesh, vertex) {
  const [dimension, places] = coordinatesOf(surface, mesh);
  const { domain } = surface;
  const size = domain ? Math.min(...[domain.u, domain.v].map(([low, high]) => high - low)) : boxOf(mesh.positions).radius;
  const whole = 10 ** (3 + Math.max(-Math.floor(Math.log10(size)), 0));
  return Array.from(places.subarray(dimension * vertex, dimension * (vertex + 1)), (x) => Math.trunc(whole * x) / whole);
}
