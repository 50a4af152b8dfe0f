/** The lengths of all geodesics over the view, each beside its line and tied to it: a press looks at that one. What has no room is in the panel's list. */

import { change } from '../state/change.js';
import { create, find } from '../panels/dom.js';
import { placesOf } from '../compute/drawn.js';
import { placeLabels } from './place-labels.js';
import { state } from '../state/state.js';
import { formatNumber } from '../panels/words.js';

/** @typedef {import('./scene.js').View} View */
/** @typedef {import('./place-labels.js').Box} Box */
/** @typedef {import('./place-labels.js').Place} Place */

/** Of a line, about so many points are looked at. */
const LOOKED_AT = 60;
/** What stands over the view. */
const OVER = '.legend, .scale, .player, .corner, .progress, .notice';

/** @type {HTMLElement[]} */ const labels = [];
/** Width and height of each label. @type {number[][]} */ let sizes = [];
/** @type {(Place | null)[]} */ let places = [];
/** @type {import('surfpath').Path[]} */ let pathsShown = [];

/** @param {number} index */
function makeLabel(index) {
  const button = create('button', { type: 'button', className: 'length-label' }, create('span', {}));
  button.addEventListener('click', () => change({ chosen: index }));
  find('anchors').append(button);
  return button;
}

/** @param {View} view */
export function renderLengths(view) {
  const { paths } = state.solved;
  const count = paths.length > 1 ? paths.length : 0;
  while (labels.length > count) labels.pop()?.remove();
  while (labels.length < count) labels.push(makeLabel(labels.length));
  for (const [i, label] of labels.entries()) {
    const length = formatNumber(paths[i].length, 4);
    /** @type {HTMLElement} */ (label.firstElementChild).textContent = length;
    label.setAttribute('aria-pressed', String(i === state.chosen));
    // With what is seen in it: who speaks to the page says that.
    label.setAttribute('aria-label', `Path ${i + 1}, length ${length}`);
  }
  if (paths !== pathsShown) places = [];
  pathsShown = paths;
  view.invalidate();
}

/** Some points of a path on the screen. @param {View} view @param {import('surfpath').Path} path */
function lineOf(view, path) {
  const all = placesOf(path);
  const last = all.length / 3 - 1;
  const count = Math.min(last, LOOKED_AT);
  return Array.from({ length: count + 1 }, (_, k) => {
    const i = 3 * Math.round((k / count) * last);
    return view.toScreen(all.subarray(i, i + 3));
  });
}

/** Where what stands over the view does, from its corner. @param {View} view @returns {Box[]} */
export function boxesOver({ canvas }) {
  const { left: x, top: y } = canvas.getBoundingClientRect();
  const elements = [...find('view').querySelectorAll(OVER)].filter((element) => element.checkVisibility());
  return elements.map((element) => {
    const { left, top, right, bottom } = element.getBoundingClientRect();
    return { left: left - x, top: top - y, right: right - x, bottom: bottom - y };
  });
}

/** The one that is looked at chooses first, then the one with the focus, then the shortest. */
function ranked() {
  const rank = (/** @type {number} */ i) => (i === state.chosen ? 2 : Number(labels[i] === document.activeElement));
  return labels.map((_, i) => i).sort((a, b) => rank(b) - rank(a) || a - b);
}

/** @param {View} view @param {Box[]} obstacles what is covered by anything else */
export function placeLengths(view, obstacles) {
  if (labels.length === 0) return;
  // All is measured before anything is moved: the browser lays the page out once.
  const { width, height } = view.size;
  sizes = labels.map(({ firstElementChild: text, hidden }, i) =>
    hidden && sizes[i] ? sizes[i] : [/** @type {HTMLElement} */ (text).offsetWidth, /** @type {HTMLElement} */ (text).offsetHeight],
  );
  const order = ranked();
  const wanted = order.map((i) => ({ line: lineOf(view, pathsShown[i]), size: sizes[i], last: places[i] }));
  const found = placeLabels(wanted, obstacles, { left: 2, top: 2, right: width - 2, bottom: height - 2 });
  for (const [k, i] of order.entries()) {
    const place = found[k];
    places[i] = place;
    labels[i].hidden = !place;
    if (!place) continue;
    labels[i].dataset.side = place.side;
    labels[i].style.transform = `translate(${place.x.toFixed(1)}px, ${place.y.toFixed(1)}px)`;
  }
}
