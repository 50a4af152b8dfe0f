/** Long work in slices of time, between which a worker hears that it is no longer wanted. */

/** Milliseconds. */
const SLICE = 100;

/** @typedef {{ report: (progress: any) => void, isStopped: () => boolean }} Job what is told of a task, and whether it is still wanted */

/**
 * @template T
 * @param {Generator<number, T>} steps yields the share that is done, in [0, 1]
 * @param {Job} job hears the share after every slice
 * @returns {Promise<T | null>} null: it was stopped
 */
export async function runInSlices(steps, { report, isStopped }) {
  while (!isStopped()) {
    const end = performance.now() + SLICE;
    let step = steps.next();
    while (!step.done && performance.now() < end) step = steps.next();
    if (step.done) return step.value;
    report({ share: step.value });
    await new Promise((resolve) => setTimeout(resolve));
  }
  return null;
}
