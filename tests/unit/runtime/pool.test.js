// The pool: answers of the main thread to the bit, its exceptions, progress, settings, the end of it.
import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import { after, before, describe, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { promisify } from 'node:util';
import { gallery } from '../../../web/gallery.js';
import { ExpressionError, load } from '../../../web/index.js';
import { createPool } from '../../../web/pool.js';
import { randomPairs } from '../../bench/pairs.js';
import { createRandom } from '../../helpers/random.js';
import { anything } from '../../helpers/refuses.js';
import { alive, wait } from '../../helpers/workers.js';

const SEED = 41;
const run = promisify(execFile);

/** @type {import('../../../web/instance.js').Surfpath} */ let surfpath;
/** @type {import('../../../web/runtime/pool.js').Pool} */ let pool;
before(async () => {
  surfpath = await load();
  pool = createPool({ workers: 2 });
});
after(async () => {
  await pool.dispose();
  assert.equal(alive.size, 0);
  surfpath.dispose();
});

/** @type {Record<string, any>} */
const DEFINITIONS = {
  saddle: gallery.saddle,
  genus2: gallery.genus2,
  globe: gallery.globe,
  trefoil: gallery.trefoil,
  halfPlane: { kind: 'metric', E: '1/v^2', F: 0, G: '1/v^2', u: [-3, 3], v: [0.05, 5] },
  dense: { ...gallery.saddle, density: 2.5 },
  hindered: { ...gallery.saddle, density: '1 + a exp(-x^2)', parameters: { a: -0 } },
};

/** Pairs on a surface. @param {any} definition @param {number} count */
function choosePairs(definition, count) {
  const surface = surfpath.surface(definition);
  const pairs = randomPairs(surface, createRandom(SEED), count).flat(2);
  surface.dispose();
  return pairs;
}

for (const [name, definition] of Object.entries(DEFINITIONS))
  describe(`${name}: the bits of the main thread, seed ${SEED}`, () => {
    /** @type {any} */ let surface;
    /** @type {number[]} */ let pairs;
    before(() => {
      surface = surfpath.surface(definition);
      pairs = choosePairs(definition, 24);
    });
    after(() => surface.dispose());

    for (const options of [undefined, { start: /** @type {const} */ ('straight'), tolerance: 1e-6, points: 5 }])
      test(`lengths and shortestPaths, ${JSON.stringify(options) ?? 'defaults'}`, async () => {
        const paths = surface.shortestPaths(pairs, options);
        const [lengths, found] = await Promise.all([
          pool.lengths(definition, pairs, options),
          pool.shortestPaths(definition, Float64Array.from(pairs), options),
        ]);
        assert.deepEqual(found, paths);
        assert.deepEqual(
          lengths,
          Float64Array.from(paths, ({ length }) => length),
        );
      });

    test('shortestPath and geodesics', async () => {
      const width = definition.kind === 'implicit' ? 3 : 2;
      const [from, to] = [pairs.slice(0, width), pairs.slice(width, 2 * width)];
      const path = surface.shortestPath(from, to);
      assert.deepEqual(await pool.shortestPath(definition, from, to), path);
      assert.deepEqual(await pool.shortestPath(definition, from, to, { start: path }), surface.shortestPath(from, to, { start: path }));
      if (definition.kind !== 'metric')
        assert.deepEqual(await pool.geodesics(definition, from, to, { max: 3 }), surface.geodesics(from, to, { max: 3 }));
    });
  });

test('distanceField is that of the main thread', async () => {
  const surface = surfpath.surface(gallery.globe);
  const options = { resolution: 12 };
  assert.deepEqual(await pool.distanceField(gallery.globe, [0.3, 0.2], options), surface.distanceField([0.3, 0.2], options));
  surface.dispose();
});

test('other parameters are another surface; a definition that is changed afterwards is not', async () => {
  const definition = {
    ...gallery.parametricTorus,
    parameters: { R: 3, a: 1 },
    x: '(R + a cos(v)) cos(u)',
    y: '(R + a cos(v)) sin(u)',
    z: 'a sin(v)',
  };
  const pairs = new Float64Array([0.5, 0.6, 2.6, 1.2]);
  const alone = [3, 4].map((R) => {
    const surface = surfpath.surface({ ...definition, parameters: { R, a: 1 } });
    const [length] = surface.lengths(pairs);
    surface.dispose();
    return length;
  });
  const first = pool.lengths(definition, pairs);
  definition.parameters.R = 4;
  const second = pool.lengths(definition, pairs);
  pairs.fill(0);
  assert.deepEqual([(await first)[0], (await second)[0]], alone);
});

test('ranges may be arrays of any type, as on the main thread', async () => {
  const unit = anything(new Float32Array([0, 1]));
  assert.equal((await pool.shortestPath({ kind: 'graph', z: 0, x: unit, y: unit }, [0, 0], [1, 0])).status, 'converged');
});

test('many surfaces in turn', async () => {
  const wanted = Array.from({ length: 12 }, (_, i) => i);
  const lengths = await Promise.all(
    wanted.map((z) => pool.lengths({ kind: 'parametric', x: 'u', y: `${z}*v`, z, u: [0, 1], v: [0, 1] }, [0, 0, 0, 1])),
  );
  for (const i of wanted.slice(1)) assert.ok(Math.abs(lengths[i][0] - i) < 1e-9 * i, `${lengths[i][0]} is not ${i}`);
});

test('bad pairs are bad in themselves; no pairs give nothing', async () => {
  const pairs = [0, 0, 0.5, 0.5, Number.NaN, 0, 0.5, 0.5, 0, 0, 1.5, 0, 0.1, 0.2, 0.3, 0.4];
  const paths = await pool.shortestPaths(gallery.saddle, pairs);
  assert.deepEqual(
    paths.map(({ status }) => status),
    ['converged', 'not-finite', 'off-surface', 'converged'],
  );
  assert.deepEqual(
    Array.from(await pool.lengths(gallery.saddle, pairs)),
    paths.map(({ length }) => length),
  );
  assert.deepEqual(await pool.lengths(gallery.saddle, []), new Float64Array(0));
  assert.deepEqual(await pool.shortestPaths(gallery.saddle, new Float64Array(0)), []);
});

test('progress rises to the whole, in whole pairs, and stops there', async () => {
  const pairs = choosePairs(gallery.saddle, 3000);
  /** @type {{ done: number, total: number }[]} */ const said = [];
  const onProgress = (/** @type {{ done: number, total: number }} */ progress) => said.push(progress);
  await pool.lengths(gallery.saddle, pairs, { start: 'straight', onProgress });
  const count = said.length;
  assert.ok(count > 3, `${count} reports`);
  assert.deepEqual(said.at(-1), { done: 3000, total: 3000 });
  for (let i = 1; i < count; i++) assert.ok(said[i].done > said[i - 1].done && said[i].total === 3000);
  await wait(20);
  assert.equal(said.length, count);
});

test('an exception of onProgress is that of the call', async () => {
  const mistake = new Error('mine');
  const onProgress = () => {
    throw mistake;
  };
  await assert.rejects(pool.lengths(gallery.saddle, [0, 0, 1, 1], { onProgress }), mistake);
});

test('a question is answered while a batch is under way', async () => {
  const one = createPool({ workers: 1 });
  let done = 0;
  const batch = one.lengths(gallery.saddle, choosePairs(gallery.saddle, 4000), {
    onProgress(progress) {
      done = progress.done;
    },
  });
  await one.shortestPath(gallery.saddle, [0, 0], [0.5, 0.5]);
  assert.ok(done < 2000, `${done} of 4000 pairs were solved first`);
  await Promise.all([assert.rejects(batch, /this pool was disposed/), one.dispose()]);
});

test('what `await using` calls ends the workers', async () => {
  const one = createPool({ workers: 1 });
  await one.lengths(gallery.saddle, [0, 0, 1, 1]);
  await one[Symbol.asyncDispose]();
  await assert.rejects(one.lengths(gallery.saddle, [0, 0, 1, 1]), /this pool was disposed/);
});

describe('the exceptions of the main thread', () => {
  const cyclic = /** @type {any} */ ({ ...gallery.saddle });
  cyclic.parameters = { cyclic };
  const saddle = gallery.saddle;
  /** @type {any[]} */
  const definitions = [
    { ...saddle, z: 'sin u' },
    { ...saddle, z: 'u +' },
    { ...saddle, u: ['0', 'q'] },
    { ...saddle, u: [0, Number.NaN] },
    { ...saddle, u: [0, Infinity] },
    { ...saddle, u: [0, undefined] },
    { ...saddle, u: undefined },
    { ...saddle, x: () => 0 },
    { ...saddle, x: Symbol('x') },
    { ...saddle, x: 1n },
    { ...saddle, parameters: { a: 'b' } },
    { ...saddle, parameters: new Map([['a', 1]]) },
    { ...saddle, kind: 'sphere' },
    { kind: 'implicit', f: 'x^2 + y^2 = 1' },
    { kind: 'tube', centreline: ['t', 0], radius: 1, t: [0, 1] },
    cyclic,
    null,
    undefined,
    'saddle',
  ];
  for (const [i, definition] of definitions.entries())
    test(`definition ${i}`, async () => {
      /** @type {any} */ let expected;
      assert.throws(
        () => surfpath.surface(definition),
        (error) => {
          expected = error;
          return true;
        },
      );
      for (const pairs of [[], [0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0]])
        await assert.rejects(pool.lengths(definition, pairs), (/** @type {any} */ error) => {
          assert.deepEqual(error, expected);
          assert.equal(error.constructor, expected.constructor);
          if (expected instanceof ExpressionError)
            assert.deepEqual([error.source, error.index, error.argument], [expected.source, expected.index, expected.argument]);
          return true;
        });
    });

  for (const [i, [method, ...given]] of /** @type {[string, ...any][]} */ ([
    ['lengths', [0, 0, 1]],
    ['lengths', ['0', 0, 1, 1]],
    ['lengths', null],
    ['shortestPaths', [0, 0, 1, 1], { via: [[0, 0]] }],
    ['lengths', [0, 0, 1, 1], { tolerance: 1 }],
    ['lengths', [0, 0, 1, 1], { tolerance: () => 1 }],
    ['lengths', [0, 0, 1, 1], { exact: true }],
    ['lengths', [0, 0, 1, 1], 5],
    ['lengths', [0, 0, 1, 1], null],
    ['shortestPath', [0, 0], [2, 0]],
    ['shortestPath', [0, 0], [Number.NaN, 0]],
    ['shortestPath', [0, 0], [0, 0], { start: () => 0 }],
    ['shortestPath', [0, 0], [0, 0], { onProgress: () => 0 }],
    ['shortestPath', [0, 0], () => 0],
    ['geodesics', [0, 0], [0, 1], { max: 0 }],
    ['distanceField', [0, 0], { resolution: 1000 }],
    ['distanceField', [0, 0], { exact: true, onProgress: () => 0 }],
    ['distanceField', [0, 0], { speed: 1 }],
  ]).entries())
    test(`arguments ${i}, of ${method}`, async () => {
      const surface = /** @type {any} */ (surfpath.surface(saddle));
      /** @type {any} */ let expected;
      assert.throws(
        () => surface[method](...given),
        (error) => {
          expected = error;
          return true;
        },
      );
      const own = method === 'lengths' || method === 'shortestPaths' ? ', signal, onProgress' : ', signal';
      expected.message = expected.message.replace(/; the options are .*$/, `$&${own}`);
      await assert.rejects(anything(pool)[method](saddle, ...given), (error) => {
        assert.deepEqual(error, expected);
        return true;
      });
      surface.dispose();
    });
});

/** As frameworks watch data: all of it through Proxies. @template T @param {T} data @returns {T} */
const watched = (data) =>
  data && typeof data === 'object' && !ArrayBuffer.isView(data)
    ? new Proxy(data, { get: (target, name, receiver) => watched(Reflect.get(target, name, receiver)) })
    : data;

test('what a framework watches through Proxies is asked of the workers, not answered by the page; a Proxy of the pool says what it is', async () => {
  const { from, to, ...definition } = structuredClone(gallery.saddle);
  const earlier = await pool.shortestPath(definition, from, to, { points: 5 });
  const asked = { via: [[0.1, 0.2]] };
  const nowhere = createPool({ workers: 1, worker: new URL('./nowhere.js', import.meta.url) });
  for (const options of [undefined, asked, { start: earlier }]) {
    const question = /** @type {Parameters<typeof pool.shortestPath>} */ ([definition, from, to, options]);
    const seen = /** @type {typeof question} */ (question.map(watched));
    assert.deepEqual(await pool.shortestPath(...seen), await pool.shortestPath(...question));
    await assert.rejects(nowhere.shortestPath(...seen), /no worker can be started/);
  }
  assert.deepEqual(await pool.lengths(definition, watched([...from, ...to])), await pool.lengths(definition, [...from, ...to]));
  await nowhere.dispose();
  for (const call of [() => watched(pool).shortestPath(definition, from, to), () => watched(pool).dispose()])
    await assert.rejects(
      call,
      /^TypeError: (shortestPath|dispose) belongs to a pool: .*, not through a Proxy \(in Vue: markRaw or shallowRef\)$/,
    );
});

test('a definition that has a mistake says so whatever its pairs', async () => {
  const f = 'x^2 + y^2 + z^2 - 1';
  for (const [definition, said] of [
    [{ f }, /^TypeError: surface: kind must be one of parametric, .*, not undefined$/],
    [{ kind: 'Implicit', f }, /^RangeError: surface: kind must be one of .*, not 'Implicit'$/],
    [{ kind: 'implicit', f }, /^RangeError: lengths: pairs must be a flat array of x y z x y z, 6 numbers a pair, not 5 numbers$/],
  ])
    await assert.rejects(pool.lengths(anything(definition), [1, 0, 0, 0, 1]), anything(said));
});

test('settings, signals and listeners are checked', async () => {
  assert.throws(() => createPool(anything(5)), /createPool: options must be an object, not 5/);
  assert.throws(() => createPool(anything({ threads: 2 })), /there is no option 'threads'; the options are workers, worker/);
  for (const worker of [5, '', 'not a URL', null])
    assert.throws(() => createPool(anything({ worker })), { name: 'TypeError', message: /^createPool: options.worker must be the URL/ });
  assert.throws(() => createPool({ worker: './worker.js' }), /of a path make one with new URL\('\.\/worker\.js', import\.meta\.url\)/);
  const surface = surfpath.surface(gallery.saddle);
  for (const given of [[], new Map([['tolerance', 0.1]])])
    await assert.rejects(pool.lengths(gallery.saddle, [0, 0, 1, 1], anything(given)), /lengths: options must be an object, not an /);
  await assert.rejects(pool.lengths(anything(surface), []), /lengths: .* pass the definition, not a Surface/);
  surface.dispose();
  const { lengths, shortestPath } = pool;
  await assert.rejects(lengths(gallery.saddle, []), /^TypeError: lengths belongs to a pool: call it as pool\.lengths, /);
  await assert.rejects(shortestPath(gallery.saddle, [0, 0], [1, 0]), /^TypeError: shortestPath belongs to a pool/);
  for (const workers of [0, 1.5, 257, Number.NaN]) assert.throws(() => createPool({ workers }), RangeError);
  await assert.rejects(pool.lengths(gallery.saddle, [], { signal: anything(1) }), /lengths: options.signal must be an AbortSignal, not 1/);
  await assert.rejects(
    pool.lengths(gallery.saddle, [], { onProgress: anything(1) }),
    /lengths: options.onProgress must be a function, not 1/,
  );
});

test('after dispose, calls reject, and so do those under way; disposing again does nothing', async () => {
  const short = createPool({ workers: 1 });
  const waiting = [short.lengths(gallery.saddle, [0, 0, 1, 1]), short.shortestPath(gallery.saddle, [0, 0], [1, 1])];
  const refused = Promise.all(waiting.map((call) => assert.rejects(call, /this pool was disposed/)));
  await short.dispose();
  await refused;
  const methods = Object.getOwnPropertyNames(Object.getPrototypeOf(short)).filter((name) => !['constructor', 'dispose'].includes(name));
  assert.ok(methods.length >= 5, methods.join());
  for (const name of methods)
    for (const given of [[], [gallery.saddle, [], []]])
      await assert.rejects(anything(short)[name](...given), { message: `${name}: this pool was disposed` });
  await short.dispose();
});

describe('a program', () => {
  const address = JSON.stringify(new URL('../../../web/pool.js', import.meta.url));
  const start = `import { createPool } from ${address}; const pool = createPool({ workers: 2 });
    const plane = { kind: 'parametric', x: 'u', y: 'v', z: 0, u: [0, 1], v: [0, 1] };`;
  const play = async (/** @type {string} */ program) =>
    (await run(process.execPath, ['--input-type=module', '-e', start + program], { timeout: 60000 })).stdout;

  test('ends by itself, though its idle pool was not disposed', async () => {
    assert.equal(await play('console.log((await pool.lengths(plane, [0, 0, 0, 1]))[0].toFixed(9));'), '1.000000000\n');
  });

  test('has threads also where a test has made a page of it, as jsdom does', async () => {
    const program = `globalThis.document = {}; const { createPool } = await import(${address}); const pool = createPool({ workers: 2 });`;
    const rest = "console.log((await pool.lengths({ kind: 'graph', z: 0, x: [0, 1], y: [0, 1] }, [0, 0, 0, 1]))[0].toFixed(9));";
    assert.equal((await run(process.execPath, ['--input-type=module', '-e', program + rest], { timeout: 60000 })).stdout, '1.000000000\n');
  });

  test('waits for what is under way', async () => {
    assert.equal(await play('pool.lengths(plane, [0, 0, 0, 1]).then(([length]) => console.log(length.toFixed(9)));'), '1.000000000\n');
  });

  test('ends while a worker is still busy with what was aborted', async () => {
    const from = '{ kind: "implicit", f: "x^2+y^2+z^2-1", bounds: [[-2,2],[-2,2],[-2,2]] }, [1, 0, 0]';
    const said = await play(
      `pool.distanceField(${from}, { exact: true, signal: AbortSignal.timeout(300) }).catch(({ name }) => console.log(name));`,
    );
    assert.equal(said, 'TimeoutError\n');
  });

  test('runs in a file that was bundled elsewhere, told where the worker is', async () => {
    const worker = fileURLToPath(new URL('../../../dist/worker.js', import.meta.url));
    const program = `const there = createPool({ workers: 1, worker: ${JSON.stringify(new URL(`file://${worker}`))} });
      console.log((await there.lengths(plane, [0, 0, 0, 1]))[0].toFixed(9));`;
    assert.equal(await play(program), '1.000000000\n');
  });
});

test('options and definitions have the fields that they inherit, as on the main thread; what cannot be posted is named', async () => {
  const inherited = Object.create(gallery.saddle);
  const surface = surfpath.surface(inherited);
  const options = Object.create({ points: 5, start: 'straight' });
  const [from, to] = [[...gallery.saddle.from], [...gallery.saddle.to]];
  assert.deepEqual(await pool.shortestPath(inherited, from, to, options), surface.shortestPath(from, to, options));
  surface.dispose();
  await assert.rejects(
    pool.shortestPath(gallery.saddle, from, to, Object.create({ tolerance: 7 })),
    /^RangeError: shortestPath: options.tolerance/,
  );
  /** @type {Record<string, unknown>} */
  const cyclic = {};
  cyclic.itself = cyclic;
  for (const big of [1n, [1n], cyclic, () => 1, new Map()])
    await assert.rejects(pool.shortestPath(anything({ ...gallery.saddle, big }), from, to), {
      name: 'TypeError',
      message: "the definition's big cannot be posted to a worker; leave it out",
    });
});
