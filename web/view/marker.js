/** A point on a surface as it is drawn: a small ball in a ring, of constant size on the screen; where the surface hides it, dimmer and without the ring. */

import { Color, GreaterDepth, Group, Mesh, PlaneGeometry, ShaderMaterial, Vector2, Vector4 } from 'three';
import { checkPixels, setColours } from './check.js';
import { HALO, PATH } from './colours.js';
import { LIFT, LOG_LIFT, liftOf } from './lift.js';

const VERTEX = /* glsl */ `
uniform vec2 resolution;
uniform float reach;
uniform float lift;
varying vec2 place;
#include <common>
#include <logdepthbuf_pars_vertex>
${LIFT}
void main() {
  vec4 eye = modelViewMatrix * vec4(0.0, 0.0, 0.0, 1.0);
  place = position.xy * reach;
  vec4 clip = lifted(projectionMatrix * eye, eye.z, lift, resolution.y);
  clip.xy += 2.0 * place / resolution * clip.w;
  gl_Position = clip;
  ${LOG_LIFT}
}`;

const FRAGMENT = /* glsl */ `
uniform vec3 fill;
uniform vec3 ring;
uniform float radius;
uniform float ringWidth;
uniform float opacity;
varying vec2 place;
#include <logdepthbuf_pars_fragment>
void main() {
  float away = length(place);
  float soft = fwidth(away);
  float ball = 1.0 - smoothstep(radius - soft, radius, away);
  float disc = 1.0 - smoothstep(radius + ringWidth - soft, radius + ringWidth, away);
  float height = sqrt(max(1.0 - away * away / (radius * radius), 0.0));
  float light = 0.82 + 0.3 * clamp(dot(vec3(place / radius, height), vec3(-0.41, 0.58, 0.7)), 0.0, 1.0);
  gl_FragColor = vec4(mix(ring, min(fill * light, vec3(1.0)), ball), opacity * disc);
  #include <logdepthbuf_fragment>
  #include <colorspace_fragment>
}`;

/** Seen in full, and, without the ring, behind the surface. */
const PASSES = [
  { depth: {}, opacity: 1 },
  { depth: { depthFunc: GreaterDepth }, opacity: 0.5 },
];
const ORDER = 10;
const viewport = new Vector4();

/** Add it beside the surface's mesh, its `position` that of the point. */
export class Marker extends Group {
  #shape = new PlaneGeometry(2, 2);
  #resolution = new Vector2(1, 1);
  #colours = { colour: new Color(PATH), ring: new Color(HALO) };
  #materials;
  /** Called each time it is drawn. @type {(camera: import('three').Camera, viewport: Vector4, renderer: import('three').WebGLRenderer) => void} */ onDraw =
    () => {};

  constructor() {
    super();
    this.#materials = PASSES.map(({ depth, opacity }) => this.#makeMaterial(depth, opacity));
    for (const [i, material] of this.#materials.entries()) {
      const mesh = new Mesh(this.#shape, material);
      mesh.frustumCulled = false;
      mesh.renderOrder = ORDER + i;
      mesh.raycast = () => {};
      this.add(mesh);
      if (i === 0) mesh.onBeforeRender = (renderer, _, camera) => this.#follow(renderer, camera);
    }
    this.setRadius(6, 2.5);
  }

  /** @param {object} depth @param {number} opacity */
  #makeMaterial(depth, opacity) {
    const uniforms = {
      resolution: { value: this.#resolution },
      fill: { value: this.#colours.colour },
      ring: { value: this.#colours.ring },
      ...{ reach: { value: 0 }, lift: { value: 0 }, radius: { value: 0 }, ringWidth: { value: 0 }, opacity: { value: opacity } },
    };
    const looks = { transparent: true, depthWrite: false, toneMapped: false, ...depth };
    return new ShaderMaterial({ vertexShader: VERTEX, fragmentShader: FRAGMENT, uniforms, ...looks });
  }

  /** @param {import('three').WebGLRenderer} renderer @param {import('three').Camera} camera */
  #follow(renderer, camera) {
    renderer.getViewport(viewport);
    this.#resolution.set(viewport.z, viewport.w);
    this.onDraw(camera, viewport, renderer);
  }

  /** @param {number} radius of the ball, in CSS pixels @param {number} ring width of the ring around it */
  setRadius(radius, ring) {
    checkPixels('setRadius: ', { radius, ring });
    for (const [i, { uniforms }] of this.#materials.entries()) {
      uniforms.radius.value = radius;
      uniforms.ringWidth.value = i === 0 ? ring : 0;
      uniforms.reach.value = radius + ring + 1;
      uniforms.lift.value = liftOf(radius + ring);
    }
  }

  /** What is not named stays. @param {{ colour?: import('three').ColorRepresentation, ring?: import('three').ColorRepresentation }} colours */
  setColours(colours) {
    setColours(this.#colours, colours);
  }

  /** Frees what it holds on the graphics card, and leaves its scene. */
  dispose() {
    this.removeFromParent();
    this.#shape.dispose();
    for (const material of this.#materials) material.dispose();
  }
}
