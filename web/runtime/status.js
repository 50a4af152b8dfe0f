/** How a computation ended: enum sp_status of wasm/status.h, which tells what each means. */

export const CONVERGED = 0;
export const ITERATION_LIMIT = 1;
export const STALLED = 2;
export const TOLERANCE_NOT_MET = 3;
export const ILL_CONDITIONED = 4;
export const DISCONNECTED = -1;
export const SINGULAR_METRIC = -2;
export const SHEET_JUMP = -3;
export const OFF_SURFACE = -4;
export const NOT_FINITE = -5;
export const OUT_OF_MEMORY = -6;

/** The words of `path.status`. @type {Map<number, import('../path.js').Status>} */
export const STATUS = new Map([
  [CONVERGED, 'converged'],
  [ITERATION_LIMIT, 'iteration-limit'],
  [STALLED, 'stalled'],
  [TOLERANCE_NOT_MET, 'tolerance-not-met'],
  [ILL_CONDITIONED, 'ill-conditioned'],
  [5, 'saddle'],
  [6, 'edge-reached'],
  [DISCONNECTED, 'disconnected'],
  [SINGULAR_METRIC, 'singular-metric'],
  [SHEET_JUMP, 'sheet-jump'],
  [OFF_SURFACE, 'off-surface'],
  [NOT_FINITE, 'not-finite'],
  [OUT_OF_MEMORY, 'out-of-memory'],
]);
