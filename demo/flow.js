/** What must be computed anew when the sketch changes, in which thread, and in which order. The one place that writes what is computed into the state. */

import { findBadBound, problemOf, sentence } from './definition.js';
import { drawnOf } from './drawn.js';
import { chooseEnds, findBadEnd, placeOf } from './ends.js';
import { Solver } from './solver.js';
import { surfaceOf } from './sketch.js';
import { chosenPath, render, state, UNSOLVED } from './state.js';

/** @typedef {import('surfpath').Surfpath} Surfpath */
/** @typedef {import('./sketch.js').Sketch} Sketch */

/** Milliseconds after the last movement before everything is computed exactly. */
const SETTLE = 180;
/** Cells a direction of an implicit surface while a slider moves it. */
const DRAFT = 40;

/** @type {Surfpath} */ let surfpath;
/** Counts changes: an answer to an older one is of no use. */
let turn = 0;
let timer = 0;

const live = new Solver((busy) => {
  state.busy = busy;
  render();
});
/** Its own thread: a long task must not keep the path waiting. */
const long = new Solver((busy) => {
  state.long = busy;
  render();
});

/** What the view shows of a surface that is new. @type {{ setSurface(mesh: import('./drawable.js').SurfaceMesh): boolean, frame(something: ArrayLike<number> | null, direction?: readonly number[]): void } | null} */
let stage = null;
let onSolved = (/** @type {boolean} */ _animated) => {};

/** Must be called first. @param {Surfpath} solver @param {typeof stage} view null: there is no 3D @param {(animated: boolean) => void} solved called with every new path */
export function connect(solver, view, solved) {
  surfpath = solver;
  stage = view;
  onSolved = solved;
}

/** @param {string} task @param {any} request @param {(progress: any) => void} [report] */
export const askLong = (task, request, report) => long.ask(task, { definition: surfaceOf(state.sketch), ...request }, report);

export const cancelLong = () => long.cancel();

/** The question that the sketch asks. */
function question() {
  const { ends, via, task, algorithm, tolerance, points, start, angle, reach } = state.sketch;
  return { definition: surfaceOf(state.sketch), ends, via, options: { task, algorithm, tolerance, points, start, angle, reach } };
}

/** Runs something of the solver; what it throws becomes a problem of the ends. @template T @param {() => Promise<T>} run @returns {Promise<T | null>} */
async function attempt(run) {
  try {
    return await run();
  } catch (error) {
    const message = sentence(error instanceof Error ? error.message : String(error));
    state.endProblem = { end: -1, coordinate: 0, message };
    return null;
  }
}

/** The surface of the formulas, anew; a mistake in them keeps the last good one. @param {{ frame: boolean, direction?: readonly number[] }} options */
export async function rebuild({ frame, direction }) {
  const mine = ++turn;
  clearTimeout(timer);
  const { kind, texts } = state.sketch;
  state.problem = findBadBound(kind, texts);
  if (state.problem) return render();
  try {
    const definition = surfaceOf(state.sketch);
    open(definition);
    const mesh = await live.ask('mesh', { definition });
    if (!mesh || mine !== turn) return;
    const outgrown = showMesh(mesh);
    if (frame || outgrown) stage?.frame(middle(), direction);
  } catch (error) {
    if (mine !== turn) return;
    state.problem = problemOf(error, kind, texts);
    return render();
  }
  repairEnds();
  await solve(true);
  if (mine === turn && chosenPath()?.status === 'off-surface') {
    state.sketch = { ...state.sketch, ends: chooseEnds(surfaceNow(), meshNow()) };
    await solve(true);
  }
}

/** @param {any} definition throws where it is wrong */
function open(definition) {
  const surface = surfpath.surface(definition);
  let [drawn, gauge] = [surface, surface.kind === 'metric' ? surface : null];
  try {
    drawn = drawnOf(surfpath, surface, definition);
    gauge ??= gaugeOf(surface, definition);
  } catch (error) {
    surface.dispose();
    throw error;
  }
  for (const old of surfaces()) old.dispose();
  Object.assign(state, { surface, drawn, gauge });
}

/** The metric alone, to draw it; null where there is none, or it is written with more than u and v. @param {import('surfpath').Surface} surface @param {any} definition */
function gaugeOf({ domain }, { metric, parameters }) {
  if (!metric || !domain) return null;
  try {
    return surfpath.metric({ ...metric, u: [domain.u[0], domain.u[1]], v: [domain.v[0], domain.v[1]], parameters });
  } catch {
    return null;
  }
}

/** All that the state holds, each once. */
const surfaces = () => new Set([state.surface, state.drawn, state.gauge].filter((surface) => surface !== null));

const surfaceNow = () => /** @type {import('surfpath').Surface} */ (state.surface);
const meshNow = () => /** @type {import('./drawable.js').SurfaceMesh} */ (state.mesh);

/** @param {import('./drawable.js').SurfaceMesh} mesh @returns {boolean | undefined} whether it is of another size */
function showMesh(mesh) {
  Object.assign(state, { mesh, shown: state.sketch, solved: UNSOLVED, chosen: 0, shade: null, shadeProblem: null, endProblem: null });
  const outgrown = stage?.setSurface(mesh);
  render();
  return outgrown;
}

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

/** The path, exactly. @param {boolean} animated */
export async function solve(animated) {
  const mine = ++turn;
  clearTimeout(timer);
  if (!state.surface) return;
  state.endProblem = findBadEnd(state.sketch.kind, state.surface, state.sketch.ends);
  if (state.endProblem) {
    state.solved = UNSOLVED;
    return render();
  }
  render();
  const solved = await attempt(() => live.ask('solve', question()));
  if (mine !== turn) return;
  Object.assign(state, { solved: solved ?? UNSOLVED, chosen: 0, moment: 1, moving: false });
  render();
  onSolved(animated);
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
  turn++;
  state.endProblem = state.surface && findBadEnd(kind, state.surface, ends);
  if (!state.surface || state.endProblem || task === 'trace' || via.length > 0 || !last || !Number.isFinite(last.length)) {
    if (state.endProblem) state.solved = UNSOLVED;
    render();
    return via.length > 0 || task === 'trace' ? solve(false) : settleSoon();
  }
  try {
    const path = state.surface.shortestPath(ends[0], ends[1], { start: last, points: Math.min(points, 200), tolerance: 1e-6 });
    const usable = Number.isFinite(path.length);
    if (usable) state.solved = { ...UNSOLVED, paths: [path], milliseconds: state.solved.milliseconds };
    Object.assign(state, { chosen: 0, moment: 1, moving: true });
  } catch (error) {
    state.endProblem = { end: -1, coordinate: 0, message: sentence(String(/** @type {Error} */ (error).message)) };
  }
  render();
  settleSoon();
}

/** Surface and path after a parameter has moved: both of the same moment, coarse while it moves. @param {Record<string, number>} parameters */
export async function deform(parameters) {
  if (!state.surface || state.problem) return rebuild({ frame: false });
  const mine = ++turn;
  const start = chosenPath() ?? undefined;
  const { kind, texts } = state.sketch;
  try {
    for (const one of surfaces()) one.set(parameters);
    const draft = await live.ask('draft', { ...question(), start, resolution: state.surface.kind === 'implicit' ? DRAFT : undefined });
    if (!draft) return;
    stage?.setSurface(draft.mesh);
    Object.assign(state, { mesh: draft.mesh, shown: state.sketch, shade: null, moving: true, problem: null });
    if (draft.path && Number.isFinite(draft.path.length)) state.solved = { ...UNSOLVED, paths: [draft.path] };
  } catch (error) {
    state.problem = problemOf(error, kind, texts);
  }
  render();
  if (mine !== turn) return;
  clearTimeout(timer);
  timer = window.setTimeout(refine, SETTLE);
}

/** Surface and path exactly, after a parameter has come to rest. */
async function refine() {
  const mine = ++turn;
  const { kind, texts } = state.sketch;
  try {
    if (state.surface?.kind === 'implicit') {
      const mesh = await live.ask('mesh', { definition: surfaceOf(state.sketch) });
      if (!mesh || mine !== turn) return;
      stage?.setSurface(mesh);
      Object.assign(state, { mesh, shade: null });
    }
  } catch (error) {
    state.problem = problemOf(error, kind, texts);
    return render();
  }
  repairEnds();
  return solve(false);
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
  try {
    const shade = await askLong('shade', { colour, from: ends[0] });
    if (mine !== turn || !shade) return;
    state.shade = shade;
  } catch (error) {
    state.shade = null;
    state.shadeProblem = sentence(error instanceof Error ? error.message : String(error));
  }
  render();
}
