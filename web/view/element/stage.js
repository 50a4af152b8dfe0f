/** What <surface-path> shows: surface, path, ends, light and camera. Draws when something has changed and it is on screen. Knows no attributes and no solver. */

import { HemisphereLight, Mesh, PerspectiveCamera, Scene } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { HALO, PATH, START, SURFACE } from '../colours.js';
import { addLights } from '../light.js';
import { sideOf } from '../side.js';
import { DragHandle, fitCamera, GeodesicLine, Marker, PathPlayer, surfaceGeometry, surfaceMaterial } from '../three.js';
import { turnByKeys } from '../turn-keys.js';
import { shareWheel } from '../wheel.js';
import { acquireRenderer, drawInto, releaseRenderer } from './renderer.js';

/** @typedef {import('../../surface.js').Surface} Surface */
/** @typedef {import('../../path.js').Path} Path */
/** @typedef {import('./style.js').Theme} Theme */

const FIELD_OF_VIEW = 32;
const MOST_PIXELS = 2;
/** Share of the view that stays free around the surface; and, at its lower edge, the pixels that the words cover. */
const [MARGIN, COVERED] = [0.08, 30];

/** x y z of a point of a surface. @param {Surface} surface @param {number[]} point */
const placeOf = (surface, point) =>
  surface.kind === 'implicit' ? surface.project(point) : Array.from(surface.evaluate(point).subarray(0, 3));

/** Whether a surface has such a point. @param {Surface} surface @param {number[]} point */
export function hasPoint(surface, point) {
  try {
    return Boolean(surface.project(placeOf(surface, point), point));
  } catch {
    return false;
  }
}

export class Stage {
  #canvas;
  #scene = new Scene();
  #camera = new PerspectiveCamera(FIELD_OF_VIEW, 1, 0.1, 100);
  /** @type {OrbitControls | null} */ #controls = null;
  #keys = new AbortController();
  #mesh = new Mesh();
  /** Materials that hold the shaders until the next ones, drawn with them, hold them too. @type {import('three').Material[]} */ #outgoing =
    [];
  #line = new GeodesicLine();
  #player = new PathPlayer(this.#line, null, { onFrame: () => this.invalidate() });
  /** @type {(DragHandle | Marker)[]} */ #ends = [];
  #size = { width: 0, height: 0, ratio: 1 };
  /** @type {ArrayLike<number>} */ #towards = [0, -1, 0];
  #isVisible = false;
  #isFitted = false;
  /** Whether the reader has turned the view: then it is not ours to change. */
  #isTurned = false;
  #request = 0;
  #redraw = () => this.invalidate();
  #listening = new AbortController();
  /** @type {Theme} */ #theme = { surface: SURFACE, line: PATH, start: START, halo: HALO };

  /** Throws where there is no WebGL. @param {HTMLCanvasElement} canvas */
  constructor(canvas) {
    acquireRenderer(this.#redraw);
    this.#canvas = canvas;
    shareWheel(canvas, () => this.#controls, { signal: this.#listening.signal });
    this.#camera.up.set(0, 0, 1);
    addLights(this.#scene, this.#camera, new HemisphereLight('#ffffff', '#b9b2a6'));
    this.#scene.add(this.#camera, this.#line);
  }

  /** Whether there is a surface to look at. */
  get hasSurface() {
    return this.#mesh.parent !== null;
  }

  /** Takes a surface in place of the last one. @param {Surface} surface @param {import('../geometry.js').GeometryOptions} look */
  setSurface(surface, look) {
    const geometry = surfaceGeometry(surface, look);
    if (geometry.index?.count === 0)
      throw new RangeError('surface-path: nothing to draw: inside its bounds f is nowhere zero, or formulas have no value');
    const coloured = geometry.hasAttribute('color');
    this.#outgoing.push(/** @type {import('three').Material} */ (this.#mesh.material));
    this.#mesh.geometry.dispose();
    this.#mesh.geometry = geometry;
    this.#mesh.material = surfaceMaterial(geometry, coloured ? {} : { color: this.#theme.surface });
    this.#scene.add(this.#mesh);
    this.invalidate();
  }

  /** Looks at the surface anew. @param {ArrayLike<number> | undefined} towards the camera from there; else from 30 degrees above, from the side of the path @param {Path | null} path */
  frame(towards, path) {
    const bounds = /** @type {import('three').Sphere} */ (this.#mesh.geometry.boundingSphere);
    this.#towards = towards ?? sideOf(path?.points ?? [], bounds).toArray();
    [this.#isFitted, this.#isTurned] = [false, false];
    this.invalidate();
  }

  /** @param {Path | null} path */
  setPath(path) {
    this.#player.setPath(path);
  }

  /** Shows how the path came about. */
  play() {
    return this.#player.play();
  }

  /**
   * Puts the ends as points to look at, or to drag; those that are there are moved. Where the surface has no such point none is left, and it throws.
   * @param {Surface} surface @param {number[][]} points
   * @param {((end: number, point?: number[]) => void) | null} onDrag the same in every call, without a point where one is let go; null: to look at
   */
  setEnds(surface, points, onDrag) {
    const isSwitched = (this.#controls === null) === (onDrag !== null);
    if (isSwitched) this.#switchControls();
    this.#dropEnds(isSwitched ? 0 : points.length);
    try {
      for (const [i, point] of points.entries()) {
        if (i < this.#ends.length) this.#moveEnd(this.#ends[i], surface, point);
        else this.#ends.push(onDrag ? this.#makeHandle(surface, point, i, onDrag) : this.#makeMarker(surface, point));
        this.#scene.add(this.#ends[i]);
      }
    } catch (error) {
      // One that cannot be where it should be must not stay where it was.
      this.#dropEnds();
      throw error;
    }
    this.#paint();
  }

  /** @param {number} [first] from that one on */
  #dropEnds(first = 0) {
    for (const end of this.#ends.splice(first)) end.dispose();
  }

  /** @param {DragHandle | Marker} end @param {Surface} surface @param {number[]} point */
  #moveEnd(end, surface, point) {
    if (end instanceof DragHandle) end.setSurface(surface, point, this.#mesh);
    else end.position.fromArray(placeOf(surface, point));
  }

  /** @param {Surface} surface @param {number[]} point @param {number} i @param {(end: number, point?: number[]) => void} onDrag */
  #makeHandle(surface, point, i, onDrag) {
    return new DragHandle(surface, point, {
      camera: this.#camera,
      domElement: this.#canvas,
      mesh: this.#mesh,
      controls: /** @type {OrbitControls} */ (this.#controls),
      label: `${i === 0 ? 'Start' : 'End'} of the path`,
      onDrag: (place) => onDrag(i, place),
      onDragEnd: () => onDrag(i),
      onChange: () => this.invalidate(),
    });
  }

  /** @param {Surface} surface @param {number[]} point */
  #makeMarker(surface, point) {
    const marker = new Marker();
    marker.position.fromArray(placeOf(surface, point));
    return marker;
  }

  #switchControls() {
    if (this.#controls) this.#dropControls();
    else this.#makeControls();
    this.#isFitted = false;
  }

  #makeControls() {
    const controls = new OrbitControls(this.#camera, this.#canvas);
    // The page scrolls on under a finger that moves up or down.
    this.#canvas.style.touchAction = 'pan-y';
    controls.addEventListener('change', () => this.invalidate());
    controls.addEventListener('start', () => {
      this.#isTurned = true;
    });
    this.#keys = new AbortController();
    turnByKeys(this.#canvas, controls, this.#keys.signal);
    this.#controls = controls;
  }

  #dropControls() {
    this.#keys.abort();
    this.#controls?.dispose();
    this.#controls = null;
  }

  /** @param {Theme} theme */
  setTheme(theme) {
    this.#theme = theme;
    this.#player.setColours({ cool: theme.start, warm: theme.line });
    this.#paint();
  }

  /** Puts the theme's colours on what there is. */
  #paint() {
    const { surface, line, halo } = this.#theme;
    const material = /** @type {import('three').MeshStandardMaterial} */ (this.#mesh.material);
    if (this.hasSurface && !material.vertexColors) material.color.set(surface);
    this.#line.setColours({ halo });
    for (const end of this.#ends) end.setColours({ colour: line, ring: halo });
    this.invalidate();
  }

  /** @param {number} width in CSS pixels @param {number} height */
  resize(width, height) {
    if (width < 1 || height < 1) return;
    this.#size = { width: Math.round(width), height: Math.round(height), ratio: Math.min(devicePixelRatio, MOST_PIXELS) };
    this.#camera.aspect = width / height;
    this.#camera.setViewOffset(width, height, 0, COVERED / 2, width, height);
    if (!this.#isTurned) this.#isFitted = false;
    // A canvas that was resized is empty until it is drawn: draw before the browser paints.
    if (this.#isVisible) this.draw();
  }

  /** @param {boolean} visible on screen */
  setVisible(visible) {
    this.#isVisible = visible;
    if (visible) this.invalidate();
    else this.#player.finish();
  }

  /** Draws in the next frame, if it is on screen then. */
  invalidate() {
    if (this.#isVisible && !this.#request) this.#request = requestAnimationFrame(() => this.draw());
  }

  /** Draws at once. */
  draw() {
    cancelAnimationFrame(this.#request);
    this.#request = 0;
    if (!this.#isVisible || this.#size.width === 0 || !this.hasSurface) return;
    if (!this.#isFitted) this.#fit();
    drawInto(this.#canvas, this.#scene, this.#camera, this.#size);
    for (const material of this.#outgoing.splice(0)) material.dispose();
  }

  #fit() {
    this.#isFitted = true;
    const margin = Math.min(MARGIN + COVERED / this.#size.height, 0.5);
    // Where formulas have no value an end is nowhere.
    const shown = this.#ends.map(({ position }) => position.toArray()).filter((place) => place.every(Number.isFinite));
    const target = fitCamera(this.#camera, this.#mesh.geometry, this.#towards, margin, shown);
    if (!this.#controls) return;
    const distance = this.#camera.position.distanceTo(target);
    Object.assign(this.#controls, { minDistance: distance / 4, maxDistance: 2 * distance });
    this.#controls.target.copy(target);
    this.#controls.update();
  }

  /** Frees all that it holds; the last one gives the WebGL context back. */
  dispose() {
    cancelAnimationFrame(this.#request);
    this.#isVisible = false;
    this.#listening.abort();
    this.#player.dispose();
    this.#dropEnds();
    this.#dropControls();
    this.#line.dispose();
    this.#mesh.geometry.dispose();
    for (const material of [this.#mesh.material, ...this.#outgoing]) /** @type {import('three').Material} */ (material).dispose();
    releaseRenderer(this.#redraw);
  }
}
