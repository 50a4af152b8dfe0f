/** A surface: its formulas, compiled and installed, and every question that can be asked about it. Hands the work to the solver; does no mathematics of paths. */

import { readPairs, readPairOptions } from './batch.js';
import { checkBounds, checkList, checkParameters, checkPeriodic, readNumbers } from './definition.js';
import { DISPOSE } from './dispose.js';
import { enterDomain, findDomain } from './domain.js';
import { compile, evaluateConstant } from './expression/compile.js';
import { measureField, readFieldOptions } from './field.js';
import { Graphs } from './graphs.js';
import { bridgesSheets, meshRectangle } from './mesh.js';
import { compileMetric, METRIC, readMeasure } from './metric.js';
import { checkOptions, describe, makePath, readOptions, readStart } from './path.js';
import { gap } from './rectangle.js';
import { ReferenceFinder } from './reference.js';
import { emptyPath } from './runtime/result.js';
import { CONVERGED, NOT_FINITE, OFF_SURFACE, SINGULAR_METRIC, STATUS, TOLERANCE_NOT_MET } from './runtime/status.js';
import { findGeodesics, findPath, placed, placeIn } from './pieces.js';
import { readShape } from './shapes.js';
import { readTrace, readTraceOptions } from './trace.js';
import { passThrough } from './via.js';

/** @typedef {import('./path.js').Path} Path */
/** @typedef {import('./path.js').PathOptions} PathOptions */
/** @typedef {import('./path.js').PairOptions} PairOptions */
/** @typedef {import('./path.js').GeodesicsOptions} GeodesicsOptions */
/** @typedef {import('./trace.js').TraceOptions} TraceOptions */
/** @typedef {import('./mesh.js').Mesh} Mesh */
/** @typedef {import('./field.js').FieldOptions} FieldOptions */
/** @typedef {import('./field.js').DistanceField} DistanceField */
/** @typedef {ReturnType<import('./runtime/solver.js').Solver['install']>} Installed */

/** enum sp_surface_kind of wasm/surface.h. */
const KIND = { parametric: 0, implicit: 1, metric: 0 };
/** `project` without `near` starts from the nearest vertex of a mesh of this resolution. */
const SEARCH = 48;
const RESOLUTION = { parametric: 96, implicit: 64 };
/** In place of 64 where that bridges sheets: enough for every surface of the gallery. */
const FINER = 96;
/** So far from an implicit surface, in parts of the diagonal of its bounds, a point is on it: as in wasm/start.c. */
const FAR = 0.1;
/** A trace that ends so on an implicit surface is tried again with so many times the tolerance, from this one no more. */
const MAY_CROSS = [TOLERANCE_NOT_MET, SINGULAR_METRIC];
const [LOOSER, LOOSEST] = [100, 1e-5];
/** More than are found as a rule: mirror images on a torus are nine, and their doubles. */
const MOST_GEODESICS = 16;
/** Statuses of what is no geodesic yet. */
const AT_NO_REST = ['stalled', 'iteration-limit'];

/** What the kinds differ in. */
const SHAPE = {
  parametric: { variables: ['u', 'v'], jet: 18, value: 3, valueOrder: /** @type {0} */ (0) },
  implicit: { variables: ['x', 'y', 'z'], jet: 10, value: 4, valueOrder: /** @type {1} */ (1) },
  metric: { variables: ['u', 'v'], jet: 18, value: 3, valueOrder: /** @type {0} */ (0) },
};

export class Surface {
  /** @type {'parametric' | 'implicit' | 'metric'} */ #kind;
  #solver;
  #forget;
  /** @type {import('./shapes.js').Shape} */ #shape;
  /** @type {'auto' | { u?: boolean, v?: boolean }} */ #periodic;
  /** With what measures length, if it is not space alone, and the reference direction of its frame. @type {ReturnType<typeof compile> & { metric: ReturnType<typeof compileMetric>, reference: number[] | null }} */
  #compiled;
  /** What measures length, if it is not space alone. @type {import('./metric.js').Measure} */ #measure;
  /** @type {Record<string, number>} */ #parameters;
  /** @type {ReferenceFinder | null} */ #finder = null;
  /** The direction that the frame of a tube or sweep should refer to. @type {number[] | null} */ #reference = null;
  /** @type {import('./domain.js').Domain | null} */ #domain = null;
  /** @type {number[] | null} */ #box = null;
  /** @type {Installed | null} */ #installed = null;
  /** @type {Installed | null} */ #installedMetric = null;
  #graphs;
  /** Those of the pieces of its domain. @type {Graphs[]} */ #graphsOfPieces = [];
  /** The domain whose walls the solver knows now. @type {import('./domain.js').Domain | null} */ #walls = null;
  /** The solver's instance in which it is installed; 0: in none. */
  #generation = 0;
  #disposed = false;

  /** Made by the factories of an instance. @param {import('./runtime/solver.js').Solver} solver @param {string} kind of the definition @param {any} definition @param {() => void} forget called when it is disposed */
  constructor(solver, kind, definition, forget) {
    this.#shape = readShape(kind, definition);
    this.#measure = readMeasure(kind, definition);
    this.#kind = kind === 'implicit' || kind === 'metric' ? kind : 'parametric';
    this.#graphs = new Graphs(KIND[this.#kind]);
    this.#solver = solver;
    this.#forget = forget;
    this.#periodic = checkPeriodic(kind, definition.periodic);
    this.#parameters = checkParameters(kind, definition.parameters ?? {});
    if (this.#shape.curve) this.#finder = new ReferenceFinder(kind, this.#shape.curve, solver, this.#parameters);
    if (kind === 'implicit') this.#box = checkBounds(kind, definition.bounds);
    const range = this.#readRange(kind);
    this.#compiled = this.#compile();
    this.#install();
    try {
      this.#settle(range);
    } catch (error) {
      this.#uninstall();
      throw error;
    }
  }

  /** What it is: tubes and the like are 'parametric'. */
  get kind() {
    Surface.#enter(this, 'kind');
    return this.#kind;
  }

  /** The named constants and their values, a copy. */
  get parameters() {
    Surface.#enter(this, 'parameters');
    return { ...this.#parameters };
  }

  /**
   * The closed parameter rectangle and which of its directions wrap; null for implicit surfaces. `turn`, where there is such a seam: one turn on along that
   * direction, the place with the other coordinate w is the one that had it at sign · w + offset.
   * @returns {{ u: [number, number], v: [number, number], periodic: { u: boolean, v: boolean }, turn?: { along: 'u' | 'v', sign: number, offset: number } } | null}
   */
  get domain() {
    Surface.#enter(this, 'domain');
    const domain = this.#domain;
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
    const { solve, start, via } = readOptions(caller, options);
    const stops = via.map((point, i) => this.#readPoint(caller, `options.via[${i}]`, point));
    const places = [this.#readPoint(caller, 'from', from), ...stops, this.#readPoint(caller, 'to', to)];
    if (stops.length > 0) return passThrough(this.#field(), caller, places, solve, start);
    const near = start === 'global' ? start : readStart(caller, start, SHAPE[this.#kind].variables.length);
    return findPath(this.#field(), places, solve, near);
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
    const { solve, start, via } = readOptions(caller, options, ['max']);
    const { max = MOST_GEODESICS } = options ?? {};
    if (via.length > 0) throw new RangeError(`${caller}: options.via is for shortestPath`);
    if (!Number.isInteger(max) || max < 1)
      throw new RangeError(`${caller}: options.max must be a whole number from 1 on, not ${describe(max)}`);
    if (start !== 'global') throw new RangeError(`${caller}: options.start must be 'global': geodesics looks for all paths`);
    const ends = [this.#readPoint(caller, 'from', from), this.#readPoint(caller, 'to', to)];
    return findGeodesics(this.#field(), ends, solve, max).filter(
      ({ index, status }) => (index === 0 && !AT_NO_REST.includes(status)) || status === 'out-of-memory',
    );
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
    const point = this.#readPoint(caller, 'from', from);
    const mesh = this.#mesh(caller, resolution);
    const place = this.#domain ? point : this.#projectOnto(`${caller}: from`, point, point);
    if (!this.#domain && gap(place, point) > FAR * this.#extent)
      throw new RangeError(`${caller}: from is farther from the surface than a tenth of its bounds; project it first`);
    return { mesh, distances: measureField(this.#field(), caller, place, mesh, exact) };
  }

  /**
   * The geodesic from a point in a direction: the exponential map. It ends early, with status `edge-reached`, on an edge of the rectangle.
   * @param {ArrayLike<number>} from u v in the rectangle (any number in a periodic direction), or x y z (projected onto the surface first)
   * @param {ArrayLike<number>} direction du dv, or x y z, of which the tangent part counts; its length does not matter. Zero or normal to the surface throws
   * @param {number} length how far, ≥ 0
   * @param {TraceOptions} [options]
   * @returns {Path} index −1, energy and gradientNorm NaN, no history; `conjugate`: the length at which the geodesic ceases to be locally shortest
   *   (null also where that is not computed: on an implicit surface with a `metric`)
   */
  trace(from, direction, length, options) {
    const caller = Surface.#enter(this, 'trace');
    const asked = readTrace(caller, direction, length, SHAPE[this.#kind].variables.length);
    const start = this.#readPoint(caller, 'from', from);
    const { domain, place } = placeIn(this.#field(), start);
    const request = { kind: KIND[this.#kind], from: place, ...asked };
    const wanted = readTraceOptions(caller, options);
    let { tolerance } = wanted;
    const run = () => this.#run((heap) => heap.trace(this.#record, request, { ...wanted, tolerance }), domain);
    let path = run();
    /* Near a curve where an implicit surface's gradient vanishes rounding keeps steps short, and turns them: longer ones lead across. */
    while (this.#kind === 'implicit' && path && MAY_CROSS.includes(path.status) && tolerance < LOOSEST) {
      tolerance *= LOOSER;
      const next = run();
      if (next && next.status >= CONVERGED) path = next;
    }
    if (path?.status === CONVERGED && tolerance > wanted.tolerance) path.status = TOLERANCE_NOT_MET;
    if (path) return place === start ? makePath(path) : placed(this.#domain, makePath(path), start);
    throw new RangeError(`${caller}: direction is normal to the surface at from; give one with a tangent part`);
  }

  /**
   * Evaluates the surface.
   * @param {ArrayLike<number>} points parametric: u v a point; implicit: x y z
   * @returns {Float64Array} parametric: position and unit normal, 6 numbers a point (NaN normals where S_u × S_v = 0); implicit: f and ∇f, 4;
   *   metric: E, F and G, 3
   */
  evaluate(points) {
    const caller = Surface.#enter(this, 'evaluate');
    checkList(`${caller}: points`, points, SHAPE[this.#kind].variables, 'point');
    if (this.#kind !== 'parametric') return this.#evaluate('value', points);
    return positionsAndNormals(this.#evaluate('jet', points));
  }

  /**
   * The point of the surface closest to a point of space.
   * @param {ArrayLike<number>} point x y z
   * @param {ArrayLike<number>} [near] where to start: u v (default: the nearest point of a grid) or x y z (default: the point itself and, where that leads nowhere,
   *   the nearest vertex of a mesh inside the bounds)
   * @returns {number[]} u v, or x y z
   */
  project(point, near) {
    const caller = Surface.#enter(this, 'project');
    this.#checkPositions(caller);
    const target = readNumbers(caller, 'point', point, 3);
    const isFree = near === undefined;
    if (this.#domain)
      return this.#projectOnto(caller, target, isFree ? this.#nearest(caller, target) : this.#readPoint(caller, 'near', near));
    return this.#projectOnto(caller, target, isFree ? target : readNumbers(caller, 'near', near, 3), isFree && this.#box !== null);
  }

  /**
   * Triangles, to draw.
   * @param {{ resolution?: number }} [options] cells a direction of the rectangle (default 96), or along the longest side of the bounds (default 64, or 96 if two sheets
   *   of the surface are too near to each other for 64); 1 … 256
   * @returns {Mesh}
   */
  mesh(options) {
    const caller = Surface.#enter(this, 'mesh');
    this.#checkPositions(caller);
    return this.#mesh(caller, checkOptions(caller, options, ['resolution']).resolution);
  }

  /** @param {string} caller @param {number} [wanted] resolution @returns {Mesh} */
  #mesh(caller, wanted) {
    const resolution = wanted ?? RESOLUTION[/** @type {'parametric' | 'implicit'} */ (this.#kind)];
    if (!Number.isInteger(resolution) || resolution < 1 || resolution > 256)
      throw new RangeError(`${caller}: options.resolution must be a whole number from 1 to 256, not ${describe(resolution)}`);
    if (this.#domain) return this.#meshRectangle(this.#domain, resolution);
    const box = this.#box;
    if (!box) throw new RangeError(`${caller}: an implicit surface is meshed inside its bounds; give them in its definition`);
    const mesh = this.#meshImplicit(caller, box, resolution);
    return wanted === undefined && bridgesSheets(mesh) ? this.#meshImplicit(caller, box, FINER) : mesh;
  }

  /** @param {import('./domain.js').Domain} domain @param {number} resolution */
  #meshRectangle({ written }, resolution) {
    return meshRectangle((points) => this.evaluate(points), written.lower, written.upper, resolution);
  }

  /** @param {string} caller @param {number[]} box @param {number} resolution @returns {Mesh} */
  #meshImplicit(caller, box, resolution) {
    const mesh = this.#run((heap) => heap.meshImplicit(/** @type {any} */ (this.#installed).value, box, resolution));
    if (mesh.status < 0) throw new RangeError(`${caller}: no mesh (${STATUS.get(mesh.status)}); try a lower resolution`);
    return { positions: mesh.positions, normals: mesh.normals, indices: mesh.indices };
  }

  /**
   * Changes named parameters, without recompiling.
   * @param {Record<string, number>} parameters those that change
   */
  set(parameters) {
    const caller = Surface.#enter(this, 'set');
    const changed = checkParameters(caller, parameters);
    for (const name of Object.keys(changed))
      if (!(name in this.#parameters))
        throw new RangeError(
          `${caller}: the surface has no parameter '${name}'; it has ${Object.keys(this.#parameters).join(', ') || 'none'}`,
        );
    const [before, reference, compiled, domain] = [this.#parameters, this.#reference, this.#compiled, this.#domain];
    this.#wake();
    this.#parameters = Object.assign(Object.create(null), before, changed);
    try {
      const range = this.#readRange(caller);
      this.#dropGraphs();
      this.#refresh();
      this.#settle(range);
    } catch (error) {
      [this.#parameters, this.#reference, this.#compiled, this.#domain] = [before, reference, compiled, domain];
      this.#dropGraphs();
      this.#uninstall();
      throw error;
    }
  }

  /** Frees the surface's memory and table slots. Using it afterwards throws; disposing twice does not. */
  dispose() {
    if (this.#disposed) return;
    this.#disposed = true;
    this.#dropGraphs();
    this.#uninstall();
    this.#forget();
  }

  /** As {@link dispose}: for `using`. */
  [DISPOSE]() {
    this.dispose();
  }

  /**
   * Throws where a method has lost its surface, or the surface is gone.
   * @param {Surface} surface @param {string} caller @returns {string} caller
   */
  static #enter(surface, caller) {
    if (!(surface instanceof Surface)) throw new TypeError(`${caller} belongs to a surface: call it as surface.${caller}`);
    if (surface.#disposed) throw new Error(`${caller}: this surface was disposed`);
    return caller;
  }

  #compile() {
    const { outputs, names, variables } = this.#shape;
    const reference = this.#reference;
    const metric = compileMetric(this.#kind, this.#measure, this.#shape, reference, this.#parameters, this.#solver.apply);
    const compiled = compile({
      outputs: typeof outputs === 'function' ? (formulas) => outputs(formulas, reference) : outputs,
      names,
      variables,
      parameters: this.#parameters,
      apply: this.#solver.apply,
      valueOrder: SHAPE[this.#kind].valueOrder,
    });
    return { ...compiled, metric, reference };
  }

  /** Puts the present parameters into effect; compiles again only where a frame needs another reference direction now. */
  #refresh() {
    if (this.#compiled.reference === this.#reference) return this.#writeParameters();
    this.#compiled = this.#compile();
    this.#uninstall();
    this.#install();
    this.#writeRecord();
  }

  /** Gives back what the solver's present instance holds of it, if anything; {@link #wake} installs it again. */
  #uninstall() {
    this.#generation = 0;
    for (const installed of [this.#installed, this.#installedMetric]) if (installed) this.#solver.remove(installed);
    this.#installed = this.#installedMetric = null;
  }

  /** @param {string} caller */
  #checkPositions(caller) {
    if (this.#kind === 'metric') throw new RangeError(`${caller}: a surface given by E, F and G has no positions in space`);
  }

  /** Compiles the modules into the solver's present instance: both or, with an error, neither. */
  #install() {
    const install = (/** @type {ReturnType<typeof compile>} */ { module, data, dataBytes }) =>
      this.#solver.install(module, data, dataBytes);
    const installed = install(this.#compiled);
    try {
      this.#installedMetric = this.#metric && install(this.#metric.compiled);
    } catch (error) {
      this.#solver.remove(installed);
      throw error;
    }
    this.#installed = installed;
    this.#generation = this.#solver.generation;
    this.#writeParameters();
  }

  get #metric() {
    return this.#compiled.metric;
  }

  /** Address of the record of the surface as it measures length. */
  get #record() {
    return /** @type {Installed} */ (this.#installedMetric ?? this.#installed).record;
  }

  /** Address of the record of the surface as space measures it. */
  get #shapeRecord() {
    return /** @type {Installed} */ (this.#installed).record;
  }

  /** Diagonal of the bounds; 0 without. */
  get #extent() {
    const box = this.#box;
    return box ? gap([box[1], box[3], box[5]], [box[0], box[2], box[4]]) : 0;
  }

  /** Installs the surface again where a trap has made the solver begin anew. */
  #wake() {
    if (this.#generation === this.#solver.generation) return;
    for (const graphs of [this.#graphs, ...this.#graphsOfPieces]) graphs.drop(null);
    try {
      this.#install();
      this.#writeRecord();
    } catch (error) {
      this.#uninstall();
      throw error;
    }
  }

  /** Runs something on the solver's memory, after making sure that this surface is installed there. @template T @param {(heap: import('./runtime/heap.js').Heap) => T} call @param {import('./domain.js').Domain | null} [domain] a piece of it @returns {T} */
  #run(call, domain = this.#domain) {
    this.#wake();
    if (this.#walls !== domain) this.#writeRecord(domain);
    return this.#solver.run(() => call(this.#solver.heap));
  }

  #writeParameters() {
    for (const installed of [this.#installed, this.#installedMetric])
      if (installed) this.#solver.heap.writeDoubles(installed.data, Object.values(this.#parameters));
  }

  /** @param {'jet' | 'value'} what @param {ArrayLike<number>} points */
  #evaluate(what, points) {
    const { variables, jet, value } = SHAPE[this.#kind];
    if (points.length === 0) return new Float64Array(0);
    this.#wake();
    const { call } = /** @type {Installed} */ (this.#installed);
    return this.#solver.evaluate(call[what], points, variables.length, what === 'jet' ? jet : value);
  }

  /** What measures length at the points, and its first derivatives; none where space does. @param {ArrayLike<number>} points @returns {Float64Array[]} one list a point */
  #evaluateMetric(points) {
    const metric = this.#metric;
    if (!metric) return [];
    const count = metric.compiled.jet.length;
    this.#wake();
    const jets = this.#solver.evaluate(/** @type {Installed} */ (this.#installedMetric).call.jet, points, 2, count);
    return Array.from({ length: points.length / 2 }, (_, i) => jets.subarray(count * i, count * i + count / 2));
  }

  /** E, F and G at points, then their derivatives, where they measure length. @returns {((points: number[]) => ArrayLike<number>[]) | null} */
  #tensors() {
    if (this.#metric?.code === METRIC.tensor) return (points) => this.#evaluateMetric(points);
    if (this.#kind !== 'metric') return null;
    return (points) => {
      const jets = this.#evaluate('jet', points);
      return Array.from({ length: points.length / 2 }, (_, i) => jets.subarray(18 * i));
    };
  }

  /** The rectangle, and the reference direction of a frame, as the parameters make them. @param {string} caller */
  #readRange(caller) {
    if (this.#kind === 'implicit') return null;
    const [lower, upper] = [
      [0, 0],
      [0, 0],
    ];
    for (const [j, [name, ends]] of this.#shape.ranges.entries()) {
      const range = ends.map((end) => evaluateConstant(end, this.#parameters, this.#solver.apply, name));
      if (!range.every(Number.isFinite) || !(range[0] < range[1]))
        throw new RangeError(`${caller}: ${name} must be a range of two numbers, the smaller first, not [${range}]`);
      [lower[j], upper[j]] = range;
    }
    if (this.#finder) this.#reference = this.#finder.find(this.#parameters, [lower[1], upper[1]]);
    return { lower, upper, caller };
  }

  /** Finds out which directions are periodic, and tells the solver. @param {import('./seams.js').Asked | null} range */
  #settle(range) {
    const surface = {
      jets: (/** @type {number[]} */ points) => this.#evaluate('jet', points),
      metrics: (/** @type {number[]} */ points) => this.#evaluateMetric(points),
      tensors: this.#tensors(),
    };
    const periodic = this.#kind === 'metric' && this.#periodic === 'auto' ? {} : this.#periodic;
    if (range) this.#domain = findDomain(periodic, surface, range);
    this.#writeRecord();
  }

  #writeRecord(domain = this.#domain) {
    const { jet, value } = /** @type {Installed} */ (this.#installed);
    this.#walls = domain;
    const wall = (/** @type {number[]} */ ends, /** @type {number} */ open) => ends.map((end, j) => (domain?.periodic[j] ? open : end));
    const lower = domain ? wall(domain.lower, -Infinity) : [0, 0];
    const upper = domain ? wall(domain.upper, Infinity) : [0, 0];
    const shape = { kind: KIND[this.#kind], metric: METRIC.induced, jet, value, lower, upper, extent: this.#extent };
    const abstract = { ...shape, metric: METRIC.tensor, value: 0 };
    const metric = this.#metric && { ...shape, metric: this.#metric.code, jet: /** @type {Installed} */ (this.#installedMetric).jet };
    this.#solver.heap.writeSurface(this.#shapeRecord, shape);
    this.#solver.heap.writeSurface(this.#record, this.#kind === 'metric' ? abstract : (metric ?? shape));
  }

  /** @param {string} caller @param {string} name @param {unknown} point @returns {number[]} */
  #readPoint(caller, name, point) {
    const numbers = readNumbers(caller, name, point, SHAPE[this.#kind].variables.length);
    return this.#domain ? enterDomain(this.#domain, numbers, `${caller}: ${name}`) : numbers;
  }

  /** What finding a path needs of this surface, or of a piece of it. @param {import('./domain.js').Domain | null} [domain] @param {Graphs} [graphs] @returns {import('./routes.js').Field} */
  #field(domain = this.#domain, graphs = this.#graphs) {
    const isPlain = this.#kind !== 'metric' && !this.#metric;
    const pieces = domain?.pinches?.pieces ?? [];
    return {
      kind: KIND[this.#kind],
      domain,
      box: this.#box,
      graphs,
      isPlain,
      positions: this.#kind !== 'metric' && domain ? (places) => this.#evaluate('value', places) : null,
      run: (call) => this.#run((heap) => call(heap, this.#record), domain),
      pieces: pieces.map((piece, i) => {
        this.#graphsOfPieces[i] ??= new Graphs(KIND[this.#kind]);
        return this.#field(piece, this.#graphsOfPieces[i]);
      }),
    };
  }

  /** Frees the graphs: they are those of other parameters, or no longer needed. */
  #dropGraphs() {
    const heap = this.#generation === this.#solver.generation ? this.#solver.heap : null;
    for (const graphs of [this.#graphs, ...this.#graphsOfPieces]) graphs.drop(heap);
  }

  /** @param {string} caller @param {number[]} target @param {number[]} place where to start @param {boolean} [isFree] a mesh may tell where else @returns {number[]} */
  #projectOnto(caller, target, place, isFree = false) {
    const found = this.#run((heap) => heap.project(this.#shapeRecord, target, place));
    if (found.status >= CONVERGED) return found.place;
    if (isFree) return this.#projectOnto(caller, target, this.#nearest(caller, target));
    throw new RangeError(
      `${caller}: no point of the surface was found from there (${STATUS.get(found.status)}); pass a point nearer to it`,
    );
  }

  /**
   * The path of each pair, one by one.
   * @param {string} caller @param {ArrayLike<number>} pairs @param {PairOptions} [options] @param {boolean} [shapeless] only lengths are wanted
   * @returns {Iterable<Path>}
   */
  *#solvePairs(caller, pairs, options, shapeless = false) {
    Surface.#enter(this, caller);
    const { solve, start } = readPairOptions(caller, options);
    // Elements are sampled in the end, chords are what is solved.
    if (shapeless && solve.algorithm === 0) solve.points = 1;
    for (const ends of readPairs(caller, pairs, SHAPE[this.#kind].variables, this.#domain)) {
      if (ends === NOT_FINITE || ends === OFF_SURFACE) yield makePath(emptyPath(ends));
      else yield findPath(this.#field(), ends, solve, start === 'global' ? start : null);
    }
  }

  /** The vertex of a mesh nearest to a point of space, as u v or x y z; without any, the point. @param {string} caller @param {number[]} target */
  #nearest(caller, target) {
    const { positions, parameters } = this.#mesh(caller, SEARCH);
    let [best, least] = [-1, Infinity];
    for (let i = 0; i < positions.length / 3; i++) {
      const away = gap(positions.subarray(3 * i), target);
      if (away < least) [best, least] = [i, away];
    }
    if (best < 0) return target;
    return Array.from(parameters ? parameters.subarray(2 * best, 2 * best + 2) : positions.subarray(3 * best, 3 * best + 3));
  }
}

/** Position and unit normal from jets of 18 numbers. @param {Float64Array} jets */
function positionsAndNormals(jets) {
  const count = jets.length / 18;
  const result = new Float64Array(6 * count);
  for (let i = 0; i < count; i++) {
    const [x, y, z, ux, uy, uz, vx, vy, vz] = jets.subarray(18 * i, 18 * i + 9);
    const normal = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
    const length = Math.sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
    result.set([x, y, z, normal[0] / length, normal[1] / length, normal[2] / length], 6 * i);
  }
  return result;
}
