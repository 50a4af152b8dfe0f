/**
 * The sides of a surface: its formulas written for one side of each of their creases, smooth, and beyond these, too; and with all creases rounded. Compiled and installed when
 * somebody asks for them. Knows nothing of paths.
 */

import { compile } from '../expression/compile.js';
import { Creases } from '../expression/creases.js';
import { dot, listOf } from '../vector.js';
import { SHAPE } from './kind.js';
import { productBy } from './lifts.js';
import { compileMetric, METRIC, nodesOf } from './metric.js';
import { compileShape } from './shapes.js';

/** @typedef {import('../expression/creases.js').Way} Way */
/** @typedef {ReturnType<import('../runtime/solver.js').Solver['install']>} Installed */
/** @typedef {(a: number[], b: number[]) => number} Product of tangent vectors, over u and v or in space */
/**
 * @typedef {object} Given a surface, for the present values of its parameters
 * @property {'parametric' | 'implicit' | 'metric'} kind
 * @property {import('./metric.js').Measure} measure
 * @property {import('./shapes.js').Shape} shape
 * @property {readonly number[] | null} reference of a frame
 * @property {Record<string, number>} parameters
 * @property {readonly number[]} scale how much its coordinates count
 * @property {import('../runtime/solver.js').Solver} solver
 * @property {(shape: Installed, measured: Installed | null, code: number) => Installed} write tells the solver what was installed; returns which of the two measures length
 */
/**
 * @typedef {object} Side
 * @property {<T>(call: import('../search/routes.js').Call<T>) => T} run
 * @property {number[]} groups of the numbers of a jet that have the same unit: 0, 1, 2 of the shape, by the order of derivatives, 3, 4, 5 of what measures length
 * @property {(places: ArrayLike<number>) => number[][]} jets of the shape and of what measures length, with their first and second derivatives, one list a place
 * @property {(places: ArrayLike<number>) => Float64Array} values of the shape at places, one after the other: x y z, or f and ∇f
 * @property {(jet: number[]) => Product} productOf what measures tangent vectors at a place, by its jets
 * @property {(places: ArrayLike<number>) => number[][]} measure as {@link Sides.measure}, of what vanishes on the creases as it is written on these sides
 */

/** So many sides one question may ask for, whatever was asked before: an icosahedron's by max and abs, where signs tell 20 facets apart, takes up to 400. As many are kept. */
const MOST_SIDES = 512;
/** Numbers of so many signs, and a leading one, are small integers to every engine. */
const MOST_BITS = 2 ** 29;

export class Sides {
  #given;
  /** Which crease each of those that formulas name is. @type {number[]} */ #which = [];
  /** What vanishes on the creases, with its derivatives. @type {Installed} */ #vanishing;
  /** The floors of its formulas, if it has any. @type {Installed | null} */ #floors = null;
  #floorCount = 0;
  /** @type {Map<string, { side: Side, installed: Installed[] }>} */ #known = new Map();
  /** What was installed, by what it is: formulas on many sides are the same. @type {Map<string, Installed[]>} */ #installed = new Map();
  /** Which sides the present question has asked for. @type {Set<string>} */ #asked = new Set();
  count = 0;
  /** How much each coordinate counts where distances are taken in them. */ scale;

  /** @param {Given} given */
  constructor(given) {
    this.#given = given;
    this.scale = given.scale;
    const creases = new Creases();
    const modules = [
      this.#compileVanishing(creases, () => {
        const nodes = [...new Set(creases.nodes)];
        this.#which = creases.nodes.map((node) => nodes.indexOf(node));
        this.count = nodes.length;
        return nodes;
      }),
    ];
    this.#floorCount = creases.floors.length;
    if (this.#floorCount > 0) {
      creases.floors = [];
      modules.push(this.#compileVanishing(creases, () => creases.floors));
    }
    [this.#vanishing, this.#floors = null] = given.solver.installAll(modules);
  }

  /** @param {Creases} creases that take down or choose @param {() => number[]} nodes what vanishes, once formulas are read */
  #compileVanishing(creases, nodes) {
    const { kind, measure, shape, reference, parameters, solver } = this.#given;
    return compile({
      outputs: (formulas) => {
        nodesOf(kind, measure, shape, reference, formulas);
        return nodes();
      },
      names: [],
      variables: shape.variables,
      parameters,
      valueOrder: 1,
      apply: solver.apply,
      creases,
    });
  }

  /** A question begins: what it gets does not depend on those before it. */
  begin() {
    this.#asked.clear();
    if (this.#known.size > MOST_SIDES) this.#forget();
  }

  /** Of each place, of each crease what vanishes there, then its derivatives by the first variable, and so on. @param {ArrayLike<number>} places */
  measure(places) {
    return this.#measureBy(this.#vanishing, places);
  }

  /** As {@link measure}, one place after the other. @param {ArrayLike<number>} places @returns {Float64Array} */
  measureAll(places) {
    return this.#evaluate(this.#vanishing, places);
  }

  /** Of each place, the floors of its formulas: where one of them changes, the surface, or what measures length, may jump. @param {ArrayLike<number>} places @returns {number[][]} */
  floors(places) {
    return this.#floors ? this.#measureBy(this.#floors, places, this.#floorCount) : [];
  }

  /** @param {Installed} vanishing @param {ArrayLike<number>} places @param {number} [count] */
  #measureBy(vanishing, places, count) {
    return split(this.#evaluate(vanishing, places, count), places.length / this.scale.length);
  }

  /** @param {Installed} vanishing @param {ArrayLike<number>} places @param {number} count how many vanish */
  #evaluate(vanishing, places, count = this.count) {
    const width = this.scale.length;
    return this.#given.solver.evaluate(vanishing.call.value, places, width, count * (1 + width));
  }

  /** The surface on these sides of its creases; null: there are too many, or there is no room. @param {number[]} signs @returns {Side | null} */
  on(signs) {
    return this.#find(keyOf(signs), () => ({ sides: this.#which.map((crease) => signs[crease]) }))?.side ?? null;
  }

  /** The surface with its creases rounded, jumps on the side that the sign of w tells: √(g² + w²) in place of |g|. null: there is no room. @param {number[]} widths w of each crease @returns {Side | null} */
  rounded(widths) {
    const { solver, parameters } = this.#given;
    const first = Object.keys(parameters).length;
    const found = this.#find('rounded', () => ({ widths: this.#which.map((crease) => first + crease) }));
    for (const { data } of found?.installed ?? []) solver.heap.writeDoubles(data + 8 * first, widths);
    return found?.side ?? null;
  }

  /** @param {string} key @param {() => Way} way how its formulas are written, asked for now or never */
  #find(key, way) {
    if (!this.#asked.has(key) && this.#asked.size >= MOST_SIDES) return null;
    this.#asked.add(key);
    if (!this.#known.has(key)) {
      try {
        this.#known.set(key, this.#make(way()));
      } catch {
        /* No memory: it goes without. */
        return null;
      }
    }
    return this.#known.get(key) ?? null;
  }

  /** @param {Way} way */
  #make(way) {
    const { kind, measure, shape, reference, parameters, solver, write } = this.#given;
    const width = this.scale.length;
    const compiled = compileShape(kind, shape, reference, parameters, solver.apply, new Creases(way));
    const metric = compileMetric(kind, measure, shape, reference, parameters, solver.apply, new Creases(way));
    const modules = [compiled, ...(metric ? [metric.compiled] : [])];
    const installed = this.#install(modules);
    const measured = write(installed[0], installed[1] ?? null, metric?.code ?? METRIC.induced);
    /** @type {Installed | null} */
    let vanishing = null;
    const vanish = () => {
      const sided = new Creases(way);
      const compiled = this.#compileVanishing(sided, () =>
        Array.from({ length: this.count }, (_, crease) => sided.nodes[this.#which.indexOf(crease)]),
      );
      return this.#install([compiled])[0];
    };
    /** @type {Side} */
    const side = {
      groups: groupsOf(modules, width),
      run: (call) => solver.run(() => call(solver.heap, measured.record, installed[0])),
      jets: (places) => {
        const count = places.length / width;
        const jets = modules.map(({ jet }, i) => split(solver.evaluate(installed[i].call.jet, places, width, jet.length), count));
        return jets[0].map((_, k) => jets.flatMap((of) => of[k]));
      },
      values: (places) => solver.evaluate(installed[0].call.value, places, width, SHAPE[kind].value),
      productOf: (jet) => productOf(kind, metric?.code ?? METRIC.induced, jet),
      measure: (places) => {
        if (this.count === 1) return this.measure(places);
        vanishing ??= vanish();
        return this.#measureBy(vanishing, places);
      },
    };
    return { side, installed };
  }

  /** @param {import('../runtime/solver.js').Module[]} modules that belong together @returns {Installed[]} */
  #install(modules) {
    const key = modules.map(({ module, data }) => `${module} ${data}`).join();
    const known = this.#installed.get(key);
    if (known) return known;
    const installed = this.#given.solver.installAll(modules);
    this.#installed.set(key, installed);
    return installed;
  }

  #forget() {
    for (const installed of [...this.#installed.values()].flat()) this.#given.solver.remove(installed);
    this.#installed.clear();
    this.#known.clear();
  }

  /** Gives back what the solver holds of it. */
  drop() {
    this.#forget();
    for (const installed of [this.#vanishing, this.#floors]) if (installed) this.#given.solver.remove(installed);
  }
}

/** What tells sides from others, quicker than their signs joined. @param {number[]} signs */
function keyOf(signs) {
  let key = '';
  let bits = 1;
  for (const sign of signs) {
    bits = 2 * bits + Number(sign > 0);
    if (bits < MOST_BITS) continue;
    key += `${bits} `;
    bits = 1;
  }
  return key + bits;
}

/**
 * What measures tangent vectors at a place: the jet of the shape says it, or that of a density or a metric behind it.
 * @param {'parametric' | 'implicit' | 'metric'} kind @param {number} code of what measures length @param {number[]} jet @returns {Product}
 */
function productOf(kind, code, jet) {
  if (kind === 'implicit') {
    const [_, ...measured] = jet.slice(10, 17);
    const density = code === METRIC.density ? measured[0] : 1;
    if (code !== METRIC.tensor) return (a, b) => density * dot(a, b);
    const [xx, xy, yy, xz, yz, zz] = measured;
    return (a, b) => dot(a, [xx * b[0] + xy * b[1] + xz * b[2], xy * b[0] + yy * b[1] + yz * b[2], xz * b[0] + yz * b[1] + zz * b[2]]);
  }
  const [u, v] = [jet.slice(3, 6), jet.slice(6, 9)];
  const space = [dot(u, u), dot(u, v), dot(v, v)].map((x) => (code === METRIC.density ? jet[21] * x : x));
  const form = kind === 'metric' ? jet : code === METRIC.tensor ? jet.slice(18) : space;
  return (a, b) => productBy(form, a, b);
}

/**
 * Of each number that modules give of a place, all values first, then all first derivatives, then all second: of which of them it is, and what of. A module that measures length may begin with the shape.
 * @param {{ jet: { length: number } }[]} modules the shape's, and what measures length, if it is another @param {number} variables
 */
function groupsOf(modules, variables) {
  const orders = [1, variables, (variables * (variables + 1)) / 2].flatMap((count, order) => Array.from({ length: count }, () => order));
  const widths = modules.map(({ jet }) => jet.length / orders.length);
  return widths.flatMap((width, which) => {
    const shaped = which === 0 ? width : width > widths[0] ? widths[0] : 0;
    return orders.flatMap((order) => Array.from({ length: width }, (_, i) => (i < shaped ? order : 3 + order)));
  });
}

/** @param {Float64Array} numbers @param {number} count lists */
function split(numbers, count) {
  const width = numbers.length / count;
  return Array.from({ length: count }, (_, i) => listOf(numbers, width * i, width * (i + 1)));
}
