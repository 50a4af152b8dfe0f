/** Surfaces turned, moved and scaled: their formulas are rewritten, so that nothing of the library takes part. */

/** What is done to space: every point is turned, moved, then scaled. @typedef {{ factor?: number, rotation?: number[][], shift?: number[] }} SpaceMap */

/** A turn about the axis (1, 2, 2)/3 by an angle whose cosine is 0.6, and a shift. @type {SpaceMap} */
export const MOTION = { rotation: rotationAbout([1 / 3, 2 / 3, 2 / 3], 0.6, 0.8), shift: [0.3, -1.1, 0.7] };

/** Rodrigues' formula. @param {number[]} axis @param {number} cosine @param {number} sine */
function rotationAbout([x, y, z], cosine, sine) {
  const [axis, skew] = [
    [x, y, z],
    [0, -z, y, z, 0, -x, -y, x, 0],
  ];
  return axis.map((a, i) => axis.map((b, j) => (i === j ? cosine : 0) + (1 - cosine) * a * b + sine * skew[3 * i + j]));
}

const IDENTITY = rotationAbout([1, 0, 0], 1, 0);

/** @param {number[]} point @param {SpaceMap} map */
export function mapPoint(point, { factor = 1, rotation = IDENTITY, shift = [0, 0, 0] }) {
  return rotation.map((row, i) => factor * (row.reduce((sum, r, j) => sum + r * point[j], 0) + shift[i]));
}

/** The same surface after a map of space. @param {any} definition @param {SpaceMap} map */
export function transform(definition, { factor = 1, rotation = IDENTITY, shift = [0, 0, 0] }) {
  const { x, y, z, f, bounds, ...rest } = definition;
  if (definition.kind === 'parametric') {
    const mapped = rotation.map((row, i) => `${factor}*((${row[0]})*(${x})+(${row[1]})*(${y})+(${row[2]})*(${z})+(${shift[i]}))`);
    return { ...rest, x: mapped[0], y: mapped[1], z: mapped[2] };
  }
  const back = [0, 1, 2].map((j) => `(${rotation.map((row, i) => `(${row[j]})*(${'xyz'[i]}/${factor}-(${shift[i]}))`).join('+')})`);
  const inner = f.replace(/\b[xyz]\b/g, (/** @type {string} */ name) => back['xyz'.indexOf(name)]);
  const reach = factor * (Math.hypot(...shift) + Math.max(...bounds.map((/** @type {number[]} */ [, high]) => high)));
  return { ...rest, f: inner, bounds: [0, 1, 2].map(() => [-reach, reach]) };
}
