/**
 * What a machine may take for what is wanted in so many milliseconds. Times are wanted on a processor of 3.8 GHz that does nothing else; one that is slower, or lent to
 * others at the moment, is allowed as many times more as it takes for plain arithmetic.
 */

/** Products and sums, each waiting for the last: 8 cycles a turn on every processor of today. */
const TURNS = 2e6;
const WANTED = (8 * TURNS) / 3.8e6;
const RUNS = 7;

/** Milliseconds of plain arithmetic. */
function compute() {
  const start = performance.now();
  let x = 1.1;
  for (let i = 0; i < TURNS; i++) x = x * 1.0000001 + 1e-9;
  return x > 0 ? performance.now() - start : Number.NaN;
}

/** @param {number} milliseconds wanted @returns {number} those and, on a slow machine, more */
export function allowance(milliseconds) {
  const times = Array.from({ length: RUNS }, compute).sort((a, b) => a - b);
  return milliseconds * Math.max(1, times[RUNS >> 1] / WANTED);
}
