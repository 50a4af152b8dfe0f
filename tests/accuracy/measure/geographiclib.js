/** Shortest paths on ellipsoids of revolution against Karney's solution of the inverse problem, GeographicLib: an oracle made by others, in other ways. */
import geographiclib from 'geographiclib-geodesic';

/** @typedef {import('../../../web/index.js').Surface} Surface */
/** @typedef {import('../../helpers/random.js').Random} Random */
/** @typedef {{ latitude: number, longitude: number }} Place degrees */
/** @typedef {{ ellipsoid: string, from: Place, to: Place, status: string, length: number, expected: number, verdict: 'right' | 'wrong' | 'refused' }} Answer */

const RADIUS = 6378137;
const DEGREE = Math.PI / 180;
const TOLERANCE = 1e-9;

/**
 * Flattening, and the error of GeographicLib's series in metres: Karney, Algorithms for geodesics (2013), section 6, and the library's documentation
 * for large flattenings.
 * @type {Record<string, { flattening: number, slack: number }>}
 */
export const ELLIPSOIDS = {
  wgs84: { flattening: 1 / 298.257223563, slack: 15e-9 },
  oblate: { flattening: 1 / 10, slack: 1.5e-3 },
  prolate: { flattening: -1 / 10, slack: 1.5e-3 },
};

/** How pairs are drawn. @type {Record<string, (random: Random) => [Place, Place]>} */
const SORTS = {
  anywhere: (random) => [anywhere(random), anywhere(random)],
  antipodal(random) {
    const from = anywhere(random);
    const away = 10 ** random.between(-6, 0.5);
    return [from, { latitude: limit(-from.latitude + away * random.normal()), longitude: from.longitude + 180 + away * random.normal() }];
  },
  near(random) {
    const from = anywhere(random);
    const away = 10 ** random.between(-3, 0);
    return [from, { latitude: limit(from.latitude + away * random.normal()), longitude: from.longitude + away * random.normal() }];
  },
  meridian(random) {
    const from = anywhere(random);
    return [from, { latitude: anywhere(random).latitude, longitude: from.longitude + random.pick([0, 180]) }];
  },
  equator: (random) => [
    { latitude: 0, longitude: anywhere(random).longitude },
    { latitude: 0, longitude: anywhere(random).longitude },
  ],
  pole: (random) => [{ latitude: random.pick([-90, 90]), longitude: anywhere(random).longitude }, anywhere(random)],
};

/** Uniform on the sphere. @param {Random} random @returns {Place} */
function anywhere(random) {
  return { latitude: Math.asin(random.between(-1, 1)) / DEGREE, longitude: random.between(-180, 180) };
}

const limit = (/** @type {number} */ latitude) => Math.min(Math.max(latitude, -90), 90);

/** The ellipsoid over longitude and reduced latitude. @param {string} name @returns {import('../../../web/instance.js').AnyDefinition} */
export function definitionOf(name) {
  return {
    kind: 'parametric',
    x: 'a*cos(u)*cos(v)',
    y: 'a*sin(u)*cos(v)',
    z: 'a*(1-f)*sin(v)',
    u: ['-pi', 'pi'],
    v: ['-pi/2', 'pi/2'],
    parameters: { a: RADIUS, f: ELLIPSOIDS[name].flattening },
  };
}

/** @param {Place} place @param {number} flattening */
function parametersOf({ latitude, longitude }, flattening) {
  const angle = latitude * DEGREE;
  const reduced = Math.abs(latitude) === 90 ? angle : Math.atan((1 - flattening) * Math.tan(angle));
  return [longitude * DEGREE, reduced];
}

/**
 * The length between two places, judged.
 * @param {string} name of the ellipsoid @param {Surface} surface of its definition @param {Place} from @param {Place} to
 * @returns {Answer}
 */
export function solvePair(name, surface, from, to) {
  const { flattening, slack } = ELLIPSOIDS[name];
  const oracle = new geographiclib.Geodesic.Geodesic(RADIUS, flattening);
  const expected = Number(oracle.Inverse(from.latitude, from.longitude, to.latitude, to.longitude).s12);
  const { status, converged, length } = surface.shortestPath(parametersOf(from, flattening), parametersOf(to, flattening));
  const right = Math.abs(length - expected) <= TOLERANCE * expected + slack;
  return { ellipsoid: name, from, to, status, length, expected, verdict: !converged ? 'refused' : right ? 'right' : 'wrong' };
}

/**
 * Solves random pairs of all sorts in turn.
 * @param {string} name of the ellipsoid @param {Surface} surface of its definition @param {Random} random @param {number} count
 */
export function solvePairs(name, surface, random, count) {
  const sorts = Object.entries(SORTS);
  return Array.from({ length: count }, (_, i) => {
    const [sort, draw] = sorts[i % sorts.length];
    return { sort, ...solvePair(name, surface, ...draw(random)) };
  });
}
