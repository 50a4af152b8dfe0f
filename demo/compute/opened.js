/** The surfaces of the page's own thread: what is dragged on, drawn and measured there. */

import { drawnOf } from './drawn.js';
import { openGauge } from './gauge.js';
import { surfaceOf } from '../state/sketch.js';

/** @typedef {import('surfpath').Surface} Surface */
/**
 * @typedef {object} Surfaces
 * @property {Surface} surface
 * @property {Surface} drawn what is drawn of it: the surface, or the plane of a metric
 * @property {import('./gauge.js').Gauge | null} gauge the metric that is not that of space, to draw it
 */

/** @param {import('surfpath').Surfpath} surfpath @param {any} definition throws where it is wrong @returns {Surfaces} */
export function openSurfaces(surfpath, definition) {
  const surface = surfpath.surface(definition);
  try {
    return { surface, drawn: drawnOf(surfpath, surface, definition), gauge: openGauge(surfpath, surface, definition) };
  } catch (error) {
    surface.dispose();
    throw error;
  }
}

/**
 * That a surface closes in space, but not as its length is measured, which makes a wall of the seam; null: none does.
 * @param {import('surfpath').Surfpath} surfpath @param {Surface} surface @param {import('../state/sketch.js').Sketch} sketch of it
 */
export function describeWall(surfpath, { domain }, sketch) {
  if (!`${sketch.density}${sketch.tensor}`) return null;
  const inSpace = surfpath.surface(/** @type {any} */ (surfaceOf({ ...sketch, density: '', tensor: [] })));
  const isSame = JSON.stringify(inSpace.domain?.periodic) === JSON.stringify(domain?.periodic);
  inSpace.dispose();
  return isSame ? null : 'Beyond its seam length is measured otherwise: no path crosses it.';
}

/** Each of them once. @param {{ [name in keyof Surfaces]: Surfaces[name] | null }} surfaces */
const each = ({ surface, drawn, gauge }) => new Set([surface, drawn, gauge].filter((one) => one !== null));

/** @param {{ [name in keyof Surfaces]: Surfaces[name] | null }} surfaces @param {Record<string, number>} parameters */
export function setParameters(surfaces, parameters) {
  for (const one of each(surfaces)) one.set(parameters);
}

/** @param {{ [name in keyof Surfaces]: Surfaces[name] | null }} surfaces */
export function closeSurfaces(surfaces) {
  for (const one of each(surfaces)) one.dispose();
}
