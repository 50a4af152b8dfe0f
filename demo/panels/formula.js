/** The formula card: the kind, its fields, the typeset form, and a mistake shown at the place where it is. */

import { change, chooseKind } from '../state/change.js';
import { coordinates, fieldNames, sidesOf, textsOf } from '../state/definition.js';
import { create, find, say } from './dom.js';
import { ENTRIES } from '../state/entries.js';
import { KINDS } from '../state/kinds.js';
import { breakable, joined, math, typeset } from './mathml.js';
import { onRender, state } from '../state/state.js';

/** @typedef {import('../state/definition.js').Problem} Problem */

/** Characters of a formula that are shown around a mistake. */
const EXCERPT = 36;
/** Characters of a line of a field, and lines at most. */
const [CHARACTERS, MOST_LINES] = [34, 7];
/** Milliseconds without a keystroke before a formula is compiled. */
const PATIENCE = 150;
const UNKNOWN = /^Unknown name (\S+?)(?=[;,.]?(?:\s|$))/u;

/** Whether the reader is writing formulas that have not been taken. */
let isWriting = () => false;
/** What the fields were built for. */
let built = '';
/** @type {unknown} */ let typesetFor = null;

export function startFormula() {
  const labels = Object.entries(KINDS).map(([kind, { title, hint }]) => {
    const input = create('input', { type: 'radio', name: 'kind', value: kind });
    input.addEventListener('change', () => chooseKind(/** @type {import('../state/kinds.js').Kind} */ (kind)));
    return create('label', { title: hint }, input, create('span', {}, title));
  });
  find('kinds').replaceChildren(...labels);
  isWriting = takeFrom(
    find('fields'),
    () => state.sketch.texts,
    () => change({ texts: readFields() }, 'texts'),
  );
  find('fields').addEventListener('keydown', (event) => {
    if (event.key === 'Enter') event.preventDefault();
  });
  onRender(renderFormula);
}

/**
 * Takes what is written in fields once it rests, unless something else has been opened meanwhile.
 * @param {HTMLElement} fields @param {() => unknown} subject what is written about: another one, as soon as anything else changes it @param {() => void} take
 * @returns {() => boolean} whether not all that was written has been taken
 */
export function takeFrom(fields, subject, take) {
  let timer = 0;
  /** @type {unknown} */ let written = null;
  const isWritten = () => written === subject();
  const finish = () => {
    clearTimeout(timer);
    const isOurs = isWritten();
    written = null;
    if (isOurs) take();
  };
  fields.addEventListener('input', () => {
    clearTimeout(timer);
    written = subject();
    timer = window.setTimeout(finish, PATIENCE);
  });
  // Who leaves a field in a hurry has written all the same.
  fields.addEventListener('change', finish);
  return isWritten;
}

const readFields = () =>
  Object.fromEntries(fieldNames(state.sketch.kind).map((name) => [name, /** @type {HTMLInputElement} */ (find(`field-${name}`)).value]));

/** Where fields do not grow with what is in them, they are given so many lines. @param {HTMLTextAreaElement} input */
function grow(input) {
  if (!CSS.supports('field-sizing', 'content')) input.rows = Math.min(Math.ceil(input.value.length / CHARACTERS) || 1, MOST_LINES);
}

/** A field for a formula, with a place for what is wrong with it. @param {string} name @param {string} label @param {string} value */
export function formulaField(name, label, value) {
  const input = create('textarea', {
    id: `field-${name}`,
    name: `field-${name}`,
    rows: 1,
    value,
    spellcheck: false,
    autocapitalize: 'off',
    // The style sheet knows an empty one by it.
    placeholder: ' ',
  });
  input.setAttribute('aria-describedby', `problem-${name}`);
  input.addEventListener('input', () => grow(input));
  grow(input);
  const problem = create('div', { id: `problem-${name}`, className: 'problem', hidden: true });
  return create('div', { className: 'formula' }, create('label', { htmlFor: input.id }, label), input, problem);
}

/** @param {string} name @param {import('../state/definition.js').Texts} texts */
function rangeFields(name, texts) {
  const ends = ['from', 'to'].map((end) => {
    const field = `${name}-${end}`;
    const input = create('input', { id: `field-${field}`, name: `field-${field}`, value: texts[field], spellcheck: false });
    input.setAttribute('aria-label', `${name} ${end}`);
    input.setAttribute('aria-describedby', `problem-${field}`);
    return input;
  });
  const problems = ['from', 'to'].map((end) => create('div', { id: `problem-${name}-${end}`, className: 'problem', hidden: true }));
  return create(
    'div',
    { className: 'range' },
    create('span', { className: 'variable' }, name),
    'from',
    ends[0],
    'to',
    ends[1],
    ...problems,
  );
}

/** @param {import('../state/state.js').State} state */
function renderFormula({ sketch, shown, problem }) {
  const { kind, texts } = sketch;
  if (built !== kind) {
    built = kind;
    find('fields').replaceChildren(
      ...Object.entries(KINDS[kind].formulas).map(([name, label]) => formulaField(name, label, texts[name])),
      ...KINDS[kind].ranges.map((name) => rangeFields(name, texts)),
    );
    for (const input of /** @type {NodeListOf<HTMLInputElement>} */ (document.querySelectorAll('input[name=kind]')))
      input.checked = input.value === kind;
  }
  // What the reader is writing is not written over, unless something else is opened.
  for (const name of fieldNames(kind)) {
    const input = /** @type {HTMLInputElement | HTMLTextAreaElement} */ (find(`field-${name}`));
    if (isWriting() || input.value === texts[name]) continue;
    input.value = texts[name];
    if (input instanceof HTMLTextAreaElement) grow(input);
  }
  showProblem(problem);
  if (shown && shown !== typesetFor) renderTypeset(shown);
  find('typeset').toggleAttribute('data-old', problem !== null && shown?.texts !== texts);
}

/** @param {import('../state/sketch.js').Sketch} shown */
function renderTypeset(shown) {
  typesetFor = shown;
  const { kind, texts, parameters } = shown;
  const names = [...coordinates(kind), 'u', 'v', 's', 't', ...Object.keys(parameters)];
  const rows = Object.entries(KINDS[kind].formulas).map(([name, label]) => {
    const sides = kind === 'implicit' ? [...sidesOf(texts[name]), '0'] : [texts[name]];
    const [left, right] = sides.map((side) => typeset(side, names));
    if (!left || right === null) return null;
    const subject = math('mi', label.replace(/[(,].*$/, ''));
    const [from, to] = right ? [breakable(left), right] : [[[subject]], left];
    const rest = joined([[math('mo', '=')]], breakable(to));
    // Of an equation each side may be long.
    const pieces = (sides[2] ? [...from, ...rest] : joined(from, rest)).map((parts) => math('math', math('mrow', ...parts)));
    return create('div', { className: 'equation' }, ...pieces);
  });
  find('typeset').replaceChildren(...rows.filter((row) => row !== null));
}

/** The formula around a mistake, and a caret under the character. @param {Problem} problem */
function mark({ source, index }) {
  const begin = Math.max(0, Math.min(index - EXCERPT / 2, source.length - EXCERPT));
  const before = begin > 0 ? '…' : '';
  const text = before + source.slice(begin, begin + EXCERPT).replace(/\s/g, ' ') + (begin + EXCERPT < source.length ? '…' : '');
  return create(
    'pre',
    { ariaHidden: 'true' },
    `${text}\n${' '.repeat(before.length + index - begin)}`,
    create('span', { className: 'caret' }, '^'),
  );
}

/** An unknown name can become a slider. @param {Problem} problem */
function offer({ message }) {
  const name = UNKNOWN.exec(message)?.[1];
  if (!name || message.includes('; write ')) return [];
  const button = create('button', { type: 'button', className: 'offer' }, `Make ${name} a slider`);
  button.addEventListener('click', () => change({ parameters: { ...state.sketch.parameters, [name]: 1 } }, `slider ${name}`));
  return [button];
}

/** @type {Problem | null} */ let problemShown = null;

/** Shows a mistake in a formula under its field, or takes it away. @param {Problem | null} problem */
function showProblem(problem) {
  if (problem === problemShown) return;
  problemShown = problem;
  const form = find('form');
  for (const element of form.querySelectorAll('.formula .problem, .range .problem')) say(/** @type {HTMLElement} */ (element), null);
  for (const input of form.querySelectorAll('.formula [aria-invalid], .range [aria-invalid]')) input.removeAttribute('aria-invalid');
  const field = problem?.field && document.getElementById(`field-${problem.field}`) ? problem.field : null;
  say(find('formula-problem'), problem && !field ? problem.message : null);
  if (problem && !field) reveal(find('formula-problem'));
  if (!problem || !field) return;
  find(`field-${field}`).setAttribute('aria-invalid', 'true');
  const place = find(`problem-${field}`);
  place.hidden = false;
  place.closest('details')?.setAttribute('open', '');
  place.replaceChildren(...(problem.source ? [mark(problem)] : []), create('p', { role: 'alert' }, problem.message), ...offer(problem));
  reveal(place);
}

/** Scrolls to what is wrong, where the reader is writing it: on a phone it would stand below the edge. @param {HTMLElement} place */
function reveal(place) {
  if (place.parentElement?.contains(document.activeElement)) place.scrollIntoView({ block: 'nearest' });
}

/** Whether the surface is still the entry's, so that the entry's words speak of it. */
export function isGiven() {
  const { shown } = state;
  const entry = shown && ENTRIES[shown.entry];
  return Boolean(entry && shown.kind === entry.kind && JSON.stringify(shown.texts) === JSON.stringify(textsOf(entry)));
}
