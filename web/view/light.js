/** The light of the view: a key over the viewer's left shoulder, a weak one from the right, both turning with the camera, and the sky. */

import { DirectionalLight } from 'three';

/** @param {import('three').Scene} scene @param {import('three').Camera} camera @param {import('three').HemisphereLight} sky */
export function addLights(scene, camera, sky) {
  const key = new DirectionalLight('#fffaf2', 2.1);
  key.position.set(-0.7, 1, 0.75);
  const fill = new DirectionalLight('#dfe9ff', 0.5);
  fill.position.set(1, -0.2, 0.5);
  sky.intensity = 1.45;
  sky.position.set(0, 0, 1);
  camera.add(key, key.target, fill, fill.target);
  scene.add(sky);
}
