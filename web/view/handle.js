/** A point of a surface that is dragged over it, by mouse, finger and arrow keys. What is pressed and focused is a button of the page that follows the point. */

import { Group, Matrix4, Raycaster, Vector2, Vector3 } from 'three';
import { checkOptions } from '../arguments.js';
import { HandleButton } from './button.js';
import { checkDrawable, checkInside, checkPixels } from './check.js';
import { Marker } from './marker.js';
import { Picker } from './pick.js';
import { stepAlong } from './step.js';

/** @typedef {import('../surface.js').Surface} Surface */
/** @typedef {import('three').ColorRepresentation} Colour */

/**
 * @typedef {object} DragHandleOptions
 * @property {import('three').Camera} camera that the view is seen through
 * @property {HTMLElement} domElement the canvas; the handle's button is added after it, so its parent should be what positions both
 * @property {import('three').Mesh} [mesh] the surface as drawn, a child of the handle's parent: rays are cast at it; default: an own one, made when first needed
 * @property {{ enabled: boolean }} [controls] of the camera; off while dragging
 * @property {string} [label] what the button is called; default 'Point'
 * @property {Colour} [colour] @property {Colour} [ring] the colour of the ring around it
 * @property {number} [radius] of the ball, in CSS pixels; default 6. What can be pressed is 24 pixels wide at least, 44 for a finger
 * @property {number} [step] of an arrow key, in CSS pixels; with Shift five times that; default 8
 * @property {(point: number[], handle: DragHandle) => void} [onDrag] the point has moved: u v or x y z
 * @property {(handle: DragHandle) => void} [onDragStart] it is pressed @property {(handle: DragHandle) => void} [onDragEnd] it is let go; or the arrow key that moved it is
 * @property {() => void} [onChange] it looks different: draw again
 */

const NAMES = ['camera', 'domElement', 'mesh', 'controls', 'label', 'colour', 'ring', 'radius', 'step'];
const EVENTS = ['onDrag', 'onDragStart', 'onDragEnd', 'onChange'];
const RING_WIDTH = 2.5;
const GROWTH = 1.3;
/** Share of the distance from the eye by which the surface must be before the point to hide it. */
const BEHIND = 0.02;

const raycaster = new Raycaster();
const pointer = new Vector2();
const projected = new Vector3();
const drawn = new Vector2();

/** Where what was projected is in a view, in pixels from where its place is measured from. @param {{ left: number, top: number, width: number, height: number }} view @returns {[number, number]} */
const placeIn = ({ left, top, width, height }) => [left + ((projected.x + 1) / 2) * width, top + ((1 - projected.y) / 2) * height];

/** Add it beside the surface's mesh, in whose coordinates it is placed. */
export class DragHandle extends Group {
  /** @type {number[]} */ #point = [];
  #surface;
  /** @type {Picker | null} */ #picker = null;
  #marker = new Marker();
  #button;
  #options;
  /** Whether it is behind the surface: then it is dragged there. */
  #isHidden = false;
  /** Whether the controls were, before it was dragged; null: it is not. @type {boolean | null} */ #wereEnabled = null;
  /** Where the view was drawn last, in CSS pixels from the corner of the canvas; nowhere at first. */
  #view = { left: 0, top: 0, width: 0, height: 0 };

  /**
   * @param {Surface} surface parametric or implicit; TypeError if it has no positions
   * @param {ArrayLike<number>} point u v in the rectangle, or x y z, which is projected
   * @param {DragHandleOptions} options
   */
  constructor(surface, point, options) {
    super();
    checkDrawable('DragHandle', surface);
    checkOptions('DragHandle', options ?? {}, [...NAMES, ...EVENTS]);
    if (!options?.camera || !options.domElement) throw new TypeError('DragHandle: options.camera and options.domElement are needed');
    const { label = 'Point', radius = 6, step = 8, onChange = () => {}, colour, ring } = options;
    checkPixels('DragHandle: options.', { radius, step });
    // Nobody draws what is not made yet.
    this.#options = { ...options, label, radius, step, onChange: () => {} };
    this.#surface = surface;
    this.add(this.#marker);
    this.#marker.onDraw = (camera, viewport, renderer) => this.#follow(camera, viewport, renderer);
    this.setColours({ colour, ring });
    this.#highlight(false);
    this.setPoint(point);
    this.#button = new HandleButton(options.domElement, this.#options.label, {
      press: (x, y) => this.#begin(x, y),
      move: (x, y) => this.#moveTo(x, y),
      release: () => this.#end(),
      nudge: (right, up) => this.#nudge(right, up),
      highlight: (on) => this.#highlight(on),
    });
    this.#options.onChange = onChange;
  }

  /** Where it is: u v, or x y z; a copy. */
  get point() {
    return [...this.#point];
  }

  /** The button that is pressed and focused: for a tooltip, a description, or a class. */
  get element() {
    return this.#button.element;
  }

  /** Moves it, without calling `onDrag`. RangeError outside the rectangle, and what `project` throws. @param {ArrayLike<number>} point as for the constructor */
  setPoint(point) {
    this.#put(this.#surface, point);
  }

  /** @param {Surface} surface @param {ArrayLike<number>} point */
  #put(surface, point) {
    const given = Array.from(point);
    const { domain } = surface;
    if (domain) checkInside('DragHandle: point', domain, given);
    const place = domain ? given : surface.project(given);
    const position = domain ? surface.evaluate(place) : place;
    if (![0, 1, 2].every((k) => Number.isFinite(position[k]))) throw new RangeError(`DragHandle: the surface has no point at [${place}]`);
    this.#surface = surface;
    this.#point = place;
    this.position.set(position[0], position[1], position[2]);
    this.#options.onChange();
  }

  /**
   * Puts it on another surface, where a drag ends, or on the same one after `surface.set`.
   * @param {Surface} surface @param {ArrayLike<number>} [point] default: where it is
   * @param {import('three').Mesh} [mesh] default: an own one
   */
  setSurface(surface, point = this.#point, mesh = undefined) {
    checkDrawable('DragHandle', surface);
    if (surface !== this.#surface) this.#button.letGo();
    this.#put(surface, point);
    this.#picker?.dispose();
    this.#picker = null;
    this.#options.mesh = mesh;
  }

  /** What is not named stays. @param {{ colour?: Colour, ring?: Colour }} colours */
  setColours(colours) {
    this.#marker.setColours(colours);
    this.#options.onChange();
  }

  /** Frees what it holds, removes its button, and leaves its scene. */
  dispose() {
    this.#button.dispose();
    this.#picker?.dispose();
    this.#picker = null;
    this.#marker.dispose();
    this.removeFromParent();
  }

  /** @param {boolean} on */
  #highlight(on) {
    this.#marker.setRadius((on ? GROWTH : 1) * this.#options.radius, RING_WIDTH);
    this.#options.onChange();
  }

  /**
   * Keeps the button over the point. A canvas of the renderer's own may be shown larger or smaller than it is drawn.
   * @param {import('three').Camera} camera @param {import('three').Vector4} viewport @param {import('three').WebGLRenderer} renderer
   */
  #follow(camera, viewport, renderer) {
    const { domElement } = this.#options;
    if (camera !== this.#options.camera) return;
    const isOwn = renderer.domElement === domElement;
    const { x: across, y: down } = isOwn ? renderer.getSize(drawn) : { x: domElement.clientWidth, y: domElement.clientHeight };
    const [wide, high] = [domElement.clientWidth / across, domElement.clientHeight / down];
    const [width, height] = [viewport.z * wide, viewport.w * high];
    this.#view = { left: viewport.x * wide, top: domElement.clientHeight - viewport.y * high - height, width, height };
    projected.setFromMatrixPosition(this.matrixWorld).project(camera);
    const seen = Math.abs(projected.x) <= 1 && Math.abs(projected.y) <= 1 && Math.abs(projected.z) <= 1;
    this.#button.place(...placeIn(this.#view), seen);
  }

  /** Where the view is in the window, as the page has placed and scaled it, in CSS pixels. */
  #window() {
    const { domElement } = this.#options;
    const box = domElement.getBoundingClientRect();
    const { left, top, width, height } = this.#view;
    if (!(width > 0)) return box;
    const scale = box.width / domElement.offsetWidth;
    const [x, y] = [domElement.clientLeft + left, domElement.clientTop + top];
    return { left: box.left + scale * x, top: box.top + scale * y, width: scale * width, height: scale * height };
  }

  /** @returns {Matrix4} from the surface's coordinates to the scene's */
  #frame() {
    this.updateWorldMatrix(true, false);
    return this.parent?.matrixWorld ?? new Matrix4();
  }

  /** The crossings of the surface are asked for through a point of the canvas. @param {number} x in CSS pixels of the window @param {number} y */
  #aim(x, y) {
    const { left, top, width, height } = this.#window();
    pointer.set((2 * (x - left)) / width - 1, 1 - (2 * (y - top)) / height);
    this.#options.camera.updateMatrixWorld();
    raycaster.setFromCamera(pointer, this.#options.camera);
  }

  #pick() {
    this.#picker ??= new Picker(this.#surface, this.#options.mesh);
    return this.#picker.pick(raycaster, this.#frame(), this.#isHidden ? this.position : null);
  }

  /** @param {number} x @param {number} y @returns {[number, number]} from there to the middle of the point, in pixels */
  #begin(x, y) {
    const { controls, camera, onDragStart } = this.#options;
    this.#frame();
    projected.setFromMatrixPosition(this.matrixWorld).project(camera);
    const [left, top] = placeIn(this.#window());
    this.#isHidden = false;
    this.#aim(left, top);
    this.#isHidden = this.#isBehind();
    if (controls) [this.#wereEnabled, controls.enabled] = [controls.enabled, false];
    onDragStart?.(this);
    return [left - x, top - y];
  }

  /** Whether the ray to the point meets the surface well before it. */
  #isBehind() {
    const first = this.#pick();
    if (!first) return false;
    const position = this.#surface.kind === 'implicit' ? first : this.#surface.evaluate(first);
    const gap = this.position.distanceTo(projected.fromArray(position));
    const distance = projected.setFromMatrixPosition(this.matrixWorld).distanceTo(raycaster.ray.origin);
    return gap * this.#frame().getMaxScaleOnAxis() > BEHIND * distance;
  }

  /** @param {number} x @param {number} y */
  #moveTo(x, y) {
    this.#aim(x, y);
    this.#accept(this.#pick());
  }

  /** @param {number} right steps @param {number} up */
  #nudge(right, up) {
    const { camera, step } = this.#options;
    camera.updateMatrixWorld();
    const pixels = /** @type {[number, number]} */ ([step * right, step * up]);
    this.#accept(stepAlong(this.#surface, this.#point, this.position, this.#frame(), camera, pixels, this.#window().height));
  }

  /** @param {number[] | null} point */
  #accept(point) {
    if (!point) return;
    this.setPoint(point);
    this.#options.onDrag?.(this.point, this);
  }

  #end() {
    const { controls, onDragEnd } = this.#options;
    if (controls && this.#wereEnabled !== null) controls.enabled = this.#wereEnabled;
    this.#wereEnabled = null;
    onDragEnd?.(this);
  }
}
