// Places and curves moved by whole turns, as the page draws them: the same points of the surface.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { inside, liftNear, turnOn, unrollings } from '../../../demo/state/lifts.js';
import { gallery } from '../../../web/gallery.js';
import { load } from '../../../web/index.js';
import { createRandom } from '../../helpers/random.js';
import { anything } from '../../helpers/refuses.js';

const surfpath = await load();
const figureEight = {
  kind: 'parametric',
  x: '(3 + cos(u/2) sin(v) - sin(u/2) sin(2v)) cos(u)',
  y: '(3 + cos(u/2) sin(v) - sin(u/2) sin(2v)) sin(u)',
  z: 'sin(u/2) sin(v) + cos(u/2) sin(2v)',
  u: [0, '2pi'],
  v: [0, '2pi'],
};

for (const [name, definition] of Object.entries({
  'a Möbius strip': gallery.moebius,
  'Klein’s bottle': figureEight,
  'a torus': gallery.parametricTorus,
  'a saddle': gallery.saddle,
}))
  test(`${name}: moved places are the same points; a curve lies in the rectangle once, in parts`, () => {
    const surface = surfpath.surface(anything(definition));
    const domain = /** @type {NonNullable<typeof surface.domain>} */ (surface.domain);
    const random = createRandom(3);
    const range = (/** @type {number} */ k) => (k ? domain.v : domain.u);
    const isClosed = (/** @type {number} */ k) => (k ? domain.periodic.v : domain.periodic.u);
    const apart = (/** @type {number[]} */ a, /** @type {number[]} */ b) => {
      const [p, q] = [surface.evaluate(a), surface.evaluate(b)];
      return Math.hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
    };
    const isInside = (/** @type {number[]} */ place) => place.every((x, k) => x >= range(k)[0] - 1e-9 && x <= range(k)[1] + 1e-9);
    for (let i = 0; i < 20; i++) {
      const [place, near] = [0, 1].map(() => [random.between(...domain.u), random.between(...domain.v)]);
      for (const k of [0, 1]) {
        const moved = turnOn(domain, place, k, isClosed(k) ? 3 : 0);
        assert.ok(apart(place, moved) < 1e-9);
        assert.ok(apart(place, inside(domain, moved)) < 1e-9 && isInside(inside(domain, moved)));
      }
      const lifted = liftNear(domain, place, near);
      assert.ok(apart(place, lifted) < 1e-9);
      for (const k of [0, 1]) if (isClosed(k)) assert.ok(Math.abs(lifted[k] - near[k]) <= (range(k)[1] - range(k)[0]) / 2 + 1e-9);
      const { parameters } = surface.shortestPath(place, near);
      const points = /** @type {Float64Array} */ (parameters);
      const curves = unrollings(domain, points);
      for (let j = 0; j < points.length / 2; j++) {
        const own = Array.from(points.slice(2 * j, 2 * j + 2));
        assert.ok(curves.every((curve) => apart(curve[j], own) < 1e-9));
        assert.ok(curves.some((curve) => isInside(curve[j])));
      }
    }
    surface.dispose();
  });
