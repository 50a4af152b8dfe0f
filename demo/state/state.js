/** The page's one state, and who shows it. What the reader chose is in `sketch`; all else is computed from it. */

import { sketchOf } from './sketch.js';

/** @typedef {import('./sketch.js').Sketch} Sketch */
/** @typedef {import('../compute/tasks.js').Solved} Solved */

export const FIRST = 'parametricTorus';

/** @type {Solved} */
export const UNSOLVED = { paths: [], legs: [], starts: [], films: [], straight: null, straightLength: NaN, milliseconds: NaN };

export const state = {
  sketch: sketchOf(FIRST),
  /** The sketch of the surface that is seen: the last good one. @type {Sketch | null} */
  shown: null,
  /** @type {import('surfpath').Surface | null} */ surface: null,
  /** What is drawn of it: the surface, or the plane of a metric. @type {import('surfpath').Surface | null} */ drawn: null,
  /** The metric that is not that of space, to draw it. @type {import('../compute/gauge.js').Gauge | null} */ gauge: null,
  /** @type {import('../compute/drawable.js').SurfaceMesh | null} */ mesh: null,
  /** What the view shows of it along x, y and z, from and to: not all of a spike. @type {number[][]} */ seen: [],
  /** @type {import('./definition.js').Problem | null} */ problem: null,
  /** @type {import('./ends.js').EndProblem | null} */ endProblem: null,
  /** What the reader is told once: the link that was opened is none, an end had to be moved. @type {string | null} */ note: null,
  solved: UNSOLVED,
  /** Which of the paths is looked at: the sketch's choice, once there are as many. */
  chosen: 0,
  /** How far the iterates have come: 0 the start … 1 the path. */
  moment: 1,
  /** @type {import('../compute/shade.js').Shade | null} */ shade: null,
  /** Why the surface is not coloured as wished. @type {string | null} */ shadeProblem: null,
  /** What is being computed of the surface and its path. @type {import('../compute/solver.js').Work | null} */ live: null,
  /** What else is being computed. @type {import('../compute/solver.js').Work | null} */ long: null,
  /** The surface of the sketch is on its way; the last one is still seen. */
  building: false,
  /** An end or a parameter moves: what is seen is not yet exact. */
  moving: false,
  /** An end has been dragged: who reads this knows that it can be. */
  dragged: false,
};

/** @typedef {typeof state} State */

/** @type {((state: State) => void)[]} */
const renderers = [];

/** @param {(state: State) => void} renderer called after every change */
export const onRender = (renderer) => renderers.push(renderer);

export function render() {
  for (const renderer of renderers) renderer(state);
  wake();
}

/** Whether what is seen is not yet what is asked for. */
export const isBusy = () => state.live !== null || state.building || state.moving;

/** Who waits until it is. @type {(() => void)[]} */
const waiting = [];

function wake() {
  if (!isBusy()) for (const go of waiting.splice(0)) go();
}

/** All that was asked for has been computed. @returns {Promise<void>} */
export const rest = () =>
  new Promise((resolve) => {
    waiting.push(resolve);
    wake();
  });

/** The path that is looked at. */
export const chosenPath = () => state.solved.paths[state.chosen] ?? null;

/** Which of the paths a sketch looks at. @param {Sketch} sketch @param {Solved} solved */
export const choiceOf = ({ chosen }, { paths }) => Math.max(Math.min(chosen, paths.length - 1), 0);

/** Newton steps from the start that is shown to the path that is looked at, each of which can be played; 0: there is nothing to play. */
export const stepsShown = () => (state.chosen > 0 ? 0 : Math.max(0, ...state.solved.films.map((film) => film.length - 1)));
