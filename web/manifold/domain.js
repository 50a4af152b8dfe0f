/** The domain of a surface: its parameter rectangle, how that is glued, which edges are points; and points that enter it. */

import { gap } from '../vector.js';
import { edgeOf, linePlaces, POSITION_GAP, reach } from './rectangle.js';
import { findSeams } from './seams.js';
import { findFree, findHole, findPinches, findPoles, isSmooth, leastAcross, tipAt, turning } from './tips.js';

/** @typedef {import('./rectangle.js').Range} Range */
/** @typedef {import('./rectangle.js').Sampled} Sampled */
/** @typedef {import('./seams.js').Asked} Asked */
/** @typedef {import('./seams.js').Glued} Glued */
/** @typedef {import('./tips.js').Tip} Tip */
/** @typedef {{ across: number, period: number, pieces: Piece[] }} Pinches lines within the rectangle that are one point: the coordinate across them, how far it is around where the pieces form a ring (both edges may be one such point) or 0, and what lies between them, in order: pieces with poles */
/** @typedef {Domain & { slabs: number[] }} Piece slabs: what a path is long, at least, that crosses so many equal parts of it, each; where length is that of space */
/** @typedef {Glued & { written: Range, poles: number[], free: number[], tips: Tip[], around: { along: number, most: number }[], pinches: Pinches | null }} Domain written: the rectangle as its definition has it, one turn; poles: edges that collapse to a point, 1 + 2 · coordinate + side; free: those along which a density or a metric makes ways free; tips: these, and edges that almost do; around: of the edges of tips along which the direction across turns by more than half a turn, the coordinate along them, and what that changes by in HALF_AROUND */

/** Radians: half a turn, and some. */
const HALF_AROUND = 1.2 * Math.PI;

/**
 * What a rectangle is glued to: which directions are periodic, as asked, or, 'auto', where the surface closes; which edges are points, and which lines between.
 * @param {'auto' | { u?: boolean, v?: boolean }} asked @param {Sampled} surface @param {Asked} written
 * @returns {Domain}
 */
export function findDomain(asked, surface, written) {
  const glued = findSeams(asked, surface, written);
  const domain = describeEdges(glued, written, surface);
  const { lower, upper, periodic } = glued;
  /* Where E, F and G measure length, positions tell nothing; across a turn the pieces change places. */
  if (surface.tensors || glued.turn) return domain;
  for (const across of [1, 0]) {
    const places = findPinches(surface.jets, glued, across);
    const isTied = meetsInPole(surface, domain, across);
    if (places.length === 0 && !isTied) continue;
    const period = periodic[across] || isTied ? upper[across] - lower[across] : 0;
    const ends = periodic[across] ? [...places, places[0] + period] : [lower[across], ...places, upper[across]];
    const pieces = ends.slice(1).map((end, i) => {
      const [low, high] = [[...lower], [...upper]];
      [low[across], high[across]] = [ends[i], end];
      const open = periodic.map((closed, j) => closed && j !== across);
      const range = { lower: low, upper: high };
      return {
        ...describeEdges({ ...range, periodic: open, turn: null }, range, surface),
        slabs: leastAcross(surface.jets, range, across),
      };
    });
    return { ...domain, pinches: { across, period, pieces } };
  }
  return domain;
}

/** Whether both edges across a coordinate are one and the same point, as those of a horn torus are. @param {Sampled} surface @param {Domain} domain @param {number} across */
function meetsInPole({ jets }, domain, across) {
  const [low, high] = [1, 2].map((side) => domain.tips.find(({ pole }) => pole === 2 * across + side && domain.poles.includes(pole))?.at);
  return !!low && !!high && gap(low, high) < POSITION_GAP * reach(jets(linePlaces(domain, across, 0.5)), low);
}

/** A glued rectangle, and what its edges are. @param {Glued} glued @param {Range} written @param {Sampled} surface @returns {Domain} */
function describeEdges(glued, written, surface) {
  const { lower, upper, periodic } = glued;
  const range = { lower, upper };
  const poles = findPoles(surface, range);
  const { jets, tensors } = surface;
  /** Radians by which the direction across turns along an edge. @param {number} pole */
  const turned = (pole) => {
    const { across, side } = edgeOf(pole);
    return turning(jets, linePlaces(range, across, side), across);
  };
  const winding = tensors ? [] : [1, 2, 3, 4].filter((pole) => turned(pole) > Math.PI);
  const holes = winding.filter((pole) => !poles.includes(pole)).flatMap((pole) => findHole(jets, range, periodic, pole));
  /* Where E, F and G measure length, positions tell nothing. */
  const tips = [
    ...poles.map((pole) =>
      tensors
        ? { pole, beyond: 0, at: null, radius: 0, smooth: periodic[edgeOf(pole).along] && isSmooth(tensors, range, pole) }
        : tipAt(jets, range, periodic, pole, edgeOf(pole).side),
    ),
    ...holes,
  ];
  const around = winding
    .filter((pole) => tips.some((tip) => tip.pole === pole))
    .map((pole) => {
      const { along } = edgeOf(pole);
      return { along, most: (HALF_AROUND / turned(pole)) * (upper[along] - lower[along]) };
    });
  return {
    ...glued,
    written: { lower: written.lower, upper: written.upper },
    poles,
    free: findFree(surface, range),
    tips,
    around,
    pinches: null,
  };
}

/** After more the numbers' last digits are a millionth of a turn. */
const MOST_TURNS = 1e9;

/**
 * Moves places that lie beyond walls of the rectangle onto these.
 * @template {number[] | Float64Array} T
 * @param {Pick<Domain, 'lower' | 'upper' | 'periodic'>} domain @param {T} places u v of each @returns {T} these
 */
export function confine({ lower, upper, periodic }, places) {
  for (let i = 0; i < places.length; i++) if (!periodic[i & 1]) places[i] = Math.min(Math.max(places[i], lower[i & 1]), upper[i & 1]);
  return places;
}

/**
 * A point of the rectangle: inside it up to rounding, anywhere in a periodic direction, as far as numbers tell one place of a turn from the next.
 * @param {Pick<Domain, 'lower' | 'upper' | 'periodic'>} domain @param {number[]} point @param {string} caller @param {string} name of the point @param {string[]} variables of a point
 */
export function enterDomain(domain, point, caller, name, variables) {
  const { lower, upper, periodic } = domain;
  for (const j of [0, 1]) {
    const [low, high] = [lower[j], upper[j]];
    const slack = (periodic[j] ? MOST_TURNS : 1e-12) * (high - low);
    if (point[j] < low - slack || point[j] > high + slack)
      throw new RangeError(
        `${caller}: ${name}[${j}] = ${point[j]} lies ${periodic[j] ? 'over 1e9 turns ' : ''}outside the range of ${variables[j]}, [${low}, ${high}]`,
      );
  }
  return confine(domain, [...point]);
}

/** Whether a point lies in the rectangle. @param {Pick<Domain, 'lower' | 'upper' | 'periodic'>} domain @param {number[]} point */
export const holdsPoint = ({ lower, upper, periodic }, point) => point.every((x, j) => periodic[j] || (x >= lower[j] && x <= upper[j]));

/** Whether a point lies on this edge of the rectangle. @param {Range} range @param {number[]} point @param {number} pole 1 + 2 · coordinate + side */
export function isAtPole({ lower, upper }, point, pole) {
  const { across, side } = edgeOf(pole);
  return point[across] === (side ? upper : lower)[across];
}

/** Whether a point lies on an edge that is one point, so that its coordinate along that edge says nothing. @param {Domain | null} domain @param {number[]} point @returns {number} that coordinate: 0, 1, or -1 */
export function freeCoordinate(domain, point) {
  const at = domain?.poles.find((pole) => isAtPole(domain, point, pole));
  return at === undefined ? -1 : edgeOf(at).along;
}

/**
 * Two ends, one that is a pole moved along its edge to face the other: a path leaves a pole along the meridian of its other end, and would else have to turn
 * round in the chart first.
 * @param {Domain | null} domain @param {number[]} a @param {number[]} b @returns {number[][]}
 */
export function facePoles(domain, a, b) {
  const face = (/** @type {number[]} */ point, /** @type {number[]} */ other) =>
    point.map((x, j) => (j === freeCoordinate(domain, point) ? other[j] : x));
  return freeCoordinate(domain, b) < 0 ? [face(a, b), b] : [a, face(b, a)];
}
