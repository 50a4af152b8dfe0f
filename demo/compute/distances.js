/**
 * Distances from a point to all vertices of a mesh, each that of a path: polylines, every one begun from that of a neighbour that is nearer to the point.
 * Smooth, so that contours are, where a search of the graph has steps of half a per cent; and much quicker than a search for each.
 */

import { liftNear, turnOn } from '../state/lifts.js';

/** @typedef {import('surfpath').Surface} Surface */
/** @typedef {import('surfpath').Path} Path */
/** @typedef {import('./drawable.js').SurfaceMesh} SurfaceMesh */
/** @typedef {{ path: Path, direction: number[] }} Reached direction: unit, in which the path leaves the point */

/** Inner points of a polyline; more where so few would leave the surface, or bend with it too roughly. */
const POINTS = [24, 96];
/** An error of a larger share of the length is not known to a tenth. */
const ROUGH = 5e-3;
/** Cosine of the angle from which two neighbours' paths may be of different ways around something: then both are tried. */
const APART = 0.97;
const MOST_STARTS = 2;
/** A path that is so much longer than the graph's way has lost the shortest one on the way from vertex to vertex: it is searched for. */
const LOST = 1.002;
/** So much too short may the graph's way be, of waves: of a longer path nothing is known but that it is not the shortest. */
const BEYOND = 1.05;
/** A search takes as long as a thousand polylines; one in vain, as where a density jumps, as long as so many. */
const [MOST_SEARCHES, IN_VAIN] = [100, 20];
/** Distance of vertices that are one point, in parts of the coordinates' size: rounding leaves that of a pole. */
const SAME = 1e-12;
/** Parts of a range into which coordinates are rounded to be compared. */
const SHARES = 1e6;

/**
 * @param {Surface} surface @param {number[]} from @param {SurfaceMesh} mesh
 * @param {ArrayLike<number>} rough distances a vertex, of which the order counts; where one is not finite there is no path
 * @returns {Generator<number, Float64Array>} share that is done, in [0, 1], after every vertex; at last the distances
 */
export function* measureDistances(surface, from, mesh, rough) {
  const distances = Float64Array.from(rough);
  const places = surface.domain && mesh.parameters ? mesh.parameters : mesh.positions;
  const twins = findTwins(surface, mesh);
  const neighbours = findNeighbours(mesh, twins);
  const order = [...twins.keys()].filter((i) => twins[i] === i && Number.isFinite(rough[i])).sort((i, j) => rough[i] - rough[j]);
  /** @type {(Reached | undefined)[]} */ const reached = [];
  let searches = 0;
  for (const [count, i] of order.entries()) {
    const to = Array.from(places.subarray(from.length * i, from.length * (i + 1)));
    const starts = chooseStarts([...neighbours[i]], reached, (j) => distances[j] + chord(mesh, i, j));
    let path = count > 0 ? follow(surface, from, to, starts) : solve(surface, from, to, 'straight');
    const isLost = count > 0 && !(path && lengthOf(path) <= LOST * rough[i]);
    if (isLost && searches < MOST_SEARCHES) {
      path = shorter(path, solve(surface, from, to, 'global'));
      searches += mayBeShortest(path, rough[i]) ? 1 : IN_VAIN;
    }
    if (path && mayBeShortest(path, rough[i])) {
      distances[i] = lengthOf(path);
      reached[i] = { path, direction: directionOf(path) };
    }
    yield count / order.length;
  }
  return distances.map((_, i) => distances[twins[i]]);
}

/** @param {SurfaceMesh} mesh @param {number} i @param {number} j */
const chord = ({ positions }, i, j) => Math.hypot(...[0, 1, 2].map((k) => positions[3 * i + k] - positions[3 * j + k]));

/** Where in its range a coordinate lies, rounded. @param {number} x @param {[number, number]} range @param {boolean} isRound the ends are the same */
function shareOf(x, [low, high], isRound) {
  const share = Math.round((SHARES * (x - low)) / (high - low));
  return isRound ? (share + SHARES) % SHARES : share;
}

/**
 * Vertices that are one point of the surface, for each the first of them: the two sides of a seam, and the corners of a triangle at a pole.
 * @param {Surface} surface @param {SurfaceMesh} mesh
 */
function findTwins({ domain }, mesh) {
  const { parameters, positions, indices } = mesh;
  const twins = Uint32Array.from({ length: positions.length / 3 }, (_, i) => i);
  if (!domain || !parameters) return twins;
  const { u, v, periodic } = domain;
  const size = positions.reduce((most, x) => Math.max(most, Math.abs(x)), 0);
  /** @type {Map<string, number>} */ const first = new Map();
  for (const i of twins.keys()) {
    const [a, b] = parameters.subarray(2 * i, 2 * i + 2);
    let place = [a, b];
    if (periodic.u && a === u[1]) place = turnOn(domain, place, 0, -1);
    if (periodic.v && b === v[1]) place = turnOn(domain, place, 1, -1);
    const key = `${shareOf(place[0], u, periodic.u)} ${shareOf(place[1], v, periodic.v)}`;
    twins[i] = first.get(key) ?? i;
    if (!first.has(key)) first.set(key, i);
  }
  for (let i = 0; i < indices.length; i++) {
    const [one, other] = [indices[i], indices[i % 3 === 2 ? i - 2 : i + 1]].map((vertex) => twins[vertex]).sort((a, b) => a - b);
    if (one !== other && chord(mesh, one, other) <= SAME * size) twins[other] = one;
  }
  return twins.map((i) => twins[i]);
}

/** @param {SurfaceMesh} mesh @param {Uint32Array} twins @returns {Set<number>[]} by vertex; of twins, the first has all */
function findNeighbours({ indices }, twins) {
  const neighbours = Array.from(twins, () => /** @type {Set<number>} */ (new Set()));
  for (let i = 0; i < indices.length; i++) {
    const [one, other] = [twins[indices[i]], twins[indices[i % 3 === 2 ? i - 2 : i + 1]]];
    neighbours[one].add(other);
    neighbours[other].add(one);
  }
  return neighbours;
}

/**
 * Paths to begin from: that of the neighbour over which the way is shortest, and the next one that leaves the point in quite another direction.
 * @param {number[]} neighbours @param {(Reached | undefined)[]} reached @param {(vertex: number) => number} cost
 * @returns {Path[]}
 */
function chooseStarts(neighbours, reached, cost) {
  /** @type {Reached[]} */ const chosen = [];
  const costs = neighbours.filter((j) => reached[j]).map((j) => ({ j, cost: cost(j) }));
  for (const { j } of costs.sort((a, b) => a.cost - b.cost)) {
    const next = /** @type {Reached} */ (reached[j]);
    const isNew = chosen.every(({ direction }) => direction.reduce((sum, x, k) => sum + x * next.direction[k], 0) < APART);
    if (isNew && chosen.push(next) === MOST_STARTS) break;
  }
  return chosen.map(({ path }) => path);
}

/** The shortest of what neighbours' paths lead to. @param {Surface} surface @param {number[]} from @param {number[]} to @param {Path[]} starts */
function follow(surface, from, to, starts) {
  /** @type {Path | null} */ let best = null;
  for (const start of starts) best = shorter(best, solve(surface, from, besideEnd(surface, to, start), start));
  return best;
}

/** A sum of chords is too short; with the estimate of its error it is the length of the curve. @param {Path} path */
const lengthOf = ({ length, lengthError }) => length + lengthError;

/** Whether the graph's way does not tell otherwise. @param {Path | null} path @param {number} way */
const mayBeShortest = (path, way) => path !== null && lengthOf(path) <= (path.converged ? BEYOND : LOST) * way;

/** @param {Path | null} one @param {Path | null} other */
const shorter = (one, other) => (one && !(other && lengthOf(other) < lengthOf(one)) ? one : other);

/** @param {Surface} surface @param {number[]} from @param {number[]} to @param {Path | 'straight' | 'global'} start @returns {Path | null} */
function solve(surface, from, to, start) {
  /** @type {Path | null} */ let found = null;
  for (const points of POINTS) {
    const path = surface.shortestPath(from, to, { start, algorithm: 'polyline', points });
    if (Number.isFinite(path.length)) found = path;
    if (path.lengthError <= ROUGH * path.length) break;
  }
  return found;
}

/** A point moved by whole turns to where a path to its surroundings ends. @param {Surface} surface @param {number[]} to @param {Path} path */
function besideEnd({ domain }, to, { parameters }) {
  return domain && parameters ? liftNear(domain, to, parameters.subarray(-2)) : to;
}

/** @param {Path} path */
function directionOf({ points }) {
  const step = [0, 1, 2].map((k) => points[3 + k] - points[k]);
  const size = Math.hypot(...step) || 1;
  return step.map((x) => x / size);
}
