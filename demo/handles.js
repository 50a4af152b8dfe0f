/** The two ends of the path: small spheres of constant size on the screen, each in a ring, and their letters beside them. */

import { BackSide, GreaterDepth, Group, Mesh, MeshBasicMaterial, SphereGeometry, Vector3 } from 'three';

/** Radii in CSS pixels. */
const SPHERE = 5.5;
const RING = 8;
const LABEL = 22;

export class Handle extends Group {
  #label;
  #materials;
  #place = new Vector3();

  /** @param {HTMLElement} label @param {number} order */
  constructor(label, order) {
    super();
    this.#label = label;
    const shape = new SphereGeometry(1, 24, 16);
    this.#materials = {
      hidden: new MeshBasicMaterial({ depthFunc: GreaterDepth, depthWrite: false }),
      // The ring is the far half of a larger sphere: whatever the view, it surrounds the inner one.
      ring: new MeshBasicMaterial({ side: BackSide, depthWrite: false }),
      sphere: new MeshBasicMaterial({ depthWrite: false }),
    };
    const sizes = { hidden: SPHERE, ring: RING, sphere: SPHERE };
    for (const [i, name] of /** @type {(keyof typeof sizes)[]} */ (['hidden', 'ring', 'sphere']).entries()) {
      Object.assign(this.#materials[name], { transparent: true, toneMapped: false });
      const mesh = new Mesh(shape, this.#materials[name]);
      mesh.scale.setScalar(sizes[name]);
      mesh.renderOrder = order + i;
      this.add(mesh);
    }
  }

  /** @param {ArrayLike<number> | null} point x y z, or null: nowhere */
  setPoint(point) {
    this.visible = point !== null;
    this.#label.hidden = !this.visible;
    if (point) this.position.set(point[0], point[1], point[2]);
  }

  /** @param {string} sphere @param {string} ring @param {import('three').ColorRepresentation} hidden */
  setColors(sphere, ring, hidden) {
    this.#materials.sphere.color.set(sphere);
    this.#materials.ring.color.set(ring);
    this.#materials.hidden.color.set(hidden);
  }

  /**
   * Keeps the size on the screen.
   * @param {import('three').PerspectiveCamera} camera @param {{ width: number, height: number }} size of the view in CSS pixels
   * @returns {[number, number]} where it is on the screen
   */
  follow(camera, { width, height }) {
    this.getWorldPosition(this.#place);
    const distance = this.#place.distanceTo(camera.position) / (this.parent?.scale.x ?? 1);
    this.scale.setScalar((2 * distance * Math.tan((camera.fov * Math.PI) / 360)) / height);
    this.#place.project(camera);
    return [((this.#place.x + 1) / 2) * width, ((1 - this.#place.y) / 2) * height];
  }

  /** Puts the letter on the side away from the other end, where the path does not run. @param {[number, number]} here @param {[number, number]} other */
  placeLabel(here, other) {
    const [dx, dy] = [here[0] - other[0], here[1] - other[1]];
    const away = LABEL / Math.max(Math.hypot(dx, dy), 1);
    this.#label.style.transform = `translate(${(here[0] + dx * away).toFixed(1)}px, ${(here[1] + dy * away).toFixed(1)}px)`;
  }
}
