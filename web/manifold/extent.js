/** Where in a box an implicit surface lies, and how far it extends along its own axes: told by points of it, to which Newton's steps lead from a grid. Knows no paths. */

import { diagonalOf, dot, gap } from '../vector.js';

/**
 * @typedef {object} Extent
 * @property {number[][]} axes three unit vectors, at right angles to each other
 * @property {number[]} middle x y z
 * @property {number[]} half how far the surface reaches from the middle along each axis, both ways, as far as points tell; never zero
 * @property {number[]} margin by so much more at most, as points lie so far apart
 */

/** Points a direction from which steps begin; in so many they come to the surface, where a body is as thin as a thousandth of a cell, too. */
const [GRID, STEPS] = [24, 14];
/** A step leads no farther than so many cells from where the first began, and is none any more below this part of one. */
const [FARTHEST, AT_REST] = [1.5, 1e-5];
/** Fewer points do not tell an extent. */
const LEAST = 24;
/** Along its shortest axis a surface is taken for as thick as this part of the longest, at least. */
const THINNEST = 1e-3;
/** Axes of their own are taken where along them a body is thinner than along those of space by this part. */
const OBLIQUE = 0.7;
/** Sweeps of Jacobi's rotations: three matrices of three converge in fewer. */
const SWEEPS = 8;
const SPACE = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];

/** Middles of so many cells a direction of a box, by x, then by y, then by z. @param {number[]} box @param {number} cells */
export function gridOf(box, cells) {
  const places = new Float64Array(3 * cells ** 3);
  const [xs, ys, zs] = [0, 2, 4].map((j) => Array.from({ length: cells }, (_, i) => box[j] + ((i + 0.5) / cells) * (box[j + 1] - box[j])));
  let k = 0;
  for (const x of xs) for (const y of ys) for (const z of zs) places.set([x, y, z], 3 * k++);
  return places;
}

/** A point on its way to the surface: by `by` at the next step. @typedef {{ from: number[], at: number[], by: number[] }} Walk */

/** Newton's step to f = 0. @param {number} f @param {number} x @param {number} y @param {number} z f and its derivatives */
export function stepBy(f, x, y, z) {
  const factor = f / (x * x + y * y + z * z);
  return [factor * x, factor * y, factor * z];
}

/**
 * Points of the surface near those of a grid.
 * @param {(places: ArrayLike<number>) => Float64Array} values f and ∇f @param {number[]} box @returns {number[][]}
 */
function pointsOf(values, box) {
  const cell = diagonalOf(box) / GRID;
  const grid = gridOf(box, GRID);
  const seen = values(grid);
  /** @type {Walk[]} */
  let walks = [];
  for (let i = 0; i < GRID ** 3; i++) {
    const [f, x, y, z] = [seen[4 * i], seen[4 * i + 1], seen[4 * i + 2], seen[4 * i + 3]];
    if (!(f * f <= cell * cell * (x * x + y * y + z * z))) continue;
    const from = [grid[3 * i], grid[3 * i + 1], grid[3 * i + 2]];
    walks.push({ from, at: from, by: stepBy(f, x, y, z) });
  }
  /** @type {number[][]} */
  const found = [];
  for (let k = 0; k < STEPS && walks.length > 0; k++) {
    for (const walk of walks) walk.at = walk.at.map((x, j) => x - walk.by[j]);
    const own = values(walks.flatMap(({ at }) => at));
    walks = walks.filter((walk, i) => {
      walk.by = stepBy(own[4 * i], own[4 * i + 1], own[4 * i + 2], own[4 * i + 3]);
      const isAtRest = dot(walk.by, walk.by) <= (AT_REST * cell) ** 2;
      if (isAtRest) found.push(walk.at);
      return !isAtRest && gap(walk.at, walk.from) <= FARTHEST * cell;
    });
  }
  return found.filter((at) => at.every((x, j) => x >= box[2 * j] && x <= box[2 * j + 1]));
}

/** Axes of a cloud of points: the eigenvectors of its second moments. @param {number[][]} points @returns {number[][]} */
function axesOf(points) {
  const mean = [0, 1, 2].map((j) => points.reduce((sum, at) => sum + at[j], 0) / points.length);
  const moments = SPACE.map(() => [0, 0, 0]);
  for (const at of points) for (const a of [0, 1, 2]) for (const b of [0, 1, 2]) moments[a][b] += (at[a] - mean[a]) * (at[b] - mean[b]);
  let axes = SPACE;
  for (let k = 0; k < 3 * SWEEPS; k++) {
    const [a, b] = [k % 3, (k + 1) % 3];
    const mixed = momentOf(moments, axes[a], axes[b]);
    const apart = (momentOf(moments, axes[b], axes[b]) - momentOf(moments, axes[a], axes[a])) / (2 * mixed);
    if (!Number.isFinite(apart)) continue;
    const tangent = Math.sign(apart || 1) / (Math.abs(apart) + Math.sqrt(apart * apart + 1));
    const cosine = 1 / Math.sqrt(tangent * tangent + 1);
    const turn = (/** @type {number} */ i, /** @type {number} */ j, /** @type {number} */ by) =>
      axes[i].map((x, c) => cosine * (x + by * axes[j][c]));
    const turned = [turn(a, b, -tangent), turn(b, a, tangent)];
    axes = axes.map((axis, i) => (i === a ? turned[0] : i === b ? turned[1] : axis));
  }
  return axes;
}

/** @param {number[][]} moments @param {number[]} a @param {number[]} b */
const momentOf = (moments, a, b) =>
  dot(
    a,
    moments.map((row) => dot(row, b)),
  );

/** @param {number[][]} points @param {number[][]} axes @param {number[]} cells of the grid along the axes of space @returns {Extent} */
function extentAlong(points, axes, cells) {
  const ranges = axes.map((axis) => {
    const along = points.map((at) => dot(axis, at));
    return [along.reduce((a, b) => Math.min(a, b)), along.reduce((a, b) => Math.max(a, b))];
  });
  const most = Math.max(...ranges.map(([low, high]) => high - low)) / 2;
  const half = ranges.map(([low, high]) => Math.max((high - low) / 2, THINNEST * most));
  const centre = ranges.map(([low, high]) => (low + high) / 2);
  return {
    axes,
    half,
    middle: [0, 1, 2].map((j) => axes.reduce((sum, axis, i) => sum + axis[j] * centre[i], 0)),
    margin: axes.map((axis, i) =>
      Math.min(
        axis.reduce((sum, x, j) => sum + Math.abs(x) * cells[j], 0),
        half[i] / 2,
      ),
    ),
  };
}

/** From where to where the surface may reach along each axis of space. @param {Extent} extent */
const rangesOf = ({ axes, middle, half, margin }) =>
  middle.map((x, j) => {
    const reach = axes.reduce((sum, axis, i) => sum + Math.abs(axis[j]) * (half[i] + margin[i]), 0);
    return [x - reach, x + reach];
  });

/** The part of some bounds that holds all of it. @param {Extent} extent @param {number[]} box */
export const boxOf = (extent, box) =>
  rangesOf(extent).flatMap(([low, high], j) => [Math.max(low, box[2 * j]), Math.min(high, box[2 * j + 1])]);

/**
 * Whether some places lie on a face of a box, where a surface is cut.
 * @param {ArrayLike<number>} places @param {ArrayLike<number> | null} box @param {number[] | null} except what lies on the faces of this one counts for nothing
 */
export function touches(places, box, except) {
  if (!box) return false;
  for (let i = 0; i < places.length; i++)
    for (let side = 2 * (i % 3); side < 2 * (i % 3) + 2; side++) if (places[i] === box[side] && except?.[side] !== box[side]) return true;
  return false;
}

/** Whether a surface comes so near to a face of its box that it may go on beyond. @param {Extent} extent @param {number[]} box */
export const isCut = (extent, box) => rangesOf(extent).some(([low, high], j) => low < box[2 * j] || high > box[2 * j + 1]);

/**
 * Whether a surface goes on beyond a box, as f changes its sign between places of the grid next to the faces: which takes a twentieth of the time of an extent.
 * @param {(places: ArrayLike<number>) => Float64Array} values f and ∇f @param {number[]} box
 */
export function isCrossed(values, box) {
  const isOuter = (/** @type {number} */ i) => [1, GRID, GRID ** 2].some((row) => [0, GRID - 1].includes(Math.floor(i / row) % GRID));
  const seen = values(gridOf(box, GRID)).filter((_, k) => k % 4 === 0 && isOuter(k / 4));
  return seen.some((f) => f < 0) && seen.some((f) => f > 0);
}

/** How much longer than thick a body is. @param {Extent} extent */
export const flatnessOf = ({ half }) => Math.max(...half) / Math.min(...half);

/**
 * The extent of what a box holds of an implicit surface: along the axes of space or, where it is much thinner along others, along these.
 * @param {(places: ArrayLike<number>) => Float64Array} values f and ∇f, four numbers a place @param {number[]} box
 * @returns {Extent | null} null: there is too little of it
 */
export function findExtent(values, box) {
  const points = pointsOf(values, box);
  if (points.length < LEAST) return null;
  const cells = [0, 2, 4].map((j) => (box[j + 1] - box[j]) / GRID);
  const straight = extentAlong(points, SPACE, cells);
  const oblique = extentAlong(points, axesOf(points), cells);
  return flatnessOf(straight) < OBLIQUE * flatnessOf(oblique) ? oblique : straight;
}
