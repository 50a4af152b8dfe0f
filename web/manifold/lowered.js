/** Steep surfaces, and their like with lower heights. Compiled when somebody asks for them. MATH.md, "Steep surfaces". Knows nothing of paths. */

import { cross } from '../vector.js';
import { shapeNodes } from './metric.js';
import { gridPlaces, vector } from './rectangle.js';

/** @typedef {import('./shapes.js').Shape} Shape */

/**
 * How steep a surface is over the plane of x and y: the root mean square of its slopes at a grid of places; 0 where it does not lie over the plane in one sheet.
 * @param {(places: number[]) => Float64Array} jets @param {import('./rectangle.js').Range} range
 */
export function steepnessOf(jets, range) {
  const seen = jets(gridPlaces(range));
  let [squares, count, side] = [0, 0, 0];
  for (let i = 0; 18 * i < seen.length; i++) {
    const [x, y, up] = cross(vector(seen, i, 3), vector(seen, i, 6));
    const square = (x * x + y * y) / (up * up);
    /* At the middle of a disk there is no normal. */
    if (!Number.isFinite(square)) continue;
    if (up * side < 0) return 0;
    side = up;
    squares += square;
    count++;
  }
  return Math.sqrt(squares / count) || 0;
}

/** A name for a parameter that none has. @param {Record<string, number>} parameters */
export function freeName(parameters) {
  let name = 'height';
  while (name in parameters) name += '_';
  return name;
}

/** A shape with its heights multiplied by a parameter. @param {Shape} shape @param {string} factor name of the parameter @returns {Shape} */
export function lowerShape(shape, factor) {
  return {
    ...shape,
    outputs(formulas, reference) {
      const { graph, read } = formulas;
      const [x, y, z] = shapeNodes(shape, formulas, reference);
      return [x, y, graph.multiply(read(factor, factor, []), z)];
    },
  };
}
