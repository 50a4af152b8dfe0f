/**
 * Ways over the poles of a parametric surface, paths that pass a pole nearby, and those that wind around a hole: what the rectangle's own coordinates cannot follow.
 * Knows which ones are worth a solve; the solver knows how.
 */

import { isAtPole } from '../manifold/domain.js';
import { copies, liftNear } from '../manifold/lifts.js';
import { edgeOf } from '../manifold/rectangle.js';
import { BESIDE_POINT, OVER_POINT, POINT_CHART } from '../runtime/heap.js';
import { emptyPath } from '../runtime/result.js';
import { CONVERGED, SINGULAR_METRIC, STALLED } from '../runtime/status.js';
import { gap } from '../vector.js';
import { asAsked, compared, ELEMENTS, holds, leaps, lengthOfShortest, MARGIN, solveFrom, within } from './candidates.js';
import { comesNear } from './distinct.js';

/** @typedef {import('./candidates.js').RawPath} RawPath */
/** @typedef {import('./candidates.js').SolveOptions} SolveOptions */
/** @typedef {import('./candidates.js').Found} Found */
/** @typedef {import('./candidates.js').Way} Way */
/** @typedef {import('./candidates.js').Problem} Problem */
/** @typedef {import('../manifold/tips.js').Tip} Tip */

/** A chord that turns around a pole by so much of a turn is not meant. */
const MOST_OF_A_TURN = 0.75;
/** A chord that turns around a pole by this part of a turn passes it nearby. */
export const SHARP = 0.05;
/** Near a pole of its own chart a path takes 10 to 25 steps; near another one hundreds, and for nothing. */
const BESIDE_STEPS = 60;
/** Over a pole it takes 105 at most, if there is a path: under a density paths wind into some cusps for ever. */
const OVER_STEPS = 120;

/**
 * Ways over a pole, which no chart shows as stationary, shortest first. One with a corner, `stalled`, is no geodesic; but what is longer is not the
 * shortest. Over a hole none leads: it tells how short a way around it may be; where the surface is smooth, nothing needs to be told. Those that
 * even as straight lines in space are longer than the best path are left out.
 * @param {Problem} problem @param {SolveOptions} options @param {Found[]} tried @param {Found[]} rough those that hold
 * @returns {Way[]}
 */
export function overPoles(problem, options, tried, rough) {
  const { from, to, domain, isPlain } = problem;
  if (!domain || options.algorithm !== ELEMENTS) return [];
  const points = isPlain && tried.find(({ path }) => path.points.length > 0)?.path.points;
  const ends = copies(domain, to);
  return ends
    .flatMap((end) => domain.tips.map((tip) => ({ ...tip, to: end })))
    .filter((tip) => tip.beyond > 0 || ![from, tip.to].some((end) => isAtPole(domain, end, tip.pole)))
    .map((tip) => ({ ...tip, bound: tip.at && points ? gap(points, tip.at) + gap(points.subarray(-3), tip.at) - 2 * tip.radius : 0 }))
    .filter((tip) => tip.bound <= (1 + MARGIN) * lengthOfShortest(rough) || comesNear(rough[0].path, tip, domain))
    .map((tip) => {
      const again = (/** @type {SolveOptions} */ asked) => solveAt(problem, tip, true, tip.to, null, within(asked, OVER_STEPS));
      const path = tip.smooth ? emptyPath(SINGULAR_METRIC) : again(compared(options));
      return { ...tip, again, path: tip.beyond > 0 ? { ...path, status: STALLED } : path };
    })
    .sort((a, b) => (a.path.length || a.bound) - (b.path.length || b.bound));
}

/**
 * Where a path near a start came to nothing: the shortest of those that pass a pole, or lead over it, unless what was found is shorter, and a path.
 * @param {Problem} problem @param {SolveOptions} options @param {RawPath} near @returns {RawPath[]} none or one
 */
export function passPoles(problem, options, near) {
  const weak = { to: problem.to, path: near, start: null, coarse: near };
  const others = leaps(problem, near) ? [] : [weak];
  const poles = overPoles(problem, options, [weak], others);
  const most = others.length > 0 && near.length > 0 ? (1 + MARGIN) * near.length : Infinity;
  const { beside, over } = besidePoles(problem, options, poles, others);
  return [...beside, ...over]
    .filter((found) => holds(found) && found.path.length <= most)
    .sort((a, b) => a.path.length - b.path.length)
    .slice(0, 1)
    .map((found) => asAsked(found, options));
}

/**
 * Solves over a pole or, on the shorter side, past it, or around a hole: where the surface is smooth in a chart around it, else on elements that close in on it.
 * @param {Problem} problem @param {Tip} tip @param {boolean} isOver @param {number[]} to @param {Float64Array | null} start @param {SolveOptions} options
 */
function solveAt({ from, domain, solve }, { pole, beyond, smooth }, isOver, to, start, options) {
  const range = /** @type {import('../manifold/domain.js').Domain} */ (domain);
  const { along } = edgeOf(pole);
  const way = isOver ? OVER_POINT : smooth && !(beyond > 0) ? POINT_CHART : BESIDE_POINT;
  const turn = range.periodic[along] ? range.upper[along] - range.lower[along] : 0;
  return solve(liftNear(range, to, from), start, options, { way, edge: pole - 1, beyond, turn });
}

/**
 * Paths that pass a pole nearby, or wind around a hole, over which a way is hardly longer: in the rectangle's own coordinates they turn too sharply there.
 * @param {Problem} problem @param {SolveOptions} options @param {Way[]} ways @param {Found[]} others
 * @returns {{ beside: Found[], over: Way[] }} over: the ways, solved where none passes the pole
 */
export function besidePoles(problem, options, ways, others) {
  let shortest = lengthOfShortest([...others, ...ways.filter(({ beyond }) => !(beyond > 0))]);
  const asked = compared(within(options, BESIDE_STEPS));
  /** @type {Found[]} */
  const beside = [];
  const over = ways.map((tip) => {
    const { to, beyond, radius, bound } = tip;
    if (Math.max(tip.path.length - 2 * radius || 0, bound) * (1 - MARGIN) > shortest) return tip;
    const again = (/** @type {SolveOptions} */ wanted) => solveAt(problem, tip, false, to, null, wanted);
    const way = { to, again, path: again(asked) };
    if (way.path.status >= CONVERGED) beside.push(way);
    /* Of a pole, where half a turn in longitude may be none around it; over a hole no way leads. */
    const isInsteadOfArcs = tip.smooth && bound > 0 && !(beyond > 0);
    if (!holds(way)) return isInsteadOfArcs ? { ...tip, path: tip.again(compared(options)) } : tip;
    shortest = Math.min(shortest, way.path.length);
    return tip;
  });
  return { beside, over };
}

/** Solves from a path found roughly; past a pole of a metric as beside one. @param {Problem} problem @param {Found} found @param {SolveOptions} options */
export function refine(problem, { to, path }, options) {
  const { domain } = problem;
  const parameters = path.parameters && domain ? unwound(domain, path.parameters) : path.parameters;
  const tip = domain && parameters && options.algorithm === ELEMENTS && passedTip(domain, parameters, SHARP);
  const beside = tip && !tip.at && solveAt(problem, tip, false, to, parameters, options);
  if (beside && holds({ path: beside })) return beside;
  return solveFrom(problem, { to, path: { ...path, parameters } }, options);
}

/**
 * At a pole, and beside a cusp of revolution, a turn, or six, are hardly a way, and a node of a rough path may lie that far off: the same path, each node in the turn of the one before.
 * @param {import('../manifold/domain.js').Domain} domain @param {Float64Array} parameters
 */
function unwound({ lower, upper, periodic, poles }, parameters) {
  const moved = parameters.slice();
  for (let i = 2; i < moved.length && poles.length > 0; i++) {
    const period = upper[i & 1] - lower[i & 1];
    const turns = (moved[i] - moved[i - 2]) / period;
    if (periodic[i & 1] && Math.abs(turns) > MOST_OF_A_TURN) moved[i] -= period * Math.round(turns);
  }
  return moved;
}

/**
 * The pole nearest to a chord of a path that turns around it by this part of a turn, or more, so that the rectangle's coordinates are no good there; null: none.
 * @param {import('../manifold/domain.js').Domain} domain @param {ArrayLike<number>} parameters @param {number} part
 */
export function passedTip({ lower, upper, tips }, parameters, part) {
  /** @type {Tip | null} */
  let passed = null;
  let nearest = Infinity;
  for (const tip of tips) {
    const { pole } = tip;
    const { across, along, side } = edgeOf(pole);
    for (let i = 2; i < parameters.length; i += 2) {
      const away = Math.abs(parameters[i + across] - (side ? upper : lower)[across]);
      const turned = Math.abs(parameters[i + along] - parameters[i + along - 2]);
      if (turned > part * (upper[along] - lower[along]) && away < nearest) [passed, nearest] = [tip, away];
    }
  }
  return passed;
}
