// What goes wrong before any mathematics: a method without its surface, a surface that is gone, a seam that does not close, a module that is not found.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { load } from '../../web/index.js';
import { anything, refuses } from '../helpers/refuses.js';

const surfpath = await load();
const plane = () => surfpath.parametric({ x: 'u', y: 'v', z: 0, u: [0, 1], v: [0, 1] });

test('a method taken off its surface, or off the instance, says where it belongs', () => {
  const { shortestPath, mesh, set } = plane();
  refuses(() => shortestPath([0, 0], [1, 1]), TypeError, /^shortestPath belongs to a surface: call it as surface\.shortestPath$/);
  refuses(() => mesh.call(anything({})), TypeError, /^mesh belongs to a surface/);
  refuses(() => set({}), TypeError, /^set belongs to a surface/);
  const { graph } = surfpath;
  refuses(() => graph({ z: 0, x: [0, 1], y: [0, 1] }), TypeError, /^graph belongs to what load\(\) gives: call it as surfpath\.graph$/);
});

test('a disposed surface answers nothing any more', () => {
  const surface = plane();
  surface.dispose();
  surface.dispose();
  for (const name of /** @type {const} */ (['kind', 'parameters', 'domain']))
    refuses(() => surface[name], Error, new RegExp(`^${name}: this surface was disposed$`));
  refuses(() => surface.trace([0, 0], [1, 0], 1), Error, /^trace: this surface was disposed$/);
});

test('a direction that does not close is not periodic, and by how much it misses is said', () => {
  const arc = { x: 'cos(u)', y: 'sin(u)', z: 'v', u: anything([0, 'a']), v: anything([0, 1]), parameters: { a: 3 }, periodic: { u: true } };
  refuses(
    () => surfpath.parametric(arc),
    RangeError,
    /^parametric: periodic\.u: the surface does not close: it is 1\.99\d+ apart at the ends of u; leave u open/,
  );
  refuses(() => surfpath.parametric({ ...arc, parameters: { a: 6.283 } }), RangeError, /it is 0\.000185\d+ apart/);
  const ring = surfpath.parametric({ ...arc, parameters: { a: 2 * Math.PI } });
  assert.equal(ring.domain?.periodic.u, true);
  refuses(() => ring.set({ a: 5 }), RangeError, /^set: periodic\.u: the surface does not close/);
  assert.equal(ring.parameters.a, 2 * Math.PI, 'a set that is refused changes nothing');
  ring.dispose();
});

test('a relative path in Node.js has nothing to be relative to', async () => {
  await assert.rejects(
    load({ wasm: './surfpath.wasm' }),
    /^TypeError: load: options\.wasm '\.\/surfpath\.wasm' has no base here: pass new URL\(/,
  );
  const file = new URL('../../dist/surfpath.wasm', import.meta.url);
  for (const wasm of [file, file.href]) (await load({ wasm })).dispose();
});

test('a product with the number 0 is 0, whatever the other factor; with a parameter that is 0 it is not', () => {
  const [written, named] = ['0*sqrt(x)', 'k*sqrt(x)'].map((z) => surfpath.graph({ z, x: [-1, 1], y: [-1, 1], parameters: { k: 0 } }));
  assert.equal(written.evaluate([-0.5, 0])[2], 0);
  assert.equal(named.evaluate([-0.5, 0])[2], NaN);
  assert.ok(Math.abs(written.shortestPath([-0.5, 0], [0.5, 0]).length - 1) < 1e-14);
  assert.equal(named.shortestPath([-0.5, 0], [0.5, 0]).status, 'not-finite');
});
