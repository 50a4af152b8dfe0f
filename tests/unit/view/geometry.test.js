// Surfaces as three.js geometry, with both releases of three.js: exact normals, curvature and distance as colours, what is refused.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { gallery } from '../../../web/gallery.js';
import { load } from '../../../web/index.js';
import { gaussianCurvature } from '../../../web/view/curvature.js';
import { loadReleases } from '../../helpers/three-releases.js';

const surfpath = await load();
const torus = surfpath.surface(gallery.parametricTorus);
const sphere = surfpath.surface(gallery.sphere);
const { R, a } = gallery.parametricTorus.parameters;

describe('Gaussian curvature', () => {
  const close = (/** @type {number} */ actual, /** @type {number} */ expected, size = Math.abs(expected)) =>
    assert.ok(Math.abs(actual - expected) < 1e-7 * size, `${actual} is not ${expected}`);

  test('of the torus is cos v / (a (R + a cos v)), parametric', () => {
    const { parameters } = torus.mesh({ resolution: 20 });
    assert.ok(parameters);
    // On the edges of the rectangle it is taken two steps inside: a 50,000th of the range, and as much of K.
    for (const [i, K] of gaussianCurvature(torus, parameters).entries()) {
      const cos = Math.cos(parameters[2 * i + 1]);
      const onEdge = i % 21 === 0 || i % 21 === 20 || i < 21 || i >= 420;
      close(K, cos / (a * (R + a * cos)), onEdge ? 300 : 1);
    }
  });

  test('of the torus, implicit, has the same values', () => {
    const implicit = surfpath.surface(gallery.torus);
    const { positions } = implicit.mesh({ resolution: 16 });
    for (const [i, K] of gaussianCurvature(implicit, positions).entries()) {
      const cos = (Math.hypot(positions[3 * i], positions[3 * i + 1]) - R) / a;
      close(K, cos / (a * (R + a * cos)), 1);
    }
  });

  test('of the sphere is 1 at its poles too, that of a plane and a cylinder none', () => {
    const globe = surfpath.surface(gallery.globe);
    for (const K of gaussianCurvature(globe, /** @type {Float64Array} */ (globe.mesh({ resolution: 12 }).parameters))) close(K, 1, 1e2);
    const plane = surfpath.graph({ z: 'x - 2 y', x: [-1, 1], y: [-1, 1] });
    for (const K of gaussianCurvature(plane, Float64Array.of(0, 0, 1, 1, -1, 0.5))) close(K, 0, 1e-2);
    const cylinder = surfpath.surface(gallery.cylinder);
    for (const K of gaussianCurvature(cylinder, Float64Array.of(0, 0, 1, 1, 3, -0.5))) close(K, 0, 1);
  });
});

for (const [title, { draw, THREE }] of await loadReleases())
  describe(`surfaceGeometry, ${title}`, () => {
    test('holds the mesh, with the surface’s own normals', () => {
      const geometry = draw.surfaceGeometry(torus, { resolution: 24 });
      const mesh = torus.mesh({ resolution: 24 });
      assert.ok(geometry instanceof THREE.BufferGeometry);
      assert.deepEqual(Array.from(geometry.attributes.position.array), Array.from(Float32Array.from(mesh.positions)));
      assert.deepEqual(Array.from(geometry.attributes.normal.array), Array.from(Float32Array.from(mesh.normals)));
      assert.deepEqual(geometry.index?.array, mesh.indices);
      assert.deepEqual([...geometry.attributes.uv.array.slice(0, 2), ...geometry.attributes.uv.array.slice(-2)], [0, 0, 1, 1]);
      assert.equal(geometry.attributes.color, undefined);
      const size = geometry.boundingSphere?.radius ?? 0;
      const known = geometry.boundingSphere?.clone();
      geometry.computeBoundingSphere();
      assert.ok(known?.equals(/** @type {any} */ (geometry.boundingSphere)), 'the bounding sphere is that of three.js');
      assert.ok(size >= R && size < 1.05 * Math.hypot(R + a, a));
    });

    test('leaves out triangles where a formula has no value', () => {
      const half = surfpath.graph({ z: 'sqrt(x)', x: [-1, 1], y: [-1, 1] });
      const { index, attributes } = draw.surfaceGeometry(half, { resolution: 10 });
      assert.ok(index && index.count > 0 && index.count < 6 * 100);
      assert.ok(attributes.position.array.every(Number.isFinite));
      for (const vertex of index.array) assert.ok(attributes.position.getX(vertex) > 0);
    });

    test('ends on the rim of where a formula has a value, whatever it is coloured by', () => {
      const dome = surfpath.graph({ z: 'sqrt(1 - x^2 - y^2)', x: [-1.1, 1.1], y: [-1.1, 1.1] });
      const z = (/** @type {{ positions: Float64Array }} */ { positions }) => positions.filter((_, i) => i % 3 === 2);
      for (const colour of /** @type {const} */ (['none', 'curvature', 'distance', z])) {
        const { index, attributes } = draw.surfaceGeometry(dome, { resolution: 24, colour, from: [0, 0] });
        assert.ok(index);
        assert.equal(attributes.color?.count ?? attributes.position.count, attributes.position.count);
        const lowest = new Array(36).fill(1);
        for (const i of index.array) {
          const turn = Math.atan2(attributes.position.getY(i), attributes.position.getX(i)) / (2 * Math.PI);
          const sector = Math.floor(36 * (turn + 0.5)) % 36;
          lowest[sector] = Math.min(lowest[sector], attributes.position.getZ(i));
        }
        assert.ok(Math.max(...lowest) < 2e-3, `${colour}: ${Math.max(...lowest)}`);
      }
    });

    test('what has one side only is not shaded where it is seen from behind', () => {
      const shadeOf = (/** @type {import('../../../web/surface.js').Surface} */ surface) => {
        const shader = { uniforms: /** @type {any} */ ({}), vertexShader: '', fragmentShader: '' };
        draw
          .surfaceMaterial(draw.surfaceGeometry(surface, { resolution: 8 }))
          .onBeforeCompile(/** @type {any} */ (shader), /** @type {any} */ (null));
        return shader.uniforms.farShade.value.toArray();
      };
      assert.deepEqual(shadeOf(surfpath.surface(gallery.moebius)), [1, 1, 1]);
      assert.ok(shadeOf(torus).every((/** @type {number} */ share) => share < 1));
    });

    test('colours by curvature: the neutral colour is at zero, the two sides differ in hue', () => {
      const geometry = draw.surfaceGeometry(torus, { resolution: 32, colour: 'curvature' });
      const { scale } = geometry.userData;
      assert.equal(scale.quantity, 'curvature');
      assert.equal(scale.low, -scale.high);
      assert.equal(scale.palette.length % 2, 1);
      const colours = geometry.attributes.color;
      const colourAt = (/** @type {number} */ row) => new THREE.Color().fromBufferAttribute(colours, 33 * row);
      const neutral = new THREE.Color(scale.palette[(scale.palette.length - 1) / 2]);
      assert.ok(Math.hypot(...colourAt(8).sub(neutral).toArray()) < 0.01, 'K = 0 at v = π/2');
      const [outside, inside] = [colourAt(0), colourAt(16)];
      assert.ok(outside.g > outside.r && inside.r > inside.g && inside.b > inside.g);
    });

    test('a plane has the neutral colour, whatever differences leave of its curvature', () => {
      const plane = surfpath.graph({ z: 'x - 2 y', x: [-1, 1], y: [-1, 1] });
      const { attributes, userData } = draw.surfaceGeometry(plane, { resolution: 4, colour: 'curvature' });
      const neutral = new THREE.Color(userData.scale.palette[2]);
      for (let i = 0; i < 25; i++) assert.ok(Math.abs(attributes.color.getX(i) - neutral.r) < 0.02);
    });

    test('colours by distance, with contours at round numbers', () => {
      const from = gallery.sphere.from;
      const { attributes, userData } = draw.surfaceGeometry(sphere, { colour: 'distance', from, resolution: 8, exact: true });
      const { scale } = userData;
      assert.ok(scale.low === 0 && scale.high > 0.95 * Math.PI && scale.high < Math.PI + 1e-6);
      assert.equal(scale.spacing, 0.5);
      const { position, contour } = attributes;
      for (let i = 0; i < position.count; i++) {
        const chord = Math.hypot(...[0, 1, 2].map((k) => position.array[3 * i + k] - from[k]));
        // Single precision: near the opposite point the arc sine keeps half of its seven digits.
        const angle = 2 * Math.asin(Math.min(chord / 2, 1));
        assert.ok(Math.abs(contour.getX(i) * scale.spacing - angle) < 1e-3, `${contour.getX(i) * scale.spacing} is not ${angle}`);
      }
    });

    test('colours by any numbers', () => {
      const { userData } = draw.surfaceGeometry(torus, { colour: ({ positions }) => positions.filter((_, i) => i % 3 === 2) });
      assert.equal(userData.scale.quantity, 'values');
      assert.ok(Math.abs(userData.scale.low + a) < 0.01 && Math.abs(userData.scale.high - a) < 0.01);
      assert.throws(() => draw.surfaceGeometry(torus, { colour: () => [1, 2] }), /surfaceGeometry: options.colour must give 9409 numbers/);
    });

    test('refuses what it cannot draw, in words', () => {
      const abstract = surfpath.metric({ E: 1, F: 0, G: 1, u: [0, 1], v: [0, 1] });
      assert.throws(() => draw.surfaceGeometry(abstract), { name: 'TypeError', message: /^surfaceGeometry: .* no positions/ });
      for (const wrong of /** @type {any[]} */ ([null, gallery.parametricTorus]))
        assert.throws(() => draw.surfaceGeometry(wrong), {
          name: 'TypeError',
          message: /^surfaceGeometry: surface must be a Surface that /,
        });
      assert.throws(() => draw.surfaceGeometry(torus, { colour: 'distance' }), { name: 'TypeError', message: /options.from/ });
      assert.throws(() => draw.surfaceGeometry(torus, { colour: /** @type {any} */ ('red') }), RangeError);
      assert.throws(() => draw.surfaceGeometry(torus, /** @type {any} */ ({ color: 'curvature' })), /no option 'color'/);
    });

    test('its material has lines where there are parameters, contours where there are colours', () => {
      const plain = draw.surfaceMaterial(draw.surfaceGeometry(torus, { resolution: 4 }));
      assert.ok(plain.defines && 'PARAMETER_LINES' in plain.defines && !('CONTOURS' in plain.defines) && !plain.vertexColors);
      const coloured = draw.surfaceMaterial(draw.surfaceGeometry(torus, { resolution: 4, colour: 'curvature' }), { roughness: 0.5 });
      assert.ok(coloured.defines && !('PARAMETER_LINES' in coloured.defines) && 'CONTOURS' in coloured.defines && coloured.vertexColors);
      assert.equal(coloured.roughness, 0.5);
      const implicit = draw.surfaceMaterial(draw.surfaceGeometry(sphere, { resolution: 8 }));
      assert.ok(implicit.defines && !('PARAMETER_LINES' in implicit.defines));
    });

    test('what is too large for 32 bits is refused, all of what is not is drawn', () => {
      const sized = (/** @type {string} */ size) => surfpath.parametric({ x: `${size}u`, y: `${size}v`, z: 'u', u: [-1, 1], v: [-1, 1] });
      assert.equal(draw.surfaceGeometry(sized('9e17'), { resolution: 8 }).index?.count, 3 * 2 * 8 * 8);
      assert.throws(() => draw.surfaceGeometry(sized('1e19')), {
        name: 'RangeError',
        message: /^surfaceGeometry: most of the surface lies beyond 1e18, .* use a larger unit$/,
      });
    });

    test('surfaceMaterial and fitCamera say which argument is wrong', () => {
      const none = /** @type {any} */ (undefined);
      const wrong = (/** @type {RegExp} */ message, name = 'TypeError') => ({ name, message });
      assert.throws(
        () => draw.surfaceMaterial(none),
        wrong(/^surfaceMaterial: geometry must be one that surfaceGeometry made, not undefined/),
      );
      assert.throws(() => draw.surfaceMaterial(/** @type {any} */ (torus)), wrong(/^surfaceMaterial: geometry/));
      const [camera, geometry] = [new THREE.PerspectiveCamera(32, 1), draw.surfaceGeometry(torus, { resolution: 4 })];
      assert.throws(() => draw.fitCamera(none, geometry, [1, 0, 0]), wrong(/^fitCamera: camera must be a PerspectiveCamera/));
      assert.throws(
        () => draw.fitCamera(new THREE.PerspectiveCamera(32, 0 / 0), geometry, [1, 0, 0]),
        wrong(/^fitCamera: camera must be a PerspectiveCamera, aspect > 0/),
      );
      assert.throws(() => draw.fitCamera(camera, none, [1, 0, 0]), wrong(/^fitCamera: geometry must/));
      for (const towards of [none, [0, 0, 0], [1, 2], [1, Number.NaN, 0]])
        assert.throws(() => draw.fitCamera(camera, geometry, towards), wrong(/^fitCamera: towards must be a direction/));
      for (const margin of [-0.1, 1, Number.NaN])
        assert.throws(
          () => draw.fitCamera(camera, geometry, [1, 0, 0], margin),
          wrong(/^fitCamera: margin must be a number in \[0, 1\)/, 'RangeError'),
        );
      const nothing = surfpath.implicit({
        f: 'x^2 + y^2 + z^2 + 1',
        bounds: [
          [-1, 1],
          [-1, 1],
          [-1, 1],
        ],
      });
      assert.throws(
        () => draw.fitCamera(camera, draw.surfaceGeometry(nothing), [1, 0, 0]),
        wrong(/^fitCamera: geometry has no triangles/, 'RangeError'),
      );
    });

    test('fitCamera fills the view and centres what is seen', () => {
      for (const [aspect, towards] of /** @type {const} */ ([
        [2, [1, -2, 1]],
        [0.5, [-3, 0.5, 0.2]],
      ])) {
        const camera = new THREE.PerspectiveCamera(32, aspect);
        camera.up.set(0, 0, 1);
        const geometry = draw.surfaceGeometry(torus, { resolution: 32 });
        const target = draw.fitCamera(camera, geometry, towards, 0.2);
        camera.updateMatrixWorld();
        const back = camera.position.clone().sub(target).normalize();
        assert.ok(back.distanceTo(new THREE.Vector3(...towards).normalize()) < 1e-12);
        const seen = new THREE.Box3();
        const point = new THREE.Vector3();
        const { position } = geometry.attributes;
        for (let i = 0; i < position.count; i++) seen.expandByPoint(point.fromBufferAttribute(position, i).project(camera));
        const reach = Math.max(seen.max.x, seen.max.y, -seen.min.x, -seen.min.y);
        assert.ok(reach > 0.77 && reach < 0.815, `${reach} of the view, not 0.8`);
        for (const k of /** @type {const} */ (['x', 'y'])) assert.ok(Math.abs(seen.max[k] + seen.min[k]) < 0.02, 'centred');
        assert.ok(seen.min.z > -1 && seen.max.z < 1, 'between near and far');
      }
    });

    test('fitCamera takes places and directions of three.js as it takes numbers', () => {
      const geometry = draw.surfaceGeometry(torus, { resolution: 16 });
      const [numbers, vectors] = [new THREE.PerspectiveCamera(32, 1), new THREE.PerspectiveCamera(32, 1)];
      const target = draw.fitCamera(numbers, geometry, [1, -2, 1], 0.1, [[0, 0, 9]]);
      assert.deepEqual(draw.fitCamera(vectors, geometry, new THREE.Vector3(1, -2, 1), 0.1, [new THREE.Vector3(0, 0, 9)]), target);
      assert.deepEqual(vectors.position, numbers.position);
      const nowhere = [new THREE.Vector3(), new THREE.Vector3(Number.NaN, 0, 1), new THREE.Vector2(1, 1)];
      for (const towards of /** @type {any[]} */ (nowhere))
        assert.throws(() => draw.fitCamera(vectors, geometry, towards), /^TypeError: fitCamera: towards must be a direction/);
    });

    test('fitCamera tilts a hair what would be seen along `up`: x is to the right then', () => {
      const geometry = draw.surfaceGeometry(torus, { resolution: 16 });
      const point = new THREE.Vector3();
      for (const up of [
        [0, 0, 1],
        [0, 2, 0],
        [-1, 0, 0],
      ])
        for (const towards of [up, up.map((x) => -x)]) {
          const camera = new THREE.PerspectiveCamera(32, 1);
          camera.up.fromArray(up);
          const target = draw.fitCamera(camera, geometry, towards);
          camera.updateMatrixWorld();
          const tilt = camera.position.clone().sub(target).angleTo(point.fromArray(towards));
          assert.ok(tilt > 0 && tilt < 0.002, `${towards}: ${tilt}`);
          const right = point.set(up[0] ? 0 : 1, up[0] ? 1 : 0, 0).project(camera);
          assert.ok(right.x > 0.01 && Math.abs(right.y) < 0.01, `${towards}: ${right.toArray()}`);
        }
    });

    test('fitCamera leaves out spikes, but no place that should be seen', () => {
      const pole = surfpath.graph({ z: '1/(x^2 + y^2)', x: [-2, 2], y: [-2, 2] });
      const geometry = draw.surfaceGeometry(pole, { resolution: 47 });
      const camera = new THREE.PerspectiveCamera(32, 1);
      camera.up.set(0, 0, 1);
      const distanceOf = (/** @type {number[][]} */ ...shown) =>
        draw.fitCamera(camera, geometry, [1, -2, 1], 0.1, shown).distanceTo(camera.position);
      assert.ok((geometry.boundingSphere?.radius ?? 0) > 100);
      assert.ok(distanceOf() < 20, `${distanceOf()}`);
      assert.ok(distanceOf([0.25, 0, 16]) > 25, `${distanceOf([0.25, 0, 16])}`);
    });

    test('fitCamera shows every place that should be seen, however far away', () => {
      const geometry = draw.surfaceGeometry(surfpath.graph({ z: '1000 x y', x: [-1, 1], y: [-1, 1] }));
      const camera = new THREE.PerspectiveCamera(32, 1.5);
      camera.up.set(0, 0, 1);
      const shown = [
        [0, 0, 0],
        [0.5, 0.1, 50],
      ];
      draw.fitCamera(camera, geometry, [0.4, -0.9, 0.5], 0.1, shown);
      camera.updateMatrixWorld();
      for (const place of shown) {
        const { x, y } = new THREE.Vector3().fromArray(place).project(camera);
        assert.ok(Math.abs(x) < 1 && Math.abs(y) < 1, `${place}: ${x}, ${y}`);
      }
    });
  });
