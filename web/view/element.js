/**
 * surfpath/element: <surface-path>, a surface and the shortest path between two of its points as an element of HTML. Importing it defines the element
 * where there are custom elements, and does nothing elsewhere, in Node for example.
 */

import {
  LOOK_ATTRIBUTES,
  PATH_ATTRIBUTES,
  readDefinition,
  readEnds,
  readLook,
  readOptions,
  SURFACE_ATTRIBUTES,
} from './element/attributes.js';
import { adopt, BaseElement, reflect } from './element/base.js';
import { Caption } from './element/caption.js';
import { filmOf } from './element/film.js';
import { getSolver } from './element/solver.js';
import { hasPoint, Stage } from './element/stage.js';
import { adoptStyle, readTheme } from './element/style.js';
import { drawn, turn } from './element/turn.js';
import { watch } from './element/watch.js';

/** @typedef {import('../path.js').Path} Path */
/** @typedef {import('../surface.js').Surface} Surface */
/** @typedef {import('../instance.js').Surfpath} Surfpath */
/** @typedef {import('../instance.js').AnyDefinition} AnyDefinition */

/** What must be done again, from the least to the most. */
const [LOOK, PATH, SURFACE] = [1, 2, 3];

/**
 * `<surface-path surface="parametricTorus" from="0,0" to="2,1" controls></surface-path>`. The attributes stand in the manual. Events: `path`, its detail the Path,
 * each time one was computed; `error`, its detail the Error, where a formula, a point or the browser does not allow it. Neither bubbles.
 */
export class SurfacePathElement extends BaseElement {
  static observedAttributes = [...SURFACE_ATTRIBUTES, ...PATH_ATTRIBUTES, ...LOOK_ATTRIBUTES];
  #canvas = document.createElement('canvas');
  #caption = new Caption(this.#canvas);
  /** @type {Stage | null} */ #stage = null;
  /** @type {AnyDefinition | null} */ #given = null;
  /** @type {Surface | null} */ #surface = null;
  /** @type {Path | null} */ #path = null;
  /** @type {number[][]} */ #ends = [];
  /** The ends that were asked for: they may have been dragged since. @type {number[][]} */ #asked = [];
  /** The definition of the surface, but for the values of its parameters: where only these change, it is not compiled anew. */
  #built = '';
  /** Its kind and title: of another one the reader has dragged nothing. */
  #named = '';
  /** What is looked at: where it stays the same, so does the view. */
  #framed = '';
  /** What is to be done again; 0: nothing. */
  #stale = 0;
  #isQueued = false;
  #isVisible = false;
  /** Whether the look of the surface is to be made again as soon as it is on screen. */
  #isUndrawn = true;
  #isUnplayed = true;
  /** Whether what stands in the element is a complaint about how it is to be drawn. */
  #isUndrawable = false;
  /** @type {AbortController | null} */ #connection = null;

  constructor() {
    super();
    const root = this.attachShadow({ mode: 'open' });
    adoptStyle(root);
    this.#canvas.setAttribute('part', 'canvas');
    root.append(this.#canvas, this.#caption.element);
  }

  /** The path that was computed last; null before, and after an error. @returns {Path | null} */
  get path() {
    return this.#path;
  }

  /** @param {string | null} formulas the attribute of a sweep, which has the same name: frameworks set attributes as properties where there are such */
  set path(formulas) {
    reflect(this, 'path', formulas);
  }

  /** What an attribute says; empty, as templates leave those that they have no value for, it is none. @param {string} name */
  #attribute = (name) => this.getAttribute(name) || null;

  /** The definition of the surface: what was set, else what the attributes say. Throws as that may. @returns {AnyDefinition} */
  get definition() {
    return this.#given ?? readDefinition(this.#attribute);
  }

  /** @param {AnyDefinition | null} definition takes the place of all attributes of the surface; null gives it back to them */
  set definition(definition) {
    this.#given = definition;
    this.#renew(SURFACE);
  }

  /** Where the path begins: u v, or x y z, as asked for. Follows the handle; empty where nothing says. @returns {number[]} */
  get from() {
    return this.#getEnd(0);
  }

  /** @param {ArrayLike<number> | string | null | undefined} point as the attribute, or numbers; null: as without the attribute */
  set from(point) {
    this.#setEnd(0, point);
  }

  /** Where it ends. @returns {number[]} */
  get to() {
    return this.#getEnd(1);
  }

  /** @param {ArrayLike<number> | string | null | undefined} point */
  set to(point) {
    this.#setEnd(1, point);
  }

  /** @param {0 | 1} end */
  #getEnd(end) {
    try {
      return [...((this.#stale >= PATH ? this.#readEnds().ends : this.#ends)[end] ?? [])];
    } catch {
      return [];
    }
  }

  /** Also where the attribute says so already, if the reader has dragged it away. @param {0 | 1} end @param {ArrayLike<number> | string | null | undefined} point */
  #setEnd(end, point) {
    const name = ['from', 'to'][end];
    const text = typeof point === 'object' && point ? Array.from(point).join(',') : (point?.toString() ?? null);
    /* A framework may set what is there each time it draws. */
    if (text === this.getAttribute(name) && String(this.#ends[end]) === String(this.#asked[end])) return;
    reflect(this, name, text || null);
    delete this.#asked[end];
    this.#renew(PATH);
  }

  connectedCallback() {
    this.#connection = new AbortController();
    adopt(this);
    watch(this, this.#connection.signal, {
      print: () => this.#print(),
      see: (isVisible) => turn().then(() => this.#see(isVisible)),
      resize: () => this.#stage?.resize(this.clientWidth, this.clientHeight),
      repaint: () => this.#stage?.setTheme(readTheme(this.#canvas)),
    });
    this.#renew(SURFACE);
  }

  /** It has come to another document, which takes no style of the last one. */
  adoptedCallback() {
    adoptStyle(/** @type {ShadowRoot} */ (this.shadowRoot));
  }

  disconnectedCallback() {
    this.#connection?.abort();
    this.#connection = null;
    this.#stage?.dispose();
    this.#stage = null;
    this.#surface?.dispose();
    this.#surface = null;
    this.#isVisible = false;
    this.#isUndrawn = true;
    this.#framed = '';
  }

  /** @param {string} name @param {string | null} before @param {string | null} now */
  attributeChangedCallback(name, before, now) {
    if (before === now) return;
    this.#renew(SURFACE_ATTRIBUTES.includes(name) ? SURFACE : PATH_ATTRIBUTES.includes(name) ? PATH : LOOK);
  }

  /** Several attributes that change together are read together. @param {number} what */
  #renew(what) {
    this.#stale = Math.max(this.#stale, what);
    if (this.#isQueued || !this.#connection) return;
    this.#isQueued = true;
    queueMicrotask(() => this.#update());
  }

  async #update() {
    let what = this.#stale;
    try {
      if (!this.#surface) this.#caption.wait();
      // What comes next holds the page for as long as it takes: that must have been seen by then.
      const [surfpath] = await Promise.all([getSolver(), this.#surface ?? drawn()]);
      await turn();
      this.#isQueued = false;
      if (!this.#connection) return;
      what = this.#stale;
      this.#stale = 0;
      if (what === SURFACE) this.#build(surfpath);
      if (what >= PATH) {
        ({ asked: this.#asked, ends: this.#ends } = this.#readEnds());
        this.#solve();
      }
      this.#isUndrawn = true;
      this.#isUnplayed = what >= PATH;
      this.#show();
    } catch (error) {
      this.#isQueued = false;
      this.#stale = Math.max(this.#stale, what);
      this.#path = null;
      this.#stage?.setPath(null);
      if (this.#stale === SURFACE) this.#dropSurface();
      if (this.#connection) this.#complain(error);
    }
  }

  /** The picture stays, dimmed, until there is another one, but nothing moves on it. */
  #dropSurface() {
    if (this.#surface) this.#stage?.setEnds(this.#surface, [], null);
    this.#surface?.dispose();
    this.#surface = null;
  }

  /** Where a reader has dragged an end it stays, until another place is asked for. */
  #readEnds() {
    const asked = readEnds(this.#attribute, this.definition);
    return { asked, ends: asked.map((point, i) => (String(point) === String(this.#asked[i]) ? this.#ends[i] : point)) };
  }

  /** @param {Surfpath} surfpath */
  #build(surfpath) {
    const definition = /** @type {AnyDefinition & { title?: string }} */ (this.definition);
    const { parameters = {}, ...rest } = definition;
    const built = JSON.stringify([rest, Object.keys(parameters)]);
    if (this.#surface && built === this.#built) return this.#surface.set(parameters);
    const surface = surfpath.surface(definition);
    this.#surface?.dispose();
    this.#surface = surface;
    const named = `${definition.kind} ${definition.title}`;
    for (const [i, end] of this.#ends.entries()) if (named !== this.#named || !hasPoint(surface, end)) delete this.#asked[i];
    [this.#built, this.#named] = [built, named];
    this.#caption.title = definition.title ?? 'Surface';
  }

  /** @param {Path | null} [start] an earlier path, while an end is dragged */
  #solve(start = null) {
    if (!this.#surface) return;
    this.#path = null;
    const [from, to] = this.#ends;
    // Of an end alone it is known, too, whether there is such a place.
    if (from && !to) this.#surface.shortestPath(from, from);
    if (to) {
      const options = readOptions(this.#attribute);
      this.#path = this.#surface.shortestPath(from, to, start && !options.via ? { ...options, start } : options);
    }
    this.#caption.tell(this.#path);
    if (this.#path) this.dispatchEvent(new CustomEvent('path', { detail: this.#path }));
  }

  /** What was never on screen is not drawn yet. */
  #print() {
    const was = this.#isVisible;
    this.#see(true);
    this.#stage?.draw();
    this.#see(was);
  }

  /** @param {boolean} isVisible on screen */
  #see(isVisible) {
    if (!this.#connection) return;
    this.#isVisible = isVisible;
    this.#stage?.setVisible(isVisible);
    this.#show();
  }

  /** Draws what has changed, once it is on screen: meshes and contexts cost more than paths. */
  #show() {
    if (!this.#isVisible || !this.#isUndrawn || !this.#surface) return;
    this.#isUndrawn = false;
    try {
      this.#draw(this.#surface);
      if (this.#isUndrawable) this.#caption.tell(this.#path);
      this.#isUndrawable = false;
    } catch (error) {
      this.#isUndrawable = true;
      this.#complain(error);
    }
  }

  /** @param {Surface} surface */
  #draw(surface) {
    const stage = this.#stage ?? this.#openStage();
    const definition = this.definition;
    const { camera, ...look } = readLook(this.#attribute, definition, this.#ends[0]);
    stage.setSurface(surface, look);
    const framed = JSON.stringify([{ ...definition, parameters: null }, camera]);
    if (framed !== this.#framed) stage.frame(camera, this.#path);
    this.#framed = framed;
    stage.setEnds(surface, this.#ends, this.hasAttribute('controls') ? (end, point) => this.#drag(end, point) : null);
    const animates = this.hasAttribute('animate') && this.#isUnplayed && this.#path !== null;
    stage.setPath(animates ? filmOf(surface, this.#ends, /** @type {Path} */ (this.#path)) : this.#path);
    this.#isUnplayed = false;
    if (animates) stage.play();
  }

  #openStage() {
    const stage = new Stage(this.#canvas);
    stage.setTheme(readTheme(this.#canvas));
    stage.resize(this.clientWidth, this.clientHeight);
    stage.setVisible(this.#isVisible);
    this.#stage = stage;
    return stage;
  }

  /** @param {number} end @param {number[]} [point] none: it is let go, and distances are from there */
  #drag(end, point) {
    if (!point) {
      if (end === 0 && this.#attribute('colour') === 'distance') this.#renew(LOOK);
      return;
    }
    this.#ends[end] = point;
    try {
      this.#solve(this.#path?.converged ? this.#path : null);
      this.#stage?.setPath(this.#path);
    } catch (error) {
      this.#complain(error);
    }
  }

  /** @param {unknown} error */
  #complain(error) {
    const detail = error instanceof Error ? error : new Error(String(error));
    this.#caption.complain(detail, this.#path);
    this.dispatchEvent(new CustomEvent('error', { detail }));
  }
}

if (globalThis.customElements && !customElements.get('surface-path')) customElements.define('surface-path', SurfacePathElement);
