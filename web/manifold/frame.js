/** Frames along a curve, for what is carried along it: two unit vectors across the curve, "left" and "up", as nodes of a graph.
 *
 * left is across the curve and a reference direction, up = tangent × left. That is a formula in the curve's first derivative: it bends without a
 * flip through straight pieces and points of inflection, where a normal of Frenet has none, and closes where the curve closes. The one thing it
 * needs is a reference that is nowhere along the curve. */

/** @typedef {import('../expression/graph.js').Graph} Graph */

/**
 * @param {import('../expression/compile.js').Formulas} formulas
 * @param {number[]} curve three nodes over the variable t
 * @param {number[]} reference three nodes
 * @returns {{ left: number[], up: number[] }}
 */
export function frameAlong({ graph, slope }, curve, reference) {
  const along = curve.map((node) => slope(node, 't'));
  const left = normalized(graph, cross(graph, reference, along));
  return { left, up: cross(graph, normalized(graph, along), left) };
}

/** @param {Graph} g @param {number[]} a @param {number[]} b */
function cross(g, a, b) {
  return [0, 1, 2].map((i) => {
    const [j, k] = [(i + 1) % 3, (i + 2) % 3];
    return g.subtract(g.multiply(a[j], b[k]), g.multiply(a[k], b[j]));
  });
}

/** @param {Graph} g @param {number[]} a */
function normalized(g, a) {
  const square = a.map((x) => g.integerPower(x, 2)).reduce((x, y) => g.add(x, y));
  const inverse = g.divide(g.one, g.squareRoot(square));
  return a.map((x) => g.multiply(x, inverse));
}
