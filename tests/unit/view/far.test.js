// Far from the origin of space, where 32 bits leave steps, with both releases of three.js: what is drawn, hit by rays and moved lies where the surface has it.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { load } from '../../../web/index.js';
import { gaussianCurvature } from '../../../web/view/curvature.js';
import { boxOf, originOf } from '../../../web/view/origin.js';
import { loadReleases } from '../../helpers/three-releases.js';

const surfpath = await load();
const HEIGHT = '20*sin((x - 500000)/30)*cos((y - 4600000)/40)';
const terrain = surfpath.graph({ z: HEIGHT, x: [499900, 500100], y: [4599900, 4600100] });
/** The same at the origin. */
const near = surfpath.graph({ z: '20*sin(x/30)*cos(y/40)', x: [-100, 100], y: [-100, 100] });
const path = terrain.shortestPath([499920, 4599930], [500070, 4600080]);
/** In parts of 200 metres: what 32 bits leave of an offset. */
const EXACT = 1e-5;

test('things are drawn from their middle where that is far, else from the origin of space', () => {
  assert.deepEqual(originOf([1e6, 0, 0, 1e6 + 4, 2, 0]), [1e6 + 2, 1, 0]);
  assert.deepEqual(originOf([50, 0, 0, 54, 2, 0]), [0, 0, 0]);
  assert.deepEqual(originOf([0, 0, 0]), [0, 0, 0]);
  assert.deepEqual(originOf([]), [0, 0, 0]);
  assert.deepEqual(boxOf([1, 2, 3, 3, 4, 4]), { center: [2, 3, 3.5], radius: 1.5 });
});

test('curvature is that of the same surface at the origin', () => {
  const box = (/** @type {number[]} */ center) => center.map((c) => /** @type {[number, number]} */ ([c - 25, c + 25]));
  const at = (/** @type {string} */ f, /** @type {number[]} */ center) =>
    surfpath.implicit({ f, bounds: /** @type {[[number, number], [number, number], [number, number]]} */ (box(center)) });
  const [x, y] = [499990, 4600020];
  const far = at(`z - ${HEIGHT}`, [x, y, 0]);
  const { positions } = far.mesh({ resolution: 12 });
  const here = at('z - 20*sin(x/30)*cos(y/40)', [x - 500000, y - 4600000, 0]);
  const moved = positions.map((p, i) => p - [500000, 4600000, 0][i % 3]);
  const expected = gaussianCurvature(here, moved);
  const most = expected.reduce((a, b) => Math.max(a, Math.abs(b)), 0);
  for (const [i, K] of gaussianCurvature(far, positions).entries())
    assert.ok(Math.abs(K - expected[i]) < 1e-4 * most, `${K} is not ${expected[i]}`);
});

for (const [title, { draw, THREE }] of await loadReleases())
  describe(title, () => {
    const geometryOf = (surface = terrain) => /** @type {any} */ (draw.surfaceGeometry(surface, { resolution: 24 }));
    const place = (/** @type {any} */ attribute, /** @type {number} */ i) => new THREE.Vector3().fromBufferAttribute(attribute, i);
    /** How a mesh is seen, as three.js puts it together and its material then moves it. @param {any} mesh @param {import('three').Camera} camera */
    const viewOf = (mesh, camera) => {
      mesh.updateMatrixWorld();
      mesh.modelViewMatrix.multiplyMatrices(camera.matrixWorldInverse, mesh.matrixWorld);
      mesh.material.onBeforeRender(null, null, camera, mesh.geometry, mesh, null);
      return new Float32Array(mesh.modelViewMatrix.elements);
    };
    const cameraAt = (/** @type {any} */ geometry) => {
      const camera = new THREE.PerspectiveCamera(32, 1);
      camera.up.set(0, 0, 1);
      draw.fitCamera(camera, geometry, [1, -2, 1]);
      camera.updateMatrixWorld();
      return camera;
    };

    test('what is near is as ever', () => {
      const geometry = geometryOf(near);
      assert.deepEqual(Object.keys(geometry.attributes).sort(), ['normal', 'position', 'uv']);
      assert.equal(geometry.constructor, THREE.BufferGeometry);
      assert.ok(!('FAR' in /** @type {any} */ (draw.surfaceMaterial(geometry).defines)));
    });

    test('positions are those of the mesh, for rays and boxes to all digits', () => {
      const geometry = geometryOf();
      const { positions } = terrain.mesh({ resolution: 24 });
      const { position } = geometry.attributes;
      assert.deepEqual(Array.from(position.array), Array.from(Float32Array.from(positions)));
      for (let i = 0; i < position.count; i++)
        assert.deepEqual(place(position, i).toArray(), Array.from(positions.subarray(3 * i, 3 * i + 3)));
      const mesh = new THREE.Mesh(geometry, draw.surfaceMaterial(geometry));
      const [x, y] = [500013.25, 4600031.5];
      const [hit] = new THREE.Raycaster(new THREE.Vector3(x, y, 100), new THREE.Vector3(0, 0, -1)).intersectObject(mesh);
      const [flat] = new THREE.Raycaster(new THREE.Vector3(x - 500000, y - 4600000, 100), new THREE.Vector3(0, 0, -1)).intersectObject(
        new THREE.Mesh(geometryOf(near), new THREE.MeshBasicMaterial({ side: THREE.DoubleSide })),
      );
      assert.ok(Math.abs(hit.distance - flat.distance) < EXACT, `${hit.distance}, not ${flat.distance}`);
    });

    for (const [how, change] of /** @type {[string, (geometry: any) => any][]} */ ([
      ['as it is', (geometry) => geometry],
      ['turned', (geometry) => geometry.rotateX(-Math.PI / 2)],
      ['brought to the origin', (geometry) => geometry.center()],
      ['as a copy, when what it was made from was moved', (geometry) => [geometry.clone(), geometry.center()][0]],
    ]))
      test(`its material draws it to all digits, ${how}`, () => {
        const geometry = change(geometryOf());
        const camera = cameraAt(geometry);
        const mesh = new THREE.Mesh(geometry, draw.surfaceMaterial(geometry));
        const view = viewOf(mesh, camera);
        const { position, offset } = geometry.attributes;
        const seen = (/** @type {number[]} */ [x, y, z]) =>
          [0, 1, 2].map((k) => view[k] * x + view[4 + k] * y + view[8 + k] * z + view[12 + k]);
        for (let i = 0; i < position.count; i++) {
          const exact = place(position, i).applyMatrix4(mesh.matrixWorld).applyMatrix4(camera.matrixWorldInverse).toArray();
          const drawn = seen(place(offset, i).toArray());
          assert.ok(Math.hypot(...drawn.map((x, k) => x - exact[k])) < 40 * EXACT, `${drawn} is not ${exact}`);
        }
      });

    test('its shaders place vertices by their offsets', () => {
      const shader = { uniforms: {}, vertexShader: '#include <common>\n#include <project_vertex>', fragmentShader: '' };
      const material = /** @type {any} */ (draw.surfaceMaterial(geometryOf()));
      material.onBeforeCompile(shader, null);
      assert.ok('FAR' in material.defines);
      assert.match(shader.vertexShader, /transformed = offset;/);
    });

    test('the camera fits it as the same surface at the origin', () => {
      const [here, there] = [cameraAt(geometryOf(near)), cameraAt(geometryOf())].map(({ position }) => position);
      assert.ok(there.sub(new THREE.Vector3(500000, 4600000, 0)).distanceTo(here) < EXACT, `${there.toArray()}, not ${here.toArray()}`);
    });

    test('a line runs through the points of its path', () => {
      const line = new draw.GeodesicLine(path);
      line.updateMatrixWorld();
      const pass = /** @type {any} */ (line.children[0].children[2]);
      const { instanceStart } = pass.geometry.attributes;
      for (let i = 0; i < pass.geometry.instanceCount; i++) {
        const drawn = place(instanceStart, i);
        assert.ok(drawn.length() < 200);
        assert.ok(drawn.applyMatrix4(pass.matrixWorld).distanceTo(new THREE.Vector3().fromArray(path.points, 3 * i)) < EXACT);
      }
      line.setPath([0, 0, 0, 1, 0, 0]);
      line.updateMatrixWorld();
      assert.deepEqual(place(pass.geometry.attributes.instanceStart, 0).toArray(), [0, 0, 0]);
      assert.deepEqual(pass.getWorldPosition(new THREE.Vector3()).toArray(), [0, 0, 0]);
    });
  });
