// Contacts with an edge that are shorter than what lies between two nodes: a plane around a disc, where the shortest way is known.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { load } from '../../web/index.js';
import { createRandom } from '../helpers/random.js';
import { ofAll } from '../helpers/sample.js';

const surfpath = await load();
const PAIRS = 40;
/** Part of a length by which the known one is rounded. */
const ROUNDING = 4e-13;

/** The shortest way around a disc. @param {number} radius @param {number} a distance of an end from its middle @param {number} b @param {number} angle between the ends, seen from there */
function wayAround(radius, a, b, angle) {
  const touching = [a, b].map((far) => Math.acos(Math.min(radius / far, 1)));
  const wound = angle - touching[0] - touching[1];
  const straight = [a, b].map((far) => Math.sqrt(Math.max(far ** 2 - radius ** 2, 0)));
  return wound > 0 ? straight[0] + straight[1] + radius * wound : Math.sqrt(a ** 2 + b ** 2 - 2 * a * b * Math.cos(angle));
}

/** Ends between which the way touches the disc along an angle of 1e-4 … 0.1, or just passes it; some of them on its edge. @param {number} radius @param {ReturnType<typeof createRandom>} random */
function grazing(radius, random) {
  const far = () => radius + random.between(0, 1) ** 2 * (2 - radius);
  const [a, b] = [random.between(0, 1) < 0.4 ? radius : far(), far()];
  const wound = 10 ** random.between(-4, -1) * (random.between(0, 1) < 0.1 ? -1 : 1);
  const angle = Math.acos(radius / a) + Math.acos(radius / b) + wound;
  return { from: [0.05, a], to: [0.05 + angle, b], length: wayAround(radius, a, b, angle) };
}

for (const radius of [0.003, 0.03, 0.3, 1])
  for (const tolerance of [1e-6, 1e-9, 1e-12])
    test(`around a disc of radius ${radius}, tolerance ${tolerance}: as long as tangents and arc, seed 5`, () => {
      const ring = surfpath.parametric({ x: 'v cos(u)', y: 'v sin(u)', z: 0, u: [0, 5], v: [radius, 2] });
      const random = createRandom(5);
      for (let i = 0; i < ofAll(15, PAIRS); i++) {
        const { from, to, length } = grazing(radius, random);
        if (!(to[0] > from[0])) continue;
        for (const start of /** @type {const} */ (['global', 'straight'])) {
          const path = ring.shortestPath(from, to, { tolerance, start });
          const what = `${from} to ${to}, ${start}: ${path.status}, ${path.length} ± ${path.lengthError}, not ${length}`;
          assert.ok(path.converged, what);
          assert.ok(Math.abs(path.length - length) <= tolerance * length + ROUNDING * length, what);
          assert.ok(Math.abs(path.length - length) <= 3 * path.lengthError + ROUNDING * length, what);
        }
      }
      ring.dispose();
    });

test('the points of a path that touches for a moment are no longer than it', () => {
  const ring = surfpath.parametric({ x: 'v cos(u)', y: 'v sin(u)', z: 0, u: [0, 3], v: [1, 2] });
  const far = 1.174;
  for (const wound of [1.7e-3, 3.844e-3, 6e-3]) {
    const path = ring.shortestPath([0.5, 1], [0.5 + Math.acos(1 / far) + wound, far], { points: 2000 });
    let chords = 0;
    for (let i = 3; i < path.points.length; i += 3)
      chords += Math.hypot(path.points[i] - path.points[i - 3], path.points[i + 1] - path.points[i - 2]);
    assert.ok(path.converged && path.touchesBoundary && Math.abs(path.length - Math.sqrt(far ** 2 - 1) - wound) < 1e-14, `${path.length}`);
    assert.ok(chords <= path.length * (1 + 1e-14), `${chords} beside ${path.length}`);
  }
  ring.dispose();
});

test('walls that a density, or a wave of the wall, pulls a path away from midway: what starts on the path is as short, seed 4', () => {
  const random = createRandom(4);
  const given = [
    { wave: '0', density: '1+0.3sin(5x)', from: [0.16541239097714422, -0.16794001892209054], to: [3.8254129399359225, 0.0702462039887905] },
    {
      wave: '0',
      density: '1+0.2sin(8x)cos(7y)',
      from: [5.546284288633615, -0.1416681000031531],
      to: [1.6879562633112073, -0.11118549257516862],
    },
  ];
  const ribbons = Array.from({ length: ofAll(2, 9) }, (_, i) => ({
    wave: `${random.between(0, 0.05)}sin(${random.between(2, 7)}u)`,
    density: i % 3 ? `1+${random.between(0.05, 0.3)}sin(${random.between(3, 9)}x)cos(${random.between(3, 9)}y)` : '1',
    from: [random.between(0, 2), random.between(-0.2, 0.2)],
    to: [random.between(3.5, 6), random.between(-0.2, 0.2)],
  }));
  for (const { wave, density, from, to } of [...given, ...ribbons]) {
    const radius = `(2+v+${wave})`;
    const ribbon = surfpath.parametric({ x: `${radius}cos(u)`, y: `${radius}sin(u)`, z: 0, u: [0, 6], v: [-0.2, 0.2], density });
    const path = ribbon.shortestPath(from, to);
    const again = ribbon.shortestPath(from, to, { start: path, points: 10000 });
    const what = `${radius}, ${density}, ${from} to ${to}: ${path.status} ${path.length}, from there ${again.length}`;
    assert.ok(path.converged && again.converged && again.touchesBoundary, what);
    assert.ok(path.length - again.length <= path.lengthError + again.lengthError + ROUNDING * path.length, what);
    ribbon.dispose();
  }
});

test('long strips, from edge to edge: where a path ends on an edge which it leaves, it ends there, seed 9', () => {
  const random = createRandom(9);
  const strips = [
    { z: '0.2cos(3x)+0.3y^2', long: 10, low: -1, high: 1 },
    { z: '0.3sin(x)+0.1y^2', long: 60, low: -1, high: 1 },
    { z: '0.3sin(2x+y)', long: 20, low: 0, high: 5 },
    { z: '0.2sin(x)', density: '1+0.3cos(2x+y)', long: 10, low: 0, high: 4 },
  ];
  let open = 0;
  for (const { z, density, long, low, high } of strips) {
    const strip = surfpath.graph({ z, density, x: [0, long], y: [low, high] });
    const end = () => [random.between(0, long), random.between(0, 1) < 0.5 ? low : high];
    const pairs = [
      [
        [0, 0],
        [long - 2, high],
      ],
      ...Array.from({ length: 40 }, () => [end(), end()]),
    ];
    for (const [from, to] of pairs) {
      const path = strip.shortestPath(from, to);
      const what = `${z} from ${from} to ${to}: ${path.status} ${path.length}`;
      assert.ok(path.converged || path.status === 'tolerance-not-met', what);
      const chords = strip.shortestPath(from, to, { algorithm: 'polyline', points: 1999, start: path });
      const apart = Math.abs(chords.length + chords.lengthError - path.length);
      if (!path.converged) {
        open++;
        /* Measured: 6e-4 at most, five times what a polyline of 8,000 points says. */
        assert.ok(chords.converged && path.lengthError < 1e-3 * path.length, what);
        assert.ok(apart <= path.lengthError + chords.lengthError, `${what} ± ${path.lengthError}, chords ${chords.length}`);
      } else if (chords.converged) assert.ok(apart <= 4 * chords.lengthError + 1e-6 * path.length, `${what}, chords ${chords.length}`);
    }
    strip.dispose();
  }
  assert.ok(open <= 4, `${open} of 164 are not solved to the tolerance`);
});

/** From a height down to a wall at the height `least`, under a density of the height: along a catenary. @param {number} least @param {number} height */
function downTo(least, height) {
  const far = Math.acosh(height / least);
  return { along: least * far, length: least ** 2 * (far / 2 + Math.sinh(2 * far) / 4) };
}

test('a density that is small on a wall: two catenaries, and the wall between them, seed 5', () => {
  /* The wall has a radius of least² there, where paths are up to 2 long. */
  const least = 0.01;
  const film = surfpath.graph({ z: 0, x: [-2, 2], y: [least, 2], density: 'y' });
  const random = createRandom(5);
  let touching = 0;
  for (let i = 0; i < PAIRS; i++) {
    const [from, to] = [0, 1].map(() => [random.between(-2, 2), random.integer(5) ? random.between(least, 2) : least]);
    const [a, b] = [downTo(least, from[1]), downTo(least, to[1])];
    const wall = Math.abs(to[0] - from[0]) - a.along - b.along;
    if (wall < 0) continue;
    const length = a.length + b.length + least * wall;
    const path = film.shortestPath(from, to);
    const what = `${from} to ${to}: ${path.status}, ${path.length} ± ${path.lengthError}, not ${length}`;
    assert.ok(path.converged, what);
    if (path.length < 0.999 * length) continue; // one catenary from end to end
    touching++;
    assert.ok(Math.abs(path.length - length) <= 3 * path.lengthError + ROUNDING * length, what);
  }
  assert.equal(touching, 33);
  film.dispose();
});

for (const least of [0.1, 0.05, 0.04])
  test(`around a corner, along both of its edges, from ${least} on: z³ makes the plane of it, in which they have one tangent in common`, () => {
    const land = surfpath.graph({ z: 0, x: [least, 1], y: [least, 1], density: '3(x^2 + y^2)' });
    const touching = least * (1 + Math.SQRT2);
    const alongEdge = (/** @type {number} */ far) => 3 * least ** 2 * (far - touching) + far ** 3 - touching ** 3;
    /* From (x + iy)³ to (y + ix)³, x = least and y where they touch. */
    const [real, imaginary] = [least ** 3 - 3 * least * touching ** 2, 3 * least ** 2 * touching - touching ** 3];
    const tangent = Math.SQRT2 * Math.abs(real + imaginary);
    for (const [up, right] of [
      [0.9, 0.9],
      [0.9, 0.4],
      [0.25, 0.6],
    ]) {
      const length = alongEdge(up) + alongEdge(right) + tangent;
      const path = land.shortestPath([least, up], [right, least]);
      assert.ok(path.converged && path.touchesBoundary, path.status);
      assert.ok(Math.abs(path.length - length) <= 3 * path.lengthError + ROUNDING * length, `${path.length}, not ${length}`);
    }
    land.dispose();
  });

test('a strip that winds many times: from one wave to the next paths touch both walls, and each wave adds as much', () => {
  const wave = (2 * Math.PI) / 3;
  const strip = surfpath.parametric({ x: 'u', y: 'v + 0.3sin(3u)', z: 0, u: [0, 30], v: [-0.2, 0.2] });
  const over = (/** @type {number} */ waves) => strip.shortestPath([1, 0.05], [1.3 + waves * wave, -0.1]);
  const [two, three] = [over(2), over(3)];
  for (const waves of [4, 5, 7, 9]) {
    const path = over(waves);
    const length = two.length + (waves - 2) * (three.length - two.length);
    assert.ok(path.converged && path.touchesBoundary, `${waves} waves: ${path.status}`);
    assert.ok(Math.abs(path.length - length) <= 3 * waves * path.lengthError + ROUNDING * length, `${path.length}, not ${length}`);
  }
  strip.dispose();
});

test('points along an edge on which a density falls to a fiftieth, from a corner on, are as far apart as elsewhere', () => {
  const land = surfpath.graph({ z: 0, x: [-1, 1], y: [-1, 1], density: '2.02 - x^2 - y^2' });
  const density = (/** @type {number} */ x, /** @type {number} */ y) => 2.02 - x * x - y * y;
  const { status, length, parameters } = land.shortestPath([-1, -1], [0.47, -0.24], { points: 999 });
  const places = /** @type {Float64Array} */ (parameters);
  assert.equal(status, 'converged');
  for (let i = 2; i < places.length; i += 2) {
    const [x, y, u, v] = places.subarray(i - 2, i + 2);
    const step = (Math.hypot(u - x, v - y) * (density(x, y) + 4 * density((x + u) / 2, (y + v) / 2) + density(u, v))) / 6;
    assert.ok(Math.abs((1000 * step) / length - 1) < 1e-5, `${1000 * step} at ${x}, ${y}, not ${length}`);
  }
  land.dispose();
});

/**
 * Bands between circles of equal width, or nearly, around a surface of revolution: an arc that is tangent to both slides along them without becoming longer, as its ends are conjugate. By Clairaut, beside the
 * wider circle a path leaves at once.
 * @type {{ name: string, width: (v: number) => number, definition: any, height: number }[]}
 */
const bands = [
  { name: 'sphere', height: 0.8, width: Math.cos, definition: { x: 'cos(v)*cos(u)', y: 'cos(v)*sin(u)', z: 'sin(v)' } },
  {
    name: 'torus',
    height: 1.2,
    width: (v) => 2 + Math.cos(v),
    definition: { x: '(2 + cos(v))*cos(u)', y: '(2 + cos(v))*sin(u)', z: 'sin(v)' },
  },
];

/** How far it is over an arc that is tangent to the circles at ±height, and around: Gauss's and Chebyshev's rule, as v = height sin t. @param {(v: number) => number} width @param {number} height */
function tangentArc(width, height) {
  const count = 200;
  let [length, around] = [0, 0];
  for (let k = 0; k < count; k++) {
    const angle = ((k + 0.5) / count - 0.5) * Math.PI;
    const [at, least] = [width(height * Math.sin(angle)), width(height)];
    const speed = ((Math.PI / count) * height * Math.cos(angle)) / Math.sqrt((at - least) * (at + least));
    length += at * speed;
    around += (least / at) * speed;
  }
  return { length, around };
}

for (const { name, width, definition, height } of bands)
  for (const beyond of [0, 1e-12, 1e-8])
    test(`a band of a ${name}, from edge to edge, the upper one ${beyond} farther: as long as an arc that is tangent to both, and the edges, seed 3`, () => {
      const band = surfpath.parametric({ ...definition, u: [0, 5.5], v: [-height, height + beyond] });
      const random = createRandom(3);
      const { length: least, around } = tangentArc(width, height);
      for (let i = 0; i < ofAll(7, 20); i++) {
        const [u, far] = [random.between(0, 0.5), random.between(4.5, 5.5)];
        for (const tolerance of [1e-6, 1e-9, 1e-12]) {
          const { status, length, lengthError } = band.shortestPath([u, -height], [far, height + beyond], { tolerance });
          const what = `${u} to ${far}, ${tolerance}: ${status}, ${length} ± ${lengthError}`;
          assert.ok(status === 'ill-conditioned' || status === 'converged', what);
          const onEdges = far - u - around;
          const known = least + width(height) * onEdges;
          const shorter = (width(height) - width(height + beyond)) * onEdges;
          assert.ok(
            length <= known * (1 + 1e-12) + lengthError && length >= known - 1.5 * shorter - 1e-12 * known - lengthError,
            `${what}, not ${known}`,
          );
          // It slants by 1e-3 at most, half the square of which edges may be too long by, two of them together.
          assert.ok(lengthError <= 1e-6, what);
        }
      }
      band.dispose();
    });

test('walls of a surface a few units wide whose coordinates are as large as a map has them: as long as at the origin, seed 5', () => {
  const [east, north] = [500000, 4649776];
  const hillAt = (/** @type {number} */ x, /** @type {number} */ y) =>
    surfpath.graph({ z: `3 exp(-(x - ${x})^2 - (y - ${y})^2)`, x: [x - 2, x + 2], y: [y - 0.6, y + 0.6] });
  const [here, there] = [hillAt(0, 0), hillAt(east, north)];
  const random = createRandom(5);
  let walls = 0;
  for (let i = 0; i < ofAll(10, PAIRS); i++) {
    const place = () => [random.between(-2, 2), i % 3 ? random.between(-0.6, 0.6) : 0.6];
    const ends = [place(), place()];
    const { length } = here.shortestPath(ends[0], ends[1], { start: 'straight' });
    const [from, to] = ends.map(([x, y]) => [east + x, Math.min(north + y, north + 0.6)]);
    const path = there.shortestPath(from, to, { start: 'straight', tolerance: 1e-6 });
    assert.ok(path.converged, `${ends}: ${path.status}`);
    assert.ok(Math.abs(path.length - length) <= 1e-6 * length, `${ends}: ${path.length}, not ${length}`);
    walls += Number(path.touchesBoundary);
  }
  assert.ok(walls >= ofAll(10, PAIRS) / 4, `${walls} touch a wall`);
});
