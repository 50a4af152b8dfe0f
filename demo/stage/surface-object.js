/** The surface of the view: one object, whose mesh and colours change. Both are computed elsewhere; here they become what the graphics card draws. */

import { BufferAttribute, BufferGeometry, Mesh } from 'three';
import { bandScale, colourVertices, contourLevels, curvatureScale } from '../../web/view/colouring.js';
import { bareGeometry } from '../../web/view/geometry.js';
import { surfaceMaterial } from 'surfpath/three';

/** @typedef {import('../compute/drawable.js').SurfaceMesh} SurfaceMesh */
/** @typedef {import('surfpath/three').ColourScale} ColourScale */

/** Colours are a little brighter than paint: the light takes some away. */
const PALE = '#ffffff';

/** Values jump if they differ by more than this part of their scale in one triangle. */
const MOST = 0.5;

export class SurfaceObject extends Mesh {
  #colour = '#c3d0dc';
  /** @type {BufferGeometry} */ geometry;
  /** @type {import('three').MeshStandardMaterial} */ material;

  /** The material before, which holds the shaders until the new one has taken them over. @type {import('three').MeshStandardMaterial | null} */ #last =
    null;

  constructor() {
    // As a parametric surface has it, so that its shaders can be compiled before there is one.
    const geometry = new BufferGeometry();
    for (const [name, size] of /** @type {const} */ ([
      ['position', 3],
      ['uv', 2],
    ]))
      geometry.setAttribute(name, new BufferAttribute(new Float32Array(3 * size), size));
    const material = surfaceMaterial(geometry);
    super(geometry, material);
    [this.geometry, this.material] = [geometry, material];
    this.frustumCulled = false;
    this.visible = false;
    this.onAfterRender = () => this.#release();
  }

  /** Whether its colours are those of numbers. */
  get isColoured() {
    return this.geometry.hasAttribute('color');
  }

  #release() {
    this.#last?.dispose();
    this.#last = null;
  }

  /** @param {string} colour of the bare surface */
  setColour(colour) {
    this.#colour = colour;
    if (!this.isColoured) this.material.color.set(colour);
  }

  /** @param {SurfaceMesh} mesh */
  setMesh(mesh) {
    const last = this.geometry;
    this.geometry = bareGeometry(mesh);
    last.dispose();
    this.visible = true;
    this.#dress();
  }

  /**
   * Colours the surface by a number a vertex.
   * @param {string} quantity @param {Float64Array | null} values null, or of another number: it is bare
   * @returns {ColourScale | null}
   */
  setValues(quantity, values) {
    const { geometry } = this;
    const fits = values !== null && values.length === geometry.getAttribute('position')?.count;
    if (!fits && !this.isColoured) return null;
    for (const name of ['color', 'contour']) geometry.deleteAttribute(name);
    delete geometry.userData.scale;
    if (fits) {
      const size = geometry.boundingSphere?.radius || 1;
      const scale =
        quantity === 'curvature' ? curvatureScale(values, size) : bandScale(quantity === 'distance' ? 'distance' : 'values', values);
      geometry.setAttribute('color', new BufferAttribute(colourVertices(values, scale), 3));
      /* Where a density jumps, lines of its levels would run along cells. */
      const isLined = quantity !== 'density' || !jumps(geometry, values, scale);
      geometry.setAttribute('contour', new BufferAttribute(contourLevels(isLined ? values : values.map(() => Number.NaN), scale), 1));
      geometry.userData.scale = scale;
    }
    this.#dress();
    return geometry.userData.scale ?? null;
  }

  /** The material that the geometry's attributes need. */
  #dress() {
    // One that was never drawn with holds nothing.
    if (this.#last) this.material.dispose();
    else this.#last = this.material;
    this.material = surfaceMaterial(this.geometry, { color: this.isColoured ? PALE : this.#colour });
  }
}

/** Whether values differ by most of their scale within a triangle. @param {import('three').BufferGeometry} geometry @param {Float64Array} values @param {ColourScale} scale */
function jumps({ index }, values, { low, high }) {
  const corners = index?.array ?? [];
  for (let i = 0; i < corners.length; i += 3) {
    const [a, b, c] = [values[corners[i]], values[corners[i + 1]], values[corners[i + 2]]];
    if (Math.max(a, b, c) - Math.min(a, b, c) > MOST * (high - low)) return true;
  }
  return false;
}
