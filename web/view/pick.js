/** Which point of a surface a ray points at: the triangle that it meets, then the surface itself. */

import { DoubleSide, Mesh, MeshBasicMaterial, Vector3 } from 'three';
import { surfaceGeometry } from './geometry.js';

/** @typedef {import('../surface.js').Surface} Surface */

const place = new Vector3();

export class Picker {
  #surface;
  #mesh;
  /** Whether the mesh is made here, and never drawn. */
  #own;

  /** @param {Surface} surface @param {Mesh} [mesh] of the surface, as `surfaceGeometry` makes it; else one is made */
  constructor(surface, mesh) {
    this.#surface = surface;
    this.#own = !mesh;
    this.#mesh = mesh ?? new Mesh(surfaceGeometry(surface), new MeshBasicMaterial({ side: DoubleSide }));
  }

  /**
   * The point under a ray; where the ray misses the surface, the one nearest to it.
   * @param {import('three').Raycaster} raycaster @param {import('three').Matrix4} frame from the surface's coordinates to the scene's
   * @param {Vector3 | null} last where the point was, in the surface's coordinates: take the crossing nearest to it; null: take the first one
   * @returns {number[] | null} u v or x y z; null where projection finds none
   */
  pick(raycaster, frame, last) {
    if (this.#own) this.#mesh.matrixWorld.copy(frame);
    else this.#mesh.updateWorldMatrix(true, false);
    const hits = raycaster.intersectObject(this.#mesh, false);
    if (hits.length === 0) return this.#graze(raycaster.ray);
    const away = (/** @type {{ point: Vector3 }} */ { point }) => (last ? this.#mesh.worldToLocal(place.copy(point)).distanceTo(last) : 0);
    const [hit] = last ? hits.sort((one, other) => away(one) - away(other)) : hits;
    return this.#project(this.#mesh.worldToLocal(hit.point), hit.uv);
  }

  /** @param {import('three').Ray} ray */
  #graze(ray) {
    const local = ray.clone().applyMatrix4(this.#mesh.matrixWorld.clone().invert());
    const { position, uv } = this.#mesh.geometry.attributes;
    const { index } = this.#mesh.geometry;
    let [nearest, least] = [0, Infinity];
    for (let i = 0; i < (index ?? position).count; i++) {
      const vertex = index ? index.getX(i) : i;
      const distance = local.distanceSqToPoint(place.fromBufferAttribute(position, vertex));
      if (distance < least) [nearest, least] = [vertex, distance];
    }
    local.closestPointToPoint(place.fromBufferAttribute(position, nearest), place);
    return this.#project(place, uv && { x: uv.getX(nearest), y: uv.getY(nearest) });
  }

  /** @param {Vector3} point near the surface @param {{ x: number, y: number }} [uv] shares of the parameters' ranges */
  #project(point, uv) {
    const { domain } = this.#surface;
    const at = (/** @type {number[]} */ [from, to], /** @type {number} */ share) => from + share * (to - from);
    // Of a geometry of the reader's own they may be anything.
    const near = domain && uv && this.#mesh.geometry.userData.cells ? [at(domain.u, uv.x), at(domain.v, uv.y)] : undefined;
    try {
      return this.#surface.project(point.toArray(), near);
    } catch (error) {
      if (error instanceof RangeError) return null;
      throw error;
    }
  }

  dispose() {
    if (!this.#own) return;
    this.#mesh.geometry.dispose();
    /** @type {MeshBasicMaterial} */ (this.#mesh.material).dispose();
  }
}
