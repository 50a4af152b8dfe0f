/** A surface as its users see it: every question that can be asked about it, its arguments checked, and handed on. No mathematics. */

import { checkOptions, refuseReceiver, wholeNumber } from './arguments.js';
import { readPairOptions, readPairs } from './batch.js';
import { checkParameters, readList, readNumbers } from './definition.js';
import { DISPOSE } from './dispose.js';
import { findGeodesics, findPath } from './intrinsic.js';
import { SHAPE } from './manifold/kind.js';
import { Manifold } from './manifold/manifold.js';
import { measureField, readFieldOptions } from './mesh/field.js';
import { meshSurface } from './mesh/mesh.js';
import { evaluateNormals } from './mesh/normals.js';
import { projectOnto } from './mesh/projection.js';
import { isGeodesic, MOST_POINTS, makePath, readOptions, readStart, scaled } from './path.js';
import { emptyPath } from './runtime/result.js';
import { NOT_FINITE, OFF_SURFACE } from './runtime/status.js';
import { COMPARED_POINTS, ELEMENTS } from './search/candidates.js';
import { settleEnd } from './search/routes.js';
import { readTrace, readTraceOptions, traceFrom } from './trace.js';
import { gap } from './vector.js';
import { passThrough } from './via.js';

/** @typedef {import('./path.js').Path} Path */
/** @typedef {import('./path.js').PathOptions} PathOptions */
/** @typedef {import('./path.js').PairOptions} PairOptions */
/** @typedef {import('./path.js').GeodesicsOptions} GeodesicsOptions */
/** @typedef {import('./trace.js').TraceOptions} TraceOptions */
/** @typedef {import('./mesh/mesh.js').Mesh} Mesh */
/** @typedef {import('./mesh/field.js').FieldOptions} FieldOptions */
/** @typedef {import('./mesh/field.js').DistanceField} DistanceField */

/**
 * @typedef {object} ParameterDomain
 * @property {[number, number]} u range of u, as the definition has it
 * @property {[number, number]} v range of v
 * @property {{ u: boolean, v: boolean }} periodic which directions wrap: they have no edges
 * @property {{ along: 'u' | 'v', sign: number, offset: number }} [turn] where there is a seam at which the surface is turned over or shifted: one turn on along that
 *   direction, the place with the other coordinate w is the one that had it at sign · w + offset
 */

/** So far from an implicit surface, in parts of the diagonal of its bounds, a point is on it: as in wasm/start.c. */
const FAR = 0.1;
/** More than are found as a rule: mirror images on a torus are nine, and their doubles. */
const MOST_GEODESICS = 16;
/** Statuses of what is no geodesic yet. */
const AT_NO_REST = ['stalled', 'iteration-limit'];

export class Surface {
  /** What a console shows: bundling shortens the name of the class itself. */
  static name = 'Surface';
  #manifold;
  #forget;

  /** Made by the factories of an instance. @internal @param {import('./runtime/solver.js').Solver} solver @param {string} kind of the definition @param {any} definition @param {() => void} forget called when it is disposed */
  constructor(solver, kind, definition, forget) {
    this.#manifold = new Manifold(solver, kind, definition);
    this.#forget = forget;
  }

  /** What it is: tubes and the like are 'parametric'. */
  get kind() {
    Surface.#enter(this, 'kind');
    return this.#manifold.kind;
  }

  /** The named constants and their values, a copy. */
  get parameters() {
    Surface.#enter(this, 'parameters');
    return { ...this.#manifold.parameters };
  }

  /**
   * The closed parameter rectangle and which of its directions wrap; null for implicit surfaces.
   * @returns {ParameterDomain | null}
   */
  get domain() {
    Surface.#enter(this, 'domain');
    const { domain } = this.#manifold;
    const turn = domain?.turn;
    return (
      domain && {
        u: [domain.written.lower[0], domain.written.upper[0]],
        v: [domain.written.lower[1], domain.written.upper[1]],
        periodic: { u: domain.periodic[0], v: domain.periodic[1] },
        ...(turn && { turn: { along: turn.direction ? 'v' : 'u', sign: turn.sign, offset: turn.offset } }),
      }
    );
  }

  /**
   * The shortest path between two points: of all that a graph search found, or near a given start.
   * @param {ArrayLike<number>} from u v in the rectangle (any number in a periodic direction), or x y z (projected onto the surface first)
   * @param {ArrayLike<number>} to
   * @param {PathOptions} [options]
   * @returns {Path}
   */
  shortestPath(from, to, options) {
    const caller = Surface.#enter(this, 'shortestPath');
    const [first, last] = [this.#manifold.readPoint(caller, 'from', from), this.#manifold.readPoint(caller, 'to', to)];
    const { solve, start, via } = readOptions(caller, options, ['via']);
    const asked = this.#inSpace(solve);
    const field = this.#manifold.field();
    if (via.length > 0) {
      const stops = Array.from(via, (point, i) => this.#manifold.readPoint(caller, `options.via[${i}]`, point));
      return this.#scaled(passThrough(field, caller, [first, ...stops, last], asked, start));
    }
    return this.#scaled(findPath(field, [first, last], asked, start === 'global' ? start : readStart(caller, start, field.domain)));
  }

  /**
   * All locally shortest paths between two points that a graph search finds, shortest first. Empty if there is none; one of status `out-of-memory` where there
   * may be some.
   * @param {ArrayLike<number>} from as for {@link shortestPath}
   * @param {ArrayLike<number>} to
   * @param {GeodesicsOptions} [options]
   * @returns {Path[]}
   */
  geodesics(from, to, options) {
    const caller = Surface.#enter(this, 'geodesics');
    const ends = [this.#manifold.readPoint(caller, 'from', from), this.#manifold.readPoint(caller, 'to', to)];
    const { solve, start } = readOptions(caller, options, ['max']);
    const { max = MOST_GEODESICS } = options ?? {};
    wholeNumber(caller, 'max', max, 1, MOST_POINTS);
    if (start !== 'global') throw new RangeError(`${caller}: options.start must be 'global'`);
    const field = this.#manifold.field();
    const asked = this.#inSpace(solve);
    const found = findGeodesics(field, ends, asked, max).filter(
      ({ index, status }) => (index === 0 && !AT_NO_REST.includes(status)) || status === 'out-of-memory',
    );
    // The shortest is looked for in more ways than all of them are.
    const shortest = findPath(field, ends, asked, 'global');
    const mayBeIt = (/** @type {Path} */ { length, lengthError }) => length - lengthError <= shortest.length + shortest.lengthError;
    /* What is not solved does not stand for what is, however much its error leaves open. */
    const isAsGood = (/** @type {Path} */ path) => path.converged || (isGeodesic(path) && !shortest.converged);
    const isKnown = !isGeodesic(shortest) || found.some((path) => isAsGood(path) && mayBeIt(path));
    const all = isKnown ? found : [shortest, ...found.filter((path) => !mayBeIt(path))].slice(0, max);
    return all.map((path) => this.#scaled(path));
  }

  /**
   * The lengths of the shortest paths of many pairs of points, to the bit those of {@link shortestPath}.
   * @param {ArrayLike<number>} pairs both points of each pair, one after the other: u v u v, or x y z x y z
   * @param {PairOptions} [options] as for shortestPath; `start` 'global' or 'straight', no `via`
   * @returns {Float64Array} a length a pair; NaN where there is no path, or a point is not finite or outside the rectangle
   */
  lengths(pairs, options) {
    return Float64Array.from(this.#solvePairs('lengths', pairs, options, true), ({ length }) => length);
  }

  /**
   * The shortest paths of many pairs of points, to the bit those of {@link shortestPath}.
   * @param {ArrayLike<number>} pairs both points of each pair, one after the other: u v u v, or x y z x y z
   * @param {PairOptions} [options] as for shortestPath; `start` 'global' or 'straight', no `via`
   * @returns {Path[]} a path a pair; status `not-finite` where a number is not, `off-surface` where a point lies outside the rectangle
   */
  shortestPaths(pairs, options) {
    return Array.from(this.#solvePairs('shortestPaths', pairs, options));
  }

  /**
   * How far all of the surface is from a point: geodesic distance at the vertices of its mesh.
   * @param {ArrayLike<number>} from u v in the rectangle (any number in a periodic direction), or x y z (projected onto the surface first)
   * @param {FieldOptions} [options]
   * @returns {DistanceField}
   */
  distanceField(from, options) {
    const caller = Surface.#enter(this, 'distanceField');
    this.#checkPositions(caller);
    const { exact, resolution } = readFieldOptions(caller, options);
    const point = this.#manifold.readPoint(caller, 'from', from);
    const manifold = this.#manifold;
    const mesh = meshSurface(manifold, caller, resolution);
    const field = manifold.field();
    let place = point;
    if (!manifold.domain) {
      /* First as an end of a path is put onto the surface. */
      const settled = settleEnd(field, point);
      place = projectOnto(manifold, `${caller}: from`, settled, settled);
      if (gap(place, point) > FAR * manifold.extent)
        throw new RangeError(`${caller}: from is farther from the surface than a tenth of its bounds; project it first`);
    }
    return { mesh, distances: measureField(field, caller, place, mesh, exact).map((distance) => manifold.factor * distance) };
  }

  /**
   * The geodesic from a point in a direction: the exponential map. It ends early, with status `edge-reached`, on an edge of the rectangle.
   * @param {ArrayLike<number>} from u v in the rectangle (any number in a periodic direction), or x y z (projected onto the surface first)
   * @param {ArrayLike<number>} direction du dv, or x y z, of which the tangent part counts, not its length; without one it throws
   * @param {number} length how far, ≥ 0
   * @param {TraceOptions} [options]
   * @returns {Path} index −1, energy and gradientNorm NaN, no history; `conjugate`: the length at which the geodesic ceases to be locally shortest
   *   (null also where that is not computed: on an implicit surface with a `metric`, and beyond a crease)
   */
  trace(from, direction, length, options) {
    const caller = Surface.#enter(this, 'trace');
    const start = this.#manifold.readPoint(caller, 'from', from);
    const asked = readTrace(caller, direction, length, this.#manifold.variables);
    asked.length /= this.#manifold.factor;
    return this.#scaled(traceFrom(this.#manifold, caller, start, asked, readTraceOptions(caller, options)));
  }

  /**
   * Evaluates the surface.
   * @param {ArrayLike<number>} points parametric: u v a point; implicit: x y z
   * @returns {Float64Array} parametric: position and unit normal, 6 numbers a point (NaN normals where S_u × S_v = 0); implicit: f and ∇f, 4;
   *   metric: E, F and G, 3
   */
  evaluate(points) {
    const caller = Surface.#enter(this, 'evaluate');
    const places = readList(`${caller}: points`, points, this.#manifold.variables, 'point');
    return this.#manifold.kind === 'parametric' ? evaluateNormals(this.#manifold, places) : this.#manifold.evaluate('value', places);
  }

  /**
   * The point of the surface closest to a point of space.
   * @param {ArrayLike<number>} point x y z
   * @param {ArrayLike<number>} [near] where to start: u v (default: those points of a grid that are nearer than all beside them) or x y z (default: the point itself and, where that leads nowhere
   *   or far, the nearest vertex of a mesh inside the bounds)
   * @returns {number[]} u v, or x y z
   */
  project(point, near) {
    const caller = Surface.#enter(this, 'project');
    this.#checkPositions(caller);
    const target = readNumbers(caller, 'point', point, SHAPE.implicit.variables);
    return projectOnto(this.#manifold, caller, target, near === undefined ? null : this.#manifold.readPoint(caller, 'near', near));
  }

  /**
   * Triangles, to draw.
   * @param {{ resolution?: number }} [options] cells a direction of the rectangle (default 96), or along the longest side of the bounds (default 64, or up to 128 if two sheets
   *   of the surface are too near to each other for 64; of a flat body along each of its axes); 1 … 256
   * @returns {Mesh}
   */
  mesh(options) {
    const caller = Surface.#enter(this, 'mesh');
    this.#checkPositions(caller);
    return meshSurface(this.#manifold, caller, checkOptions(caller, options, ['resolution']).resolution);
  }

  /**
   * Changes named parameters, without recompiling.
   * @param {Record<string, number>} parameters those that change
   */
  set(parameters) {
    const caller = Surface.#enter(this, 'set');
    const changed = checkParameters(caller, parameters);
    const { parameters: known } = this.#manifold;
    for (const name of Object.keys(changed))
      if (!(name in known))
        throw new RangeError(`${caller}: the surface has no parameter '${name}'; it has ${Object.keys(known).join(', ') || 'none'}`);
    this.#manifold.set(caller, changed);
  }

  /** Frees the surface's memory and table slots. Using it afterwards throws; disposing twice does not. */
  dispose() {
    if (Surface.#own(this, 'dispose').isDisposed) return;
    this.#manifold.dispose();
    this.#forget();
  }

  /** As {@link dispose}: for `using`. */
  [DISPOSE]() {
    this.dispose();
  }

  /** Throws where a method has lost its surface. @param {Surface} surface @param {string} caller */
  static #own(surface, caller) {
    if (!(#manifold in Object(surface))) refuseReceiver(caller, 'a surface', 'surface');
    return surface.#manifold;
  }

  /**
   * Throws where a method has lost its surface, or the surface is gone.
   * @param {Surface} surface @param {string} caller @returns {string} caller
   */
  static #enter(surface, caller) {
    if (Surface.#own(surface, caller).isDisposed) throw new Error(`${caller}: this surface was disposed`);
    return caller;
  }

  /** Options as they are where length is that of space. @param {import('./runtime/heap.js').SolveOptions} options */
  #inSpace(options) {
    const { factor } = this.#manifold;
    return factor === 1 ? options : { ...options, gradientTolerance: options.gradientTolerance / factor ** 2 };
  }

  /** @param {Path} path where length is that of space */
  #scaled(path) {
    return scaled(path, this.#manifold.factor);
  }

  /** @param {string} caller */
  #checkPositions(caller) {
    if (this.#manifold.kind === 'metric') throw new RangeError(`${caller}: a surface given by E, F and G has no positions in space`);
  }

  /**
   * The path of each pair, one by one.
   * @param {string} caller @param {ArrayLike<number>} pairs @param {PairOptions} [options] @param {boolean} [shapeless] only lengths are wanted
   * @returns {Iterable<Path>}
   */
  *#solvePairs(caller, pairs, options, shapeless = false) {
    Surface.#enter(this, caller);
    const { solve, start } = readPairOptions(caller, options);
    // Elements are sampled in the end, chords are what is solved; but what is compared has points.
    if (shapeless && solve.algorithm === ELEMENTS) solve.points = start === 'global' ? COMPARED_POINTS : 1;
    const asked = this.#inSpace(solve);
    for (const ends of readPairs(caller, pairs, this.#manifold.variables, this.#manifold.domain)) {
      if (ends === NOT_FINITE || ends === OFF_SURFACE) yield makePath(emptyPath(ends));
      else yield this.#scaled(findPath(this.#manifold.field(), ends, asked, start === 'global' ? start : null));
    }
  }
}
