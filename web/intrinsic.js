/**
 * Paths from place to place as they are answered: by positions in space or, where these lead astray, by E, F and G. Chords see only what is between their ends in
 * space: where sheets cross or lie close to each other they jump over, and nothing leads back. Over u and v alone there is no other sheet. MATH.md, "Intrinsic paths".
 */

import { findAtPole, poleBeside, polesOf, withPoles } from './creases/at-poles.js';
import { findCreased } from './creases/creased.js';
import { GAUSS } from './gauss.js';
import { vector } from './manifold/rectangle.js';
import { isGeodesic, mostOf } from './path.js';
import { findAllByPieces, findByPieces } from './pieces/pieces.js';
import { compared, ELEMENTS, isCompared } from './search/candidates.js';
import { findFromInfinite } from './search/infinite-ends.js';
import { replaced } from './search/join.js';
import { findSteep, hasNet, isNoLonger } from './search/steep.js';
import { settleEnd } from './search/routes.js';
import { findFromStill } from './search/still-ends.js';
import { gap, largest, norm } from './vector.js';

/** @typedef {import('./path.js').Path} Path */
/** @typedef {import('./search/routes.js').Field} Field */
/** @typedef {import('./runtime/heap.js').SolveOptions} SolveOptions */

/** Steps of Newton across creases, and by E, F and G under a density, after which no more is tried; who allows fewer altogether wants to know where they end. */
const STEPS = 100;
/** Statuses of paths that may be none because of how they were measured; under a density or a metric the last two are its own, as a rule. */
const ASTRAY = ['stalled', 'singular-metric', 'iteration-limit', 'tolerance-not-met'];
/** Statuses of those that lead over the surface, but are not solved to the tolerance. */
const ON_SURFACE = ['iteration-limit', 'tolerance-not-met'];
/** Statuses of paths on an implicit surface that may be none because a rim is sharper than chords are long. */
const APART = ['sheet-jump', 'disconnected', 'off-surface', 'stalled', 'iteration-limit', 'tolerance-not-met'];
/** Lines are measured from node to node in so many parts, each by Gauss's rule. */
const PARTS = 32;
/** The surface is torn under a line whose chords are longer than derivatives say by more than this part. */
const TORN = 1e-9;
/** A path that is not converged is kept where it is longer than a polyline by no more than this part. */
const NO_LONGER = 2e-3;
/** Elements that agree to this part of a length lead over the surface, through no wall, if not where it is shortest. */
const NEARLY = 1e-6;
/** So much of the coordinates is what they leave open of a length. */
const ROUNDING = 1e-15;
/** Finer graphs than the first that may tell ways over creases. */
const FINER = 2;

/**
 * How long a line is in space that is straight over u and v from node to node: by derivatives, and by chords between the parts, which are shorter, unless it is torn.
 * @param {Field} field @param {Float64Array} line u v of its nodes
 */
function measure({ jets }, line) {
  /** @type {number[][]} */
  const [places, steps] = [[], []];
  for (let i = 2; i < line.length; i += 2)
    for (let part = 0; part < PARTS; part++)
      for (const { at } of GAUSS)
        for (const j of [0, 1]) {
          const step = (line[i + j] - line[i + j - 2]) / PARTS;
          places.push(line[i + j - 2] + (part + at) * step);
          steps.push(step);
        }
  const seen = jets(places);
  let [length, chords] = [0, 0];
  for (let i = 0; 2 * i < places.length; i++) {
    const [a, b] = [vector(seen, i, 3), vector(seen, i, 6)];
    const speed = a.map((x, j) => x * steps[2 * i] + b[j] * steps[2 * i + 1]);
    length += GAUSS[i % GAUSS.length].weight * norm(speed);
    if (i) chords += gap(vector(seen, i, 0), vector(seen, i - 1, 0));
  }
  return { length, chords };
}

/**
 * The surface by its E, F and G, and the options for it, where a path does not hold; null: there is nothing to gain. Ways through branch points are known in space alone.
 * @param {Field} field @param {Path} path @param {SolveOptions} options
 */
function instead({ own, graphs, isPlain }, path, options) {
  const isOpen = ASTRAY.slice(0, isPlain ? 4 : 2).includes(path.status) && options.algorithm === ELEMENTS && options.maxIterations >= STEPS;
  const field = own && isOpen && !graphs.branches?.length ? own() : null;
  return field && { field, options: isPlain ? options : { ...options, maxIterations: STEPS } };
}

/** Whether a path by E, F and G is one in space, as good as was asked. @param {Field} field @param {Path} path @param {SolveOptions} options */
function isGood(field, path, { tolerance }) {
  const size = largest(path.points.subarray(0, 3));
  return isGeodesic(path) && ROUNDING * size <= tolerance * path.length && isWhole(field, path);
}

/** Whether there is a path, or may be one, that was not solved. @param {Path} path */
const isUnsolved = ({ status }) => status === 'stalled' || ON_SURFACE.includes(status);

/** Whether a path is one, if not to the tolerance. @param {Path} path */
const isRoughlyKnown = ({ status, length, lengthError }) => ON_SURFACE.includes(status) && lengthError < length;

/** Whether elements nearly agree. @param {Path} path */
const isNearlyKnown = ({ status, length, lengthError }) => status === 'tolerance-not-met' && lengthError <= NEARLY * length;

/** Whether the surface is not torn under a path. @param {Field} field @param {Path} path */
function isWhole(field, { parameters }) {
  if (!parameters) return false;
  const { length, chords } = measure(field, parameters);
  return chords <= (1 + TORN) * length;
}

/** @param {Path} path @param {Path | null | undefined} creased */
const shorter = (path, creased) => (creased && !(path.converged && path.length < creased.length) ? creased : path);

/**
 * The path between two ends.
 * @param {Field} field @param {number[][]} ends @param {SolveOptions} options @param {import('./pieces/pieces.js').Start} start
 * @returns {Path}
 */
export function findPath(field, ends, options, start) {
  return (
    (options.algorithm === ELEMENTS ? findFromStill(field, ends, options, start, findMoving) : null) ??
    findMoving(field, ends, options, start)
  );
}

/** As {@link findPath}, where length is not zero in all directions at an end. @param {Field} field @param {number[][]} ends @param {SolveOptions} options @param {import('./pieces/pieces.js').Start} start @returns {Path} */
function findMoving(field, ends, options, start) {
  const begun = options.algorithm === ELEMENTS ? findFromInfinite(field, ends, options, start, findFinite) : null;
  return begun ?? findFinite(field, ends, options, start);
}

/** As {@link findPath}, where length is measured by numbers at both ends. @param {Field} field @param {number[][]} ends @param {SolveOptions} options @param {import('./pieces/pieces.js').Start} start @returns {Path} */
function findFinite(field, ends, options, start) {
  /* Across creases elements do not come to rest, and chords lie in the air: what they say soon they say as well as later. */
  const find = (/** @type {SolveOptions} */ asked) =>
    findSmooth(field, ends, { ...asked, maxIterations: Math.min(asked.maxIterations, STEPS) }, start);
  /** @type {Map<number, Path[]>} */
  const around = new Map();
  const findAround = (/** @type {number} */ pole) => {
    const paths =
      around.get(pole) ?? findAtPole(field, ends, start, pole, (flat, places, line) => [findFinite(flat, places, options, line)]);
    around.set(pole, paths);
    return paths;
  };
  const creased = findCreased(field, ends, options, start, 0, { findSmooth: (asked) => [find(asked)], findAround });
  if (!creased) return findSmooth(field, ends, options, start);
  const { known } = creased;
  const passed = known ? poleBeside(field.domain, known.parameters) : polesOf(field.domain);
  const [beside = null] = passed.flatMap(findAround).sort((a, b) => a.length - b.length);
  if (beside && beside.length <= (known ? known.length : creased.bound)) return beside;
  if (known) return known;
  const path = shorter(find(options), creased.path);
  if (path.converged && path.length <= creased.most) return path;
  /* Cells that are wider than a wall lead through it, and elements come to no rest. */
  const mayBeThin = start === 'global' && !field.domain && field.isPlain && !isGeodesic(path) && !isNearlyKnown(path) && !creased.path;
  for (let finer = 1; mayBeThin && finer <= FINER; finer++) {
    const other = findCreased(field, ends, options, start, finer);
    if (other?.known) return other.known;
  }
  const rough = creased.rough();
  const mayBeShort = !field.domain && field.isPlain && !isGeodesic(path);
  if (rough && (mayBeShort || !(path.length <= rough.length * (1 + NO_LONGER)))) return rough;
  const lengthError = Math.max(path.lengthError, path.length - creased.most);
  return { ...path, status: path.converged ? 'stalled' : path.status, converged: false, lengthError };
}

/** As {@link findPath}, where no crease is crossed. @param {Field} field @param {number[][]} ends @param {SolveOptions} options @param {import('./pieces/pieces.js').Start} start @returns {Path} */
function findSmooth(field, ends, options, start) {
  if (!field.domain) return findImplicit(field, ends, options, start);
  const find = (/** @type {Field} */ given) => findByPieces(given, ends, options, start);
  const isNetted = start === 'global' && hasNet(field, options);
  const first = find(isNetted ? { ...field, isBrief: true } : field);
  const isOne = isGeodesic(first) || isUnsolved(first);
  const steep = start === 'global' && isOne ? findSteep(field, ends, options, first) : first;
  const path = isNetted && !isGeodesic(steep) ? find(field) : first;
  if (steep !== first && (path === first || isNoLonger(steep, path))) return steep;
  const again = instead(field, path, options);
  if (!again) return path;
  const own = findByPieces(again.field, ends, compared(again.options), start);
  /* One that is known only roughly is better than none, or than what is longer. */
  const isRough = field.isPlain && isRoughlyKnown(own) && isWhole(field, own);
  if (!isRough && !isGood(field, own, options)) return path;
  /* Chords that stall may have jumped, and are as long as the line through their nodes; any other path is one on the surface. */
  const mayJump = path.status === 'stalled' && !path.crossesSingularity;
  const [length, most] = isRough ? [mostOf(own), path.length] : [own.length, mostOf(path)];
  if (!mayJump && length > most) return path;
  const line =
    mayJump &&
    field.isPlain &&
    (start === 'global' || isRough) &&
    (isCompared(options) ? path : findByPieces(field, ends, compared(options), start)).parameters;
  if (line && length > measure(field, line).length) return path;
  return isCompared(options) ? own : findByPieces(again.field, ends, again.options, start);
}

/** As {@link findSmooth}, on an implicit surface. @param {Field} field @param {number[][]} ends @param {SolveOptions} options @param {import('./pieces/pieces.js').Start} start @returns {Path} */
function findImplicit(field, ends, options, start) {
  const isSure = options.algorithm === ELEMENTS && options.maxIterations >= STEPS;
  const bodies = isSure ? field.bodies?.() : null;
  if (!bodies) return findByPieces(field, ends, options, start);
  const { box } = field;
  const stretched = () => findStretched(field, box ? bodies.stretchedIn(box) : bodies.stretchedAround(ends), ends, options, start);
  const path = findByPieces(field, ends, options, start);
  const other = APART.includes(path.status) ? stretched() : null;
  if (!other) return path;
  if (other.converged) return other.length <= mostOf(path) * (1 + NO_LONGER) ? other : path;
  return mostOf(other) < mostOf(path) ? other : path;
}

/**
 * The path between two ends of a flat body, found where this is stretched.
 * @param {Field} field @param {import('./manifold/stretched.js').Stretched | null} stretched
 * @param {number[][]} ends @param {SolveOptions} options @param {import('./pieces/pieces.js').Start} start @returns {Path | null}
 */
function findStretched(field, stretched, ends, options, start) {
  if (!stretched) return null;
  const settled = ends.map((end) => settleEnd(field, end));
  const places = settled.map((end) => stretched.into(end));
  const line = start && start !== 'global' ? Float64Array.from(stretched.into(start)) : start;
  const found = replaced(findByPieces(stretched.field, places, options, line), (points) => stretched.back(points));
  const { points } = found;
  if (points.length > 0) for (const [i, end] of settled.entries()) points.set(end, i * (points.length - 3));
  return found;
}

/**
 * All locally shortest paths between two ends that are found, shortest first.
 * @param {Field} field @param {number[][]} ends @param {SolveOptions} options @param {number} most
 * @returns {Path[]}
 */
export function findGeodesics(field, ends, options, most) {
  const others = {
    findSmooth: (/** @type {SolveOptions} */ asked) => findAllByPieces(field, ends, asked, most),
    findAround: (/** @type {number} */ pole) =>
      findAtPole(field, ends, 'global', pole, (flat, places) => findGeodesics(flat, places, options, most)),
  };
  const creased = findCreased(field, ends, options, 'all', 0, others)?.paths;
  if (creased?.length) return withPoles(field, creased, others.findAround).slice(0, most);
  const paths = findAllByPieces(field, ends, options, most);
  const again = paths.length === 1 ? instead(field, paths[0], options) : null;
  if (!again) return paths;
  const own = findAllByPieces(again.field, ends, compared(again.options), most);
  if (!own.every((path) => isGood(field, path, options))) return paths;
  return isCompared(options) ? own : findAllByPieces(again.field, ends, again.options, most);
}
