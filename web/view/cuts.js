/** Meshes of formulas, cut along the rim of where these have a value and where they jump. Else the rim is a saw of whole triangles, and a jump a wall. */

/** @typedef {import('./drawable.js').SurfaceMesh} SurfaceMesh */
/** @typedef {(places: Float64Array) => Float64Array} Evaluate position and normal at each u v */
/** @typedef {{ count: number, places: Float64Array, values: Float64Array }} Table of vertices: u v; position and normal */

/** How much longer than half of the edges one is that may leap; and up to where a rim is followed: beside a pole it is infinitely far. */
const [LONG, FARTHEST] = [2.5, 200];
/** One of so many edges tells how long they are. */
const SOME = 7;
const HALVINGS = 20;
/** Where an edge is halved, as in the very middle there may be a pole; and what stays of its length, at least, where something jumps. */
const [MIDDLE, LEAP] = [0.493, 0.3];
/** Coordinates beyond are not drawn: their squares, and products with those, are too large for 32 bits, and keep some machines busy for minutes. */
export const LARGEST = 1e18;

/** What is true of a vertex: no edge at it is cut, some are, it cannot be drawn. */
const [WHOLE, CUT, NONE] = [0, 1, 2];

/** Whether a vertex can be drawn. @param {Float64Array} values @param {number} i */
function isGood(values, i) {
  for (let k = 6 * i; k < 6 * i + 6; k++) if (!(Math.abs(values[k]) <= LARGEST)) return false;
  return true;
}

/** Between two vertices. @param {Float64Array} a @param {number} i @param {Float64Array} b @param {number} j */
function gap(a, i, b, j) {
  const [x, y, z] = [a[6 * i] - b[6 * j], a[6 * i + 1] - b[6 * j + 1], a[6 * i + 2] - b[6 * j + 2]];
  return Math.sqrt(x * x + y * y + z * z);
}

/** @param {Table} table @param {number} to @param {Table} source @param {number} from */
function copy({ places, values }, to, source, from) {
  for (let k = 0; k < 2; k++) places[2 * to + k] = source.places[2 * from + k];
  for (let k = 0; k < 6; k++) values[6 * to + k] = source.values[6 * from + k];
}

/** @param {number} count @returns {Table} */
const tableOf = (count) => ({ count, places: new Float64Array(2 * count), values: new Float64Array(6 * count) });

/**
 * @param {SurfaceMesh} mesh of a rectangle @param {Evaluate} evaluate
 * @returns {SurfaceMesh} the same vertices, then twins of some of them
 */
export function cutMesh(mesh, evaluate) {
  const { positions, normals, indices } = mesh;
  const count = positions.length / 3;
  const table = { count, places: /** @type {Float64Array} */ (mesh.parameters), values: new Float64Array(6 * count) };
  for (let i = 0; i < positions.length; i++) {
    const at = 2 * i - (i % 3);
    [table.values[at], table.values[at + 3]] = [positions[i], normals[i]];
  }
  const marks = Uint8Array.from({ length: count }, (_, i) => (isGood(table.values, i) ? WHOLE : NONE));
  const { ends, usual } = longEdges(table.values, marks, indices);
  const sides = tableOf(ends.length);
  for (const [i, vertex] of ends.entries()) copy(sides, i, table, vertex);
  const leaps = findLeaps(sides, evaluate, FARTHEST * usual);
  /** The vertex on an edge where it is cut, on the side of the first end. @type {Map<number, number>} */ const cuts = new Map();
  /** @type {number[]} */ const added = [];
  for (const side of leaps) {
    const [vertex, other] = [ends[side], ends[side ^ 1]];
    marks[vertex] = CUT;
    // Where an edge leaps twice, what lies between is not on either side.
    const away = gap(table.values, vertex, sides.values, side);
    const isFar = away > FARTHEST * usual || away >= gap(sides.values, side, sides.values, side ^ 1);
    cuts.set(vertex * count + other, isFar ? vertex : count + added.length);
    if (!isFar) added.push(side);
  }
  if (cuts.size === 0) return mesh;
  const extended = (/** @type {Float64Array} */ list, /** @type {Float64Array} */ source, stride = 6, first = 0, size = 3) => {
    const longer = new Float64Array(list.length + size * added.length);
    longer.set(list);
    for (const [i, side] of added.entries()) longer.set(source.subarray(stride * side + first).subarray(0, size), list.length + size * i);
    return longer;
  };
  return {
    positions: extended(positions, sides.values),
    normals: extended(normals, sides.values, 6, 3),
    parameters: extended(table.places, sides.places, 2, 0, 2),
    indices: cutTriangles(indices, marks, (from, to) => cuts.get(from * count + to)),
    twins: added.map((side) => ends[side]),
  };
}

/** Edges that may leave what can be drawn, or leap: both ends of each, the first of which can be drawn; and how long half of all edges are at least. @param {Float64Array} values @param {Uint8Array} marks @param {Uint32Array} indices */
function longEdges(values, marks, indices) {
  const after = (/** @type {number} */ i) => indices[i % 3 === 2 ? i - 2 : i + 1];
  const lengths = Float64Array.from({ length: indices.length }, (_, i) => gap(values, indices[i], values, after(i)));
  const sorted = lengths.filter((x, i) => i % SOME === 0 && Number.isFinite(x)).sort();
  const usual = sorted[sorted.length >> 1];
  /** @type {Set<number>} */ const known = new Set();
  /** @type {number[]} */ const ends = [];
  for (let i = 0; i < lengths.length; i++) {
    const [one, other] = [indices[i], after(i)];
    if (marks[one] === marks[other] && (marks[one] === NONE || lengths[i] <= LONG * usual)) continue;
    const key = Math.min(one, other) * marks.length + Math.max(one, other);
    if (!known.has(key)) ends.push(...(marks[one] === NONE ? [other, one] : [one, other]));
    known.add(key);
  }
  return { ends, usual };
}

/**
 * Halves edges until their ends are beside what leaps. @param {Table} sides both ends of each edge, which are moved there @param {Evaluate} evaluate @param {number} farthest
 * @returns {number[]} the ends beside a leap that can be drawn
 */
function findLeaps(sides, evaluate, farthest) {
  const { count, places, values } = sides;
  const first = values.slice();
  const isRim = (/** @type {number} */ far) => !isGood(first, far);
  let open = Array.from({ length: count / 2 }, (_, i) => 2 * i);
  for (let i = 0; i < HALVINGS && open.length > 0; i++) {
    const middle = tableOf(open.length);
    for (const [at, near] of open.entries())
      for (const k of [0, 1]) middle.places[2 * at + k] = places[2 * near + k] + MIDDLE * (places[2 * near + 2 + k] - places[2 * near + k]);
    middle.values = evaluate(middle.places);
    open = open.filter((near, at) => {
      const isThere = isGood(middle.values, at);
      const isNearer = isRim(near + 1)
        ? isThere && gap(first, near, middle.values, at) <= farthest
        : gap(values, near, middle.values, at) < gap(values, near + 1, middle.values, at);
      copy(sides, isNearer ? near : near + 1, middle, at);
      return isRim(near + 1) || (isThere && gap(values, near, values, near + 1) > LEAP * gap(first, near, first, near + 1));
    });
  }
  return open.flatMap((near) => (isRim(near + 1) ? [near] : [near, near + 1]));
}

/** Triangles without what lies beyond cuts. @param {Uint32Array} indices @param {Uint8Array} marks @param {(from: number, to: number) => number | undefined} cutOf */
function cutTriangles(indices, marks, cutOf) {
  /** @type {number[]} */ const result = [];
  for (let i = 0; i < indices.length; i++) {
    const start = i - (i % 3);
    const [corner, next, last] = [indices[i], indices[start + ((i + 1) % 3)], indices[start + ((i + 2) % 3)]];
    if (marks[corner] + marks[next] + marks[last] === WHOLE) result.push(corner);
    if (marks[corner] + marks[next] + marks[last] === WHOLE || marks[corner] === NONE) continue;
    const [ahead, behind, across] = [cutOf(corner, next), cutOf(corner, last), cutOf(next, last)];
    if (ahead !== undefined && behind !== undefined) result.push(corner, ahead, behind);
    else if (ahead !== undefined || marks[next] === NONE) continue;
    else if (behind !== undefined && across !== undefined) result.push(corner, next, across, corner, across, behind);
    // Whole; or with one cut, which ends inside.
    else if (marks[last] !== NONE && (behind !== undefined || (across === undefined && i === start))) result.push(corner, next, last);
  }
  return Uint32Array.from(result);
}
