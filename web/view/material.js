/** The look of a surface: matte, lit on both sides, with thin antialiased parameter lines and contours that keep their width at any zoom. */

import { DoubleSide, MeshStandardMaterial, Vector2, Vector3 } from 'three';
import { checkBoolean, checkObject } from '../arguments.js';
import { checkGeometry } from './check.js';
import { drawFromOrigin, FarGeometry, PROJECT } from './far.js';

/**
 * @typedef {object} LineOptions
 * @property {boolean} [lines] draw parameter lines where the geometry has parameters; default: unless it is coloured
 * @property {boolean} [contours] draw contour lines where the geometry is coloured; default true
 */

/** How much bands between contours differ in brightness. */
const BAND = 0.07;
/** What the far side takes of red, green and blue. What has one side only has none that is far: the seam would be a step. */
const FAR_SHADE = /** @type {const} */ ([0.93, 0.9, 0.86]);

const VERTEX = /* glsl */ `
#ifdef FAR
  attribute vec3 offset;
#endif
#ifdef CONTOURS
  attribute float contour;
  varying float vContour;
#endif
#include <common>`;

const VERTEX_MAIN = /* glsl */ `
#ifdef CONTOURS
  vContour = contour;
#endif
#include <begin_vertex>`;

const FRAGMENT = /* glsl */ `
uniform vec2 cells;
uniform vec3 farShade;
#ifdef CONTOURS
  varying float vContour;
  uniform float band;
#endif
#include <common>`;

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

/**
 * Darkens the far side a little, and lines; those that crowd closer than a few pixels fade out. Where a large area lies on a level there is no line: rounding
 * alone would draw it; and a band begins a hair before its level, so that the area has one brightness.
 */
const SHADING = /* glsl */ `
#include <color_fragment>
if (farSide) diffuseColor.rgb *= farShade;
#ifdef PARAMETER_LINES
  vec2 place = vUv * cells;
  vec2 widths = max(fwidth(place), vec2(1e-6));
  vec2 nearness = 1.0 - clamp(abs(fract(place - 0.5) - 0.5) / widths - 0.15, 0.0, 1.0);
  nearness *= 1.0 - smoothstep(0.06, 0.22, widths);
  diffuseColor.rgb *= 1.0 - 0.2 * max(nearness.x, nearness.y);
#endif
#ifdef CONTOURS
  float width = max(fwidth(vContour), 1e-6);
  float contourLine = 1.0 - clamp(abs(fract(vContour - 0.5) - 0.5) / width - 0.25, 0.0, 1.0);
  contourLine *= smoothstep(4e-6, 4e-5, width) * (1.0 - smoothstep(0.12, 0.4, width));
  diffuseColor.rgb *= 1.0 - band * mod(floor(vContour + 1e-4), 2.0);
  diffuseColor.rgb *= 1.0 - 0.38 * contourLine;
#endif`;

/**
 * Makes a material for a geometry of {@link surfaceGeometry}: a MeshStandardMaterial, seen from both sides, its colours those of the geometry if it has any.
 * It fits geometries with the same attributes; make another one where they differ. Dispose it as any material. TypeError for what is no such geometry.
 * @param {import('three').BufferGeometry} geometry
 * @param {LineOptions & import('three').MeshStandardMaterialParameters} [options]
 * @returns {MeshStandardMaterial}
 */
export function surfaceMaterial(geometry, options = {}) {
  checkGeometry('surfaceMaterial', geometry);
  checkObject('surfaceMaterial: options', options);
  const coloured = geometry.hasAttribute('contour') && geometry.hasAttribute('color');
  const { lines = !coloured, contours = true, ...parameters } = options;
  checkBoolean('surfaceMaterial', 'lines', lines);
  checkBoolean('surfaceMaterial', 'contours', contours);
  const { scale, cells = [CELLS, CELLS], isOneSided = false } = geometry.userData;
  const color = coloured ? '#ffffff' : '#cfd6dc';
  const material = new MeshStandardMaterial({
    color,
    side: DoubleSide,
    roughness: 0.72,
    metalness: 0,
    vertexColors: coloured,
    ...parameters,
  });
  material.defines = { ...material.defines };
  if (lines && geometry.hasAttribute('uv')) Object.assign(material.defines, { USE_UV: '', PARAMETER_LINES: '' });
  if (contours && coloured) material.defines.CONTOURS = '';
  if (geometry instanceof FarGeometry) drawFromOrigin(material);
  const uniforms = {
    cells: { value: new Vector2(cells[0], cells[1]) },
    band: { value: scale?.spacing > 0 ? BAND : 0 },
    farShade: { value: new Vector3(...(isOneSided ? [1, 1, 1] : FAR_SHADE)) },
  };
  material.onBeforeCompile = (shader) => {
    Object.assign(shader.uniforms, uniforms);
    shader.vertexShader = shader.vertexShader
      .replace('#include <common>', VERTEX)
      .replace('#include <begin_vertex>', VERTEX_MAIN)
      .replace('#include <project_vertex>', PROJECT);
    shader.fragmentShader = shader.fragmentShader
      .replace('#include <common>', FRAGMENT)
      .replace('#include <clipping_planes_fragment>', SIDE)
      .replace('#include <normal_fragment_begin>', NORMAL)
      .replace('#include <color_fragment>', SHADING);
  };
  return material;
}

/** Where a geometry does not say how many cells suit it. */
const CELLS = 16;
