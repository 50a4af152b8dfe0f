/**
 * A surface in the solver's present instance: its compiled modules, the values of its parameters, and the records by which the solver knows it. Compiles nothing, and
 * answers no questions.
 */

import { KIND } from './kind.js';
import { METRIC } from './metric.js';

/** @typedef {import('./domain.js').Domain} Domain */
/** @typedef {import('../runtime/solver.js').Solver} Solver */
/** @typedef {ReturnType<Solver['install']>} Installed */
/** @typedef {Installed & { code: number }} Measured as which of METRIC */
/** @typedef {import('../runtime/solver.js').Module} Module */
/** @typedef {{ compiled: Module, code: number }} Metric what measures length, and as which of METRIC */
/** @typedef {{ kind: 'parametric' | 'implicit' | 'metric', extent: number }} Kind of a surface, and the diagonal of its bounds */

/**
 * Tells the solver what a surface is: as space measures it, and as it measures length.
 * @param {Solver} solver @param {Kind} surface @param {Domain | null} domain its walls @param {Installed} shape as space measures it
 * @param {(Measured | null)[]} measures of length
 */
export function writeRecords({ heap }, { kind, extent }, domain, { jet, value, record }, measures) {
  const wall = (/** @type {number[]} */ ends, /** @type {number} */ open) => ends.map((end, j) => (domain?.periodic[j] ? open : end));
  const lower = domain ? wall(domain.lower, -Infinity) : [0, 0];
  const upper = domain ? wall(domain.upper, Infinity) : [0, 0];
  const shape = { kind: KIND[kind], metric: METRIC.induced, jet, value, lower, upper, extent };
  heap.writeSurface(record, kind === 'metric' ? { ...shape, metric: METRIC.tensor, value: 0 } : shape);
  for (const measure of measures) if (measure) heap.writeSurface(measure.record, { ...shape, metric: measure.code, jet: measure.jet });
}

export class Installation {
  /** As space measures it, once it is installed. @type {Installed | null} */ shape = null;
  /** What measures its length, if it is not space alone. @type {Measured | null} */ metric = null;
  /** Its own E, F and G, once somebody asks. @type {Measured | null} */ own = null;
  /** The domain whose walls the solver knows now. @type {Domain | null} */ walls = null;
  #solver;
  /** The solver's instance in which it is installed; 0: in none. */
  #generation = 0;

  /** @param {Solver} solver */
  constructor(solver) {
    this.#solver = solver;
  }

  /** Whether it is installed, and the solver has not begun anew since. */
  get isPresent() {
    return this.#generation === this.#solver.generation;
  }

  /** Installs the modules: both or, with an error, neither. @param {Module} shape @param {Metric | null} metric @param {Record<string, number>} parameters */
  install(shape, metric, parameters) {
    const [installed, measured] = this.#solver.installAll(metric ? [shape, metric.compiled] : [shape]);
    this.shape = installed;
    this.metric = metric && { ...measured, code: metric.code };
    this.own = null;
    this.#generation = this.#solver.generation;
    this.writeParameters(parameters);
  }

  /** Installs its own E, F and G, too. @param {Metric} own @param {Record<string, number>} parameters */
  installOwn({ compiled, code }, parameters) {
    this.own = { ...this.#solver.install(compiled), code };
    this.writeParameters(parameters);
  }

  /** Gives back what the solver's present instance holds of it, if anything. */
  uninstall() {
    this.#generation = 0;
    for (const installed of this.#all) if (installed) this.#solver.remove(installed);
    this.shape = this.metric = this.own = null;
  }

  /** @param {Record<string, number>} parameters */
  writeParameters(parameters) {
    for (const installed of this.#all) if (installed) this.#solver.heap.writeDoubles(installed.data, Object.values(parameters));
  }

  /** @param {Kind} surface @param {Domain | null} domain */
  write(surface, domain) {
    this.walls = domain;
    writeRecords(this.#solver, surface, domain, /** @type {Installed} */ (this.shape), [this.metric, this.own]);
  }

  get #all() {
    return [this.shape, this.metric, this.own];
  }
}
