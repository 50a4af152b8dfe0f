/** `load` and what it gives: one instance of the solver, and the factories of surfaces. The two entries, with the module inlined or beside, share it. */

import { checkObject, checkOptions, refuseName, refuseReceiver } from './arguments.js';
import { DISPOSE } from './dispose.js';
import { PARAMETRIC_KINDS } from './manifold/shapes.js';
import { compileSolver, Solver } from './runtime/solver.js';
import { Surface } from './surface.js';

/** @typedef {import('./definition.js').ParametricDefinition} ParametricDefinition */
/** @typedef {import('./definition.js').ImplicitDefinition} ImplicitDefinition */
/** @typedef {import('./definition.js').MetricDefinition} MetricDefinition */
/** @typedef {import('./manifold/shapes.js').GraphDefinition} GraphDefinition */
/** @typedef {import('./manifold/shapes.js').RevolutionDefinition} RevolutionDefinition */
/** @typedef {import('./manifold/shapes.js').TubeDefinition} TubeDefinition */
/** @typedef {import('./manifold/shapes.js').SweepDefinition} SweepDefinition */
/** @typedef {import('./runtime/solver.js').WasmSource} WasmSource */

/**
 * A definition with the name of its kind.
 * @typedef {({ kind: 'parametric' } & ParametricDefinition) | ({ kind: 'implicit' } & ImplicitDefinition) | ({ kind: 'graph' } & GraphDefinition)
 *   | ({ kind: 'revolution' } & RevolutionDefinition) | ({ kind: 'tube' } & TubeDefinition) | ({ kind: 'sweep' } & SweepDefinition) | ({ kind: 'metric' } & MetricDefinition)} AnyDefinition
 */

const KINDS = [...PARAMETRIC_KINDS, 'implicit', 'metric'];

/** One instance: surfaces of it share a memory; two instances share nothing. Made by `load`. */
export class Surfpath {
  /** What a console shows: bundling shortens the name of the class itself. */
  static name = 'Surfpath';
  /** @type {Solver | null} */ #solver;
  /** @type {Set<Surface>} */ #surfaces = new Set();

  /** @param {WebAssembly.Module} module */
  constructor(module) {
    this.#solver = new Solver(module);
  }

  /** A parametric surface S(u, v). Throws ExpressionError, TypeError or RangeError for a definition that is wrong. @param {ParametricDefinition} definition */
  parametric(definition) {
    return Surfpath.#add(this, 'parametric', definition);
  }

  /** An implicit surface f(x, y, z) = 0. @param {ImplicitDefinition} definition */
  implicit(definition) {
    return Surfpath.#add(this, 'implicit', definition);
  }

  /** A metric ds² = E du² + 2F du dv + G dv² without positions: its paths have parameters, but no points. @param {MetricDefinition} definition */
  metric(definition) {
    return Surfpath.#add(this, 'metric', definition);
  }

  /**
   * The graph z(x, y) over a rectangle. Its u and v are x and y.
   * @param {GraphDefinition} definition
   */
  graph(definition) {
    return Surfpath.#add(this, 'graph', definition);
  }

  /**
   * A surface of revolution: the profile r(t), z(t) turned about the z axis. Its u is the angle from the x axis, its v is t.
   * @param {RevolutionDefinition} definition
   */
  revolution(definition) {
    return Surfpath.#add(this, 'revolution', definition);
  }

  /**
   * A tube of a given radius around a curve. Its u is the angle across the curve, its v is t. The curve may have straight pieces and points of
   * inflection, but must nowhere stand still; where it closes, so does the tube. The surface is smooth where the radius is smaller than the
   * curve's radius of curvature, and may meet itself elsewhere.
   * @param {TubeDefinition} definition
   */
  tube(definition) {
    return Surfpath.#add(this, 'tube', definition);
  }

  /**
   * A profile carried along a path, upright as seen along it. Its u is s, its v is t. Along the z axis a profile [x, y] keeps its x and y.
   * @param {SweepDefinition} definition
   */
  sweep(definition) {
    return Surfpath.#add(this, 'sweep', definition);
  }

  /**
   * A surface from plain data: an entry of the gallery, say. Fields that its kind does not know are ignored, but not what looks like one of its own.
   * @param {AnyDefinition} definition
   */
  surface(definition) {
    checkObject('surface: the definition', definition);
    const { kind } = definition;
    if (!KINDS.includes(kind)) refuseName('surface: kind', `one of ${KINDS.join(', ')}`, kind);
    return Surfpath.#add(this, kind, definition);
  }

  /** Disposes all surfaces, each of which leaves the list then, and lets the memory go. */
  dispose() {
    Surfpath.#check(this, 'dispose');
    for (const surface of this.#surfaces) surface.dispose();
    this.#solver = null;
  }

  /** As {@link dispose}: for `using`. */
  [DISPOSE]() {
    this.dispose();
  }

  /** Throws where a method has lost its instance. @param {Surfpath} instance @param {string} caller */
  static #check(instance, caller) {
    if (!(#solver in Object(instance))) refuseReceiver(caller, 'what load() gives', 'surfpath');
  }

  /** @param {Surfpath} to @param {string} kind @param {any} definition */
  static #add(to, kind, definition) {
    Surfpath.#check(to, kind);
    /** @type {Surface | null} */
    const surface = to.#solver && new Surface(to.#solver, kind, definition, () => to.#surfaces.delete(/** @type {Surface} */ (surface)));
    if (to.#solver && surface) {
      to.#surfaces.add(surface);
      return surface;
    }
    /* Before, or by a getter of the definition. */
    surface?.dispose();
    throw new Error(`${kind}: this instance was disposed`);
  }
}

/** @type {Map<unknown, Promise<WebAssembly.Module>>} modules compiled so far, by their addresses, or the entry whose own they are */
const compiled = new Map();

/**
 * @typedef {object} LoadOptions
 * @property {WasmSource} [wasm] another place to take the module from
 */

/** Compiles the module, for one who is named. @typedef {(caller: string, options?: LoadOptions) => Promise<WebAssembly.Module>} Compile */

/**
 * Makes what compiles an entry's module.
 * @param {() => WasmSource | Promise<WasmSource>} inlined the entry's own module
 * @returns {Compile}
 */
export function makeCompile(inlined) {
  return async (caller, options) => {
    const { wasm = inlined } = checkOptions(caller, options, ['wasm']);
    const key = wasm instanceof URL ? wasm.href : wasm;
    /* Bytes are the caller's, and an answer is read once. */
    if (typeof key === 'object') return compileSolver(caller, () => key);
    let module = compiled.get(key);
    if (!module) {
      module = compileSolver(caller, () => (wasm === inlined ? inlined() : wasm));
      compiled.set(key, module);
      module.catch(() => compiled.delete(key));
    }
    return module;
  };
}

/**
 * Makes `load` for an entry.
 * @param {Compile} compile the entry's own
 * @returns {(options?: LoadOptions) => Promise<Surfpath>}
 */
export function makeLoad(compile) {
  return async function load(options) {
    return new Surfpath(await compile('load', options));
  };
}
