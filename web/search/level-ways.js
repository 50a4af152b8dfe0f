/**
 * Ways over a steep surface. Length there is little else than climb, and to go along a line of equal height costs next to nothing: the nodes around each band between two such lines are joined to
 * one another, and along a line to those across the bands beside it. MATH.md, "Steep surfaces". Knows nothing of the solver.
 */

import { countBelow, distance, edgeAt, TRIANGLES } from './levels.js';

/** @typedef {import('./levels.js').Levels} Levels */
/** @typedef {(node: number, length: number, left: number) => void} Visit what a node is joined to, how far that is, and where in the order of nodes the way leaves the node's line, if it follows it, or -1 */
/** @typedef {(node: number) => boolean} Open whether a way to a node may become shorter: how far it is need not be known else */

/** Between two lines a band is as good as flat: a node is joined across it to those so many crossings farther along, as long as that is not so many times as far as it is wide. */
const [ALONG, SLANT] = [[1, 2, 3, 4, 6, 8, 12, 16, 24, 32], 8];
/** Known ways are so many cells wide to each side, and count as much longer; what leads apart from them for this part of its length is another one. */
const [BESIDE, KNOWN, NEW] = [2, 1.1, 0.05];
/** Triangles around an edge by direction, and around a corner: cell and which of both. */
// biome-ignore format: a table
const AROUND = [
  [[0, 0, 0], [0, -1, 1]],
  [[0, 0, 1], [-1, 0, 0]],
  [[0, 0, 0], [0, 0, 1]],
  [[0, 0, 0], [0, 0, 1], [-1, 0, 0], [0, -1, 1], [-1, -1, 0], [-1, -1, 1]],
];

/** Nodes around the bands that a node is on. @param {Levels} net @param {number} node @param {Open} isOpen @param {Visit} visit */
function visitAround({ width, corners, points, lowest, highest, first, base, edgeOf }, node, isOpen, visit) {
  const edge = node < corners ? 3 * node : edgeOf[node - corners];
  const corner = Math.floor(edge / 3);
  const bottom = node < corners ? lowest[node] : base[edge] + node - first[edge];
  const top = node < corners ? highest[node] : bottom + 1;
  const around = AROUND[node < corners ? 3 : edge % 3];
  for (let t = 0; t < around.length; t++) {
    const cell = corner + around[t][0] + around[t][1] * width;
    if (cell < 0 || cell >= corners - width || cell % width === width - 1) continue;
    const triangle = TRIANGLES[around[t][2]];
    for (let k = 0; k < 3; k++) {
      const q = cell + triangle.corners[k][0] + triangle.corners[k][1] * width;
      if (lowest[q] <= top && highest[q] >= bottom && isOpen(q)) visit(q, distance(points, node, q), -1);
      const other = edgeAt(cell, width, triangle.edges[k]);
      const zero = first[other] - base[other];
      const last = Math.min(first[other + 1] - 1, zero + top);
      for (let n = Math.max(first[other], zero + bottom - 1); n <= last; n++) if (isOpen(n)) visit(n, distance(points, node, n), -1);
    }
  }
}

/** Nodes across the bands beside a crossing, along its line. @param {Levels} net @param {number} node @param {Open} isOpen @param {Visit} visit */
function visitAlong({ corners, points, order, line, along, rank, across, widths }, node, isOpen, visit) {
  const at = rank[node - corners];
  for (let way = -1; way <= 1; way += 2) {
    for (let step = 0, isNear = true; isNear && step < ALONG.length; step++) {
      const here = at + way * ALONG[step];
      if (line[here] !== line[at]) break;
      const [there, last] = [order[here], order[here - way]];
      const far = Math.abs(along[here] - along[at]);
      isNear = false;
      for (let side = 0; side < 2; side++) {
        const at = 2 * (there - corners) + side;
        const [other, wide] = [across[at], widths[at]];
        if (other < 0) continue;
        isNear ||= far < SLANT * wide;
        if (!isOpen(other)) continue;
        const chord = distance(points, there, last);
        let part = 0;
        for (let k = 0; k < 3; k++)
          part += ((points[3 * other + k] - points[3 * there + k]) * (points[3 * there + k] - points[3 * last + k])) / chord;
        visit(other, Math.sqrt((far + part) ** 2 + Math.max(0, wide * wide - part * part)), here);
      }
    }
  }
}

/** What is next: numbers by their keys, the least first. */
class Queue {
  /** @type {number[]} */ #keys = [];
  /** @type {number[]} */ #numbers = [];

  /** @param {number} key @param {number} number */
  put(key, number) {
    const [keys, numbers] = [this.#keys, this.#numbers];
    let at = keys.length;
    for (; at > 0 && keys[(at - 1) >> 1] > key; at = (at - 1) >> 1) {
      keys[at] = keys[(at - 1) >> 1];
      numbers[at] = numbers[(at - 1) >> 1];
    }
    keys[at] = key;
    numbers[at] = number;
  }

  /** @returns {number} -1: there is none */
  take() {
    const [keys, numbers] = [this.#keys, this.#numbers];
    if (keys.length === 0) return -1;
    const least = numbers[0];
    const [key, number] = [/** @type {number} */ (keys.pop()), /** @type {number} */ (numbers.pop())];
    if (keys.length === 0) return least;
    let at = 0;
    for (let child = 1; child < keys.length; child = 2 * at + 1) {
      if (child + 1 < keys.length && keys[child + 1] < keys[child]) child++;
      if (keys[child] >= key) break;
      keys[at] = keys[child];
      numbers[at] = numbers[child];
      at = child;
    }
    keys[at] = key;
    numbers[at] = number;
    return least;
  }
}

/** Ways between two places of a surface, one after the other. */
export class LevelNet {
  #net;
  /** 1 by number of a cell's first corner: a known way leads through it. */ #known;

  /** @param {Levels} net */
  constructor(net) {
    this.#net = net;
    this.#known = new Uint8Array(net.corners);
  }

  /** A line along which no other way is. @param {ArrayLike<number>} line u and v of its points, and more @param {number} size numbers a point */
  avoid(line, size) {
    const { us, vs, width } = this.#net;
    let [lastU, lastV] = [-1, -1];
    for (let i = 0; i < line.length; i += size) {
      const [u, v] = [countBelow(us, line[i], true) - 1, countBelow(vs, line[i + 1], true) - 1];
      const steps = lastU < 0 ? 1 : Math.max(Math.abs(u - lastU), Math.abs(v - lastV));
      for (let k = 1; k <= steps; k++) {
        const [i, j] = lastU < 0 ? [u, v] : [Math.round(lastU + (k / steps) * (u - lastU)), Math.round(lastV + (k / steps) * (v - lastV))];
        for (let row = Math.max(0, j - BESIDE); row <= Math.min(vs.length - 1, j + BESIDE); row++)
          this.#known.fill(1, row * width + Math.max(0, i - BESIDE), row * width + Math.min(width - 1, i + BESIDE) + 1);
      }
      [lastU, lastV] = [u, v];
    }
  }

  /**
   * The shortest way of which a part is apart from all that are known, if it is shorter than some length.
   * @param {number} most @returns {Float64Array | null} u, v and height of its points
   */
  find(most) {
    const net = this.#net;
    const { corners, points, edgeOf, from, to } = net;
    const count = points.length / 3;
    const known = new Uint8Array(count);
    known.set(this.#known);
    for (let i = 0; i < edgeOf.length; i++) known[corners + i] = this.#known[Math.floor(edgeOf[i] / 3)];
    const lengths = new Float64Array(count).fill(Infinity);
    const [before, left] = [new Int32Array(count).fill(-1), new Int32Array(count)];
    const done = new Uint8Array(count);
    const queue = new Queue();
    let node = from;
    /** @type {Visit} */
    const visit = (other, length, by) => {
      const so = lengths[node] + (known[node] && known[other] ? KNOWN * length : length);
      if (!(so < lengths[other])) return;
      const least = so + distance(points, other, to);
      if (least > most) return;
      lengths[other] = so;
      before[other] = node;
      left[other] = by;
      queue.put(least, other);
    };
    const isOpen = (/** @type {number} */ other) => lengths[other] > lengths[node];
    lengths[from] = 0;
    for (; node >= 0 && node !== to; node = queue.take()) {
      if (done[node]) continue;
      done[node] = 1;
      visitAround(net, node, isOpen, visit);
      if (node >= corners) visitAlong(net, node, isOpen, visit);
    }
    if (lengths[to] === Infinity) return null;
    let apart = 0;
    for (let other = to; other !== from; other = before[other]) if (!known[other]) apart += lengths[other] - lengths[before[other]];
    return apart <= NEW * lengths[to] ? null : this.#trace(before, left);
  }

  /** The points of a way, those along lines between. @param {Int32Array} before @param {Int32Array} left */
  #trace(before, left) {
    const { corners, places, points, from, to, order, along, rank } = this.#net;
    /** @type {number[]} */
    const way = [];
    const put = (/** @type {number} */ node, /** @type {number} */ height) => way.push(height, places[2 * node + 1], places[2 * node]);
    for (let node = to; node !== from; node = before[node]) {
      put(node, points[3 * node + 2]);
      if (left[node] < 0) continue;
      const last = before[node];
      const [start, end] = [rank[last - corners], left[node]];
      for (let k = end; k !== start; k += Math.sign(start - end)) {
        const part = (along[k] - along[start]) / (along[end] - along[start]);
        put(order[k], points[3 * last + 2] + part * (points[3 * node + 2] - points[3 * last + 2]));
      }
    }
    put(from, points[3 * from + 2]);
    return Float64Array.from(way.reverse());
  }
}
