/** A page with a three.js scene for tests of surfpath/three: what is in it is put on `window`, and the test does the rest. */

/** Both releases that are tested: where their files are. */
export const RELEASES = { 'latest release': 'three', 'the release before': 'three-previous' };

/**
 * A page with a canvas of 640 × 480, a camera at (6, -9, 6) that looks at the origin, light, controls, and `view` for all of it.
 * @param {string} three folder in node_modules @param {string} [more] parameters of the renderer
 */
export const scenePage = (three, more = '') => `<!doctype html>
<html lang="en"><meta charset="utf-8"><title>Scene</title>
<body><main><div id="frame"><canvas id="canvas" width="640" height="480"></canvas></div></main>
<script type="importmap">{ "imports": {
  "three": "/node_modules/${three}/build/three.module.js", "three/addons/": "/node_modules/${three}/examples/jsm/",
  "surfpath": "/dist/index.js", "surfpath/gallery": "/dist/gallery.js", "surfpath/three": "/dist/three.js" } }</script>
<script type="module">
  import * as THREE from 'three';
  import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
  import { load } from 'surfpath';
  import { gallery } from 'surfpath/gallery';
  import * as draw from 'surfpath/three';
  const canvas = document.getElementById('canvas');
  Object.assign(canvas.parentElement.style, { position: 'relative', width: '640px' });
  const renderer = new THREE.WebGLRenderer({ canvas, antialias: true, preserveDrawingBuffer: true${more} });
  const camera = new THREE.PerspectiveCamera(32, 4 / 3, 1, 60);
  camera.up.set(0, 0, 1);
  camera.position.set(8, -12, 8);
  const controls = new OrbitControls(camera, canvas);
  const scene = new THREE.Scene();
  scene.background = new THREE.Color('#f4f5f2');
  const key = new THREE.DirectionalLight('#fffaf2', 2.1);
  key.position.set(-0.7, 1, 0.75);
  const fill = new THREE.DirectionalLight('#dfe9ff', 0.5);
  fill.position.set(1, -0.2, 0.5);
  camera.add(key, key.target, fill, fill.target);
  const sky = new THREE.HemisphereLight('#ffffff', '#b9b2a6', 1.45);
  sky.position.set(0, 0, 1);
  scene.add(camera, sky);
  renderer.toneMapping = THREE.NeutralToneMapping;
  controls.update();
  const render = () => renderer.render(scene, camera);
  // Where a point of the scene is in the window.
  const place = (point) => {
    camera.updateMatrixWorld();
    const seen = new THREE.Vector3(...point).project(camera);
    const { left, top, width, height } = canvas.getBoundingClientRect();
    return { x: left + (width / 2) * (seen.x + 1), y: top + (height / 2) * (1 - seen.y) };
  };
  // Pictures are compared here: a million numbers take seconds on their way out of a browser.
  const pictures = [];
  const takePicture = () => {
    const drawing = new OffscreenCanvas(640, 480).getContext('2d', { willReadFrequently: true });
    drawing.drawImage(canvas, 0, 0);
    pictures.push(drawing.getImageData(0, 0, 640, 480).data);
  };
  // How many pixels of the last two pictures differ clearly, and how many of the last one do from its corner.
  const comparePictures = () => {
    const [before, last] = pictures.splice(0).slice(-2);
    const count = (isOther) => last.filter(isOther).length / 4;
    return { differ: count((x, i) => Math.abs(x - before[i]) > 24), lit: count((x, i) => Math.abs(x - last[i % 4]) > 24) };
  };
  window.view = { THREE, draw, gallery, surfpath: await load(), renderer, camera, controls, scene, render, place, pictures, takePicture, comparePictures };
</script>`;
