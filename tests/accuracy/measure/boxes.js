// Bodies of boxes, and how long shortest paths on them are: exactly, by unfolding faces around all corners that a path may turn at. Knows nothing of the library.

/** @typedef {[number, number][]} Box its ranges of x, y and z */
/** @typedef {{ face: number, place: number[] }} Spot */
/** @typedef {{ corners: number[][], faces: number[][] }} Net triangles, counter-clockwise from outside */

/** @param {number[]} ends x, y and z from and to @returns {Box} */
const box = (...ends) => [0, 2, 4].map((k) => /** @type {[number, number]} */ ([ends[k], ends[k + 1]]));

/** Boxes overlap, or the surface would have walls inside. @type {Record<string, Box[]>} */
export const BODIES = {
  angle: [box(-1, 1, -1, 0, -0.5, 0.5), box(-1, 0, -1, 1, -0.5, 0.5)],
  cross: [box(-1.2, 1.2, -0.4, 0.4, -0.4, 0.4), box(-0.4, 0.4, -1.2, 1.2, -0.4, 0.4), box(-0.4, 0.4, -0.4, 0.4, -1.2, 1.2)],
  channel: [box(-1, 1, -0.5, 0.5, -1, -0.4), box(-1, -0.5, -0.5, 0.5, -1, 1), box(0.5, 1, -0.5, 0.5, -1, 1)],
  frame: [box(-1, 1, -1, -0.5, -0.3, 0.3), box(-1, 1, 0.5, 1, -0.3, 0.3), box(-1, -0.5, -1, 1, -0.3, 0.3), box(0.5, 1, -1, 1, -0.3, 0.3)],
  stairs: [box(-1, 1, -1, 1, -1, -0.4), box(-1, 0.3, -1, 1, -1, 0.2), box(-1, -0.4, -1, 1, -1, 0.8)],
  table: [box(-1, 1, -1, 1, 0.5, 0.8), ...[-0.9, 0.6].flatMap((x) => [-0.9, 0.6].map((y) => box(x, x + 0.3, y, y + 0.3, -1, 0.65)))],
  tee: [box(-1, 1, -0.4, 0.4, 0.4, 1), box(-0.3, 0.3, -0.4, 0.4, -1, 0.7)],
  towers: [box(-1, 1, -1, 1, -0.5, 0), box(-1, 0.1, -1, 0.1, -0.5, 0.6), box(-0.1, 1, -0.1, 1, -0.5, 0.3)],
  notch: [box(-1, 1, -1, 1, -1, 0.2), box(-1, 1, -1, -0.3, -1, 0.9), box(-1, 1, 0.3, 1, -1, 0.9)],
  cubes: [box(-1, 0.3, -1, 0.3, -1, 0.3), box(-0.2, 1, -0.2, 1, -0.2, 1)],
};

/** The formula that is 0 on the surface of boxes. @param {Box[]} boxes */
export const formulaOf = (boxes) =>
  boxes
    .map((ranges) => `max(${ranges.map(([low, high], k) => `abs(${'xyz'[k]} - ${(low + high) / 2}) - ${(high - low) / 2}`).join(', ')})`)
    .reduce((one, other) => `min(${one}, ${other})`);

/** The surface of boxes, in triangles that meet along whole edges. @param {Box[]} boxes @returns {Net} */
export function netOf(boxes) {
  const cuts = [0, 1, 2].map((k) => [...new Set(boxes.flatMap((ranges) => ranges[k]))].sort((a, b) => a - b));
  const isInside = (/** @type {number[]} */ cell) => {
    const middle = cell.map((i, k) => (cuts[k][i] + cuts[k][i + 1]) / 2);
    return boxes.some((ranges) => ranges.every(([low, high], k) => middle[k] > low && middle[k] < high));
  };
  /** @type {Map<string, number>} */
  const known = new Map();
  /** @type {Net} */
  const net = { corners: [], faces: [] };
  const cornerAt = (/** @type {number[]} */ place) => {
    const key = place.join();
    if (!known.has(key)) known.set(key, net.corners.push(place) - 1);
    return /** @type {number} */ (known.get(key));
  };
  for (let i = -1; i < cuts[0].length; i++)
    for (let j = -1; j < cuts[1].length; j++)
      for (let k = -1; k < cuts[2].length; k++)
        for (const axis of [0, 1, 2]) {
          const [cell, next] = [[i, j, k], [i, j, k].map((x, d) => x + Number(d === axis))];
          if (isInside(cell) === isInside(next)) continue;
          const [p, q] = [(axis + 1) % 3, (axis + 2) % 3];
          const [a, b, c, d] = [
            [0, 0],
            [1, 0],
            [1, 1],
            [0, 1],
          ].map(([s, t]) => {
            const place = [0, 0, 0];
            place[axis] = cuts[axis][next[axis]];
            place[p] = cuts[p][cell[p] + s];
            place[q] = cuts[q][cell[q] + t];
            return cornerAt(place);
          });
          net.faces.push(
            ...(isInside(cell)
              ? [
                  [a, b, c],
                  [a, c, d],
                ]
              : [
                  [c, b, a],
                  [d, c, a],
                ]),
          );
        }
  return net;
}

const minus = (/** @type {number[]} */ a, /** @type {number[]} */ b) => a.map((x, k) => x - b[k]);
const size = (/** @type {number[]} */ a) => Math.sqrt(a.reduce((sum, x) => sum + x * x, 0));
const turn = (/** @type {number[]} */ a, /** @type {number[]} */ b) => a[0] * b[1] - a[1] * b[0];

/** Shortest ways on a surface of triangles. */
export class Ways {
  /** @param {Net} net */
  constructor(net) {
    this.net = net;
    /** Which face has an edge, by its corners in order. @type {Map<string, number>} */
    this.faceAt = new Map(net.faces.flatMap((face, f) => face.map((a, k) => /** @type {const} */ ([`${a} ${face[(k + 1) % 3]}`, f]))));
    this.edges = net.faces.map((face) => face.map((a, k) => [a, face[(k + 1) % 3]]));
    this.saddles = net.corners.map((_, corner) => this.#angleAround(corner) > 2 * Math.PI + 1e-9);
    this.turning = [...this.saddles.keys()].filter((corner) => this.saddles[corner]);
    /** Straight lengths between corners at which paths may turn. */
    this.between = this.turning.map((corner) =>
      this.#look(
        corner,
        net.faces.flatMap((face, f) => (face.includes(corner) ? [f] : [])),
        null,
      ),
    );
  }

  /** @param {number} corner */
  #angleAround(corner) {
    const { corners, faces } = this.net;
    const angles = faces
      .filter((face) => face.includes(corner))
      .map((face) => {
        const [a, b] = face.filter((other) => other !== corner).map((other) => minus(corners[other], corners[corner]));
        return Math.acos(a.reduce((sum, x, k) => sum + x * b[k], 0) / size(a) / size(b));
      });
    return angles.reduce((sum, x) => sum + x, 0);
  }

  /** A place at random, faces by their areas. @param {{ next: () => number }} random @returns {Spot} */
  pick(random) {
    const { corners, faces } = this.net;
    const sides = (/** @type {number[]} */ [a, b, c]) => [minus(corners[b], corners[a]), minus(corners[c], corners[a])];
    const areas = faces.map((face) => {
      const [p, q] = sides(face);
      return size([p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]]);
    });
    let rest = random.next() * areas.reduce((sum, x) => sum + x, 0);
    let face = 0;
    while (rest > areas[face]) rest -= areas[face++];
    const [s, t] = [random.next(), random.next()];
    const [p, q] = sides(faces[face]);
    const [u, v] = s + t > 1 ? [1 - s, 1 - t] : [s, t];
    return { face, place: corners[faces[face][0]].map((x, k) => x + u * p[k] + v * q[k]) };
  }

  /** Two places on faces around a corner at which paths may turn, as far from it as these reach, to a hundredth of that. @param {import('../../helpers/random.js').Random} random */
  pickAround(random) {
    const { corners, faces } = this.net;
    const corner = this.turning[Math.floor(random.next() * this.turning.length)];
    const around = [...faces.keys()].filter((face) => faces[face].includes(corner));
    return [0, 1].map(() => {
      const face = around[Math.floor(random.next() * around.length)];
      const [p, q] = faces[face].filter((other) => other !== corner).map((other) => minus(corners[other], corners[corner]));
      const [s, t, reach] = [random.next(), random.next(), 10 ** (-2 * random.next())];
      const [u, v] = s + t > 1 ? [1 - s, 1 - t] : [s, t];
      return { face, place: corners[corner].map((x, k) => x + reach * (u * p[k] + v * q[k])) };
    });
  }

  /** How long the shortest way is. @param {Spot} from @param {Spot} to */
  length(from, to) {
    const [here, there] = [this.#look(from.place, [from.face], to), this.#look(to.place, [to.face], null)];
    /* Dijkstra's algorithm over the corners that a way may turn at. */
    const distance = this.turning.map((corner) => here.corners.get(corner) ?? Infinity);
    const open = new Set(distance.keys());
    let best = here.target;
    while (open.size > 0) {
      const next = [...open].reduce((a, b) => (distance[a] <= distance[b] ? a : b));
      open.delete(next);
      best = Math.min(best, distance[next] + (there.corners.get(this.turning[next]) ?? Infinity));
      for (const k of open)
        distance[k] = Math.min(distance[k], distance[next] + (this.between[next].corners.get(this.turning[k]) ?? Infinity));
    }
    return best;
  }

  /**
   * What is seen straight along the surface from a place in these faces, or a corner of them: corners at which paths may turn, and a target, each at its least distance.
   * @param {number[] | number} origin @param {number[]} faces @param {Spot | null} target
   */
  #look(origin, faces, target) {
    const { net } = this;
    const place = typeof origin === 'number' ? net.corners[origin] : origin;
    const seen = { corners: /** @type {Map<number, number>} */ (new Map()), target: Infinity };
    const note = (/** @type {number} */ corner, /** @type {number} */ away) => {
      if (this.saddles[corner]) seen.corners.set(corner, Math.min(away, seen.corners.get(corner) ?? Infinity));
    };
    for (const first of faces) {
      if (target?.face === first) seen.target = Math.min(seen.target, size(minus(target.place, place)));
      for (const corner of net.faces[first]) if (corner !== origin) note(corner, size(minus(net.corners[corner], place)));
      for (const [a, b] of this.edges[first]) {
        if (a === origin || b === origin) continue;
        /* In the plane the place is the origin. */
        const [p, q] = [minus(net.corners[a], place), minus(net.corners[b], place)];
        const along = size(minus(q, p));
        const x = p.reduce((sum, of, k) => sum + of * (q[k] - p[k]), 0) / along;
        const y = -Math.sqrt(Math.max(0, size(p) ** 2 - x * x));
        const [left, right] = [
          [x, y],
          [x + along, y],
        ];
        if (y < 0) this.#pass({ a, b, left, right, low: left, high: right, visited: [first] }, target, note, seen);
      }
    }
    return seen;
  }

  /** Through an edge, unfolded, into the face beyond, as far as is seen. @param {any} window @param {Spot | null} target @param {(corner: number, away: number) => void} note @param {{ target: number }} seen */
  #pass({ a, b, left, right, low, high, visited }, target, note, seen) {
    const { net, faceAt } = this;
    const face = faceAt.get(`${b} ${a}`);
    /* A shortest way comes to a face once. */
    if (face === undefined || visited.includes(face)) return;
    const along = minus(right, left).map((x) => x / size(minus(right, left)));
    const out = [along[1], -along[0]];
    const unfold = (/** @type {number[]} */ place) => {
      const [p, q] = [minus(place, net.corners[a]), minus(net.corners[b], net.corners[a])];
      const x = p.reduce((sum, of, k) => sum + of * q[k], 0) / size(q);
      const y = Math.sqrt(Math.max(0, size(p) ** 2 - x * x));
      return left.map((/** @type {number} */ of, /** @type {number} */ k) => of + x * along[k] + y * out[k]);
    };
    const isSeen = (/** @type {number[]} */ at) => turn(low, at) >= -1e-12 && turn(at, high) >= -1e-12;
    if (target?.face === face) {
      const at = unfold(target.place);
      if (isSeen(at)) seen.target = Math.min(seen.target, size(at));
    }
    const corner = /** @type {number} */ (net.faces[face].find((other) => other !== a && other !== b));
    const apex = unfold(net.corners[corner]);
    if (isSeen(apex)) note(corner, size(apex));
    const next = [...visited, face];
    if (turn(low, apex) > 0)
      this.#pass({ a, b: corner, left, right: apex, low, high: turn(apex, high) > 0 ? apex : high, visited: next }, target, note, seen);
    if (turn(apex, high) > 0)
      this.#pass({ a: corner, b, left: apex, right, low: turn(low, apex) > 0 ? apex : low, high, visited: next }, target, note, seen);
  }
}

/** A body of boxes at random, each overlapping one before it. @param {import('../../helpers/random.js').Random} random @returns {Box[]} */
export function randomBoxes(random) {
  /** @type {Box[]} */
  const boxes = [];
  const count = 2 + Math.floor(random.next() * 3);
  while (boxes.length < count) {
    const ranges = [0, 1, 2].map(() => {
      const [a, b] = [random.between(-1, 1), random.between(-1, 1)].sort((x, y) => x - y);
      return /** @type {[number, number]} */ ([a, Math.max(b, a + 0.3)]);
    });
    const overlaps = (/** @type {Box} */ other) =>
      other.every(([low, high], k) => Math.min(high, ranges[k][1]) - Math.max(low, ranges[k][0]) > 0.1);
    if (boxes.length === 0 || boxes.some(overlaps)) boxes.push(ranges);
  }
  return boxes;
}

/** Ends at random, and what the shortest path between them is found to be. @typedef {{ from: number[], to: number[], exact: number, path: import('../../../web/path.js').Path, milliseconds: number }} Answer */

/**
 * Paths between random places on bodies of boxes.
 * @param {import('../../../web/instance.js').Surfpath} surfpath @param {Box[]} boxes @param {import('../../helpers/random.js').Random} random @param {number} pairs @param {boolean} [isAround] both around one corner at which paths may turn @returns {Answer[]}
 */
export function askOnBoxes(surfpath, boxes, random, pairs, isAround = false) {
  const ways = new Ways(netOf(boxes));
  const cuts = boxes.flat(2);
  const side = /** @type {[number, number]} */ ([Math.min(...cuts) - 0.25, Math.max(...cuts) + 0.25]);
  const surface = surfpath.surface({ kind: 'implicit', f: formulaOf(boxes), bounds: [side, side, side] });
  const answers = Array.from({ length: pairs }, () => {
    const [from, to] = isAround ? ways.pickAround(random) : [ways.pick(random), ways.pick(random)];
    const start = performance.now();
    const path = surface.shortestPath(from.place, to.place);
    const milliseconds = performance.now() - start;
    return { from: from.place, to: to.place, exact: ways.length(from, to), path, milliseconds };
  });
  surface.dispose();
  return answers;
}
