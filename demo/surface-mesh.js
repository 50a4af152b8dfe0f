/** A surface's triangles as a three.js mesh: matte, lit on both sides, with faint antialiased parameter lines where there are parameters. */

import { BufferAttribute, BufferGeometry, DoubleSide, Mesh, MeshStandardMaterial } from 'three';

/** @typedef {import('./drawable.js').SurfaceMesh} SurfaceMesh */

/** Cells between parameter lines along the surface's longer side. */
const CELLS = 22;

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

/** How a number a vertex becomes a colour: -1 … 1 between two hues with the surface's own at zero; 0 … 1 from light to dark in contour bands. */
const MODES = new Map([
  ['plain', 0],
  ['curvature', 1],
  ['distance', 2],
  ['density', 3],
]);

const DECLARED = /* glsl */ `
#include <common>
varying float vShade;
uniform int mode;
float contour(float x, float count) {
  float lines = x * count;
  float width = max(fwidth(lines), 1e-6);
  return (1.0 - clamp(abs(fract(lines - 0.5) - 0.5) / width - 0.2, 0.0, 1.0)) * (1.0 - smoothstep(0.2, 0.5, width));
}`;

/** Colours the surface, darkens it along whole texture coordinates, and its other side a little; lines that crowd closer than a few pixels fade out. */
const SHADING = /* glsl */ `
#include <color_fragment>
if (mode == 1) {
  vec3 hue = vShade < 0.0 ? vec3(0.30, 0.10, 0.47) : vec3(0.03, 0.34, 0.16);
  diffuseColor.rgb = mix(diffuseColor.rgb, hue, 0.85 * min(abs(vShade), 1.0));
} else if (mode >= 2 && vShade > -0.5) {
  vec3 dark = mode == 2 ? vec3(0.02, 0.17, 0.30) : vec3(0.16, 0.06, 0.30);
  float count = mode == 2 ? 14.0 : 8.0;
  float band = (floor(vShade * count) + 0.5) / count;
  diffuseColor.rgb = mix(diffuseColor.rgb, dark, 0.78 * clamp(mode == 2 ? band : vShade, 0.0, 1.0));
  diffuseColor.rgb *= 1.0 - 0.3 * contour(vShade, count);
}
if (farSide) diffuseColor.rgb *= vec3(0.93, 0.9, 0.86);
#ifdef USE_UV
  vec2 widths = max(fwidth(vUv), vec2(1e-6));
  vec2 nearness = 1.0 - clamp(abs(fract(vUv - 0.5) - 0.5) / widths - 0.15, 0.0, 1.0);
  nearness *= 1.0 - smoothstep(0.06, 0.22, widths);
  diffuseColor.rgb *= 1.0 - (mode == 0 ? 0.2 : 0.1) * max(nearness.x, nearness.y);
#endif`;

/** The surface of the view: one object, whose mesh and colours change. */
export class SurfaceObject extends Mesh {
  #mode = { value: 0 };
  /** @type {BufferGeometry} */ geometry;

  constructor() {
    const material = new MeshStandardMaterial({ side: DoubleSide, roughness: 0.72, metalness: 0 });
    const nothing = new BufferGeometry();
    super(nothing, material);
    this.geometry = nothing;
    this.frustumCulled = false;
    this.visible = false;
    material.onBeforeCompile = (shader) => {
      shader.uniforms.mode = this.#mode;
      shader.vertexShader = shader.vertexShader
        .replace('#include <common>', '#include <common>\nattribute float shade;\nvarying float vShade;')
        .replace('#include <begin_vertex>', '#include <begin_vertex>\nvShade = shade;');
      shader.fragmentShader = shader.fragmentShader
        .replace('#include <common>', DECLARED)
        .replace('#include <clipping_planes_fragment>', SIDE)
        .replace('#include <normal_fragment_begin>', NORMAL)
        .replace('#include <color_fragment>', SHADING);
    };
  }

  /** @param {string} color */
  setColor(color) {
    /** @type {MeshStandardMaterial} */ (this.material).color.set(color);
  }

  /** @param {SurfaceMesh} mesh */
  setMesh(mesh) {
    this.geometry.dispose();
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(Float32Array.from(mesh.positions), 3));
    geometry.setAttribute('normal', new BufferAttribute(Float32Array.from(mesh.normals), 3));
    if (mesh.parameters) geometry.setAttribute('uv', new BufferAttribute(lineCoordinates(mesh, mesh.parameters), 2));
    geometry.setIndex(new BufferAttribute(mesh.indices, 1));
    geometry.computeBoundingSphere();
    this.geometry = geometry;
    this.visible = true;
    this.setShade('plain', null);
    const material = /** @type {MeshStandardMaterial} */ (this.material);
    if (Boolean(mesh.parameters) === (material.defines?.USE_UV !== undefined)) return;
    material.defines = { ...material.defines };
    if (mesh.parameters) material.defines.USE_UV = '';
    else delete material.defines.USE_UV;
    material.needsUpdate = true;
  }

  /** @param {string} colour @param {Float32Array | null} values one a vertex, or none */
  setShade(colour, values) {
    const count = this.geometry.getAttribute('position')?.count ?? 0;
    const fits = values?.length === count;
    this.#mode.value = fits ? (MODES.get(colour) ?? 0) : 0;
    if (fits) this.geometry.setAttribute('shade', new BufferAttribute(values, 1));
    else this.geometry.deleteAttribute('shade');
  }
}
