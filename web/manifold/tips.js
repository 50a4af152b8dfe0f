/** Edges of a parameter rectangle that are one point, or almost: poles, apexes, small holes. Knows only samples of the surface. */

import { dot, gap, listOf, norm, unit } from '../vector.js';
import { edgeOf, FRACTIONS, linePlaces, POSITION_GAP, reach, vector } from './rectangle.js';

/** @typedef {import('./rectangle.js').Range} Range */
/** @typedef {import('./rectangle.js').Jets} Jets */
/** @typedef {import('./rectangle.js').Sampler} Sampler */
/** @typedef {import('./rectangle.js').Sampled} Sampled */
/** @typedef {{ pole: number, beyond: number, at: Float64Array | null, radius: number, smooth: boolean }} Tip an edge, 1 + 2 · coordinate + side; how far beyond it, in the coordinate across, the surface collapses to a point; negative: inside the rectangle; that point, where it is known; how far the edge is from it, in space; and whether the surface is smooth there and closed around it */

/** An edge that is almost a point: the point is so near, in parts of the range, and equally near everywhere along the edge, up to this part of that. */
const NEAR_POINT = 0.05;
const SAME_POINT = 0.1;
/** The surface is smooth at a point if derivatives around it differ from those of a plane by less. */
const FLAT = 1e-5;
/** A density makes ways along an edge free up to this part of what they are beside it: `sqrt(cos(v))` at π/2 is the root of a rounding. */
const FREE = 1e-6;
/** So near to a point, in parts of the range, and twice as far, a metric tells what it is at it. */
const BESIDE = 1e-4;
/** So many steps over the range, on these lines, and how much of one lies before the first (no simple part: a place that is one should not be hit), find where a line is a point; so many halvings of one find the place. */
const [SCANNED, SCANNED_LINES, BEGIN, HALVINGS] = [48, [0.137, 0.611], 0.3183, 48];
/** Beside a zero without a turn one of the squared speeds is so many times that at the nearest place: 9 at least where it is a kink, as of abs(v), 81 of a parabola. */
const TOUCHING = 8;
/** Parts of a range between lines, on which the speed is sampled; so much of what these tell is counted on. */
const SLABS = 64;
const CERTAIN = 0.9;
/** Of the range. */
const ROUNDING = 2e-15;

/**
 * Edges that are one point: a pole, an apex. They are compared with the line beside them: the surface may be far larger elsewhere.
 * @param {Sampled} surface @param {Range} range
 */
export function findPoles(surface, range) {
  return findEdges(range, surface.tensors ? hasNoLength(formsOf(surface), range, POSITION_GAP) : isOnePlace(surface.jets));
}

/**
 * Edges along which a density or a metric makes ways free, or almost, poles or not.
 * @param {Sampled} surface @param {Range} range
 */
export function findFree(surface, range) {
  const forms = formsOf(surface);
  return forms(range.lower).length > 0 ? findEdges(range, hasNoLength(forms, range, FREE)) : [];
}

/** @param {Range} range @param {(places: number[], beside: number[], along: number) => boolean} isIt tells from an edge and the line beside it */
function findEdges(range, isIt) {
  return [1, 2, 3, 4].filter((edge) => {
    const { across, along, side } = edgeOf(edge);
    const beside = linePlaces(range, across, Math.abs(side - FRACTIONS[1]));
    return isIt(linePlaces(range, across, side), beside, along);
  });
}

/**
 * An edge that is almost a point, as where 3.14 stands for π: the speed along it vanishes at a point a little beyond, extrapolated, or before.
 * @param {Jets} jets @param {Range} range @param {boolean[]} periodic @param {number} pole the edge
 * @returns {Tip[]} none or one
 */
export function findHole(jets, range, periodic, pole) {
  const { across: direction, side } = edgeOf(pole);
  const span = range.upper[direction] - range.lower[direction];
  const place = (/** @type {number} */ fraction) => linePlaces(range, direction, fraction);
  /** Where the speed vanishes, in parts of the range from here; NaN where it turns instead. @param {number} fraction */
  const offsetsAt = (fraction) => {
    const sampled = jets(place(fraction));
    return FRACTIONS.map((_, i) => {
      const [speed, change] = [vector(sampled, i, direction ? 3 : 6), vector(sampled, i, 12)];
      const [product, squared] = [dot(speed, change), dot(change, change)];
      return product ** 2 >= (1 - SAME_POINT) * dot(speed, speed) * squared ? -product / (squared * span) : Number.NaN;
    });
  };
  const offsets = offsetsAt(side);
  const [first] = offsets;
  const isNear = Math.abs(first) <= NEAR_POINT && offsets.every((offset) => Math.abs(offset - first) <= SAME_POINT * Math.abs(first));
  if (!isNear) return [];
  const exact = side + first + offsetsAt(side + first)[0];
  /* Not behind the point, not even by rounding: there the normal has turned over. */
  const before = exact - ROUNDING * (2 * side - 1);
  if (isOnePlace(jets)(place(before), place(Math.abs(side - FRACTIONS[1])))) return [tipAt(jets, range, periodic, pole, before)];
  const beyond = (side ? span : -span) * first;
  return beyond > 0 ? [{ pole, beyond, at: null, radius: 0, smooth: false }] : [];
}

/**
 * Where, between two edges, the rectangle is one point: the speed along a line vanishes there, and turns round, as where a radius changes its sign, or does not, as where
 * one touches zero.
 * @param {Jets} jets @param {Range} range @param {number} across the coordinate that is constant on the line
 * @returns {number[]} it, ascending
 */
export function findPinches(jets, range, across) {
  const scan = Array.from({ length: SCANNED + 1 }, (_, i) => (i + BEGIN) / (SCANNED + 1));
  const speed = (/** @type {Float64Array} */ sampled, /** @type {number} */ i) => vector(sampled, i, across ? 3 : 6);
  /* Of each line, what the speeds at two of its places multiply to. */
  const products = SCANNED_LINES.map((line) => {
    const sampled = jets(linePlaces(range, 1 - across, line, scan));
    return (/** @type {number} */ i, /** @type {number} */ j) => dot(speed(sampled, i), speed(sampled, j));
  });
  /** Of the zero of the speed from one place to the next: 1 where it turns, 2 where it almost vanishes and does not, 0: there is none. @param {number} i */
  const orderAt = (i) => {
    if (products.every((product) => product(i, i + 1) < 0)) return 1;
    const isLeast =
      i > 0 &&
      products.every((product) => {
        const [before, here, after] = [i - 1, i, i + 1].map((k) => product(k, k));
        return here <= before && here < after && product(i - 1, i) > 0 && TOUCHING * here <= Math.max(before, after);
      });
    return isLeast ? 2 : 0;
  };
  /** Where three numbers of the jets turn round between two parts of the range: halved, as they may jump there. @param {number} low @param {number} high @param {number} offset */
  const settle = (low, high, offset) => {
    const numbers = (/** @type {number} */ x) => vector(jets(linePlaces(range, across, x, SCANNED_LINES)), 0, offset);
    const beyond = numbers(high);
    for (let step = 0; step < HALVINGS; step++) {
      const middle = (low + high) / 2;
      if (dot(numbers(middle), beyond) < 0) low = middle;
      else high = middle;
    }
    return high;
  };
  /** @type {number[]} */
  const found = [];
  for (let i = 0; i < SCANNED; i++) {
    const order = orderAt(i);
    if (order === 0) continue;
    /* At a double zero of the speed, which rounding blurs, and at a kink its change turns round. */
    const at = order === 1 ? settle(scan[i], scan[i + 1], across ? 3 : 6) : settle(scan[i - 1], scan[i + 1], 12);
    const place = (/** @type {number} */ fraction) => linePlaces(range, across, fraction);
    const beside = scan[at < (scan[i] + scan[i + 1]) / 2 ? i + 1 : i];
    if (at > scan[0] && at < scan[SCANNED] && isOnePlace(jets)(place(at), place(beside)))
      found.push((1 - at) * range.lower[across] + at * range.upper[across]);
  }
  return found.filter((x, i) => i === 0 || x > found[i - 1]);
}

/**
 * What a path is long, at least, that crosses the rectangle: part by part, from line to line. Least over the lines, with the speed between them taken for no less than at both.
 * @param {Jets} jets @param {Range} range @param {number} across the coordinate that is constant on the lines
 * @returns {number[]} of SLABS equal parts
 */
export function leastAcross(jets, range, across) {
  const width = (range.upper[across] - range.lower[across]) / SLABS;
  const speeds = Array.from({ length: SLABS + 1 }, (_, k) => {
    const sampled = jets(linePlaces(range, across, k / SLABS));
    const squares = FRACTIONS.map((_, i) => {
      const [along, away] = [vector(sampled, i, across ? 3 : 6), vector(sampled, i, across ? 6 : 3)];
      return dot(away, away) - (dot(along, away) ** 2 / dot(along, along) || 0);
    });
    return Math.sqrt(Math.max(0, Math.min(...squares))) || 0;
  });
  return speeds.slice(1).map((speed, k) => CERTAIN * width * Math.min(speed, speeds[k]));
}

/** The point to which lines across lead. @param {Jets} jets @param {Range} range @param {boolean[]} periodic @param {number} pole @param {number} fraction where @returns {Tip} */
export function tipAt(jets, range, periodic, pole, fraction) {
  const { across: direction, side } = edgeOf(pole);
  const sampled = jets(linePlaces(range, direction, fraction));
  const at = vector(sampled, 0, 0);
  const beyond = (fraction - side) * (side ? 1 : -1) * (range.upper[direction] - range.lower[direction]);
  return {
    pole,
    beyond,
    at,
    radius: reach(jets(linePlaces(range, direction, side)), at),
    smooth: periodic[1 - direction] && isFlat(sampled, direction),
  };
}

/** Whether the derivatives across a point are those of a plane around it, a cos θ + b sin θ, equal steps of the coordinate along those of θ. @param {Float64Array} sampled @param {number} direction */
function isFlat(sampled, direction) {
  const across = (/** @type {number} */ i) => vector(sampled, i, direction ? 6 : 3);
  /* 2 cos(2π/16), as there are 17 FRACTIONS. */
  const twice = Math.sqrt(2 + Math.SQRT2);
  const size = Math.max(...FRACTIONS.map((_, i) => norm(across(i))));
  return (
    size > 0 &&
    FRACTIONS.slice(2).every(
      (_, i) =>
        gap(
          across(i).map((x, k) => x + across(i + 2)[k]),
          across(i + 1).map((x) => twice * x),
        ) <=
        FLAT * size,
    )
  );
}

/**
 * By how much the direction across turns along a line of the rectangle: radians, to 1e-6 where it stays in a plane.
 * @param {Jets} jets @param {number[]} places @param {number} direction
 */
export function turning(jets, places, direction) {
  const sampled = jets(places);
  return angleAlong(FRACTIONS.map((_, i) => vector(sampled, i, direction ? 6 : 3)));
}

/** The sum of the angles, radians, from each vector to the next, which are small. @param {Float64Array[]} vectors */
export function angleAlong(vectors) {
  const units = vectors.map((x) => unit(listOf(x)));
  return units.slice(1).reduce((sum, x, i) => {
    /* Twice the arcsine of half the chord. */
    const [chord, square] = [gap(x, units[i]), gap(x, units[i]) ** 2];
    return sum + chord * (1 + (square / 24) * (1 + (9 * square) / 80));
  }, 0);
}

/** Whether a line is one point, and that beside it is none: where it is, too, there is no surface. @param {Jets} jets */
function isOnePlace(jets) {
  return (/** @type {number[]} */ places, /** @type {number[]} */ beside) => {
    const sampled = jets(places);
    const around = jets(beside);
    const near = POSITION_GAP * reach(around, sampled);
    return reach(around, around) > 0 && FRACTIONS.every((_, i) => gap(vector(sampled, i, 0), sampled) <= near);
  };
}

/**
 * E, F and G at each of some places, where a density or a metric measures length; none where space does.
 * @param {Sampled} surface @returns {(places: number[]) => ArrayLike<number>[]}
 */
export function formsOf({ jets, metrics, tensors }) {
  if (tensors) return tensors;
  return (places) => {
    const sampled = jets(places);
    /* Behind x, y and z: the square of the density. */
    return metrics(places).map((measured, i) => {
      const [a, b] = [vector(sampled, i, 3), vector(sampled, i, 6)];
      return [dot(a, a), dot(a, b), dot(b, b)].map((product) => measured[3] * product);
    });
  };
}

/**
 * Whether the speed along an edge vanishes, up to a part of what it is beside it: where E, F and G measure length that tells what is a point.
 * @param {ReturnType<typeof formsOf>} forms @param {Range} range @param {number} near
 */
function hasNoLength(forms, range, near) {
  const span = [0, 1].map((j) => range.upper[j] - range.lower[j]);
  const lengths = (/** @type {number[]} */ places, /** @type {number} */ j) =>
    forms(places).map((form) => Math.sqrt(Math.abs(form[2 * j])) * span[j]);
  return (/** @type {number[]} */ places, /** @type {number[]} */ beside, /** @type {number} */ along) => {
    const around = [...lengths(beside, 0), ...lengths(beside, 1)];
    const least = near * Math.max(0, ...around.filter(Number.isFinite));
    return lengths(places, along).every((length) => length <= least);
  };
}

/**
 * Whether E, F and G around an edge that is a point are those of a surface that is smooth there, once around.
 * @param {Sampler} tensors @param {Range} range @param {number} pole
 */
export function isSmooth(tensors, range, pole) {
  const { across, side } = edgeOf(pole);
  const [away, turn] = [across, 1 - across].map((j) => range.upper[j] - range.lower[j]);
  /* Over dr and r dθ: what the diagonal differs by, twice the mixed part, the trace. */
  const around = (/** @type {number} */ fraction) => {
    const circle = ((side ? -2 : 2) * Math.PI * fraction * away) / turn;
    return tensors(linePlaces(range, across, Math.abs(side - fraction))).map((tensor) => {
      const [outwards, along] = [tensor[2 * across], tensor[2 - 2 * across] / circle ** 2];
      return [outwards - along, (2 * tensor[1]) / circle, outwards + along];
    });
  };
  const far = around(2 * BESIDE);
  const at = around(BESIDE).map((near, i) => near.map((x, k) => 2 * x - far[i][k]));
  /* The first two turn back twice as fast as the directions, by an eighth of a turn. */
  return at
    .slice(1)
    .every(
      (next, i) => gap(next, [(at[i][0] + at[i][1]) * Math.SQRT1_2, (at[i][1] - at[i][0]) * Math.SQRT1_2, at[i][2]]) <= FLAT * next[2],
    );
}
