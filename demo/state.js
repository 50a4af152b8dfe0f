/** The page's one state, what can be done to it, and the one function that shows it. */

import { gallery } from 'surfpath/gallery';
import { buildSurface, chooseEnds, findBadEnd, meshOf, placeOf, solve, UNSOLVED } from './compute.js';
import { blend, smooth } from './curves.js';
import { definitionOf, findBadBound, problemOf, textsOf } from './definition.js';
import { find, say } from './dom.js';
import { OWN } from './kinds.js';
import { buildEnds, buildFields, buildSliders, showEndProblem, showProblem } from './panel.js';
import { Player } from './player.js';
import { showMoment, showResult } from './result.js';

/** @typedef {import('./kinds.js').Kind} Kind */
/** @typedef {import('./definition.js').Texts} Texts */
/** @typedef {import('surfpath/gallery').GalleryEntry} GalleryEntry */

/** @type {Readonly<Record<string, GalleryEntry>>} */
const entries = { ...gallery, ...Object.fromEntries(Object.values(OWN).map((own) => [`own-${own.kind}`, own])) };

const state = {
  entry: '',
  kind: /** @type {Kind} */ ('parametric'),
  texts: /** @type {Texts} */ ({}),
  /** Those of the gallery's entry, or what a formula of one's own starts from. */
  given: /** @type {Texts} */ ({}),
  /** Those of the last good surface. */
  shown: /** @type {Texts} */ ({}),
  parameters: /** @type {Record<string, number>} */ ({}),
  ends: /** @type {number[][]} */ ([]),
  options: /** @type {import('./compute.js').Options} */ ({ points: 64, algorithm: 'elements', tolerance: 1e-9, start: 'global' }),
  /** The last good surface. */
  built: /** @type {import('./compute.js').Built | null} */ (null),
  problem: /** @type {import('./definition.js').Problem | null} */ (null),
  solved: UNSOLVED,
  /** The iterate shown: 0 the start, between whole numbers what lies between two. */
  moment: 0,
};

/** @type {import('surfpath').Surfpath} */ let surfpath;
/** @type {import('./scene.js').View | null} */ let view = null;

const player = new Player(showAt);

/** Must be called first. @param {import('surfpath').Surfpath} solver @param {import('./scene.js').View | null} scene null: there is no 3D */
export function connect(solver, scene) {
  surfpath = solver;
  view = scene;
}

export const kind = () => state.kind;

/** Shows an iterate, or what lies between two of them. @param {number} moment */
function showAt(moment) {
  state.moment = moment;
  renderMoment();
}

function renderMoment() {
  const { frames } = state.solved;
  const last = frames.length - 1;
  const before = Math.min(Math.floor(state.moment), Math.max(last - 1, 0));
  const warmth = last > 0 ? state.moment / last : 1;
  view?.setWarmth(warmth * warmth);
  view?.setPath(last < 0 ? null : smooth(last === 0 ? frames[0] : blend(frames[before], frames[before + 1], state.moment - before)));
  showMoment(state.moment, last);
}

/** Whether the surface is still the gallery's entry, so that the formula and source of that speak of it. */
const isGiven = () => Object.keys(state.given).every((name) => state.given[name] === state.shown[name]);

function render() {
  const { solved, options, problem } = state;
  view?.setStart(solved.straight && smooth(solved.straight));
  view?.setEnds(state.ends.map(endPlace));
  showProblem(problem);
  showEndProblem(solved.problem);
  const entry = isGiven() ? entries[state.entry] : undefined;
  say(find('typeset'), entry?.formula ?? null);
  say(find('source'), entry?.source ?? null);
  for (const [name, value] of Object.entries(state.parameters)) find(`value-${name}`).textContent = String(Number(value.toPrecision(4)));
  find('tolerance-row').hidden = options.algorithm !== 'elements';
  showResult({ ...solved, start: options.start, problem });
  renderMoment();
}

/** Where an end is drawn: where the path ends, or, without one, where it was asked. @param {number[]} point @param {number} end */
function endPlace(point, end) {
  const points = state.solved.path?.points;
  if (points && points.length > 0) return points.slice(end === 0 ? 0 : -3).slice(0, 3);
  return state.built && point.every(Number.isFinite) ? placeOf(state.built.surface, point) : null;
}

/** Finds the path anew. @param {boolean} animated */
function updatePath(animated) {
  if (state.built) state.solved = solve(state.built, state.ends, state.options);
  player.stop();
  state.moment = Math.max(state.solved.frames.length - 1, 0);
  render();
  if (animated) play();
}

/** Builds the surface of the form anew; a mistake in it keeps the last good one. @param {{ frame: boolean, direction?: readonly number[] }} options */
function updateSurface({ frame, direction }) {
  state.problem = findBadBound(state.kind, state.texts);
  if (state.problem) return render();
  try {
    const built = buildSurface(surfpath, definitionOf(state.kind, state.texts, state.parameters));
    state.built?.surface.dispose();
    state.built = built;
    state.shown = state.texts;
  } catch (error) {
    state.problem = problemOf(error, state.kind, state.texts);
    return render();
  }
  const outgrown = view?.setSurface(state.built.mesh);
  if (findBadEnd(state.built, state.ends)) chooseRandomEnds();
  else updatePath(true);
  if (state.solved.path?.status === 'off-surface') chooseRandomEnds();
  if (frame || outgrown) view?.frame(middle(), direction);
}

/** The middle of the path. */
function middle() {
  const points = state.solved.path?.points;
  return points && points.length > 0 ? points.subarray(3 * Math.floor(points.length / 6)) : null;
}

/** Takes a surface from the gallery, or a first formula to change. @param {string} name of the gallery, or own- and a kind */
export function choose(name) {
  const entry = entries[name];
  state.entry = name;
  state.kind = entry.kind;
  state.parameters = { ...entry.parameters };
  state.texts = state.given = textsOf(entry);
  state.ends = [[...entry.from], [...entry.to]];
  /** @type {HTMLSelectElement} */ (find('entry')).value = name;
  buildSliders(state.parameters);
  buildFields(state.kind, state.texts);
  buildEnds(state.kind, state.ends);
  updateSurface({ frame: true, direction: entry.camera });
}

export function chooseRandomEnds() {
  if (!state.built) return;
  state.ends = chooseEnds(state.built);
  buildEnds(state.kind, state.ends);
  updatePath(true);
}

/** @param {Texts} texts */
export function changeFormula(texts) {
  state.texts = texts;
  updateSurface({ frame: false });
}

/** @param {string} name @param {number} value */
export function changeParameter(name, value) {
  state.parameters[name] = value;
  if (!state.built || state.problem) return updateSurface({ frame: false });
  try {
    state.built.surface.set({ [name]: value });
    state.built.mesh = meshOf(state.built.surface, state.built.kind);
    view?.setSurface(state.built.mesh);
  } catch (error) {
    state.problem = problemOf(error, state.kind, state.texts);
  }
  updatePath(false);
}

/** @param {number[][]} ends */
export function changeEnds(ends) {
  state.ends = ends;
  updatePath(false);
}

/** @param {Partial<import('./compute.js').Options>} options */
export function changeOptions(options) {
  Object.assign(state.options, options);
  updatePath(options.points === undefined);
}

export function play() {
  player.play(state.solved.frames.length - 1);
}

/** @param {number} moment */
export function scrub(moment) {
  player.stop();
  showAt(moment);
}
