/** What stands over the view at points of the surface: the handles of A, B and the points between, which can be dragged and moved by keys, and lengths of other paths. */

import { change } from './change.js';
import { create, find } from './dom.js';
import { pointBeside, pointUnder } from './drag.js';
import { placesOf } from './drawn.js';
import { placeOf } from './ends.js';
import { render, state } from './state.js';
import { formatNumber } from './words.js';

/** @typedef {import('./scene.js').View} View */
/** @typedef {import('./scene.js').Anchor} Anchor */

/** CSS pixels that an arrow key moves a handle; with Shift, more. */
const STEP = 8;
const STRIDE = 40;
/** @type {Record<string, [number, number]>} */
const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

/** @type {HTMLElement[]} */ const handles = [];
/** @type {HTMLElement[]} */ const labels = [];
/** @type {View} */ let view;
/** The handle that a pointer holds, or −1. */
let held = -1;

/** @param {View} scene */
export function startAnchors(scene) {
  view = scene;
}

/** All points that can be moved: A, B, then those between. */
const points = () => [...state.sketch.ends, ...state.sketch.via];

/** @param {number} index @param {number[]} point */
function move(index, point) {
  const { ends, via } = state.sketch;
  if (index < 2) return change({ ends: ends.map((end, i) => (i === index ? point : end)) }, `move ${index}`);
  return change({ via: via.map((one, i) => (i === index - 2 ? point : one)) }, `move ${index}`);
}

const letterOf = (/** @type {number} */ index) => (index < 2 ? 'AB'[index] : String(index - 1));

/** @param {number} index */
function makeHandle(index) {
  const letter = letterOf(index);
  const name = index < 2 ? `End ${letter}` : `Point ${letter} on the way`;
  const button = create('button', { type: 'button', className: 'handle', id: `handle-${letter}` }, create('span', {}, letter));
  button.setAttribute('aria-label', `${name}: drag it, or move it with the arrow keys`);
  button.addEventListener('pointerdown', (event) => {
    if (event.button !== 0) return;
    event.preventDefault();
    button.setPointerCapture(event.pointerId);
    button.focus({ focusVisible: false });
    held = index;
    view.setActive(index, true);
  });
  button.addEventListener('pointermove', (event) => held === index && dragTo(index, event));
  for (const end of ['pointerup', 'pointercancel', 'lostpointercapture']) button.addEventListener(end, () => release(index));
  button.addEventListener('keydown', (event) => press(index, event));
  for (const [type, active] of /** @type {[string, boolean][]} */ ([
    ['pointerenter', true],
    ['pointerleave', false],
    ['focus', true],
    ['blur', false],
  ]))
    button.addEventListener(type, () => held < 0 && view.setActive(index, active));
  return button;
}

/** @param {number} index */
function release(index) {
  if (held !== index) return;
  held = -1;
  view.setActive(index, false);
}

/** @param {number} index @param {PointerEvent} event */
function dragTo(index, { clientX, clientY }) {
  const { drawn, mesh } = state;
  const last = points()[index];
  const place = drawn && placeOf(drawn, last);
  if (!drawn || !mesh || !place) return;
  const { left, top } = view.canvas.getBoundingClientRect();
  move(index, pointUnder(view, drawn, mesh, last, place, clientX - left, clientY - top));
}

/** @param {number} index @param {KeyboardEvent} event */
function press(index, event) {
  if (event.key === 'Delete' && index >= 2) return void change({ via: state.sketch.via.filter((_, i) => i !== index - 2) });
  const arrow = ARROWS[event.key];
  const { drawn } = state;
  const last = points()[index];
  const place = drawn && placeOf(drawn, last);
  if (!arrow || !drawn || !place || event.ctrlKey || event.altKey || event.metaKey) return;
  event.preventDefault();
  const values = drawn.evaluate(last);
  const normal = drawn.kind === 'implicit' ? values.subarray(1, 4) : values.subarray(3, 6);
  const size = Math.hypot(...normal);
  const [right, up] = arrow.map((x) => x * (event.shiftKey ? STRIDE : STEP));
  move(
    index,
    pointBeside(
      view,
      drawn,
      last,
      place,
      Array.from(normal, (x) => x / size),
      right,
      up,
    ),
  );
}

/** Where an end is drawn: where the path ends, or, without one, where it was asked. @param {number[]} point @param {number} index */
function placeOfHandle(point, index) {
  const path = state.solved.paths[state.chosen];
  if (index < 2 && path && !state.moving && (index === 0 || state.sketch.task !== 'trace')) {
    const places = placesOf(path);
    if (places.length > 0) return places.slice(index === 0 ? 0 : -3).slice(0, 3);
  }
  return state.drawn ? placeOf(state.drawn, point) : null;
}

/** @param {number} index */
function makeLabel(index) {
  const button = create('button', { type: 'button', className: 'length-label' }, create('span', {}));
  button.addEventListener('click', () => {
    state.chosen = index;
    render();
  });
  return button;
}

/** Keeps as many elements as are needed. @param {HTMLElement[]} list @param {number} count @param {(index: number) => HTMLElement} make */
function resize(list, count, make) {
  while (list.length > count) list.pop()?.remove();
  while (list.length < count) {
    const element = make(list.length);
    list.push(element);
    find('anchors').append(element);
  }
}

/** Puts everything where it belongs. */
export function renderAnchors() {
  const traced = state.sketch.task === 'trace';
  const places = points()
    .slice(0, traced ? 1 : undefined)
    .map(placeOfHandle);
  const shown = state.drawn && places.every((place) => place !== null) ? /** @type {ArrayLike<number>[]} */ (places) : [];
  resize(handles, shown.length, makeHandle);
  const { paths } = state.solved;
  resize(labels, paths.length > 1 ? paths.length : 0, makeLabel);
  /** @type {Anchor[]} */
  const anchors = shown.map((point, i) => ({ element: handles[i], point, away: i < 2 && shown.length > 1 ? 1 - i : i }));
  for (const [i, label] of labels.entries()) {
    const all = placesOf(paths[i]);
    const at = 3 * Math.floor((all.length / 3) * (0.42 + 0.16 * (i / labels.length)));
    /** @type {HTMLElement} */ (label.firstElementChild).textContent = formatNumber(paths[i].length, 4);
    label.setAttribute('aria-pressed', String(i === state.chosen));
    label.setAttribute('aria-label', `Path ${i + 1}, length ${formatNumber(paths[i].length, 6)}`);
    anchors.push({ element: label, point: all.subarray(at, at + 3) });
  }
  view.setAnchors(anchors, shown.length);
}
