/**
 * The known shortest paths of tests/data as definitions, pairs of points and options for the library.
 *
 * Knows the rules that README.md there states (periodicity, bounds, densities); knows nothing of how paths are computed.
 */
import { readdirSync, readFileSync } from 'node:fs';

const folder = new URL('../data/', import.meta.url);

/** Half sides of the boxes that the printed domains get wrong. */
const halfSides = new Map([
  ['torus', 5.7],
  ['bc_printed', 1.5],
  ['bc_corrected', 1.5],
]);

/**
 * A case as it stands in its file; tests/data/README.md explains the fields.
 *
 * @typedef {object} StoredCase
 * @property {string} id
 * @property {string} family
 * @property {string} surface
 * @property {'parametric'|'implicit'|'metric'} kind
 * @property {string} [x]
 * @property {string} [y]
 * @property {string} [z]
 * @property {string} [f]
 * @property {string} [E]
 * @property {string} [F]
 * @property {string} [G]
 * @property {string} [density]
 * @property {string} [density_convention]
 * @property {Record<string, (string|number)[]>|null} domain
 * @property {{ u: boolean, v: boolean }|null} periodic
 * @property {number[]} from
 * @property {number[]} to
 * @property {number} length
 * @property {number} relerr_bound
 * @property {boolean} touches_boundary
 * @property {boolean} [crosses_cusp]
 * @property {boolean} unique
 * @property {number|null} second_length
 * @property {number} naive_length
 * @property {boolean} naive_global
 * @property {number[]} [to_lift]
 * @property {number[][]|null} [path]
 * @property {string} note
 */

/**
 * A case made ready: `surface(definition).shortestPath(from, to, options)` should find `expected.length`.
 *
 * @typedef {object} Case
 * @property {string} id
 * @property {string} family
 * @property {import('./verify-path.js').Definition} definition
 * @property {number[]} from
 * @property {number[]} to
 * @property {{ points: number }} options
 * @property {StoredCase} expected
 */

/**
 * Loads the cases.
 *
 * @param {{ families?: string, kinds?: string[] }} [filter] families: their letters, as in 'ABD'; kinds: of the definition, after the rules.
 *   All cases without it.
 * @returns {Case[]} in the order of the files' names
 */
export function loadCases({ families = 'ABCDEF', kinds = ['parametric', 'implicit', 'metric'] } = {}) {
  const names = readdirSync(folder).filter((name) => /^[A-F]_.*\.json$/.test(name) && families.includes(name[0]));
  const stored = names.sort().flatMap((name) => /** @type {StoredCase[]} */ (JSON.parse(readFileSync(new URL(name, folder), 'utf8'))));
  return stored.map(prepare).filter(({ definition }) => kinds.includes(definition.kind));
}

/**
 * @param {StoredCase} stored
 * @returns {Case}
 */
function prepare(stored) {
  const { id, family, from, to } = stored;
  return { id, family, definition: definitionOf(stored), from, to, options: { points: 64 }, expected: stored };
}

/**
 * @param {StoredCase} stored
 * @returns {import('./verify-path.js').Definition}
 */
function definitionOf(stored) {
  if (stored.kind === 'implicit') return { kind: 'implicit', f: text(stored.f), bounds: boundsOf(stored) };
  const domain = /** @type {Record<string, [string, string]>} */ (stored.domain);
  const rectangle = { u: domain.u, v: domain.v, periodic: stored.periodic ?? { u: false, v: false } };
  if (stored.kind === 'metric' && !stored.density) {
    return { kind: 'metric', E: text(stored.E), F: text(stored.F), G: text(stored.G), ...rectangle };
  }
  const { x = 'u', y = 'v', z = '0' } = stored;
  const definition = { kind: /** @type {const} */ ('parametric'), x, y, z, ...rectangle };
  return stored.density ? { ...definition, density: lengthElement(stored) } : definition;
}

/**
 * @param {string|undefined} expression
 * @returns {string}
 */
function text(expression) {
  if (expression === undefined) throw new Error('a case without the expressions of its kind');
  return expression;
}

/**
 * The factor of ds: the paper's Eq. 22 weights the squared length element instead.
 *
 * @param {StoredCase} stored
 */
function lengthElement({ density, density_convention: convention = '' }) {
  return convention.startsWith('T =') ? `sqrt(${density})` : text(density);
}

/**
 * @param {StoredCase} stored
 * @returns {[number, number][]}
 */
function boundsOf({ surface, domain, from, to, path }) {
  if (domain && ['x', 'y', 'z'].every((axis) => domain[axis]) && !halfSides.has(surface)) {
    return ['x', 'y', 'z'].map((axis) => [Number(domain[axis][0]), Number(domain[axis][1])]);
  }
  const half = halfSides.get(surface) ?? 1.6 * Math.max(...[from, to, ...(path ?? [])].flat().map(Math.abs));
  return [0, 1, 2].map(() => [-half, half]);
}
