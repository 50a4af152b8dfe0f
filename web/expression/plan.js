/* What a function that computes some nodes of a graph has to do: which nodes are alive, how often each is read, which change from point to point,
 * which sines and cosines belong together. */

import { COS, SIN } from './functions.js';
import { Operation } from './operation.js';

/** @typedef {import('./graph.js').Graph} Graph */

/**
 * What a function computes. `uses`: how often each node is read, 0 = not at all. `partners`: for a sine its cosine and the reverse, where both are wanted.
 * `order`: the nodes that are read, in the order to compute them: what calls need, then calls, so that the processor has the last ones to work on while it
 * waits for one that waits for others; then what the first root needs, then the second, so that few are kept at a time. `calls`: those that are calls.
 * @typedef {{ roots: number[], uses: Uint32Array, varies: Uint8Array, partners: Map<number, number>, order: number[], calls: number[] }} Plan
 */

/** Finds out what is wanted, and by whom. @param {Graph} graph @param {number[]} roots nodes that are stored @returns {Plan} */
export function plan(graph, roots) {
  const uses = new Uint32Array(graph.size);
  const varies = new Uint8Array(graph.size);
  /** -2: a call needs it; -1: a call; else the first root that needs it. */
  const turn = graph.operations.map((operation) => (operation >= Operation.call ? -1 : roots.length));
  for (const [place, root] of roots.entries()) {
    uses[root]++;
    turn[root] = Math.min(turn[root], place);
  }
  for (let id = graph.size - 1; id >= 0; id--) {
    if (uses[id] === 0) continue;
    const count = graph.operandCount(id);
    const asked = turn[id] < 0 ? -2 : turn[id];
    if (count > 0) {
      uses[graph.left[id]]++;
      turn[graph.left[id]] = Math.min(turn[graph.left[id]], asked);
    }
    if (count > 1) {
      uses[graph.right[id]]++;
      turn[graph.right[id]] = Math.min(turn[graph.right[id]], asked);
    }
  }
  for (let id = 0; id < graph.size; id++) {
    const count = graph.operandCount(id);
    const operandVaries = (count > 0 && varies[graph.left[id]]) || (count > 1 && varies[graph.right[id]]);
    varies[id] = Number(graph.operations[id] === Operation.variable || operandVaries);
  }
  const order = [...uses.keys()].filter((id) => uses[id] > 0).sort((a, b) => turn[a] - turn[b]);
  const calls = order.filter((id) => graph.operations[id] >= Operation.call);
  return { roots, uses, varies, partners: pairSines(graph, uses, calls), order, calls };
}

/** @param {Graph} graph @param {Uint32Array} uses @param {number[]} calls */
function pairSines(graph, uses, calls) {
  /** @type {Map<number, number>} */
  const sines = new Map();
  /** @type {Map<number, number>} */
  const partners = new Map();
  for (const id of calls) if (graph.operations[id] === Operation.call + SIN) sines.set(graph.left[id], id);
  for (const id of calls) {
    const sine = sines.get(graph.left[id]);
    if (graph.operations[id] !== Operation.call + COS || sine === undefined) continue;
    partners.set(id, sine).set(sine, id);
    uses[graph.left[id]]--;
  }
  return partners;
}

/** Constants that any of the functions reads, in the order of the data block. @param {Graph} graph @param {Plan[]} plans @returns {number[]} */
export function constantsOf(graph, plans) {
  return graph.operations.flatMap((operation, id) =>
    operation === Operation.constant && plans.some(({ uses }) => uses[id] > 0) ? [id] : [],
  );
}
