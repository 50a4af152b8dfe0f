/** A view turned by keys, for readers without a mouse: arrows turn it as a drag that way would, + comes nearer, - steps back. */

const ANGLE = Math.PI / 24;
const NEARER = 0.9;

/** @typedef {import('three/addons/controls/OrbitControls.js').OrbitControls} OrbitControls */

/** @type {Record<string, (controls: OrbitControls) => void>} */
const MOVES = {
  ArrowLeft: (controls) => controls.rotateLeft(-ANGLE),
  ArrowRight: (controls) => controls.rotateLeft(ANGLE),
  ArrowUp: (controls) => controls.rotateUp(-ANGLE),
  ArrowDown: (controls) => controls.rotateUp(ANGLE),
  '+': (controls) => controls.dollyIn(NEARER),
  '=': (controls) => controls.dollyIn(NEARER),
  '-': (controls) => controls.dollyOut(NEARER),
};

/** Makes the canvas a stop of the tabulator. @param {HTMLCanvasElement} canvas @param {OrbitControls} controls @param {AbortSignal} [signal] until when */
export function turnByKeys(canvas, controls, signal) {
  const turn = (/** @type {KeyboardEvent} */ event) => {
    const move = MOVES[event.key];
    // With these, keys are the browser's.
    if (!move || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    controls.dispatchEvent({ type: 'start' });
    move(controls);
    controls.dispatchEvent({ type: 'end' });
  };
  canvas.tabIndex = 0;
  canvas.addEventListener('keydown', turn, signal ? { signal } : {});
  signal?.addEventListener('abort', () => canvas.removeAttribute('tabindex'));
}
