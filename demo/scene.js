/** The 3D view: camera, light, surface, curves and handles. Draws only when something has changed. Knows nothing of formulas and solvers. */

import { Color, Group, HemisphereLight, NeutralToneMapping, PerspectiveCamera, Scene, Sphere, Vector3, WebGLRenderer } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { GeodesicLine } from 'surfpath/three';
import { fitView } from './fit.js';
import { addLights } from './light.js';
import { Strokes } from './strokes.js';
import { SurfaceObject } from './surface-object.js';

/** @typedef {Record<'surface' | 'halo' | 'path' | 'start' | 'other' | 'sky' | 'ground' | 'via', string>} Theme colours */
/** @typedef {{ element: HTMLElement, point: ArrayLike<number> }} Anchor an element that stands over a point */
/** @typedef {{ starts: Float64Array[], paths: Float64Array[], others: Float64Array[], warmth: number }} Curves */

const ELEVATION = Math.PI / 6;
const FIELD_OF_VIEW = 32;
const MOST_PIXELS = 2;
/** CSS pixels at the lower edge that the player covers. */
const COVERED = 64;
/** Share of the view that stays free around the surface, both sides together. */
const MARGIN = 0.1;
/** In CSS pixels, at least: the legend stands there on small screens. */
const LEAST_MARGIN = 56;
/** Drawn after one another; the markers of handles come after all. */
const ORDER = { others: 1, starts: 4, paths: 7 };
const WIDTH = { others: 2.5, starts: 2, paths: 4 };

export class View {
  #renderer;
  #scene = new Scene();
  #camera = new PerspectiveCamera(FIELD_OF_VIEW, 1, 0.1, 100);
  #controls;
  #curves = new Group();
  #surface = new SurfaceObject();
  #sky = new HemisphereLight();
  /** @type {Record<'starts' | 'paths' | 'others', GeodesicLine[]>} */ #lines = { starts: [], paths: [], others: [] };
  #strokes = new Strokes();
  /** @type {Anchor[]} */ #anchors = [];
  #bounds = new Sphere(new Vector3(), 1);
  #size = { width: 1, height: 1 };
  #pending = false;
  /** Whether the reader has turned the view: then it is not ours to change. */
  #touched = false;
  /** @type {Theme | null} */ #theme = null;
  #warmth = 1;
  /** Called after the first frame with a surface. @type {(() => void) | null} */ onFirst = null;
  /** Called before each frame. @type {() => void} */ onDraw = () => {};

  /** Throws where there is no WebGL. @param {HTMLElement} element @param {HTMLCanvasElement} canvas */
  constructor(element, canvas) {
    this.#renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true, powerPreference: 'low-power' });
    this.#renderer.toneMapping = NeutralToneMapping;
    this.#camera.up.set(0, 0, 1);
    addLights(this.#scene, this.#camera, this.#sky);
    this.#curves.add(this.#strokes);
    this.#scene.add(this.#camera, this.#surface, this.#curves);
    this.#controls = new OrbitControls(this.#camera, canvas);
    Object.assign(this.#controls, { enableDamping: true, dampingFactor: 0.12, rotateSpeed: 0.9 });
    this.#controls.addEventListener('change', () => this.invalidate());
    this.#controls.addEventListener('start', () => {
      this.#touched = true;
    });
    this.#resize(element);
    new ResizeObserver(() => this.#resize(element)).observe(element);
  }

  get canvas() {
    return this.#renderer.domElement;
  }

  /** The surface's mesh, for exports and rays. */
  get surface() {
    return this.#surface;
  }

  get camera() {
    return this.#camera;
  }

  get controls() {
    return this.#controls;
  }

  /** The theme's colours. */
  get theme() {
    return this.#theme;
  }

  /** Adds what is placed in the surface's coordinates. @param {import('three').Object3D} object */
  add(object) {
    this.#scene.add(object);
  }

  /** Numbers of geometries, textures and programs that the graphics card holds for this view. */
  get memory() {
    const { memory, programs } = this.#renderer.info;
    return { ...memory, programs: programs?.length ?? 0 };
  }

  /** @param {Theme} theme */
  setTheme(theme) {
    this.#theme = theme;
    this.#surface.setColour(theme.surface);
    this.#sky.color.set(theme.sky);
    this.#sky.groundColor.set(theme.ground);
    this.#paint();
  }

  /** @param {import('./drawable.js').SurfaceMesh} mesh @returns {boolean} whether it is much larger or smaller than the last one, or elsewhere */
  setSurface(mesh) {
    const last = this.#bounds.clone();
    this.#surface.setMesh(mesh);
    this.#bounds.copy(/** @type {Sphere} */ (this.#surface.geometry.boundingSphere));
    this.#bounds.radius = Math.max(this.#bounds.radius, 1e-6);
    this.invalidate();
    const growth = this.#bounds.radius / last.radius;
    return growth > 1.5 || growth < 0.4 || this.#bounds.center.distanceTo(last.center) > last.radius;
  }

  /** Colours the surface by a number a vertex. @param {string} quantity @param {Float64Array | null} values */
  setValues(quantity, values) {
    this.invalidate();
    return this.#surface.setValues(quantity, values);
  }

  /** Strokes on the surface that show a metric. @param {Float64Array | null} ends two points each, x y z */
  setStrokes(ends) {
    this.#strokes.setEnds(ends);
    this.invalidate();
  }

  /** @param {Curves} curves */
  setCurves(curves) {
    this.#warmth = curves.warmth;
    for (const role of /** @type {const} */ (['starts', 'paths', 'others'])) this.#fill(role, curves[role]);
    this.#paint();
  }

  /** @param {'starts' | 'paths' | 'others'} role @param {Float64Array[]} curves */
  #fill(role, curves) {
    const lines = this.#lines[role];
    while (lines.length > curves.length) {
      const line = /** @type {GeodesicLine} */ (lines.pop());
      line.dispose();
    }
    for (const [i, points] of curves.entries()) {
      if (!lines[i]) {
        lines[i] = new GeodesicLine(null, { width: WIDTH[role] });
        lines[i].setOrder(ORDER[role]);
        this.#curves.add(lines[i]);
      }
      lines[i].setPath(points);
    }
  }

  /** @param {Anchor[]} anchors */
  setAnchors(anchors) {
    this.#anchors = anchors;
    this.invalidate();
  }

  #paint() {
    const theme = this.#theme;
    if (!theme) return;
    const colours = (/** @type {Color} */ colour) => ({ colour, halo: theme.halo });
    const [start, other] = [new Color(theme.start), new Color(theme.other)];
    this.#strokes.material.color.set(theme.via);
    const path = start.clone().lerp(new Color(theme.path), this.#warmth);
    for (const line of this.#lines.starts) line.setColours(colours(start));
    for (const line of this.#lines.others) line.setColours(colours(other));
    for (const line of this.#lines.paths) line.setColours(colours(path));
    this.invalidate();
  }

  /** Looks at the whole surface from 30 degrees above, from the side where something is. @param {ArrayLike<number> | null} something x y z @param {readonly number[]} [direction] to look from instead */
  frame(something, direction) {
    const { center, radius } = this.#bounds;
    const towards = something ? new Vector3(something[0], something[1], something[2]).sub(center).setZ(0) : new Vector3();
    if (towards.length() < 0.08 * radius) towards.set(0.6, -1, 0);
    towards.normalize().multiplyScalar(Math.cos(ELEVATION)).setZ(Math.sin(ELEVATION));
    if (direction) towards.fromArray(direction).normalize();
    // Straight from above there is no "up": a hair from the front.
    if (Math.hypot(towards.x, towards.y) < 1e-3) towards.set(0, -1e-3, 1).normalize();
    this.#controls.minDistance = 0.15 * radius;
    this.#controls.maxDistance = 20 * radius;
    this.#touched = false;
    this.#fit(towards);
  }

  /** @param {Vector3} towards the camera, unit length */
  #fit(towards) {
    const points = this.#surface.geometry.getAttribute('position');
    if (!points) return;
    const { width, height } = this.#size;
    const slope = Math.tan((FIELD_OF_VIEW * Math.PI) / 360) / height;
    const margin = Math.max(MARGIN * Math.min(width, height), LEAST_MARGIN);
    const slopes = [slope * (width - margin), slope * (height - COVERED - margin)];
    const { target, distance } = fitView(points, this.#bounds.center, towards, this.#camera.up, slopes);
    this.#controls.target.copy(target);
    this.#camera.position.copy(target).addScaledVector(towards, distance);
    this.#controls.update();
    this.invalidate();
  }

  /** Draws in the next frame. */
  invalidate() {
    if (this.#pending) return;
    this.#pending = true;
    requestAnimationFrame(() => this.draw());
  }

  /** Draws now. */
  draw() {
    this.#pending = false;
    this.#controls.update();
    const { center, radius } = this.#bounds;
    const distance = this.#camera.position.distanceTo(center);
    this.#camera.near = Math.max(distance - 1.6 * radius, 0.01 * radius);
    this.#camera.far = distance + 1.6 * radius;
    this.#camera.updateProjectionMatrix();
    this.#scene.updateMatrixWorld();
    this.#placeAnchors();
    this.onDraw();
    this.#renderer.render(this.#scene, this.#camera);
    if (this.onFirst && this.#surface.geometry.index) {
      this.onFirst();
      this.onFirst = null;
    }
  }

  /** Where a point of space is on the screen, in CSS pixels of the view. @param {ArrayLike<number>} point @returns {[number, number]} */
  toScreen(point) {
    const place = new Vector3(point[0], point[1], point[2]).project(this.#camera);
    return [((place.x + 1) / 2) * this.#size.width, ((1 - place.y) / 2) * this.#size.height];
  }

  #placeAnchors() {
    for (const { element, point } of this.#anchors) {
      const [x, y] = this.toScreen(point);
      element.style.transform = `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px)`;
    }
  }

  /** @param {HTMLElement} element */
  #resize(element) {
    const { width, height } = element.getBoundingClientRect();
    if (width < 1 || height < 1) return;
    this.#size = { width, height };
    this.#renderer.setPixelRatio(Math.min(window.devicePixelRatio, MOST_PIXELS));
    this.#renderer.setSize(width, height, false);
    this.#camera.aspect = width / height;
    this.#camera.setViewOffset(width, height, 0, COVERED / 2, width, height);
    if (!this.#touched) this.#fit(this.#camera.position.clone().sub(this.#controls.target).normalize());
    // A resized canvas is empty until it is drawn: draw before the browser paints.
    this.draw();
  }
}
