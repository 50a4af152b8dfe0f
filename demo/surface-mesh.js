/** A surface's triangles as a three.js mesh: matte, lit on both sides, with faint antialiased parameter lines where there are parameters. */

import { BufferAttribute, BufferGeometry, DoubleSide, Mesh, MeshStandardMaterial } from 'three';

/** @typedef {{ positions: Float64Array, normals: Float64Array, parameters?: Float64Array, indices: Uint32Array }} SurfaceMesh */

/** Cells between parameter lines along the surface's longer side. */
const CELLS = 22;

/** Triangles whose corners are all numbers: a formula may have no value on a part of its range. @param {SurfaceMesh} mesh @returns {SurfaceMesh} */
export function drawable(mesh) {
  const { positions, normals } = mesh;
  if (positions.every(Number.isFinite) && normals.every(Number.isFinite)) return mesh;
  const good = (/** @type {number} */ i) =>
    [0, 1, 2].every((k) => Number.isFinite(positions[3 * i + k]) && Number.isFinite(normals[3 * i + k]));
  const indices = [];
  for (let i = 0; i < mesh.indices.length; i += 3) {
    const corners = mesh.indices.subarray(i, i + 3);
    if (corners.every(good)) indices.push(...corners);
  }
  const finite = (/** @type {number} */ x) => (Number.isFinite(x) ? x : 0);
  return { ...mesh, positions: positions.map(finite), normals: normals.map(finite), indices: Uint32Array.from(indices) };
}

/** How long the grid's lines are in a direction, on average. @param {SurfaceMesh} mesh @param {number} side vertices a side @param {number} step from a vertex to the next @param {number} across */
function gridLength({ positions }, side, step, across) {
  let sum = 0;
  for (let line = 0; line < side; line++)
    for (let i = 1; i < side; i++) {
      const [a, b] = [3 * (line * across + (i - 1) * step), 3 * (line * across + i * step)];
      sum += Math.hypot(positions[b] - positions[a], positions[b + 1] - positions[a + 1], positions[b + 2] - positions[a + 2]);
    }
  return sum / side;
}

/** Texture coordinates in which a parameter line runs at every whole number, the cells about square. @param {SurfaceMesh} mesh @param {Float64Array} parameters */
function lineCoordinates(mesh, parameters) {
  const side = Math.round(Math.sqrt(parameters.length / 2));
  const lengths = [gridLength(mesh, side, 1, side), gridLength(mesh, side, side, 1)];
  const longer = Math.max(...lengths);
  const counts = lengths.map((length) => Math.max(4, 2 * Math.round((CELLS * length) / longer / 2)));
  const [low, high] = [parameters.subarray(0, 2), parameters.subarray(-2)];
  return Float32Array.from(parameters, (x, i) => ((x - low[i & 1]) / (high[i & 1] - low[i & 1])) * counts[i & 1]);
}

/**
 * The far side is seen where triangle and normal agree that it is, a pixel away from the silhouette: there the flat triangles and the smooth normals
 * disagree, and normals turned by the triangle's side alone would leave dark specks.
 */
const SIDE = /* glsl */ `
#include <clipping_planes_fragment>
float facing = dot(normalize(vNormal), normalize(vViewPosition));
bool farSide = !gl_FrontFacing && facing < -fwidth(facing);`;

const NORMAL = /* glsl */ `
float faceDirection = farSide ? -1.0 : 1.0;
vec3 normal = faceDirection * normalize(vNormal);
vec3 nonPerturbedNormal = normal;`;

/** Darkens the surface along whole texture coordinates, and its other side a little; lines that crowd closer than a few pixels fade out. */
const SHADING = /* glsl */ `
#include <color_fragment>
if (farSide) diffuseColor.rgb *= vec3(0.93, 0.9, 0.86);
#ifdef USE_UV
  vec2 widths = max(fwidth(vUv), vec2(1e-6));
  vec2 nearness = 1.0 - clamp(abs(fract(vUv - 0.5) - 0.5) / widths - 0.15, 0.0, 1.0);
  nearness *= 1.0 - smoothstep(0.06, 0.22, widths);
  diffuseColor.rgb *= 1.0 - 0.2 * max(nearness.x, nearness.y);
#endif`;

/** @returns {MeshStandardMaterial} */
export function surfaceMaterial() {
  const material = new MeshStandardMaterial({ side: DoubleSide, roughness: 0.72, metalness: 0 });
  material.onBeforeCompile = (shader) => {
    shader.fragmentShader = shader.fragmentShader
      .replace('#include <clipping_planes_fragment>', SIDE)
      .replace('#include <normal_fragment_begin>', NORMAL)
      .replace('#include <color_fragment>', SHADING);
  };
  return material;
}

/** @param {SurfaceMesh} mesh @param {MeshStandardMaterial} material whose parameter lines are switched as the mesh needs */
export function surfaceObject(mesh, material) {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(Float32Array.from(mesh.positions), 3));
  geometry.setAttribute('normal', new BufferAttribute(Float32Array.from(mesh.normals), 3));
  if (mesh.parameters) geometry.setAttribute('uv', new BufferAttribute(lineCoordinates(mesh, mesh.parameters), 2));
  geometry.setIndex(new BufferAttribute(mesh.indices, 1));
  geometry.computeBoundingSphere();
  material.defines = { ...material.defines };
  if (mesh.parameters) material.defines.USE_UV = '';
  else delete material.defines.USE_UV;
  material.needsUpdate = true;
  return new Mesh(geometry, material);
}
