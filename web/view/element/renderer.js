/** One WebGL context for all elements of a page: browsers allow only some. It draws out of sight, and the picture is copied. */

import { NeutralToneMapping, WebGLRenderer } from 'three';

/** @type {WebGLRenderer | null} */ let renderer = null;
let users = 0;
/** What it has room for, in CSS pixels: growing is slow. @type {{ width: number, height: number, ratio: number }} */ let room;

/** Makes the context if it is the first to ask. Throws where there is no WebGL. @param {() => void} redraw called when the browser, which may take the context away, has given it back */
export function acquireRenderer(redraw) {
  if (!renderer) {
    renderer = new WebGLRenderer({ antialias: true, alpha: true, powerPreference: 'low-power' });
    renderer.toneMapping = NeutralToneMapping;
    room = { width: 0, height: 0, ratio: 0 };
  }
  renderer.domElement.addEventListener('webglcontextrestored', redraw);
  users++;
}

/** Gives the context back to the browser if nobody else draws with it. Dispose of what was drawn before. @param {() => void} redraw as it was acquired */
export function releaseRenderer(redraw) {
  renderer?.domElement.removeEventListener('webglcontextrestored', redraw);
  users--;
  if (users > 0 || !renderer) return;
  renderer.dispose();
  if (!renderer.getContext().isContextLost()) renderer.forceContextLoss();
  renderer = null;
}

/** @param {number} width @param {number} height @param {number} ratio */
function makeRoom(width, height, ratio) {
  if (width <= room.width && height <= room.height && ratio === room.ratio) return;
  room = { width: Math.max(width, room.width), height: Math.max(height, room.height), ratio };
  renderer?.setPixelRatio(ratio);
  renderer?.setSize(room.width, room.height, false);
}

/**
 * Draws a scene into a canvas.
 * @param {HTMLCanvasElement} canvas with a 2D context; resized to fit
 * @param {import('three').Scene} scene @param {import('three').Camera} camera
 * @param {{ width: number, height: number, ratio: number }} size whole CSS pixels, and device pixels to each
 */
export function drawInto(canvas, scene, camera, { width, height, ratio }) {
  const context = canvas.getContext('2d');
  // Without it the last picture stays.
  if (!renderer || !context || renderer.getContext().isContextLost()) return;
  makeRoom(width, height, ratio);
  renderer.setViewport(0, 0, width, height);
  renderer.setScissor(0, 0, width, height);
  renderer.setScissorTest(true);
  renderer.render(scene, camera);
  const [across, down] = [Math.floor(width * ratio), Math.floor(height * ratio)];
  if (canvas.width !== across) canvas.width = across;
  if (canvas.height !== down) canvas.height = down;
  context.clearRect(0, 0, across, down);
  context.drawImage(renderer.domElement, 0, renderer.domElement.height - down, across, down, 0, 0, across, down);
}
