/** The metric that is measured by, where it is not that of space: opened to be drawn. */

import { Tensor } from './tensor.js';

/** @typedef {import('surfpath').Surface} Surface */
/** @typedef {(Surface & { kind: 'metric' }) | Tensor} Gauge of kind 'metric': E, F, G over u, v; 'space': six entries over x, y, z */

/**
 * Null where length is that of space, or the metric is written with more than u and v.
 * @param {import('surfpath').Surfpath} surfpath @param {Surface} surface @param {any} definition
 * @returns {Gauge | null}
 */
export function openGauge(surfpath, surface, { metric, parameters }) {
  if (surface.kind === 'metric') return /** @type {Gauge} */ (surface);
  if (!metric) return null;
  if (surface.kind === 'implicit') return new Tensor(surfpath, metric, parameters);
  const { u, v } = /** @type {NonNullable<Surface['domain']>} */ (surface.domain);
  try {
    return /** @type {Gauge} */ (surfpath.metric({ ...metric, u, v, parameters }));
  } catch {
    return null;
  }
}
