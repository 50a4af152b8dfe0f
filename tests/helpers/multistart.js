/**
 * Exhaustive multistart: the shortest of the paths that many different starts lead to. Independent of the solver's graph: on parametric surfaces a
 * start is a straight line to a lift of the end, or over random points; on implicit ones a shortest way over the edges of a mesh on which random balls
 * are expensive, so that ways of every homotopy class come up.
 */

/** @typedef {import('../../web/index.js').Surface} Surface */
/** @typedef {import('../../web/index.js').Path} Path */
/** @typedef {import('./random.js').Random} Random */
/** @typedef {{ to: number[], start: number[] }} Start */
/** @typedef {(from: number[], to: number[]) => Start} MakeStart */

const BALLS = 6;
const EXPENSIVE = 20;
const SMOOTHINGS = 30;
const START_POINTS = 97;

/** Straight lines to all lifts first, then lines over one or two random points. @param {Surface} surface @param {Random} random @returns {MakeStart} */
function linesOver(surface, random) {
  const domain = /** @type {NonNullable<Surface['domain']>} */ (surface.domain);
  const ranges = [domain.u, domain.v];
  const closed = [domain.periodic.u, domain.periodic.v];
  const lift = (/** @type {number[]} */ point) =>
    point.map((x, j) => (closed[j] ? x + (random.integer(3) - 1) * (ranges[j][1] - ranges[j][0]) : x));
  return (from, to) => {
    const end = lift(to);
    const over = Array.from({ length: random.integer(3) }, () => lift(ranges.map(([low, high]) => random.between(low, high))));
    return { to: end, start: [from, ...over, end].flat() };
  };
}

/** The edges of a mesh, both ways, by vertex. @param {Uint32Array} indices @param {number} count of vertices */
function neighboursOf(indices, count) {
  const first = new Uint32Array(count + 2);
  const each = (/** @type {(a: number, b: number) => void} */ visit) => {
    for (let i = 0; i < indices.length; i += 3) for (let k = 0; k < 3; k++) visit(indices[i + k], indices[i + ((k + 1) % 3)]);
  };
  each((a) => first[a + 2]++);
  for (let i = 2; i < first.length; i++) first[i] += first[i - 1];
  const to = new Uint32Array(indices.length);
  /* Each edge of a closed mesh is passed once each way. */
  each((a, b) => {
    to[first[a + 1]++] = b;
  });
  return { first, to };
}

/** Vertices nearest first. */
class Queue {
  /** @type {number[]} */ #keys = [];
  /** @type {number[]} */ #vertices = [];

  get isEmpty() {
    return this.#keys.length === 0;
  }

  /** @param {number} key @param {number} vertex */
  push(key, vertex) {
    let i = this.#keys.length;
    for (; i > 0; i = (i - 1) >> 1) {
      const parent = (i - 1) >> 1;
      if (this.#keys[parent] <= key) break;
      [this.#keys[i], this.#vertices[i]] = [this.#keys[parent], this.#vertices[parent]];
    }
    [this.#keys[i], this.#vertices[i]] = [key, vertex];
  }

  pop() {
    const nearest = { key: this.#keys[0], vertex: this.#vertices[0] };
    const [key, vertex] = [Number(this.#keys.pop()), Number(this.#vertices.pop())];
    const count = this.#keys.length;
    let i = 0;
    while (2 * i + 1 < count) {
      let child = 2 * i + 1;
      if (child + 1 < count && this.#keys[child + 1] < this.#keys[child]) child++;
      if (key <= this.#keys[child]) break;
      [this.#keys[i], this.#vertices[i]] = [this.#keys[child], this.#vertices[child]];
      i = child;
    }
    if (count > 0) [this.#keys[i], this.#vertices[i]] = [key, vertex];
    return nearest;
  }
}

/** Ways over the edges of a mesh with expensive balls. @param {import('../../web/index.js').Mesh} mesh @param {Random} random @returns {MakeStart} */
function waysOver({ positions, indices }, random) {
  const count = positions.length / 3;
  const { first, to: edges } = neighboursOf(indices, count);
  const apart = (/** @type {number} */ a, /** @type {number} */ b) =>
    Math.hypot(
      positions[3 * a] - positions[3 * b],
      positions[3 * a + 1] - positions[3 * b + 1],
      positions[3 * a + 2] - positions[3 * b + 2],
    );
  const at = (/** @type {number} */ i) => Array.from(positions.subarray(3 * i, 3 * i + 3));
  const nearest = (/** @type {number[]} */ [x, y, z]) => {
    let [best, least] = [0, Infinity];
    for (let i = 0; i < count; i++) {
      const away = (positions[3 * i] - x) ** 2 + (positions[3 * i + 1] - y) ** 2 + (positions[3 * i + 2] - z) ** 2;
      if (away < least) [best, least] = [i, away];
    }
    return best;
  };
  let size = 0;
  for (let i = 0; i < count; i += 17) size = Math.max(size, apart(0, i));
  return (from, to) => {
    const [begin, end] = [nearest(from), nearest(to)];
    const balls = Array.from({ length: random.integer(BALLS + 1) }, () => ({
      center: random.integer(count),
      radius: size * random.between(0.05, 0.4),
    }));
    const cost = Float64Array.from({ length: count }, (_, i) =>
      balls.some(({ center, radius }) => apart(i, center) < radius) ? EXPENSIVE : 1,
    );
    const distance = new Float64Array(count).fill(Infinity);
    const before = new Int32Array(count).fill(-1);
    const queue = new Queue();
    distance[begin] = 0;
    queue.push(0, begin);
    while (!queue.isEmpty) {
      const { key, vertex } = queue.pop();
      if (vertex === end) break;
      if (key > distance[vertex]) continue;
      for (let e = first[vertex]; e < first[vertex + 1]; e++) {
        const next = edges[e];
        const length = key + apart(vertex, next) * (cost[vertex] + cost[next]);
        if (length < distance[next]) {
          distance[next] = length;
          before[next] = vertex;
          queue.push(length, next);
        }
      }
    }
    const way = [];
    for (let i = end; i >= 0; i = before[i]) way.push(at(i));
    return { to, start: smoothed([from, ...way.reverse(), to]) };
  };
}

/** A polyline of evenly spread points, its corners rounded. @param {number[][]} way @returns {number[]} */
function smoothed(way) {
  const spread = Array.from({ length: START_POINTS }, (_, i) => {
    const at = (i / (START_POINTS - 1)) * (way.length - 1);
    const k = Math.min(Math.floor(at), way.length - 2);
    return way[k].map((x, c) => x + (at - k) * (way[k + 1][c] - x));
  });
  for (let sweep = 0; sweep < SMOOTHINGS; sweep++)
    for (let i = 1; i < START_POINTS - 1; i++) spread[i] = spread[i].map((x, c) => 0.5 * x + 0.25 * (spread[i - 1][c] + spread[i + 1][c]));
  return spread.flat();
}

/**
 * What makes random starts on a surface. @param {Surface} surface @param {Random} random @param {number} resolution of the mesh of an implicit surface
 * @returns {MakeStart}
 */
export function startMaker(surface, random, resolution) {
  return surface.domain ? linesOver(surface, random) : waysOver(surface.mesh({ resolution }), random);
}

/**
 * The shortest length that starts lead to: polylines first, the three that look shortest then to the tolerance; infinite without any.
 * @param {Surface} surface @param {MakeStart} make @param {number[]} from @param {number[]} to @param {{ starts: number, points: number }} effort
 */
export function multistart(surface, make, from, to, { starts, points }) {
  /** @type {{ path: Path, end: number[], estimate: number }[]} */
  const found = [];
  for (let k = 0; k < starts; k++) {
    const { to: end, start } = make(from, to);
    const path = surface.shortestPath(from, end, { algorithm: 'polyline', points, start });
    if (!path.converged && path.status !== 'ill-conditioned') continue;
    const estimate = path.length + path.lengthError;
    if (found.every((other) => Math.abs(other.estimate - estimate) > 1e-7 * estimate)) found.push({ path, end, estimate });
  }
  found.sort((a, b) => a.estimate - b.estimate);
  const exact = found.slice(0, 3).map(({ path, end }) => surface.shortestPath(from, end, { start: path }));
  return Math.min(...exact.filter(({ converged }) => converged).map(({ length }) => length));
}
