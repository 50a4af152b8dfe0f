// Edges of the rectangle along which a density or a metric makes ways free: what is longer than the way over one is not `converged`.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { load } from '../../../web/index.js';
import { createRandom } from '../../helpers/random.js';

const surfpath = await load();
const strip = /** @type {const} */ ({ u: [-3, 3], v: [0, 1] });
const plane = { ...strip, x: 'u', y: 'v', z: 0 };
const thrown = surfpath.parametric({ ...plane, density: 'sqrt(1-v)' });
/** Straight up to v = 1, where a stone that is thrown comes to rest, and down. @param {number[][]} ends */
const overEdge = (ends) => ends.reduce((sum, [, v]) => sum + (2 / 3) * (1 - v) ** 1.5, 0);

test('a path that is longer than the way over a free edge is stalled, and its error contains that; a shorter one is converged', () => {
  const ends = [
    [-0.43083612, 0.63770188],
    [0.14704251, 0.70775792],
  ];
  const metric = { E: '1-v', F: 0, G: '1-v' };
  for (const surface of [thrown, surfpath.parametric({ ...plane, metric }), surfpath.metric({ ...strip, ...metric })]) {
    const path = surface.shortestPath(ends[0], ends[1]);
    assert.deepEqual([path.status, path.length.toFixed(7)], ['stalled', '0.3195463']);
    assert.ok(Math.abs(path.length - path.lengthError - overEdge(ends)) < 1e-6);
    assert.equal(surface.shortestPath([-0.2, 0.2], [0.1, 0.3]).status, 'converged');
  }
});

test('of random paths beside a free edge none that is converged is longer than the way over it, and most are', () => {
  const random = createRandom(6);
  let converged = 0;
  for (let i = 0; i < 60; i++) {
    const ends = [0, 1].map(() => [random.between(-1, 1), random.next()]);
    const path = thrown.shortestPath(ends[0], ends[1]);
    if (path.status !== 'converged') continue;
    converged++;
    assert.ok(path.length <= overEdge(ends) * (1 + 1e-6), `${ends}: ${path.length}, ${overEdge(ends)}`);
  }
  assert.ok(converged >= 20, `${converged} of 60`);
});

test('an edge that is free but for rounding is one; a little inside of it paths follow the edge', () => {
  const well = surfpath.parametric({ ...plane, v: [0, 'pi/2'], density: 'sqrt(cos(v))' });
  assert.equal(well.shortestPath([-0.27, 1.2], [0.27, 1.2]).status, 'stalled');
  const inside = surfpath.parametric({ ...plane, v: [0, 0.999], density: 'sqrt(1-v)' });
  const path = inside.shortestPath([-0.43083612, 0.63770188], [0.14704251, 0.70775792]);
  assert.deepEqual([path.status, path.length.toFixed(4)], ['converged', '0.2678']);
});
