/** Short thin lines on the surface. */

import { BufferAttribute, BufferGeometry, LineBasicMaterial, LineSegments } from 'three';
import { originOf } from '../../web/view/origin.js';

/** A hair nearer to the eye than the surface they lie on. */
function strokeMaterial() {
  const material = new LineBasicMaterial({ transparent: true, opacity: 0.7, depthWrite: false, toneMapped: false });
  material.onBeforeCompile = (shader) => {
    shader.vertexShader = shader.vertexShader.replace(
      '#include <project_vertex>',
      '#include <project_vertex>\ngl_Position.z -= 2e-3 * gl_Position.w;',
    );
  };
  return material;
}

export class Strokes extends LineSegments {
  /** @type {BufferGeometry} */ geometry;
  /** @type {LineBasicMaterial} */ material;

  constructor() {
    const [geometry, material] = [new BufferGeometry(), strokeMaterial()];
    super(geometry, material);
    [this.geometry, this.material] = [geometry, material];
    this.visible = false;
  }

  /** How many there are. */
  get count() {
    return (this.geometry.getAttribute('position')?.count ?? 0) / 2;
  }

  /** @param {Float64Array | null} ends two points each, x y z */
  setEnds(ends) {
    this.geometry.dispose();
    this.geometry = new BufferGeometry();
    this.visible = ends !== null && ends.length > 0;
    if (!ends || ends.length === 0) return;
    const origin = originOf(ends);
    this.position.fromArray(origin);
    const offsets = Float32Array.from(ends, (x, i) => x - origin[i % 3]);
    this.geometry.setAttribute('position', new BufferAttribute(offsets, 3));
  }
}
