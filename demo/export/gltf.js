/** The surface and its path as glTF. Loaded when it is asked for: the writer is large. */

import { BufferAttribute, BufferGeometry, DoubleSide, Line, Mesh, MeshBasicMaterial, MeshStandardMaterial, Scene } from 'three';
import { GLTFExporter } from 'three/addons/exporters/GLTFExporter.js';
import { themeColor } from '../panels/dom.js';
import { placesOf } from '../compute/drawn.js';
import { FarGeometry } from '../../web/view/far.js';
import { originOf } from '../../web/view/origin.js';

/** glTF's y points up, this page's z. */
const UPRIGHT = -Math.PI / 2;

/** @param {BufferGeometry} geometry of the surface @param {import('surfpath').Path | null} path @returns {Promise<string>} */
export async function toGltf(geometry, path) {
  const scene = new Scene();
  scene.rotation.x = UPRIGHT;
  const bare = new BufferGeometry().setIndex(geometry.index);
  const isFar = geometry instanceof FarGeometry;
  bare.setAttribute('position', geometry.getAttribute(isFar ? 'offset' : 'position'));
  bare.setAttribute('normal', geometry.getAttribute('normal'));
  const surface = new Mesh(
    bare,
    new MeshStandardMaterial({ color: themeColor('surface'), roughness: 0.72, metalness: 0, side: DoubleSide }),
  );
  if (isFar) surface.position.copy(geometry.origin);
  scene.add(Object.assign(surface, { name: 'surface' }));
  const places = path ? placesOf(path) : [];
  if (places.length > 0) {
    const origin = originOf(places);
    const offsets = Float32Array.from(places, (x, i) => x - origin[i % 3]);
    const curve = new BufferGeometry().setAttribute('position', new BufferAttribute(offsets, 3));
    const line = new Line(curve, new MeshBasicMaterial({ color: themeColor('path') }));
    line.position.fromArray(origin);
    scene.add(Object.assign(line, { name: 'path' }));
  }
  return JSON.stringify(await new GLTFExporter().parseAsync(scene));
}
