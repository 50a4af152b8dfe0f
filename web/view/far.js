/** Geometry of a surface far from the origin of space, and how a material draws it exactly. */

import { BufferAttribute, BufferGeometry, Matrix4, Vector3 } from 'three';
import { originOf } from './origin.js';

/** Places of 64 bits: rays and boxes meet these; graphics cards are given what 32 bits hold of them. */
class Places extends BufferAttribute {
  /** @param {Float64Array} exact x y z … */
  constructor(exact) {
    super(new Float32Array(exact), 3);
    this.exact = exact;
  }

  /** @param {number} i */
  getX(i) {
    return this.exact[3 * i];
  }

  /** @param {number} i */
  getY(i) {
    return this.exact[3 * i + 1];
  }

  /** @param {number} i */
  getZ(i) {
    return this.exact[3 * i + 2];
  }

  /** @param {number} i @param {number} x @param {number} y @param {number} z */
  setXYZ(i, x, y, z) {
    this.exact.set([x, y, z], 3 * i);
    return super.setXYZ(i, x, y, z);
  }

  clone() {
    return /** @type {this} */ (new Places(this.exact.slice()));
  }
}

/** Its `position` is as that of any geometry, for any material; `offset` is the same from `origin`, for materials that {@link drawFromOrigin}. */
export class FarGeometry extends BufferGeometry {
  origin = new Vector3();

  /** @param {Float64Array} [positions] */
  constructor(positions = new Float64Array()) {
    super();
    this.setAttribute('position', new Places(positions));
    this.#measure();
  }

  #measure() {
    const { exact } = /** @type {Places} */ (this.getAttribute('position'));
    const origin = originOf(exact);
    this.origin.fromArray(origin);
    const offset = this.getAttribute('offset') ?? new BufferAttribute(new Float32Array(exact.length), 3);
    offset.array.set(exact.map((x, i) => x - origin[i % 3]));
    offset.needsUpdate = true;
    this.setAttribute('offset', offset);
  }

  /** @param {FarGeometry} source */
  copy(source) {
    super.copy(source);
    this.#measure();
    return this;
  }

  /** By this geometries are turned, moved and scaled. @param {import('three').Matrix4} matrix */
  applyMatrix4(matrix) {
    super.applyMatrix4(matrix);
    this.#measure();
    return this;
  }
}

/**
 * GLSL in place of `#include <project_vertex>`. What else is computed of a vertex, shadows say, may be coarse. An instance is turned about the origin of space,
 * not that of the offsets, which the turn moves, too: by nothing where it is only shifted.
 */
export const PROJECT = /* glsl */ `
#ifdef FAR
  vec3 coarse = transformed;
  transformed = offset;
#endif
#include <project_vertex>
#ifdef FAR
  transformed = coarse;
  #ifdef USE_INSTANCING
  mvPosition.xyz += mat3(modelViewMatrix) * (mat3(instanceMatrix) - mat3(1.0)) * (coarse - offset);
  gl_Position = projectionMatrix * mvPosition;
  #endif
#endif`;

const shift = new Matrix4();

/** Has a material draw a geometry by its offsets: the renderer asks it after it has put together how the object is seen. @param {import('three').Material} material */
export function drawFromOrigin(material) {
  material.defines = { ...material.defines, FAR: '' };
  material.onBeforeRender = (_renderer, _scene, _camera, geometry, object) => {
    object.modelViewMatrix.multiply(shift.setPosition(/** @type {FarGeometry} */ (geometry).origin));
  };
}
