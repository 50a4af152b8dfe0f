/** The cards of the path: what to compute and how, the ends as numbers, and the list of all geodesics. */

import { change } from '../state/change.js';
import { coordinates } from '../state/definition.js';
import { create, find, say } from './dom.js';
import { numberIn } from '../compute/flow.js';
import { runsOf } from '../compute/legs.js';
import { chooseEnds, letterOf, onto, radiusOf, rangesOf, shorten } from '../state/ends.js';
import { MOST_POINTS, MOST_VIA, pointsOf, surfaceOf } from '../state/sketch.js';
import { chosenPath, onRender, rest, state } from '../state/state.js';
import { formatLonger, formatNumber } from './words.js';

/** @typedef {import('../state/state.js').State} State */

const LISTED = /** @type {const} */ (['algorithm', 'start']);
/** What the number inputs were built for. */
let built = '';
/** The points as the inputs have them, and what they were found for: an implicit surface has one beside what was written. */
const written = /** @type {{ point: number[], shown: unknown, place: number[] }[]} */ ([]);

export function startPathCard() {
  for (const name of LISTED) find(name).addEventListener('change', (event) => change({ [name]: choiceOf(event) }));
  find('tolerance').addEventListener('change', (event) => change({ tolerance: Number(choiceOf(event)) }));
  find('points').addEventListener('input', changePoints);
  find('tasks').addEventListener('change', changeTask);
  for (const name of /** @type {const} */ (['angle', 'reach']))
    find(name).addEventListener('input', ({ target }) => change({ [name]: /** @type {HTMLInputElement} */ (target).valueAsNumber }));
  find('ends').addEventListener('input', ({ target }) => typeEnd(/** @type {HTMLInputElement} */ (target)));
  // Once the focus is where it goes.
  find('ends').addEventListener('focusout', () => setTimeout(() => renderEnds(state)));
  find('random-ends').addEventListener('click', () => {
    if (state.surface && state.mesh)
      change({ ends: chooseEnds(state.surface, state.mesh, state.seen), via: [] }, `random ${performance.now()}`);
  });
  find('swap-ends').addEventListener('click', () =>
    change({ ends: [...state.sketch.ends].reverse(), via: [...state.sketch.via].reverse() }),
  );
  find('add-via').addEventListener('click', () => {
    const { entry } = state.sketch;
    adding = adding.then(rest).then(() => entry === state.sketch.entry && addVia());
  });
  onRender(renderPathCard);
}

const choiceOf = (/** @type {Event} */ { target }) => /** @type {HTMLInputElement} */ (target).value;

/** All geodesics between two ends pass no points on the way; straight ahead it goes as far as the surface is large. @param {Event} event */
function changeTask(event) {
  const task = /** @type {State['sketch']['task']} */ (choiceOf(event));
  const { reach } = state.sketch;
  const unit = unitOf(state);
  const isFar = reach > FARTHEST * unit || reach < unit / 10;
  change({ task, ...(task === 'all' ? { via: [] } : {}), ...(task === 'trace' && isFar ? { reach: USUAL * unit } : {}) });
}

/** How far straight ahead it goes at most, and at first, in powers of ten of the surface's size. */
const [FARTHEST, USUAL] = [40, 6];
/** @type {{ mesh: unknown, unit: number }} */ let measured = { mesh: null, unit: 1 };

/** The power of ten up to the size of what is seen of the surface. @param {Pick<State, 'mesh' | 'seen'>} state */
function unitOf({ mesh, seen }) {
  if (!mesh || mesh === measured.mesh) return measured.unit;
  measured = { mesh, unit: 10 ** Math.floor(Math.log10(radiusOf(mesh, seen) || 1)) };
  return measured.unit;
}

/** @param {Event} event */
function changePoints({ target }) {
  const input = /** @type {HTMLInputElement} */ (target);
  if (checkPoints(input)) change({ points: input.valueAsNumber });
}

/** Whether there may be so many, and says so where not. @param {HTMLInputElement} input */
function checkPoints(input) {
  const points = input.valueAsNumber;
  const good = Number.isInteger(points) && points >= 1 && points <= MOST_POINTS;
  if (good) input.removeAttribute('aria-invalid');
  else input.setAttribute('aria-invalid', 'true');
  say(find('points-problem'), good ? null : `Write a whole number from 1 to ${MOST_POINTS}.`);
  return good;
}

/** What has been written as coordinates, in numbers. @type {Map<string, number>} */
const numbers = new Map();

/** @param {string} text */
function numberOf(text) {
  const number = numbers.get(text) ?? (Number(text) || numberIn(text));
  numbers.set(text, number);
  return number;
}

/** @param {HTMLInputElement} input */
function typeEnd({ name, value }) {
  const [, row, coordinate] = name.split('-').map(Number);
  const { ends, via } = state.sketch;
  const typed = written[row].place.map((x, k) => (k === coordinate ? numberOf(value) : x));
  const replace = (/** @type {number[][]} */ list, /** @type {number} */ at) => list.map((point, i) => (i === at ? typed : point));
  change(row < 2 ? { ends: replace(ends, row) } : { via: replace(via, row - 2) }, `type ${name}`);
}

/** Why no point can be put on the path; null: one can. @param {State} state */
function whyNoVia({ sketch }) {
  if (sketch.via.length >= MOST_VIA) return `A path passes ${MOST_VIA} points at most.`;
  return Number.isFinite(chosenPath()?.length) ? null : 'There is no path to put a point on.';
}

/** Until there is a path through the last point that was added, and of what was changed meanwhile: its legs tell where the next one goes. @type {Promise<unknown>} */
let adding = Promise.resolve();

/** A point in the middle of the longest leg of the path, to be dragged away. */
function addVia() {
  const path = chosenPath();
  const { via, kind } = state.sketch;
  const { legs } = state.solved;
  const dimension = coordinates(kind).length;
  const all = dimension === 2 ? path?.parameters : path?.points;
  const isOfOthers = legs.length !== (via.length && via.length + 1);
  if (whyNoVia(state) || isOfOthers || !path || !all) return;
  const longest = legs.reduce((best, { length }, i) => (length > legs[best].length ? i : best), 0);
  const middle = dimension * middleOf(runsOf(path, legs), legs, longest);
  const point = Array.from(all.slice(middle, middle + dimension));
  const next = [...via.slice(0, longest), point, ...via.slice(longest)];
  change({ via: next, task: 'path', start: 'global' }, `via ${performance.now()}`);
}

/** The point in the middle of a leg. @param {number[]} runs @param {import('../compute/legs.js').Leg[]} legs none: there is one @param {number} leg */
function middleOf(runs, legs, leg) {
  const begin = legs.slice(0, leg).reduce((sum, { segments }) => sum + segments, 0);
  return begin + Math.floor((legs[leg]?.segments ?? runs.length - 1) / 2);
}

/** @param {string[]} names @param {string} letter @param {number} row */
function endRow(names, letter, row) {
  const inputs = names.map((name, i) => {
    // With letters: phones' keys for numbers may have no minus, and no pi.
    const input = create('input', { name: `end-${row}-${i}`, id: `end-${row}-${i}`, spellcheck: false, autocapitalize: 'off' });
    input.setAttribute('aria-label', `${name} of ${letter}`);
    input.setAttribute('aria-describedby', 'ends-problem');
    return create('label', { className: 'coordinate' }, create('span', { className: 'variable' }, name), input);
  });
  const children = [create('strong', { className: 'letter' }, letter), ...inputs];
  if (row < 2) return create('div', { className: 'end' }, ...children);
  const remove = create('button', { type: 'button', className: 'icon small' }, '✕');
  remove.setAttribute('aria-label', `Remove point ${letter}`);
  remove.addEventListener('click', () => change({ via: state.sketch.via.filter((_, i) => i !== row - 2) }, `remove ${performance.now()}`));
  return create('div', { className: 'end' }, ...children, remove);
}

/** @param {State} state */
function renderPathCard(state) {
  const { sketch, endProblem, solved, chosen } = state;
  for (const input of /** @type {NodeListOf<HTMLInputElement>} */ (document.querySelectorAll('input[name=task]')))
    input.checked = input.value === sketch.task;
  for (const name of LISTED) /** @type {HTMLSelectElement} */ (find(name)).value = sketch[name];
  showTolerance(/** @type {HTMLSelectElement} */ (find('tolerance')), sketch.tolerance);
  const points = /** @type {HTMLInputElement} */ (find('points'));
  if (points !== document.activeElement) {
    points.valueAsNumber = sketch.points;
    checkPoints(points);
  }
  find('tolerance-row').hidden = sketch.algorithm !== 'elements';
  for (const id of ['solver-card', 'swap-ends', 'add-via']) find(id).hidden = sketch.task === 'trace';
  find('start-row').hidden = sketch.task === 'all';
  find('trace-rows').hidden = sketch.task !== 'trace';
  if (sketch.task === 'trace')
    /** @type {HTMLInputElement} */ (find('reach')).max = String(Math.max(FARTHEST * unitOf(state), sketch.reach));
  for (const [name, unit] of /** @type {const} */ ([
    ['angle', '°'],
    ['reach', ''],
  ])) {
    const input = /** @type {HTMLInputElement} */ (find(name));
    if (input !== document.activeElement) input.valueAsNumber = sketch[name];
    find(`${name}-value`).textContent = `${Number(sketch[name].toPrecision(3))}${unit}`;
  }
  const several = /** @type {HTMLOptionElement} */ (find('start').querySelector('[value=several]'));
  several.disabled = sketch.via.length > 0;
  several.title = several.disabled ? 'Between A and B alone, without points on the way' : '';
  const reason = whyNoVia(state);
  Object.assign(find('add-via'), { disabled: reason !== null, title: reason ?? '' });
  renderEnds(state);
  for (const input of find('ends').querySelectorAll('[aria-invalid]')) input.removeAttribute('aria-invalid');
  say(find('ends-problem'), endProblem?.message ?? null);
  if (endProblem && endProblem.end >= 0)
    document.getElementById(`end-${endProblem.end}-${endProblem.coordinate}`)?.setAttribute('aria-invalid', 'true');
  renderList(sketch.task === 'all' ? solved.paths.filter(({ length }) => Number.isFinite(length)) : [], chosen);
}

/** A link may hold one that is not in the list. @param {HTMLSelectElement} select @param {number} tolerance */
function showTolerance(select, tolerance) {
  const value = String(tolerance);
  if (![...select.options].some((option) => option.value === value))
    select.append(create('option', { value }, formatNumber(tolerance, 1).replace('1 × ', '')));
  select.value = value;
}

/** A point as its row shows it: on the surface that is seen, unless it is just being written. @param {State} state @param {number} row @param {number[]} point */
function placeOfRow({ drawn, shown, building, sketch }, row, point) {
  const last = written[row];
  const isHere = document.getElementById(`end-${row}-0`)?.closest('.end')?.contains(document.activeElement);
  if (last?.point === point && (isHere || last.shown === shown)) return last.place;
  const isKnown = drawn && shown && !isHere && !building && shown.entry === sketch.entry;
  const place = (isKnown && onto(drawn, surfaceOf(shown), point)) || point;
  written[row] = { point, shown: isKnown ? shown : null, place };
  return place;
}

/** @param {State} state */
function renderEnds(state) {
  const { kind } = state.sketch;
  const points = pointsOf(state.sketch);
  const wanted = `${kind} ${points.length}`;
  if (built !== wanted) {
    built = wanted;
    const rows = points.map((_, row) => endRow(coordinates(kind), letterOf(row), row));
    find('ends').replaceChildren(...rows);
  }
  const { surface, shown } = state;
  const ranges = surface && shown?.kind === kind ? rangesOf(surface, surfaceOf(shown)) : [];
  for (const [row, point] of points.entries()) {
    for (const [i, x] of placeOfRow(state, row, point).entries()) {
      const input = /** @type {HTMLInputElement | null} */ (document.getElementById(`end-${row}-${i}`));
      if (!input) continue;
      // What is being written is the number itself, and stays as it is written.
      if (!Object.is(numberOf(input.value), x)) input.value = Number.isFinite(x) ? shorten(x, ranges[i] ?? [-Infinity, Infinity]) : '';
    }
  }
}

/** @param {import('surfpath').Path[]} paths @param {number} chosen */
function renderList(paths, chosen) {
  const rows = paths.map((path, i) => {
    const button = create('button', { type: 'button' }, create('strong', {}, formatNumber(path.length, 8)));
    if (i > 0) button.append(create('span', { className: 'hint' }, ` ${formatLonger(path.length, paths[0].length)}`));
    button.setAttribute('aria-pressed', String(i === chosen));
    button.addEventListener('click', () => change({ chosen: i }));
    return create('li', {}, button);
  });
  // Only where something is different: a list that is replaced loses the focus.
  const list = find('paths');
  const text = rows.map((row) => row.textContent).join();
  if (list.dataset.rows !== text) {
    list.replaceChildren(...rows);
    list.dataset.rows = text;
  } else for (const [i, row] of [...list.children].entries()) row.firstElementChild?.setAttribute('aria-pressed', String(i === chosen));
}
