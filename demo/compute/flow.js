/** What must be computed anew when the sketch changes, in which thread, and in which order. The one place that writes what is computed into the state. */

import { findBadBound, problemOf, sentence } from '../state/definition.js';
import { areFar, chooseEnds, describeFar, findBadEnd } from '../state/ends.js';
import {
  areInside,
  areLeftBehind,
  areNear,
  endPlaces,
  lineOfEnds,
  mended,
  meshNow,
  moveEnds,
  pointsOfPath,
  projected,
  repairEnds,
  surfaceNow,
} from './footing.js';
import { closeSurfaces, describeWall, openSurfaces, setParameters } from './opened.js';
import { pointsOf, surfaceOf } from '../state/sketch.js';
import { choiceOf, chosenPath, render, state, UNSOLVED } from '../state/state.js';
import { describeNoMeasure } from '../panels/words.js';
import { askLong, live } from './workers.js';

/** @typedef {import('surfpath').Surfpath} Surfpath */
/** @typedef {import('../state/sketch.js').Sketch} Sketch */
/** @typedef {import('./drawable.js').SurfaceMesh} SurfaceMesh */
/** @typedef {import('./opened.js').Surfaces} Surfaces */
/** @typedef {import('./tasks.js').Solved} Solved */

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
/** The turn of the newest draft, while it is on its way: the surface has moved, and is not seen yet where it is. */
let drafting = 0;
/** Whether what is seen of the surface is a draft. */
let isDraft = false;
/** Ways left to move ends onto a surface that may have left them behind; none: that has been seen to. @type {(() => number[][])[]} */
let remedies = [];
/** What is wished of the next surface that is there, as a mistake in the formulas leaves it wished: to look at all of it, and from where. @type {Framing | null} */
let framing = null;
/** How the surface that is seen was looked at first. @type {Framing} */ let framed = {};
/** Those on which a path takes longer than a frame. @type {WeakSet<object>} */
const slow = new WeakSet();

/** How all of a surface is looked at: a direction, else from its ends' side; and what the reader of a link made of that. @typedef {{ direction?: readonly number[], view?: number[] }} Framing */
/** What the view shows of a surface that is new. @typedef {{ setSurface(mesh: SurfaceMesh, ends: readonly ArrayLike<number>[], chosen: number): number[][], frame(curve: ArrayLike<number>, direction?: readonly number[], view?: readonly number[]): void, refit(): void, view: number[] }} Stage */
/** @type {Stage | null} */
let stage = null;
let onSolved = (/** @type {boolean} */ _animated) => {};

/** Must be called first. @param {Surfpath} solver @param {(animated: boolean) => void} solved called with every new path */
export function connect(solver, solved) {
  surfpath = solver;
  onSolved = solved;
}

/** What a formula of constants comes to; NaN: it is none. @param {string} text */
export function numberIn(text) {
  try {
    const surface = surfpath.graph({ z: text, x: [0, 1], y: [0, 1] });
    const height = surface.evaluate([Number.NaN, Number.NaN])[2];
    surface.dispose();
    return height;
  } catch {
    return Number.NaN;
  }
}

/** Surfaces are shown in a view from now on; one that is there already, at once. @param {Stage | null} view null: there is no 3D */
export function showIn(view) {
  stage = view;
  if (state.mesh) {
    look(state.mesh);
    stage?.frame(lineOfEnds(), framed.direction, framed.view);
  }
  render();
}

/** Looks at all of the surface again, as when it was opened; at one of the reader's own from the side of the path. */
export const reframe = () => stage?.frame(pointsOfPath() ?? lineOfEnds(), framed.direction);

/** Whence the surface of the sketch is looked at; nothing: as when it was opened. */
export function viewNow() {
  const isSeen = !framing && state.shown?.entry === state.sketch.entry;
  return (isSeen ? (stage?.view ?? framed.view) : framing?.view) ?? [];
}

/** A new question about the path: older answers do not count any more. */
function begin() {
  clearTimeout(timer);
  return ++turn;
}

/** Whether what is seen is what the sketch began with, so that the sketch's points lie on it. */
const isReady = () => state.surface !== null && !state.building && !drafting && state.shown?.entry === state.sketch.entry;

/** What was to be computed cannot be: says why, and comes to rest. @param {Partial<import('../state/state.js').State>} why */
function give(why) {
  Object.assign(state, { moving: false, ...why });
  render();
}

/** What a sketch asks, about its own surface or the one that is seen. @param {Sketch} sketch @param {Sketch} shown */
function questionOf(sketch, shown) {
  const { ends, via, task, algorithm, tolerance, start, angle, reach } = sketch;
  // Each leg of the way has a point of its own at least.
  const points = Math.max(sketch.points, 2 * via.length + 1);
  return { definition: surfaceOf(shown), ends, via, options: { task, algorithm, tolerance, points, start, angle, reach } };
}

/** What is asked now. */
export const question = () => questionOf(state.sketch, state.shown ?? state.sketch);

/** What neither end alone is at fault for. @param {unknown} error @returns {import('../state/ends.js').EndProblem} */
const endProblemOf = (error) => ({ end: -1, coordinate: 0, message: messageOf(error) });

/** There is no path. @param {unknown} error why */
const unsolved = (error) => ({ endProblem: endProblemOf(error), solved: UNSOLVED, chosen: 0, moment: 1 });

const messageOf = (/** @type {unknown} */ error) => sentence(error instanceof Error ? error.message : String(error));

/** The surface of the formulas, anew, and its path; a mistake in them keeps the last good one. @param {{ frame: boolean } & Framing} options */
export async function rebuild({ frame, direction, view }) {
  const [mine, asked] = [++builds, begin()];
  drafting = 0;
  if (frame) framing = { direction, view };
  const { sketch } = state;
  const problem = findBadBound(sketch.kind, sketch.texts);
  if (problem) return give({ problem, building: false });
  Object.assign(state, { problem: null, building: true });
  /** @type {Surfaces | null} */ let opened = null;
  /** @type {Solved | null} */ let solved = null;
  /** Until the path is there between ends that were brought to where they are seen. @type {Promise<void> | null} */ let fetched = null;
  let isSeen = false;
  const receive = (/** @type {{ mesh: SurfaceMesh }} */ { mesh }) => {
    if (mine !== builds) return;
    // Ends of another entry are none of the surface that is still seen.
    const wereNear = !framing && areNear();
    adopt(sketch, /** @type {Surfaces} */ (opened), mesh);
    isSeen = true;
    framed = framing ?? {};
    if (framing) {
      framing = null;
      return stage?.frame(lineOfEnds(), framed.direction, framed.view);
    }
    stage?.refit();
    // A link, or an entry of the gallery, says where they are; a formula that grew away from them, or beside which they became one dot, does not.
    const isFar = areFar(endPlaces(), state.seen);
    if (isFar || (areNear() && !wereNear)) {
      moveEnds(mended(), isFar ? 'far' : 'near');
      look(mesh);
      stage?.refit();
      fetched = solve(true);
    }
  };
  try {
    opened = openSurfaces(surfpath, surfaceOf(sketch));
    const isSolvable = areInside(sketch, opened.surface);
    solved = await live.ask('open', { ...questionOf(sketch, sketch), isSolvable }, receive);
  } catch (error) {
    if (isSeen && asked === turn) return give(unsolved(error));
    if (!isSeen && mine === builds) give({ problem: problemOf(error, sketch.kind, sketch.texts), building: false });
  }
  if (!isSeen && opened) closeSurfaces(opened);
  if (!isSeen || mine !== builds) return;
  if (!solved || asked !== turn) return fetched ?? solve(true);
  show(solved, true);
  return fetchEnds();
}

/** The surface has changed, and may have left its ends behind. @param {boolean} isDrafted */
function unsettle(isDrafted) {
  isDraft = isDrafted;
  remedies = [mended, projected, () => chooseEnds(surfaceNow(), meshNow(), state.seen)];
}

/** Ends that are left behind by the surface are moved onto it: to the nearest places, else anywhere. */
async function fetchEnds() {
  const [remedy, ...others] = areLeftBehind() ? remedies : [];
  remedies = others;
  if (!remedy) return;
  moveEnds(remedy());
  await solve(true);
}

/** Takes a surface in place of the last one. @param {Sketch} sketch @param {Surfaces} opened @param {SurfaceMesh} mesh */
function adopt(sketch, opened, mesh) {
  closeSurfaces(state);
  Object.assign(state, opened, { mesh, shown: sketch, building: false, moving: false });
  Object.assign(state, { solved: UNSOLVED, chosen: 0, shade: null, shadeProblem: null, endProblem: null });
  unsettle(false);
  look(mesh);
  state.note ??= describeFar(endPlaces(), state.seen) ?? describeWall(surfpath, opened.surface, sketch);
  render();
}

/** Shows a mesh in the view. @param {SurfaceMesh} mesh */
function look(mesh) {
  // The height of a graph is as it comes; all else has ranges, or is put into space by hand.
  state.seen = stage?.setSurface(mesh, endPlaces(), state.shown?.kind === 'graph' ? 2 : 3) ?? [];
}

/** The path, exactly, on a surface that is as exact, with its ends on it. @param {boolean} animated */
export async function solve(animated) {
  const mine = begin();
  if (!isReady()) return;
  try {
    if (isDraft) await redraw();
    if (mine !== turn) return;
    if (remedies.length > 0) repairEnds();
    const endProblem = findBadEnd(state.sketch.kind, surfaceNow(), pointsOf(state.sketch));
    if (endProblem) return give({ endProblem, solved: UNSOLVED });
    state.endProblem = null;
    render();
    const solved = await live.ask('solve', question());
    if (mine !== turn || !solved) return;
    show(solved, animated);
  } catch (error) {
    if (mine !== turn) return;
    give(unsolved(error));
  }
  await fetchEnds();
}

/** @param {Solved} solved @param {boolean} animated */
function show(solved, animated) {
  give({ solved, chosen: choiceOf(state.sketch, solved), moment: 1 });
  onSolved(animated);
}

/** The surface exactly, after a parameter has come to rest. */
async function redraw() {
  const { surface, shown } = state;
  if (surface?.kind === 'implicit') {
    const mesh = await live.ask('mesh', { definition: surfaceOf(/** @type {Sketch} */ (shown)) });
    if (!mesh || shown !== state.shown) return;
    look(mesh);
    Object.assign(state, { mesh, shade: null });
  }
  isDraft = false;
  // Not while it moves: who changes its size sees it change.
  stage?.refit();
}

/** Everything exactly, a moment after the last movement. */
function settleSoon() {
  clearTimeout(timer);
  timer = window.setTimeout(() => solve(false), SETTLE);
}

/** The path after an end has moved: from the last one, at once. */
export function follow() {
  const last = chosenPath();
  const { via, points, task, kind } = state.sketch;
  begin();
  if (!isReady()) return render();
  state.endProblem = findBadEnd(kind, surfaceNow(), pointsOf(state.sketch));
  if (state.endProblem || task === 'trace' || via.length > 0 || slow.has(surfaceNow())) return solve(false);
  if (last && Number.isFinite(last.length)) followFrom(last, Math.min(points, 200));
  render();
  return settleSoon();
}

/** @param {import('surfpath').Path} last @param {number} points */
function followFrom(last, points) {
  const [from, to] = state.sketch.ends;
  const start = performance.now();
  try {
    const find = (/** @type {import('surfpath').Path | 'straight'} */ begin) =>
      surfaceNow().shortestPath(from, to, { start: begin, points, tolerance: 1e-6 });
    // Beside a rim, the last one moved to the new end may leave the surface.
    const near = find(last);
    const path = Number.isFinite(near.length) ? near : find('straight');
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
  drafting = mine;
  const shown = { ...state.shown, parameters };
  const start = chosenPath() ?? undefined;
  try {
    setParameters(state, parameters);
    const resolution = state.surface.kind === 'implicit' ? DRAFT : undefined;
    const draft = await live.ask('draft', { ...question(), definition: surfaceOf(shown), start, resolution });
    if (!draft || built !== builds) return;
    look(draft.mesh);
    unsettle(true);
    Object.assign(state, { mesh: draft.mesh, shown, shade: null, moving: true });
    if (draft.path && Number.isFinite(draft.path.length)) state.solved = { ...UNSOLVED, paths: [draft.path] };
    render();
    if (mine !== drafting) return;
    drafting = 0;
    settleSoon();
  } catch (error) {
    // Where it has moved on, or the last one that could be drawn, and its path.
    if (mine !== drafting) return;
    drafting = 0;
    setParameters(state, state.shown.parameters);
    give({ problem: problemOf(error, shown.kind, shown.texts) });
    await solve(false);
  }
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
  /** What there is of it, if anything. @type {import('./shade.js').Shade | null} */ let painted = null;
  const paint = (/** @type {import('./shade.js').Shade | null | undefined} */ shade) => {
    if (mine !== turn || !shade) return;
    state.shade = painted = shade.some(Number.isFinite) ? shade : null;
    render();
  };
  try {
    const exact = await askLong('shade', { colour, from: ends[0] }, ({ shade }) => paint(shade));
    paint(exact);
    if (exact && !painted) throw new RangeError(describeNoMeasure(state.shown ?? state.sketch));
  } catch (error) {
    if (mine !== turn) return;
    Object.assign(state, { shade: painted, shadeProblem: painted ? null : messageOf(error) });
    render();
  }
}
