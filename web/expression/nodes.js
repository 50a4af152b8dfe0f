/* Differentiation of nodes that are in the graph already: for surfaces that are put together from formulas and from derivatives of formulas. */

import { Calculus } from './differentiate.js';
import { solverFunctions } from './functions.js';
import * as Operation from './operation.js';
import { plan } from './plan.js';

/** @typedef {import('./graph.js').Graph} Graph */
/** @typedef {import('./differentiate.js').Jet} Jet */

/** What formulas call the operations. @type {Record<number, string>} */
const NAMES = {
  [Operation.add]: 'add',
  [Operation.subtract]: 'subtract',
  [Operation.multiply]: 'multiply',
  [Operation.divide]: 'divide',
  [Operation.negate]: 'negate',
  [Operation.absolute]: 'abs',
  [Operation.squareRoot]: 'sqrt',
  [Operation.floor]: 'floor',
  [Operation.minimum]: 'min',
  [Operation.maximum]: 'max',
};

/**
 * Adds the derivatives of nodes to their graph.
 * @param {Graph} graph
 * @param {number[]} nodes
 * @param {number} variableCount
 * @param {1 | 2} order of the highest derivatives wanted
 * @returns {Jet[]}
 */
export function differentiateNodes(graph, nodes, variableCount, order) {
  const calculus = new Calculus(graph, variableCount, order === 2);
  const { uses } = plan(graph, nodes);
  /** @type {Jet[]} by node */
  const jets = [];
  for (let id = 0; id < uses.length; id++) {
    if (uses[id] === 0) continue;
    const operands = graph.operands(id).map((operand) => jets[operand]);
    jets[id] = jetOf(graph, calculus, id, operands);
  }
  return nodes.map((node) => jets[node]);
}

/** @param {Graph} graph @param {Calculus} calculus @param {number} id @param {Jet[]} operands @returns {Jet} */
function jetOf(graph, calculus, id, operands) {
  const operation = graph.operations[id];
  if (operation === Operation.variable) return calculus.variable(graph.left[id]);
  if (operation >= Operation.call) return calculus.call(solverFunctions[operation - Operation.call].name, operands);
  if (NAMES[operation]) return calculus.call(NAMES[operation], operands);
  const constant = calculus.constant(id);
  if (operands.length === 0 || operation === Operation.less) return constant;
  return choice(graph, id, operands, constant);
}

/**
 * The operations of which a choice is made act on derivatives as they do on numbers. In a sign they act on single bits and on the argument where
 * it is 0 or NaN: nothing to differentiate.
 * @param {Graph} graph @param {number} id @param {Jet[]} operands @param {Jet} constant
 */
function choice(graph, id, [a, b], constant) {
  const [operation, mask] = [graph.operations[id], b.value];
  /** @param {(x: number, y: number) => number} act @returns {Jet} */
  const combine = (act) => ({
    value: id,
    first: a.first.map((x, i) => act(x, b.first[i])),
    second: a.second.map((x, i) => act(x, b.second[i])),
  });
  if (operation === Operation.or) return combine((x, y) => graph.or(x, y));
  if (graph.operations[mask] !== Operation.less) return constant;
  if (operation === Operation.and) return combine((x) => graph.and(x, mask));
  return graph.right[mask] === graph.absolute(a.value) ? constant : combine((x) => graph.andNot(x, mask));
}
