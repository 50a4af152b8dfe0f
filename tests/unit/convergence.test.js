// Newton's method needs the few iterations that are promised, from straight starts, and says honestly where it ends.
import assert from 'node:assert/strict';
import { before, describe, test } from 'node:test';
import { gallery } from '../../web/gallery.js';
import { load } from '../../web/index.js';
import { randomPairs } from '../bench/pairs.js';
import { STRAIGHT } from '../helpers/options.js';
import { createRandom } from '../helpers/random.js';

/** @typedef {import('../../web/path.js').Path} Path */
/** @typedef {import('../../web/path.js').PathOptions} PathOptions */

const SEED = 20260101;
const PAIRS = 1000;
/** The paper's test for convergence. @type {PathOptions} */
const OPTIONS = { ...STRAIGHT, points: 50, gradientTolerance: 1e-6 };

/** Largest mean number of iterations over the pairs whose path touches no edge. @type {[keyof typeof gallery, number][]} */
const PARAMETRIC = [
  ['saddle', 3],
  ['helicoid', 3],
  ['paraboloid', 4],
  ['dini', 6],
  ['parametricTorus', 5],
];
/** The same over the pairs whose straight start keeps its sheet. @type {[keyof typeof gallery, number][]} */
const IMPLICIT = [
  ['torus', 8],
  ['metamorphosis', 8],
  ['genus2', 8],
];
/** Where the paper's method may end; a status without a path has a NaN length, and no other has. */
const HONEST = new Set(['converged', 'saddle', 'stalled', 'sheet-jump', 'iteration-limit']);

/** @type {Awaited<ReturnType<typeof load>>} */ let surfpath;

/** @param {keyof typeof gallery} name @param {PathOptions} options @returns {Path[]} one for each of the same random pairs */
function solveAll(name, options) {
  const surface = surfpath.surface(gallery[name]);
  const paths = randomPairs(surface, createRandom(SEED), PAIRS).map(([from, to]) => surface.shortestPath(from, to, options));
  surface.dispose();
  return paths;
}

/** @param {Path[]} paths */
function iterationsOf(paths) {
  const counts = paths.map(({ iterations }) => iterations);
  return { mean: counts.reduce((sum, count) => sum + count, 0) / counts.length, most: Math.max(...counts) };
}

/** @param {Path[]} paths */
function statusesOf(paths) {
  const count = (/** @type {string} */ status) => paths.filter((path) => path.status === status).length;
  return [...new Set(paths.map(({ status }) => status))].map((status) => `${status} ${count(status)}`).join(', ');
}

/** No number of a path is NaN or infinite, and its length is that of its chords. @param {Path} path */
function assertFinite(path) {
  assert.ok(
    [...path.points, ...(path.parameters ?? []), path.length, path.lengthError, path.energy, path.gradientNorm].every(Number.isFinite),
  );
  const chord = (/** @type {number} */ i) => Math.hypot(...[0, 1, 2].map((k) => path.points[i + 3 + k] - path.points[i + k]));
  let sum = 0;
  for (let i = 0; i + 3 < path.points.length; i += 3) sum += chord(i);
  assert.ok(Math.abs(path.length - sum) <= 1e-13 * sum, `length ${path.length}, chords ${sum}`);
}

before(async () => {
  surfpath = await load();
});

describe(`${PAIRS} random pairs, seed ${SEED}, K = 50, |grad E| <= 1e-6, straight start`, () => {
  for (const [name, limit] of PARAMETRIC) {
    test(`${name}: at most ${limit} iterations in the mean, and all converge`, (t) => {
      const free = solveAll(name, OPTIONS).filter((path) => !path.touchesBoundary);
      const { mean, most } = iterationsOf(free);
      t.diagnostic(`${name}: mean ${mean.toFixed(2)}, most ${most}, over ${free.length} pairs`);
      assert.equal(statusesOf(free), `converged ${free.length}`);
      assert.ok(free.length > 0.9 * PAIRS, `only ${free.length} paths touch no edge`);
      assert.ok(free.every((path) => path.index === 0 && path.gradientNorm <= 1e-6));
      assert.ok(mean <= limit, `mean ${mean}`);
      free.forEach(assertFinite);
    });
  }

  for (const [name, limit] of IMPLICIT) {
    test(`${name}, implicit: at most ${limit} iterations in the mean, and all that keep their sheet converge`, (t) => {
      const kept = solveAll(name, OPTIONS).filter((path) => path.status !== 'sheet-jump');
      const { mean, most } = iterationsOf(kept);
      t.diagnostic(`${name}: mean ${mean.toFixed(2)}, most ${most}, over ${kept.length} pairs`);
      assert.equal(statusesOf(kept), `converged ${kept.length}`);
      assert.ok(kept.length > 0.8 * PAIRS, `only ${kept.length} straight starts keep their sheet`);
      assert.ok(kept.every((path) => path.index === 0 && path.gradientNorm <= 1e-6));
      assert.ok(mean <= limit, `mean ${mean}`);
      kept.forEach(assertFinite);
    });
  }

  for (const [name] of [...PARAMETRIC, ...IMPLICIT]) {
    test(`${name}, the paper's method: an honest status, and the same length where it finds the same path`, (t) => {
      const [papers, ours] = [solveAll(name, { ...OPTIONS, algorithm: 'paper' }), solveAll(name, OPTIONS)];
      t.diagnostic(`${name}: ${statusesOf(papers)}`);
      for (const path of papers) {
        assert.ok(HONEST.has(path.status), path.status);
        if (path.status === 'sheet-jump') assert.ok(Number.isNaN(path.length) && path.points.length === 0);
        else assertFinite(path);
        if (path.converged) assert.ok(path.index === 0 && path.gradientNorm <= 1e-6);
      }
      const same = papers.flatMap((path, i) => (path.converged && ours[i].converged && runsBeside(path, ours[i]) ? [i] : []));
      const apart = same.map((i) => Math.abs(papers[i].length / ours[i].length - 1));
      assert.ok(same.length > 0.7 * PAIRS, `only ${same.length} paths are the same`);
      assert.ok(Math.max(...apart) <= 1e-6, `lengths differ by ${Math.max(...apart)}`);
    });
  }
});

/** Two paths of one class: nowhere further apart than a twentieth of their length. @param {Path} one @param {Path} other */
function runsBeside({ points, length }, other) {
  for (let i = 0; i < points.length; i += 3) {
    if (Math.hypot(...[0, 1, 2].map((k) => points[i + k] - other.points[i + k])) > 0.05 * length) return false;
  }
  return true;
}
