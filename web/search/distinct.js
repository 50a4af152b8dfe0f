/** Which of several paths between the same ends are the same one, judged by their lengths, how often they lead around, and where they run. */

import { edgeOf } from '../manifold/rectangle.js';
import { gap } from '../vector.js';

/** @typedef {import('../manifold/rectangle.js').Range} Range */
/** @typedef {Pick<import('../manifold/tips.js').Tip, 'at' | 'pole'>} Tip */
/** @typedef {Pick<import("../runtime/result.js").RawPath, "length" | "lengthError" | "points" | "parameters" | "turns">} Compared */

/** Two paths are the same where they are nowhere farther apart, in parts of how long they are in space, or in u and v. */
const APART = 0.01;
/** Beside a way over an apex that holds, within this part of its length, is no path: rough ones come there where they stall, or cut its corner. */
export const BESIDE = 0.1;
/** Places at which two paths are compared. */
const SAMPLES = 16;

/** The length of the geodesic under a rough polyline, to fourth order. @param {Compared} path */
export const estimate = (path) => path.length + path.lengthError;

/** Sorts by that length. @param {{ path: Compared }} a @param {{ path: Compared }} b */
export const byEstimate = (a, b) => estimate(a.path) - estimate(b.path);

/** Each path once: the first of those that are the same. @template {{ path: Compared }} T @param {T[]} list @returns {T[]} */
export const firsts = (list) => list.filter((found, i) => !isAmong(list.slice(0, i), found));

/** Sorted by length, each path once. @template {{ path: Compared }} T @param {T[]} found @returns {T[]} */
export const distinct = (found) => firsts([...found].sort(byEstimate));

/** @param {Compared} a @param {Compared} b @param {number} [apart] in place of 0.01 of the length */
export const isSame = (a, b, apart = APART) => a.turns === b.turns && isAsLong(a, b, apart) && areNear(samplesOf(a), samplesOf(b), apart);

/** @param {Compared} a @param {Compared} b @param {number} apart */
const isAsLong = (a, b, apart) => !(Math.abs(estimate(a) - estimate(b)) > apart * estimate(a));

/** @param {number[][]} p places along a path @param {number[][]} q along another @param {number} apart */
function areNear(p, q, apart) {
  let [away, size] = [0, 0];
  for (let i = 0; i < SAMPLES; i++) {
    away = Math.max(away, gap(p[i], q[i]));
    size += gap(p[i], p[i + 1]);
  }
  return away <= apart * size;
}

/** Whether a path is one of these. @param {{ path: Compared }[]} list @param {{ path: Compared }} found @param {number} [apart] as for `isSame` */
export const isAmong = (list, { path }, apart) => list.some((other) => isSame(other.path, path, apart));

/**
 * Whether a path comes so near to a tip that a rough one may cut its corner there, and be shorter than any.
 * @param {Compared} path @param {Tip} tip @param {Range | null} range
 */
export function comesNear(path, tip, range) {
  const samples = samplesBeside(path, tip, range);
  const length = samples.reduce((sum, sample, i) => sum + gap(sample, samples[i - 1] ?? sample), 0);
  return samples.some((sample) => gap(sample, [0, 0, 0]) < length / SAMPLES);
}

/**
 * Whether a rough path is one that stalls beside a way over an apex, or cuts its corner. In a metric the coordinate around the apex says nothing of that: only how far from it both are is compared.
 * @param {Tip & { path: Compared }} way @param {{ path: Compared }} found @param {Range | null} range
 */
export function isBesideWay(way, { path }, range) {
  const samples = (/** @type {Compared} */ one) => samplesBeside(one, way, range);
  return comesNear(path, way, range) && isAsLong(way.path, path, BESIDE) && areNear(samples(way.path), samples(path), BESIDE);
}

/** Places along a path as they are from a tip: in space or, where it has no positions, by the coordinate across. @param {Compared} path @param {Tip} tip @param {Range | null} range */
function samplesBeside(path, { at, pole }, range) {
  const { across, side } = edgeOf(pole);
  const origin = at ?? [range?.[side ? 'upper' : 'lower'][across] ?? 0, 0, 0];
  return samplesOf(path).map((place) => (at ? place : [place[across], 0, 0]).map((x, k) => x - origin[k]));
}

/** Places along paths that were compared before. @type {WeakMap<Compared, number[][]>} */
const sampled = new WeakMap();

/** Places along a path of equal chords: points, or u v 0 where it has no positions. @param {Compared} path @returns {number[][]} */
function samplesOf(path) {
  const known = sampled.get(path);
  if (known) return known;
  const { points, parameters } = path;
  const [numbers, width] = points.length > 0 || !parameters ? [points, 3] : [parameters, 2];
  const last = numbers.length / width - 1;
  const samples = Array.from({ length: SAMPLES + 1 }, (_, i) => {
    const at = (i / SAMPLES) * last;
    const before = Math.min(Math.floor(at), last - 1);
    return [0, 1, 2].map((k) => {
      const [from, to] = [numbers[width * before + k], numbers[width * (before + 1) + k]];
      return k < width ? from + (at - before) * (to - from) : 0;
    });
  });
  sampled.set(path, samples);
  return samples;
}
