/** Where the sketch's points stand on the surface that is seen; and moved back onto it, where it has left them behind. */

import { areOneDot, describeMoved, findBadEnd, mendEnds, onto, placeOf } from '../state/ends.js';
import { surfaceOf } from '../state/sketch.js';
import { chosenPath, state } from '../state/state.js';

/** @typedef {import('../state/sketch.js').Sketch} Sketch */
/** @typedef {import('./drawable.js').SurfaceMesh} SurfaceMesh */

/** The ends of the sketch, put onto what is seen of the surface. */
export function mended() {
  const { surface, drawn, mesh, shown, sketch, seen } = /** @type {any} */ (state);
  return mendEnds(sketch.kind, { surface, drawn, mesh }, surfaceOf(shown), sketch.ends, seen);
}

/** The ends of the sketch on the surface: the solver goes downhill from where they are, and may get nowhere, or too far, where there is a place nearby. */
export function projected() {
  const { drawn, shown, sketch } = /** @type {any} */ (state);
  return sketch.ends.map((/** @type {number[]} */ end) => onto(drawn, surfaceOf(shown), end) ?? end);
}

/** Ends elsewhere, as the note says; points on the way go. @param {number[][]} ends @param {import('../state/ends.js').Why} [why] */
export function moveEnds(ends, why) {
  state.note = describeMoved(state.sketch.ends, ends, why) ?? state.note;
  state.sketch = { ...state.sketch, ends, via: [] };
}

/** Whether a formula that was changed has left its ends behind: off the surface, or where it has no value. */
export function areLeftBehind() {
  const isLost = (/** @type {number[]} */ end) => state.drawn !== null && placeOf(state.drawn, end) === null;
  return chosenPath()?.status === 'off-surface' || (state.sketch.ends.some(isLost) && meshNow().indices.length > 0);
}

/** The surface that is seen, once there is one. */
export const surfaceNow = () => /** @type {import('surfpath').Surface} */ (state.surface);
export const meshNow = () => /** @type {SurfaceMesh} */ (state.mesh);

/** Whether all points of a sketch may lie on a surface. @param {Sketch} sketch @param {import('surfpath').Surface} surface */
export const areInside = ({ kind, ends, via }, surface) => !findBadEnd(kind, surface, [...ends, ...via]);

/** Ends outside the surface's domain are moved onto it, points on the way there are dropped. */
export function repairEnds() {
  const { kind, ends, via } = state.sketch;
  if (areInside(state.sketch, surfaceNow())) return;
  const inside = (/** @type {number[]} */ point) => !findBadEnd(kind, surfaceNow(), [point]);
  if (findBadEnd(kind, surfaceNow(), ends)) moveEnds(mended());
  else state.sketch = { ...state.sketch, via: via.filter(inside) };
}

/** Where the ends are, as far as they are anywhere. */
export const endPlaces = () =>
  state.sketch.ends.flatMap((end) => {
    const place = state.drawn && placeOf(state.drawn, end);
    return place ? [place] : [];
  });

/** Whether the ends are one dot in the view. */
export function areNear() {
  const { drawn, mesh, sketch, seen } = state;
  return drawn && mesh && areOneDot(drawn, mesh, sketch.ends, seen);
}

/** What to look at: the line from one end to the other, x y z of each place. */
export function lineOfEnds() {
  const [from, to] = endPlaces();
  return to ? [...from, ...from.map((x, k) => (x + to[k]) / 2), ...to] : [];
}

/** Better, once there is a path: all of it. */
export function pointsOfPath() {
  const points = chosenPath()?.points ?? [];
  return points.length > 0 ? points : null;
}
