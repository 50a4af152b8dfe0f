/** Points that the reader can take hold of: a small sphere in a ring, of constant size on the screen. The buttons that stand over them are in anchors.js. */

import { BackSide, GreaterDepth, Group, Mesh, MeshBasicMaterial, SphereGeometry, Vector3 } from 'three';

/** Radii in CSS pixels. */
const SIZES = { hidden: 6, ring: 8.5, sphere: 6 };
const shape = new SphereGeometry(1, 24, 16);

export class Handle extends Group {
  #materials = {
    hidden: new MeshBasicMaterial({ depthFunc: GreaterDepth, depthWrite: false }),
    // The ring is the far half of a larger sphere: whatever the view, it surrounds the inner one.
    ring: new MeshBasicMaterial({ side: BackSide, depthWrite: false }),
    sphere: new MeshBasicMaterial({ depthWrite: false }),
  };
  #size;

  /** @param {number} order @param {number} [size] of 1 */
  constructor(order, size = 1) {
    super();
    this.#size = size;
    for (const [i, name] of /** @type {(keyof typeof SIZES)[]} */ (['hidden', 'ring', 'sphere']).entries()) {
      Object.assign(this.#materials[name], { transparent: true, toneMapped: false });
      const mesh = new Mesh(shape, this.#materials[name]);
      mesh.scale.setScalar(SIZES[name]);
      mesh.renderOrder = order + i;
      this.add(mesh);
    }
  }

  /** Grows under the pointer and in focus. @param {boolean} active */
  setActive(active) {
    this.#size = active ? 1.3 : 1;
  }

  /** @param {string} sphere @param {string} ring @param {import('three').ColorRepresentation} hidden */
  setColors(sphere, ring, hidden) {
    this.#materials.sphere.color.set(sphere);
    this.#materials.ring.color.set(ring);
    this.#materials.hidden.color.set(hidden);
  }

  /** Keeps the size on the screen. @param {import('three').PerspectiveCamera} camera @param {number} height of the view in CSS pixels */
  follow(camera, height) {
    const distance = this.getWorldPosition(new Vector3()).distanceTo(camera.position) / (this.parent?.scale.x ?? 1);
    this.scale.setScalar((this.#size * 2 * distance * Math.tan((camera.fov * Math.PI) / 360)) / height);
  }

  dispose() {
    for (const material of Object.values(this.#materials)) material.dispose();
  }
}
