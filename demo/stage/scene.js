/** The 3D view: light, surface, curves and handles, seen by an eye. Draws only when something has changed. Knows nothing of formulas and solvers. */

import { HemisphereLight, NeutralToneMapping, Raycaster, Scene, Vector2, Vector3, WebGLRenderer } from 'three';
import { Marker } from 'surfpath/three';
import { addLights } from '../../web/view/light.js';
import { watchPixels } from '../../web/view/pixels.js';
import { CurveLines } from './curve-lines.js';
import { Eye } from './eye.js';
import { Strokes } from './strokes.js';
import { SurfaceObject } from './surface-object.js';

/** @typedef {Record<'surface' | 'halo' | 'path' | 'start' | 'other' | 'sky' | 'ground' | 'via', string>} Theme colours */
/** @typedef {import('./curve-lines.js').Curves} Curves */

const MOST_PIXELS = 2;
/** Radius and ring of the point that is pointed at, in CSS pixels. */
const DOT = /** @type {const} */ ([4.5, 2]);

const INK = '#1d2733';

export class View {
  #element;
  #renderer;
  #eye;
  #scene = new Scene();
  #curves = new CurveLines();
  #surface = new SurfaceObject();
  #sky = new HemisphereLight();
  #strokes = new Strokes();
  #dot = new Marker();
  #rays = new Raycaster();
  #size = { width: 1, height: 1 };
  #pending = false;
  /** Shaders are being compiled, beside the page's thread: what is seen stays until they are ready. */
  #isCompiling = false;
  /** @type {Theme | null} */ #theme = null;
  /** Called after the first frame with a surface. @type {(() => void) | null} */ onFirst = null;
  /** Called when the browser takes the graphics card away, and when it gives it back. @type {(isLost: boolean) => void} */ onLost =
    () => {};
  /** Called before each frame. @type {() => void} */ onDraw = () => {};

  /** Throws where there is no WebGL. @param {HTMLElement} element @param {HTMLCanvasElement} canvas */
  constructor(element, canvas) {
    this.#element = element;
    this.#renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true, powerPreference: 'low-power' });
    this.#renderer.toneMapping = NeutralToneMapping;
    this.#eye = new Eye(canvas, () => this.invalidate());
    this.#dot.visible = false;
    this.#dot.setRadius(...DOT);
    addLights(this.#scene, this.camera, this.#sky);
    this.#scene.add(this.camera, this.#surface, this.#strokes, this.#curves, this.#dot);
    this.#compile();
    this.resize();
    new ResizeObserver(() => this.resize()).observe(element);
    watchPixels(() => this.resize());
    // Phones take it from pages behind others; what it held is sent again with the next frame.
    canvas.addEventListener('webglcontextlost', () => this.onLost(true));
    canvas.addEventListener('webglcontextrestored', () => {
      this.onLost(false);
      this.#compile();
    });
  }

  get canvas() {
    return this.#renderer.domElement;
  }

  /** The surface's mesh, for exports and rays. */
  get surface() {
    return this.#surface;
  }

  get camera() {
    return this.#eye.camera;
  }

  get controls() {
    return this.#eye.controls;
  }

  /** Whence it is looked at, see `Eye`. */
  get view() {
    return this.#eye.view;
  }

  /** The theme's colours. */
  get theme() {
    return this.#theme;
  }

  /** Adds what is placed in the surface's coordinates. @param {import('three').Object3D} object */
  add(object) {
    this.#scene.add(object);
  }

  /** Numbers of geometries and textures that the graphics card holds for this view, and its programs by number. */
  get memory() {
    const { memory, programs } = this.#renderer.info;
    return { ...memory, programs: (programs ?? []).map(({ id }) => id) };
  }

  /** How many strokes show a metric. */
  get strokes() {
    return this.#strokes.count;
  }

  /** Where the point is that is pointed at; null: nothing is. */
  get dot() {
    return this.#dot.visible ? this.#dot.position.toArray() : null;
  }

  /** @param {Theme} theme */
  setTheme(theme) {
    this.#theme = theme;
    this.#surface.setColour(theme.surface);
    this.#sky.color.set(theme.sky);
    this.#sky.groundColor.set(theme.ground);
    this.#colourStrokes();
    this.#dot.setColours({ colour: theme.via, ring: theme.halo });
    this.#curves.paint(theme);
    this.invalidate();
  }

  /** @param {import('../compute/drawable.js').SurfaceMesh} mesh @param {readonly ArrayLike<number>[]} ends see `Eye` @param {number} chosen */
  setSurface(mesh, ends, chosen) {
    this.#surface.setMesh(mesh);
    this.#compile();
    return this.#eye.setSurface(this.#surface.geometry, ends, chosen);
  }

  /** Colours the surface by a number a vertex. @param {string} quantity @param {Float64Array | null} values */
  setValues(quantity, values) {
    const scale = this.#surface.setValues(quantity, values);
    this.#colourStrokes();
    this.#compile();
    return scale;
  }

  /** As the theme's ink on the bare surface; what is coloured is light in both themes. */
  #colourStrokes() {
    this.#strokes.material.color.set(this.#surface.isColoured ? INK : (this.#theme?.via ?? INK));
  }

  /** Strokes on the surface that show a metric. @param {Float64Array | null} ends two points each, x y z */
  setStrokes(ends) {
    this.#strokes.setEnds(ends);
    this.invalidate();
  }

  /** @param {Curves} curves */
  setCurves(curves) {
    this.#curves.setCurves(curves);
    if (this.#theme) this.#curves.paint(this.#theme);
    this.invalidate();
  }

  /** Marks the point that is pointed at elsewhere. @param {ArrayLike<number> | null} place x y z */
  setDot(place) {
    if (!place && !this.#dot.visible) return;
    this.#dot.visible = place !== null;
    if (place) this.#dot.position.set(place[0], place[1], place[2]);
    this.invalidate();
  }

  /** Looks at the whole surface. @param {ArrayLike<number>} curve @param {readonly number[]} [direction] @param {readonly number[]} [view] see `Eye` */
  frame(curve, direction, view) {
    this.#eye.frame(curve, direction, view);
    this.invalidate();
  }

  /** Looks at the whole surface again if it does not fit any more, or is tiny. */
  refit() {
    this.#eye.refit();
    this.invalidate();
  }

  /** What a place of the window shows of the surface. @param {number} x @param {number} y @returns {{ place: number[], shares: number[] | null } | null} x y z, and shares of the parameters' ranges */
  pick(x, y) {
    const { left, top } = this.canvas.getBoundingClientRect();
    const { width, height } = this.#size;
    this.#rays.setFromCamera(new Vector2((2 * (x - left)) / width - 1, 1 - (2 * (y - top)) / height), this.camera);
    const [hit] = this.#rays.intersectObject(this.#surface, false);
    return hit ? { place: hit.point.toArray(), shares: hit.uv?.toArray() ?? null } : null;
  }

  /** Draws in the next frame. */
  invalidate() {
    if (this.#pending) return;
    this.#pending = true;
    requestAnimationFrame(() => {
      this.#pending = false;
      if (!this.#isCompiling) this.draw();
    });
  }

  /** Has the shaders ready that are new, then draws. */
  async #compile() {
    if (this.#isCompiling) return;
    // Without the extension nobody knows when they are ready: drawing waits for them.
    if (this.#renderer.getContext().getExtension('KHR_parallel_shader_compile')) {
      this.#isCompiling = true;
      // In a task of its own: what is new has taken long enough.
      await new Promise((resolve) => setTimeout(resolve));
      await this.#renderer.compileAsync(this.#scene, this.camera);
      this.#isCompiling = false;
    } else this.#renderer.compile(this.#scene, this.camera);
    this.invalidate();
  }

  /** Draws now. */
  draw() {
    this.#eye.update();
    this.#scene.updateMatrixWorld();
    this.onDraw();
    this.#renderer.render(this.#scene, this.camera);
    if (this.onFirst && this.#surface.geometry.index) {
      this.onFirst();
      this.onFirst = null;
    }
  }

  /** Width and height, in CSS pixels. */
  get size() {
    return this.#size;
  }

  /** Where a point of space is on the screen, in CSS pixels of the view. @param {ArrayLike<number>} point @returns {[number, number]} */
  toScreen(point) {
    const place = new Vector3(point[0], point[1], point[2]).project(this.camera);
    return [((place.x + 1) / 2) * this.#size.width, ((1 - place.y) / 2) * this.#size.height];
  }

  /** As large as its place in the page. */
  resize() {
    const { clientWidth: width, clientHeight: height } = this.#element;
    if (width < 1 || height < 1) return;
    // The style sheet knows what stands over the view: it is the view's padding.
    const { paddingTop, paddingBottom } = getComputedStyle(this.#element);
    const covered = { top: Number.parseFloat(paddingTop), bottom: Number.parseFloat(paddingBottom) };
    this.setSize({ width, height }, covered, Math.min(window.devicePixelRatio, MOST_PIXELS));
  }

  /** Draws at once, since a resized canvas is empty until then. @param {{ width: number, height: number }} size CSS pixels @param {import('./eye.js').Covered} covered @param {number} ratio pixels a CSS pixel */
  setSize(size, covered, ratio) {
    this.#size = size;
    this.#renderer.setPixelRatio(ratio);
    this.#renderer.setSize(size.width, size.height, false);
    this.#eye.resize(size.width, size.height, covered);
    this.draw();
  }
}
