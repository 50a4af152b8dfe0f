/* What a function that computes some nodes of a graph has to do: which nodes are alive, how often each is read, which change from point to point,
 * which sines and cosines belong together. */

import { COS, SIN } from './functions.js';
import * as Operation from './operation.js';

/** @typedef {import('./graph.js').Graph} Graph */

/**
 * What a function computes. `uses`: how often each node is read, 0 = not at all. `angles`: for a sine or cosine that is computed with others, all that one call
 * computes: the sine and the cosine of an angle, or of two angles. `order`: the nodes that are read, in the order to compute them: angles that need no call, two
 * by two; what other calls need, then those calls, so that the processor has the last ones to work on while it waits for one that waits for others; then what
 * the first root needs, then the second, so that few are kept at a time. `calls`: those that are calls.
 * @typedef {{ roots: number[], uses: Uint32Array, varies: Uint8Array, angles: Map<number, number[]>, order: number[], calls: number[] }} Plan
 */

/** Turns of nodes: what a call needs comes right before the calls of its kind, roots from 0 on. */
const [TWO_ANGLES, CALL] = [-3, -1];

/** Traits of nodes. */
const [VARIES, CALLS] = [1, 2];

/** Finds out what is wanted, and by whom. @param {Graph} graph @param {number[]} roots nodes that are stored @returns {Plan} */
export function plan(graph, roots) {
  const uses = countUses(graph, roots);
  const traits = traitsOf(graph);
  const angles = pairAngles(graph, uses, traits);
  const turn = graph.operations.map((operation, id) => {
    if (operation < Operation.call) return roots.length;
    return angles.get(id)?.length === 4 ? TWO_ANGLES : CALL;
  });
  for (const [place, root] of roots.entries()) turn[root] = Math.min(turn[root], place);
  for (let id = graph.size - 1; id >= 0; id--) {
    if (uses[id] === 0) continue;
    const asked = turn[id] < 0 ? turn[id] & ~1 : turn[id];
    for (const operand of graph.operands(id)) turn[operand] = Math.min(turn[operand], asked);
  }
  const order = [...uses.keys()].filter((id) => uses[id] > 0).sort((a, b) => turn[a] - turn[b]);
  return {
    roots,
    uses,
    varies: traits.map((trait) => trait & VARIES),
    angles,
    order,
    calls: order.filter((id) => graph.operations[id] >= Operation.call),
  };
}

/** @param {Graph} graph @param {number[]} roots */
function countUses(graph, roots) {
  const uses = new Uint32Array(graph.size);
  for (const root of roots) uses[root]++;
  for (let id = graph.size - 1; id >= 0; id--) if (uses[id] > 0) for (const operand of graph.operands(id)) uses[operand]++;
  return uses;
}

/** What holds of a node or of what it needs. @param {Graph} graph */
function traitsOf(graph) {
  const traits = new Uint8Array(graph.size);
  for (const [id, operation] of graph.operations.entries()) {
    traits[id] = operation >= Operation.call ? CALLS : operation === Operation.variable ? VARIES : 0;
    for (const operand of graph.operands(id)) traits[id] |= traits[operand];
  }
  return traits;
}

/**
 * Sines and cosines of the same angle are one call, which reads the angle once. Two such angles are, if they change from point to point and need no other call.
 * @param {Graph} graph @param {Uint32Array} uses @param {Uint8Array} traits
 */
function pairAngles(graph, uses, traits) {
  /** @type {Map<number, number>} by angle */
  const sines = new Map();
  /** @type {Map<number, number[]>} */
  const angles = new Map();
  /** @type {number[]} */
  let waiting = [];
  const live = [...uses.keys()].filter((id) => uses[id] > 0);
  for (const id of live) if (graph.operations[id] === Operation.call + SIN) sines.set(graph.left[id], id);
  for (const id of live) {
    const angle = graph.left[id];
    const sine = sines.get(angle);
    if (graph.operations[id] !== Operation.call + COS || sine === undefined) continue;
    uses[angle]--;
    const isFree = traits[angle] === VARIES;
    const together = [...(isFree ? waiting : []), sine, id];
    for (const node of together) angles.set(node, together);
    if (isFree) waiting = together.length === 4 ? [] : together;
  }
  return angles;
}

/** Constants that any of the functions reads, in the order of the data block. @param {Graph} graph @param {Plan[]} plans @returns {number[]} */
export function constantsOf(graph, plans) {
  return graph.operations.flatMap((operation, id) =>
    operation === Operation.constant && plans.some(({ uses }) => uses[id] > 0) ? [id] : [],
  );
}
