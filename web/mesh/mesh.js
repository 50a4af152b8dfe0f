/** Triangle meshes, for drawing: a grid of the rectangle. Implicit surfaces are meshed in C; here only the result is judged. */

import { wholeNumber } from '../arguments.js';
import { boxOf, touches } from '../manifold/extent.js';
import { STATUS } from '../runtime/status.js';
import { evaluateNormals } from './normals.js';

/** @typedef {import('../manifold/manifold.js').Manifold} Manifold */

/**
 * @typedef {object} Mesh
 * @property {Float64Array} positions x y z a vertex
 * @property {Float64Array} normals unit normals, exact; implicit: ∇f/|∇f|
 * @property {Float64Array} [parameters] u v a vertex, parametric surfaces only
 * @property {Uint32Array} indices three a triangle, counter-clockwise seen from the normals' side
 */

const RESOLUTION = { parametric: 96, implicit: 64 };
/** In place of 64 where that bridges sheets, one after the other; the first is enough for every surface of the gallery. */
const FINER = [96, 128];
/** The cosine of how far normals on two sides of what is thin are apart, at least. A part of the bounds that is no smaller than this has not much finer cells. */
const [OPPOSITE, SMALLER] = [-0.5, 0.5];
/** Cells at most. */
const FINEST = 256;
/** How far, in parts of the rectangle, a vertex without a normal (a pole) looks inwards for one. */
const INWARDS = 1e-4;

/** @param {ArrayLike<number>} lower @param {ArrayLike<number>} upper @param {number} resolution */
function gridPoints(lower, upper, resolution) {
  const points = new Float64Array(2 * (resolution + 1) ** 2);
  for (let j = 0, at = 0; j <= resolution; j++)
    for (let i = 0; i <= resolution; i++) {
      points[at++] = i === resolution ? upper[0] : lower[0] + (i / resolution) * (upper[0] - lower[0]);
      points[at++] = j === resolution ? upper[1] : lower[1] + (j / resolution) * (upper[1] - lower[1]);
    }
  return points;
}

/** @param {number} resolution */
function gridTriangles(resolution) {
  const indices = new Uint32Array(6 * resolution * resolution);
  for (let j = 0, at = 0; j < resolution; j++)
    for (let i = 0; i < resolution; i++) {
      const corner = j * (resolution + 1) + i;
      const above = corner + resolution + 1;
      for (const index of [corner, corner + 1, above + 1, corner, above + 1, above]) indices[at++] = index;
    }
  return indices;
}

/**
 * @param {Manifold} manifold that has positions @param {string} caller @param {number} [wanted] resolution
 * @returns {Mesh}
 */
export function meshSurface(manifold, caller, wanted) {
  const { kind, domain, box } = manifold;
  const resolution = wanted === undefined ? RESOLUTION[/** @type {'parametric' | 'implicit'} */ (kind)] : wanted;
  wholeNumber(caller, 'resolution', resolution, 1, FINEST);
  if (domain) return meshRectangle(manifold, domain.written, resolution);
  if (!box) throw new RangeError(`${caller}: an implicit surface is meshed inside its bounds; give them in its definition`);
  const mesh = meshImplicit(manifold, caller, box, resolution);
  return wanted === undefined && isPoor(mesh) ? meshFiner(manifold, caller, box) : mesh;
}

/** Whether the lattice may have been too coarse. @param {Mesh} mesh */
const isPoor = (mesh) => mesh.indices.length === 0 || bridgesSheets(mesh);

/**
 * A mesh of what the usual lattice does not resolve: of a flat body as it is where this is stretched, or in the part of the bounds that holds the surface; and of more cells.
 * @param {Manifold} manifold @param {string} caller @param {number[]} box @returns {Mesh}
 */
function meshFiner(manifold, caller, box) {
  const { bodies } = manifold;
  const round = bodies.stretchedIn(box)?.mesh(RESOLUTION.implicit, isPoor);
  if (round && isInside(round.positions, box)) return round;
  const usual = meshImplicit(manifold, caller, box, FINER[0]);
  let mesh = usual;
  const extent = bodies.extentIn(box);
  const part = extent ? boxOf(extent, box) : box;
  const isSmaller = volumeOf(part) < SMALLER * volumeOf(box);
  for (const resolution of isSmaller ? FINER : FINER.slice(1)) {
    if (!isPoor(mesh)) break;
    mesh = meshImplicit(manifold, caller, part, resolution);
    if (touches(mesh.positions, part, box)) mesh = meshImplicit(manifold, caller, box, resolution);
  }
  /* What has holes all the same is no better for being larger, unless its cells are much smaller. */
  return isPoor(mesh) && !isSmaller ? usual : mesh;
}

/** @param {number[]} box */
const volumeOf = (box) => (box[1] - box[0]) * (box[3] - box[2]) * (box[5] - box[4]);

/** Whether the bounds cut nothing off. @param {Float64Array} positions @param {number[]} box */
const isInside = (positions, box) => positions.every((x, k) => x >= box[2 * (k % 3)] && x <= box[2 * (k % 3) + 1]);

/** @param {Manifold} manifold @param {string} caller @param {number[]} box @param {number} resolution @returns {Mesh} */
function meshImplicit(manifold, caller, box, resolution) {
  const { status, ...mesh } = manifold.run((heap, _, { value }) => heap.meshImplicit(value, box, resolution));
  if (status < 0) throw new RangeError(`${caller}: no mesh (${STATUS.get(status)}); try a lower resolution`);
  return mesh;
}

/** @param {Manifold} manifold @param {import('../manifold/rectangle.js').Range} range @param {number} resolution cells a direction @returns {Mesh} */
function meshRectangle(manifold, { lower, upper }, resolution) {
  const parameters = gridPoints(lower, upper, resolution);
  const evaluated = evaluateNormals(manifold, parameters);
  const count = parameters.length / 2;
  const [positions, normals] = [new Float64Array(3 * count), new Float64Array(3 * count)];
  for (let i = 0; i < count; i++) {
    for (let k = 0; k < 3; k++) [positions[3 * i + k], normals[3 * i + k]] = [evaluated[6 * i + k], evaluated[6 * i + 3 + k]];
    if (!Number.isNaN(normals[3 * i])) continue;
    const inwards = [0, 1].map((k) => parameters[2 * i + k] + INWARDS * ((lower[k] + upper[k]) / 2 - parameters[2 * i + k]));
    normals.set(evaluateNormals(manifold, inwards).subarray(3, 6), 3 * i);
  }
  return { positions, normals, parameters, indices: gridTriangles(resolution) };
}

/**
 * Whether some triangle faces away from the normals of its own corners, which face apart. Then the lattice was too coarse: two sheets of the surface lie within a cell of
 * it, some triangles join one to the other, and the mesh has holes where the surface has none. (Slivers that do so where the surface is smooth, and at the tip of a cone, are there in any lattice.)
 * @param {Mesh} mesh
 */
function bridgesSheets({ positions, normals, indices }) {
  for (let i = 0; i < indices.length; i += 3) {
    const [a, b, c] = [3 * indices[i], 3 * indices[i + 1], 3 * indices[i + 2]];
    let facing = 0;
    for (let axis = 0; axis < 3; axis++) {
      const [next, last] = [(axis + 1) % 3, (axis + 2) % 3];
      const area =
        (positions[b + next] - positions[a + next]) * (positions[c + last] - positions[a + last]) -
        (positions[b + last] - positions[a + last]) * (positions[c + next] - positions[a + next]);
      facing += area * (normals[a + axis] + normals[b + axis] + normals[c + axis]);
    }
    if (facing < 0 && Math.min(between(normals, a, b), between(normals, b, c), between(normals, c, a)) < OPPOSITE) return true;
  }
  return false;
}

/** @param {Float64Array} normals @param {number} a @param {number} b where two of them begin */
const between = (normals, a, b) => normals[a] * normals[b] + normals[a + 1] * normals[b + 1] + normals[a + 2] * normals[b + 2];
