/** The card of what measures length: a density, a metric in place of that of space, and examples fitted to any surface. */

import { change } from '../state/change.js';
import { create, find, say } from './dom.js';
import { formulaField, takeFrom } from './formula.js';
import { tensorNames } from '../state/kinds.js';
import { PRESETS } from '../state/presets.js';
import { onRender, state } from '../state/state.js';

/** Entries off the diagonal, which are 0 where nothing is written. */
const MIXED = ['xy', 'xz', 'yz'];

/** Whether the reader is writing formulas that have not been taken. */
let isWriting = () => false;
/** What the fields were built for. */
let built = '';

export function startMeasure() {
  find('measure-presets').addEventListener('click', ({ target }) => {
    const preset = /** @type {HTMLElement} */ (target).dataset.preset;
    if (preset) change(PRESETS[preset](), `preset ${preset}`, true);
  });
  isWriting = takeFrom(find('measure-fields'), token, takeFields);
  onRender(renderMeasure);
}

/** @param {string} name @returns {HTMLInputElement | null} */
const field = (name) => /** @type {HTMLInputElement | null} */ (document.getElementById(`field-${name}`));

const textOf = (/** @type {string} */ name) => field(name)?.value ?? '';

function token() {
  const { entry, kind, density, tensor } = state.sketch;
  return JSON.stringify([entry, kind, density, tensor]);
}

/** Whether length is measured otherwise than by space. @param {{ density: string, tensor: string[] }} measure */
const hasMeasure = ({ density, tensor }) => density.trim() !== '' || tensor.length > 0;

function takeFields() {
  const names = tensorNames(state.sketch.kind);
  const texts = names.map((name) => textOf(`metric.${name}`));
  const some = texts.some((text) => text.trim());
  const tensor = some ? texts.map((text, i) => (text.trim() ? text : MIXED.includes(names[i]) ? '0' : '')) : [];
  const density = textOf('density');
  const { colour } = state.sketch;
  const [had, has] = [hasMeasure(state.sketch), hasMeasure({ density, tensor })];
  // A new measure is shown, one that is gone is not; what the reader chose meanwhile stays.
  if (!had && has && colour === 'plain') return change({ density, tensor, colour: 'density' }, 'measure');
  if (had && !has && colour === 'density') return change({ density, tensor, colour: 'plain' }, 'measure');
  return change({ density, tensor }, 'measure');
}

/** @param {import('../state/state.js').State} state */
function renderMeasure({ sketch, problem }) {
  const { kind, density, tensor } = sketch;
  find('measure-card').hidden = kind === 'metric';
  find('measure-presets')
    .querySelector('[data-preset=climb]')
    ?.toggleAttribute('hidden', kind !== 'implicit');
  const names = tensorNames(kind);
  if (built !== names.join()) {
    built = names.join();
    find('measure-fields').replaceChildren(...fields(names));
  }
  const half = tensor.some((text) => !text.trim());
  const all = names.length === 3 ? 'all three of E, F and G' : 'xx, yy and zz';
  say(find('measure-problem'), half && !problem ? `Write ${all}, or none.` : null);
  // What the reader is writing is not written over, unless something else is opened.
  if (isWriting()) return;
  const values = [['density', density], ...names.map((name, i) => [`metric.${name}`, tensor[i] ?? ''])];
  for (const [name, value] of values) {
    const input = field(name);
    if (input && input.value !== value) input.value = value;
  }
}

/** @param {string[]} names of the entries */
function fields(names) {
  const inSpace = names.length === 6;
  const [place, plane] = inSpace ? ['x, y, z', 'x, y, z'] : ['u, v, x, y, z', 'u, v'];
  const entries = names.map((name) => formulaField(`metric.${name}`, inSpace ? `T${name}` : `${name}(${plane})`, ''));
  return [
    formulaField('density', `ρ(${place}), density`, ''),
    create(
      'p',
      { className: 'hint' },
      inSpace
        ? 'In place of space’s: ds² = dxᵀ T dx, a symmetric matrix T over x, y, z.'
        : 'In place of space’s: ds²\u00a0= E\u00a0du² + 2F\u00a0du\u00a0dv + G\u00a0dv².',
    ),
    create('div', { className: inSpace ? 'entries-of-tensor' : '' }, ...entries),
  ];
}
