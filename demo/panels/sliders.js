/** A slider for each named parameter, and a number beside it for what a slider cannot say. */

import { change } from '../state/change.js';
import { create, find } from './dom.js';
import { onRender, state } from '../state/state.js';

/** What the sliders were built for. */
let built = '';

export function startSliders() {
  find('sliders').addEventListener('input', ({ target }) => {
    const { name, valueAsNumber } = /** @type {HTMLInputElement} */ (target);
    if (!Number.isFinite(valueAsNumber)) return;
    const parameter = name.replace(/^(parameter|value)-/, '');
    change({ parameters: { ...state.sketch.parameters, [parameter]: valueAsNumber } }, `parameter ${parameter}`);
  });
  onRender(renderSliders);
}

/** @param {import('../state/state.js').State} state */
function renderSliders({ sketch: { entry, parameters } }) {
  const names = [entry, ...Object.keys(parameters)].join();
  if (built !== names) {
    built = names;
    find('sliders').replaceChildren(...Object.entries(parameters).map(([name, value]) => slider(name, value)));
  }
  for (const [name, value] of Object.entries(parameters)) {
    for (const field of [`parameter-${name}`, `value-${name}`]) {
      const input = /** @type {HTMLInputElement} */ (find(field));
      if (input !== document.activeElement && input.valueAsNumber !== value) input.value = String(Number(value.toPrecision(6)));
    }
  }
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
  return create('div', { className: 'slider' }, create('label', { htmlFor: input.id, className: 'variable' }, name), input, number);
}
