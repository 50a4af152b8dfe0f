/** A curve on a surface as it is drawn: a wide line in a thin halo where it is seen, dashed and dimmer where the surface hides it. */

import { GreaterDepth, Group, Vector3 } from 'three';
import { Line2 } from 'three/addons/lines/Line2.js';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { checkBoolean, checkOptions, refuseNumber } from '../arguments.js';
import { checkPixels, readPoints, setColours } from './check.js';
import { HALO, PATH } from './colours.js';
import { LIFT, LOG_LIFT, liftOf } from './lift.js';
import { LineBuffers } from './line-buffers.js';
import { originOf } from './origin.js';

/** @typedef {import('three').ColorRepresentation} Colour */
/** @typedef {import('../path.js').Path} Path */

/**
 * @typedef {object} GeodesicLineOptions
 * @property {Colour} [colour] default an orange-red
 * @property {number} [width] in CSS pixels, at any zoom; default 4
 * @property {Colour | null} [halo] colour of a thin border, best that of the background; null: none; default white
 * @property {number} [haloWidth] in CSS pixels, on each side; default 1.5
 * @property {boolean} [hidden] whether the part behind the surface is drawn, dashed; default true
 * @property {Colour} [hiddenColour] of that part; default: as the line, half transparent
 * @property {number} [dash] length of a dash in CSS pixels; gaps are two thirds of it; default 7
 */

const NAMES = ['colour', 'width', 'halo', 'haloWidth', 'hidden', 'hiddenColour', 'dash'];
const GAP = 2 / 3;
/** The hidden part is thinner than the line, and half transparent. */
const [THINNER, DIMMER] = [0.65, 0.55];

const center = new Vector3();

/** One of the three passes. */
class Pass extends Line2 {
  /** Width and height in pixels that were asked for; null: those of the viewport. @type {[number, number] | null} */ size = null;

  /** @param {LineBuffers} buffers @param {import('three/addons/lines/LineMaterial.js').LineMaterialParameters} parameters @param {{ value: number }} lift */
  constructor(buffers, parameters, lift) {
    // Transparent objects are drawn after the surface, in the order asked for; the colours themselves are opaque, so joints do not show.
    const material = new LineMaterial({ transparent: true, depthWrite: false, toneMapped: false, ...parameters });
    material.onBeforeCompile = (shader) => {
      shader.uniforms.lift = lift;
      shader.vertexShader = shader.vertexShader
        .replace('void main()', `uniform float lift;\n${LIFT}\nvoid main()`)
        .replace('gl_Position = clip;', 'gl_Position = lifted(clip, (position.y < 0.5 ? start : end).z, lift, resolution.y);')
        .replace('#include <logdepthbuf_vertex>', LOG_LIFT);
    };
    super(buffers, material);
  }

  /** @param {import('three').WebGLRenderer} renderer @param {import('three').Scene} [_] @param {import('three').Camera} [camera] */
  onBeforeRender(renderer, _, camera) {
    super.onBeforeRender(renderer);
    const { resolution } = this.material;
    if (this.size) resolution.set(...this.size);
    if (camera && this.material.dashed) this.material.dashScale = this.#pixelsPerUnit(camera, resolution.y);
  }

  /** How many pixels one unit of length takes at the middle of the line, so that dashes keep their size on the screen. @param {import('three').Camera} camera @param {number} height */
  #pixelsPerUnit(camera, height) {
    const { elements } = camera.projectionMatrix;
    center.copy(/** @type {import('three').Sphere} */ (this.geometry.boundingSphere).center).applyMatrix4(this.matrixWorld);
    const depth = -center.applyMatrix4(camera.matrixWorldInverse).z;
    const scale = this.matrixWorld.getMaxScaleOnAxis();
    return (scale * height * elements[5]) / (2 * Math.max(elements[15] + depth * -elements[11], 1e-9));
  }
}

/** A path as a wide line. Add it beside the surface's mesh; it needs nothing of the surface's material. Throws TypeError for a path without positions. */
export class GeodesicLine extends Group {
  #buffers = new LineBuffers();
  /** Hidden while there is no path; `visible` of the whole is the caller's. */
  #body = new Group();
  #lift = { value: 0 };
  #passes;
  /** Whether what is hidden has a colour of its own; else that of the line. */
  #isHiddenOwn = false;

  /**
   * @param {Path | ArrayLike<number> | null} path a path of a surface with positions, or x y z …; null: nothing to draw yet
   * @param {GeodesicLineOptions} [options]
   */
  constructor(path = null, options = {}) {
    super();
    this.add(this.#body);
    checkOptions('GeodesicLine', options, NAMES);
    const { colour = PATH, width = 4, halo = HALO, haloWidth = 1.5, hidden = true, hiddenColour = colour, dash = 7 } = options;
    checkPixels('GeodesicLine: options.', { width, haloWidth, dash });
    checkBoolean('GeodesicLine', 'hidden', hidden);
    this.#isHiddenOwn = options.hiddenColour !== undefined;
    const border = halo === null ? 0 : haloWidth;
    this.#lift.value = liftOf(width / 2 + border);
    const dashes = {
      dashed: true,
      dashSize: dash,
      gapSize: GAP * dash,
      depthFunc: GreaterDepth,
      opacity: this.#isHiddenOwn ? 1 : DIMMER,
    };
    this.#passes = {
      hidden: this.#makePass(hiddenColour, Math.max(1.5, THINNER * width), dashes, hidden),
      halo: this.#makePass(halo ?? HALO, width + 2 * border, {}, border > 0),
      line: this.#makePass(colour, width, {}, true),
    };
    this.setPath(path);
  }

  /** @param {Colour} color @param {number} linewidth @param {object} parameters @param {boolean} shown */
  #makePass(color, linewidth, parameters, shown) {
    const pass = new Pass(this.#buffers, { color, linewidth, ...parameters }, this.#lift);
    pass.frustumCulled = false;
    pass.visible = shown;
    pass.renderOrder = 1 + this.#body.children.length;
    this.#body.add(pass);
    return pass;
  }

  /**
   * Shows another path. Buffers are reused where it has as many points: cheap enough for every frame.
   * @param {Path | ArrayLike<number> | null} path as for the constructor; of a path that was not found, nothing is drawn
   */
  setPath(path) {
    const points = readPoints('GeodesicLine', path);
    this.#body.visible = points !== null;
    if (!points) return;
    const origin = originOf(points);
    this.#body.position.fromArray(origin);
    this.#buffers.write(points, origin);
  }

  /**
   * Recolours the line; what is not named stays.
   * @param {{ colour?: Colour, halo?: Colour, hiddenColour?: Colour }} colours hiddenColour: as colour until it is named once
   */
  setColours(colours) {
    const { hidden, line, halo } = this.#passes;
    setColours({ colour: line.material.color, halo: halo.material.color, hiddenColour: hidden.material.color }, colours);
    this.#isHiddenOwn ||= colours?.hiddenColour !== undefined;
    if (this.#isHiddenOwn) hidden.material.opacity = 1;
    else hidden.material.color.copy(line.material.color);
  }

  /**
   * Draw after what has a smaller order: of several lines, that of the path last. Takes this number and the next two.
   * @param {number} order default 1
   */
  setOrder(order) {
    if (!Number.isFinite(order)) refuseNumber('setOrder: order', 'a finite number', order);
    for (const [i, pass] of Object.values(this.#passes).entries()) pass.renderOrder = order + i;
  }

  /**
   * Sets the size of what is drawn on, where it is not the renderer's own canvas: a render target.
   * @param {number} width in CSS pixels @param {number} height
   */
  setResolution(width, height) {
    checkPixels('setResolution: ', { width, height });
    for (const pass of Object.values(this.#passes)) pass.size = [width, height];
  }

  /** Frees what it holds on the graphics card, and leaves its scene. */
  dispose() {
    this.removeFromParent();
    this.#buffers.dispose();
    for (const { material } of Object.values(this.#passes)) material.dispose();
  }
}
