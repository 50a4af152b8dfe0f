/* Graph -> bytes of a WebAssembly module with the functions `jet` and `value`: one pass over the pairs of points, no branches.
 *
 * A node used once is computed where it is used, on the stack; one used more often gets a local, which is free again after its last use. What
 * depends on parameters alone is computed once, before the loop. Sines and cosines of an angle, or of two, are one call. */

import * as wasm from './encode.js';
import { solverFunctions } from './functions.js';
import * as Operation from './operation.js';
import { constantsOf, plan } from './plan.js';

/** @typedef {import('./graph.js').Graph} Graph */
/** @typedef {import('./plan.js').Plan} Plan */

const PAIR_BYTES = 16;
const NUMBER_BYTES = 8;
/** For the sines and cosines of two angles, but the first. */
const SCRATCH_BYTES = 3 * PAIR_BYTES;
const TYPES = [
  wasm.functionType([wasm.V128], [wasm.V128]),
  wasm.functionType([wasm.V128, wasm.V128], [wasm.V128]),
  wasm.functionType([wasm.V128, wasm.I32], [wasm.V128]),
  wasm.functionType([wasm.V128, wasm.V128, wasm.I32], [wasm.V128]),
  wasm.functionType([wasm.I32, wasm.I32, wasm.I32], []),
];
const EVALUATE = 4;

/** Functions that may be imported, in this order: those of functions.js, then those for the sine and cosine of an angle, and of two. `type`: of TYPES. */
const IMPORTS = [
  ...solverFunctions.map(({ name, arity }) => ({ name, type: arity - 1 })),
  { name: 'sincos', type: 2 },
  { name: 'sincos_two', type: 3 },
];

/** Locals of the generated functions; those of vectors follow. */
const [COUNT, IN, OUT, DATA, FIRST_VECTOR] = [0, 1, 2, 3, 4];

/** Uses left of a local that the next round of the loop needs again. */
const KEPT_FOR_EVER = 0xffffffff;

/**
 * Writes the module.
 * @param {Graph} graph
 * @param {{ jet: number[], value: number[] }} outputs nodes that each function stores, in order
 * @param {{ variableCount: number, parameterCount: number }} counts
 * @returns {{ module: Uint8Array<ArrayBuffer>, constants: number[], dataBytes: number }} `constants` follow the parameters in the data block, scratch follows them
 */
export function emit(graph, outputs, { variableCount, parameterCount }) {
  const plans = [plan(graph, outputs.jet), plan(graph, outputs.value)];
  const constants = constantsOf(graph, plans);
  const slots = new Map(constants.map((id, k) => [id, parameterCount + k]));
  const scratch = PAIR_BYTES * Math.ceil((NUMBER_BYTES * (parameterCount + constants.length)) / PAIR_BYTES);
  const imports = importsOf(graph, plans);
  const bodies = plans.map((each) => new FunctionEmitter(graph, each, { slots, scratch, imports, variableCount }).emit());
  const module = wasm.module({
    types: TYPES,
    imports: [
      wasm.importMemory('memory'),
      wasm.importConstant('data', wasm.I32),
      ...imports.map((k) => wasm.importFunction(`sp_${IMPORTS[k].name}`, IMPORTS[k].type)),
    ],
    functionTypes: [EVALUATE, EVALUATE],
    exports: ['jet', 'value'].map((name, k) => wasm.exportFunction(name, imports.length + k)),
    bodies,
  });
  return { module, constants: constants.map((id) => graph.numberOf(id)), dataBytes: scratch + SCRATCH_BYTES };
}

/** The function that computes a node. @param {Graph} graph @param {Plan} plan @param {number} id */
function functionOf(graph, { angles }, id) {
  const together = angles.get(id);
  return together ? solverFunctions.length + together.length / 2 - 1 : graph.operations[id] - Operation.call;
}

/** The functions that are called. @param {Graph} graph @param {Plan[]} plans @returns {number[]} */
function importsOf(graph, plans) {
  const called = plans.flatMap((each) => each.calls.map((id) => functionOf(graph, each, id)));
  return [...new Set(called)];
}

/** Writes one function. */
class FunctionEmitter {
  /** @type {number[]} */ #code = [];
  /** Locals by node. @type {Map<number, number>} */ #locals = new Map();
  /** @type {number[]} */ #freeLocals = [];
  #localCount = 0;
  #graph;
  #plan;
  #remaining;
  #layout;

  /**
   * @param {Graph} graph
   * @param {Plan} plan
   * @param {{ slots: Map<number, number>, scratch: number, imports: number[], variableCount: number }} layout
   */
  constructor(graph, plan, layout) {
    this.#graph = graph;
    this.#plan = plan;
    this.#remaining = plan.uses.slice();
    this.#layout = layout;
  }

  emit() {
    const before = this.#collect(() => this.#emitInvariants());
    const loop = this.#collect(() => this.#emitLoop());
    const code = [wasm.globalGet(0), wasm.localSet(DATA), before, ...wasm.repeat(COUNT, loop)];
    const locals = /** @type {[number, number][]} */ ([
      [1, wasm.I32],
      [this.#localCount, wasm.V128],
    ]);
    return wasm.body(locals, code);
  }

  /** @param {() => void} write */
  #collect(write) {
    this.#code = [];
    write();
    return this.#code;
  }

  /** What the loop needs and no variable changes. A number that is read here and there is loaded there; one that is stored again and again is kept. */
  #emitInvariants() {
    const { roots, uses, varies, angles } = this.#plan;
    const needed = this.#neededByLoop();
    const stored = new Set(roots);
    for (let id = 0; id < uses.length; id++) {
      const isOperation = this.#graph.isOperation(id);
      if (uses[id] === 0 || varies[id] || !(isOperation || (uses[id] > 1 && stored.has(id)))) continue;
      if (uses[id] > 1 || needed.has(id) || angles.has(id)) this.#compute(id);
      this.#remaining[id] = KEPT_FOR_EVER;
    }
  }

  /** @returns {Set<number>} nodes that vary nowhere but are read by those that do */
  #neededByLoop() {
    const { roots, uses, varies } = this.#plan;
    const needed = new Set(roots);
    for (let id = 0; id < uses.length; id++) {
      if (uses[id] > 0 && varies[id]) needed.add(this.#graph.left[id]).add(this.#graph.right[id]);
    }
    return needed;
  }

  #emitLoop() {
    const { roots, uses, varies, order, calls } = this.#plan;
    const places = placesOf(roots);
    const called = new Set(calls);
    for (const id of order) {
      if (varies[id] && (uses[id] > 1 || called.has(id))) this.#compute(id);
      for (const place of places.get(id) ?? []) this.#storeOutput(id, place);
    }
    this.#code.push(...wasm.advance(IN, PAIR_BYTES * this.#layout.variableCount), ...wasm.advance(OUT, PAIR_BYTES * roots.length));
  }

  /** @param {number} id @param {number} place */
  #storeOutput(id, place) {
    this.#code.push(...wasm.localGet(OUT));
    this.#push(id);
    this.#code.push(...wasm.store(PAIR_BYTES * place));
  }

  /** Computes a node into a local of its own, a sine or cosine together with those of the same call. @param {number} id */
  #compute(id) {
    if (this.#locals.has(id)) return;
    const together = this.#plan.angles.get(id);
    if (together === undefined) {
      this.#push(id);
      this.#keep(id);
    } else this.#computeAngles(together);
  }

  /** @param {number[]} together a sine and a cosine, and another two */
  #computeAngles(together) {
    const { scratch } = this.#layout;
    for (let k = 0; k < together.length; k += 2) this.#push(this.#graph.left[together[k]]);
    this.#code.push(...wasm.localGet(DATA), ...wasm.addConstant(scratch), ...this.#call(together[0]));
    for (const [k, id] of together.entries()) {
      if (k > 0) this.#code.push(...wasm.localGet(DATA), ...wasm.load(scratch + (k - 1) * PAIR_BYTES));
      this.#keep(id);
    }
  }

  /** @param {number} id */
  #keep(id) {
    const local = this.#freeLocals.pop() ?? FIRST_VECTOR + this.#localCount++;
    this.#locals.set(id, local);
    this.#code.push(...wasm.localSet(local));
  }

  /** Puts a node on the stack: from its local, or by computing it. @param {number} id */
  #push(id) {
    const tasks = [id];
    for (let task = tasks.pop(); task !== undefined; task = tasks.pop()) {
      if (task < 0) this.#operate(~task);
      else if (this.#locals.has(task)) this.#read(task);
      else if (this.#graph.isOperation(task)) this.#schedule(task, tasks);
      else this.#loadLeaf(task);
    }
  }

  /** @param {number} id @param {number[]} tasks */
  #schedule(id, tasks) {
    tasks.push(~id, ...this.#graph.operands(id).reverse());
  }

  /** @param {number} id */
  #operate(id) {
    const operation = this.#graph.operations[id];
    this.#code.push(...(operation < Operation.call ? wasm.arithmetic[operation - Operation.add] : this.#call(id)));
  }

  /** @param {number} id */
  #call(id) {
    return wasm.call(this.#layout.imports.indexOf(functionOf(this.#graph, this.#plan, id)));
  }

  /** @param {number} id */
  #read(id) {
    const local = /** @type {number} */ (this.#locals.get(id));
    this.#code.push(...wasm.localGet(local));
    if (--this.#remaining[id] === 0) this.#freeLocals.push(local);
  }

  /** @param {number} id */
  #loadLeaf(id) {
    const { operations, left } = this.#graph;
    if (operations[id] === Operation.variable) this.#code.push(...wasm.localGet(IN), ...wasm.load(PAIR_BYTES * left[id]));
    else {
      const slot = operations[id] === Operation.parameter ? left[id] : /** @type {number} */ (this.#layout.slots.get(id));
      this.#code.push(...wasm.localGet(DATA), ...wasm.loadSplat(NUMBER_BYTES * slot));
    }
  }
}

/** Places of every root in the output. @param {number[]} roots */
function placesOf(roots) {
  /** @type {Map<number, number[]>} */
  const places = new Map();
  roots.forEach((id, place) => {
    const known = places.get(id);
    if (known) known.push(place);
    else places.set(id, [place]);
  });
  return places;
}
