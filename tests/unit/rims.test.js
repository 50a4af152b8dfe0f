// Implicit surfaces that end where f has no more value: paths beside that rim, against great circles.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { load } from '../../web/index.js';
import { createRandom } from '../helpers/random.js';
import { anything, close } from '../helpers/refuses.js';

const surfpath = await load();
const RADIUS = Math.SQRT2;
const PAIRS = 12;

describe('between ends beside the rim of a hemisphere, where a step of the projection leads beyond it', () => {
  for (const f of ['z - sqrt(2 - x^2 - y^2)', 'sqrt(2 - x^2 - y^2) - z'])
    for (const bounds of [anything(Array(3).fill([-1.5, 1.5])), undefined])
      test(`${f}, ${bounds ? 'within' : 'without'} bounds`, () => {
        const surface = surfpath.implicit({ f, bounds });
        const random = createRandom(61);
        for (const beside of [0.99, 0.999, 0.9999])
          for (let i = 0; i < PAIRS; i++) {
            const [from, to] = [0, 1].map(() => {
              const angle = random.between(0, 2 * Math.PI);
              const out = RADIUS * beside;
              return [out * Math.cos(angle), out * Math.sin(angle), Math.sqrt(2 - out ** 2)];
            });
            const { status, length } = surface.shortestPath(from, to);
            assert.equal(status, 'converged', `${from} to ${to}`);
            const cosine = from.reduce((sum, x, j) => sum + (x * to[j]) / 2, 0);
            close(length, RADIUS * Math.acos(cosine), 1e-9);
          }
      });
});
