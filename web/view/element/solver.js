/** One solver for all elements of a page. */

import { load } from '../../index.js';

/** @typedef {import('../../instance.js').Surfpath} Surfpath */

/** @type {Promise<Surfpath> | null} */
let solver = null;

/** Rejects as `load` does; the next call tries again. @returns {Promise<Surfpath>} */
export function getSolver() {
  solver ??= load();
  solver.catch(() => {
    solver = null;
  });
  return solver;
}
