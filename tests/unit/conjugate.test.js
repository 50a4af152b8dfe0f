// Ends that are nearly antipodal on a perfect sphere: the length is known, whatever the way, and what is said of it holds.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { load } from '../../web/index.js';
import { createRandom } from '../helpers/random.js';
import { ofAll } from '../helpers/sample.js';

const SEED = 11;
/** How far the second end is from antipodal, in space, about. */
const APART = ofAll([1e-2, 1e-5, 0], [1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 0]);
const TOLERANCES = [1e-4, 1e-6, 1e-9, 1e-12];
/** Rounding of the ends and of the reference. */
const ROUNDING = 2e-14;

const surfpath = await load();
const globe = surfpath.parametric({
  x: 'cos(v)*cos(u)',
  y: 'cos(v)*sin(u)',
  z: 'sin(v)',
  u: [0, 2 * Math.PI],
  v: [-Math.PI / 2, Math.PI / 2],
  periodic: { u: true, v: false },
});
const ball = surfpath.implicit({ f: 'x^2 + y^2 + z^2 - 1' });

/** @typedef {[number, number]} Place longitude and latitude */

/** @param {Place} place */
const inSpace = ([u, v]) => [Math.cos(v) * Math.cos(u), Math.cos(v) * Math.sin(u), Math.sin(v)];

/** Half the chord from one place to the antipode of the other, which rounding leaves exact however short. @param {Place} from @param {Place} to */
function halfChord([u, v], [s, t]) {
  const turn = Math.abs(s - u) - Math.PI;
  return Math.sqrt(Math.sin((t + v) / 2) ** 2 + Math.cos(v) * Math.cos(t) * Math.sin(turn / 2) ** 2);
}

/** @param {number} sine half a chord */
const lengthOf = (sine) => Math.PI - 2 * Math.asin(sine);

/**
 * @param {import('../../web/index.js').Path} path @param {number} length @param {number} tolerance @param {string} name
 */
function check(path, length, tolerance, name) {
  const error = Math.abs(path.length - length);
  assert.ok(['converged', 'ill-conditioned'].includes(path.status), `${name}: ${path.status}`);
  assert.ok(error <= path.lengthError + ROUNDING, `${name}: ${path.status}, error ${error}, said ${path.lengthError}`);
  if (path.converged) assert.ok(error <= tolerance * length + ROUNDING, `${name}: converged, error ${error}`);
}

test(`nearly antipodal ends, seed ${SEED}`, () => {
  const random = createRandom(SEED);
  for (const apart of APART)
    for (const [i, tolerance] of TOLERANCES.entries()) {
      /** @type {Place} */
      const from = [random.between(0, 2 * Math.PI), Math.asin(random.between(-0.99, 0.99))];
      const way = [0, Math.PI / 2, random.between(0, 2 * Math.PI)][i % 3];
      /** @type {Place} */
      const to = [from[0] + Math.PI + (apart * Math.cos(way)) / Math.cos(from[1]), -from[1] + apart * Math.sin(way)];
      const name = `${JSON.stringify([from, to])}, tolerance ${tolerance}`;
      check(globe.shortestPath(from, to, { tolerance }), lengthOf(halfChord(from, to)), tolerance, `globe ${name}`);
      const [a, b] = [inSpace(from), inSpace(to)];
      const sum = Math.hypot(a[0] + b[0], a[1] + b[1], a[2] + b[2]);
      check(ball.shortestPath(a, b, { tolerance }), lengthOf(sum / 2), tolerance, `ball ${name}`);
    }
});

// The way over the pole has a corner of 1.6e-7 and was called converged, though 8.4e-8 too long.
test('a corner over a pole counts as long as it may be cut', () => {
  /** @type {[Place, Place][]} */
  const pairs = [
    [
      [0.8330400114602214, -0.908766011815234],
      [3.9746325043802626, 0.9087659961591592],
    ],
    [
      [1.4802157206519257, 0.40682969272953273],
      [4.621808268085117, -0.40682971498469006],
    ],
    [
      [5.3550895222305686, -1.4074845406168772],
      [2.2134968078585473, 1.4074845390876964],
    ],
  ];
  for (const [from, to] of pairs)
    for (const tolerance of TOLERANCES)
      check(globe.shortestPath(from, to, { tolerance }), lengthOf(halfChord(from, to)), tolerance, JSON.stringify([from, to]));
});

// The farthest vertex of the graph was taken for one that nothing leads to.
test('ends farthest from each other are not disconnected', () => {
  /** @type {[number[], number[]][]} */
  const pairs = [
    [
      [0.09931254067257633, 0.3434560322604786, -0.9339030855335295],
      [-0.09931233694145297, -0.34354989246125167, 0.9338685834318926],
    ],
    [
      [0.9380104527736055, -0.3390003566556758, -0.07221598628267935],
      [-0.9380328337566551, 0.3389270130989075, 0.0722695135331091],
    ],
  ];
  for (const [from, to] of pairs) assert.equal(ball.shortestPath(from, to).status, 'ill-conditioned');
});

// Where E, F and G measure length the corner was not looked at: 7e-6 too long, and converged.
test('a corner over a pole of E, F, G', () => {
  const plane = surfpath.metric({ E: 'v^2', F: '0', G: '1', u: [0, 2 * Math.PI], v: [0, 2], periodic: { u: true, v: false } });
  /** @type {[Place, Place][]} */
  const pairs = [
    [
      [4.150863732227052, 0.3532150136306882],
      [1.0162196672290253, 1.585276922211051],
    ],
    [
      [4.7697223652131555, 1.4543419214896858],
      [1.627177029944317, 0.7369510605931282],
    ],
    [
      [0.5, 1.2],
      [0.5 + Math.PI, 0.7],
    ],
  ];
  for (const [from, to] of pairs) {
    const apart = Math.hypot(from[1] - to[1], 2 * Math.sqrt(from[1] * to[1]) * Math.sin((to[0] - from[0]) / 2));
    const path = plane.shortestPath(from, to);
    const error = Math.abs(path.length - apart);
    assert.ok(error <= path.lengthError + ROUNDING, `${path.status}, error ${error}, said ${path.lengthError}`);
    if (path.converged) assert.ok(error <= 1e-9 * apart, `converged, error ${error}`);
  }
  plane.dispose();
});
