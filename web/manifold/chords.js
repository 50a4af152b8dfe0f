/** Lengths of chords of a polyline in the rectangle, from what is measured at their ends alone: many of them, quickly. */

/** Numbers of a place: x y z; x y z and the square of a density; E F G. */
const WIDTH = { space: 3, density: 4, form: 3 };

/**
 * The mean of what both ends of a chord measure: its length in space, by densities, or of its du and dv by E, F and G.
 * @param {ArrayLike<number>} places u v of each @param {Float64Array} measured numbers of each place @param {keyof typeof WIDTH} by @returns {Float64Array} one less than places; NaN where length is not real
 */
export function chordLengths(places, measured, by) {
  const width = WIDTH[by];
  const count = places.length / 2 - 1;
  const lengths = new Float64Array(count);
  for (let i = 0; i < count; i++) {
    const [a, b] = [width * i, width * (i + 1)];
    if (by === 'form') {
      const [du, dv] = [places[2 * i + 2] - places[2 * i], places[2 * i + 3] - places[2 * i + 1]];
      lengths[i] = 0.5 * (formLength(measured, a, du, dv) + formLength(measured, b, du, dv));
      continue;
    }
    let squared = 0;
    for (let j = 0; j < 3; j++) squared += (measured[b + j] - measured[a + j]) ** 2;
    lengths[i] = Math.sqrt(squared) * (by === 'space' ? 1 : 0.5 * (Math.sqrt(measured[a + 3]) + Math.sqrt(measured[b + 3])));
  }
  return lengths;
}

/** @param {Float64Array} form @param {number} at where E, F and G stand in it @param {number} du @param {number} dv */
const formLength = (form, at, du, dv) => Math.sqrt(form[at] * du * du + 2 * form[at + 1] * du * dv + form[at + 2] * dv * dv);
