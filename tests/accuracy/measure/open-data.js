/** Solves the stored cases at a tolerance and compares lengths and error estimates with what is known. Knows nothing of how they are printed. */
import { loadCases } from '../../helpers/cases.js';

/** @typedef {import('../../helpers/cases.js').Case} Case */
/** @typedef {import('../../../web/index.js').Path} Path */
/** @typedef {import('../../../web/index.js').Surface} Surface */

/**
 * One solved case. error: relative, of the length. refused: the library does not take the definition.
 * @typedef {{ id: string, family: string, status: string, refused: boolean, converged: boolean, right: boolean, honest: boolean, error: number, lengthError: number, milliseconds: number }} Outcome
 */

/** Families whose surfaces are smooth enough for 1e-11 where 1e-12 is asked for. */
const SMOOTH = 'ABCEF';

/** The largest relative error of a right answer. Eq. 47: its smallest radius of curvature is 1e-3 of its size. @param {Case} one @param {number} tolerance */
function limitOf({ family, expected }, tolerance) {
  if (expected.surface.startsWith('bc_')) return Math.max(1e-8, 10 * tolerance);
  if (tolerance < 1e-9 && SMOOTH.includes(family)) return 10 * tolerance;
  return Math.max(tolerance, 1e-9);
}

/** @param {Case} one @param {Path} path @param {number} tolerance @param {number} milliseconds @returns {Outcome} */
function judge(one, path, tolerance, milliseconds) {
  const { length, relerr_bound: bound } = one.expected;
  const error = Math.abs(path.length - length);
  return {
    id: one.id,
    family: one.family,
    status: path.status,
    refused: false,
    converged: path.converged,
    right: path.converged && error <= limitOf(one, tolerance) * length,
    honest: error <= 10 * path.lengthError + 4 * bound * length,
    error: error / length,
    lengthError: path.lengthError / length,
    milliseconds,
  };
}

/** @param {import('../../../web/instance.js').Surfpath} surfpath @param {Case} one @returns {Surface | null} null: refused */
function make(surfpath, one) {
  try {
    return surfpath.surface(/** @type {any} */ (one.definition));
  } catch (error) {
    if (error instanceof RangeError && /not built yet/.test(error.message)) return null;
    throw error;
  }
}

/**
 * Solves all cases of some families, those of a surface one after the other; the first solve of a surface, which builds its graph, is not timed.
 * @param {import('../../../web/instance.js').Surfpath} surfpath @param {{ tolerance: number, families?: string }} options
 * @returns {Outcome[]}
 */
export function solveOpenData(surfpath, { tolerance, families = 'ABCDEF' }) {
  const cases = loadCases({ families });
  return [...new Set(cases.map(({ definition }) => JSON.stringify(definition)))].flatMap((text) => {
    const own = cases.filter(({ definition }) => JSON.stringify(definition) === text);
    const surface = make(surfpath, own[0]);
    surface?.shortestPath(own[0].from, own[0].to, { tolerance });
    const outcomes = own.map((one) => {
      const begin = performance.now();
      const path = surface?.shortestPath(one.from, one.to, { tolerance });
      return path ? judge(one, path, tolerance, performance.now() - begin) : refuse(one);
    });
    surface?.dispose();
    return outcomes;
  });
}

/** @param {Case} one @returns {Outcome} */
function refuse({ id, family }) {
  const nothing = { converged: false, right: false, honest: false, error: Number.NaN, lengthError: Number.NaN, milliseconds: Number.NaN };
  return { id, family, status: 'refused', refused: true, ...nothing };
}
