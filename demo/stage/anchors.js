/** What stands over the view at points of the surface: the handles of A, B and the points between, which can be dragged and moved by keys. */

import { DragHandle } from 'surfpath/three';
import { change, forget } from '../state/change.js';
import { create } from '../panels/dom.js';
import { placesOf } from '../compute/drawn.js';
import { chosenPath, onRender, state } from '../state/state.js';
import { findBadEnd, letterOf, onto } from '../state/ends.js';
import { boxesOver, placeLengths, renderLengths } from './lengths.js';
import { liftNear } from '../state/lifts.js';
import { isInside, overlap } from './place-labels.js';
import { pointsOf, surfaceOf } from '../state/sketch.js';

/** @typedef {import('./scene.js').View} View */

/** Half the width of what marks a handle at its largest, in CSS pixels. */
const MARKER = 11;
/** How far along the path is what its letter keeps away from, in parts of it. */
const BESIDE = 0.12;
/** From that side of its point a letter goes, if something stands there, to the next, by cosine and sine: across the path, or along it. */
const TURNS = [
  [1, 0],
  [0, 1],
  [0, -1],
  [-1, 0],
];

/** Of each point that has a place, by its index. @type {(DragHandle | null)[]} */ const handles = [];
/** What each was put for: an unchanged one is not looked at again. @type {unknown[]} */ let placed = [];
/** What the handles were made for. @type {unknown} */ let surfaceOfHandles = null;
/** @type {unknown} */ let meshOfHandles = null;
/** @type {unknown} */ let themeOfHandles = null;
/** The sketch when a handle was pressed. @type {unknown} */ let grabbed = null;

/** @param {View} view */
export function startAnchors(view) {
  onRender(() => renderHandles(view));
  onRender(() => renderLengths(view));
  view.onDraw = () => placeLengths(view, placeLetters(view));
}

/** A periodic coordinate by whole turns as near as may be to the last one. @param {number[]} point @param {number[]} last */
function unwind(point, last) {
  const domain = state.surface?.domain;
  return domain ? liftNear(domain, point, last) : point;
}

/** @param {number} index @param {number[]} given */
function move(index, given) {
  if (state.building) return;
  state.dragged = true;
  const { ends, via } = state.sketch;
  const point = unwind(given, pointsOf(state.sketch)[index]);
  if (index < 2) change({ ends: ends.map((end, i) => (i === index ? point : end)) }, `move ${index}`);
  else change({ via: via.map((one, i) => (i === index - 2 ? point : one)) }, `move ${index}`);
}

/** @param {View} view @param {import('surfpath').Surface} drawn @param {number} index @param {number[]} point */
function makeHandle(view, drawn, index, point) {
  const letter = letterOf(index);
  const { theme } = view;
  const handle = new DragHandle(drawn, point, {
    camera: view.camera,
    domElement: view.canvas,
    controls: view.controls,
    mesh: view.surface,
    label: index < 2 ? `End ${letter}` : `Point ${letter} on the way`,
    colour: index < 2 ? theme?.path : theme?.via,
    ring: theme?.halo,
    onDrag: (moved) => move(index, moved),
    onDragStart: () => {
      grabbed = state.sketch;
    },
    onChange: () => view.invalidate(),
  });
  handle.element.id = `handle-${letter}`;
  handle.element.append(create('span', { className: 'letter-tag' }, letter));
  listenForEscape(handle.element);
  if (index >= 2)
    handle.element.addEventListener('keydown', ({ key }) => {
      if (key === 'Delete') change({ via: state.sketch.via.filter((_, i) => i !== index - 2) });
    });
  handleBefore(index)?.element.after(handle.element);
  view.add(handle);
  return handle;
}

/** Puts what is dragged back to where it was. @param {HTMLElement} element of a handle */
function listenForEscape(element) {
  let pointer = -1;
  element.addEventListener('pointerdown', ({ pointerId }) => {
    pointer = pointerId;
  });
  element.addEventListener('keydown', (event) => {
    if (event.key !== 'Escape' || !element.hasPointerCapture(pointer)) return;
    event.stopPropagation();
    // A drag is one change.
    if (state.sketch !== grabbed) forget();
    element.releasePointerCapture(pointer);
    element.blur();
  });
  // The ring of the focus is for keys.
  element.addEventListener('lostpointercapture', ({ pointerType }) => pointerType === 'touch' && element.blur());
}

/** The handle that comes before another one on the way from A to B: the tab key follows it. @param {number} index */
function handleBefore(index) {
  const before = index === 1 ? handles.slice(2) : handles.slice(2, Math.max(index, 2));
  return (index === 0 ? [] : [handles[0], ...before]).filter((handle) => handle).at(-1);
}

/** A handle for each point that has a place: none for what is half written, or outside. @param {View} view */
function renderHandles(view) {
  const { drawn, mesh, building } = state;
  // The sketch's points belong to a surface that is not here yet.
  if (building) return;
  const wanted = drawn && mesh && state.shown?.entry === state.sketch.entry ? pointsOf(state.sketch) : [];
  while (handles.length > wanted.length) handles.pop()?.dispose();
  if (!drawn || !state.shown) return;
  if (themeOfHandles !== view.theme) colourHandles(view);
  const isNew = surfaceOfHandles !== drawn || meshOfHandles !== mesh;
  [surfaceOfHandles, meshOfHandles] = [drawn, mesh];
  const definition = surfaceOf(state.shown);
  for (const [i, point] of wanted.entries()) {
    if (!isNew && placed[i] === point) continue;
    const handle = handles[i];
    const place = findBadEnd(state.sketch.kind, drawn, [point]) ? null : onto(drawn, definition, point);
    if (!place) {
      handle?.dispose();
      handles[i] = null;
    } else if (!handle) handles[i] = makeHandle(view, drawn, i, place);
    else if (isNew) handle.setSurface(drawn, place, view.surface);
    else if (handle.point.some((x, k) => x !== point[k])) handle.setPoint(place);
  }
  placed = wanted;
}

/** @param {View} view */
function colourHandles({ theme }) {
  themeOfHandles = theme;
  for (const [i, handle] of handles.entries()) handle?.setColours({ colour: i < 2 ? theme?.path : theme?.via, ring: theme?.halo });
}

/** Where the path runs near one of its ends; null: there is none. @param {number} end */
function alongPath(end) {
  const path = end < 2 ? chosenPath() : null;
  const places = path ? placesOf(path) : [];
  const last = places.length / 3 - 1;
  const away = Math.max(Math.floor(BESIDE * last), 1);
  const at = 3 * (end === 0 ? away : last - away);
  return places.length > 3 ? [places[at], places[at + 1], places[at + 2]] : null;
}

/** A box about a place. @param {number} x @param {number} y @param {number} across half its width @param {number} [down] half its height */
const boxAt = (x, y, across, down = across) => ({ left: x - across, top: y - down, right: x + across, bottom: y + down });

/** A letter stands on the side where the path does not run, as near as it can without covering its point, if nothing stands there, nor the points and letters before it. @param {View} view @returns what is covered by handles, letters and all else */
function placeLetters(view) {
  const covered = boxesOver(view);
  const { width: right, height: bottom } = view.size;
  const isFree = (/** @type {import('./place-labels.js').Box} */ box) =>
    isInside(box, { left: 0, top: 0, right, bottom }) && !covered.some((other) => overlap(box, other));
  const letters = handles.flatMap((handle, i) => {
    if (!handle) return [];
    const letter = /** @type {HTMLElement} */ (handle.element.lastElementChild);
    return [{ i, handle, letter, half: [letter.offsetWidth / 2, letter.offsetHeight / 2] }];
  });
  for (const { i, handle, letter, half } of letters) {
    const [x, y] = view.toScreen(handle.position.toArray());
    const beside = alongPath(i);
    const [ox, oy] = beside ? view.toScreen(beside) : [x, y];
    const gap = Math.hypot(x - ox, y - oy);
    // Where the path is a point, too: over its end, or under it, as the other letter is over it.
    const [aside, below] = gap < 1 ? [0, i === 1 ? 1 : -1] : [(x - ox) / gap, (y - oy) / gap];
    const places = TURNS.map(([cos, sin]) => {
      const [across, down] = [cos * aside - sin * below, sin * aside + cos * below];
      const far = MARKER + Math.abs(across) * half[0] + Math.abs(down) * half[1];
      return [far * across, far * down];
    });
    const boxOf = (/** @type {number[]} */ [across, down]) => boxAt(x + across, y + down, half[0], half[1]);
    const place = places.find((one) => isFree(boxOf(one))) ?? places[0];
    letter.style.transform = `translate(${place[0].toFixed(1)}px, ${place[1].toFixed(1)}px)`;
    covered.push(boxAt(x, y, MARKER), boxOf(place));
  }
  return covered;
}
