/** Seeded pairs of points on a surface of the gallery, for benchmarks and for the tests of convergence. */

/** What is needed of a surface, be it of the sources or of what was built. @typedef {Pick<import('../../web/surface.js').Surface, 'domain' | 'mesh'>} Ground */
/** @typedef {import('../helpers/random.js').Random} Random */
/** @typedef {[number[], number[]]} Pair */

/**
 * Makes a source of random points: uniform in the parameter rectangle, or among the vertices of an implicit surface's mesh.
 * @param {Ground} surface
 * @param {Random} random
 * @returns {() => number[]}
 */
export function pointSource(surface, random) {
  const { domain } = surface;
  if (domain) return () => [random.between(domain.u[0], domain.u[1]), random.between(domain.v[0], domain.v[1])];
  const { positions } = surface.mesh();
  return () => {
    const at = 3 * random.integer(positions.length / 3);
    return Array.from(positions.subarray(at, at + 3));
  };
}

/**
 * Random pairs of points.
 * @param {Ground} surface
 * @param {Random} random
 * @param {number} count
 * @returns {Pair[]}
 */
export function randomPairs(surface, random, count) {
  const point = pointSource(surface, random);
  return Array.from({ length: count }, () => [point(), point()]);
}
