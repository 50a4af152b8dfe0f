/** The strip of results, the player and the legend: numbers and words of what is seen. */

import { mayLeap, unbroken } from '../compute/curves.js';
import { find } from './dom.js';
import { isOnSurface, nameOf } from '../state/ends.js';
import { pointsOf, surfaceOf } from '../state/sketch.js';
import { chosenPath, isBusy, stepsShown, onRender } from '../state/state.js';
import { describeStatus, describeWork, formatEstimate, formatEstimateOf, formatNumber, formatTime, formatTo } from './words.js';

/** Said of a surface whose formula is not the one that is written. */
const OLD = ['Last good surface', 'What is written now could not be drawn; the reason stands beside it.'];
const OF_ERROR = 'Estimated difference to the length of the smooth shortest path';

export function startResult() {
  onRender(renderResult);
  onRender(renderMoment);
}

/** Parts of the path's length: a straight line that is shorter has left the surface, and its chords are no length on it. */
const LEAST_SHARE = 0.998;
/** From here on by how much something is longer is better seen from the lengths. */
const MOST_SHARE = 1000;

/** What is computed takes so long that what is seen must not pass for the answer. */
let isWaiting = false;

/** @param {string} id @param {string} text */
function write(id, text) {
  const element = find(id);
  if (element.textContent !== text) element.textContent = text;
}

/** @param {number} length @param {number} start */
function describeStart(length, start) {
  const share = Math.round(100 * (start / length - 1));
  const longer = share > 0 && share < MOST_SHARE ? ` (+${share} %)` : '';
  return `${formatNumber(start, 4)}${longer}`;
}

/** The statuses of a path one point of which may not lie on the surface. */
const OFF = ['off-surface', 'singular-metric'];

/** @param {import('../state/state.js').State} state */
function renderResult(state) {
  const { sketch, shown, solved, problem, endProblem, note, live, moving, building, surface, gauge } = state;
  const path = chosenPath();
  const exists = path !== null && Number.isFinite(path.length);
  const busy = live !== null || building;
  document.documentElement.toggleAttribute('data-busy', isBusy());
  find('result').setAttribute('aria-busy', String(busy));
  // All digits, for those who read the page by program.
  find('length').dataset.exact = exists ? String(path.length) : '';
  write('length', exists ? formatTo(path.length, path.lengthError) : '–');
  const isKnown = exists && !moving && path.lengthError < path.length;
  write('length-error', isKnown ? formatEstimateOf(path.length, path.lengthError) : '');
  find('length-error').title = isKnown ? `${OF_ERROR}: ${formatEstimate(path.lengthError)}` : OF_ERROR;
  if (!moving) {
    const hasStart = solved.straightLength >= LEAST_SHARE * (path?.length || 0) && !gauge && !shown?.density;
    find('start-figure').hidden = !hasStart && !busy;
    write('start-length', hasStart ? describeStart(path?.length ?? NaN, solved.straightLength) : '–');
    write('steps-caption', sketch.task === 'trace' ? 'Steps' : 'Newton steps');
    write('iterations', exists ? String(stepsShown() || path.iterations) : '–');
    write('time', exists && Number.isFinite(solved.milliseconds) ? formatTime(solved.milliseconds) : '–');
  } else write('start-length', '–');
  // Of several tasks in a row each begins as a quick one.
  isWaiting = busy && !problem && (isWaiting || live?.isSlow === true);
  find('result').toggleAttribute('data-waiting', isWaiting);
  if (isWaiting) return renderWaiting(building, sketch);
  if (busy && !problem && (!surface || !path)) return;
  const isOld = path !== null && problem !== null;
  const [words, advice] = isOld ? OLD : path ? describePath(path, state) : ['No path', (problem ?? endProblem)?.message ?? ''];
  write('status', words);
  // What the reader must know of the ends stands before what to do, which a path that is one leaves out.
  write('advice', note && (isOld || path?.converged) ? note : [note, advice].filter(Boolean).join(' '));
  find('status').toggleAttribute('data-old', isOld);
  if (!moving) find('status').dataset.status = path?.status ?? 'none';
}

/** @param {import('surfpath').Path} path @param {import('../state/state.js').State} state */
function describePath(path, { sketch, moving, building, drawn, shown }) {
  // In the middle of a sphere no way leads to it: to the solver that is a tip. Ends of a surface that is on its way are none of the one that is seen.
  const mayBeOff = OFF.includes(path.status) && !building && drawn && shown;
  const off = mayBeOff ? pointsOf(sketch).findIndex((point) => !isOnSurface(drawn, surfaceOf(shown), point)) : -1;
  if (off >= 0) return ['No path', `${nameOf(off)} lies too far from the surface: move it nearer.`];
  return describeStatus(path.status, sketch, { isFollowed: moving, leaps: leaps(path, sketch) });
}

/** Whether a path leaps over what is no surface. @param {import('surfpath').Path} path @param {import('../state/sketch.js').Sketch} sketch */
const leaps = (path, sketch) => mayLeap(path, sketch) && unbroken(path.points).length > 1;

/** @param {boolean} building the surface is not there yet @param {import('../state/sketch.js').Sketch} sketch */
function renderWaiting(building, sketch) {
  write('status', describeWork(building, sketch));
  write('advice', '');
  delete find('status').dataset.status;
}

/** @param {import('../state/state.js').State} state */
function renderMoment({ moment, moving, building, live }) {
  const last = stepsShown();
  const slider = /** @type {HTMLInputElement} */ (find('moment'));
  const some = last > 0;
  slider.max = String(Math.max(last, 1));
  slider.valueAsNumber = some ? moment * last : 1;
  slider.disabled = !some;
  /** @type {HTMLButtonElement} */ (find('play')).disabled = !some;
  // What has no iterates needs no player; while something moves, it stays where it is.
  if (some || !(moving || building || live)) find('player').hidden = !some;
  const words = some ? `Newton step ${Math.round(moment * last)} of ${last}` : '';
  slider.setAttribute('aria-valuetext', words);
  write('moment-words', words);
}
