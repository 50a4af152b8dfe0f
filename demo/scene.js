/** The 3D view: camera, light, surface, lines and handles. Draws only when something has changed. Knows nothing of formulas and solvers. */

import { Box3, Color, Group, HemisphereLight, NeutralToneMapping, PerspectiveCamera, Scene, Sphere, Vector3, WebGLRenderer } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { fitView } from './fit.js';
import { Handle } from './handles.js';
import { addLights } from './light.js';
import { CurveLine } from './line.js';
import { surfaceMaterial, surfaceObject } from './surface-mesh.js';

/** @typedef {Record<'surface' | 'halo' | 'path' | 'start' | 'hidden' | 'sky' | 'ground', string>} Theme colours */

/**
 * The lines are drawn this much nearer to the eye, scaled about it: on the screen they stay where they are, in depth a line some pixels wide clears a
 * surface that slopes up to 75 degrees. (A polygon offset in proportion to the slope would let the far side shine through at every silhouette.)
 */
const LIFT = 0.99;
const ELEVATION = Math.PI / 6;
const FIELD_OF_VIEW = 32;
const MOST_PIXELS = 2;
/** CSS pixels at the lower edge that the player covers. */
const COVERED = 64;
/** Share of the view that stays free around the surface, both sides together. */
const MARGIN = 0.11;
/** In CSS pixels, at least: the legend stands there on small screens. */
const LEAST_MARGIN = 60;

export class View {
  #renderer;
  #scene = new Scene();
  #camera = new PerspectiveCamera(FIELD_OF_VIEW, 1, 0.1, 100);
  #controls;
  #lifted = new Group();
  #material = surfaceMaterial();
  /** @type {import('three').Mesh | null} */ #surface = null;
  #sky = new HemisphereLight();
  #start = new CurveLine(2, 10);
  #path = new CurveLine(4, 20);
  #handles;
  #bounds = new Sphere(new Vector3(), 1);
  #size = { width: 1, height: 1 };
  #pending = false;
  /** Whether the reader has turned the view: then it is not ours to change. */
  #touched = false;
  /** @type {Theme | null} */ #theme = null;
  #warmth = 1;

  /** Throws where there is no WebGL. @param {HTMLElement} element @param {HTMLCanvasElement} canvas @param {[HTMLElement, HTMLElement]} labels */
  constructor(element, canvas, labels) {
    this.#renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true, powerPreference: 'low-power' });
    this.#renderer.toneMapping = NeutralToneMapping;
    this.#handles = labels.map((label, i) => new Handle(label, 30 + 10 * i));
    this.#camera.up.set(0, 0, 1);
    addLights(this.#scene, this.#camera, this.#sky);
    this.#lifted.add(this.#start, this.#path, ...this.#handles);
    this.#scene.add(this.#camera, this.#lifted);
    this.#controls = new OrbitControls(this.#camera, canvas);
    Object.assign(this.#controls, { enableDamping: true, dampingFactor: 0.12, rotateSpeed: 0.9 });
    this.#controls.addEventListener('change', () => this.invalidate());
    this.#controls.addEventListener('start', () => {
      this.#touched = true;
    });
    this.#resize(element);
    new ResizeObserver(() => this.#resize(element)).observe(element);
  }

  /** @param {Theme} theme */
  setTheme(theme) {
    this.#theme = theme;
    this.#material.color.set(theme.surface);
    this.#sky.color.set(theme.sky);
    this.#sky.groundColor.set(theme.ground);
    this.#start.setColors(theme.start, theme.halo, new Color(theme.start).lerp(new Color(theme.hidden), 0.55));
    for (const handle of this.#handles) handle.setColors(theme.path, theme.halo, new Color(theme.path).lerp(new Color(theme.hidden), 0.55));
    this.setWarmth(this.#warmth);
  }

  /** Colours the path by how far it has converged. @param {number} warmth 0: as the start … 1: converged */
  setWarmth(warmth) {
    this.#warmth = warmth;
    if (!this.#theme) return;
    const color = new Color(this.#theme.start).lerp(new Color(this.#theme.path), warmth);
    this.#path.setColors(color, this.#theme.halo, color.clone().lerp(new Color(this.#theme.hidden), 0.45));
    this.invalidate();
  }

  /** @param {import('./surface-mesh.js').SurfaceMesh} mesh @returns {boolean} whether it is much larger or smaller than the last one, or elsewhere */
  setSurface(mesh) {
    const last = this.#bounds.clone();
    if (this.#surface) {
      this.#scene.remove(this.#surface);
      this.#surface.geometry.dispose();
    }
    this.#surface = surfaceObject(mesh, this.#material);
    this.#scene.add(this.#surface);
    const box = new Box3().setFromObject(this.#surface);
    box.getBoundingSphere(this.#bounds);
    this.#bounds.radius = Math.max(/** @type {Sphere} */ (this.#surface.geometry.boundingSphere).radius, 1e-6);
    for (const line of [this.#start, this.#path]) line.setDash(this.#bounds.radius / 45);
    this.invalidate();
    const growth = this.#bounds.radius / last.radius;
    return growth > 1.5 || growth < 0.4 || this.#bounds.center.distanceTo(last.center) > last.radius;
  }

  /** @param {Float64Array | null} points */
  setStart(points) {
    this.#start.setPoints(points);
    this.invalidate();
  }

  /** @param {Float64Array | null} points */
  setPath(points) {
    this.#path.setPoints(points);
    this.invalidate();
  }

  /** @param {(ArrayLike<number> | null)[]} points of A and B */
  setEnds(points) {
    for (const [i, handle] of this.#handles.entries()) handle.setPoint(points[i]);
    this.invalidate();
  }

  /** Looks at the whole surface from 30 degrees above, from the side where something is. @param {ArrayLike<number> | null} something x y z @param {readonly number[]} [direction] to look from instead */
  frame(something, direction) {
    const { center, radius } = this.#bounds;
    const towards = something ? new Vector3(something[0], something[1], something[2]).sub(center).setZ(0) : new Vector3();
    if (towards.length() < 0.08 * radius) towards.set(0.6, -1, 0);
    towards.normalize().multiplyScalar(Math.cos(ELEVATION)).setZ(Math.sin(ELEVATION));
    if (direction) towards.fromArray(direction).normalize();
    this.#controls.minDistance = 0.15 * radius;
    this.#controls.maxDistance = 20 * radius;
    this.#touched = false;
    this.#fit(towards);
  }

  /** @param {Vector3} towards the camera, unit length */
  #fit(towards) {
    if (!this.#surface) return;
    const { width, height } = this.#size;
    const slope = Math.tan((FIELD_OF_VIEW * Math.PI) / 360) / height;
    const margin = Math.max(MARGIN * Math.min(width, height), LEAST_MARGIN);
    const slopes = [slope * (width - margin), slope * (height - COVERED - margin)];
    const { center } = this.#bounds;
    const { target, distance } = fitView(this.#surface.geometry.getAttribute('position'), center, towards, this.#camera.up, slopes);
    this.#controls.target.copy(target);
    this.#camera.position.copy(target).addScaledVector(towards, distance);
    this.#controls.update();
    this.invalidate();
  }

  /** Draws in the next frame. */
  invalidate() {
    if (this.#pending) return;
    this.#pending = true;
    requestAnimationFrame(() => this.#draw());
  }

  #draw() {
    this.#pending = false;
    this.#controls.update();
    const { center, radius } = this.#bounds;
    const distance = this.#camera.position.distanceTo(center);
    this.#camera.near = Math.max(distance - 1.6 * radius, 0.01 * radius);
    this.#camera.far = distance + 1.6 * radius;
    this.#camera.updateProjectionMatrix();
    this.#lifted.scale.setScalar(LIFT);
    this.#lifted.position.copy(this.#camera.position).multiplyScalar(1 - LIFT);
    this.#scene.updateMatrixWorld();
    const places = this.#handles.map((handle) => handle.follow(this.#camera, this.#size));
    for (const [i, handle] of this.#handles.entries()) handle.placeLabel(places[i], places[1 - i]);
    this.#renderer.render(this.#scene, this.#camera);
  }

  /** @param {HTMLElement} element */
  #resize(element) {
    const { width, height } = element.getBoundingClientRect();
    if (width < 1 || height < 1) return;
    this.#size = { width, height };
    const ratio = Math.min(window.devicePixelRatio, MOST_PIXELS);
    this.#renderer.setPixelRatio(ratio);
    this.#renderer.setSize(width, height, false);
    this.#camera.aspect = width / height;
    this.#camera.setViewOffset(width, height, 0, COVERED / 2, width, height);
    if (!this.#touched) this.#fit(this.#camera.position.clone().sub(this.#controls.target).normalize());
    // A resized canvas is empty until it is drawn: draw before the browser paints.
    this.#draw();
  }
}
