/**
 * Shortest ways over a square whose density jumps, by brute force: Dijkstra's algorithm on a grid whose nodes see far, then nodes moved while that makes the way shorter.
 * What it finds is a way, so the shortest path is no longer; it misses that by a few thousandths. Knows nothing of the solver.
 */

/** @typedef {(x: number, y: number) => number} Density */

/** Half the side of the square, spaces of the grid along a side, and how many of them an edge spans at most. */
const [SIDE, SPACES, SIGHT] = [2, 160, 5];
/** Points at which density is looked at, a space of the grid. */
const SEEN = 4;
/** Nodes of the way that is moved, and how often all are moved at each of so many steps, each half the one before. */
const [NODES, SWEEPS, STEPS] = [96, 6, 9];

const STEP = (2 * SIDE) / SPACES;
const ROW = SPACES + 1;
/** @type {(a: number, b: number) => number} */
const greatest = (a, b) => (b === 0 ? Math.abs(a) : greatest(b, a % b));
const EDGES = Array.from({ length: (2 * SIGHT + 1) ** 2 }, (_, k) => [
  (k % (2 * SIGHT + 1)) - SIGHT,
  Math.floor(k / (2 * SIGHT + 1)) - SIGHT,
]).filter(([x, y]) => greatest(x, y) === 1);

/** How long a straight line is, by the rule of midpoints. @param {Density} density @param {number[]} from @param {number[]} to */
function chord(density, [ax, ay], [bx, by]) {
  const length = Math.hypot(bx - ax, by - ay);
  const count = Math.max(2 * SEEN, Math.ceil((length / STEP) * SEEN));
  let sum = 0;
  for (let i = 0; i < count; i++) {
    const part = (i + 0.5) / count;
    sum += density(ax + part * (bx - ax), ay + part * (by - ay));
  }
  return (length * sum) / count;
}

/** @param {Density} density @param {number[][]} way */
const measure = (density, way) => way.slice(1).reduce((sum, place, i) => sum + chord(density, way[i], place), 0);

/** The grid with the lengths of its edges. @param {Density} density */
function buildGrid(density) {
  return EDGES.map(([dx, dy]) => {
    const of = new Float64Array(ROW * ROW).fill(Infinity);
    for (let k = 0; k < of.length; k++) {
      const [x, y] = [k % ROW, Math.floor(k / ROW)];
      if (Math.min(x + dx, y + dy) < 0 || Math.max(x + dx, y + dy) > SPACES) continue;
      of[k] = chord(density, placeOf(k), placeOf(k + dx + ROW * dy));
    }
    return of;
  });
}

/** @param {number} k */
const placeOf = (k) => [STEP * (k % ROW) - SIDE, STEP * Math.floor(k / ROW) - SIDE];

/** The shortest way over the grid. @param {Float64Array[]} lengths @param {number} from @param {number} to nodes @returns {number[][]} */
function search(lengths, from, to) {
  const distance = new Float64Array(ROW * ROW).fill(Infinity);
  const before = new Int32Array(ROW * ROW).fill(-1);
  /* Buckets of a tenth of a space: what is shorter by less may come later, and is then looked at again. */
  /** @type {number[][]} */
  const buckets = [[from]];
  distance[from] = 0;
  for (let b = 0; b < buckets.length; b++)
    for (const k of buckets[b] ?? []) {
      if (Math.floor(distance[k] / (STEP / 10)) < b) continue;
      for (const [e, [dx, dy]] of EDGES.entries()) {
        const next = k + dx + ROW * dy;
        const length = distance[k] + lengths[e][k];
        if (!(length < distance[next])) continue;
        distance[next] = length;
        before[next] = k;
        const at = Math.floor(length / (STEP / 10));
        buckets[at] ??= [];
        buckets[at].push(next);
      }
    }
  const way = [];
  for (let k = to; k >= 0; k = before[k]) way.push(placeOf(k));
  return way.reverse();
}

/** Nodes evenly along a way. @param {number[][]} way */
function even(way) {
  const behind = [0];
  for (let i = 1; i < way.length; i++) behind.push(behind[i - 1] + Math.hypot(way[i][0] - way[i - 1][0], way[i][1] - way[i - 1][1]));
  let i = 1;
  return Array.from({ length: NODES }, (_, k) => {
    const wanted = (behind[way.length - 1] * k) / (NODES - 1);
    while (i < way.length - 1 && behind[i] < wanted) i++;
    const part = behind[i] > behind[i - 1] ? (wanted - behind[i - 1]) / (behind[i] - behind[i - 1]) : 0;
    return way[i].map((x, j) => way[i - 1][j] + part * (x - way[i - 1][j]));
  });
}

/** Moves nodes one by one while that shortens the way. @param {Density} density @param {number[][]} way */
function tighten(density, way) {
  const places = even(way);
  let step = STEP;
  for (let halving = 0; halving < STEPS; halving++, step /= 2)
    for (let sweep = 0; sweep < SWEEPS; sweep++)
      for (let i = 1; i < places.length - 1; i++) {
        const long = (/** @type {number[]} */ at) => chord(density, places[i - 1], at) + chord(density, at, places[i + 1]);
        let known = long(places[i]);
        for (let turn = 0; turn < 8; turn++) {
          const angle = (turn * Math.PI) / 4;
          const tried = [places[i][0] + step * Math.cos(angle), places[i][1] + step * Math.sin(angle)];
          if (Math.max(...tried.map(Math.abs)) > SIDE) continue;
          const length = long(tried);
          if (length < known) [places[i], known] = [tried, length];
        }
      }
  return places;
}

/** Lengths of shortest ways, from above. @param {Density} density @returns {(from: number[], to: number[]) => number} */
export function bruteForce(density) {
  /** @type {Float64Array[] | null} */
  let lengths = null;
  return (from, to) => {
    lengths ??= buildGrid(density);
    const [a, b] = [from, to].map(([x, y]) => Math.round((x + SIDE) / STEP) + ROW * Math.round((y + SIDE) / STEP));
    const way = [from, ...search(lengths, a, b), to];
    return Math.min(measure(density, [from, to]), measure(density, tighten(density, way)));
  };
}

/** Densities over the square that jump, as formulas and as functions. @type {Record<string, [string, Density]>} */
export const JUMPS = {
  'winding bank': ['2 + sign(y - 0.3*sin(2x))', (x, y) => 2 + Math.sign(y - 0.3 * Math.sin(2 * x))],
  'steeper bank': ['3 - 2*sign(y - 0.5*sin(3x))', (x, y) => 3 - 2 * Math.sign(y - 0.5 * Math.sin(3 * x))],
  'straight bank': ['2 + sign(x + y/2)', (x, y) => 2 + Math.sign(x + y / 2)],
  lake: ['2 + sign(1 - hypot(x, y))', (x, y) => 2 + Math.sign(1 - Math.hypot(x, y))],
  'two lakes': [
    '3 + sign(0.5 - hypot(x - 0.8, y)) + sign(0.6 - hypot(x + 0.7, y - 0.2))',
    (x, y) => 3 + Math.sign(0.5 - Math.hypot(x - 0.8, y)) + Math.sign(0.6 - Math.hypot(x + 0.7, y - 0.2)),
  ],
  'square lake': ['3 + 2*sign(0.8 - max(abs(x), abs(y)))', (x, y) => 3 + 2 * Math.sign(0.8 - Math.max(Math.abs(x), Math.abs(y)))],
  'triangular lake': [
    '2 + sign(min(y + 0.6, 0.8 - y - 1.2*abs(x)))',
    (x, y) => 2 + Math.sign(Math.min(y + 0.6, 0.8 - y - 1.2 * Math.abs(x))),
  ],
  'lake like a star': [
    '3 + 2*sign(0.9 + 0.3*cos(5*atan2(y, x)) - hypot(x, y))',
    (x, y) => 3 + 2 * Math.sign(0.9 + 0.3 * Math.cos(5 * Math.atan2(y, x)) - Math.hypot(x, y)),
  ],
  plateau: ['2 - sign(1 - hypot(x, y))', (x, y) => 2 - Math.sign(1 - Math.hypot(x, y))],
  'straight road': ['1.2 - sign(0.15 - abs(x - y))', (x, y) => 1.2 - Math.sign(0.15 - Math.abs(x - y))],
  'winding road': ['2 - sign(0.1 - abs(y - 0.3*sin(2x)))', (x, y) => 2 - Math.sign(0.1 - Math.abs(y - 0.3 * Math.sin(2 * x)))],
  river: ['2 + sign(0.3 - abs(y - 0.3*sin(2x)))', (x, y) => 2 + Math.sign(0.3 - Math.abs(y - 0.3 * Math.sin(2 * x)))],
  strips: ['2 + sign(sin(4x))', (x) => 2 + Math.sign(Math.sin(4 * x))],
  'tilted chessboard': ['2 + sign(sin(2x + y)*sin(2y - x))', (x, y) => 2 + Math.sign(Math.sin(2 * x + y) * Math.sin(2 * y - x))],
  'curved chessboard': [
    '3 + 2*sign(sin(2x + sin(y)/2)*sin(2y + x^2/4))',
    (x, y) => 3 + 2 * Math.sign(Math.sin(2 * x + Math.sin(y) / 2) * Math.sin(2 * y + (x * x) / 4)),
  ],
  'four fields': ['3 + sign(x + 0.2y) + 0.5*sign(y - 0.1x)', (x, y) => 3 + Math.sign(x + 0.2 * y) + 0.5 * Math.sign(y - 0.1 * x)],
  'three fields': ['2 + sign(x)*(1 + sign(y)/2)', (x, y) => 2 + Math.sign(x) * (1 + Math.sign(y) / 2)],
  'nook of a field': ['2 + max(sign(x), sign(y))', (x, y) => 2 + Math.max(Math.sign(x), Math.sign(y))],
  chessboard: ['2 + sign(sin(2x)*sin(2y))', (x, y) => 2 + Math.sign(Math.sin(2 * x) * Math.sin(2 * y))],
};

/** A path is longer than it need be if it is longer than what brute force found by this part. */
const LONGER = 0.01;

/**
 * Asks for random pairs on a plane whose density jumps, and judges the answers.
 * @param {import('../../../web/index.js').Surface} surface @param {Density} density the same @param {import('../../helpers/random.js').Random} random @param {number} pairs
 * @returns {import('./creases.js').Answer[]}
 */
export function askOnPlane(surface, density, random, pairs) {
  const search = bruteForce(density);
  const place = () => [random.between(-SIDE, SIDE), random.between(-SIDE, SIDE)];
  return Array.from({ length: pairs }, () => {
    const [from, to] = [place(), place()];
    const begin = performance.now();
    const { status, converged, length } = surface.shortestPath(from, to);
    const milliseconds = performance.now() - begin;
    const expected = search(from, to);
    const error = Math.max(0, length / expected - 1);
    const verdict = !converged ? 'refused' : error <= LONGER ? 'right' : 'longer';
    return { from, to, status, length, expected, error, verdict, milliseconds };
  });
}
