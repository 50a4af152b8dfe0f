// The defaults, high-order elements from a global search: right to the tolerance on every stored path, with an honest estimate.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { load } from '../../web/index.js';
import { loadCases } from '../helpers/cases.js';
import { verifyPath } from '../helpers/verify-path.js';

/** @typedef {import('../helpers/cases.js').Case} Case */
/** @typedef {import('../../web/index.js').Path} Path */

const surfpath = await load();
const cases = loadCases({ families: 'ABCDF', kinds: ['parametric', 'implicit'] }).filter(
  ({ definition }) => definition.density === undefined,
);
const names = [...new Set(cases.map(nameOf))];

/** Enough that no path turns by more than a quarter from chord to chord: only then can points be judged as those of a geodesic. */
const FINE = 255;

/** Surface and kind: one test each. @param {Case} one */
function nameOf({ expected, definition }) {
  return `${expected.family} ${expected.surface}, ${definition.kind}`;
}

/** @type {Map<string, import('../../web/index.js').Surface>} by definition: a graph is built once */
const surfaces = new Map();

/** @param {Case} one */
function surfaceOf({ definition }) {
  const key = JSON.stringify(definition);
  const surface = surfaces.get(key) ?? surfpath.surface(/** @type {any} */ (definition));
  surfaces.set(key, surface);
  return surface;
}

/** All cases of a surface, solved. @param {string} name @param {import('../../web/path.js').PathOptions} [options] */
function solveAll(name, options) {
  const own = cases.filter((one) => nameOf(one) === name);
  return own.map((one) => ({ ...one, path: surfaceOf(one).shortestPath(one.from, one.to, options) }));
}

/** Eq. 47 has the sharpest turns of all. @param {Case} one */
const toleranceOf = ({ expected }) => (expected.surface.startsWith('bc_') ? 1e-8 : 1e-9);

/** @param {Path} path */
function chordsOf({ points }) {
  return Array.from({ length: points.length / 3 - 1 }, (_, i) =>
    Math.hypot(...[0, 1, 2].map((k) => points[3 * i + 3 + k] - points[3 * i + k])),
  );
}

/** A path as the polyline of its points, whose length is that of its chords. @param {Path} path */
const polylineOf = (path) => ({ ...path, length: chordsOf(path).reduce((sum, chord) => sum + chord) });

/** Points in the opposite order. @param {Float64Array} points */
const backwards = (points) => points.map((_, i) => points[points.length - 3 - i + 2 * (i % 3)]);

describe('the open data, default options', () => {
  for (const name of names) {
    test(`${name}: converged, right to the tolerance, lengthError honest, singularities told`, () => {
      for (const one of solveAll(name)) {
        const { id, path, expected } = one;
        const error = Math.abs(path.length - expected.length);
        assert.equal(path.status, 'converged', id);
        assert.equal(path.index, 0, id);
        assert.ok(error <= toleranceOf(one) * expected.length, `${id}: length ${path.length}, not ${expected.length}`);
        assert.ok(path.lengthError >= 0 && path.lengthError <= 1e-9 * path.length, `${id}: lengthError ${path.lengthError}`);
        /* The estimate is that of the last refinement; the stored length has an error of its own. */
        const known = 10 * path.lengthError + 4 * expected.relerr_bound * expected.length;
        assert.ok(error <= known, `${id}: error ${error}, said ${path.lengthError}`);
        assert.equal(path.crossesSingularity, Boolean(expected.crosses_cusp), `${id}: crossesSingularity`);
      }
    });

    test(`${name}: B to A is A to B backwards, to the bit`, () => {
      for (const one of solveAll(name)) {
        const { id, from, to, path } = one;
        const back = surfaceOf(one).shortestPath(to, from);
        assert.deepEqual({ ...back, points: backwards(back.points), parameters: null }, { ...path, parameters: null }, id);
      }
    });

    test(`${name}: begins and ends where asked, on the surface, equally spaced, a geodesic`, () => {
      for (const { id, definition, from, to, path, expected } of solveAll(name, { points: FINE })) {
        if (expected.crosses_cusp) assertSpacedAcrossCusp(id, path);
        else assert.deepEqual(verifyPath(definition, polylineOf(path), { from, to }), [], id);
      }
    });
  }

  test('the data have cases of every sort', () => {
    assert.equal(cases.length, 179);
    assert.ok(cases.filter(({ expected }) => expected.crosses_cusp).length >= 3);
    assert.ok(cases.filter(({ expected }) => expected.touches_boundary).length >= 8);
  });
});

/** A cusp turns the path around in space, so that the one chord that spans it may be short; all others are an equal part of the length. @param {string} id @param {Path} path */
function assertSpacedAcrossCusp(id, path) {
  const chords = chordsOf(path).map((chord) => (chord * (FINE + 1)) / path.length);
  assert.ok(Math.max(...chords) <= 1 + 1e-9, `${id}: a chord is longer than its part of the path`);
  const short = chords.filter((chord) => chord < 0.99);
  assert.ok(short.length <= 1, `${id}: short chords ${short}`);
}

describe('the open data, at other tolerances', () => {
  for (const name of names.filter((one) => 'ABCF'.includes(one[0]))) {
    test(`${name}: 1e-12 gives eleven digits`, () => {
      for (const { id, path, expected } of solveAll(name, { tolerance: 1e-12 })) {
        assert.equal(path.status, 'converged', id);
        assert.ok(Math.abs(path.length / expected.length - 1) <= 1e-11, `${id}: length ${path.length}, not ${expected.length}`);
      }
    });
  }

  for (const tolerance of [1e-3, 1e-6]) {
    test(`${tolerance}: as right as asked, in no more steps than 1e-9`, () => {
      for (const name of names) {
        const fine = solveAll(name);
        for (const [i, { id, path, expected }] of solveAll(name, { tolerance }).entries()) {
          assert.equal(path.status, 'converged', id);
          assert.ok(Math.abs(path.length / expected.length - 1) <= tolerance, `${id}: length ${path.length}, not ${expected.length}`);
          /* Where a path crosses a cusp, so many steps are those of a search for the crossing. */
          if (expected.crosses_cusp) continue;
          assert.ok(path.iterations <= fine[i].path.iterations, `${id}: ${path.iterations} steps, ${fine[i].path.iterations} at 1e-9`);
        }
      }
    });
  }
});

test('where a surface is torn an error says that nothing is known of the length, and no more', () => {
  for (const z of ['floor(3x)', 'floor(x + y)', 'x - floor(x)'])
    for (const start of /** @type {const} */ (['global', 'straight'])) {
      const path = surfpath.graph({ z, x: [-1, 1], y: [-1, 1] }).shortestPath([-0.9, -0.3], [0.8, 0.4], { start });
      assert.equal(path.status, 'stalled', z);
      assert.ok(path.lengthError > 0.1 * path.length && path.lengthError <= path.length, `${z}: ${path.length} ± ${path.lengthError}`);
    }
});
