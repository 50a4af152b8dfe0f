/* The graph of a compiled surface written as C, for native tests and benchmarks: same operations, same order, hence the same bits as the
 * WebAssembly module. Needs pair.h, functions.h and tests/native/expression.h. */

import { solverFunctions } from '../../web/expression/functions.js';
import * as Operation from '../../web/expression/operation.js';
import { constantsOf, plan } from '../../web/expression/plan.js';

/** @typedef {import('../../web/expression/compile.js').Compiled} Compiled */

/** @type {Record<number, (a: string, b: string) => string>} */
const FORMULAS = {
  [Operation.add]: (a, b) => `${a} + ${b}`,
  [Operation.subtract]: (a, b) => `${a} - ${b}`,
  [Operation.multiply]: (a, b) => `${a} * ${b}`,
  [Operation.divide]: (a, b) => `${a} / ${b}`,
  [Operation.negate]: (a) => `-${a}`,
  [Operation.absolute]: (a) => `sp_absolute(${a})`,
  [Operation.squareRoot]: (a) => `sp_square_root(${a})`,
  [Operation.floor]: (a) => `sp_floor(${a})`,
  [Operation.minimum]: (a, b) => `sp_minimum(${a}, ${b})`,
  [Operation.maximum]: (a, b) => `sp_maximum(${a}, ${b})`,
  [Operation.less]: (a, b) => `sp_less(${a}, ${b})`,
  [Operation.and]: (a, b) => `sp_and(${a}, ${b})`,
  [Operation.andNot]: (a, b) => `sp_and_not(${a}, ${b})`,
  [Operation.or]: (a, b) => `sp_or(${a}, ${b})`,
};

/**
 * Writes `void NAME_jet(int32_t pair_count, const sp_pair *in, sp_pair *out)`, `NAME_value` of the same type, and `double NAME_data[]`: the
 * parameters, which may be changed, then the constants.
 * @param {Compiled} compiled
 * @param {string} name prefix of the C names
 * @param {number} variableCount
 * @returns {string} a C file
 */
export function writeC(compiled, name, variableCount) {
  const plans = [plan(compiled.graph, compiled.jet), plan(compiled.graph, compiled.value)];
  const first = compiled.parameterNames.length;
  const slots = new Map(constantsOf(compiled.graph, plans).map((id, k) => [id, first + k]));
  const write = (/** @type {string} */ suffix, /** @type {import('../../web/expression/plan.js').Plan} */ each) =>
    writeFunction(compiled.graph, each, { name: `${name}_${suffix}`, data: `${name}_data`, slots, variableCount });
  return `#include "expression.h"
#include "functions.h"

extern double ${name}_data[];
void ${name}_jet(int32_t pair_count, const sp_pair *in, sp_pair *out);
void ${name}_value(int32_t pair_count, const sp_pair *in, sp_pair *out);

double ${name}_data[] = {${[...compiled.data].map(literal).join(', ') || '0.0'}};

${write('jet', plans[0])}
${write('value', plans[1])}`;
}

/** A C literal of exactly this number. @param {number} value */
function literal(value) {
  if (Number.isNaN(value)) return '__builtin_nan("")';
  if (!Number.isFinite(value)) return value > 0 ? '__builtin_inf()' : '-__builtin_inf()';
  const text = Object.is(value, -0) ? '-0' : String(value);
  return /[.e]/.test(text) ? text : `${text}.0`;
}

/**
 * @param {import('../../web/expression/graph.js').Graph} graph
 * @param {import('../../web/expression/plan.js').Plan} plan
 * @param {{ name: string, data: string, slots: Map<number, number>, variableCount: number }} layout
 */
function writeFunction(graph, { roots, varies, angles, order }, { name, data, slots, variableCount }) {
  /** @type {string[][]} */
  const [before, inside] = [[], []];
  const declared = new Set();
  for (const id of order) {
    const together = angles.get(id) ?? [id];
    if (!declared.has(id)) (varies[id] ? inside : before).push(...declare(graph, together, data, slots));
    for (const node of together) declared.add(node);
  }
  inside.push(...roots.map((id, place) => `out[${place}] = n${id};`));
  return `void ${name}(int32_t pair_count, const sp_pair *in, sp_pair *out) {
${before.map((line) => `    ${line}\n`).join('')}    for (; pair_count > 0; pair_count--, in += ${variableCount}, out += ${roots.length}) {
${inside.map((line) => `        ${line}\n`).join('')}    }
}
`;
}

/**
 * The declaration of a node, or of the sines and cosines that one call computes.
 * @param {import('../../web/expression/graph.js').Graph} graph
 * @param {number[]} together
 * @param {string} data
 * @param {Map<number, number>} slots
 * @returns {string[]}
 */
function declare(graph, together, data, slots) {
  const [id] = together;
  const operation = graph.operations[id];
  const [a, b] = [`n${graph.left[id]}`, `n${graph.right[id]}`];
  const assign = (/** @type {string} */ formula) => [`const sp_pair n${id} = ${formula};`];
  if (operation === Operation.variable) return assign(`in[${graph.left[id]}]`);
  if (operation === Operation.parameter) return assign(`sp_splat(${data}[${graph.left[id]}])`);
  if (operation === Operation.constant) return assign(`sp_splat(${data}[${slots.get(id)}])`);
  if (operation < Operation.call) return assign(FORMULAS[operation](a, b));
  const called = solverFunctions[operation - Operation.call];
  if (together.length === 1) return assign(`sp_${called.name}(${called.arity === 1 ? a : `${a}, ${b}`})`);
  if (together.length === 2) return [`sp_pair n${together[1]};`, ...assign(`sp_sincos(${a}, &n${together[1]})`)];
  return [
    `sp_pair of${id}[3];`,
    ...assign(`sp_sincos_two(${a}, n${graph.left[together[2]]}, of${id})`),
    ...together.slice(1).map((node, k) => `const sp_pair n${node} = of${id}[${k}];`),
  ];
}
