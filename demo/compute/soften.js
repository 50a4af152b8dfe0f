/** Where what colours a rectangle's mesh jumps between neighbouring vertices, colours would be stairs: there a vertex has the mean of the cell around it. */

/** Values jump where the larger one of two neighbours is so many times the smaller. */
const JUMP = 1.3;
/** Places looked at in a cell, each way. */
const SIDE = 4;

/**
 * @param {Float64Array} values one a vertex of the grid, whose lines are equally apart, then of its twins
 * @param {Float64Array} places u v … of the vertices, v fastest @param {number[]} twins
 * @param {{ u: number[], v: number[] }} ranges of the rectangle
 * @param {(places: Float64Array) => Float64Array} sample values at other places
 * @returns {Float64Array}
 */
export function soften(values, places, twins, { u, v }, sample) {
  const count = values.length - twins.length;
  const row = Math.sqrt(count);
  const differs = (/** @type {number} */ i, /** @type {number} */ j) =>
    Math.max(values[i], values[j]) > JUMP * Math.min(values[i], values[j]);
  const isBeside = (/** @type {number} */ i) =>
    (i % row > 0 && differs(i, i - 1)) ||
    (i % row < row - 1 && differs(i, i + 1)) ||
    (i >= row && differs(i, i - row)) ||
    (i < count - row && differs(i, i + row));
  const beside = Array.from({ length: count }, (_, i) => i).filter(isBeside);
  const [du, dv] = [u, v].map(([low, high]) => (high - low) / (row - 1) / SIDE);
  const clip = (/** @type {number} */ x, /** @type {number[]} */ [low, high]) => Math.min(Math.max(x, low), high);
  const offsets = Array.from({ length: SIDE * SIDE }, (_, k) => [k % SIDE, Math.floor(k / SIDE)].map((x) => x + 0.5 - SIDE / 2));
  const seen = sample(
    Float64Array.from(
      beside.flatMap((i) => offsets.flatMap(([a, b]) => [clip(places[2 * i] + a * du, u), clip(places[2 * i + 1] + b * dv, v)])),
    ),
  );
  const softened = values.slice();
  for (const [k, i] of beside.entries())
    softened[i] = seen.subarray(k * offsets.length, (k + 1) * offsets.length).reduce((sum, x) => sum + x, 0) / offsets.length;
  for (const [k, i] of twins.entries()) softened[count + k] = softened[i];
  return softened;
}
