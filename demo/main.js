/** Starts the page: the view, the solver, and what the reader's hands do to the state. */

import { load } from 'surfpath';
import { fieldNames } from './definition.js';
import { find, say, themeColor } from './dom.js';
import { fillGallery, fillKinds, readEnds, readFields } from './panel.js';
import { View } from './scene.js';
import {
  changeEnds,
  changeFormula,
  changeOptions,
  changeParameter,
  choose,
  chooseRandomEnds,
  connect,
  kind,
  play,
  scrub,
} from './state.js';

const FIRST = 'parametricTorus';
const MOST_POINTS = 2000;
/** Milliseconds without a keystroke before a formula is compiled. */
const PATIENCE = 150;

let timer = 0;

/** A field of the form changed. @param {HTMLInputElement} input */
function changed(input) {
  const { name, value } = input;
  if (['kind', 'entry'].includes(name) || name.startsWith('field-')) clearTimeout(timer);
  if (name.startsWith('field-')) timer = window.setTimeout(() => changeFormula(readFields(fieldNames(kind()))), PATIENCE);
  else if (name.startsWith('parameter-')) changeParameter(name.slice('parameter-'.length), input.valueAsNumber);
  else if (name.startsWith('end-')) changeEnds(readEnds(kind()));
  else if (name === 'points') changePoints(input);
  else if (name === 'tolerance') changeOptions({ tolerance: Number(value) });
  else if (name === 'algorithm' || name === 'start') changeOptions({ [name]: value });
  else if (name === 'kind') choose(`own-${value}`);
  else if (name === 'entry') choose(value);
}

/** @param {HTMLInputElement} input */
function changePoints(input) {
  const points = input.valueAsNumber;
  const good = Number.isInteger(points) && points >= 1 && points <= MOST_POINTS;
  if (good) input.removeAttribute('aria-invalid');
  else input.setAttribute('aria-invalid', 'true');
  say(find('points-problem'), good ? null : `Write a whole number from 1 to ${MOST_POINTS}.`);
  if (good) changeOptions({ points });
}

function listen() {
  find('panel').addEventListener('input', (event) => changed(/** @type {HTMLInputElement} */ (event.target)));
  find('panel').addEventListener('submit', (event) => event.preventDefault());
  find('fields').addEventListener('keydown', (event) => {
    if (event.key === 'Enter') event.preventDefault();
  });
  find('play').addEventListener('click', play);
  find('moment').addEventListener('input', (event) => scrub(/** @type {HTMLInputElement} */ (event.target).valueAsNumber));
  find('random-ends').addEventListener('click', chooseRandomEnds);
}

/** @param {View} view */
function applyTheme(view) {
  const names = /** @type {const} */ (['surface', 'halo', 'path', 'start', 'hidden', 'sky', 'ground']);
  view.setTheme(/** @type {import('./scene.js').Theme} */ (Object.fromEntries(names.map((name) => [name, themeColor(name)]))));
}

/** The 3D view, or null with a notice where there is no WebGL. */
function makeView() {
  try {
    const view = new View(find('view'), find('canvas'), [find('label-a'), find('label-b')]);
    applyTheme(view);
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => applyTheme(view));
    return view;
  } catch {
    for (const label of ['label-a', 'label-b']) find(label).hidden = true;
    say(find('notice'), 'No 3D graphics here: switch WebGL on, or use another browser. The numbers below are computed all the same.');
    return null;
  }
}

async function start() {
  fillGallery(find('entry'));
  fillKinds(find('kinds'));
  const view = makeView();
  try {
    connect(await load(), view);
  } catch (error) {
    const reason = error instanceof Error ? error.message : String(error);
    say(find('notice'), `The solver cannot run here; use a current browser with WebAssembly. (${reason})`);
    return say(find('status'), 'No solver');
  }
  listen();
  choose(FIRST);
}

start();
