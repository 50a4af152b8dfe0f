/** What must be computed anew when the sketch changes, in which thread, and in which order. The one place that writes what is computed into the state. */

import { findBadBound, problemOf, sentence } from '../state/definition.js';
import { chooseEnds, findBadEnd, placeOf } from '../state/ends.js';
import { closeSurfaces, openSurfaces, setParameters } from './opened.js';
import { surfaceOf } from '../state/sketch.js';
import { chosenPath, render, state, UNSOLVED } from '../state/state.js';
import { askLong, live } from './workers.js';

/** @typedef {import('surfpath').Surfpath} Surfpath */
/** @typedef {import('../state/sketch.js').Sketch} Sketch */
/** @typedef {import('./drawable.js').SurfaceMesh} SurfaceMesh */
/** @typedef {import('./opened.js').Surfaces} Surfaces */

/** Milliseconds after the last movement before everything is computed exactly. */
const SETTLE = 180;
/** Cells a direction of an implicit surface while a slider moves it. */
const DRAFT = 40;
/** Milliseconds that a path may take in the page's own thread while an end is dragged. */
const FRAME = 12;

/** @type {Surfpath} */ let surfpath;
/** Counts changes of the surface, and of the path: an answer to an older one is of no use. */
let [builds, turn] = [0, 0];
let timer = 0;
/** Where the surface that is seen is looked at from; undefined: from its ends' side. @type {readonly number[] | undefined} */ let toLookFrom;
/** Those on which a path takes longer than a frame. @type {WeakSet<object>} */
const slow = new WeakSet();

/** What the view shows of a surface that is new. @type {{ setSurface(mesh: SurfaceMesh): boolean, frame(something: ArrayLike<number> | null, direction?: readonly number[]): void } | null} */
let stage = null;
let onSolved = (/** @type {boolean} */ _animated) => {};

/** Must be called first. @param {Surfpath} solver @param {(animated: boolean) => void} solved called with every new path */
export function connect(solver, solved) {
  surfpath = solver;
  onSolved = solved;
}

/** Surfaces are shown in a view from now on; one that is there already, at once. @param {typeof stage} view null: there is no 3D */
export function showIn(view) {
  stage = view;
  if (!state.mesh) return;
  stage?.setSurface(state.mesh);
  stage?.frame(middle(), toLookFrom);
  render();
}

/** A new question about the path: older answers do not count any more. */
function begin() {
  clearTimeout(timer);
  return ++turn;
}

/** Whether what is seen is a surface of the sketch's kind, so that the sketch's points lie on it. */
const isReady = () => state.surface !== null && !state.building && state.shown?.kind === state.sketch.kind;

/** What was to be computed cannot be: says why, and comes to rest. @param {Partial<import('../state/state.js').State>} why */
function give(why) {
  Object.assign(state, { moving: false, ...why });
  render();
}

/** The question that the sketch asks, about the surface that is seen. */
function question() {
  const { ends, via, task, algorithm, tolerance, points, start, angle, reach } = state.sketch;
  const definition = surfaceOf(/** @type {Sketch} */ (state.shown));
  return { definition, ends, via, options: { task, algorithm, tolerance, points, start, angle, reach } };
}

/** What neither end alone is at fault for. @param {unknown} error @returns {import('../state/ends.js').EndProblem} */
const endProblemOf = (error) => ({ end: -1, coordinate: 0, message: messageOf(error) });

const messageOf = (/** @type {unknown} */ error) => sentence(error instanceof Error ? error.message : String(error));

/** The surface of the formulas, anew; a mistake in them keeps the last good one. @param {{ frame: boolean, direction?: readonly number[] }} options */
export async function rebuild({ frame, direction }) {
  const mine = ++builds;
  begin();
  const { sketch } = state;
  const problem = findBadBound(sketch.kind, sketch.texts);
  if (problem) return give({ problem, building: false });
  Object.assign(state, { problem: null, building: true });
  /** @type {Surfaces | null} */ let opened = null;
  try {
    const definition = surfaceOf(sketch);
    opened = openSurfaces(surfpath, definition);
    const mesh = await live.ask('mesh', { definition });
    if (!mesh || mine !== builds) return closeSurfaces(opened);
    const outgrown = adopt(sketch, opened, mesh);
    toLookFrom = direction;
    if (frame || outgrown) stage?.frame(middle(), direction);
  } catch (error) {
    if (opened) closeSurfaces(opened);
    if (mine === builds) give({ problem: problemOf(error, sketch.kind, sketch.texts), building: false });
    return;
  }
  repairEnds();
  const path = await solve(true);
  // A formula that was changed may have left its ends behind.
  if (path?.status !== 'off-surface') return;
  state.sketch = { ...state.sketch, ends: chooseEnds(surfaceNow(), meshNow()), via: [] };
  await solve(true);
}

/** Takes a surface in place of the last one. @param {Sketch} sketch @param {Surfaces} opened @param {SurfaceMesh} mesh @returns {boolean | undefined} whether it is of another size */
function adopt(sketch, opened, mesh) {
  closeSurfaces(state);
  Object.assign(state, opened, { mesh, shown: sketch, building: false, moving: false });
  Object.assign(state, { solved: UNSOLVED, chosen: 0, shade: null, shadeProblem: null, endProblem: null });
  const outgrown = stage?.setSurface(mesh);
  render();
  return outgrown;
}

const surfaceNow = () => /** @type {import('surfpath').Surface} */ (state.surface);
const meshNow = () => /** @type {SurfaceMesh} */ (state.mesh);

function repairEnds() {
  const { kind, ends, via } = state.sketch;
  const inside = (/** @type {number[]} */ point) => !findBadEnd(kind, surfaceNow(), [point, point]);
  if (findBadEnd(kind, surfaceNow(), ends)) state.sketch = { ...state.sketch, ends: chooseEnds(surfaceNow(), meshNow()), via: [] };
  else if (!via.every(inside)) state.sketch = { ...state.sketch, via: via.filter(inside) };
}

/** A place to look from: the middle between the ends. */
function middle() {
  const places = state.sketch.ends.map((end) => state.drawn && placeOf(state.drawn, end));
  return places[0] && places[1] ? places[0].map((x, k) => (x + /** @type {number[]} */ (places[1])[k]) / 2) : null;
}

/** The path, exactly. @param {boolean} animated @returns {Promise<import('surfpath').Path | null>} null: there is none, or another question was asked meanwhile */
export async function solve(animated) {
  const mine = begin();
  if (!isReady()) return null;
  const endProblem = findBadEnd(state.sketch.kind, surfaceNow(), state.sketch.ends);
  if (endProblem) {
    give({ endProblem, solved: UNSOLVED });
    return null;
  }
  state.endProblem = null;
  render();
  try {
    const solved = await live.ask('solve', question());
    if (mine !== turn || !solved) return null;
    give({ solved, chosen: 0, moment: 1 });
  } catch (error) {
    if (mine === turn) give({ endProblem: endProblemOf(error), solved: UNSOLVED, chosen: 0, moment: 1 });
    return null;
  }
  onSolved(animated);
  return chosenPath();
}

/** Everything exactly, a moment after the last movement. */
function settleSoon() {
  clearTimeout(timer);
  timer = window.setTimeout(() => solve(false), SETTLE);
}

/** The path after an end has moved: from the last one, at once. */
export function follow() {
  const last = chosenPath();
  const { ends, via, points, task, kind } = state.sketch;
  begin();
  if (!isReady()) return render();
  state.endProblem = findBadEnd(kind, surfaceNow(), ends);
  if (state.endProblem) return give({ solved: UNSOLVED });
  if (task === 'trace' || via.length > 0 || slow.has(surfaceNow())) return solve(false);
  if (last && Number.isFinite(last.length)) followFrom(last, Math.min(points, 200));
  render();
  return settleSoon();
}

/** @param {import('surfpath').Path} last @param {number} points */
function followFrom(last, points) {
  const [from, to] = state.sketch.ends;
  const start = performance.now();
  try {
    const path = surfaceNow().shortestPath(from, to, { start: last, points, tolerance: 1e-6 });
    if (Number.isFinite(path.length)) state.solved = { ...UNSOLVED, paths: [path], milliseconds: state.solved.milliseconds };
    Object.assign(state, { chosen: 0, moment: 1, moving: true });
  } catch (error) {
    state.endProblem = endProblemOf(error);
  }
  if (performance.now() - start > FRAME) slow.add(surfaceNow());
}

/** Surface and path after a parameter has moved: both of the same moment, coarse while it moves. @param {Record<string, number>} parameters */
export async function deform(parameters) {
  if (!state.surface || !state.shown || state.problem || state.building) return rebuild({ frame: false });
  const [mine, built] = [begin(), builds];
  const shown = { ...state.shown, parameters };
  const start = chosenPath() ?? undefined;
  try {
    setParameters(state, parameters);
    const resolution = state.surface.kind === 'implicit' ? DRAFT : undefined;
    const draft = await live.ask('draft', { ...question(), definition: surfaceOf(shown), start, resolution });
    if (!draft || built !== builds) return;
    stage?.setSurface(draft.mesh);
    Object.assign(state, { mesh: draft.mesh, shown, shade: null, moving: true });
    if (draft.path && Number.isFinite(draft.path.length)) state.solved = { ...UNSOLVED, paths: [draft.path] };
  } catch (error) {
    if (built !== builds) return;
    setParameters(state, state.shown.parameters);
    return give({ problem: problemOf(error, shown.kind, shown.texts) });
  }
  render();
  if (mine !== turn) return;
  clearTimeout(timer);
  timer = window.setTimeout(refine, SETTLE);
}

/** Surface and path exactly, after a parameter has come to rest. */
async function refine() {
  const [mine, built] = [begin(), builds];
  const shown = /** @type {Sketch} */ (state.shown);
  try {
    if (state.surface?.kind === 'implicit') {
      const mesh = await live.ask('mesh', { definition: surfaceOf(shown) });
      if (!mesh || mine !== turn || built !== builds) return;
      stage?.setSurface(mesh);
      Object.assign(state, { mesh, shade: null });
    }
  } catch (error) {
    if (mine === turn) give({ problem: problemOf(error, shown.kind, shown.texts) });
    return;
  }
  repairEnds();
  await solve(false);
}

/** Colours for the surface as the sketch wishes them. */
export async function recolour() {
  const { colour, ends } = state.sketch;
  state.shadeProblem = null;
  if (colour === 'plain' || !state.mesh) {
    state.shade = null;
    return render();
  }
  const mine = turn;
  /** The last one before the exact one is there. @type {import('./shade.js').Shade | null} */ let painted = null;
  const paint = (/** @type {import('./shade.js').Shade | null | undefined} */ shade) => {
    if (mine !== turn || !shade) return;
    state.shade = painted = shade;
    render();
  };
  try {
    paint(await askLong('shade', { colour, from: ends[0] }, ({ shade }) => paint(shade)));
  } catch (error) {
    if (mine !== turn) return;
    Object.assign(state, { shade: painted, shadeProblem: painted ? null : messageOf(error) });
    render();
  }
}
