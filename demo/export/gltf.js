/** The surface and its path as glTF. Loaded when it is asked for: the writer is large. */

import { BufferAttribute, BufferGeometry, DoubleSide, Line, Mesh, MeshBasicMaterial, MeshStandardMaterial, Scene } from 'three';
import { GLTFExporter } from 'three/addons/exporters/GLTFExporter.js';
import { themeColor } from '../panels/dom.js';
import { placesOf } from '../compute/drawn.js';

/** glTF's y points up, this page's z. */
const UPRIGHT = -Math.PI / 2;

/** @param {BufferGeometry} geometry of the surface @param {import('surfpath').Path | null} path @returns {Promise<string>} */
export async function toGltf(geometry, path) {
  const scene = new Scene();
  scene.rotation.x = UPRIGHT;
  const bare = new BufferGeometry().setIndex(geometry.index);
  for (const name of ['position', 'normal']) bare.setAttribute(name, geometry.getAttribute(name));
  const surface = new Mesh(
    bare,
    new MeshStandardMaterial({ color: themeColor('surface'), roughness: 0.72, metalness: 0, side: DoubleSide }),
  );
  scene.add(Object.assign(surface, { name: 'surface' }));
  if (path && placesOf(path).length > 0) {
    const places = new BufferGeometry().setAttribute('position', new BufferAttribute(Float32Array.from(placesOf(path)), 3));
    scene.add(Object.assign(new Line(places, new MeshBasicMaterial({ color: themeColor('path') })), { name: 'path' }));
  }
  return JSON.stringify(await new GLTFExporter().parseAsync(scene));
}
