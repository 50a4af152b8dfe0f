/** What the page asks of the library, as tasks of plain data for a worker: meshes, paths, colours, series for plots. Knows nothing of the page. */

import { isNear, lengthOf } from './curves.js';
import { meshOf } from './drawable.js';
import { drawnOf } from './drawn.js';
import { legsOf } from './legs.js';
import { shade } from './shade.js';
import { severalStarts, startOf } from './starts.js';
import { study } from './study.js';
import { tracedPath } from './traced.js';

/** @typedef {import('surfpath').Surface} Surface */
/** @typedef {import('surfpath').Path} Path */
/** @typedef {import('../state/sketch.js').Sketch} Sketch */
/**
 * @typedef {object} Opened
 * @property {any} definition
 * @property {Surface} surface that measures
 * @property {Surface} drawn that has positions: the same, or for a metric the plane of its parameters
 */
/** @typedef {{ definition: any, ends: number[][], via: number[][], options: Pick<Sketch, 'task' | 'algorithm' | 'tolerance' | 'points' | 'start' | 'angle' | 'reach'> }} Question */
/**
 * @typedef {object} Solved
 * @property {Path[]} paths shortest first
 * @property {import('./legs.js').Leg[]} legs of the first path, where it passes points
 * @property {import('./starts.js').Start[]} starts the lines that several starts are; none where there is one start
 * @property {Float64Array[][]} films for each start, the iterates x y z … from it to the path; none where there is nothing to play
 * @property {Float64Array | null} straight the straight start, x y z …
 * @property {number} straightLength
 * @property {number} milliseconds that one such solve takes
 */

const MEASURE_FOR = 9;
const BATCH = 1.5;
/** What takes so long is not run again to be measured. */
const LONG = 500;
const MOST_GEODESICS = 12;
/** The straight line as such, without a step of the method: of so many points that its length does not depend on how many the path has. */
const LINE = /** @type {const} */ ({ algorithm: 'polyline', points: 1000, maxIterations: 0 });

export class Workshop {
  #surfpath;
  #key = '';
  /** @type {Opened | null} */ #opened = null;

  /** @param {import('surfpath').Surfpath} surfpath */
  constructor(surfpath) {
    this.#surfpath = surfpath;
  }

  /** @param {string} task @param {any} request @param {import('./slices.js').Job} job @returns {unknown} the result, or a promise of it */
  run(task, request, job) {
    const opened = this.#open(request.definition);
    const mesh = () => meshOf(opened, request.resolution, this.#surfpath);
    if (task === 'mesh') return mesh();
    if (task === 'open') {
      job.report({ mesh: mesh(), task: 'solve' });
      return request.isSolvable ? solve(opened, request) : null;
    }
    if (task === 'draft') return { mesh: mesh(), path: warmPath(opened, request) };
    if (task === 'solve') return solve(opened, request);
    if (task === 'shade') return shade(opened, request, job, this.#surfpath);
    if (task === 'study') return study(opened, request, job.report);
    throw new RangeError(`there is no task ${task}`);
  }

  /** The surface of a definition: the last one where only parameters differ. @param {any} definition */
  #open(definition) {
    const { parameters, ...rest } = definition;
    const key = JSON.stringify([rest, Object.keys(parameters ?? {})]);
    if (this.#opened && key === this.#key) {
      for (const one of new Set([this.#opened.surface, this.#opened.drawn])) one.set(parameters ?? {});
      this.#opened.definition = definition;
      return this.#opened;
    }
    this.#key = '';
    const surface = this.#surfpath.surface(definition);
    for (const old of [this.#opened?.surface, this.#opened?.drawn]) old?.dispose();
    this.#opened = null;
    this.#opened = { definition, surface, drawn: drawnOf(this.#surfpath, surface, definition) };
    this.#key = key;
    return this.#opened;
  }
}

/** @param {Question['options']} options */
const wanted = ({ algorithm, tolerance, points }) =>
  /** @type {import('surfpath').PairOptions} */ (algorithm === 'elements' ? { algorithm, tolerance, points } : { algorithm, points });

/** A path near an earlier one, while a slider moves. @param {Opened} opened @param {Question & { start?: Path }} question @returns {Path | null} */
function warmPath({ surface }, { ends, via, options, start }) {
  if (options.task === 'trace' || !start) return null;
  const from = via.length > 0 ? { via, start: /** @type {const} */ ('straight') } : { start };
  try {
    return surface.shortestPath(ends[0], ends[1], { points: options.points, tolerance: 1e-6, ...from });
  } catch {
    return null;
  }
}

/** @param {Opened} opened @param {Question} question @returns {Solved} */
function solve(opened, { ends, via, options }) {
  if (options.task === 'trace') return tracedPath(opened, ends[0], options);
  const { surface } = opened;
  const [from, to] = ends;
  const several = options.start === 'several' && options.task === 'path' && via.length === 0;
  const lines = several ? severalStarts(opened, from, to) : [];
  const starts = via.length > 0 ? [] : several ? lines : [/** @type {const} */ ('straight')];
  const start = options.start === 'several' ? /** @type {const} */ ('straight') : options.start;
  const asked = { ...wanted(options), ...(via.length > 0 ? { via } : {}), start };
  let taken = 0;
  const find = () => {
    const begin = performance.now();
    const path = surface.shortestPath(from, to, asked);
    taken = performance.now() - begin;
    return path;
  };
  const paths = several
    ? [shortest(starts.map((one) => surface.shortestPath(from, to, { ...asked, start: one })))]
    : options.task === 'all' && via.length === 0
      ? surface.geodesics(from, to, { ...wanted(options), start: 'global', max: MOST_GEODESICS })
      : [find()];
  if (paths.length === 0) paths.push(find());
  const films = starts.map((one) => iterates(opened, from, to, wanted(options), one)).filter((film) => film.length > 0);
  const straight = several ? null : (films[0]?.[0] ?? null);
  const line = straight && iterates(opened, from, to, LINE, 'straight')[0];
  return {
    paths,
    legs: via.length > 0 ? legsOf(opened, paths[0], [from, ...via, to], wanted(options)) : [],
    starts: lines.map((line) => startOf(opened, line)),
    films: several ? films : films.flatMap((film) => framesOf(paths[0], film)),
    straight,
    straightLength: line ? lengthOf(line) : NaN,
    milliseconds: taken > LONG ? taken : measure(find),
  };
}

/** @param {Path[]} paths */
const shortest = (paths) => paths.reduce((best, path) => (path.length < best.length || Number.isNaN(best.length) ? path : best));

/** The iterates, if they lead to the path, which takes the last one's place; else nothing. @param {Path} path @param {Float64Array[]} film */
function framesOf({ points }, film) {
  const last = /** @type {Float64Array} */ (film.at(-1));
  return isNear(last, points) ? [[...film.slice(0, -1), points]] : [];
}

/** How Newton's method moves a start to a path: the start, and what each step makes of it. @param {Opened} opened @param {number[]} from @param {number[]} to @param {import('surfpath').PairOptions} options @param {Float64Array | 'straight'} start */
function iterates({ surface }, from, to, options, start) {
  try {
    const { history } = surface.shortestPath(from, to, { ...options, start, record: true });
    return history.flatMap((iterate) => (iterate.points && iterate.points.length > 0 ? [iterate.points] : []));
  } catch {
    return [];
  }
}

/** The least mean time of a run in several batches, in milliseconds: a batch outlasts the grain of the browser's clock. @param {() => void} run */
function measure(run) {
  const end = performance.now() + MEASURE_FOR;
  let least = Infinity;
  do {
    const begin = performance.now();
    let [count, elapsed] = [0, 0];
    while (elapsed < BATCH) {
      run();
      count++;
      elapsed = performance.now() - begin;
    }
    least = Math.min(least, elapsed / count);
  } while (performance.now() < end);
  return least;
}
