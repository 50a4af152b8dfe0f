// What goes wrong before any mathematics: a method without its surface, a surface that is gone, a seam that does not close, a module that is not found.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { inspect } from 'node:util';
import { compileModule, load } from '../../web/index.js';
import { anything, refuses } from '../helpers/refuses.js';

const surfpath = await load();
const plane = () => surfpath.parametric({ x: 'u', y: 'v', z: 0, u: [0, 1], v: [0, 1] });

test('a method taken off its surface, or off the instance, says where it belongs', () => {
  const { shortestPath, mesh, set } = plane();
  refuses(() => shortestPath([0, 0], [1, 1]), TypeError, /^shortestPath belongs to a surface: call it as surface\.shortestPath, /);
  refuses(() => mesh.call(anything({})), TypeError, /^mesh belongs to a surface/);
  refuses(() => set({}), TypeError, /^set belongs to a surface/);
  const { graph } = surfpath;
  refuses(() => graph({ z: 0, x: [0, 1], y: [0, 1] }), TypeError, /^graph belongs to what load\(\) gives: call it as surfpath\.graph, /);
});

test('so does one that is called through a Proxy, as frameworks make them, and how to have none', () => {
  const [surface, instance] = [new Proxy(plane(), {}), new Proxy(surfpath, {})];
  const advice = ', not through a Proxy \\(in Vue: markRaw or shallowRef\\)$';
  for (const call of [() => surface.shortestPath([0, 0], [1, 1]), () => surface.kind, () => surface.dispose()])
    refuses(call, TypeError, new RegExp(`^(shortestPath|kind|dispose) belongs to a surface: call it as surface\\.\\w+${advice}`));
  for (const call of [() => instance.graph({ z: 0, x: [0, 1], y: [0, 1] }), () => instance.dispose()])
    refuses(call, TypeError, new RegExp(`^(graph|dispose) belongs to what load\\(\\) gives: call it as surfpath\\.\\w+${advice}`));
});

test('a disposed surface answers nothing any more', () => {
  const surface = plane();
  surface.dispose();
  surface.dispose();
  for (const name of /** @type {const} */ (['kind', 'parameters', 'domain']))
    refuses(() => surface[name], Error, new RegExp(`^${name}: this surface was disposed$`));
  refuses(() => surface.trace([0, 0], [1, 0], 1), Error, /^trace: this surface was disposed$/);
});

test('four numbers in place of two points: what is said is what a point looks like', () => {
  const surface = plane();
  const call = anything(surface);
  for (const ask of [() => call.shortestPath(0, 0, 1, 1), () => call.geodesics(0, 0, 1, 1)])
    refuses(ask, TypeError, /^(shortestPath|geodesics): from must be \[u, v\], not 0$/);
  surface.dispose();
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

test('a function in place of a value is told as one, not with its source', () => {
  const surface = plane();
  const secret = () => 'secret';
  refuses(
    () => surface.shortestPath([0, 0], [1, 1], { points: anything(secret) }),
    TypeError,
    /points must be a whole number .*, not a function$/,
  );
  refuses(() => surface.shortestPath(anything(secret), [1, 1]), TypeError, /from must be \[u, v\], not a function$/);
  refuses(() => surfpath.surface(anything({ kind: class Kind {} })), TypeError, /, not a function$/);
});

test('what is wrong first is told first; null is no set of parameters, and a word no start', () => {
  const surface = plane();
  refuses(() => surface.trace(anything(undefined), anything(undefined), 1), TypeError, /^trace: from must be \[u, v\]/);
  refuses(
    () => surfpath.graph(anything({ z: 0, x: [0, 1], y: [0, 1], parameters: null })),
    TypeError,
    /^graph: parameters must be .* null$/,
  );
  refuses(() => surface.shortestPath([0, 0], [1, 1], { start: anything('near') }), RangeError, /options\.start must be 'global'/);
});

test('points are told by the names of their definition', () => {
  const range = /** @type {[number, number]} */ ([0, 1]);
  const graph = surfpath.graph({ z: 0, x: range, y: range });
  refuses(() => graph.shortestPath([2, 0], [0, 0]), RangeError, /^shortestPath: from\[0\] = 2 lies outside the range of x, \[0, 1\]$/);
  refuses(() => graph.shortestPath([0, 0, 0], [0, 0]), RangeError, /^shortestPath: from must be \[x, y\], 2 numbers, not 3$/);
  refuses(() => graph.evaluate([1]), RangeError, /^evaluate: points must be a flat array of x y, 2 numbers a point/);
  const vase = surfpath.revolution({ r: 1, z: 't', t: range });
  refuses(() => vase.shortestPath([0, 2], [0, 0]), RangeError, /from\[1\] = 2 lies outside the range of t, /);
  const strip = surfpath.sweep({ profile: ['s', 0], path: ['t', 0, 0], s: range, t: range });
  refuses(() => strip.trace([-1, 0], [1, 0], 1), RangeError, /from\[0\] = -1 lies outside the range of s, /);
});

test('a Map of options or parameters would go unnoticed: it is refused', () => {
  const surface = surfpath.graph({ z: 'a', x: [0, 1], y: [0, 1], parameters: { a: 1 } });
  refuses(() => surface.set(anything(new Map([['a', 2]]))), TypeError, /^set: parameters must be .*, not an object of type Map$/);
  refuses(() => surface.mesh(anything(new Map([['resolution', 2]]))), TypeError, /^mesh: options must be .*, not an object of type Map$/);
});

test('a console shows instance, surface and error by their names, bundled or not', async () => {
  for (const entry of ['../../web/index.js', '../../dist/index.js']) {
    const { load, ExpressionError } = await import(entry);
    const instance = await load();
    const surface = instance.graph({ z: 0, x: [0, 1], y: [0, 1] });
    assert.deepEqual([inspect(instance), inspect(surface), ExpressionError.name], ['Surfpath {}', 'Surface {}', 'ExpressionError']);
  }
});

test('null is no resolution and no tolerance', () => {
  const surface = plane();
  refuses(
    () => surface.mesh({ resolution: anything(null) }),
    TypeError,
    /^mesh: options\.resolution must be a whole number from 1 to 256, not null$/,
  );
  refuses(
    () => surface.distanceField([0, 0], { resolution: anything(null) }),
    TypeError,
    /^distanceField: options\.resolution .*, not null$/,
  );
  refuses(
    () => surface.shortestPath([0, 0], [1, 1], { tolerance: anything(null) }),
    TypeError,
    /tolerance must be a number between .*, not null$/,
  );
});

test('load and compileModule complain in their own names', async () => {
  for (const [name, call] of Object.entries({ load, compileModule })) {
    await assert.rejects(call(anything({ bogus: 1 })), new RegExp(`^TypeError: ${name}: there is no option 'bogus'`));
    await assert.rejects(call({ wasm: new Uint8Array(4) }), new RegExp(`^TypeError: ${name}: options\\.wasm is not surfpath\\.wasm$`));
  }
});

test('a URL, a Response or a signal in place of options does not go unnoticed', async () => {
  for (const wasm of [new URL('file:///surfpath.wasm'), new Response('')])
    await assert.rejects(load(anything(wasm)), /^TypeError: load: there is no option '\w+'; the options are wasm$/);
  const surface = plane();
  refuses(() => surface.mesh(anything(new AbortController().signal)), TypeError, /^mesh: there is no option 'aborted'/);
  assert.equal(surface.mesh(Object.create({ resolution: 2 })).indices.length, 24, 'inherited options count');
  refuses(() => surface.mesh(Object.create({ reslution: 2 })), TypeError, /^mesh: there is no option 'reslution'/);
});

test('a path in place of a point or of points is no list, whatever its length', () => {
  const surface = plane();
  const path = surface.shortestPath([0, 0], [1, 1]);
  const none = { ...path, length: NaN };
  for (const wrong of [path, none]) {
    refuses(() => surface.shortestPath(anything(wrong), [1, 1]), TypeError, /^shortestPath: from must be \[u, v\], not an object$/);
    refuses(() => surface.evaluate(anything(wrong)), TypeError, /^evaluate: points must be a flat array of u v, .*, not an object$/);
    refuses(() => surface.lengths(anything(wrong)), TypeError, /^lengths: pairs must be a flat array of u v u v, .*, not an object$/);
  }
});

test('what is disposed in the middle of a call, by a getter, ends it', async () => {
  const gone = /^surfpath: this surface was disposed$/;
  /** @param {string} name @param {unknown} value @param {(surface: ReturnType<typeof plane>, options: any) => unknown} call */
  const ends = (name, value, call) => {
    const surface = plane();
    const get = () => {
      surface.dispose();
      return value;
    };
    refuses(() => call(surface, Object.defineProperty({}, name, { get, enumerable: true })), Error, gone);
  };
  ends('points', 8, (surface, options) => surface.shortestPath([0, 0], [1, 1], options));
  ends('start', 'straight', (surface, options) => surface.shortestPath([0, 0], [1, 1], options));
  ends('max', 2, (surface, options) => surface.geodesics([0, 0], [1, 1], options));
  ends('points', 8, (surface, options) => surface.lengths([0, 0, 1, 1], options));
  ends('points', 8, (surface, options) => surface.trace([0, 0], [1, 0], 1, options));
  ends('resolution', 8, (surface, options) => surface.mesh(options));
  ends('resolution', 8, (surface, options) => surface.distanceField([0, 0], options));
  ends('0', 0.5, (surface, point) => surface.project(Object.assign(point, { length: 3, 1: 0, 2: 0 })));
  ends('0', 0.5, (surface, point) => surface.evaluate(Object.assign(point, { length: 2, 1: 0 })));
  const graph = surfpath.graph({ z: 'k', x: [0, 1], y: [0, 1], parameters: { k: 1 } });
  const changed = {
    get k() {
      graph.dispose();
      return 2;
    },
  };
  refuses(() => graph.set(changed), Error, gone);

  const instance = await load();
  const definition = {
    get z() {
      instance.dispose();
      return 'x';
    },
    x: anything([0, 1]),
    y: anything([0, 1]),
  };
  refuses(() => instance.graph(definition), Error, /^graph: this instance was disposed$/);
});

test('a name of no use is out of range, what is no name is of the wrong type', () => {
  const surface = plane();
  const [from, to] = [
    [0, 0],
    [1, 1],
  ];
  for (const wrong of [1, null, {}]) {
    refuses(() => surface.shortestPath(from, to, { algorithm: anything(wrong) }), TypeError, /options\.algorithm must be 'elements', /);
    refuses(() => surfpath.surface(anything({ kind: wrong })), TypeError, /^surface: kind must be one of /);
  }
  refuses(() => surface.shortestPath(from, to, { algorithm: anything('fast') }), RangeError, /, not 'fast'$/);
  refuses(() => surfpath.surface(anything({ kind: 'ball' })), RangeError, /, not 'ball'$/);
});

test('a call that takes no via does not offer it', () => {
  const surface = plane();
  refuses(
    () => surface.geodesics([0, 0], [1, 1], anything({ via: [] })),
    TypeError,
    /^geodesics: there is no option 'via'; (?!.*via).*, max$/,
  );
  refuses(() => surface.shortestPath([0, 0], [1, 1], anything({ max: 1 })), TypeError, /no option 'max'; .*, via$/);
});

test('a module that is not there is told with who wanted it, and where', async () => {
  await assert.rejects(load({ wasm: anything(null) }), /^TypeError: load: options\.wasm must be a URL/);
  const nowhere = new URL('file:///nope.wasm');
  await assert.rejects(load({ wasm: nowhere }), /^Error: load: options\.wasm 'file:\/\/\/nope\.wasm' failed: ENOENT/);
  await assert.rejects(load({ wasm: new Response('', { status: 404 }) }), /^Error: load: options\.wasm answered 404; it should be/);
});
