/** Numbers as colours of vertices: a scale that suits them, a palette that the colour-blind can read, and levels for contour lines. */

import { Color } from 'three';

/**
 * @typedef {object} ColourScale how numbers became colours, for a legend
 * @property {'curvature' | 'distance' | 'values'} quantity
 * @property {number} low the number at the palette's first colour; smaller ones look like it
 * @property {number} high the number at its last colour
 * @property {number} spacing of the contour lines; curvature: 0, there is one line, where K = 0
 * @property {readonly string[]} palette colours at equal steps
 */

/** Purple, grey, green: told apart with any colour vision, and neither is the path's orange nor the start's blue. */
export const DIVERGING = ['#8a5aab', '#baa0cb', '#e9e6e1', '#98c5a8', '#43986a'];
/** Light to dark, so that it reads in grey too. */
export const SEQUENTIAL = ['#faf6e3', '#cde5cf', '#98d0ca', '#6cb1cb', '#6189c0', '#6a69aa'];
const NOWHERE = '#a9a8a5';
/** Share of the vertices whose curvature is inside the scale: a few with very much would leave all others pale. */
const INSIDE = 0.95;
const BANDS = 12;
/** Numbers that differ by less than this part of the largest are one: what rounding leaves of a constant is nothing to show. */
const SAME = 1e-9;
/** Curvature below this, times the size squared, is none: what differences leave of a plane. */
const FLAT = 1e-7;

/** A round number: 1, 2 or 5 times a power of ten, not below x. @param {number} x */
function roundUp(x) {
  const power = 10 ** Math.floor(Math.log10(x));
  return power * /** @type {number} */ ([1, 2, 5, 10].find((digit) => digit * power >= x * (1 - 1e-12)));
}

/** @param {ArrayLike<number>} values @param {number} size of the surface @returns {ColourScale} zero in the middle */
export function curvatureScale(values, size) {
  const sizes = Float64Array.from(values).filter(Number.isFinite).map(Math.abs).sort();
  const most = Math.max(sizes[Math.floor(INSIDE * (sizes.length - 1))] ?? 0, FLAT / size ** 2);
  return { quantity: 'curvature', low: -most, high: most, spacing: 0, palette: DIVERGING };
}

/** @param {'distance' | 'values'} quantity @param {ArrayLike<number>} values @returns {ColourScale} */
export function bandScale(quantity, values) {
  const finite = Float64Array.from(values).filter(Number.isFinite);
  const high = finite.reduce((most, x) => Math.max(most, x), -Infinity);
  const low = quantity === 'distance' ? 0 : finite.reduce((least, x) => Math.min(least, x), Infinity);
  if (!(high - low > SAME * Math.max(high, -low))) {
    const first = Number.isFinite(low) ? low : 0;
    return { quantity, low: first, high: first + 1, spacing: 1, palette: SEQUENTIAL };
  }
  return { quantity, low, high, spacing: roundUp((high - low) / BANDS), palette: SEQUENTIAL };
}

/**
 * Colours of vertices, in three's working colour space.
 * @param {ArrayLike<number>} values @param {ColourScale} scale
 * @returns {Float32Array} r g b of each
 */
export function colourVertices(values, { low, high, palette }) {
  const stops = palette.map((name) => new Color(name));
  const nowhere = new Color(NOWHERE);
  const colour = new Color();
  const colours = new Float32Array(3 * values.length);
  for (let i = 0; i < values.length; i++) {
    const place = Math.min(Math.max((values[i] - low) / (high - low), 0), 1) * (stops.length - 1);
    const stop = Math.min(Math.floor(place), stops.length - 2);
    if (Number.isFinite(values[i])) colour.lerpColors(stops[stop], stops[stop + 1], place - stop);
    else colour.copy(nowhere);
    colour.toArray(colours, 3 * i);
  }
  return colours;
}

/**
 * What the contour lines run along: whole numbers of it. Curvature: zero alone.
 * @param {ArrayLike<number>} values @param {ColourScale} scale
 */
export function contourLevels(values, { spacing, high }) {
  return Float32Array.from(values, (x) => {
    if (!Number.isFinite(x)) return 0.5;
    return spacing > 0 ? x / spacing : Math.min(Math.max((0.45 * x) / high, -0.45), 0.45);
  });
}
