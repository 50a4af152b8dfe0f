/** The form: builds its changing parts, reads it, and shows what is wrong at the place where it is wrong. Knows no mathematics. */

import { gallery } from 'surfpath/gallery';
import { coordinates } from './definition.js';
import { create, find, say } from './dom.js';
import { KINDS } from './kinds.js';

/** @typedef {import('./kinds.js').Kind} Kind */
/** @typedef {import('./definition.js').Problem} Problem */
/** @typedef {import('./compute.js').EndProblem} EndProblem */

/** Characters of a formula that are shown around a mistake. */
const EXCERPT = 40;

/** Fills the list of surfaces. @param {HTMLSelectElement} select */
export function fillGallery(select) {
  for (const [kind, { title }] of Object.entries(KINDS)) {
    const entries = Object.entries(gallery).filter(([, entry]) => entry.kind === kind);
    const options = entries.map(([name, entry]) => create('option', { value: name }, entry.title));
    if (options.length > 0) select.append(create('optgroup', { label: title }, ...options));
  }
  const own = Object.entries(KINDS).map(([kind, { title }]) =>
    create('option', { value: `own-${kind}` }, `Your own, ${title.toLowerCase()}`),
  );
  select.append(create('optgroup', { label: 'Formula' }, ...own));
}

/** Fills the choice of kinds. @param {HTMLElement} element */
export function fillKinds(element) {
  const labels = Object.entries(KINDS).map(([kind, { title, hint }]) => {
    const input = create('input', { type: 'radio', name: 'kind', value: kind });
    return create('label', { title: hint }, input, create('span', {}, title));
  });
  element.replaceChildren(...labels);
}

/** @param {string} name @param {string} label @param {string} value */
function formulaField(name, label, value) {
  const input = create('textarea', {
    id: `field-${name}`,
    name: `field-${name}`,
    rows: 1,
    value,
    spellcheck: false,
    autocapitalize: 'off',
  });
  input.setAttribute('aria-describedby', `problem-${name}`);
  const problem = create('div', { id: `problem-${name}`, className: 'problem', hidden: true });
  return create('div', { className: 'formula' }, create('label', { htmlFor: input.id }, label), input, problem);
}

/** @param {string} name @param {import('./definition.js').Texts} texts */
function rangeFields(name, texts) {
  const ends = ['from', 'to'].map((end) => {
    const field = `${name}-${end}`;
    const input = create('input', {
      id: `field-${field}`,
      name: `field-${field}`,
      value: texts[field],
      ariaLabel: `${name} ${end}`,
      spellcheck: false,
    });
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

/** Builds the fields of a kind of surface. @param {Kind} kind @param {import('./definition.js').Texts} texts */
export function buildFields(kind, texts) {
  find('fields').replaceChildren(
    ...Object.entries(KINDS[kind].formulas).map(([name, label]) => formulaField(name, label, texts[name])),
    ...KINDS[kind].ranges.map((name) => rangeFields(name, texts)),
  );
  for (const radio of document.querySelectorAll('input[name=kind]')) {
    const input = /** @type {HTMLInputElement} */ (radio);
    input.checked = input.value === kind;
  }
}

/** Builds the number inputs of A and B. @param {Kind} kind @param {number[][]} ends */
export function buildEnds(kind, ends) {
  const rows = ends.map((point, end) => {
    const letter = 'AB'[end];
    const inputs = coordinates(kind).map((name, i) => {
      const input = create('input', {
        type: 'number',
        step: '0.05',
        name: `end-${end}-${i}`,
        id: `end-${end}-${i}`,
        value: String(Number(point[i].toPrecision(5))),
        ariaLabel: `${name} of ${letter}`,
      });
      input.setAttribute('aria-describedby', 'ends-problem');
      return create('label', { className: 'coordinate' }, create('span', { className: 'variable' }, name), input);
    });
    return create('div', { className: 'end' }, create('strong', {}, letter), ...inputs);
  });
  find('ends').replaceChildren(...rows);
}

/** A slider for each named parameter. @param {Readonly<Record<string, number>>} parameters */
export function buildSliders(parameters) {
  const rows = Object.entries(parameters).map(([name, value]) => {
    const size = Math.abs(value) || 1;
    const step = 10 ** Math.floor(Math.log10(size)) / 100;
    const [min, max] = (value < 0 ? [-2, -0.1] : [0.1, 2]).map((factor) => step * Math.round((factor * size) / step));
    const input = create('input', { type: 'range', name: `parameter-${name}`, id: `parameter-${name}` });
    Object.assign(input, { min: String(min), max: String(max), step: String(step) });
    input.value = String(value);
    const output = create('output', { id: `value-${name}` }, String(value));
    return create('div', { className: 'slider' }, create('label', { htmlFor: input.id, className: 'variable' }, name), input, output);
  });
  find('sliders').replaceChildren(...rows);
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

/** Shows a mistake in the formula under its field, or takes it away. @param {Problem | null} problem */
export function showProblem(problem) {
  for (const element of find('fields').querySelectorAll('.problem')) {
    element.replaceChildren();
    /** @type {HTMLElement} */ (element).hidden = true;
  }
  for (const input of find('fields').querySelectorAll('[aria-invalid]')) input.removeAttribute('aria-invalid');
  say(find('formula-problem'), problem && !problem.field ? problem.message : null);
  if (!problem?.field) return;
  find(`field-${problem.field}`).setAttribute('aria-invalid', 'true');
  const place = find(`problem-${problem.field}`);
  place.hidden = false;
  place.replaceChildren(...(problem.source ? [mark(problem)] : []), create('p', { role: 'alert' }, problem.message));
}

/** @param {EndProblem | null} problem */
export function showEndProblem(problem) {
  for (const input of find('ends').querySelectorAll('[aria-invalid]')) input.removeAttribute('aria-invalid');
  say(find('ends-problem'), problem?.message ?? null);
  if (problem && problem.end >= 0) find(`end-${problem.end}-${problem.coordinate}`).setAttribute('aria-invalid', 'true');
}

/** Text of every formula field. @param {string[]} names @returns {import('./definition.js').Texts} */
export function readFields(names) {
  return Object.fromEntries(names.map((name) => [name, /** @type {HTMLInputElement} */ (find(`field-${name}`)).value]));
}

/** @param {Kind} kind @returns {number[][]} NaN where there is no number */
export function readEnds(kind) {
  return [0, 1].map((end) => coordinates(kind).map((_, i) => /** @type {HTMLInputElement} */ (find(`end-${end}-${i}`)).valueAsNumber));
}
