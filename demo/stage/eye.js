/** The eye of the view: a camera that looks at a whole surface until the reader turns it. */

import { Box3, MathUtils, PerspectiveCamera, Sphere, Vector3 } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { fitView, tilted } from '../../web/view/fit.js';
import { sideOf } from '../../web/view/side.js';
import { pointsWithin, rangesWithoutSpikes } from '../../web/view/spikes.js';
import { turnByKeys } from '../../web/view/turn-keys.js';
import { shareWheel } from '../../web/view/wheel.js';
import { shareOfView } from './fit.js';

const FIELD_OF_VIEW = 32;
/** Share of the view that stays free around the surface, both sides together. */
const MARGIN = 0.1;
/** In CSS pixels, at least. */
const LEAST_MARGIN = 44;
/** Share of the view below which a surface is too small to be seen well. */
const TINY = 0.35;
/** By how much a surface may grow or shrink, and move, in parts of its distance, before a view that nobody has turned follows it. */
const [GROWTH, SHIFT] = [1.15, 0.02];
/** Parts of its distance that the camera is off by rounding, not by hand. */
const ROUNDING = 1e-6;
/** A side of the surface is the same but for rounding. */
const SAME = 1e-4;
/** What has no width is looked at as if it had so much, in parts of the whole surface. */
const THREAD = 1e-6;
/** Ends of a path are seen that lie so far apart, in parts of the width of the surface. */
const FARTHEST = 6;
/** How much farther than the surface without its spikes these are drawn. */
const DEEP = 200;

/** @typedef {{ top: number, bottom: number }} Covered CSS pixels at the edges of the view that other things stand over */

export class Eye {
  camera = new PerspectiveCamera(FIELD_OF_VIEW, 1, 0.1, 100);
  controls;
  /** About what must fit into the view. */
  #bounds = new Sphere(new Vector3(), 1);
  /** About all of the surface. */
  #whole = new Sphere(new Vector3(), 1);
  /** What must fit into the view. @type {import('../../web/view/spikes.js').Points | null} */ #points = null;
  #size = { width: 1, height: 1 };
  /** @type {Covered} */ #covered = { top: 0, bottom: 0 };
  /** Where the camera looked at, and from how far, when all of the surface was fitted. */
  #fitted = { target: new Vector3(), distance: 1 };
  /** Where it would fit from the side to which it was turned; null: turned since. @type {{ target: Vector3, distance: number } | null} */ #planned =
    null;
  /** The side that all of the surface was last shown from. */
  #framed = new Vector3(0, 0, 1);
  /** Whether the reader has come nearer, stepped back or moved aside since: then the view is not ours to change. One that is only turned is. */
  #touched = false;
  /** Where the surface was then. */
  #seen = new Sphere();

  /** @param {HTMLCanvasElement} canvas @param {() => void} onChange */
  constructor(canvas, onChange) {
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, canvas);
    Object.assign(this.controls, { enableDamping: true, dampingFactor: 0.12, rotateSpeed: 0.9 });
    turnByKeys(canvas, this.controls);
    // At 400 % the page is one column, which scrolls.
    shareWheel(canvas, () => this.controls, { scrolls: () => document.documentElement.scrollHeight > innerHeight });
    this.controls.addEventListener('change', () => {
      onChange();
      this.#planned = null;
      if (this.#touched || this.#isFitted()) return;
      this.#touched = true;
      this.#seen.copy(this.#bounds);
    });
  }

  /**
   * @param {import('three').BufferGeometry} geometry @param {readonly ArrayLike<number>[]} ends places on it that should be seen, x y z each
   * @param {number} chosen along so many axes it is as long as the reader wishes: all of that is seen
   * @returns what is seen along each axis, from and to
   */
  setSurface(geometry, ends, chosen) {
    if (!this.#touched && this.#points) this.#planned ??= this.#plan(this.#towards());
    this.#whole.copy(/** @type {Sphere} */ (geometry.boundingSphere));
    const all = geometry.getAttribute('position');
    const ranges = rangesWithoutSpikes(all, ends, FARTHEST, chosen);
    const bulk = pointsWithin(all, ranges, ends);
    this.#points = bulk ?? all;
    if (bulk) new Box3().setFromBufferAttribute(bulk).getBoundingSphere(this.#bounds);
    else this.#bounds.copy(this.#whole);
    this.#bounds.radius ||= THREAD * this.#whole.radius;
    return ranges;
  }

  /**
   * Looks at the whole surface again, from the same side, if it is noticeably larger, smaller or elsewhere; once the reader has chosen a distance or a place,
   * only if it has outgrown the view, left it, or become tiny in it, and not because of what the reader left out.
   */
  refit() {
    if (!this.#points || this.#isAsLeft()) return;
    if (!this.#touched) {
      const { target, distance } = this.#plan(this.#towards());
      const before = this.#planned ?? this.#fitted;
      const growth = distance / before.distance;
      const isOff = growth > GROWTH || growth < 1 / GROWTH || target.distanceTo(before.target) > SHIFT * distance;
      return isOff && this.#fit(this.#towards());
    }
    this.camera.updateMatrixWorld();
    const { reach, extent } = shareOfView(this.#points, this.camera.matrixWorldInverse, this.#slopes(0));
    if (reach > 1 || extent < TINY) this.#fit(this.#towards());
  }

  /** Whether the camera is as far, and looks at the same place, as when it was fitted. */
  #isFitted() {
    const { target, distance } = this.#fitted;
    const off = Math.abs(this.camera.position.distanceTo(this.controls.target) - distance) + target.distanceTo(this.controls.target);
    return off <= ROUNDING * distance;
  }

  /** Whether the reader has chosen the view of a surface that was about as large, and there. */
  #isAsLeft() {
    const { center, radius } = this.#bounds;
    const growth = radius / this.#seen.radius;
    return this.#touched && growth < 1.5 && growth > 0.4 && center.distanceTo(this.#seen.center) < this.#seen.radius;
  }

  /** From what is looked at to the camera, unit length. */
  #towards() {
    return this.camera.position.clone().sub(this.controls.target).normalize();
  }

  /**
   * Whence the reader looks: degrees around and up; and the distance, and how far what is looked at is from the surface's middle, in its radii, where the reader
   * has chosen these. Nothing: as it was framed.
   */
  get view() {
    const towards = this.#towards();
    if (!this.#touched && this.#framed.distanceTo(towards) < SAME) return [];
    const { center, radius } = this.#bounds;
    const { target } = this.controls;
    const place = this.#touched
      ? [this.camera.position.distanceTo(target) / radius, ...target.clone().sub(center).divideScalar(radius)]
      : [];
    const angles = [Math.atan2(towards.y, towards.x), Math.asin(towards.z)].map(MathUtils.radToDeg);
    return [...angles, ...place].map((number) => Number(number.toFixed(2)));
  }

  /** @param {readonly number[]} view */
  #look([around, up, distance, ...place]) {
    const [turn, rise] = [around, up].map(MathUtils.degToRad);
    const towards = new Vector3(Math.cos(turn) * Math.cos(rise), Math.sin(turn) * Math.cos(rise), Math.sin(rise));
    this.#fit(tilted(towards, this.camera.up));
    if (place.length === 0) return;
    const { center, radius } = this.#bounds;
    this.controls.target.fromArray(place).multiplyScalar(radius).add(center);
    this.camera.position.copy(this.controls.target).addScaledVector(towards, distance * radius);
    this.controls.update();
  }

  /** Looks at the whole surface from the side where a curve is. @param {ArrayLike<number>} curve x y z of each place @param {readonly number[]} [direction] to look from instead @param {readonly number[]} [view] of a reader who did so before */
  frame(curve, direction, view = []) {
    this.#halt();
    const towards = direction ? new Vector3(...direction).normalize() : sideOf(curve, this.#bounds);
    this.#framed = tilted(towards, this.camera.up);
    this.#fit(this.#framed);
    if (view.length > 0) this.#look(view);
  }

  /** What is left of a turn that runs out would turn whatever is looked at next. */
  #halt() {
    this.controls.enableDamping = false;
    this.controls.update();
    this.controls.enableDamping = true;
  }

  /** @param {number} width in CSS pixels @param {number} height @param {Covered} covered */
  resize(width, height, covered) {
    this.#size = { width, height };
    this.#covered = covered;
    this.camera.aspect = width / height;
    const { top, bottom } = covered;
    this.camera.setViewOffset(width, height, 0, (bottom - top) / 2, width, height);
    if (!this.#touched) this.#fit(this.#towards());
  }

  /** Tangents of half the angles of view, across and up, of what nothing stands over. @param {number} margin CSS pixels, both sides together */
  #slopes(margin) {
    const { width, height } = this.#size;
    const { top, bottom } = this.#covered;
    const slope = Math.tan((FIELD_OF_VIEW * Math.PI) / 360) / height;
    return [slope * (width - margin), slope * (height - top - bottom - margin)];
  }

  /** Where all of the surface just fits. @param {Vector3} towards the camera, unit length */
  #plan(towards) {
    const { width, height } = this.#size;
    const slopes = this.#slopes(Math.max(MARGIN * Math.min(width, height), LEAST_MARGIN));
    return fitView(
      /** @type {import('../../web/view/spikes.js').Points} */ (this.#points),
      this.#bounds.center,
      towards,
      this.camera.up,
      slopes,
    );
  }

  /** @param {Vector3} towards the camera, unit length */
  #fit(towards) {
    if (!this.#points) return;
    const { radius } = this.#bounds;
    const { target, distance } = this.#plan(towards);
    Object.assign(this.controls, { minDistance: 0.15 * radius, maxDistance: 20 * radius });
    this.controls.target.copy(target);
    this.camera.position.copy(target).addScaledVector(towards, distance);
    this.controls.update();
    this.#fitted = { target, distance: this.camera.position.distanceTo(target) };
    this.#planned = { target, distance };
    this.#touched = false;
  }

  /** Brings the camera to where it is in this frame; depths as near to the surface as may be. */
  update() {
    this.controls.update();
    const { center, radius } = this.#whole;
    const { position } = this.camera;
    const distance = position.distanceTo(center);
    this.camera.near = Math.max(distance - 1.6 * radius, 0.01 * this.#bounds.radius);
    this.camera.far = Math.min(distance + 1.6 * radius, position.distanceTo(this.#bounds.center) + DEEP * this.#bounds.radius);
    this.camera.updateProjectionMatrix();
  }
}
