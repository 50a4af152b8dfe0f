/* Formulas -> a small WebAssembly module that evaluates them with their derivatives, and the data block it reads. */

import { refuse } from '../arguments.js';
import { differentiate } from './differentiate.js';
import { emit } from './emit.js';
import { ExpressionError } from './error.js';
import { constants, functions } from './functions.js';
import { Graph } from './graph.js';
import { differentiateNodes } from './nodes.js';
import { isName } from './notation.js';
import { parse } from './parse.js';

/** @typedef {import('./graph.js').Apply} Apply */
/** @typedef {import('./parse.js').Meaning} Meaning */
/** @typedef {import('./differentiate.js').Jet} Jet */

/** How many named parameters there may be. */
const LARGEST_PARAMETER_COUNT = 64;

/**
 * What a surface is put together with that is not three formulas.
 * @typedef {object} Formulas
 * @property {Graph} graph where its nodes are made
 * @property {(source: string | number, name: string, variables: string[], known?: Record<string, number>) => number} read the node of a formula over some
 *   of the variables and over known nodes, whose names no parameter may have; `name` is for error messages
 * @property {(node: number, variable: string) => number} slope the node of a derivative
 */

/**
 * @typedef {object} Compiled
 * @property {Uint8Array<ArrayBuffer>} module imports env.memory, env.data (i32 constant, address of the data block, a multiple of 16) and the env.sp_… functions it calls; exports `jet` and `value`
 * @property {Float64Array} data what the data block starts with: parameters in the order of their names, the widths of creases, then constants
 * @property {number} dataBytes size of the data block with its scratch, a multiple of 16
 * @property {string[]} parameterNames in the order of `data`
 * @property {Graph} graph
 * @property {number[]} jet nodes that `jet` stores: values, first derivatives variable by variable, second derivatives in upper-triangular order
 * @property {number[]} value nodes that `value` stores: values, with `valueOrder` 1 the first derivatives too
 */

/**
 * Compiles the expressions of a surface.
 * @param {object} options
 * @param {(string | number)[] | ((formulas: Formulas) => number[])} options.outputs the expressions, or what makes their nodes
 * @param {string[]} options.names what the caller calls them, for error messages: 'x', 'y', 'z' or 'f'
 * @param {string[]} options.variables such as 'u', 'v'
 * @param {Record<string, number>} [options.parameters] named constants, changeable in the data block; they hide the constants pi, e and tau
 * @param {0 | 1} [options.valueOrder] whether `value` stores first derivatives too; default: only if there is one output
 * @param {Apply} options.apply folds elementary functions of constants
 * @param {import('./creases.js').Creases} [options.creases] takes down those of the expressions, or says on which side of them they are wanted, or that they are rounded
 * @returns {Compiled}
 * @throws {ExpressionError} for an expression or parameter that cannot be used
 * @throws {TypeError} for an expression that is no string or finite number, a parameter that is no finite number
 */
export function compile({ outputs, names, variables, parameters = {}, valueOrder = names.length === 1 ? 1 : 0, apply, creases }) {
  const parameterNames = Object.keys(parameters);
  const scope = createScope(variables, parameters);
  const graph = new Graph(apply);
  const jets =
    typeof outputs === 'function'
      ? differentiateNodes(graph, outputs(formulasOf(graph, variables, scope, creases)), variables.length, 2)
      : outputs.map((source, k) => differentiate(graph, read(source, scope, names[k]), variables.length, 2, [], creases));
  const jet = layOut(jets, 2);
  const value = layOut(jets, valueOrder);
  const widths = new Array(creases?.widthCount ?? 0).fill(0);
  const counts = { variableCount: variables.length, parameterCount: parameterNames.length + widths.length };
  const { module, constants: numbers, dataBytes } = emit(graph, { jet, value }, counts);
  const data = Float64Array.from([...parameterNames.map((name) => parameters[name]), ...widths, ...numbers]);
  return { module, data, dataBytes, parameterNames, graph, jet, value };
}

/** @param {Graph} graph @param {string[]} variables @param {Map<string, Meaning>} scope @param {import('./creases.js').Creases} [creases] @returns {Formulas} */
function formulasOf(graph, variables, scope, creases) {
  const visible = (/** @type {string[]} */ names, /** @type {string[]} */ known) => {
    const own = new Map([...scope].filter(([name, { kind }]) => kind !== 'variable' || names.includes(name)));
    for (const [value, name] of known.entries()) {
      if (own.get(name)?.kind === 'parameter') refuseVariable(name);
      own.set(name, { kind: 'known', value });
    }
    return own;
  };
  return {
    graph,
    read: (source, name, names, known = {}) => {
      const jets = Object.values(known).map((value) => ({ value, first: [], second: [] }));
      return differentiate(graph, read(source, visible(names, Object.keys(known)), name), 0, 0, jets, creases).value;
    },
    slope: (node, variable) => differentiateNodes(graph, [node], variables.length, 1)[0].first[variables.indexOf(variable)],
  };
}

/**
 * Evaluates an expression without variables, such as the end of a range.
 * @param {string | number} source
 * @param {Record<string, number>} parameters
 * @param {Apply} apply
 * @param {string} [name] what the caller calls it, for error messages
 * @returns {number} may be infinite or NaN, as sqrt(-1) is
 * @throws {ExpressionError}
 * @throws {TypeError}
 */
export function evaluateConstant(source, parameters, apply, name = '') {
  const scope = createScope([], parameters);
  const values = Object.values(parameters);
  for (const [parameter, { kind, value }] of scope)
    if (kind === 'parameter') scope.set(parameter, { kind: 'number', value: values[value] });
  const graph = new Graph(apply);
  return graph.numberOf(differentiate(graph, read(source, scope, name), 0, 0).value);
}

/** @param {string | number} source @param {Map<string, Meaning>} scope @param {string} name @returns {import('./postfix.js').Instruction[]} */
function read(source, scope, name) {
  if (typeof source === 'string') return parse(source, scope, name);
  if (typeof source === 'number' && Number.isFinite(source)) return [{ kind: 'number', name: '', value: source, index: 0 }];
  refuse(name || 'the expression', 'a string or a finite number', source);
}

/** What names mean: variables before parameters before constants. @param {string[]} variables @param {Record<string, number>} parameters @returns {Map<string, Meaning>} */
function createScope(variables, parameters) {
  /** @type {Map<string, Meaning>} */
  const scope = new Map();
  for (const [value, name] of variables.entries()) scope.set(name, { kind: 'variable', value });
  Object.entries(parameters).forEach(([name, value], index) => {
    checkParameter(name, value, index, scope);
    scope.set(name, { kind: 'parameter', value: index });
  });
  for (const [name, value] of constants) if (!scope.has(name)) scope.set(name, { kind: 'number', value });
  return scope;
}

/** @param {string} name @param {string} message @returns {never} */
function refuseParameter(name, message) {
  throw new ExpressionError(name, 0, message, 'parameters');
}

/** @param {string} name of a parameter */
function refuseVariable(name) {
  refuseParameter(name, `${name} is a variable of the surface; give the parameter another name`);
}

/** @param {string} name @param {number} value @param {number} index @param {Map<string, Meaning>} scope */
function checkParameter(name, value, index, scope) {
  if (index >= LARGEST_PARAMETER_COUNT)
    refuseParameter(name, `there are more than ${LARGEST_PARAMETER_COUNT} parameters; write some as numbers`);
  if (!isName(name)) refuseParameter(name, `${JSON.stringify(name)} cannot name a parameter; write a letter, then letters and digits`);
  if (functions.has(name)) refuseParameter(name, `${name} is a function; give the parameter another name`);
  if (scope.has(name)) refuseVariable(name);
  if (!Number.isFinite(value)) refuse(`the parameter ${name}`, 'a finite number', value);
}

/** Nodes of all outputs together, by order of derivative. @param {Jet[]} jets @param {0 | 1 | 2} order */
function layOut(jets, order) {
  const nodes = jets.map(({ value }) => value);
  for (const derivatives of [order > 0 ? jets.map(({ first }) => first) : [], order > 1 ? jets.map(({ second }) => second) : []]) {
    for (let k = 0; k < (derivatives[0]?.length ?? 0); k++) nodes.push(...derivatives.map((of) => of[k]));
  }
  return nodes;
}
