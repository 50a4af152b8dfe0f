/** The buffers of a wide line, written in place: an animation changes them every frame. */

import { InstancedInterleavedBuffer, InterleavedBufferAttribute } from 'three';
import { LineGeometry } from 'three/addons/lines/LineGeometry.js';

export class LineBuffers extends LineGeometry {
  #pieces = 0;
  #ends = new InstancedInterleavedBuffer(new Float32Array(6), 6, 1);
  #distances = new InstancedInterleavedBuffer(new Float32Array(2), 2, 1);

  /** @param {number} pieces */
  #resize(pieces) {
    // Buffers cannot grow: the old ones are freed, the new ones made when they are first drawn.
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

  /** @param {ArrayLike<number>} points x y z of two points or more @param {ArrayLike<number>} origin from which they are written */
  write(points, origin) {
    const pieces = points.length / 3 - 1;
    if (pieces !== this.#pieces) this.#resize(pieces);
    const [ends, distances] = [this.#ends.array, this.#distances.array];
    for (let i = 0, distance = 0; i < pieces; i++) {
      for (let k = 0; k < 6; k++) ends[6 * i + k] = points[3 * i + k] - origin[k % 3];
      const [dx, dy, dz] = [0, 1, 2].map((k) => points[3 * i + 3 + k] - points[3 * i + k]);
      distances[2 * i] = distance;
      distance += Math.hypot(dx, dy, dz);
      distances[2 * i + 1] = distance;
    }
    this.#ends.needsUpdate = true;
    this.#distances.needsUpdate = true;
    this.computeBoundingSphere();
  }
}
