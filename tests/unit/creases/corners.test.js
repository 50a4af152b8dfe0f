// Paths that turn at corners, where creases meet: on bodies of boxes as long as faces unfolded around these, on graphs as long as the straight lines to the corner.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { turnBetween } from '../../../web/creases/fan.js';
import { load } from '../../../web/index.js';
import { dot } from '../../../web/vector.js';
import { askOnBoxes, BODIES, formulaOf, randomBoxes, Ways } from '../../accuracy/measure/boxes.js';
import { createRandom } from '../../helpers/random.js';
import { ofAll } from '../../helpers/sample.js';

const surfpath = await load();
const RIGHT = 2e-9;
const PAIRS = 4;

/** @param {import('../../accuracy/measure/boxes.js').Answer[]} answers */
function check(answers) {
  for (const { from, to, exact, path } of answers) {
    const asked = `${from} to ${to}`;
    assert.equal(path.status, 'converged', asked);
    assert.ok(Math.abs(path.length - exact) <= RIGHT * exact, `${asked}: ${path.length}, exact ${exact}`);
    for (const [end, first] of /** @type {[number[], number][]} */ ([
      [from, 0],
      [to, path.points.length - 3],
    ]))
      for (const [k, x] of end.entries()) assert.ok(Math.abs(x - path.points[first + k]) <= 1e-9, `${asked}: ends elsewhere`);
  }
}

for (const [name, boxes] of Object.entries(BODIES))
  test(`boxes: ${name}, as long as unfolded, seed 2`, () => check(askOnBoxes(surfpath, boxes, createRandom(2), PAIRS)));

test('boxes at random, as long as unfolded, seed 6', () => {
  const random = createRandom(6);
  for (let body = 0; body < ofAll(1, 5); body++) check(askOnBoxes(surfpath, randomBoxes(random), random, 2));
});

test('a path ends where it was asked to, not on another face below', () => {
  const bars = ['x', 'y', 'z'].map((long) => `max(${['x', 'y', 'z'].map((axis) => `abs(${axis}) - ${axis === long ? 1.2 : 0.4}`)})`);
  const side = /** @type {const} */ ([-1.5, 1.5]);
  const cross = surfpath.implicit({ f: `min(${bars})`, bounds: [side, side, side] });
  const [from, to, corner] = [
    [-0.4, 0.4785, 0.0106],
    [0.3309, 0.4, 0.7068],
    [-0.4, 0.4, 0.4],
  ];
  const path = cross.shortestPath(from, to);
  const straight = Math.hypot(...from.map((x, k) => x - corner[k])) + Math.hypot(...to.map((x, k) => x - corner[k]));
  assert.deepEqual([...path.points.slice(-3)], to);
  assert.ok(
    path.converged && Math.abs(path.length - straight) <= RIGHT * straight,
    `${path.status}, ${path.length}, through the corner ${straight}`,
  );
  cross.dispose();
});

test('a leg that would pass just beyond a corner does not cut it off: the path turns there', () => {
  const side = /** @type {const} */ ([-1.25, 1.25]);
  const frame = surfpath.implicit({ f: formulaOf(BODIES.frame), bounds: [side, side, side] });
  const corner = [0.5, -0.5, 0.3];
  for (const beyond of [0.03, 0.003, 1e-3, 1e-4, 1e-6])
    for (const [y, z] of [
      [0.4, -0.2],
      [-0.2, 0.1],
    ]) {
      /* Unfolded, the straight line over the upper edge crosses that so far beyond the corner. */
      const [from, out, edge] = [[0.5, y, z], 0.2, -0.5 - beyond];
      const to = [0.5 + out, edge + ((edge - y) * out) / (0.3 - z), 0.3];
      const exact = Math.hypot(...from.map((x, k) => x - corner[k])) + Math.hypot(...to.map((x, k) => x - corner[k]));
      const path = frame.shortestPath(from, to);
      assert.ok(
        path.converged && Math.abs(path.length - exact) <= RIGHT * exact,
        `${beyond}, ${from}: ${path.status}, ${path.length}, exact ${exact}`,
      );
    }
  frame.dispose();
});

test('a path that slides into a corner, or comes to rest across the body beside one, turns there', () => {
  /** @type {[import('../../accuracy/measure/boxes.js').Box[], number[], number[], number[]][]} */
  const cases = [
    [BODIES.frame, [-0.5, 0.4844, 0.2872], [-0.5, 0.5, 0.3], [-0.435, 0.5618, 0.3]],
    [BODIES.channel, [-0.5, -0.4593, -0.3289], [-0.5, -0.5, -0.4], [-0.3604, -0.5, -0.5254]],
    [BODIES.notch, [0.9168, -0.3, 0.2009], [1, -0.3, 0.2], [1, -0.495, 0.1058]],
    /* It goes round in circles between ways as far from the corner as a quarter of them. */
    [BODIES.cubes, [0.3, 0.2906, -0.2593], [0.3, 0.3, -0.2], [0.3191, 0.3374, -0.2]],
  ];
  for (const [boxes, from, corner, to] of cases) {
    const side = /** @type {const} */ ([-1.25, 1.25]);
    const body = surfpath.implicit({ f: formulaOf(boxes), bounds: [side, side, side] });
    const exact = Math.hypot(...from.map((x, k) => x - corner[k])) + Math.hypot(...to.map((x, k) => x - corner[k]));
    const path = body.shortestPath(from, to);
    assert.ok(path.converged && Math.abs(path.length - exact) <= RIGHT * exact, `${from}: ${path.status}, ${path.length}, exact ${exact}`);
    body.dispose();
  }
});

test('ends that are typed with a few digits lie beside a body, by little or by more: the path is that of the places below', () => {
  const side = /** @type {const} */ ([-1.5, 1.5]);
  const cube = surfpath.implicit({ f: 'max(|x|, |y|, |z|) - 1', bounds: [side, side, side] });
  for (const off of [0, 1e-12, 1e-10, 1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-3]) {
    const path = cube.shortestPath([1 + off, 0.2, 0.3], [-0.4, 1 + off, 0.1]);
    const exact = Math.hypot(0.8 + 1.4, 0.2);
    assert.ok(path.converged && Math.abs(path.length - exact) <= RIGHT * exact, `${off}: ${path.status}, ${path.length}, exact ${exact}`);
  }
  cube.dispose();
});

test('a corner lets go of legs that turn by less than half around it with no crease between them', () => {
  const { table } = BODIES;
  const side = /** @type {const} */ ([-1.25, 1.25]);
  const surface = surfpath.implicit({ f: formulaOf(table), bounds: [side, side, side] });
  const [from, to] = [
    [-0.9524, 0.9823, 0.5],
    [0.7532, -0.9, -0.4603],
  ];
  /* Under the table, past the first leg's outer corner, from its inner one to that of the third, and around this. */
  const exact = Math.hypot(from[0] + 0.6, from[1] - 0.9) + Math.hypot(1.2, 1.5) + Math.hypot(0.3 + to[0] - 0.6, 0.5 - to[2]);
  const path = surface.shortestPath(from, to);
  assert.ok(path.converged && Math.abs(path.length - exact) <= RIGHT * exact, `${path.status}, ${path.length}, exact ${exact}`);
  surface.dispose();
});

test('|x| − |y|: through the corner where that is shortest, past it elsewhere, seed 3', () => {
  const graph = surfpath.graph({ z: 'abs(x) - abs(y)', x: [-1, 1], y: [-1, 1] });
  const at = (/** @type {number[]} */ [x, y]) => [x, y, Math.abs(x) - Math.abs(y)];
  const sides = [-1, 0, 1];
  const corners = sides.flatMap((y) => sides.map((x) => at([x, y])));
  const faces = [0, 1, 3, 4].flatMap((k) => [
    [k, k + 1, k + 4],
    [k, k + 4, k + 3],
  ]);
  const ways = new Ways({ corners, faces });
  const random = createRandom(3);
  let through = 0;
  for (let i = 0; i < 30; i++) {
    const [from, to] = [ways.pick(random), ways.pick(random)];
    const path = graph.shortestPath(from.place.slice(0, 2), to.place.slice(0, 2));
    assert.equal(path.status, 'converged');
    if (path.touchesBoundary) continue;
    const exact = ways.length(from, to);
    const [a, b] = [from, to].map(({ place }) => Math.hypot(...place));
    if (Math.abs(a + b - exact) <= RIGHT * exact) through++;
    assert.ok(Math.abs(path.length - exact) <= RIGHT * exact, `${from.place} to ${to.place}: ${path.length}, exact ${exact}`);
  }
  assert.ok(through >= 3, `only ${through} lead through the corner`);
  graph.dispose();
});

test('all around a corner it is a full turn, from the direction of a node that is not tangent to its side, as on what bends', () => {
  /** A plane with a crease along y. @type {any} */
  const side = { jets: () => [[0, 0, 0, 1]], measure: () => [[0, 1, 0, 0]], productOf: () => dot };
  const sides = { ...side, scale: [1, 1, 1], count: 1, on: () => side };
  for (const steep of [0, 1e-9, 1e-3, 0.1]) {
    const around = turnBetween(sides, { place: [0, 0, 0], creases: [0] }, [1], [1, 0.3, steep]);
    assert.ok(around && around.rays.length === 2, `${steep}: ${JSON.stringify(around)}`);
    const turn = Math.PI * around.turn.halves + Math.atan2(around.turn.y, around.turn.x);
    assert.ok(Math.abs(turn - 2 * Math.PI) < 1e-9, `${steep}: ${JSON.stringify(around)}`);
  }
});

test('from and to tips of an octahedron, and from beside them: as long as unfolded, and a field is finite on all of it', () => {
  const side = /** @type {const} */ ([-1.2, 1.2]);
  const octahedron = surfpath.implicit({ f: 'abs(x) + abs(y) + abs(z) - 1', bounds: [side, side, side] });
  /* Two triangles of sides √2 laid flat side by side: from tip to tip it is twice their height. The other lengths are the least over all rows of up to five faces, by where these are crossed. */
  for (const k of [0, 1, 2]) {
    const tip = [0, 1, 2].map((i) => Number(i === k));
    const path = octahedron.shortestPath(
      tip,
      tip.map((x) => -x),
    );
    assert.equal(path.status, 'converged');
    assert.ok(Math.abs(path.length - Math.sqrt(6)) <= RIGHT, String(path.length));
  }
  for (const [from, to, exact] of /** @type {[number[], number[], number][]} */ ([
    [[1, 0, 0], [-0.627281989140146, 0.161054018344248, 0.21166399251560603], 1.993326539484356],
    [[0.98, 0.015, 0.005], [-1, 0, 0], 2.425005154633696],
    [[0.999, 0.001, 0], [-0.999, 0, 0.001], 2.447040661697307],
  ])) {
    const path = octahedron.shortestPath(from, to);
    assert.equal(path.status, 'converged', `${from} to ${to}`);
    assert.ok(Math.abs(path.length - exact) <= RIGHT, `${from} to ${to}: ${path.length}`);
  }
  assert.ok(octahedron.distanceField([1, 0, 0]).distances.every(Number.isFinite));
});
