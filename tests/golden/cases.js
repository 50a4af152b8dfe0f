/** What is solved for the golden hash: the gallery by every algorithm and start, metrics, traces, meshes, hostile surfaces. Runs in Node and in browsers alike. */
import { createRandom } from '../helpers/random.js';
import { addPath, BitHash } from './bits.js';

/** @typedef {typeof import('../../web/index.js')} Library */
/** @typedef {import('../../web/index.js').Surface} Surface */
/** @typedef {import('../helpers/random.js').Random} Random */
/** @typedef {{ solves: number, hash: string, groups: Record<string, string> }} Golden */
/** @typedef {{ algorithm: 'elements' | 'polyline' | 'paper', points: number, maxIterations: number }} StraightOptions */
/** A pair of points that the native build solves too. @typedef {{ from: number[], to: number[], options: StraightOptions }} StraightProblem */

const SEED = 20260;
/** Pairs a surface. */
export const PAIRS = { straight: 320, global: 14, trace: 40, metric: 120, hostile: 40 };
/** @type {StraightOptions['algorithm'][]} */
const ALGORITHMS = ['elements', 'polyline', 'polyline', 'paper'];

/** @type {Record<string, any>} */
const METRICS = {
  density: { kind: 'parametric', x: 'u', y: 'v', z: 'u*v', u: [-1, 1], v: [-1, 1], density: '1+2*exp(-4*(u^2+v^2))' },
  induced: { kind: 'parametric', x: 'u', y: 'v', z: '0', u: [-1, 1], v: [-1, 1], metric: { E: '1+v^2', F: 'u*v/4', G: '1+sin(u)^2' } },
  abstract: { kind: 'metric', E: '1/v^2', F: 0, G: '1/v^2', u: [-1, 1], v: [0.5, 2] },
  sphere: { kind: 'implicit', f: 'x^2+y^2+z^2-1', bounds: [-2, -2, -2].map((low) => [low, -low]), density: '1+x^2' },
  slit: { kind: 'parametric', x: 'sin(u)*cos(v)', y: 'sin(u)*sin(v)', z: 'cos(u)', u: [0, 3.1], v: [0, 6.2], density: '1+z^2/5' },
};
/** Not smooth, not finite, not there. @type {Record<string, any>} */
const HOSTILE = {
  nan: { kind: 'graph', z: 'sqrt(x)', x: [-1, 1], y: [-1, 1] },
  step: { kind: 'graph', z: 'floor(3*x)', x: [-1, 1], y: [-1, 1] },
  corner: { kind: 'graph', z: 'abs(x)+abs(y)', x: [-1, 1], y: [-1, 1] },
  pole: { kind: 'graph', z: '1/(x^2+y^2)', x: [-1, 1], y: [-1, 1] },
  wild: { kind: 'graph', z: 'sin(1/x)*tan(9*y)', x: [-1, 1], y: [-1, 1] },
  huge: { kind: 'graph', z: '1e150*x*y', x: [-1, 1], y: [-1, 1] },
  point: { kind: 'parametric', x: 0, y: 0, z: 0, u: [0, 1], v: [0, 1] },
  line: { kind: 'parametric', x: 'u', y: 'u', z: 'u', u: [0, 1], v: [0, 1] },
  empty: { kind: 'implicit', f: 'x^2+y^2+z^2+1', bounds: [-2, -2, -2].map((low) => [low, -low]) },
  cone: { kind: 'implicit', f: 'x^2+y^2-z^2', bounds: [-2, -2, -2].map((low) => [low, -low]) },
  negative: { kind: 'metric', E: 'u', F: 0, G: 'v', u: [-1, 1], v: [-1, 1] },
};

/** A source of points: uniform in the rectangle, or in the bounds, which is mostly off the surface, or among the mesh. @param {Surface} surface @param {any} definition @param {Random} random @returns {() => number[]} */
function pointSource(surface, definition, random) {
  const { domain } = surface;
  if (domain) return () => [random.between(domain.u[0], domain.u[1]), random.between(domain.v[0], domain.v[1])];
  const { positions } = surface.mesh({ resolution: 24 });
  if (positions.length === 0)
    return () => definition.bounds.map((/** @type {[number, number]} */ [low, high]) => random.between(low, high));
  return () => {
    const at = 3 * random.integer(positions.length / 3);
    return Array.from(positions.subarray(at, at + 3));
  };
}

/**
 * Problems with straight starts in which the library hands both ends to the solver as they are, and what comes of it back: less than half a period apart, by so much
 * that no path has to pass a pole.
 * @param {Surface} surface @param {any} definition @param {number} count
 * @returns {StraightProblem[]}
 */
export function straightProblems(surface, definition, count) {
  const random = createRandom(SEED);
  const point = pointSource(surface, definition, random);
  return Array.from({ length: count }, (_, i) => {
    const [from, far] = [point(), point()];
    const ranges = surface.domain ? [surface.domain.u, surface.domain.v] : [];
    const periodic = surface.domain ? [surface.domain.periodic.u, surface.domain.periodic.v] : [];
    const isNear = (/** @type {number} */ x, /** @type {number} */ j) =>
      !periodic[j] || Math.abs(x - from[j]) < 0.4 * (ranges[j][1] - ranges[j][0]);
    const to = far.map((x, j) => (isNear(x, j) ? x : from[j] + (x - from[j]) / 4));
    return { from, to, options: { algorithm: ALGORITHMS[i % 4], points: 1 + random.integer(48), maxIterations: i % 7 ? 100 : 2 } };
  });
}

/** The surfaces that a native build has too. @param {Record<string, any>} gallery */
export const nativeEntries = (gallery) => Object.entries(gallery).filter(([, { kind }]) => kind === 'parametric' || kind === 'implicit');

/** @param {Surface} surface @param {StraightProblem[]} problems @returns {string} */
export function solveStraight(surface, problems) {
  const hash = new BitHash();
  for (const { from, to, options } of problems) addPath(hash, surface.shortestPath(from, to, { ...options, start: 'straight' }));
  return String(hash);
}

/** @param {Surface} surface @param {any} definition @param {number} count @param {import('../../web/index.js').PathOptions} options */
function solvePairs(surface, definition, count, options) {
  const [hash, random] = [new BitHash(), createRandom(SEED + 1)];
  const point = pointSource(surface, definition, random);
  for (let i = 0; i < count; i++) addPath(hash, surface.shortestPath(point(), point(), { points: 9, record: i % 5 === 0, ...options }));
  return String(hash);
}

/** @param {Surface} surface @param {any} definition @param {number} count */
function traceMany(surface, definition, count) {
  const [hash, random] = [new BitHash(), createRandom(SEED + 2)];
  const point = pointSource(surface, definition, random);
  for (let i = 0; i < count; i++) {
    const from = point();
    const direction = from.map(() => random.between(-1, 1));
    addPath(hash, surface.trace(from, direction, random.between(0, 3), { points: 9 }));
  }
  return String(hash);
}

/** What is drawn. @param {Surface} surface */
function drawn(surface) {
  const hash = new BitHash();
  const { positions, normals, indices } = surface.mesh({ resolution: 12 });
  for (const numbers of [positions, normals, indices]) hash.addAll(numbers);
  return String(hash);
}

/**
 * Solves everything.
 * @param {Pick<Library, 'load'>} library @param {Record<string, any>} gallery @param {number} [share] of the pairs
 * @returns {Promise<Golden>}
 */
export async function runCases({ load }, gallery, share = 1) {
  const surfpath = await load();
  const count = (/** @type {keyof typeof PAIRS} */ name) => Math.ceil(share * PAIRS[name]);
  /** @type {Record<string, string>} */ const groups = {};
  let solves = 0;
  const note = (/** @type {string} */ name, /** @type {number} */ number, /** @type {string} */ hash) => {
    groups[name] = hash;
    solves += number;
  };
  for (const [name, definition] of Object.entries(gallery)) {
    const surface = surfpath.surface(definition);
    note(`${name} straight`, count('straight'), solveStraight(surface, straightProblems(surface, definition, count('straight'))));
    note(`${name} global`, count('global'), solvePairs(surface, definition, count('global'), {}));
    note(`${name} trace`, count('trace'), traceMany(surface, definition, count('trace')));
    note(`${name} mesh`, 0, drawn(surface));
    surface.dispose();
  }
  for (const [kind, definitions] of /** @type {const} */ ([
    ['metric', METRICS],
    ['hostile', HOSTILE],
  ]))
    for (const [name, definition] of Object.entries(definitions)) {
      const surface = surfpath.surface(definition);
      for (const algorithm of /** @type {const} */ (['elements', 'polyline', 'paper']))
        note(`${kind} ${name} ${algorithm}`, count(kind), solvePairs(surface, definition, count(kind), { algorithm, start: 'straight' }));
      note(`${kind} ${name} global`, count('global'), solvePairs(surface, definition, count('global'), {}));
      surface.dispose();
    }
  surfpath.dispose();
  const whole = new BitHash();
  for (const name of Object.keys(groups).sort())
    for (const digits of groups[name].match(/.{8}/g) ?? []) whole.add(Number.parseInt(digits, 16));
  return { solves, hash: String(whole), groups };
}
