/** A geodesic from a point in a direction: what a caller may ask of it, checked, and its trace. */

import { checkOptions, readTolerance, refuseNumber, wholeNumber } from './arguments.js';
import { changesSides, traceAcross } from './creases/trace-across.js';
import { sizeOf } from './creases/linear.js';
import { endOf } from './creases/meeting.js';
import { readNumbers } from './definition.js';
import { freeCoordinate } from './manifold/domain.js';
import { KIND } from './manifold/kind.js';
import { MOST_POINTS, makePath } from './path.js';
import { placeIn } from './pieces/pieces.js';
import { CONVERGED, NOT_FINITE, SINGULAR_METRIC, TOLERANCE_NOT_MET } from './runtime/status.js';
import { placed } from './search/join.js';
import { settleEnd } from './search/routes.js';

/** A trace that ends so on an implicit surface is tried again with so many times the tolerance, from this one no more. */
const MAY_CROSS = [TOLERANCE_NOT_MET, SINGULAR_METRIC];
const [LOOSER, LOOSEST] = [100, 1e-5];

/** From a pole a trace begins beside it, by this part of the rectangle. */
const BESIDE = 1e-15;

/**
 * @typedef {object} TraceOptions
 * @property {number} [points] K, points of the path between its ends, equally spaced by length: 1 … 100,000, default 64
 * @property {number} [tolerance] largest error of a step, of the direction and relative to the length: 1e-14 … 0.01, default 1e-12
 */

/**
 * @param {string} caller @param {unknown} direction @param {unknown} length @param {string[]} variables of a point
 * @returns {{ direction: number[], length: number }}
 */
export function readTrace(caller, direction, length, variables) {
  const names = variables.length === 2 ? variables.map((x) => `d${x}`) : variables;
  const numbers = readNumbers(caller, 'direction', direction, names);
  if (numbers.every((x) => x === 0)) throw new RangeError(`${caller}: direction must not be zero`);
  if (typeof length !== 'number' || !(length >= 0 && length < Infinity))
    refuseNumber(`${caller}: length`, 'a finite number that is not negative', length);
  return { direction: numbers, length };
}

/** @param {string} caller @param {TraceOptions | undefined} given @returns {{ points: number, tolerance: number }} */
export function readTraceOptions(caller, given) {
  const { points = 64, tolerance = 1e-12 } = checkOptions(caller, given, ['points', 'tolerance']);
  return { points: wholeNumber(caller, 'points', points, 1, MOST_POINTS), tolerance: readTolerance(caller, tolerance, 1e-14, 0.01) };
}

/**
 * @param {import('./manifold/manifold.js').Manifold} manifold @param {string} caller @param {number[]} start @param {ReturnType<typeof readTrace>} asked
 * @param {ReturnType<typeof readTraceOptions>} wanted
 * @returns {import('./path.js').Path}
 */
export function traceFrom(manifold, caller, start, asked, wanted) {
  const field = manifold.field();
  const { domain, place } = placeIn(field, start, asked.direction);
  /* Around a pole a coordinate says nothing, and has no derivative: a trace leaves it along the meridian, from beside it. */
  const along = freeCoordinate(domain, place);
  const across = 1 - along;
  const pole = place[across];
  if (domain && along >= 0) {
    place[across] += BESIDE * (domain.lower[across] + domain.upper[across] - 2 * pole);
    asked.direction[along] = 0;
  }
  const run = (/** @type {number} */ length, /** @type {number} */ tolerance) =>
    manifold.run(
      (heap, record) => heap.trace(record, { kind: KIND[manifold.kind], from: place, ...asked, length }, { ...wanted, tolerance }),
      domain,
    );
  const path = field.jumps ? traceCreased(field, place, asked, wanted, run) : traceSmooth(manifold, asked, wanted, run);
  if (along >= 0 && path?.parameters) {
    const steps = (path.parameters[2 + across] - pole) / (place[across] - pole);
    path.parameters[across] = pole;
    path.lengthError += path.length / (wanted.points + 1) / (steps || 1);
  }
  if (path) return place === start ? makePath(path) : placed(manifold.domain, makePath(path), start);
  throw new RangeError(`${caller}: direction is normal to the surface at from; give one with a tangent part`);
}

/** @typedef {(length: number, tolerance: number) => import('./runtime/result.js').RawPath | null} Run a trace on the surface as it is; null: the direction is normal to it */

/** @param {import('./manifold/manifold.js').Manifold} manifold @param {ReturnType<typeof readTrace>} asked @param {ReturnType<typeof readTraceOptions>} wanted @param {Run} run */
function traceSmooth({ kind }, { length }, wanted, run) {
  let { tolerance } = wanted;
  let path = run(length, tolerance);
  /* Near a curve where an implicit surface's gradient vanishes rounding keeps steps short, and turns them: longer ones lead across. */
  while (kind === 'implicit' && path && MAY_CROSS.includes(path.status) && tolerance < LOOSEST) {
    tolerance *= LOOSER;
    const next = run(length, tolerance);
    if (next && next.status >= CONVERGED) path = next;
  }
  if (path?.status === CONVERGED && tolerance > wanted.tolerance) path.status = TOLERANCE_NOT_MET;
  return path;
}

/**
 * Where formulas have creases: on their sides, one after the other. Within a piece, whose edges sides do not know, only as far as none is crossed.
 * @param {import('./search/routes.js').Field} field @param {number[]} place @param {ReturnType<typeof readTrace>} asked @param {ReturnType<typeof readTraceOptions>} wanted @param {Run} run
 */
function traceCreased(field, place, { direction, length }, wanted, run) {
  const lost = (/** @type {import('./runtime/result.js').RawPath} */ raw) => ({ ...raw, status: TOLERANCE_NOT_MET, lengthError: length });
  const still = run(0, wanted.tolerance);
  if (still && !still.end) return still;
  const sides = field.jumps?.() ?? null;
  const isWhole = sides && field.pieces.length === 0;
  /* What is normal to one side of a crease may lead into the other. */
  const from = field.domain ? place : still ? endOf(still) : settleEnd(field, place);
  const reach = still?.end ? sizeOf(still.end.velocity) * length : length;
  const path = isWhole ? traceAcross(field, sides, { place: from, direction, length, reach }, wanted) : run(length, wanted.tolerance);
  /* A side may end where its crease does, as that of max(0, x)^2.5. */
  const whole = isWhole && path?.status === NOT_FINITE ? run(length, wanted.tolerance) : null;
  if (whole && whole.status >= CONVERGED) return lost(whole);
  if (!path) return still && lost(still);
  const isKnown = isWhole || (sides && !changesSides(sides, path));
  return isKnown || path.status !== CONVERGED ? path : lost(path);
}
