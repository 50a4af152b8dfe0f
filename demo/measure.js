/** The card of what measures length: a density, a metric in place of that of space, and the paper's two examples fitted to any surface. */

import { change } from './change.js';
import { find, say } from './dom.js';
import { formulaField } from './formula.js';
import { onRender, state } from './state.js';

/** @typedef {import('./sketch.js').Sketch} Sketch */

const PATIENCE = 150;
const TENSOR = ['metric.E', 'metric.F', 'metric.G'];

let timer = 0;
let built = '';

export function startMeasure() {
  find('measure-presets').addEventListener('click', ({ target }) => {
    const preset = /** @type {HTMLElement} */ (target).dataset.preset;
    if (preset) change(PRESETS[preset](), `preset ${preset}`);
  });
  find('measure-fields').addEventListener('input', () => {
    clearTimeout(timer);
    timer = window.setTimeout(readFields, PATIENCE);
  });
  onRender(renderMeasure);
}

const textOf = (/** @type {string} */ name) =>
  /** @type {HTMLInputElement | null} */ (document.getElementById(`field-${name}`))?.value.trim() ?? '';

function readFields() {
  const tensor = TENSOR.map(textOf);
  const density = textOf('density');
  change({ density, tensor: tensor.some(Boolean) ? tensor : [], colour: density || tensor.some(Boolean) ? 'density' : 'plain' }, 'measure');
}

/** A number as it stands in a formula. @param {number} x */
const write = (x) => String(Number(x.toPrecision(3)));

/** "(u - 2)", without what is zero. @param {string} name @param {number} x */
const shifted = (name, x) => (Math.abs(x) < 1e-9 ? name : x < 0 ? `(${name}+${write(-x)})` : `(${name}-${write(x)})`);

/** @type {Record<string, () => Partial<Sketch>>} */
const PRESETS = {
  none: () => ({ density: '', tensor: [], colour: state.sketch.colour === 'density' ? 'plain' : state.sketch.colour }),
  bump: () => ({ density: bump(), tensor: [], colour: 'density' }),
  grain: () => {
    const turn = `(${grainAngle()})`;
    return {
      density: '',
      tensor: [`9*cos${turn}^2+sin${turn}^2`, `8*sin${turn}*cos${turn}`, `9*sin${turn}^2+cos${turn}^2`],
      colour: 'plain',
    };
  },
};

/** A Gaussian hill of density in the middle between the ends. */
function bump() {
  const { ends, kind } = state.sketch;
  if (kind === 'implicit') {
    const [x, y, z] = ends[0].map((a, k) => (a + ends[1][k]) / 2);
    const size = ends[0].reduce((sum, a, k) => sum + (a - ends[1][k]) ** 2, 0) / 12;
    return `1+3*exp(-(${shifted('x', x)}^2+${shifted('y', y)}^2+${shifted('z', z)}^2)/${write(size)})`;
  }
  const domain = state.surface?.domain;
  if (!domain) return '';
  const { u, v } = domain;
  const [a, b] = [0, 1].map((k) => (ends[0][k] + ends[1][k]) / 2);
  const [p, q] = [u, v].map(([low, high]) => ((high - low) / 7) ** 2);
  return `1+3*exp(-${shifted('u', a)}^2/${write(p)}-${shifted('v', b)}^2/${write(q)})`;
}

/** The angle of the paper's rotating field, u + 0.7 v, with whole turns where the surface closes. */
function grainAngle() {
  const domain = state.surface?.domain;
  const closes = domain?.periodic.u || domain?.periodic.v;
  return closes ? 'u+v' : 'u+0.7*v';
}

/** @param {import('./state.js').State} state */
function renderMeasure({ sketch, problem }) {
  const { kind, density, tensor } = sketch;
  // A metric of the implicit kind has six entries: more than a reader wants to write.
  const takesMetric = kind !== 'implicit' && kind !== 'metric';
  find('measure-card').hidden = kind === 'metric';
  find('measure-presets').querySelector('[data-preset=grain]')?.toggleAttribute('hidden', !takesMetric);
  const wanted = String(takesMetric);
  if (built !== wanted) {
    built = wanted;
    const space = kind === 'implicit' ? 'x, y, z' : 'u, v, x, y, z';
    const names = takesMetric ? TENSOR : [];
    find('measure-fields').replaceChildren(
      formulaField('density', `ρ(${space}), density`, density),
      ...names.map((name) => formulaField(name, `${name.slice(-1)}(u, v) in place of space’s`, '')),
    );
  }
  for (const [name, value] of [['density', density], ...TENSOR.map((name, i) => [name, tensor[i] ?? ''])]) {
    const input = /** @type {HTMLInputElement | null} */ (document.getElementById(`field-${name}`));
    if (input && input !== document.activeElement && input.value !== value) input.value = value;
  }
  const half = tensor.some((text) => !text.trim());
  say(find('measure-problem'), half && !problem ? 'Write all three of E, F and G, or none.' : null);
}
