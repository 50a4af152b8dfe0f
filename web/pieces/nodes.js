/** Nodes of an implicit surface: points where ∇f = 0, and sheets meet as the halves of a double cone do, or two cusps; what of the surface hangs together without them, and where it crosses itself. */

import { ahead, scaled } from '../creases/linear.js';
import { gridOf } from '../manifold/extent.js';
import { diagonalOf, distancesFrom, dot, gap, largest as largestOf, listOf, minus, norm, unit } from '../vector.js';
import {
  cofactors,
  crossingsFrom,
  formOf,
  isSaddle,
  jetOf,
  longest,
  planeOf,
  SINGULAR,
  STEPS,
  step,
  times,
  walkFrom,
  walkOn,
} from './singular.js';

/** @typedef {import('../path.js').Path} Path */
/** @typedef {import('./singular.js').Crossing} Crossing */
/** @typedef {import('./singular.js').Jets} Jets */

/**
 * @typedef {object} Node
 * @property {number[]} at x y z
 * @property {number[]} second the second derivatives of f: xx xy xz yy yz zz
 * @property {number} determinant of these
 * @property {boolean} isFlat the determinant is zero: derivatives of higher order tell how sheets meet, as those of two cusps, or of two bowls that touch
 * @property {number[][]} [axes] if so: of the line in which f″ is zero, and along which sheets lie on two sides of the node ahead on that, and behind
 */

/** @typedef {import('./singular.js').Walk<Node>} Walk */

/** Of more nodes none is taken, as ways over them would be too many. */
const MOST = 256;
/** So many at which second derivatives are singular are no points: f is a square, or zero everywhere. */
const MOST_FLAT = 4096;
/** A node is the same as another up to this part of the box. */
const SAME = 1e-6;
/** Nodes where f″ is singular lie on a curve of such points if they are nearer to each other than so many cells. */
const ALONE = 3;
/** Cones flatter than this are not told from planes. */
const FLAT = 1e-3;
/** Cells a direction of the mesh that tells what hangs together; nothing so many of them around a node does. */
const [CELLS, AROUND] = [48, 2.5];
/** A point belongs to what lies so many cells farther from it than the nearest. */
const BESIDE = 1.5;
/** What lies nearer to a node, and what lies between two that are nearer than twice that, may be gone altogether: only a solve tells where it leads. */
const SMALL = 3.5;

/** The node where steps end, if one is there. @param {number[]} at @param {number[]} second @returns {Node | null} */
function nodeAt(at, second) {
  const determinant = dot(second, cofactors(second));
  const isFlat = Math.abs(determinant) <= SINGULAR * largestOf(second) ** 3;
  /* A form that is definite: nothing of the surface is near. */
  if (!isFlat && second[0] * second[3] > second[1] ** 2 && second[0] * determinant > 0) return null;
  return { at, second, determinant, isFlat };
}

/** Half as many places are looked at around a node in the plane in which f″ is zero; so even is |∇f| on them, and so large beside what f″ makes of it, where no curve of such points leads through the node. */
const [HALF, EVEN, LARGE, NO_FORM] = [48, 0.1, 1e-6, 1e-3];

/**
 * The axes of a node where f″ is singular, if sheets meet there, and there alone. In the directions in which f″ is zero f is what terms of higher order leave of it where it is stationary in the others: if
 * its gradient vanishes nowhere around the node, no curve of such points leads through this. Of a plane the axis is what is normal to it. On a line f must have on both sides the sign that f″ has not, if that is
 * semidefinite, and the line is the axis: else the surface ends there as in a tip. Or f has a sign there that f″ has in one of its directions: the axis is the other one, which is left where f″ less that
 * eigenvalue is applied.
 * @param {Jets} jets @param {Node} node @param {number} cell how far from it that is seen @returns {number[][] | null} null: they do not
 */
function axesOf(jets, { at, second }, cell) {
  const { isLine, axis, back, trace, product, largest } = formOf(second);
  const [aside, other] = planeOf(axis);
  const halves = Array.from({ length: HALF }, (_, i) => (2 * i + 1) / HALF - 1).flatMap((t) => [
    [1 - t * t, 2 * t],
    [t * t - 1, 2 * t],
  ]);
  const around = halves.map(([x, y]) => unit(ahead(scaled(aside, x), other, y)));
  const directions = isLine ? [axis, scaled(axis, -1)] : around;
  let places = directions.map((along) => ahead(at, along, cell));
  let seen = jets(places.flat());
  const slopeOf = (/** @type {number} */ i) => listOf(seen, 10 * i + 1, 10 * i + 4);
  for (let k = 0; k < STEPS; k++) {
    places = places.map((place, i) => minus(place, back(slopeOf(i))));
    seen = jets(places.flat());
  }
  /* Third derivatives are all there is: f″ is rounding. */
  if (seen.some((x, i) => i % 10 > 3 && Math.abs(x) * NO_FORM > largest)) return null;
  const slopes = places.map((_, i) => norm(slopeOf(i)));
  const steepest = Math.max(...slopes);
  if (!(Math.min(...slopes) > EVEN * steepest && steepest > LARGE * largest * cell)) return null;
  if (!isLine) return [axis, axis, axis];
  const signs = places.map((_, i) => Math.sign(seen[10 * i]));
  if (product > 0) return signs.every((sign) => sign * trace < 0) ? [axis, axis, axis] : null;
  const sides = signs.map((sign) => {
    const same = (trace + sign * Math.sqrt(trace * trace - 4 * product)) / 2;
    return longest([aside, other].map((e) => ahead(times(second, e), e, -same)));
  });
  return [axis, ...sides];
}

/**
 * Whether f and ∇f are so small, beside the second derivatives, as they are within a cell of a node: by far most are not.
 * @param {Float64Array} jets @param {number} k where the jet of a place begins @param {number} cell
 */
function mayLead(jets, k, cell) {
  const mixed = jets[k + 5] ** 2 + jets[k + 6] ** 2 + jets[k + 8] ** 2;
  const most = (jets[k + 4] ** 2 + jets[k + 7] ** 2 + jets[k + 9] ** 2 + 2 * mixed) * cell ** 2;
  return jets[k] ** 2 <= most * cell ** 2 && jets[k + 1] ** 2 + jets[k + 2] ** 2 + jets[k + 3] ** 2 <= most;
}

/**
 * The nodes to which Newton's steps lead from some places.
 * @param {Jets} jets @param {Float64Array} places @param {number} cell farther than two no node is looked for @param {number} extent of the box
 */
function nodesFrom(jets, places, cell, extent) {
  const sampled = jets(places);
  const reach = { extent, far: 2 * cell };
  const goesOn = (/** @type {Walk} */ walk, /** @type {number[]} */ jet) => {
    const second = jet.slice(4);
    const minors = cofactors(second);
    const determinant = dot(second, minors);
    /* 0/0: at rest. */
    const by = times(minors, jet.slice(1)).map((part) => part / determinant || 0);
    return step(walk, jet, by, reach) && walk.size < cell;
  };
  /** @type {[Walk[], Walk[]]} */
  const [walks, crossing] = [[], []];
  for (let i = 0; 3 * i < places.length; i++) {
    if (!mayLead(sampled, 10 * i, cell)) continue;
    /** @type {Walk} */
    const walk = walkFrom(listOf(places, 3 * i, 3 * i + 3));
    const jet = jetOf(sampled, i);
    if (goesOn(walk, jet)) walks.push(walk);
    if (isSaddle(jet.slice(4))) crossing.push(walk);
  }
  walkOn(jets, walks, reach, goesOn, ({ at }, jet) => nodeAt(at, jet.slice(4)));
  return {
    nodes: walks.flatMap(({ end }) => end ?? []),
    open: crossing.flatMap(({ from, end }) => (end ? [] : [from])),
  };
}

/**
 * @param {Jets} jets @param {number[]} box @param {number} grid points a direction from which they are looked for
 * @returns {{ nodes: Node[], crossings: Crossing[] }} those in the box that are found, none where the surface is degenerate, or they are too many; crossings: places, a cell apart, on curves along which the surface crosses itself
 */
function findNodes(jets, box, grid) {
  const size = diagonalOf(box);
  /** @type {[Node[], Node[]]} */
  const [nodes, flat] = [[], []];
  const places = gridOf(box, grid);
  const slice = 3 * grid ** 2;
  const cell = size / grid;
  /** @type {Crossing[]} */
  const crossings = [];
  for (let from = 0; from < places.length; from += slice) {
    if (nodes.length > MOST || flat.length > MOST_FLAT) return { nodes: [], crossings };
    const found = nodesFrom(jets, places.subarray(from, from + slice), cell, size);
    for (const crossing of crossingsFrom(jets, found.open, 2 * cell, size))
      if (crossing && crossings.every(({ place }) => gap(place, crossing.place) > cell)) crossings.push(crossing);
    for (const node of found.nodes) {
      const known = node.isFlat ? flat : nodes;
      if (!known.some(({ at }) => gap(at, node.at) <= SAME * size)) known.push(node);
    }
  }
  const isAlone = (/** @type {Node} */ node) => flat.every((other) => other === node || gap(other.at, node.at) > ALONE * cell);
  return {
    nodes: [
      ...nodes,
      ...flat.flatMap((node) => {
        const axes = isAlone(node) && axesOf(jets, node, cell);
        return axes ? [{ ...node, axes }] : [];
      }),
    ],
    crossings,
  };
}

/** Where a path that begins at a node leads from there, a unit vector. @param {Path} path */
const leaving = ({ points }) => unit([0, 1, 2].map((j) => 4 * points[3 + j] - points[6 + j] - 3 * points[j]));

/**
 * Whether a path through a node passes from one of its cones to the other: else it has a corner there. With H the second derivatives, a and b on one cone,
 * det H · aᵀHb ≥ 0; on two, ≤ 0. Where H is singular what has passed to the other side along its axis, as from cusp to cusp or bowl to bowl, has come from one to
 * the other, in whatever direction. With one sign of f on the line and another behind the node sheets are joined otherwise there, and the node is one point of a whole, around which angles sum up to 4π: a path has π on
 * both sides if it changes sides along the axis on whose side of the node more of it lies.
 * @param {Node} node @param {Path} one from the node @param {Path} other from there, too
 */
export function crosses({ second, determinant, axes }, one, other) {
  const [a, b] = [leaving(one), leaving(other)];
  if (axes) {
    const [line, before, behind] = axes;
    const axis = dot(line, a) + dot(line, b) < 0 ? behind : before;
    const [rise, fall] = [one, other].map(({ points }) => dot(axis, minus(listOf(points, 3, 6), listOf(points, 0, 3))));
    return rise * fall < 0;
  }
  const cosine = dot(a, b);
  const form = (/** @type {number[]} */ v, /** @type {number[]} */ w) => Math.sign(determinant) * dot(v, times(second, w));
  /* aᵀHa and bᵀHb are zero on the cones: less their mean it is (a ± b)ᵀH(a ± b)/2, which stays small where the path goes straight on, however rough a and b are. */
  const product = form(a, b) - 0.5 * Math.sign(cosine) * (form(a, a) + form(b, b));
  return product < -FLAT * largestOf(second) * cosine;
}

/**
 * Numbers of what hangs together without the nodes, by place.
 * @param {import('../mesh/mesh.js').Mesh} mesh @param {number} cell @param {Node[]} nodes @returns {(place: number[]) => number[]} those around it
 */
function findParts({ positions, indices }, cell, nodes) {
  const part = Int32Array.from({ length: positions.length / 3 }, (_, i) => i);
  for (const { at } of nodes)
    distancesFrom(positions, at).forEach((x, i) => {
      if (x <= AROUND * cell) part[i] = -1;
    });
  const find = (/** @type {number} */ i) => {
    while (part[i] !== i) i = part[i] = part[part[i]];
    return i;
  };
  for (let i = 0; i < indices.length; i += 3) {
    const [a, b, c] = [indices[i], indices[i + 1], indices[i + 2]];
    if (part[a] < 0 || part[b] < 0 || part[c] < 0) continue;
    part[find(a)] = find(b);
    part[find(b)] = find(c);
  }
  return (at) => {
    const away = distancesFrom(positions, at);
    const near = away.reduce((least, x, i) => (part[i] >= 0 && x < least ? x : least), Infinity) + BESIDE * cell;
    /** @type {Set<number>} */
    const found = new Set();
    away.forEach((x, i) => {
      if (part[i] >= 0 && x <= near) found.add(find(i));
    });
    return [...found];
  };
}

/**
 * The nodes in a box, and which places can be joined without passing one.
 * @param {import('../search/routes.js').Field} field an implicit surface @param {number[]} box @param {number} grid cells a direction
 */
export function findNet({ jets, mesh }, box, grid) {
  const { nodes, crossings } = findNodes(jets, box, grid);
  const cell = Math.max(...[0, 2, 4].map((j) => box[j + 1] - box[j])) / CELLS;
  const partsAt = nodes.length > 0 ? findParts(mesh(box, CELLS), cell, nodes) : () => [];
  return {
    nodes: nodes.map((node) => ({ ...node, parts: partsAt(node.at) })),
    partsAt,
    near: SMALL * cell,
    crossings,
    apart: diagonalOf(box) / grid,
  };
}
