/**
 * The geodesic curvature of a polyline on a surface: none, up to what its chords can tell.
 *
 * A polyline X_0 … X_K+1 of nearly equal chords h is one when its turn at each inner point, the difference d of the unit chords, is normal
 * to the surface: exactly so for a polyline of least energy. For points of a smooth geodesic the tangential part of d is a twelfth of that of d's
 * second difference, plus higher orders. So the limit follows from the polyline itself: twice that, plus |d|^3/8 for the higher orders, plus `tolerance`,
 * a geodesic curvature times the path's length. The tangential turn of any other curve falls like h, this limit like h^3. Points of a smooth geodesic
 * are judged fairly once no turn exceeds 1/4.
 */
import { add, cross, dot, norm, scale, subtract, unit } from './reference.js';

/** @typedef {import('./verify-path.js').Context} Context */
/** @typedef {import('./reference.js').Vector} Vector */

/**
 * Demands that no inner point is pulled sideways within the surface, except against an edge of the rectangle.
 *
 * @param {Context} context
 * @param {number} tolerance largest geodesic curvature times length that counts as none
 */
export function checkCurvature(context, tolerance) {
  const { surface, chords, normals, length, size, demand } = context;
  const turns = chords.slice(1).map((chord, i) => subtract(unit(chord), unit(chords[i])));
  const sideways = turns.map((_, i) => unit(cross(normals[i + 1], add(unit(chords[i]), unit(chords[i + 1])))));
  const lateral = turns.map((turn, i) => dot(turn, sideways[i]));
  turns.forEach((_, i) => {
    const change = largestTurn(turns, i) ** 3 / 8 + secondDifference(turns, i, sideways[i]) / 6;
    const chord = Math.min(norm(chords[i]), norm(chords[i + 1]));
    const limit = (tolerance * chord) / length + change + (8e-16 * size) / chord;
    const edges = surface.kind === 'parametric' ? edgesNear(context, surface, i + 1) : [];
    if (edges.length === 0) demand('curvature', i + 1, Math.abs(lateral[i]), limit);
    for (const { at, outward } of edges) {
      demand('edge', i + 1, -dot(scale(sideways[i], lateral[i]), outward), limit);
      if (at !== i + 1) demand('edge', i + 1, Math.abs(lateral[i]), Math.abs(lateral[at - 1] ?? 0) + limit);
    }
  });
}

/** @type {(turns: Vector[], index: number) => number} the largest turn at an index and beside it */
const largestTurn = (turns, index) => Math.max(...turns.slice(Math.max(0, index - 1), index + 2).map(norm));

/**
 * The largest of the three second differences of the turns nearest to an index, along a direction: one alone may happen to vanish.
 *
 * @param {Vector[]} turns fewer than three have none: 0
 * @param {number} index
 * @param {Vector} along
 */
function secondDifference(turns, index, along) {
  const first = Math.max(1, Math.min(index - 1, turns.length - 4));
  const middles = [first, first + 1, first + 2].filter((i) => i < turns.length - 1);
  return Math.max(0, ...middles.map((i) => Math.abs(dot(subtract(add(turns[i - 1], turns[i + 1]), scale(turns[i], 2)), along))));
}

/**
 * The edges of the rectangle that hold a point or, if there are none, a neighbour of it, with the direction in the surface that leads out
 * across them. A taut string may turn there, if only so that it presses outwards; its last free chord may already cover part of the edge.
 *
 * @param {Context} context
 * @param {import('./reference.js').ParametricReference} surface
 * @param {number} index
 * @returns {{ at: number, outward: Vector }[]}
 */
function edgesNear({ places }, surface, index) {
  const touching = (/** @type {number} */ at) => {
    if (at === 0 || at === places.length - 1) return [];
    return [0, 1].filter((i) => !surface.periodic[i] && surface.rectangle[i].includes(places[at][i])).map((i) => ({ at, i }));
  };
  const own = touching(index);
  const near = own.length > 0 ? own : [...touching(index - 1), ...touching(index + 1)];
  const tangents = surface.tangents(places[index]);
  return near.map(({ at, i }) => {
    const along = unit(tangents[1 - i]);
    const across = unit(subtract(tangents[i], scale(along, dot(tangents[i], along))));
    return { at, outward: places[at][i] === surface.rectangle[i][1] ? across : scale(across, -1) };
  });
}
