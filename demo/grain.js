/** A metric drawn on its surface: short strokes in the direction in which length counts least, where it depends on the direction. */

/** @typedef {import('surfpath').Surface} Surface */

/** Strokes a direction of the rectangle. */
const STROKES = 22;
/** Length of a stroke, in parts of the distance between two. */
const SHARE = 0.62;
/** Ratio of the greatest to the least factor, squared, from which a direction can be seen. */
const VISIBLE = 1.15;

/** The direction of the smaller eigenvalue of E, F, G, and by how much the greater one is greater. @param {number} E @param {number} F @param {number} G */
function easiest(E, F, G) {
  const [mean, half] = [(E + G) / 2, Math.hypot((E - G) / 2, F)];
  const angle = Math.atan2(2 * F, E - G) / 2 + Math.PI / 2;
  return { direction: [Math.cos(angle), Math.sin(angle)], ratio: (mean + half) / (mean - half) };
}

/** Both ends of each stroke, x y z. @param {Surface} gauge the metric @param {Surface} drawn @returns {Float64Array} */
export function strokes(gauge, drawn) {
  const { u, v } = /** @type {NonNullable<Surface['domain']>} */ (drawn.domain);
  const cell = [(u[1] - u[0]) / STROKES, (v[1] - v[0]) / STROKES];
  const places = Array.from({ length: STROKES ** 2 }, (_, i) => [
    u[0] + ((i % STROKES) + 0.5) * cell[0],
    v[0] + (Math.floor(i / STROKES) + 0.5) * cell[1],
  ]);
  const metric = gauge.evaluate(Float64Array.from(places.flat()));
  const size = (SHARE * Math.min(...cell)) / 2;
  const ends = places.flatMap((place, i) => {
    const { direction, ratio } = easiest(metric[3 * i], metric[3 * i + 1], metric[3 * i + 2]);
    if (!(ratio > VISIBLE)) return [];
    return [-size, size].flatMap((step) => place.map((x, k) => x + step * direction[k]));
  });
  const values = drawn.evaluate(Float64Array.from(ends));
  return Float64Array.from({ length: values.length / 2 }, (_, i) => values[6 * Math.floor(i / 3) + (i % 3)]);
}
