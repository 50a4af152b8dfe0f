/** The page's worker: one instance of the solver, one surface at a time, and the tasks of tasks.js. */

import { ExpressionError, load } from 'surfpath';
import { Workshop } from './compute/tasks.js';

const loading = load();
/** @type {Workshop | null} */ let workshop = null;
/** The last task that is no longer wanted. */
let stopped = 0;

/** Errors lose their fields on the way between threads. @param {unknown} error */
function describe(error) {
  if (!(error instanceof Error)) return { message: String(error) };
  const { name, message } = error;
  return error instanceof ExpressionError
    ? { name, message, source: error.source, index: error.index, argument: error.argument }
    : { name, message };
}

/** The memory of a mesh, which is handed over rather than copied: it is large, and nobody needs it here. @param {any} result */
function buffersOf(result) {
  const arrays = [result?.positions, result?.normals, result?.parameters, result?.indices].filter(ArrayBuffer.isView);
  return [...new Set(arrays.filter(({ byteLength, buffer }) => byteLength === buffer.byteLength).map(({ buffer }) => buffer))];
}

self.addEventListener('message', async ({ data: { id, task, request, stop } }) => {
  if (stop) {
    stopped = stop;
    return;
  }
  const report = (/** @type {any} */ progress) => self.postMessage({ id, progress }, { transfer: buffersOf(progress.mesh) });
  try {
    workshop ??= new Workshop(await loading);
    const result = /** @type {any} */ (await workshop.run(task, request, { report, isStopped: () => stopped === id }));
    self.postMessage({ id, result }, { transfer: buffersOf(result?.mesh ?? result) });
  } catch (error) {
    self.postMessage({ id, error: describe(error) });
  }
});
