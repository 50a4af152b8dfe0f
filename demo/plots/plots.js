/** The card of plots: what is plotted of the present path, measured in a worker while it can be seen, and can be cancelled. */

import { sentence } from '../state/definition.js';
import { create, find } from '../panels/dom.js';
import { hoverAlong, onHover, setHover } from '../state/hover.js';
import { plot } from './plot.js';
import { chosenPath, state } from '../state/state.js';
import { askLong } from '../compute/workers.js';

/** @typedef {import('../compute/study.js').Series} Series */
/** @typedef {import('./plot.js').Axis} Axis */

/** @type {Record<string, { across: Axis, up: Axis, words: string }>} */
const PLOTS = {
  convergence: {
    across: { label: 'Newton step' },
    up: { label: '‖∇E‖, norm of the gradient', log: true },
    words: 'From the straight start. A quadratic method doubles the digits each step.',
  },
  error: {
    across: { label: 'points K', log: true },
    up: { label: 'relative error of the length', log: true },
    words: 'K chords against the path that is exact to thirteen digits.',
  },
  time: {
    across: { label: 'points K', zero: true },
    up: { label: 'milliseconds a path', zero: true },
    words: 'Measured now, in this browser, from the straight start.',
  },
  curvature: {
    across: { label: 'length from A', zero: true },
    up: { label: 'curvature', zero: true },
    words: 'How much the path bends in space: a geodesic only as its surface does.',
  },
};

let mine = 0;
/** The plot along the path, if it is the one that is seen. @type {import('./plot.js').Plot | null} */ let along = null;

export function startPlots() {
  find('plot-choice').addEventListener('change', refreshPlot);
  find('plots-card').addEventListener('toggle', refreshPlot);
  find('plot').addEventListener('pointermove', pointAt);
  find('plot').addEventListener('pointerleave', () => along && setHover(null));
  onHover((hover) => along?.guide(hover?.run ?? null));
}

/** The point of the path that a place of its plot is about. @param {PointerEvent} event */
function pointAt({ clientX, clientY }) {
  const path = chosenPath();
  const picture = /** @type {SVGSVGElement | null} */ (find('plot').querySelector('svg'));
  if (!along || !path || !picture) return;
  const { x } = new DOMPoint(clientX, clientY).matrixTransform(picture.getScreenCTM()?.inverse());
  const run = along.valueAt(x);
  setHover(run >= 0 && run <= path.length ? hoverAlong(path, state.solved.legs, run) : null);
}

const choice = () => /** @type {HTMLSelectElement} */ (find('plot-choice')).value;

/** Measures and draws anew, if the card is open. */
export async function refreshPlot() {
  const path = chosenPath();
  if (!(/** @type {HTMLDetailsElement} */ (find('plots-card')).open) || state.moving) return;
  const name = choice();
  const turn = ++mine;
  if (!path || state.sketch.task === 'trace' || state.sketch.via.length > 0 ? name !== 'curvature' : false)
    return explain('This plot is for a path between two ends.');
  if (name === 'curvature' && path?.points.length === 0) return explain('This path has no place in space, and so no curvature there.');
  const { ends, points } = state.sketch;
  const show = (/** @type {{ series: Series[] }} */ { series }) => {
    if (turn === mine) draw(name, series);
  };
  try {
    const series = await askLong('study', { plot: name, ends, path, legs: state.solved.legs, options: { points } }, show);
    if (series && turn === mine) draw(name, series);
  } catch (error) {
    if (turn === mine) explain(sentence(error instanceof Error ? error.message : String(error)));
  }
}

/** @param {string} words */
function explain(words) {
  along = null;
  find('plot').replaceChildren(create('p', { className: 'hint' }, words));
}

/** @param {string} name @param {Series[]} series */
function draw(name, series) {
  const { across, up, words } = PLOTS[name];
  const drawn = plot(series, across, up);
  along = name === 'curvature' ? drawn : null;
  const keys = series.map(({ label }, i) => create('li', { className: `key key-${i}` }, label));
  find('plot').replaceChildren(
    create('p', { className: 'plot-title' }, up.label),
    drawn.root,
    ...(series.length > 1 ? [create('ul', { className: 'keys' }, ...keys)] : []),
    create('p', { className: 'hint' }, words),
  );
}
