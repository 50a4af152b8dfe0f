/** The strip of results and the player: numbers and words of a solved path. */

import { lengthOf } from './curves.js';
import { find, say } from './dom.js';
import { describeStatus, formatEstimate, formatNumber, formatTime, formatTo } from './words.js';

/** @typedef {import('surfpath').Path} Path */

/** @param {HTMLElement} element @param {string} text */
const write = (element, text) => {
  if (element.textContent !== text) element.textContent = text;
};

/** @param {number} length @param {number} start */
function describeStart(length, start) {
  const share = Math.round(100 * (start / length - 1));
  const longer = Number.isFinite(share) && share > 0 ? ` (+${share} %)` : '';
  return `${formatNumber(start, 4)}${longer}`;
}

/**
 * @param {{ path: Path | null, milliseconds: number, straight: Float64Array | null, start: 'global' | 'straight',
 *   problem: import('./definition.js').Problem | null }} shown
 */
export function showResult({ path, milliseconds, straight, start, problem }) {
  const exists = path !== null && Number.isFinite(path.length);
  write(find('length'), exists ? formatTo(path.length, path.lengthError) : '–');
  write(find('length-error'), exists ? formatEstimate(path.lengthError) : '');
  write(find('start-length'), straight ? describeStart(path?.length ?? NaN, lengthOf(straight)) : '–');
  write(find('iterations'), path ? String(path.iterations) : '–');
  write(find('time'), Number.isFinite(milliseconds) ? formatTime(milliseconds) : '–');
  const [words, advice] = path ? describeStatus(path.status, start) : ['No path', 'See the message at the end points.'];
  write(find('status'), words);
  write(find('advice'), problem ? `${advice} (The last good surface is shown.)` : advice);
  find('status').dataset.status = path?.status ?? 'none';
}

/** @param {number} moment @param {number} last number of the last iterate */
export function showMoment(moment, last) {
  const slider = /** @type {HTMLInputElement} */ (find('moment'));
  const some = last > 0;
  slider.max = String(Math.max(last, 1));
  slider.valueAsNumber = some ? moment : 1;
  slider.disabled = !some;
  /** @type {HTMLButtonElement} */ (find('play')).disabled = !some;
  const words = some ? `Iteration ${Math.round(moment)} of ${last}` : 'Path alone';
  slider.setAttribute('aria-valuetext', words);
  say(find('moment-words'), words);
}
