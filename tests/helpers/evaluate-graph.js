/* The graph of a compiled surface evaluated in plain JavaScript, node by node: what the emitted module must reproduce to the bit. */

import * as Operation from '../../web/expression/operation.js';

const numbers = new Float64Array(2);
const bits = new BigUint64Array(numbers.buffer);

/** @param {(x: bigint, y: bigint) => bigint} operation @returns {(x: number, y: number) => number} */
function bitwise(operation) {
  return (x, y) => {
    numbers.set([x, y]);
    bits[0] = operation(bits[0], bits[1]);
    return numbers[0];
  };
}

/** @type {Record<number, (x: number, y: number) => number>} */
const OPERATIONS = {
  [Operation.add]: (x, y) => x + y,
  [Operation.subtract]: (x, y) => x - y,
  [Operation.multiply]: (x, y) => x * y,
  [Operation.divide]: (x, y) => x / y,
  [Operation.negate]: (x) => -x,
  [Operation.absolute]: Math.abs,
  [Operation.squareRoot]: Math.sqrt,
  [Operation.floor]: Math.floor,
  [Operation.minimum]: (x, y) => Math.min(x, y),
  [Operation.maximum]: (x, y) => Math.max(x, y),
  [Operation.and]: bitwise((x, y) => x & y),
  [Operation.andNot]: bitwise((x, y) => x & ~y),
  [Operation.or]: bitwise((x, y) => x | y),
};

/**
 * Evaluates all nodes at one point.
 * @param {import('../../web/expression/graph.js').Graph} graph
 * @param {ArrayLike<number>} point the variables
 * @param {ArrayLike<number>} parameters
 * @param {import('../../web/expression/graph.js').Apply} apply
 * @returns {Float64Array} by node
 */
export function evaluateGraph(graph, point, parameters, apply) {
  const values = new Float64Array(graph.size);
  const words = new BigUint64Array(values.buffer);
  for (let id = 0; id < graph.size; id++) {
    const operation = graph.operations[id];
    const [left, right] = [graph.left[id], graph.right[id]];
    if (operation === Operation.constant) values[id] = graph.numberOf(id);
    else if (operation === Operation.variable) values[id] = point[left];
    else if (operation === Operation.parameter) values[id] = parameters[left];
    else if (operation === Operation.less) words[id] = values[left] < values[right] ? 0xffffffffffffffffn : 0n;
    else if (operation >= Operation.call) values[id] = apply(operation - Operation.call, values[left], values[right]);
    else values[id] = OPERATIONS[operation](values[left], values[right]);
  }
  return values;
}
