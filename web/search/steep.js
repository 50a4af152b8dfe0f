/**
 * The shortest path on a steep surface: a net of its lines of equal height shows ways that no other graph sees; and what is found with lower heights is raised. MATH.md, "Steep surfaces".
 */

import { isGeodesic, mostOf, stalled } from '../path.js';
import { sumOf } from '../vector.js';
import { compared, ELEMENTS, isCompared, within } from './candidates.js';
import { domainOf } from './infinite-ends.js';
import { inOrder, reverse } from './join.js';
import { LevelNet } from './level-ways.js';
import { makeLevels } from './levels.js';
import { findRaised } from './raised.js';
import { ROUGHLY } from './rough.js';
import { drawLine, solveNear } from './routes.js';

/** @typedef {import('../path.js').Path} Path */
/** @typedef {import('./routes.js').Field} Field */
/** @typedef {import('../runtime/heap.js').SolveOptions} SolveOptions */

/** @typedef {{ path: Path, start: Float64Array }} Followed a path, and a line from which elements come to it */

/** @type {Path['status']} */
const STALLED = 'stalled';
/** From this root mean square of its slopes on a surface is steep. */
const STEEP = 5;
/** Who allows fewer steps wants to know where they end. */
const LEAST_STEPS = 100;
/** So many ways are followed that the net has for no longer than the shortest path by this factor. */
const [MOST, LONGER] = [2, 1.1];
/** Points that a way is drawn in, and chords and steps by which it is relaxed: elements cannot turn as often as it does. What does not come to rest then is relaxed again. */
const [POINTS, RELAXED] = [
  8192,
  [
    [8191, 60],
    [16383, 120],
  ],
];
/** What elements do not come to in so many steps they seldom do in more. */
const FINE = 200;
/** A line that leads to no path is shorter than one if it is so by this part. */
const ROUGH = 1e-3;
/** Steps that put points of a way where the surface is as high, and how far they may lead, in parts of the range. */
const [SETTLING, FARTHEST] = [4, 0.02];

/**
 * A way in many points on the surface, each as high as it is between those of the way.
 * @param {Field} field @param {Float64Array} way u, v and height of its points
 */
function draw({ domain, jets }, way) {
  const { lower, upper } = /** @type {import('../manifold/domain.js').Domain} */ (domain);
  const parts = Math.ceil(POINTS / (way.length / 3 - 1));
  const count = (way.length / 3 - 1) * parts;
  const line = new Float64Array(2 * (count + 1));
  const heights = new Float64Array(count);
  for (let i = 0; i < count; i++) {
    const [k, t] = [3 * Math.floor(i / parts), (i % parts) / parts];
    for (let j = 0; j < 2; j++) line[2 * i + j] = way[k + j] + t * (way[k + 3 + j] - way[k + j]);
    heights[i] = way[k + 2] + t * (way[k + 5] - way[k + 2]);
  }
  line.set(way.subarray(-3, -1), 2 * count);
  const drawn = line.slice();
  for (let step = 0; step < SETTLING; step++) {
    const at = jets(line);
    for (let i = 1; i < count; i++) {
      const [zu, zv] = [at[18 * i + 5], at[18 * i + 8]];
      const factor = (heights[i] - at[18 * i + 2]) / (zu * zu + zv * zv);
      const u = Math.min(Math.max(line[2 * i] + factor * zu, lower[0]), upper[0]);
      const v = Math.min(Math.max(line[2 * i + 1] + factor * zv, lower[1]), upper[1]);
      const isNear =
        Math.abs(u - drawn[2 * i]) < FARTHEST * (upper[0] - lower[0]) && Math.abs(v - drawn[2 * i + 1]) < FARTHEST * (upper[1] - lower[1]);
      line[2 * i] = isNear ? u : drawn[2 * i];
      line[2 * i + 1] = isNear ? v : drawn[2 * i + 1];
    }
  }
  return line;
}

/**
 * The path that a line leads to: one that holds, as others can be compared with, or else the line as far as it was relaxed.
 * @param {Field} field @param {number[][]} ends @param {SolveOptions} options @param {Float64Array} line
 * @returns {Followed}
 */
function follow(field, ends, options, line) {
  let [start, lengthError] = [line, Infinity];
  for (const [points, maxIterations] of RELAXED) {
    const rough = solveNear(field, ends, { ...ROUGHLY, points, maxIterations }, start);
    if (!rough.parameters) break;
    /* Chords that stall have jumped over what they are too long for. */
    if (rough.status === STALLED) continue;
    ({ parameters: start, lengthError } = rough);
    const path = solveNear(field, ends, within(compared(options), FINE), start);
    if (isGeodesic(path)) return { path, start };
  }
  const length = sumOf(field.chords?.(start) ?? []);
  const path = { ...stalled(drawLine(field, ends, start, options.points)), length };
  return { path: { ...path, lengthError: Math.min(lengthError, (LONGER - 1) * length) }, start };
}

/**
 * The shortest of a known path and those near ways that the net has, as they can be compared.
 * @param {Field} field @param {LevelNet} net @param {number[][]} ends @param {SolveOptions} options @param {Followed | null} known
 */
function followWays(field, net, ends, options, known) {
  let shortest = known;
  if (known) net.avoid(known.start, 2);
  for (let i = 0; i < MOST; i++) {
    const way = net.find(LONGER * (shortest?.path.length ?? Infinity));
    if (!way) break;
    net.avoid(way, 3);
    const found = follow(field, ends, options, draw(field, way));
    net.avoid(found.start, 2);
    const least = isGeodesic(found.path) ? found.path.length : found.path.length * (1 + ROUGH);
    if (!shortest || least < shortest.path.length) shortest = found;
  }
  return shortest;
}

/** @param {Field} field @param {SolveOptions} options */
function steepOf({ positions, lowered }, { algorithm, maxIterations }) {
  return (positions && algorithm === ELEMENTS && maxIterations >= LEAST_STEPS && lowered?.()) || null;
}

/** Whether a net tells ways over a surface. @param {Field} field @param {SolveOptions} options */
export function hasNet(field, options) {
  const steep = steepOf(field, options);
  return !!steep && steep.steepness >= STEEP && !domainOf(field).periodic.includes(true);
}

/** Whether a line that leads to no path is no longer than what a whole search found. @param {Path} line @param {Path} path */
export const isNoLonger = (line, path) => path.status === STALLED || line.length * (isGeodesic(path) ? 1 + ROUGH : 1) <= mostOf(path);

/**
 * The path that is the shortest where the surface is steep, as far as can be told; the given one where it is not, where geodesics are unique, or nothing better is found. Exchanged ends reverse it.
 * @param {Field} field @param {number[][]} ends @param {SolveOptions} options @param {Path} path as other searches found it @returns {Path}
 */
export function findSteep(field, ends, options, path) {
  const steep = steepOf(field, options);
  const isOnly = () => isGeodesic(path) && field.run((heap, record) => field.graphs.find(heap, record, field, 0)?.unique);
  if (!steep || isOnly()) return path;
  const find = (/** @type {number[][]} */ both, /** @type {boolean} */ isTurned) =>
    findForwards(steep, field, both, options, isTurned ? reverse(path) : path);
  return inOrder(domainOf(field), ends, find) ?? path;
}

/** As {@link findSteep}, in this order; null: nothing better. @param {import('./raised.js').Lowered} steep @param {Field} field @param {number[][]} ends @param {SolveOptions} options @param {Path} path */
function findForwards(steep, field, ends, options, path) {
  const { positions, jets } = field;
  const domain = domainOf(field);
  const known = isGeodesic(path) && path.parameters ? { path, start: path.parameters } : null;
  const levels = hasNet(field, options) ? makeLevels(/** @type {import('./levels.js').Positions} */ (positions), jets, domain, ends) : null;
  const found = levels ? followWays(field, new LevelNet(levels), ends, options, known) : known;
  if (found && found === known) return null;
  if (found && isGeodesic(found.path)) return isCompared(options) ? found.path : solveNear(field, ends, options, found.start);
  const most = found ? found.path.length * (1 + ROUGH) : Infinity;
  const raised = known ? null : findRaised(steep, field, ends, options, most);
  const best = raised?.converged ? raised : found?.path;
  return best && (known || isNoLonger(best, path)) ? best : null;
}
