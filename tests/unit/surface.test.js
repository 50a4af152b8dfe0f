// The methods of a surface as a stranger would use and misuse them.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { gallery } from '../../web/gallery.js';
import { load } from '../../web/index.js';
import { createRandom } from '../helpers/random.js';
import { ofAll } from '../helpers/sample.js';
import { allClose, anything, assertNoPath, close, refuses } from '../helpers/refuses.js';

const surfpath = await load();
const saddle = surfpath.surface(gallery.saddle);
const sphere = surfpath.surface(gallery.sphere);
const ring = surfpath.surface(gallery.parametricTorus);

describe('ends', () => {
  /** @type {[string, unknown, Function, RegExp][]} */
  const bad = [
    ['nothing', undefined, TypeError, /shortestPath: from must be \[u, v\], not undefined/],
    ['text', 'ab', TypeError, /from must be \[u, v\], not 'ab'/],
    ['a number', 3, TypeError, /from must be \[u, v\]/],
    ['three numbers', [0, 0, 0], RangeError, /from must be \[u, v\], 2 numbers, not 3/],
    ['NaN', [NaN, 0], RangeError, /from\[0\] must be a finite number, not NaN/],
    ['Infinity', [0, -Infinity], RangeError, /from\[1\] must be a finite number, not -Infinity/],
    ['numbers as text', ['0', '0'], TypeError, /from\[0\] must be a finite number, not '0'/],
    ['a point outside the range of u', [1.5, 0], RangeError, /from\[0\] = 1.5 lies outside the range of u, \[-1, 1\]/],
    ['a point outside the range of v', [0, -2], RangeError, /from\[1\] = -2 lies outside the range of v/],
  ];
  for (const [what, point, kind, message] of bad)
    test(`shortestPath refuses ${what}`, () => refuses(() => saddle.shortestPath(anything(point), [0, 0]), kind, message));

  test('the second end is checked too, and three numbers are wanted of an implicit surface', () => {
    refuses(() => saddle.shortestPath([0, 0], [0, 9]), RangeError, /to\[1\] = 9 lies outside/);
    refuses(() => sphere.shortestPath([1, 0, 0], [0, 1]), RangeError, /to must be \[x, y, z\], 3 numbers, not 2/);
  });

  test('an end outside by rounding alone is moved onto the edge', () => {
    const path = saddle.shortestPath([1 + 1e-13, 0], [0, 0]);
    assert.equal(path.parameters?.[0], 1);
  });

  test('typed arrays are taken', () => {
    assert.deepEqual(saddle.shortestPath(new Float64Array([0, 0]), new Float32Array([0.5, 0.5])), saddle.shortestPath([0, 0], [0.5, 0.5]));
  });

  test('equal ends give a path of length 0', () => {
    for (const path of [saddle.shortestPath([0.1, 0.2], [0.1, 0.2]), sphere.shortestPath([0, 1, 0], [0, 1, 0])]) {
      assert.deepEqual([path.status, path.converged, path.length, path.lengthError, path.index], ['converged', true, 0, 0, 0]);
      assert.deepEqual(Array.from(path.points.subarray(0, 3)), Array.from(path.points.subarray(-3)));
    }
  });

  test('and tell of the edge that they lie on', () => {
    assert.ok(saddle.shortestPath([1, 0], [1, 0]).touchesBoundary);
    assert.ok(!saddle.shortestPath([0, 0], [0, 0]).touchesBoundary);
    assert.equal(saddle.shortestPath([1, 0], [1, 0], { record: true }).history.length, 1);
  });

  test('so they do wherever they lie, inside bounds and through points on the way, and it is one of the geodesics, once', () => {
    const knot = { kind: 'implicit', f: '(x*(x-1)^2*(x-2)+y^2)^2+z^2-0.01', bounds: Array.from('xyz', () => [-2.3, 2.3]) };
    for (const definition of /** @type {any[]} */ ([knot, gallery.torus, gallery.globe])) {
      const surface = surfpath.surface(definition);
      const { positions, parameters } = surface.mesh({ resolution: 9 });
      const places = parameters ?? positions;
      const width = surface.domain ? 2 : 3;
      for (let i = 0; i < places.length - width; i += ofAll(63, 7) * width) {
        const [a, b] = [places.subarray(i, i + width), places.subarray(places.length - width)];
        const path = surface.shortestPath(a, a);
        assert.deepEqual([path.status, path.length, path.lengthError], ['converged', 0, 0], `vertex ${i / width}`);
        assert.ok(path.points.length === 3 * 66 && path.points.every((x, k) => x === path.points[k % 3]));
        const [first, ...others] = surface.geodesics(a, a, { max: 3 });
        assert.ok(first.length === 0 && others.every(({ length }) => length > 0.1), `vertex ${i / width}`);
        assert.equal(surface.shortestPath(a, b, { via: [a] }).status, surface.shortestPath(a, b).status, `vertex ${i / width}`);
      }
      surface.dispose();
    }
  });

  test('ends so near that points between them would be rounding are as far apart as they are, at once, seed 23', () => {
    const random = createRandom(23);
    const knot = { kind: 'implicit', f: '(x*(x-1)^2*(x-2)+y^2)^2+z^2-0.01', bounds: Array.from('xyz', () => [-2.3, 2.3]) };
    for (const definition of /** @type {any[]} */ ([
      knot,
      gallery.torus,
      gallery.parametricTorus,
      gallery.saddle,
      { ...gallery.saddle, density: '1 + u^2' },
    ])) {
      const surface = surfpath.surface(definition);
      const { positions, parameters } = surface.mesh({ resolution: 9 });
      const places = parameters ?? positions;
      const width = surface.domain ? 2 : 3;
      for (let i = 0; i < ofAll(3, 20); i++) {
        const at = width * random.integer(places.length / width);
        const a = Array.from(places.subarray(at, at + width));
        const b = a.map((x) => x + 10 ** random.between(-17, -12) * random.between(-1, 1));
        if (surface.domain)
          for (const [j, [low, high]] of [surface.domain.u, surface.domain.v].entries()) b[j] = Math.min(Math.max(b[j], low), high);
        const path = surface.shortestPath(a, b, { points: 2 + (i % 2), record: i % 3 === 0 });
        const back = surface.shortestPath(b, a, { points: 2 + (i % 2) });
        const { points, length, lengthError } = path;
        const count = points.length / 3;
        const straight = Math.sqrt([0, 1, 2].reduce((sum, k) => sum + (points[3 * count - 3 + k] - points[k]) ** 2, 0));
        const name = `${a} ${b}: ${path.status} ${length}`;
        assert.ok(path.converged && back.length === length && count === 4 + (i % 2), name);
        assert.ok(!definition.density && !definition.metric ? Math.abs(length - straight) <= lengthError : length < 1e-9, name);
        for (const entry of path.history) assert.ok(!entry.points || entry.points.length === points.length, name);
        const start = surface.shortestPath(
          a,
          a.map((x) => x * 0.999),
        );
        assert.ok(surface.shortestPath(a, b, { start, points: 2 + (i % 2) }).length <= 1.01 * length + lengthError, name);
        assert.ok(surface.geodesics(a, b, { max: 3 }).filter((one) => one.length < 0.01).length === 1, name);
      }
      surface.dispose();
    }
    const once = ring.shortestPath([0, 0.5], [2 * Math.PI, 0.5]);
    assert.ok(once.converged && once.length < 1e-14);
    assert.ok(saddle.shortestPath([0.1 + 0.2, 0], [0.3, 0]).converged);
  });

  test('ends near beside the coordinates, between which the surface curves: the whole way, to as many digits as the coordinates carry', () => {
    const radius = 1e-6;
    const solved = /** @type {[any, number[], number[], number][]} */ ([
      [{ kind: 'graph', z: 'sin(x)', x: [-1e10, 1e10], y: [-1, 1] }, [0, 0], [5, 0], 6.02176183182551],
      [{ kind: 'metric', E: '2+sin(3u)', F: 0, G: 1, u: [-1e9, 1e9], v: [-1, 1] }, [0, 0], [2, 0], 2.7838992780331204],
      [
        { kind: 'implicit', f: `(x-1000)^2+y^2+z^2-${radius ** 2}` },
        [1000, radius, 0],
        [1000, radius * Math.cos(1.5), radius * Math.sin(1.5)],
        1.5 * radius,
      ],
      [
        { kind: 'implicit', f: '(x-500000)^2+(y-5400000)^2+(z-300)^2-1e-6' },
        [500000.001, 5400000, 300],
        [500000, 5400000, 300.001],
        (1e-3 * Math.PI) / 2,
      ],
    ]).map(([definition, from, to, length]) => {
      const surface = surfpath.surface(definition);
      const path = surface.shortestPath(from, to);
      surface.dispose();
      return { path, length };
    });
    for (const { path, length } of solved) {
      assert.ok(
        path.converged && Math.abs(path.length - length) <= path.lengthError + 1e-14,
        `${path.length} +- ${path.lengthError}, not ${length}`,
      );
      const [places, width] = path.parameters ? [path.parameters, 2] : [path.points, 3];
      assert.equal(new Set(Array.from({ length: 66 }, (_, i) => places.slice(width * i, width * (i + 1)).join())).size, 66);
      assert.ok(path.lengthError <= 1e-5 * length, `${path.lengthError}`);
    }
  });

  test('ends beside an implicit surface are joined by its graph, where the straight line leads nowhere', () => {
    const sides = /** @type {const} */ ([-1.2, 1.2]);
    const quartic = surfpath.implicit({ f: '(x^2+y^2+z^2)^2 - 1', bounds: [sides, sides, sides] });
    const [from, to] = [
      [-0.7, 0, 0.3],
      [0.5, 0.4, -0.2],
    ];
    const [path] = quartic.geodesics(from, to, { max: 1 });
    const cosine = (from[0] * to[0] + from[2] * to[2]) / (Math.hypot(...from) * Math.hypot(...to));
    assert.equal(quartic.shortestPath(from, to).status, 'converged');
    assert.ok(Math.abs(path.length - Math.acos(cosine)) < 1e-9, `${path.length}`);
    quartic.dispose();
  });

  test('an end beside an implicit surface is moved onto it, one far from it is off-surface', () => {
    const near = sphere.shortestPath([1.1, 0, 0], [0, 0.95, 0]);
    assert.equal(near.status, 'converged');
    assert.deepEqual(Array.from(near.points.subarray(0, 3)), [1, 0, 0]);
    assertNoPath(sphere.shortestPath([3, 0, 0], [0, 1, 0]), 'off-surface');
    assertNoPath(sphere.shortestPath([1, 0, 0], [0, 0, 3]), 'off-surface');
    assertNoPath(sphere.shortestPath([3, 0, 0], [3, 0, 0]), 'off-surface');
    /* However far: on the way there the gradient falls as that of a power does, which is singular at any place. */
    const cushion = surfpath.implicit({ f: 'x^4 + y^4 + z^4 - 1' });
    for (const far of [
      [0, 3, 3],
      [0, 9, 9],
      [90, 90, 90],
    ])
      assertNoPath(cushion.shortestPath([1, 0, 0], far), 'off-surface');
    const double = surfpath.implicit({ f: '(x^4 + y^4 + z^4 - 1)^2' });
    for (const at of [
      [0, 1, 0],
      [0, 1.04, 0],
    ])
      assertNoPath(double.shortestPath([1, 0, 0], at), 'singular-metric');
    for (const surface of [cushion, double]) surface.dispose();
  });
});

describe('set', () => {
  const hill = surfpath.parametric({ x: 'u', y: 'v', z: 'h*exp(-4*(u^2+v^2))', u: [-1, 1], v: [-1, 'w'], parameters: { h: 0, w: 1 } });

  test('changes what it names, and the answers with it', () => {
    const flat = hill.shortestPath([-0.9, 0.1], [0.9, 0.1]).length;
    hill.set({ h: 0.5 });
    assert.deepEqual(hill.parameters, { h: 0.5, w: 1 });
    assert.ok(hill.shortestPath([-0.9, 0.1], [0.9, 0.1]).length > flat);
    hill.set({ h: 0 });
    assert.equal(hill.shortestPath([-0.9, 0.1], [0.9, 0.1]).length, flat);
  });

  test('refuses what does not exist or is no number, and then changes nothing', () => {
    refuses(() => hill.set({ height: 1 }), RangeError, /set: the surface has no parameter 'height'; it has h, w/);
    refuses(() => hill.set({ toString: 1 }), RangeError, /no parameter 'toString'/);
    refuses(() => hill.set({ h: NaN }), RangeError, /parameter h must be a finite number/);
    refuses(() => hill.set(anything(undefined)), TypeError, /parameters must be an object of numbers, not undefined/);
    refuses(() => hill.set({ h: 1, w: -2 }), RangeError, /v must be a range of two numbers/);
    assert.deepEqual(hill.parameters, { h: 0, w: 1 });
    assert.equal(hill.evaluate([0, 0])[2], 0);
  });

  test('parameters is a copy', () => {
    hill.parameters.h = 9;
    assert.equal(hill.parameters.h, 0);
  });
});

describe('evaluate', () => {
  test('parametric: position and unit normal', () => {
    const [x, y, z, nx, ny, nz] = saddle.evaluate([0.5, 0.25]);
    assert.deepEqual([x, y, z], [0.5, 0.25, 0.1875]);
    const length = Math.hypot(1, 0.5, 1);
    for (const difference of [nx + 1 / length, ny - 0.5 / length, nz - 1 / length]) close(difference, 0);
    assert.equal(saddle.evaluate(new Float32Array(20)).length, 60);
    assert.equal(saddle.evaluate([]).length, 0);
  });

  test('implicit: f and its gradient', () => {
    assert.deepEqual(Array.from(sphere.evaluate([1, 2, 3, 0, 0, 0])), [13, 2, 4, 6, -1, 0, 0, 0]);
  });

  test('knows the surface beyond the rectangle, NaN where the formula ends, no normal at a pole', () => {
    assert.equal(saddle.evaluate([5, 0])[2], 25);
    assert.ok(saddle.evaluate([NaN, 0]).every((x, i) => i === 1 || Number.isNaN(x)));
    assert.ok(surfpath.surface(gallery.enneper).evaluate([0, 0]).every(Number.isFinite));
    assert.ok(Number.isNaN(surfpath.parametric({ ...gallery.saddle, x: 'u^3', y: 'v', z: 0 }).evaluate([0, 0])[3]));
  });

  test('refuses what is no flat array', () => {
    refuses(() => saddle.evaluate([1, 2, 3]), RangeError, /evaluate: points must be a flat array of u v, 2 numbers a point, not 3 numbers/);
    refuses(() => saddle.evaluate(anything(undefined)), TypeError, /points must be a flat array .* not undefined/);
    refuses(
      () =>
        saddle.evaluate(
          anything([
            [0, 0],
            [1, 1],
          ]),
        ),
      TypeError,
      /it holds an array of 2/,
    );
    refuses(() => sphere.evaluate(anything(['1', 2, 3])), TypeError, /it holds '1'/);
  });
});

describe('project', () => {
  test('finds the closest point', () => {
    allClose(sphere.project([3, 4, 0]), [0.6, 0.8, 0]);
    const [u, v] = ring.project([5.5 * Math.cos(2), 5.5 * Math.sin(2), 0.1]);
    close(u, 2, 1e-9);
    assert.ok(Math.abs(v - 0.0667) < 0.01, `${v}`);
  });

  test('stays in the rectangle, and may be told where to begin', () => {
    assert.deepEqual(surfpath.parametric({ ...gallery.saddle, z: 0 }).project([7, 0.5, 2]), [1, 0.5]);
    allClose(sphere.project([0, 0, 0], [0, 0, 2]), [0, 0, 1]);
  });

  for (const { title, surface, u, v } of [
    {
      title: 'Rosenbrock’s function, steep and folded',
      surface: surfpath.graph({ z: '(1 - x)^2 + 100(y - x^2)^2', x: [-2, 2], y: [-1, 3] }),
      u: [-2, 2],
      v: [-1, 3],
    },
    {
      title: 'an egg box',
      surface: surfpath.graph({ z: 'sin(12x)*sin(12y)', x: [-2, 2], y: [-2, 2] }),
      u: [-2, 2],
      v: [-2, 2],
    },
    {
      title: 'turns close above each other',
      surface: surfpath.parametric({ x: 'v*cos(u)', y: 'v*sin(u)', z: '0.05u', u: [0, 40], v: [-1, 1] }),
      u: [0, 40],
      v: [-1, 1],
    },
  ])
    test(`finds points of the surface where they are: ${title}`, () => {
      const random = createRandom(5);
      for (let i = 0; i < 100; i++) {
        const place = [random.between(u[0], u[1]), random.between(v[0], v[1])];
        const point = Array.from(surface.evaluate(place).slice(0, 3));
        const found = surface.evaluate(surface.project(point)).slice(0, 3);
        /* Of squares, which are flat at the bottom, half of all digits are left. */
        assert.ok(Math.hypot(...point.map((x, j) => x - found[j])) < 1e-7 * (1 + Math.hypot(...point)), `${place}`);
      }
      surface.dispose();
    });

  test('beside the rim of a formula, beyond which the grid has no place', () => {
    const dome = surfpath.graph({ z: 'sqrt(4 - x^2 - y^2)', x: [-3, 3], y: [-3, 3] });
    const random = createRandom(6);
    for (let i = 0; i < 60; i++) {
      const point = [random.between(-3, 3), random.between(-3, 3), random.between(0.1, 3)];
      const far = Math.hypot(...point);
      const found = dome.project(point);
      assert.equal(found.length, 2);
      for (const j of [0, 1]) close(found[j], (2 * point[j]) / far, 1e-6);
    }
    dome.dispose();
  });

  test('implicit, without bounds: from far away and from deep inside, whatever the degree', () => {
    for (const degree of [2, 4, 8]) {
      const surface = surfpath.implicit({ f: `x^${degree} + y^${degree} + z^${degree} - 1` });
      for (const size of [0.1, 10, 1e4]) {
        const found = surface.project([size, 0.3 * size, 0.01 * size]);
        close(surface.evaluate(found)[0], 0, 1e-12);
        if (degree === 2)
          close(
            Math.hypot(...found.map((x, j) => x - [1, 0.3, 0.01][j] * size)),
            Math.abs(size * Math.hypot(1, 0.3, 0.01) - 1),
            1e-9 * size,
          );
      }
      surface.dispose();
    }
  });

  test('finds the closest point of what a parameter was changed to, on which turn of a strip it may be', () => {
    const strip = surfpath.parametric({ x: 'cos(u) + v/10', y: 'sin(u)', z: 'k*u', u: [0, 60], v: [-1, 1], parameters: { k: 0.1 } });
    const turn = () => Math.round(strip.project([2, 0, 6])[0] / (2 * Math.PI));
    assert.equal(turn(), 9);
    strip.set({ k: 0.3 });
    assert.equal(turn(), 3);
  });

  test('refuses misuse, and says so where there is nothing', () => {
    refuses(() => sphere.project([1, 2]), RangeError, /project: point must be \[x, y, z\], 3 numbers, not 2/);
    refuses(() => saddle.project([0, 0, 0], [5, 5]), RangeError, /project: near\[0\] = 5 lies outside/);
    refuses(
      () => surfpath.implicit({ f: 'x^2 + y^2 + z^2 - 1' }).project([0, 0, 0]),
      RangeError,
      /project: no point of the surface was found from there \(off-surface\); pass a point nearer/,
    );
    refuses(() => surfpath.implicit({ f: 'x^2 + 1', bounds: gallery.torus.bounds }).project([0, 0, 0]), RangeError, /project: no point/);
  });

  test('implicit: no farther than the nearest vertex of a mesh', () => {
    close(Math.hypot(...sphere.project([0, 0, 0])), 1);
    const surface = surfpath.surface(gallery.threeTori);
    const random = createRandom(3);
    const vertices = surface.mesh({ resolution: 32 }).positions;
    for (let i = 0; i < 200; i++) {
      const point = gallery.threeTori.bounds.map(([least, most]) => random.between(least, most));
      const away = (/** @type {ArrayLike<number>} */ place) => Math.hypot(...point.map((x, j) => x - place[j]));
      const found = surface.project(point);
      const nearest = Math.min(...Array.from({ length: vertices.length / 3 }, (_, k) => away(vertices.subarray(3 * k))));
      close(surface.evaluate(found)[0], 0, 1e-9);
      assert.ok(away(found) <= nearest, `${point}: ${away(found)}, a vertex is ${nearest} away`);
    }
  });
});

describe('mesh', () => {
  test('parametric: a grid with positions, unit normals, parameters, indices', () => {
    const { positions, normals, parameters, indices } = saddle.mesh({ resolution: 4 });
    assert.deepEqual([positions.length, normals.length, parameters?.length, indices.length], [75, 75, 50, 96]);
    for (let i = 0; i < 25; i++) close(Math.hypot(...normals.subarray(3 * i, 3 * i + 3)), 1);
    assert.ok(indices instanceof Uint32Array && indices.every((index) => index < 25));
  });

  test('implicit: every vertex on the surface, exact normals, no parameters', () => {
    const { positions, normals, parameters, indices } = sphere.mesh({ resolution: 10 });
    assert.equal(parameters, undefined);
    assert.ok(indices.length > 0 && indices.every((index) => 3 * index < positions.length));
    for (const [i, x] of positions.entries()) close(x, normals[i]);
  });

  test('poles get a normal', () => {
    const { normals } = surfpath.surface(gallery.globe).mesh({ resolution: 8 });
    assert.ok(normals.every(Number.isFinite));
  });

  test('refuses misuse', () => {
    for (const resolution of [0, 257, 1.5, NaN])
      refuses(() => saddle.mesh({ resolution }), RangeError, /resolution must be a whole number from 1 to 256/);
    refuses(() => saddle.mesh(anything({ resolution: '8' })), TypeError, /resolution must be a whole number from 1 to 256, not '8'/);
    refuses(
      () => saddle.geodesics([0, 0], [1, 1], anything({ max: '3' })),
      TypeError,
      /max must be a whole number from 1 to 100000, not '3'/,
    );
    const bounds = anything([
      ['-1', 1],
      [-1, 1],
      [-1, 1],
    ]);
    refuses(() => surfpath.implicit({ f: 'x', bounds }), TypeError, /bounds\[0\]\[0\] must be a finite number, not '-1'/);
    refuses(() => saddle.mesh(anything({ reslution: 8 })), TypeError, /there is no option 'reslution'; the options are resolution/);
    refuses(() => saddle.mesh(anything(null)), TypeError, /options must be an object/);
    refuses(() => surfpath.implicit({ f: 'x' }).mesh(), RangeError, /inside its bounds; give them in its definition/);
  });
});

describe('dispose', () => {
  /** Every public member that asks or changes something: methods, and properties that are computed. @param {object} object @returns {string[]} */
  const membersOf = (object) =>
    Object.getOwnPropertyNames(Object.getPrototypeOf(object)).filter((name) => !['constructor', 'dispose'].includes(name));
  /** @param {any} object @param {string} name @param {any[]} given */
  const use = (object, name, ...given) => (typeof object[name] === 'function' ? object[name](...given) : undefined);

  test('every member of a disposed surface refuses, of whatever kind, and it may be disposed twice', () => {
    const halfPlane = { kind: 'metric', E: '1/v^2', F: 0, G: '1/v^2', u: [-3, 3], v: [0.05, 5] };
    for (const definition of [gallery.sphere, gallery.saddle, gallery.trefoil, { ...gallery.saddle, density: 2 }, halfPlane]) {
      const surface = surfpath.surface(anything(definition));
      surface.dispose();
      surface.dispose();
      const names = membersOf(surface);
      assert.ok(names.length >= 11, names.join());
      for (const name of names)
        for (const given of [[], [[0, 0], [1, 1], 0.5]])
          refuses(() => use(surface, name, ...given), Error, new RegExp(`^${name}: this surface was disposed`));
    }
  });

  test('every member of a disposed instance refuses', async () => {
    const other = await load();
    other.dispose();
    other.dispose();
    const names = membersOf(other);
    assert.ok(names.length >= 8, names.join());
    for (const name of names) refuses(() => use(other, name, gallery.saddle), Error, /: this instance was disposed/);
  });

  test('both dispose by Symbol.dispose, as `using` does', async () => {
    const other = await load();
    const surface = other.surface(gallery.saddle);
    surface[Symbol.dispose]();
    refuses(() => surface.evaluate([0, 0]), Error, /this surface was disposed/);
    other[Symbol.dispose]();
    refuses(() => other.surface(gallery.saddle), Error, /this instance was disposed/);
  });

  test('a disposed instance takes its surfaces along, and no others', async () => {
    const other = await load();
    const surface = other.surface(gallery.saddle);
    other.dispose();
    other.dispose();
    refuses(() => surface.shortestPath([0, 0], [0.5, 0.5]), Error, /this surface was disposed/);
    refuses(() => other.surface(gallery.saddle), Error, /parametric: this instance was disposed/);
    assert.equal(saddle.shortestPath([0, 0], [0.5, 0.5]).status, 'converged');
  });

  test('other surfaces keep working when slots and memory are used again', () => {
    const before = saddle.shortestPath([-0.9, 0.1], [0.5, 0.9]);
    for (let i = 0; i < ofAll(5, 50); i++) {
      const passing = surfpath.parametric({ ...gallery.saddle, z: `u^2 - ${i}*v^2` });
      passing.shortestPath([0, 0], [0.5, 0.5]);
      passing.dispose();
    }
    assert.deepEqual(saddle.shortestPath([-0.9, 0.1], [0.5, 0.9]), before);
  });
});
