/** A curve as it is drawn on a surface: a wide line in a thin halo where it is seen, a paler dashed one where the surface hides it. */

import { GreaterDepth, Group, InstancedInterleavedBuffer, InterleavedBufferAttribute } from 'three';
import { Line2 } from 'three/addons/lines/Line2.js';
import { LineGeometry } from 'three/addons/lines/LineGeometry.js';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';

/** @typedef {import('three').ColorRepresentation} Color */

const HALO = 1.5;

/** A line geometry whose buffers are written in place: an animation changes it every frame. */
class CurveGeometry extends LineGeometry {
  #pieces = -1;
  #ends = new InstancedInterleavedBuffer(new Float32Array(6), 6, 1);
  #distances = new InstancedInterleavedBuffer(new Float32Array(2), 2, 1);

  /** @param {number} pieces */
  #resize(pieces) {
    if (pieces === this.#pieces) return;
    this.dispose();
    this.#pieces = pieces;
    this.instanceCount = pieces;
    this.#ends = new InstancedInterleavedBuffer(new Float32Array(6 * pieces), 6, 1);
    this.#distances = new InstancedInterleavedBuffer(new Float32Array(2 * pieces), 2, 1);
    this.setAttribute('instanceStart', new InterleavedBufferAttribute(this.#ends, 3, 0));
    this.setAttribute('instanceEnd', new InterleavedBufferAttribute(this.#ends, 3, 3));
    this.setAttribute('instanceDistanceStart', new InterleavedBufferAttribute(this.#distances, 1, 0));
    this.setAttribute('instanceDistanceEnd', new InterleavedBufferAttribute(this.#distances, 1, 1));
  }

  /** @param {ArrayLike<number>} points x y z … */
  write(points) {
    const pieces = points.length / 3 - 1;
    this.#resize(pieces);
    const [ends, distances] = [this.#ends.array, this.#distances.array];
    for (let i = 0, distance = 0; i < pieces; i++) {
      for (let k = 0; k < 6; k++) ends[6 * i + k] = points[3 * i + k];
      distances[2 * i] = distance;
      distance += Math.hypot(
        points[3 * i + 3] - points[3 * i],
        points[3 * i + 4] - points[3 * i + 1],
        points[3 * i + 5] - points[3 * i + 2],
      );
      distances[2 * i + 1] = distance;
    }
    this.#ends.needsUpdate = true;
    this.#distances.needsUpdate = true;
  }
}

export class CurveLine extends Group {
  #geometry = new CurveGeometry();
  #hidden;
  #halo;
  #line;

  /** @param {number} width in CSS pixels @param {number} order in which it is drawn, after smaller ones */
  constructor(width, order) {
    super();
    this.#hidden = new LineMaterial({ linewidth: Math.max(1.5, 0.6 * width), dashed: true, depthFunc: GreaterDepth, depthWrite: false });
    this.#halo = new LineMaterial({ linewidth: width + 2 * HALO, depthWrite: false });
    this.#line = new LineMaterial({ linewidth: width, depthWrite: false });
    for (const [i, material] of [this.#hidden, this.#halo, this.#line].entries()) {
      // Transparent objects are drawn after the surface, in the order asked for; the colours themselves are opaque, so joints do not show.
      Object.assign(material, { transparent: true, toneMapped: false });
      const line = new Line2(this.#geometry, material);
      line.frustumCulled = false;
      line.renderOrder = order + i;
      this.add(line);
    }
    this.visible = false;
  }

  /** @param {ArrayLike<number> | null} points x y z …, or null: nothing to draw */
  setPoints(points) {
    this.visible = points !== null && points.length >= 6;
    if (points && this.visible) this.#geometry.write(points);
  }

  /** @param {Color} line @param {Color} halo @param {Color} hidden */
  setColors(line, halo, hidden) {
    this.#line.color.set(line);
    this.#halo.color.set(halo);
    this.#hidden.color.set(hidden);
  }

  /** @param {number} length of a dash, in the unit of the scene */
  setDash(length) {
    this.#hidden.dashSize = length;
    this.#hidden.gapSize = 0.6 * length;
  }

  dispose() {
    this.#geometry.dispose();
    for (const material of [this.#hidden, this.#halo, this.#line]) material.dispose();
  }
}
