/** Measures of length to begin with, fitted to the surface that is seen: the paper's two, and climbing that counts more. */

import { state } from './state.js';

/** @typedef {import('./sketch.js').Sketch} Sketch */

/** A number as it stands in a formula. @param {number} x */
const write = (x) => String(Number(x.toPrecision(3)));

/** "(u - 2)", without what is zero. @param {string} name @param {number} x */
const shifted = (name, x) => (Math.abs(x) < 1e-9 ? name : x < 0 ? `(${name}+${write(-x)})` : `(${name}-${write(x)})`);

/** @type {Record<string, () => Partial<Sketch>>} */
export const PRESETS = {
  none: () => ({ density: '', tensor: [], colour: state.sketch.colour === 'density' ? 'plain' : state.sketch.colour }),
  bump: () => ({ density: bump(), tensor: [], colour: 'density' }),
  grain: () => ({ density: '', tensor: state.sketch.kind === 'implicit' ? grainInSpace() : grain(`(${grainAngle()})`), colour: 'plain' }),
  climb: () => ({ density: '', tensor: ['1', '0', '0', '1', '0', '9'], colour: 'plain' }),
};

/** A Gaussian hill of density in the middle between the ends. */
function bump() {
  const { ends, kind } = state.sketch;
  if (kind === 'implicit') {
    const [x, y, z] = ends[0].map((a, k) => (a + ends[1][k]) / 2);
    const size = ends[0].reduce((sum, a, k) => sum + (a - ends[1][k]) ** 2, 0) / 12;
    return `1+3*exp(-(${shifted('x', x)}^2+${shifted('y', y)}^2+${shifted('z', z)}^2)/${write(size)})`;
  }
  const domain = state.surface?.domain;
  if (!domain) return '';
  const [a, b] = [0, 1].map((k) => (ends[0][k] + ends[1][k]) / 2);
  const term = (/** @type {'u' | 'v'} */ name, /** @type {number} */ middle) => {
    const width = domain[name][1] - domain[name][0];
    const [away, turn] = [shifted(name, middle), width / Math.PI];
    // Around a direction that closes a density must repeat, or the surface is cut there.
    return `-${domain.periodic[name] ? `(${turn}sin(${away}/${turn}))` : away}^2/${write((width / 7) ** 2)}`;
  };
  return `1+3*exp(${term('u', a)}${term('v', b)})`;
}

/** Nine times as long across as along a direction that turns. @param {string} angle in brackets */
const grain = (angle) => [`9*cos${angle}^2+sin${angle}^2`, `8*sin${angle}*cos${angle}`, `9*sin${angle}^2+cos${angle}^2`];

/** The angle of the paper's rotating field, u + 0.7 v, with whole turns where the surface closes. */
function grainAngle() {
  const domain = state.surface?.domain;
  const closes = domain?.periodic.u || domain?.periodic.v;
  return closes ? 'u+v' : 'u+0.7*v';
}

/** The same across space: it turns in the planes z = const, by half a turn from one end of the surface to the other. */
function grainInSpace() {
  const size = (state.mesh?.positions ?? new Float64Array(0)).reduce((most, x) => Math.max(most, Math.abs(x)), 0) || 1;
  const [xx, xy, yy] = grain(`(${write(1.5 / size)}*(x+z))`);
  return [xx, xy, '0', yy, '0', '1'];
}
