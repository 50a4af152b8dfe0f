/** The library with a clock around each path that its solver finds: what of the time is WebAssembly's, JavaScript left out. */
import { load } from 'surfpath';

/**
 * Loads it.
 * @returns {Promise<{ surfpath: Awaited<ReturnType<typeof load>>, measure: (run: () => unknown) => number }>} measure: milliseconds of a task that the solver takes
 */
export async function loadClocked() {
  let spent = 0;
  const clock = (/** @type {Function} */ solve, /** @type {number[]} */ given) => {
    const start = performance.now();
    const status = solve(...given);
    spent += performance.now() - start;
    return status;
  };
  const { Instance } = WebAssembly;
  const construct = (/** @type {unknown} */ _, /** @type {[WebAssembly.Module]} */ [module]) => {
    const exports = /** @type {Record<string, any>} */ (new Instance(module).exports);
    return { exports: { ...exports, sp_solve_path: (/** @type {number[]} */ ...given) => clock(exports.sp_solve_path, given) } };
  };
  /* The solver's instance is the one made while it is loaded. */
  WebAssembly.Instance = /** @type {typeof Instance} */ (new Proxy(Instance, { construct }));
  const surfpath = await load().finally(() => {
    WebAssembly.Instance = Instance;
  });
  const measure = (/** @type {() => unknown} */ run) => {
    spent = 0;
    run();
    return spent;
  };
  return { surfpath, measure };
}
