/** Lines of equal height on a surface: a net of triangles that they cut into bands. Its nodes are corners, moved onto saddles where these are near, and where lines cross edges. Knows nothing of ways. */

/** @typedef {import('../manifold/rectangle.js').Range} Range */
/** @typedef {(places: ArrayLike<number>) => Float64Array} Positions x y z of places u v */
/** @typedef {(places: ArrayLike<number>) => Float64Array} Jets 18 numbers a place u v: S, S_u, S_v, S_uu, S_uv, S_vv */
/** @typedef {NonNullable<ReturnType<typeof makeNet>>} Net */
/** @typedef {NonNullable<ReturnType<typeof makeLevels>>} Levels */

/** Cells a direction; lines of equal height, between each and the next of which lie as many corners, and as many through saddles. */
const [CELLS, LEVELS] = [96, 48];
/** Around a saddle the land is now higher, now lower, so often at least. */
const TURNS = 4;
/** Where more of the cells than this part are in their middles higher, or lower, than at both ends of a diagonal, they are as wide as waves: of these a net knows nothing. */
const BEYOND = 0.45;
/** Newton steps to a saddle, which moves a corner by less than this part of a cell. */
const [SETTLING, FARTHEST] = [4, 0.4];
/** False positions and halvings, in turn, that put a crossing onto its line. */
const PLACING = 7;
const AT_ONCE = 2048;

/** Edges of a net by direction: what a corner's number grows by along them, in rows and columns. */
// biome-ignore format: a table
const STEPS = [[1, 0], [0, 1], [1, 1]];
/** Both triangles of a cell: corners, and edges (the third number is their direction), from the cell's first corner on. */
// biome-ignore format: a table
export const TRIANGLES = [
  { corners: [[0, 0], [1, 0], [1, 1]], edges: [[0, 0, 0], [1, 0, 1], [0, 0, 2]] },
  { corners: [[0, 0], [1, 1], [0, 1]], edges: [[0, 0, 2], [0, 1, 0], [0, 0, 1]] },
];

/** The number of an edge of a triangle. @param {number} cell its first corner @param {number} width @param {number[]} edge as TRIANGLES has it */
export const edgeAt = (cell, width, edge) => 3 * (cell + edge[0] + edge[1] * width) + edge[2];

/** How many of ascending numbers are less than one; with `orSame`, no larger. @param {ArrayLike<number>} numbers @param {number} x @param {boolean} orSame */
export function countBelow(numbers, x, orSame) {
  let [low, high] = [0, numbers.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (numbers[middle] < x || (orSame && numbers[middle] === x)) low = middle + 1;
    else high = middle;
  }
  return low;
}

/** Lines of the net in a direction: at all of these numbers, and evenly between. @param {number[]} knots */
function spread(knots) {
  const sorted = [...new Set(knots)].sort((a, b) => a - b);
  const width = (sorted[sorted.length - 1] - sorted[0]) / CELLS;
  return sorted.flatMap((to, i) => {
    const from = sorted[i - 1] ?? to;
    const parts = Math.max(1, Math.round((to - from) / width));
    return Array.from({ length: parts }, (_, k) => (k < parts - 1 ? from + ((k + 1) / parts) * (to - from) : to));
  });
}

/** So many of some numbers, evenly from the least to the largest; or all. @param {number[]} numbers */
function quantiles(numbers) {
  const sorted = Float64Array.from(numbers).sort();
  const count = Math.min(LEVELS, sorted.length);
  return Array.from({ length: count }, (_, k) => sorted[Math.round(((k + 0.5) / count) * (sorted.length - 1))]);
}

/** @param {Float64Array} points @param {number} a @param {number} b numbers of two of them */
export function distance(points, a, b) {
  const [x, y, z] = [points[3 * a] - points[3 * b], points[3 * a + 1] - points[3 * b + 1], points[3 * a + 2] - points[3 * b + 2]];
  return Math.sqrt(x * x + y * y + z * z);
}

/** Whether a line that is moved stays the one between its neighbours; on an edge of the range it does not move. @param {number[]} lines @param {number} i @param {number} x */
const isBeside = (lines, i, x) =>
  i === 0 ||
  i === lines.length - 1 ||
  (x > lines[i] - FARTHEST * (lines[i] - lines[i - 1]) && x < lines[i] + FARTHEST * (lines[i + 1] - lines[i]));

/**
 * Moves corners beside saddles onto them; on an edge of the range, along it, those that are highest or lowest there.
 * @param {Jets} jets @param {number[]} us @param {number[]} vs @param {Float64Array} grid places of the corners @param {Float64Array} seen points of them @param {number[]} fixed numbers of corners
 * @returns {number[]} numbers of these corners
 */
function moveToSaddles(jets, us, vs, grid, seen, fixed) {
  const width = us.length;
  const ring = [1, width + 1, width, -1, -width - 1, -width];
  const saddles = [];
  const isOnU = (/** @type {number} */ q) => q % width === 0 || q % width === width - 1;
  const isOnV = (/** @type {number} */ q) => q < width || q >= seen.length / 3 - width;
  for (let q = 0; q < seen.length / 3; q++) {
    if ((isOnU(q) && isOnV(q)) || fixed.includes(q)) continue;
    const isAbove = (/** @type {number} */ step) => seen[3 * (q + step) + 2] > seen[3 * q + 2];
    let turns = 0;
    if (isOnU(q)) turns = isAbove(width) === isAbove(-width) ? TURNS : 0;
    else if (isOnV(q)) turns = isAbove(1) === isAbove(-1) ? TURNS : 0;
    else for (let k = 0; k < 6; k++) if (isAbove(ring[k]) !== isAbove(ring[(k + 1) % 6])) turns++;
    if (turns >= TURNS) saddles.push(q);
  }
  for (let step = 0; step < SETTLING; step++) {
    const at = jets(saddles.flatMap((q) => [grid[2 * q], grid[2 * q + 1]]));
    saddles.forEach((q, k) => {
      const [onU, onV] = [isOnU(q), isOnV(q)];
      const [zu, zv, zuu, zuv, zvv] = [5, 8, 11, 14, 17].map((c) => at[18 * k + c]);
      const det = zuu * zvv - zuv * zuv;
      const u = grid[2 * q] + (onU ? 0 : onV ? -zu / zuu : (zuv * zv - zvv * zu) / det);
      const v = grid[2 * q + 1] + (onV ? 0 : onU ? -zv / zvv : (zuv * zu - zuu * zv) / det);
      if (isBeside(us, q % width, u) && isBeside(vs, Math.floor(q / width), v)) [grid[2 * q], grid[2 * q + 1]] = [u, v];
    });
  }
  return saddles;
}

/**
 * Puts crossings of edges and lines of equal height where they are, so many at a time as a processor has at hand.
 * @param {Positions} positions @param {Float64Array} places of corners, then of crossings, which are written @param {Float64Array} points the same
 * @param {{ edgeOf: Int32Array, ends: Int32Array, heights: Float64Array }} crossings the edge of each, the low and the high corner of each edge, and the height of each
 */
function placeCrossings(positions, places, points, { edgeOf, ends, heights }) {
  const corners = places.length / 2 - heights.length;
  /* Of each edge the part, and the height, of a place below and of one above. */
  const [below, above] = [new Float64Array(2 * AT_ONCE), new Float64Array(2 * AT_ONCE)];
  const parts = new Float64Array(AT_ONCE);
  for (let start = 0; start < heights.length; start += AT_ONCE) {
    const count = Math.min(AT_ONCE, heights.length - start);
    const cut = places.subarray(2 * (corners + start), 2 * (corners + start + count));
    for (let i = 0; i < count; i++) {
      [below[2 * i], above[2 * i]] = [0, 1];
      below[2 * i + 1] = points[3 * ends[2 * edgeOf[start + i]] + 2];
      above[2 * i + 1] = points[3 * ends[2 * edgeOf[start + i] + 1] + 2];
    }
    for (let step = 0; step < PLACING; step++) {
      for (let i = 0; i < count; i++) {
        const height = heights[start + i];
        const ratio = step % 2 ? 0.5 : (height - below[2 * i + 1]) / (above[2 * i + 1] - below[2 * i + 1]);
        parts[i] = below[2 * i] + ratio * (above[2 * i] - below[2 * i]);
        const edge = 2 * edgeOf[start + i];
        const [low, high] = [2 * ends[edge], 2 * ends[edge + 1]];
        cut[2 * i] = places[low] + parts[i] * (places[high] - places[low]);
        cut[2 * i + 1] = places[low + 1] + parts[i] * (places[high + 1] - places[low + 1]);
      }
      const seen = positions(cut);
      for (let i = 0; i < count; i++) {
        const side = seen[3 * i + 2] <= heights[start + i] ? below : above;
        side[2 * i] = parts[i];
        side[2 * i + 1] = seen[3 * i + 2];
      }
      if (step === PLACING - 1) points.set(seen, 3 * (corners + start));
    }
  }
}

/**
 * Whether the surface has waves between the corners of cells that these do not see.
 * @param {Positions} positions @param {Float64Array} grid places of the corners @param {Float64Array} seen points of them @param {number} next from the first corner of a cell to the last
 */
function isBlind(positions, grid, seen, next) {
  const middles = positions(grid.map((x, i) => (x + grid[i + 2 * next]) / 2).subarray(0, -2 * next));
  let beyond = 0;
  for (let i = 2; i < middles.length; i += 3) beyond += Number((middles[i] - seen[i]) * (middles[i] - seen[i + 3 * next]) > 0);
  return 3 * beyond > BEYOND * middles.length;
}

/**
 * The net; null: the surface has no height somewhere, or waves too short for it. Its nodes: corners, row by row, then crossings, edge by edge and upwards. Edge 3q + k leads from corner q in direction k.
 * @param {Positions} positions @param {Jets} jets @param {Range} range @param {number[][]} asked ends of the path
 */
function makeNet(positions, jets, { lower, upper }, asked) {
  const [us, vs] = [0, 1].map((j) => spread([lower[j], upper[j], asked[0][j], asked[1][j]]));
  const width = us.length;
  const corners = width * vs.length;
  const grid = new Float64Array(2 * corners);
  for (let q = 0; q < corners; q++) [grid[2 * q], grid[2 * q + 1]] = [us[q % width], vs[Math.floor(q / width)]];
  const [from, to] = asked.map(([u, v]) => us.indexOf(u) + width * vs.indexOf(v));
  const saddles = moveToSaddles(jets, us, vs, grid, positions(grid), [from, to]);
  const seen = positions(grid);
  const heights = Array.from({ length: corners }, (_, q) => seen[3 * q + 2]);
  if (!heights.every(Number.isFinite) || isBlind(positions, grid, seen, width + 1)) return null;
  const levels = Float64Array.from(
    new Set([heights[from], heights[to], ...quantiles(heights), ...quantiles(saddles.map((q) => heights[q]))]),
  ).sort();
  /* Band k lies below level k. A corner on a level is in two. */
  const [lowest, highest] = [false, true].map((orSame) => Int32Array.from(heights.map((z) => countBelow(levels, z, orSame))));
  const first = new Int32Array(3 * corners + 1);
  /* Of each edge the level of its first crossing. */
  const base = new Int32Array(3 * corners);
  const ends = new Int32Array(6 * corners);
  for (let edge = 0; edge < 3 * corners; edge++) {
    const q = Math.floor(edge / 3);
    const step = STEPS[edge % 3];
    const other = q % width < width - step[0] && q < corners - step[1] * width ? q + step[0] + step[1] * width : q;
    const low = heights[other] < heights[q] ? other : q;
    const high = other + q - low;
    ends[2 * edge] = low;
    ends[2 * edge + 1] = high;
    base[edge] = highest[low];
    first[edge + 1] = first[edge] + Math.max(0, lowest[high] - highest[low]);
  }
  const count = first[3 * corners];
  const edgeOf = new Int32Array(count);
  const goals = new Float64Array(count);
  for (let edge = 0; edge < 3 * corners; edge++) {
    for (let i = first[edge]; i < first[edge + 1]; i++) {
      edgeOf[i] = edge;
      goals[i] = levels[base[edge] + i - first[edge]];
    }
    first[edge] += corners;
  }
  first[3 * corners] += corners;
  const places = new Float64Array(2 * (corners + count));
  const points = new Float64Array(3 * (corners + count));
  places.set(grid);
  points.set(seen);
  placeCrossings(positions, places, points, { edgeOf, ends, heights: goals });
  return { us, vs, width, corners, from, to, places, points, lowest, highest, first, base, edgeOf };
}

/** What lines are found from. @typedef {Pick<Net, 'corners' | 'width' | 'first' | 'base' | 'points'>} Crossed */

/**
 * Visits all pairs of crossings on edges of one triangle.
 * @param {Crossed} net @param {0 | 1} above 1: the second one's line is the next above the first one's; 0: they are on one line, and each edge is taken with the next
 * @param {(one: number, other: number) => void} visit
 */
function visitPairs({ corners, width, first, base }, above, visit) {
  for (let cell = 0; cell < corners - width; cell++) {
    if (cell % width === width - 1) continue;
    for (const { edges } of TRIANGLES) {
      for (let k = 0; k < (above ? 9 : 3); k++) {
        const one = edgeAt(cell, width, edges[k % 3]);
        const other = edgeAt(cell, width, edges[above ? Math.floor(k / 3) : (k + 1) % 3]);
        /* Crossing n of the one, and what is that of the other. */
        const shift = base[one] + above - base[other];
        const last = Math.min(first[one + 1] - first[one], first[other + 1] - first[other] - shift);
        for (let n = Math.max(0, -shift); n < last; n++) visit(first[one] + n, first[other] + n + shift);
      }
    }
  }
}

/** Of each crossing those on the lines below and above it, in a triangle with it, that are nearest, or -1, and how far these are. @param {Crossed} net */
function findAcross(net) {
  const { corners, points } = net;
  const across = new Int32Array(2 * (points.length / 3 - corners)).fill(-1);
  const widths = new Float64Array(across.length).fill(Infinity);
  const offer = (/** @type {number} */ at, /** @type {number} */ other) => {
    const far = distance(points, corners + (at >> 1), other);
    if (far < widths[at]) [widths[at], across[at]] = [far, other];
  };
  visitPairs(net, 1, (lower, upper) => {
    offer(2 * (lower - corners) + 1, upper);
    offer(2 * (upper - corners), lower);
  });
  return { across, widths };
}

/**
 * Lines of equal height: nodes in the order in which they follow each other, the line of each, how far along it that is, where in this order a crossing is, and what is across from it, how far.
 * @param {Crossed} net
 */
function findLines(net) {
  const { corners, points } = net;
  const count = points.length / 3 - corners;
  /* Both neighbours of each. A line leaves a triangle by the one of its other edges which it crosses. */
  const links = new Int32Array(2 * count).fill(-1);
  const link = (/** @type {number} */ a, /** @type {number} */ b) => {
    links[2 * (a - corners) + Number(links[2 * (a - corners)] >= 0)] = b;
  };
  visitPairs(net, 0, (one, other) => {
    link(one, other);
    link(other, one);
  });
  const [order, line, along] = [new Int32Array(count), new Int32Array(count), new Float64Array(count)];
  const rank = new Int32Array(count).fill(-1);
  let at = 0;
  const follow = (/** @type {number} */ start) => {
    for (let node = start, last = -1; node >= 0 && rank[node - corners] < 0; at++) {
      order[at] = node;
      line[at] = start;
      along[at] = last < 0 ? 0 : along[at - 1] + distance(points, node, last);
      rank[node - corners] = at;
      const next = links[2 * (node - corners)];
      [node, last] = [next === last ? links[2 * (node - corners) + 1] : next, node];
    }
  };
  /* From ends first; what is left is closed. */
  for (const most of [0, Infinity]) for (let i = 0; i < count; i++) if (rank[i] < 0 && links[2 * i + 1] < most) follow(corners + i);
  return { order, line, along, rank, ...findAcross(net) };
}

/**
 * The net of a surface, with both ends among its corners and their heights among its lines; null: it has no height somewhere, or waves too short for a net.
 * @param {Positions} positions @param {Jets} jets @param {Range} range @param {number[][]} ends
 */
export function makeLevels(positions, jets, range, ends) {
  const net = makeNet(positions, jets, range, ends);
  return net && { ...net, ...findLines(net) };
}
