// Straight ahead from A at an angle: measured as the surface measures it, or said why there is none.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { load } from 'surfpath';
import { gallery } from 'surfpath/gallery';
import { tracedPath } from '../../../demo/compute/traced.js';
import { anything } from '../../helpers/refuses.js';

const surfpath = await load();

/** @param {object} definition @param {number[]} from @param {number} angle @param {number} [reach] */
function trace(definition, from, angle, reach = 1) {
  const surface = surfpath.surface(anything(definition));
  return tracedPath({ surface, drawn: surface, definition }, from, { angle, reach, points: 200 }).paths[0];
}

/** The last point of a path. @param {import('surfpath').Path} path */
const endOf = ({ parameters }) => Array.from(/** @type {Float64Array} */ (parameters).subarray(-2));

/** @param {number[]} actual @param {number[]} expected */
const near = (actual, expected) =>
  assert.ok(
    actual.every((x, k) => Math.abs(x - expected[k]) < 1e-6),
    `${actual}, not ${expected}`,
  );

test('in the half-plane, straight up and along a half circle', () => {
  const halfPlane = { kind: 'metric', E: '1/v^2', F: 0, G: '1/v^2', u: [-3, 3], v: [0.1, 4] };
  near(endOf(trace(halfPlane, [0, 1], 90)), [0, Math.E]);
  near(endOf(trace(halfPlane, [0, 1], 0)), [Math.tanh(1), 1 / Math.cosh(1)]);
});

test('a metric that is skew: its own right angle', () => {
  const skew = { kind: 'metric', E: 4, F: 1, G: 1, u: [-3, 3], v: [-3, 3] };
  near(endOf(trace(skew, [0, 0], 0)), [0.5, 0]);
  const height = Math.sqrt(0.75);
  near(endOf(trace(skew, [0, 0], 90)), [-0.25 / height, 1 / height]);
});

test('a metric that is none is told as what it is', () => {
  for (const E of [-1, 0])
    assert.equal(trace({ kind: 'metric', E, F: 0, G: 1, u: [-1, 1], v: [-1, 1] }, [0, 0], 30).status, 'singular-metric');
});

test('a skew plane in space: the angle is that of space', () => {
  const plane = { kind: 'parametric', x: '2u+v', y: 'v', z: 0, u: [-3, 3], v: [-3, 3] };
  near(Array.from(trace(plane, [0, 0], 30).points.slice(-3)), [Math.cos(Math.PI / 6), 0.5, 0]);
});

test('at a tip, a pole and a node there is none, in the reader’s words', () => {
  for (const [definition, from] of /** @type {[object, number[]][]} */ ([
    [{ kind: 'revolution', r: 't', z: 't', t: [0, 2] }, [1, 0]],
    [{ kind: 'parametric', x: 'v*cos(u)', y: 'v*sin(u)', z: 0, u: [0, '2*pi'], v: [0, 1] }, [1, 0]],
    [{ ...gallery.globe, x: '5+cos(v)*cos(u)' }, [1, Math.PI / 2]],
    [{ kind: 'implicit', f: 'x^2+y^2-z^2', bounds: [0, 1, 2].map(() => [-1, 1]) }, [0, 0, 0]],
  ]))
    assert.throws(() => trace(definition, from, 30), /^RangeError: There is no direction at A, as at a tip: move it\.$/);
});
