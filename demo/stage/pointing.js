/** The mouse over the 3D view: which point of the surface it is at, and how far along the path; and the dot for what is pointed at elsewhere. */

import { placesOf } from '../compute/drawn.js';
import { runsOf } from '../compute/legs.js';
import { placeOf } from '../state/ends.js';
import { onHover, setHover } from '../state/hover.js';
import { chosenPath, onRender, state } from '../state/state.js';

/** CSS pixels within which the path is meant. */
const NEAR = 12;

/** @param {import('./scene.js').View} view */
export function startPointing(view) {
  let request = 0;
  const { canvas } = view;
  canvas.addEventListener('pointermove', ({ clientX, clientY, buttons, pointerType }) => {
    cancelAnimationFrame(request);
    // Who turns the view points at nothing.
    if (buttons !== 0 || pointerType === 'touch') return setHover(null);
    request = requestAnimationFrame(() => setHover(state.building ? null : pointAt(view, clientX, clientY)));
  });
  canvas.addEventListener('pointerleave', () => {
    cancelAnimationFrame(request);
    setHover(null);
  });
  onHover((hover) => view.setDot(hover && (hover.place ?? (hover.parameters && placeIn(hover.parameters)))));
  let shown = state.mesh;
  onRender(({ mesh }) => {
    if (mesh !== shown) setHover(null);
    shown = mesh;
  });
}

/** @param {number[]} parameters */
const placeIn = (parameters) => state.drawn && placeOf(state.drawn, parameters);

/** @param {import('./scene.js').View} view @param {number} x @param {number} y @returns {import('../state/hover.js').Hover | null} */
function pointAt(view, x, y) {
  const hit = view.pick(x, y);
  if (!hit) return null;
  const { shares } = hit;
  const domain = state.drawn?.domain;
  const parameters = domain && shares ? [domain.u, domain.v].map(([low, high], k) => low + shares[k] * (high - low)) : null;
  return { place: parameters ? placeIn(parameters) : hit.place, parameters, run: runAt(view, x, y) };
}

/** How far along the path is what is at a place of the window; null: the path is not there. @param {import('./scene.js').View} view @param {number} x @param {number} y */
function runAt(view, x, y) {
  const path = chosenPath();
  const places = path ? placesOf(path) : [];
  const { left, top } = view.canvas.getBoundingClientRect();
  let [nearest, least] = [-1, NEAR];
  for (let i = 0; i < places.length; i += 3) {
    const [across, down] = view.toScreen([places[i], places[i + 1], places[i + 2]]);
    const distance = Math.hypot(left + across - x, top + down - y);
    if (distance < least) [nearest, least] = [i, distance];
  }
  return path && nearest >= 0 ? runsOf(path, state.solved.legs)[nearest / 3] : null;
}
