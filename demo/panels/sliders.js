/** A slider for each named parameter, and a number beside it for what a slider cannot say. */

import { change } from '../state/change.js';
import { brief } from '../state/definition.js';
import { create, find, say } from './dom.js';
import { namesIn } from '../state/sketch.js';
import { onRender, state } from '../state/state.js';

/** What the sliders were built for. */
let built = '';

export function startSliders() {
  find('sliders').addEventListener('input', ({ target }) => {
    const { name, valueAsNumber } = /** @type {HTMLInputElement} */ (target);
    const parameter = parameterOf(name);
    const good = Number.isFinite(valueAsNumber);
    say(find('sliders-problem'), good ? null : `Write a number for ${parameter}.`);
    if (good) change({ parameters: { ...state.sketch.parameters, [parameter]: valueAsNumber } }, `parameter ${parameter}`);
  });
  // Who leaves a number empty gets it back.
  find('sliders').addEventListener('change', ({ target }) => {
    const input = /** @type {HTMLInputElement} */ (target);
    if (!Number.isFinite(input.valueAsNumber)) input.value = brief(state.sketch.parameters[parameterOf(input.name)]);
    say(find('sliders-problem'), null);
  });
  find('sliders').addEventListener('click', ({ target }) => {
    const name = /** @type {HTMLElement} */ (target).dataset.remove;
    if (name) change({ parameters: without(state.sketch.parameters, name) }, `remove ${name}`);
  });
  onRender(renderSliders);
}

/** @param {string} name of an input */
const parameterOf = (name) => name.replace(/^(parameter|value)-/, '');

/** @param {Record<string, number>} parameters @param {string} name */
const without = (parameters, name) => Object.fromEntries(Object.entries(parameters).filter(([other]) => other !== name));

/** @param {import('../state/state.js').State} state */
function renderSliders({ sketch }) {
  const { entry, parameters } = sketch;
  const names = [entry, ...Object.keys(parameters)].join();
  if (built !== names) {
    built = names;
    find('sliders').replaceChildren(...Object.entries(parameters).map(([name, value]) => slider(name, value)));
  }
  const used = namesIn(sketch);
  for (const [name, value] of Object.entries(parameters)) {
    find(`remove-${name}`).hidden = used.has(name);
    widen(/** @type {HTMLInputElement} */ (find(`parameter-${name}`)), value);
    for (const field of [`parameter-${name}`, `value-${name}`]) {
      const input = /** @type {HTMLInputElement} */ (find(field));
      if (input !== document.activeElement && input.valueAsNumber !== value) input.value = brief(value);
    }
  }
}

/** A slider reaches as far as the number beside it, in whole steps. @param {HTMLInputElement} input @param {number} value */
function widen(input, value) {
  const [min, max, step] = [input.min, input.max, input.step].map(Number);
  if (value < min) input.min = String(min - step * Math.ceil((min - value) / step));
  if (value > max) input.max = String(max + step * Math.ceil((value - max) / step));
}

/** @param {string} name @param {number} value */
function slider(name, value) {
  const size = Math.abs(value) || 1;
  const step = 10 ** Math.floor(Math.log10(size)) / 100;
  const [min, max] = (value < 0 ? [-2, -0.1] : [0.1, 2]).map((factor) => String(step * Math.round((factor * size) / step)));
  const input = create('input', { type: 'range', name: `parameter-${name}`, id: `parameter-${name}` });
  Object.assign(input, { min, max, step: String(step) });
  input.value = String(value);
  const number = create('input', { type: 'number', name: `value-${name}`, id: `value-${name}`, step: 'any', value: String(value) });
  number.setAttribute('aria-label', `${name}, as a number`);
  const remove = create('button', { type: 'button', className: 'icon small', id: `remove-${name}`, title: 'No formula has it' }, '✕');
  remove.dataset.remove = name;
  remove.setAttribute('aria-label', `Remove ${name}`);
  return create('div', { className: 'slider' }, create('label', { htmlFor: input.id, className: 'variable' }, name), input, number, remove);
}
