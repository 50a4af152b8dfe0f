// surfpath/three where it draws: in headless Chromium, with the latest release of three.js; `make browsers`: with both. Lines over the surface pixel by pixel; handles by mouse, finger and keys.
import assert from 'node:assert/strict';
import { mkdir, readFile } from 'node:fs/promises';
import { after, before, describe, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { COARSE, measurePicture, nextFrame, openBrowser, openPage } from '../helpers/page.js';
import { RELEASES, scenePage } from '../helpers/scene.js';
import { serveSite } from '../helpers/site.js';

const SCREENSHOTS = fileURLToPath(new URL('../../build/screenshots/', import.meta.url));
/** The releases by their titles, the latest first. */
const TESTED = Object.entries(RELEASES).slice(0, process.env.EVERY_RELEASE ? undefined : 1);
/** The torus of the gallery. */
const [R, A] = [4, 1.5];

/** @type {Awaited<ReturnType<typeof serveSite>>} */ let site;

before(async () => {
  await mkdir(SCREENSHOTS, { recursive: true });
  const pages = TESTED.flatMap(([, name]) => [
    [name, scenePage(name)],
    [`${name}-logarithmic`, scenePage(name, ', logarithmicDepthBuffer: true')],
  ]);
  site = await serveSite(Object.fromEntries(pages));
});
after(() => site?.close());

/** How far a point is from the torus. @param {number[]} point */
const fromTorus = ([x, y, z]) => Math.abs(Math.hypot(Math.hypot(x, y) - R, z) - A);

for (const [title, name] of TESTED)
  describe(title, () => {
    /** @type {Awaited<ReturnType<typeof openBrowser>>} */ let browser;
    /** @type {import('playwright-core').Page} */ let page;
    /** @type {string[]} */ let complaints;

    before(async () => {
      browser = await openBrowser([], COARSE);
      ({ page, complaints } = await openPage(browser.context, `${site.address}/${name}`));
      await page.waitForFunction(() => /** @type {any} */ (window).view);
    });
    after(() => browser?.close());

    /** Empties the scene and puts a torus in it, with an end point at (u, v) if there are any. @param {number[] | null} end @param {string} entry */
    const begin = (end, entry = 'parametricTorus') =>
      page.evaluate(
        ([at, key]) => {
          const { view } = /** @type {any} */ (window);
          const { THREE, draw, gallery, surfpath, scene, camera, controls, renderer, render } = view;
          for (const thing of view.things ?? []) thing.dispose();
          scene.remove(view.mesh);
          camera.position.set(8, -12, 8);
          controls.update();
          view.surface = surfpath.surface(gallery[key]);
          const geometry = draw.surfaceGeometry(view.surface);
          const material = draw.surfaceMaterial(geometry);
          view.mesh = new THREE.Mesh(geometry, material);
          scene.add(view.mesh);
          view.things = [geometry, material];
          view.calls = { start: 0, drag: 0, end: 0, off: 0 };
          const drawn = { camera, controls, domElement: renderer.domElement, mesh: view.mesh, label: 'Point A', onChange: render };
          const events = {
            onDragStart: () => view.calls.start++,
            onDragEnd: () => view.calls.end++,
            onDrag: () => {
              view.calls.drag++;
              view.calls.off += controls.enabled ? 0 : 1;
            },
          };
          if (at) view.handle = new draw.DragHandle(view.surface, at, { ...drawn, ...events });
          if (at) scene.add(view.handle);
          if (at) view.things.push(view.handle);
          render();
        },
        /** @type {[number[] | null, string]} */ ([end, entry]),
      );

    /** Where the handle is: as the surface has it, in the window, and the camera. */
    const where = () =>
      page.evaluate(() => {
        const { view } = /** @type {any} */ (window);
        view.render();
        const box = view.handle.element.getBoundingClientRect();
        return {
          point: /** @type {number[]} */ (view.handle.point),
          position: /** @type {number[]} */ (view.handle.position.toArray()),
          screen: /** @type {{ x: number, y: number }} */ (view.place(view.handle.position)),
          button: { x: box.x + box.width / 2, y: box.y + box.height / 2, size: box.width },
          camera: /** @type {number[]} */ (view.camera.position.toArray()),
          enabled: /** @type {boolean} */ (view.controls.enabled),
          calls: /** @type {Record<'start' | 'drag' | 'end' | 'off', number>} */ (view.calls),
        };
      });

    describe('a line', () => {
      /** The colours of the picture along a path, with what an independent ray says of each place. @param {number[]} eye @param {object} options */
      const along = (eye, options) =>
        page.evaluate(
          ([from, given]) => {
            const { view } = /** @type {any} */ (window);
            const { THREE, draw, surface, scene, camera, controls, renderer, render, mesh } = view;
            camera.position.set(...from);
            controls.update();
            const path = surface.trace([0.3, 0.4], [0.4, 1], 40, { points: 600 });
            const line = new draw.GeodesicLine(path, given);
            scene.add(line);
            view.things.push(line);
            render();
            const drawing = new OffscreenCanvas(640, 480).getContext('2d', { willReadFrequently: true });
            if (!drawing) throw new Error('no canvas');
            drawing.drawImage(renderer.domElement, 0, 0);
            const { data } = drawing.getImageData(0, 0, 640, 480);
            const normals = surface.evaluate(path.parameters);
            const raycaster = new THREE.Raycaster();
            const eyePoint = camera.position;
            return Array.from({ length: path.points.length / 3 }, (_, i) => {
              const point = new THREE.Vector3(...path.points.subarray(3 * i, 3 * i + 3));
              const direction = point.clone().sub(eyePoint);
              const distance = direction.length();
              raycaster.set(eyePoint, direction.normalize());
              const facing = -direction.dot(new THREE.Vector3(...normals.subarray(6 * i + 3, 6 * i + 6)));
              const hit = raycaster.intersectObject(mesh)[0]?.distance ?? Infinity;
              const { x, y } = view.place(point);
              const box = renderer.domElement.getBoundingClientRect();
              const at = 4 * (640 * Math.floor(y - box.top) + Math.floor(x - box.left));
              return { facing, before: distance - hit, colour: Array.from(data.subarray(at, at + 3)), x, y };
            });
          },
          /** @type {[number[], object]} */ ([eye, options]),
        );
      /** Whether the part of the line that is not hidden runs there too. @param {Awaited<ReturnType<typeof along>>} places @param {number} x @param {number} y */
      const isNearSeen = (places, x, y) => places.some((other) => other.before < 0.2 && Math.hypot(other.x - x, other.y - y) < 14);

      for (const eye of [
        [8, -12, 8],
        [14, 3, 5],
        [-4, -9, 14],
      ])
        test(`is seen wherever the surface does not hide it, from (${eye})`, async () => {
          await begin(null);
          const places = await along(eye, { colour: '#ff0000' });
          // The surface slopes up to 75 degrees there: what the lift promises.
          const open = places.filter(({ facing, before }) => facing > 0.26 && before < 0.05);
          const swallowed = open.filter(({ colour: [r, g, b] }) => !(r > 230 && g < 40 && b < 40));
          assert.ok(open.length > 120);
          assert.deepEqual(swallowed, []);
          await page.locator('#frame').screenshot({ path: `${SCREENSHOTS}three-line-${eye[0]}-${name}.png` });
        });

      test('is seen also where depths are logarithms, and so is a handle', async () => {
        const usual = page;
        ({ page } = await openPage(browser.context, `${site.address}/${name}-logarithmic`));
        await page.waitForFunction(() => /** @type {any} */ (window).view);
        await begin([0.3, 0.4]);
        const places = await along([8, -12, 8], { colour: '#ff0000' });
        const { screen } = await where();
        const frame = await page.locator('#frame').boundingBox();
        const clip = { x: screen.x - 8, y: screen.y - 8, width: 16, height: 16 };
        const ball = frame && (await measurePicture(page, await page.screenshot({ clip })));
        await page.close();
        page = usual;
        const open = places.filter(({ facing, before }) => facing > 0.26 && before < 0.05);
        const seen = open.filter(({ colour: [r, g] }) => r > 200 && g < 130);
        // The ball's ring covers some.
        assert.ok(seen.length > 0.97 * open.length, `${seen.length} of ${open.length}`);
        assert.ok(ball && ball.warm > 60, `${ball?.warm} pixels of the handle`);
      });

      test('is dashed and dimmer where the surface hides it', async () => {
        await begin(null);
        const places = await along([8, -12, 8], { colour: '#ff0000' });
        const behind = places.filter(({ before, x, y }) => before > 1 && !isNearSeen(places, x, y));
        assert.ok(behind.length > 60);
        assert.ok(
          behind.every(({ colour: [r, g, b] }) => !(r > 230 && g < 40 && b < 40)),
          'as bright as the line',
        );
        // Half transparent red over grey.
        const dashes = behind.map(({ colour: [r, g, b] }) => r - (g + b) / 2 > 40);
        const share = dashes.filter(Boolean).length / dashes.length;
        assert.ok(share > 0.45 && share < 0.75, `dashes cover ${(100 * share).toFixed(0)} %, not 60 %`);
        const changes = dashes.filter((dash, i) => i > 0 && dash !== dashes[i - 1]).length;
        assert.ok(changes > 12, `${changes} ends of dashes`);
      });

      test('is not drawn where it is hidden if asked so', async () => {
        await begin(null);
        const places = await along([8, -12, 8], { colour: '#ff0000', hidden: false });
        const behind = places.filter(({ before, x, y }) => before > 1 && !isNearSeen(places, x, y));
        assert.ok(behind.length > 60);
        assert.ok(behind.every(({ colour: [r, g, b] }) => r - (g + b) / 2 < 40));
      });

      test('has the width that was asked for at any distance', async () => {
        for (const distance of [12, 30]) {
          await begin(null);
          const rows = await page.evaluate((far) => {
            const { view } = /** @type {any} */ (window);
            const { draw, scene, camera, controls, renderer, render } = view;
            camera.position.set(0.01, 0, far);
            controls.update();
            const line = new draw.GeodesicLine([0, -4, 1.5, 0, 4, 1.5], { colour: '#ff0000', width: 8, halo: '#0000ff', haloWidth: 3 });
            scene.add(line);
            view.things.push(line);
            render();
            const drawing = new OffscreenCanvas(640, 480).getContext('2d', { willReadFrequently: true });
            drawing?.drawImage(renderer.domElement, 0, 0);
            const middle = Array.from(drawing?.getImageData(320, 0, 1, 480).data ?? []);
            const count = (/** @type {number[]} */ pixels, /** @type {number} */ channel) =>
              pixels.filter((x, i) => i % 4 === channel && x > 200 && pixels[i + 2 - 2 * channel] < 60).length;
            return [count(middle, 0), count(middle, 2)];
          }, distance);
          assert.ok(Math.abs(rows[0] - 8) <= 1 && Math.abs(rows[1] - 6) <= 2, `${rows} at ${distance}`);
        }
      });
    });

    describe('far from the origin of space', () => {
      /** A hilly square with a line, an end and a handle, its middle at some place; a picture is taken. @param {number[]} middle @param {string} picture */
      const hills = async (middle, picture) => {
        await page.evaluate(([a, b, c]) => {
          const { view } = /** @type {any} */ (window);
          const { THREE, draw, surfpath, scene, camera, controls, renderer, render, takePicture } = view;
          for (const thing of view.things ?? []) thing.dispose();
          scene.remove(view.mesh);
          const z = `${c} + 20*sin((x - ${a})/30)*cos((y - ${b})/40)`;
          const surface = surfpath.graph({ z, x: [a - 100, a + 100], y: [b - 100, b + 100] });
          const [from, to] = [
            [a - 80, b - 70],
            [a + 70, b + 80],
          ];
          const geometry = draw.surfaceGeometry(surface);
          const material = draw.surfaceMaterial(geometry);
          view.mesh = new THREE.Mesh(geometry, material);
          const line = new draw.GeodesicLine(surface.shortestPath(from, to));
          const marker = new draw.Marker();
          marker.position.fromArray(surface.evaluate(from));
          view.surface = surface;
          view.handle = new draw.DragHandle(surface, to, { camera, controls, domElement: renderer.domElement, mesh: view.mesh });
          view.things = [geometry, material, line, marker, view.handle];
          scene.add(view.mesh, line, marker, view.handle);
          controls.target.copy(draw.fitCamera(camera, geometry, [1, -2, 1.5]));
          controls.update();
          render();
          takePicture();
        }, middle);
        await page.locator('#frame').screenshot({ path: `${SCREENSHOTS}three-${picture}-${name}.png` });
      };
      const compare = () =>
        page.evaluate(() => /** @type {{ differ: number, lit: number }} */ (/** @type {any} */ (window).view.comparePictures()));
      /** As far as maps in metres are. */
      const AWAY = [500000, 4600000, 3000000];

      test('everything is drawn as it is at the origin', async () => {
        await hills([0, 0, 0], 'hills');
        await hills(AWAY, 'hills-away');
        const { differ, lit } = await compare();
        assert.ok(lit > 1e4, `${lit} pixels of the hills`);
        // Pixels of edges, where a hair decides.
        assert.ok(differ < 60, `${differ} pixels differ`);
      });

      test('instances stand where their matrices say, also turned ones', async () => {
        // Places that 32 bits hold, as those of instances are.
        const places = [
          [0, 0, 0],
          [524288, 4194304, 3145728],
        ];
        const turn = async (/** @type {number[]} */ middle) => {
          await hills(middle, 'instances');
          await page.evaluate(([a, b, c]) => {
            const { THREE, scene, mesh, render, pictures, takePicture } = /** @type {any} */ (window).view;
            const instances = new THREE.InstancedMesh(mesh.geometry, mesh.material, 1);
            const about = new THREE.Matrix4().makeTranslation(a, b, c);
            const turned = about
              .clone()
              .multiply(new THREE.Matrix4().makeRotationZ(Math.PI / 2))
              .multiply(about.clone().invert());
            instances.setMatrixAt(0, turned);
            scene.remove(mesh);
            scene.add(instances);
            render();
            pictures.pop();
            takePicture();
            scene.remove(instances);
            instances.dispose();
          }, middle);
        };
        for (const middle of places) await turn(middle);
        const { differ, lit } = await compare();
        // Their places in space have steps of a quarter.
        assert.ok(differ < 0.02 * lit, `${differ} pixels of ${lit} differ`);
      });

      test('a handle stays under the pointer, and on the surface', async () => {
        await hills(AWAY, 'hills-away');
        const drag = async () => {
          await page.evaluate(() => /** @type {any} */ (window).view.render());
          return page.evaluate(() => {
            const { handle, place } = /** @type {any} */ (window).view;
            return { ...place(handle.position), position: /** @type {number[]} */ (handle.position.toArray()) };
          });
        };
        const start = await drag();
        await page.mouse.move(start.x + 3, start.y - 2);
        await page.mouse.down();
        for (let i = 1; i <= 5; i++) {
          await page.mouse.move(start.x + 3 - 21 * i, start.y - 2 + 9 * i);
          const { x, y, position } = await drag();
          assert.ok(Math.hypot(x - start.x + 21 * i, y - start.y - 9 * i) < 0.5, `(${x}, ${y})`);
          const [across, along, up] = AWAY.map((x0, k) => position[k] - x0);
          assert.ok(Math.abs(up - 20 * Math.sin(across / 30) * Math.cos(along / 40)) < 1e-8);
        }
        await page.mouse.up();
        const before = await drag();
        await page.keyboard.press('ArrowLeft');
        const moved = await drag();
        assert.ok(before.x - moved.x > 3 && Math.abs(before.y - moved.y) < 3, `by ${moved.x - before.x}, ${moved.y - before.y}`);
      });

      after(() =>
        page.evaluate(() => {
          const { camera, controls } = /** @type {any} */ (window).view;
          controls.target.set(0, 0, 0);
          Object.assign(camera, { near: 1, far: 60 }).updateProjectionMatrix();
        }),
      );
    });

    describe('a handle', () => {
      test('follows the mouse on the surface, the controls off', async () => {
        await begin([5, 0.9]);
        const start = await where();
        assert.ok(Math.hypot(start.button.x - start.screen.x, start.button.y - start.screen.y) < 1);
        // Not in the middle: what was pressed stays under the pointer.
        await page.mouse.move(start.screen.x + 7, start.screen.y + 5);
        await page.mouse.down();
        for (let i = 1; i <= 8; i++) {
          await page.mouse.move(start.screen.x + 7 + 12 * i, start.screen.y + 5 + 6 * i);
          const now = await where();
          assert.ok(fromTorus(now.position) < 1e-12, `${fromTorus(now.position)} off the surface`);
          const gap = Math.hypot(now.screen.x - start.screen.x - 12 * i, now.screen.y - start.screen.y - 6 * i);
          assert.ok(gap < 1, `${gap} pixels from the pointer`);
          assert.equal(now.enabled, false);
        }
        await page.mouse.up();
        const end = await where();
        assert.deepEqual(end.camera, start.camera);
        assert.equal(end.enabled, true);
        assert.deepEqual([end.calls.start, end.calls.end, end.calls.off], [1, 1, end.calls.drag]);
        assert.ok(end.calls.drag >= 8);
        await page.mouse.move(start.screen.x, start.screen.y);
        assert.deepEqual((await where()).point, end.point);
      });

      test('follows it on a canvas that the page shows smaller than it is drawn', async () => {
        await page.evaluate(() =>
          Object.assign(/** @type {any} */ (document.getElementById('canvas')).style, { width: '50%', height: 'auto' }),
        );
        await begin([5, 0.9]);
        const start = await where();
        assert.ok(Math.hypot(start.button.x - start.screen.x, start.button.y - start.screen.y) < 1);
        await page.mouse.move(start.screen.x, start.screen.y);
        await page.mouse.down();
        await page.mouse.move(start.screen.x + 30, start.screen.y + 15, { steps: 3 });
        const end = await where();
        await page.mouse.up();
        assert.ok(Math.hypot(end.screen.x - start.screen.x - 30, end.screen.y - start.screen.y - 15) < 1);
        await page.evaluate(() => document.getElementById('canvas')?.removeAttribute('style'));
      });

      test('goes to the nearest place where the pointer leaves the surface', async () => {
        await begin([5.5, 0.2]);
        const start = await where();
        await page.mouse.move(start.screen.x, start.screen.y);
        await page.mouse.down();
        await page.mouse.move(start.screen.x + 40, start.screen.y + 60, { steps: 3 });
        await page.mouse.move(start.screen.x + 90, start.screen.y + 200, { steps: 4 });
        const outside = await where();
        await page.mouse.up();
        assert.ok(fromTorus(outside.position) < 1e-12);
        assert.ok(outside.calls.drag >= 7, `${outside.calls.drag}`);
        assert.ok(Math.hypot(outside.screen.x - start.screen.x, outside.screen.y - start.screen.y) > 30);
      });

      test('stays on its own side where it was hidden when it was pressed', async () => {
        await begin([1.57, 4.7]);
        const start = await where();
        await page.mouse.move(start.screen.x, start.screen.y);
        await page.mouse.down();
        await page.mouse.move(start.screen.x + 12, start.screen.y, { steps: 4 });
        await page.mouse.up();
        const end = await where();
        assert.ok(fromTorus(end.position) < 1e-12);
        const moved = Math.hypot(...end.position.map((x, k) => x - start.position[k]));
        assert.ok(moved > 0.05 && moved < 1, `it moved by ${moved}`);
      });

      test('follows a finger, and the page does not scroll', async () => {
        await begin([5, 0.9]);
        await page.evaluate(() => {
          document.body.style.height = '3000px';
        });
        const start = await where();
        const session = await page.context().newCDPSession(page);
        const touch = (/** @type {string} */ type, /** @type {{ x: number, y: number }[]} */ touchPoints) =>
          session.send('Input.dispatchTouchEvent', /** @type {any} */ ({ type, touchPoints }));
        const at = (/** @type {number} */ i) => [{ x: start.screen.x + 4 + 8 * i, y: start.screen.y - 3 + 9 * i }];
        await touch('touchStart', at(0));
        for (let i = 1; i <= 6; i++) await touch('touchMove', at(i));
        await nextFrame(page);
        const end = await where();
        assert.ok(fromTorus(end.position) < 1e-12);
        const gap = [end.screen.x - start.screen.x - 48, end.screen.y - start.screen.y - 54];
        assert.ok(Math.hypot(...gap) < 1.5, `${gap} pixels from the finger`);
        assert.equal(end.button.size, 44, 'for a finger');
        assert.equal(end.enabled, false);
        await touch('touchEnd', []);
        assert.equal((await where()).enabled, true);
        assert.equal(await page.evaluate(() => scrollY), 0);
        assert.deepEqual(end.camera, start.camera);
        await page.evaluate(() => {
          document.body.style.height = '';
        });
      });

      test('can be hit within 24 pixels, and beside it the view turns', async () => {
        await begin([5, 0.9]);
        const start = await where();
        assert.equal(start.button.size, 24);
        const hit = (/** @type {number} */ dx) =>
          page.evaluate(([x, y]) => document.elementFromPoint(x, y)?.getAttribute('aria-label'), [start.screen.x + dx, start.screen.y]);
        assert.deepEqual([await hit(-11), await hit(11), await hit(14)], ['Point A', 'Point A', null]);
        await page.mouse.move(start.screen.x + 30, start.screen.y + 30);
        await page.mouse.down();
        await page.mouse.move(start.screen.x + 80, start.screen.y + 30, { steps: 3 });
        await page.mouse.up();
        const end = await where();
        assert.deepEqual(end.point, start.point);
        assert.notDeepEqual(end.camera, start.camera);
        assert.ok(Math.hypot(end.button.x - end.screen.x, end.button.y - end.screen.y) < 1, 'the button came along');
      });

      test('moves by arrow keys as seen, and says when that ends', async () => {
        await begin([5, 0.9]);
        await page.keyboard.press('Tab');
        assert.equal(await page.evaluate(() => document.activeElement?.getAttribute('aria-label')), 'Point A');
        let last = await where();
        for (const [key, x, y] of /** @type {const} */ ([
          ['ArrowRight', 1, 0],
          ['ArrowUp', 0, -1],
          ['ArrowLeft', -1, 0],
          ['ArrowDown', 0, 1],
          ['Shift+ArrowLeft', -5, 0],
        ])) {
          await page.keyboard.press(key);
          const now = await where();
          const [dx, dy] = [now.screen.x - last.screen.x, now.screen.y - last.screen.y];
          assert.ok((dx * x + dy * y) / Math.hypot(x, y) > 3, `${key} moved it by (${dx}, ${dy})`);
          assert.ok(fromTorus(now.position) < 1e-12);
          last = now;
        }
        assert.deepEqual([last.calls.drag, last.calls.end], [5, 5]);
      });

      test('leaves controls alone that it has not switched off, and tells of no change before it is made', async () => {
        await begin([5, 0.9]);
        await page.evaluate(() => {
          /** @type {any} */ (window).view.controls.enabled = false;
        });
        await page.keyboard.press('Tab');
        await page.keyboard.press('ArrowRight');
        const { enabled, calls } = await where();
        assert.deepEqual([enabled, calls.end], [false, 1]);
        const told = await page.evaluate(() => {
          const { view } = /** @type {any} */ (window);
          view.controls.enabled = true;
          let changes = 0;
          const drawn = { camera: view.camera, domElement: view.renderer.domElement, radius: undefined, onChange: () => changes++ };
          const handle = new view.draw.DragHandle(view.surface, [1, 1], drawn);
          const before = changes;
          handle.setPoint([1, 2]);
          handle.dispose();
          return [before, changes];
        });
        assert.deepEqual(told, [0, 1]);
      });

      test('stays as it is where it cannot be put on another surface', async () => {
        await begin([5, 0.9]);
        const before = await where();
        const message = await page.evaluate(() => {
          const { view } = /** @type {any} */ (window);
          const dome = view.surfpath.graph({ z: 'sqrt(1 - x^2 - y^2)', x: [-1, 1], y: [-1, 1] });
          try {
            view.handle.setSurface(dome, [0.9, 0.9]);
            return '';
          } catch (error) {
            return String(error);
          }
        });
        assert.match(message, /^RangeError: DragHandle: the surface has no point at \[0.9,0.9\]/);
        await page.keyboard.press('Tab');
        await page.keyboard.press('ArrowRight');
        const after = await where();
        assert.notDeepEqual(after.point, before.point);
        assert.ok(fromTorus(after.position) < 1e-12);
      });

      test('is let go where it is put on another surface: what was pressed moves it no more, the controls are on', async () => {
        await begin([5, 0.9]);
        const { screen } = await where();
        await page.mouse.move(screen.x, screen.y);
        await page.mouse.down();
        await page.mouse.move(screen.x + 12, screen.y + 6);
        await page.evaluate(() => {
          const { view } = /** @type {any} */ (window);
          view.handle.setSurface(view.surfpath.surface({ ...view.gallery.parametricTorus }), [5, 0.8], view.mesh);
        });
        const put = await where();
        await page.mouse.move(screen.x + 40, screen.y + 20, { steps: 4 });
        await page.mouse.up();
        const after = await where();
        assert.deepEqual([after.point, after.calls.end, put.enabled], [[5, 0.8], 1, true]);
      });

      test('refuses a place that is none, and a line what is no number', async () => {
        await begin([0, 1]);
        const messages = await page.evaluate(() => {
          const { view } = /** @type {any} */ (window);
          const { draw, gallery, surfpath, camera, renderer } = view;
          const helicoid = surfpath.surface(gallery.helicoid);
          const told = [
            () => new draw.DragHandle(helicoid, [Number.NaN, 0], { camera, domElement: renderer.domElement }),
            () => new draw.GeodesicLine([0, 0, 0, NaN, 1, 1]),
            () => new draw.GeodesicLine(null, { haloWidth: -1 }),
            () => new draw.DragHandle(helicoid, [0, 0], { camera, domElement: renderer.domElement, step: '8' }),
            () => view.handle.setColours({ color: 'red' }),
            () => new draw.DragHandle(helicoid, [99, 0], { camera, domElement: renderer.domElement }),
            () => view.handle.setSurface(helicoid, [0, -99]),
            () => view.handle.setPoint([1, 2, 3]),
          ];
          return told.map((make) => {
            try {
              make();
              return '';
            } catch (error) {
              return String(error);
            }
          });
        });
        assert.match(messages[0], /^(Type|Range)Error: /);
        assert.match(messages[1], /^RangeError: GeodesicLine: path must hold finite numbers/);
        assert.match(messages[2], /^RangeError: GeodesicLine: options.haloWidth must be a number of pixels, 0 or more, not -1/);
        assert.match(messages[3], /^TypeError: DragHandle: options.step must be a number of pixels, 0 or more, not '8'/);
        assert.match(messages[4], /^TypeError: setColours: there is no option 'color'; the options are colour, ring/);
        assert.match(messages[5], /^RangeError: DragHandle: point: u = 99 lies outside its range, \[-/);
        assert.match(messages[6], /^RangeError: DragHandle: point: v = -99 lies outside its range, \[-/);
        assert.match(messages[7], /^TypeError: DragHandle: point must be two numbers, u v, not an array of 3/);
        assert.deepEqual((await where()).point, [0, 1], 'where it was');
        // What rounding adds to an end of the range, and any number of turns, is no reason.
        await page.evaluate(() => {
          const { view } = /** @type {any} */ (window);
          view.handle.setPoint([-99, 99]);
          view.handle.setSurface(view.surfpath.graph({ z: 0, x: [0, 3], y: [0, 3] }), [3 + 4e-13, -1e-13]);
        });
        assert.equal(await page.locator('.surfpath-handle').count(), 1, 'a handle that is refused leaves no button');
      });

      test("follows the mouse over a mesh of the reader's own, whatever its uv are", async () => {
        await begin([0.2, 0.1], 'saddle');
        await page.evaluate(() => {
          const { view } = /** @type {any} */ (window);
          const { THREE, surface, scene } = view;
          const { positions, parameters, indices } = surface.mesh({ resolution: 64 });
          const geometry = new THREE.BufferGeometry();
          geometry.setAttribute('position', new THREE.BufferAttribute(new Float32Array(positions), 3));
          // As an image would lie on it four times each way, upside down.
          const uv = Float32Array.from(parameters, (/** @type {number} */ x, /** @type {number} */ i) => 4 * (i % 2 ? 1 - x : x));
          geometry.setAttribute('uv', new THREE.BufferAttribute(uv, 2));
          geometry.setIndex(new THREE.BufferAttribute(indices, 1));
          view.own = new THREE.Mesh(geometry, new THREE.MeshNormalMaterial());
          scene.add(view.own);
          view.things.push(geometry);
          view.handle.setSurface(surface, undefined, view.own);
        });
        const { screen } = await where();
        await page.mouse.move(screen.x, screen.y);
        await page.mouse.down();
        await page.mouse.move(screen.x + 20, screen.y - 6, { steps: 4 });
        const now = await where();
        await page.mouse.up();
        assert.ok(Math.hypot(now.screen.x - screen.x - 20, now.screen.y - screen.y + 6) < 3, `it is at ${now.screen.x}, ${now.screen.y}`);
        await page.evaluate(() => {
          const { view } = /** @type {any} */ (window);
          view.scene.remove(view.own);
        });
      });

      test('has its button once its canvas has come into the page', async () => {
        await begin(null);
        const parents = await page.evaluate(() => {
          const { view } = /** @type {any} */ (window);
          const { THREE, draw, surface, camera, scene } = view;
          const renderer = new THREE.WebGLRenderer();
          renderer.setSize(64, 48);
          const handle = new draw.DragHandle(surface, [5, 0.9], { camera, domElement: renderer.domElement });
          scene.add(handle);
          const box = document.createElement('div');
          document.body.append(box);
          box.append(renderer.domElement);
          renderer.render(scene, camera);
          const parents = [handle.element.parentNode === box, handle.element.style.visibility];
          handle.dispose();
          renderer.dispose();
          box.remove();
          return parents;
        });
        assert.deepEqual(parents, [true, 'visible']);
      });

      test('stays on an implicit surface', async () => {
        await begin([3.55, 2.77, 1.4], 'torus');
        const start = await where();
        assert.ok(fromTorus(start.position) < 1e-12);
        await page.mouse.move(start.screen.x, start.screen.y);
        await page.mouse.down();
        await page.mouse.move(start.screen.x - 60, start.screen.y + 8, { steps: 5 });
        await page.mouse.up();
        const end = await where();
        assert.ok(fromTorus(end.position) < 1e-12);
        assert.ok(Math.hypot(end.screen.x - start.screen.x + 60, end.screen.y - start.screen.y - 8) < 1);
      });

      test('follows the mouse through a turned, scaled group and an orthographic camera', async () => {
        await begin(null);
        const start = await page.evaluate(() => {
          const { view } = /** @type {any} */ (window);
          const { THREE, draw, surface, scene, renderer, mesh } = view;
          const camera = new THREE.OrthographicCamera(-6, 6, 4.5, -4.5, 1, 60);
          camera.up.set(0, 0, 1);
          camera.position.set(8, -12, 8);
          camera.lookAt(0, 0, 0);
          const group = new THREE.Group();
          group.rotation.set(0.3, 0.2, 0.1);
          group.scale.setScalar(0.8);
          group.position.set(0.4, 0.2, 0.1);
          const handle = new draw.DragHandle(surface, [5, 0.9], { camera, domElement: renderer.domElement, mesh });
          const line = new draw.GeodesicLine(surface.trace([5, 0.9], [1, 0.3], 9), { colour: '#ff0000' });
          group.add(mesh, handle, line);
          scene.add(group);
          view.group = { camera, handle, place: () => handle.getWorldPosition(new THREE.Vector3()).project(camera) };
          view.things.push(handle, line, { dispose: () => scene.remove(group) });
          renderer.render(scene, camera);
          const box = handle.element.getBoundingClientRect();
          return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
        });
        await page.mouse.move(start.x, start.y);
        await page.mouse.down();
        await page.mouse.move(start.x + 50, start.y + 20, { steps: 4 });
        await page.mouse.up();
        const end = await page.evaluate(() => {
          const { group, renderer, scene } = /** @type {any} */ (window).view;
          renderer.render(scene, group.camera);
          const box = renderer.domElement.getBoundingClientRect();
          const { x, y } = group.place();
          return { x: box.x + 320 * (x + 1), y: box.y + 240 * (1 - y), position: group.handle.position.toArray() };
        });
        assert.ok(Math.hypot(end.x - start.x - 50, end.y - start.y - 20) < 1, `${end.x - start.x}, ${end.y - start.y}`);
        assert.ok(fromTorus(end.position) < 1e-12);
        const { warm } = await measurePicture(page, await page.locator('#frame').screenshot());
        assert.ok(warm > 300, `only ${warm} pixels of the line are seen`);
      });

      test('scrolls the view through its button, and hides it outside', async () => {
        await begin([5, 0.9]);
        const start = await where();
        await page.mouse.move(start.screen.x, start.screen.y);
        await page.mouse.wheel(0, -240);
        await page.waitForFunction(
          (was) => /** @type {any} */ (window).view.camera.position.length() < was - 0.1,
          Math.hypot(...start.camera),
        );
        await page.evaluate(() => {
          const { view } = /** @type {any} */ (window);
          view.camera.lookAt(100, 0, 0);
          view.render();
        });
        assert.equal(await page.evaluate(() => /** @type {any} */ (window).view.handle.element.style.visibility), 'hidden');
      });
    });

    test('no contour line is drawn where a large area lies on a level, and one beside it is', async () => {
      await begin(null);
      const rows = await page.evaluate(() => {
        const { THREE, draw, surfpath, scene, camera, renderer, mesh, render } = /** @type {any} */ (window).view;
        const surface = surfpath.graph({ z: 0, x: [-2, 2], y: [-1, 1] });
        // 1 on the left half, a level exactly, then a ramp to 3: eleven levels, a fifth apart.
        const colour = (/** @type {{ positions: Float64Array }} */ { positions }) =>
          Array.from({ length: positions.length / 3 }, (_, i) => 1 + Math.max(0, positions[3 * i]));
        const geometry = draw.surfaceGeometry(surface, { resolution: 40, colour });
        const material = draw.surfaceMaterial(geometry);
        const plane = new THREE.Mesh(geometry, material);
        scene.remove(mesh);
        scene.add(plane);
        camera.position.set(0, -0.01, 8);
        camera.lookAt(0, 0, 0);
        render();
        const canvas = Object.assign(document.createElement('canvas'), { width: 640, height: 480 });
        const drawing = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d'));
        drawing.drawImage(renderer.domElement, 0, 0);
        const { data } = drawing.getImageData(0, 230, 640, 1);
        scene.remove(plane);
        scene.add(mesh);
        for (const thing of [geometry, material]) thing.dispose();
        return Array.from({ length: 640 }, (_, i) => data[4 * i] + data[4 * i + 1] + data[4 * i + 2]);
      });
      const steps = (/** @type {number} */ from, /** @type {number} */ to) =>
        rows.slice(from, to).map((x, i) => Math.abs(x - rows[from + i + 1]));
      assert.ok(Math.max(...steps(140, 300)) < 12, 'the flat half is of one brightness');
      const lines = steps(330, 500).filter((step) => step > 40).length;
      assert.ok(lines >= 6, `the ramp has lines: ${lines} steps`);
    });

    test('forty surfaces, lines and handles leave nothing behind', async () => {
      await begin(null);
      const counts = await page.evaluate(() => {
        const { THREE, draw, surface, scene, camera, renderer, render } = /** @type {any} */ (window).view;
        const path = surface.shortestPath([1, 1], [3, 0.5]);
        const turn = () => {
          const geometry = draw.surfaceGeometry(surface, { resolution: 8, colour: 'curvature' });
          const material = draw.surfaceMaterial(geometry);
          const mesh = new THREE.Mesh(geometry, material);
          const line = new draw.GeodesicLine(path);
          const handle = new draw.DragHandle(surface, [1, 1], { camera, domElement: renderer.domElement });
          scene.add(mesh, line, handle);
          render();
          line.setPath([0, 0, 0, 1, 1, 1]);
          render();
          scene.remove(mesh);
          for (const thing of [geometry, material, line, handle]) thing.dispose();
        };
        const count = () => [
          renderer.info.memory.geometries,
          renderer.info.memory.textures,
          renderer.info.programs.length,
          scene.children.length,
          document.querySelectorAll('button').length,
        ];
        turn();
        render();
        const before = count();
        for (let i = 0; i < 40; i++) turn();
        render();
        // Waits until the graphics card has done all of it.
        renderer.getContext().finish();
        return [before, count()];
      });
      assert.deepEqual(counts[1], counts[0]);
    });

    test('the console stayed silent', () => {
      assert.deepEqual(complaints, []);
    });
  });

test('a bundler drops surfpath/three where nothing of it is used', async () => {
  const { build } = await import('esbuild');
  const root = fileURLToPath(new URL('../..', import.meta.url));
  const { outputFiles } = await build({
    stdin: { contents: "import './dist/three.js';", resolveDir: root },
    external: ['three', 'three/*'],
    bundle: true,
    format: 'esm',
    write: false,
    logLevel: 'error',
  });
  assert.doesNotMatch(outputFiles[0].text, /class|=>|import/);
});

test('the page of README.md draws its path, and moves it with its end', async () => {
  const readme = await readFile(new URL('../../README.md', import.meta.url), 'utf8');
  const html = [...readme.matchAll(/^```html\n(.*?)^```$/gms)].map(([, text]) => text).find((text) => text.includes('surfpath/three'));
  assert.ok(html);
  const served = await serveSite({ 'page.html': html });
  const browser = await openBrowser([], COARSE);
  try {
    const { page, complaints } = await openPage(browser.context, `${served.address}/page.html`);
    const length = () => page.title();
    await page.waitForFunction(() => /^\d/.test(document.title));
    await page.waitForSelector('.surfpath-handle');
    await page.waitForFunction(() => document.querySelector('button')?.style.visibility === 'visible');
    const before = await length();
    assert.match(before, /^8\.8\d/);
    const box = await page.locator('.surfpath-handle').boundingBox();
    assert.ok(box);
    await page.mouse.move(box.x + 12, box.y + 12);
    await page.mouse.down();
    await page.mouse.move(box.x + 40, box.y + 12, { steps: 4 });
    await page.mouse.up();
    await nextFrame(page);
    assert.notEqual(await length(), before);
    const { warm } = await measurePicture(page, await page.locator('canvas').screenshot());
    assert.ok(warm > 60, `only ${warm} pixels of the path are seen`);
    assert.deepEqual(complaints, []);
  } finally {
    await browser.close();
    await served.close();
  }
});
