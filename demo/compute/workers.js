/** The page's two workers: one for the surface and its path, one for what may take long and must not keep the path waiting. */

import { find, say } from '../panels/dom.js';
import { surfaceOf } from '../state/sketch.js';
import { Solver } from './solver.js';
import { onRender, render, state } from '../state/state.js';

/** @type {Record<string, string>} by task */
const WORDS = {
  open: 'Drawing the surface',
  mesh: 'Drawing the surface',
  draft: 'Drawing the surface',
  solve: 'Searching for paths',
  shade: 'Measuring the surface',
  study: 'Measuring paths',
};

export const live = new Solver((work) => {
  state.live = work;
  render();
});

const long = new Solver((work) => {
  state.long = work;
  render();
});

/** About the surface that is seen. @param {string} task @param {any} request @param {(progress: any) => void} [report] */
export const askLong = (task, request, report) =>
  long.ask(task, { definition: surfaceOf(state.shown ?? state.sketch), ...request }, report);

/** What is slow says so over the view, and can be cancelled there. */
export function startProgress() {
  find('cancel').addEventListener('click', () => {
    for (const solver of [live, long]) solver.cancel();
  });
  onRender(renderProgress);
}

/** @param {import('../state/state.js').State} state */
function renderProgress({ live: first, long: second }) {
  // For those who read the page by program: colours and plots are not what they will be.
  document.documentElement.toggleAttribute('data-measuring', second !== null);
  const work = [first, second].find((one) => one?.isSlow);
  find('progress').hidden = !work;
  if (!work) return;
  say(find('progress-words'), WORDS[work.task]);
  const bar = /** @type {HTMLProgressElement} */ (find('progress-bar'));
  if (work.share === null) bar.removeAttribute('value');
  else bar.value = work.share;
}
