/** A surface sampled along lines of its parameter rectangle. Knows only evaluations of S and its derivatives. */

import { gap } from '../vector.js';

/** @typedef {{ lower: number[], upper: number[] }} Range */
/** @typedef {(points: number[]) => Float64Array} Jets 18 numbers a point (u, v): S, S_u, S_v, S_uu, S_uv, S_vv */
/** @typedef {(points: number[]) => ArrayLike<number>[]} Sampler */
/** @typedef {{ jets: Jets, metrics: Sampler, tensors: Sampler | null }} Sampled `metrics`: for each point what measures length there, and its first derivatives; none where space does. `tensors`: E F G, where they do */

const GRID = 16;
export const FRACTIONS = Array.from({ length: GRID + 1 }, (_, i) => i / GRID);
/** Points nearer than this part of what lies around them are the same. */
export const POSITION_GAP = 1e-9;

/** @param {Float64Array} jets @param {number} i @param {number} offset of three numbers in a jet */
export const vector = (jets, i, offset) => jets.subarray(18 * i + offset, 18 * i + offset + 3);

/** The largest distance from a point to those of these samples that are finite. @param {Float64Array} jets @param {ArrayLike<number>} point */
export function reach(jets, point) {
  let farthest = 0;
  for (let i = 0; i < jets.length / 18; i++) {
    const away = gap(vector(jets, i, 0), point);
    if (away > farthest && away < Infinity) farthest = away;
  }
  return farthest;
}

/**
 * An edge of a rectangle by its number, 1 + 2 · across + side: the coordinate that is constant there, the other one, and 0 for the lower edge, 1 for the upper.
 * @param {number} edge
 */
export const edgeOf = (edge) => ({ across: (edge - 1) >> 1, along: edge > 2 ? 0 : 1, side: (edge - 1) & 1 });

/** 17 × 17 places. @param {Range} range */
export function gridPlaces({ lower, upper }) {
  const places = [];
  for (let i = 0; i <= GRID; i++)
    for (let j = 0; j <= GRID; j++)
      places.push(lower[0] + (i / GRID) * (upper[0] - lower[0]), lower[1] + (j / GRID) * (upper[1] - lower[1]));
  return places;
}

/** Diagonal of the bounding box of those of these samples that are finite. @param {Jets} jets @param {Range} range */
export function diagonal(jets, range) {
  const places = gridPlaces(range);
  const sampled = jets(places);
  const [low, high] = [
    [Infinity, Infinity, Infinity],
    [-Infinity, -Infinity, -Infinity],
  ];
  for (let i = 0; i < places.length / 2; i++)
    for (let k = 0; k < 3; k++) {
      if (Number.isFinite(sampled[18 * i + k])) {
        low[k] = Math.min(low[k], sampled[18 * i + k]);
        high[k] = Math.max(high[k], sampled[18 * i + k]);
      }
    }
  return gap(low, high);
}

/** Places along a line of the rectangle. @param {Range} range @param {number} direction of the coordinate that is constant there @param {number} side where: 0, the lower edge, to 1, the upper @param {number[]} fractions */
export function linePlaces({ lower, upper }, direction, side, fractions = FRACTIONS) {
  const other = 1 - direction;
  const constant = (1 - side) * lower[direction] + side * upper[direction];
  return fractions.flatMap((fraction) => {
    const along = lower[other] + fraction * (upper[other] - lower[other]);
    return direction === 0 ? [constant, along] : [along, constant];
  });
}
