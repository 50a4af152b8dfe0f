// Starts that are given: however many points they have, they lead where a start of a few points does.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { gallery } from '../../web/gallery.js';
import { load } from '../../web/index.js';
import { createRandom } from '../helpers/random.js';

const surfpath = await load();
const PAIRS = 20;
/** Both are right to the default tolerance. */
const TWO_TOLERANCES = 2e-9;

/** The straight line of the parameters. @param {number[]} from @param {number[]} to @param {number} count */
const lineOf = (from, to, count) =>
  Float64Array.from({ length: 2 * count }, (_, i) => {
    const t = Math.floor(i / 2) / (count - 1);
    return (1 - t) * from[i % 2] + t * to[i % 2];
  });

/* Newton on 512 chords and more frees about one of them a step where they lie on a wall that the path does not follow. */
for (const name of /** @type {const} */ (['moebius', 'vase']))
  test(`${name}: a start of 256 points and more converges where one of 64 does, walls or not`, () => {
    const surface = surfpath.surface(gallery[name]);
    const { domain } = surface;
    assert.ok(domain);
    const random = createRandom(5);
    const point = () => [random.between(domain.u[0], domain.u[1]), random.between(domain.v[0], domain.v[1])];
    let touching = 0;
    for (let i = 0; i < PAIRS; i++) {
      const [from, to] = [point(), point()];
      const few = surface.shortestPath(from, to, { start: lineOf(from, to, 64) });
      touching += Number(few.touchesBoundary);
      assert.equal(few.status, 'converged');
      for (const count of [256, 700, 3000]) {
        const many = surface.shortestPath(from, to, { start: lineOf(from, to, count) });
        assert.equal(many.status, 'converged', `${from} to ${to}, ${count} points`);
        assert.ok(Math.abs(many.length / few.length - 1) <= TWO_TOLERANCES, `${from} to ${to}, ${count} points`);
      }
      const far = surface.shortestPath(from, point(), { points: 1000 });
      const moved = surface.shortestPath(from, to, { start: far });
      assert.equal(moved.status, 'converged', `${from} to ${to}, from a path of 1,002 points to elsewhere`);
    }
    assert.ok(touching > 0, 'no pair touches a wall');
    surface.dispose();
  });
