/**
 * A surface as a manifold: its domain, and what measures length on it, for the present values of its parameters. Compiled and installed in the
 * solver, and installed again where that has begun anew. Answers no questions of its own.
 */

import { checkBounds, checkParameters, checkPeriodic, readNumbers } from '../definition.js';
import { Creases } from '../expression/creases.js';
import { diagonalOf } from '../vector.js';
import { Bodies } from './bodies.js';
import { chordLengths } from './chords.js';
import { enterDomain, findDomain } from './domain.js';
import { Graphs } from './graphs.js';
import { Installation, writeRecords } from './installation.js';
import { KIND, SHAPE } from './kind.js';
import { freeName, lowerShape, steepnessOf } from './lowered.js';
import { compileMetric, factorOf, METRIC, readMeasure } from './metric.js';
import { flattenShape, intoPlane, outOfPlane } from './polar.js';
import { ReferenceFinder } from './reference.js';
import { scaleOf } from './scale.js';
import { compileShape, evaluateRanges, readShape } from './shapes.js';
import { Sides } from './sides.js';
import { formsOf } from './tips.js';

/** @typedef {import('./domain.js').Domain} Domain */
/** @typedef {import('./installation.js').Installed} Installed */

export class Manifold {
  /** @type {'parametric' | 'implicit' | 'metric'} */ kind;
  /** Where an implicit surface is searched. @type {number[] | null} */ box = null;
  /** @type {Domain | null} */ domain = null;
  /** @type {Record<string, number>} */ parameters;
  isDisposed = false;
  #solver;
  /** @type {import('./shapes.js').Shape} */ #shape;
  /** @type {'auto' | { u?: boolean, v?: boolean }} */ #periodic;
  /**
   * With what measures length, if it is not space alone; its own E, F and G, once somebody asks; the reference direction of its frame; and, where length is that of space
   * times a number, that: it is left out of all that is compiled.
   * @type {ReturnType<typeof compileShape> & { metric: ReturnType<typeof compileMetric>, own: ReturnType<typeof compileMetric>, reference: number[] | null, factor: number, isCreased: boolean, hasFloors: boolean }}
   */
  #compiled;
  /** What measures length, if it is not space alone: as it is defined. @type {import('./metric.js').Measure} */ #defined;
  /** @type {ReferenceFinder | null} */ #finder = null;
  /** The direction that the frame of a tube or sweep should refer to. @type {number[] | null} */ #reference = null;
  #installation;
  /** Of all of it, then of the pieces of its domain; and as its own E, F and G measure them. @type {Graphs[][]} */ #graphs = [[], []];
  /** Of its creases, once somebody asks. @type {Sides | null} */ #sides = null;
  /** What boxes hold of an implicit surface, once somebody asks. @type {Bodies | null} */ #bodies = null;
  /** Its like with lower heights, once somebody asks. @type {Manifold | null} */ #low = null;
  /** It over the planes around its poles, once somebody asks; null: there is no room for it. @type {Map<number, Manifold | null>} */ #flat =
    new Map();
  /** What questions need of it, once one is asked. @type {import('../search/routes.js').Field | null} */ #field = null;
  /** A coarse mesh, in which projections look for where to begin, once one has. @type {import('../mesh/projection.js').Coarse | null} */ coarse =
    null;

  /** @param {import('../runtime/solver.js').Solver} solver @param {string} kind of the definition @param {any} definition @param {import('./shapes.js').Shape} [shape] what it says of the shape */
  constructor(solver, kind, definition, shape = readShape(kind, definition)) {
    this.#shape = shape;
    this.#defined = readMeasure(kind, definition);
    const { parameters = {}, periodic } = definition;
    this.kind = kind === 'implicit' || kind === 'metric' ? kind : 'parametric';
    this.#solver = solver;
    this.#installation = new Installation(solver);
    this.#periodic = checkPeriodic(kind, periodic);
    this.parameters = checkParameters(kind, parameters);
    if (this.#shape.curve) this.#finder = new ReferenceFinder(kind, this.#shape.curve, solver, this.parameters);
    if (kind === 'implicit') this.box = checkBounds(kind, definition.bounds);
    const range = this.#readRange(kind);
    this.#compiled = this.#compile();
    this.#install();
    try {
      this.#settle(range);
    } catch (error) {
      this.#installation.uninstall();
      throw error;
    }
  }

  /** Changes parameters; with an error, none. @param {string} caller @param {Record<string, number>} changed */
  set(caller, changed) {
    const [before, reference, compiled, domain] = [this.parameters, this.#reference, this.#compiled, this.domain];
    this.#wake();
    this.parameters = Object.assign(Object.create(null), before, changed);
    try {
      const range = this.#readRange(caller);
      this.#dropGraphs();
      this.#refresh();
      this.#settle(range);
    } catch (error) {
      [this.parameters, this.#reference, this.#compiled, this.domain] = [before, reference, compiled, domain];
      this.#dropGraphs();
      this.#installation.uninstall();
      throw error;
    }
  }

  /** Frees memory and table slots. */
  dispose() {
    this.isDisposed = true;
    this.#dropGraphs();
    this.#installation.uninstall();
  }

  /** Diagonal of the bounds; 0 without. */
  get extent() {
    return this.box ? diagonalOf(this.box) : 0;
  }

  /** What all lengths are to be multiplied by. */
  get factor() {
    return this.#compiled.factor || 1;
  }

  /** What measures length, if it is not space alone, nor that times a number. */
  get #measure() {
    return this.#compiled.factor ? {} : this.#defined;
  }

  /** Coordinates of a point, as the definition calls them. */
  get variables() {
    return this.#shape.variables;
  }

  /** @param {string} caller @param {string} name @param {unknown} point @returns {number[]} */
  readPoint(caller, name, point) {
    const numbers = readNumbers(caller, name, point, this.variables);
    return this.domain ? enterDomain(this.domain, numbers, caller, name, this.variables) : numbers;
  }

  /** @param {'jet' | 'value'} what @param {ArrayLike<number>} points */
  evaluate(what, points) {
    const { variables, jet, value } = SHAPE[this.kind];
    if (points.length === 0) return new Float64Array(0);
    this.#wake();
    const { call } = this.#shaped;
    return this.#solver.evaluate(call[what], points, variables.length, what === 'jet' ? jet : value);
  }

  /**
   * Runs something on the solver's memory, after making sure that this surface is installed there.
   * @template T @param {import('../search/routes.js').Call<T>} call @param {Domain | null} [domain] its own, or that of a piece @param {boolean} [isOwn] as its own E, F and G measure it
   * @returns {T}
   */
  run(call, domain = this.domain, isOwn = false) {
    this.#wake();
    const { walls, metric, own } = this.#installation;
    if (walls !== domain) this.#writeRecord(domain);
    const shape = this.#shaped;
    const measured = (isOwn ? own : metric) ?? shape;
    return this.#solver.run(() => call(this.#solver.heap, measured.record, shape));
  }

  /** What a question needs of this surface: for the life of its parameters the same. @returns {import('../search/routes.js').Field} */
  field() {
    this.#field ??= {
      ...this.#fieldOf(this.domain, 0, false),
      own:
        this.kind === 'parametric' && !this.#measure.metric
          ? () => (this.#installOwn() ? this.#fieldOf(this.domain, 0, true) : null)
          : null,
      sides: this.#compiled.isCreased ? () => this.#findSides() : null,
      jumps: this.#compiled.isCreased || this.#compiled.hasFloors ? () => this.#findSides() : null,
      bodies: this.kind === 'implicit' && !this.#measure.metric ? () => this.bodies : null,
      flattened: this.kind !== 'implicit' && this.#compiled.isCreased ? (pole) => this.#findFlattened(pole) : null,
      lowered: this.kind === 'parametric' && !this.#compiled.metric && !this.#compiled.isCreased ? () => this.#findLowered() : null,
    };
    return this.#field;
  }

  /** It with lower heights, and how steep it is; null: it is no steep one over x and y. @returns {import('../search/raised.js').Lowered | null} */
  #findLowered() {
    const [[graphs]] = this.#graphs;
    graphs.steepness ??= steepnessOf((places) => this.evaluate('jet', places), /** @type {Domain} */ (this.domain));
    const { steepness } = graphs;
    return steepness > 0 ? { steepness, at: (height) => this.#lower(height) } : null;
  }

  /** Its like with heights multiplied by a number; null: there is no room for it. @param {number} height */
  #lower(height) {
    const factor = freeName(this.parameters);
    try {
      const definition = { periodic: this.#periodic, parameters: { ...this.parameters, [factor]: 1 } };
      this.#low ??= new Manifold(this.#solver, this.kind, definition, lowerShape(this.#shape, factor));
      this.#low.set(this.kind, { [factor]: height });
      return this.#low.field();
    } catch {
      /* No memory, or more parameters than a module may have. */
      return null;
    }
  }

  /** It over the plane around one of its poles; null: there is no room for it, or it is carried along a curve. @param {number} pole @returns {import('../creases/at-poles.js').Flattened | null} */
  #findFlattened(pole) {
    const domain = /** @type {Domain} */ (this.domain);
    const { apply } = this.#solver;
    if (!this.#flat.has(pole)) this.#flat.set(pole, this.#flatten(domain, pole));
    const flat = this.#flat.get(pole);
    if (!flat) return null;
    return {
      field: flat.field(),
      into: (places) => intoPlane(domain, pole, places, apply),
      back: (places, ends) => outOfPlane(domain, pole, places, ends, apply),
    };
  }

  /** @param {Domain} domain @param {number} pole */
  #flatten(domain, pole) {
    const shape = flattenShape(this.#shape, domain, pole, this.kind === 'metric');
    const { density, metric } = this.#measure;
    try {
      return shape && new Manifold(this.#solver, this.kind, { periodic: {}, parameters: this.parameters, density, metric }, shape);
    } catch {
      /* No memory, or more than a module may hold. */
      return null;
    }
  }

  /** What boxes hold of an implicit surface. @returns {Bodies} */
  get bodies() {
    this.#wake();
    this.#bodies ??= new Bodies({
      measure: this.#measure,
      shape: this.#shape,
      parameters: this.parameters,
      solver: this.#solver,
      values: (places) => this.evaluate('value', places),
      write: (shape, measured, extent) => {
        writeRecords(this.#solver, { kind: this.kind, extent }, null, shape, [{ ...measured, code: METRIC.tensor }]);
        return measured;
      },
    });
    return this.#bodies;
  }

  /** The sides of its creases; null: there is no room for what tells them. */
  #findSides() {
    this.#wake();
    try {
      this.#sides ??= new Sides({
        kind: this.kind,
        measure: this.#measure,
        shape: this.#shape,
        reference: this.#reference,
        parameters: this.parameters,
        scale: scaleOf(KIND[this.kind], this.domain, (call) => this.run(call)),
        solver: this.#solver,
        write: (shape, measured, code) => {
          writeRecords(this.#solver, this, this.domain, shape, [measured && { ...measured, code }]);
          return measured ?? shape;
        },
      });
    } catch {
      /* No memory, or more than a module may hold. */
    }
    return this.#sides;
  }

  /** @param {Domain | null} domain its own, or that of a piece @param {number} place of its graphs @param {boolean} isOwn @returns {import('../search/routes.js').Field} */
  #fieldOf(domain, place, isOwn) {
    const isAbstract = this.kind === 'metric';
    const graphs = this.#graphs[Number(isOwn)];
    graphs[place] ??= new Graphs(KIND[this.kind], this.#compiled.isCreased);
    return {
      kind: KIND[this.kind],
      domain,
      box: this.box,
      graphs: graphs[place],
      isPlain: !isAbstract && !isOwn && !this.#compiled.metric,
      positions: !isAbstract && domain ? (places) => this.evaluate('value', places) : null,
      chords: domain ? (places) => this.#measureChords(places) : null,
      run: (call, part) => this.run(call, part ?? domain, isOwn),
      jets: (places) => this.evaluate('jet', places),
      forms: (places) => formsOf(this.#sampled)(places),
      mesh: (box, resolution) => this.run((heap, _, { value }) => heap.meshImplicit(value, box, resolution)),
      pieces: (domain?.pinches?.pieces ?? []).map((piece, i) => this.#fieldOf(piece, i + 1, isOwn)),
    };
  }

  #compile() {
    const reference = this.#reference;
    const { apply } = this.#solver;
    const [creases, measured] = [new Creases(), new Creases()];
    /* Compiled even where it is not needed: it says what is wrong with a definition. */
    const metric = compileMetric(this.kind, this.#defined, this.#shape, reference, this.parameters, apply, measured);
    const compiled = compileShape(this.kind, this.#shape, reference, this.parameters, apply, creases);
    const factor = this.#findFactor();
    const all = factor ? [creases] : [creases, measured];
    const isCreased = all.some(({ nodes }) => nodes.length > 0);
    const hasFloors = all.some(({ floors }) => floors.length > 0);
    return { ...compiled, metric: factor ? null : metric, own: null, reference, factor, isCreased, hasFloors };
  }

  #findFactor() {
    return factorOf(this.#defined, this.parameters, this.#solver.apply);
  }

  /** Puts the present parameters into effect; compiles again only where a frame needs another reference direction now, or a constant density is positive no more. */
  #refresh() {
    const factor = this.#findFactor();
    if (this.#compiled.reference === this.#reference && !this.#compiled.factor === !factor) {
      this.#compiled = { ...this.#compiled, factor };
      return this.#installation.writeParameters(this.parameters);
    }
    this.#compiled = this.#compile();
    this.#installation.uninstall();
    this.#install();
    this.#writeRecord();
  }

  #install() {
    this.#installation.install(this.#compiled, this.#compiled.metric, this.parameters);
  }

  /** Compiles and installs its own E, F and G, unless that is done. Returns whether there is room for them. */
  #installOwn() {
    this.#wake();
    if (this.#installation.own) return true;
    const measure = { ...this.#measure, isOwn: true };
    try {
      this.#compiled.own ??= compileMetric(this.kind, measure, this.#shape, this.#reference, this.parameters, this.#solver.apply);
      this.#installation.installOwn(/** @type {NonNullable<ReturnType<typeof compileMetric>>} */ (this.#compiled.own), this.parameters);
      this.#writeRecord(this.#installation.walls);
      return true;
    } catch {
      /* No memory, or more than a module may hold: it goes without. */
      return false;
    }
  }

  /** Installs the surface again where a trap has made the solver begin anew. */
  #wake() {
    /* By a getter, say, of the options of a call that has begun. */
    if (this.isDisposed) throw new Error('surfpath: this surface was disposed');
    if (this.#installation.isPresent) return;
    this.#dropGraphs();
    try {
      this.#install();
      this.#writeRecord();
    } catch (error) {
      this.#installation.uninstall();
      throw error;
    }
  }

  #writeRecord(domain = this.domain) {
    this.#installation.write(this, domain);
  }

  /** Where the surface itself is installed, which it is after {@link #wake}. */
  get #shaped() {
    return /** @type {Installed} */ (this.#installation.shape);
  }

  /** What measures length at the points, and its first derivatives; none where space does. @param {ArrayLike<number>} points @returns {Float64Array[]} one list a point */
  #evaluateMetric(points) {
    const { metric } = this.#compiled;
    if (!metric) return [];
    const count = metric.compiled.jet.length;
    this.#wake();
    const jets = this.#solver.evaluate(/** @type {Installed} */ (this.#installation.metric).call.jet, points, 2, count);
    return Array.from({ length: points.length / 2 }, (_, i) => jets.subarray(count * i, count * i + count / 2));
  }

  /** How long chords between places u v one after the other are: the mean of what is measured at both ends. @param {ArrayLike<number>} places */
  #measureChords(places) {
    const { metric } = this.#compiled;
    this.#wake();
    const { call } = metric ? /** @type {Installed} */ (this.#installation.metric) : this.#shaped;
    const width = metric ? metric.compiled.jet.length / 6 : 3;
    const isForm = this.kind === 'metric' || metric?.code === METRIC.tensor;
    return chordLengths(places, this.#solver.evaluate(call.value, places, 2, width), isForm ? 'form' : metric ? 'density' : 'space');
  }

  /** E, F and G at points, then their derivatives, where they measure length. @returns {((points: number[]) => ArrayLike<number>[]) | null} */
  #tensors() {
    if (this.#compiled.metric?.code === METRIC.tensor) return (points) => this.#evaluateMetric(points);
    if (this.kind !== 'metric') return null;
    return (points) => {
      const jets = this.evaluate('jet', points);
      return Array.from({ length: points.length / 2 }, (_, i) => jets.subarray(18 * i));
    };
  }

  /** @returns {import('./rectangle.js').Sampled} */
  get #sampled() {
    return {
      jets: (points) => this.evaluate('jet', points),
      metrics: (points) => this.#evaluateMetric(points),
      tensors: this.#tensors(),
    };
  }

  /** The rectangle, and the reference direction of a frame, as the parameters make them. @param {string} caller */
  #readRange(caller) {
    if (this.kind === 'implicit') return null;
    const range = evaluateRanges(caller, this.#shape, this.parameters, this.#solver.apply);
    if (this.#finder) this.#reference = this.#finder.find(this.parameters, [range.lower[1], range.upper[1]]);
    return range;
  }

  /** Finds out which directions are periodic, and tells the solver. @param {import('./seams.js').Asked | null} range */
  #settle(range) {
    const periodic = this.kind === 'metric' && this.#periodic === 'auto' ? {} : this.#periodic;
    if (range) this.domain = findDomain(periodic, this.#sampled, range);
    this.#writeRecord();
  }

  /** Frees the graphs, and what else was made of the surface: they are those of other parameters, or no longer needed. */
  #dropGraphs() {
    this.coarse = this.#field = null;
    this.#sides?.drop();
    this.#sides = null;
    const heap = this.#installation.isPresent ? this.#solver.heap : null;
    this.#bodies?.drop(heap);
    this.#bodies = null;
    this.#low?.dispose();
    this.#low = null;
    for (const flat of this.#flat.values()) flat?.dispose();
    this.#flat.clear();
    for (const graphs of this.#graphs.flat()) graphs.drop(heap);
  }
}
