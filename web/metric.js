/** How length is measured where space does not do it alone: densities and metric tensors, checked and compiled into what the solver reads. */

import { checkExpression } from './definition.js';
import { compile } from './expression/compile.js';
import { describe } from './path.js';

/** @typedef {import('./expression/compile.js').Compiled} Compiled */

/** enum sp_surface_metric of wasm/surface.h */
export const METRIC = { induced: 0, density: 1, tensor: 2 };

/** What a `metric` holds: as callers name its entries, and in the order in which the solver reads them. @type {Record<string, { entries: string[], order: string[] }>} */
const TENSOR = {
  parametric: { entries: ['E', 'F', 'G'], order: ['E', 'F', 'G'] },
  implicit: { entries: ['xx', 'xy', 'xz', 'yy', 'yz', 'zz'], order: ['xx', 'xy', 'yy', 'xz', 'yz', 'zz'] },
};

/** @param {string} kind @param {any} definition */
export function checkMetric(kind, { density, metric }) {
  if (kind === 'metric') {
    if (density !== undefined || metric !== undefined)
      throw new RangeError(`${kind}: a surface given by E, F and G takes no density or metric; multiply E, F and G by ρ² instead`);
    return;
  }
  if (density === undefined && metric === undefined) return;
  if (density !== undefined) checkExpression(kind, 'density', density);
  if (metric === undefined) return;
  const { entries } = TENSOR[kind];
  const what = `{ ${entries.join(', ')} }`;
  if (typeof metric !== 'object' || metric === null) throw new TypeError(`${kind}: metric must be ${what}, not ${describe(metric)}`);
  for (const name of entries) {
    if (metric[name] === undefined) throw new TypeError(`${kind}: metric must be ${what}; ${name} is missing`);
    checkExpression(kind, `metric.${name}`, metric[name]);
  }
}

/**
 * Compiles what measures length, if it is not space alone: the function `jet` of wasm/surface.h for that metric.
 * @param {'parametric' | 'implicit' | 'metric'} kind @param {any} definition @param {string[]} variables
 * @param {Record<string, number>} parameters @param {import('./expression/compile.js').Apply} apply
 * @returns {{ code: number, compiled: Compiled } | null}
 */
export function compileMetric(kind, definition, variables, parameters, apply) {
  const { density, metric, x, y, z, f } = definition;
  if (kind === 'metric' || (density === undefined && metric === undefined)) return null;
  const [shape, names] =
    kind === 'implicit'
      ? [[f], ['f']]
      : metric
        ? [[], []]
        : [
            [x, y, z],
            ['x', 'y', 'z'],
          ];
  const order = metric ? TENSOR[kind].order : [];
  const factors = metric ? order.map((name) => metric[name]) : [1];
  const compiled = compile({
    outputs: [...shape, ...factors],
    names: [...names, ...order.map((name) => `metric.${name}`)],
    variables,
    parameters,
    valueOrder: 0,
    density:
      density === undefined ? undefined : { source: density, positions: kind === 'parametric' ? { x, y, z } : {}, from: shape.length },
    apply,
  });
  return { code: metric ? METRIC.tensor : METRIC.density, compiled };
}
