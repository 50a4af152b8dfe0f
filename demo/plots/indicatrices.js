/** Ellipses of what is equally far, where a metric measures length: Tissot's indicatrices in the plane of the parameters. */

import { determinantOf } from '../compute/tensor.js';
import { state } from '../state/state.js';
import { pointList, svg } from './svg.js';

/** @typedef {import('./plane-frame.js').Frame} Frame */

/** An ellipse at points of a lattice: all that is equally far from its centre, where length is not that of space, and is one. @param {Frame} frame */
export function indicatrices(frame) {
  const { gauge } = state;
  if (gauge?.kind !== 'metric') return [];
  const cells = 9;
  const places = Array.from({ length: cells * cells }, (_, i) =>
    [i % cells, Math.floor(i / cells)].map((x, k) => frame.low[k] + ((x + 0.5) / cells) * (frame.high[k] - frame.low[k])),
  );
  const values = gauge.evaluate(Float64Array.from(places.flat()));
  const metrics = places
    .map((place, i) => ({ place, metric: values.subarray(3 * i, 3 * i + 3) }))
    .filter(({ metric: [E, F, G] }) => E > 0 && determinantOf(E, F, G) > 0 && Number.isFinite(longestRadius([E, F, G])));
  const size = (0.42 * (frame.high[0] - frame.low[0])) / cells / Math.max(...metrics.map(({ metric }) => longestRadius(metric)));
  return metrics.map(({ place, metric }) => ellipse(place, metric, size, frame));
}

/** Of an ellipse E a² + 2F ab + G b² = 1: from its greater eigenvalue, as the difference that is the smaller one may round to 0. @param {ArrayLike<number> & Iterable<number>} metric */
export function longestRadius([E, F, G]) {
  const greater = (E + G) / 2 + Math.hypot((E - G) / 2, F);
  return Math.sqrt(greater / determinantOf(E, F, G));
}

/** @param {number[]} place @param {Float64Array} metric E F G @param {number} size @param {Frame} frame */
function ellipse(place, [E, F, G], size, frame) {
  const points = Array.from({ length: 48 }, (_, i) => {
    const [a, b] = [Math.cos((i * Math.PI) / 24), Math.sin((i * Math.PI) / 24)];
    const radius = size / Math.sqrt(E * a * a + 2 * F * a * b + G * b * b);
    return frame.to([place[0] + radius * a, place[1] + radius * b]);
  });
  return svg('polygon', { points: pointList(points), class: 'indicatrix' });
}
