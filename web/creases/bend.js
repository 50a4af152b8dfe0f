/** Which way a geodesic goes on beyond a crease: what its length changes by along that is the same on both sides. MATH.md, "Traces across creases". */

import { minus } from '../vector.js';
import { directions, settle } from './crease.js';
import { ahead, apart, inner, scaled, sizeOf } from './linear.js';
import { frameOn } from './tangent.js';

/** @typedef {{ field: import('../search/routes.js').Field, sides: import('../manifold/sides.js').Sides, tolerance: number, size: number }} Tracing size: of the coordinates that rounding is a part of */
/** @typedef {{ position: number, turn: number }} Spread errors of a place, and of the direction there */
/** @typedef {{ velocity: number[], isReflected: boolean, spread: Spread }} Bend */

/** Squares of sines that are less graze the crease. */
const GRAZING = 1e-10;
/** Sides fit together where cosines of what is along the crease on both differ from 1 by no more. */
const TURNED = 1e-9;
/** The curvature of a crease is told by places so far apart, in parts of the coordinates. */
const BESIDE = 1e-4;

/**
 * Where a geodesic leads that comes to a crease: beyond it or, where what it would change by along the crease is more than the length there is, back.
 * @param {Tracing} tracing @param {number} crease @param {number[]} before signs of the side from which @param {number[]} after @param {number[]} place @param {number[]} velocity
 * @param {Spread} spread as it comes there @returns {Bend | null} null: it grazes the crease, or the sides do not fit together there
 */
export function bend(tracing, crease, before, after, place, velocity, spread) {
  const { scale } = tracing.sides;
  const [on, beyond] = [before, after].map((signs) => ({ crease, signs }));
  const [here, there] = [on, beyond].map((side) => directions(tracing.sides, side, place));
  if (!(Math.abs(inner(here.along, there.along, scale)) >= 1 - TURNED)) return null;
  const one = frameOn(tracing, before, place, here.along, here.across);
  const other = frameOn(tracing, after, place, here.along, there.across);
  const y = inner(velocity, here.across, scale);
  const x = inner(velocity, here.along, scale) + one.skew * y;
  const momentum = x * one.t;
  const [squared, refracted] = [y * y * one.n, 1 - (momentum * momentum) / other.t];
  if (!(squared > GRAZING && Math.abs(refracted) > GRAZING)) return null;
  const isReflected = refracted < 0;
  const turned = isReflected
    ? ahead(scaled(here.along, x), one.across, -y)
    : ahead(scaled(here.along, momentum / other.t), other.across, Math.sign(y) * Math.sqrt(refracted / other.n));
  const sines = [squared, isReflected ? squared : refracted].map(Math.sqrt);
  const ratio = isReflected ? 1 : Math.sqrt(one.t / other.t);
  return { velocity: turned, isReflected, spread: bentBy(sines, ratio, curvatureOf(tracing, on, place, here.along, one.t), spread) };
}

/** How much a crease turns by length, about. @param {Tracing} tracing @param {import('./crease.js').On} on @param {number[]} place @param {number[]} along @param {number} squared length of that */
function curvatureOf({ sides, field: { domain } }, on, place, along, squared) {
  const { scale } = sides;
  const reach = domain ? Math.max(...minus(domain.upper, domain.lower).map((x, j) => x * scale[j])) : sizeOf(place) || 1;
  const next = settle(sides, on, ahead(place, along, BESIDE * reach));
  return apart(directions(sides, on, next).along, along, scale) / (Math.sqrt(squared) * apart(next, place, scale));
}

/** Errors beyond a crease: a place beside the right one lies farther along the crease, which has turned there. @param {number[]} sines of the angles before and after @param {number} ratio of cosines @param {number} curvature @param {Spread} spread @returns {Spread} */
function bentBy([before, after], ratio, curvature, { position, turn }) {
  const refraction = Math.max(1, (ratio * before) / after);
  return { position: Math.max(1, after / before) * position, turn: refraction * turn + ((1 + refraction) * curvature * position) / before };
}
