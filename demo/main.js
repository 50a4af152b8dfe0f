/** Starts the page: the view, the solver, the cards, and what the keys do. */

import { load } from 'surfpath';
import { change, history, openAddress, redo, undo, viewMoved } from './state/change.js';
import { find, say } from './panels/dom.js';
import { startExports } from './export/exports.js';
import { connect, recolour, reframe, showIn } from './compute/flow.js';
import { startFormula } from './panels/formula.js';
import { startGallery } from './panels/gallery.js';
import { startMeasure } from './panels/measure.js';
import { startPathCard } from './panels/path-card.js';
import { startPlane } from './plots/plane.js';
import { Player } from './stage/player.js';
import { refreshPlot, startPlots } from './plots/plots.js';
import { startResult } from './panels/result.js';
import { View } from './stage/scene.js';
import { startShow } from './stage/show.js';
import { startSliders } from './panels/sliders.js';
import { FIRST, stepsShown, onRender, render, state } from './state/state.js';
import { live, startProgress } from './compute/workers.js';

const player = new Player((moment) => {
  state.moment = moment;
  render();
});

/** The picture of the first scene, which stands in for it until there is something to see. */
const removePoster = () => document.getElementById('poster')?.remove();

const LOST = 'The browser has stopped 3D graphics: the picture comes back with them.';

/** The 3D view, or null with a notice where there is no WebGL. */
function makeView() {
  try {
    const view = new View(find('view'), /** @type {HTMLCanvasElement} */ (find('canvas')));
    Object.assign(window, { surfpathView: view });
    view.onFirst = removePoster;
    view.onLost = (isLost) => say(find('notice'), isLost ? LOST : null);
    view.controls.addEventListener('change', viewMoved);
    startShow(view);
    return view;
  } catch {
    removePoster();
    say(find('notice'), 'No 3D graphics here: switch WebGL on, or use another browser. The numbers need none.');
    return null;
  }
}

/** The slider is moved to anywhere between two steps; the arrow keys go from one to the next. @type {Record<string, number>} */
const STEPS_OF_KEYS = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1 };

/** @param {number} step an iterate, or a place between two of them */
function showStep(step) {
  player.stop();
  state.moment = Math.min(Math.max(step / stepsShown(), 0), 1);
  render();
}

function listen() {
  find('form').addEventListener('submit', (event) => event.preventDefault());
  find('colour').addEventListener('change', ({ target }) =>
    change({ colour: /** @type {any} */ (/** @type {HTMLSelectElement} */ (target).value) }),
  );
  find('play').addEventListener('click', () => player.play());
  find('moment').addEventListener('input', ({ target }) => showStep(/** @type {HTMLInputElement} */ (target).valueAsNumber));
  find('moment').addEventListener('keydown', (event) => {
    const direction = STEPS_OF_KEYS[event.key];
    if (!direction) return;
    event.preventDefault();
    showStep(Math.round(state.moment * stepsShown()) + direction);
  });
  find('undo').addEventListener('click', undo);
  find('redo').addEventListener('click', redo);
  find('reframe').addEventListener('click', reframe);
  find('toggle-panel').addEventListener('click', togglePanel);
  find('tabs').addEventListener('click', ({ target }) => showTab(/** @type {HTMLElement} */ (target).dataset.tab));
  addEventListener('keydown', pressed);
  // Before whatever is pressed hears of it.
  addEventListener('pointerdown', () => history.hold(), true);
  for (const type of ['pointerup', 'pointercancel']) addEventListener(type, () => history.release());
  // The address itself may have been rewritten since: of a change a moment before.
  addEventListener('hashchange', ({ newURL }) => openAddress(new URL(newURL).hash));
  onRender(() => {
    /** @type {HTMLButtonElement} */ (find('undo')).disabled = !history.canUndo;
    /** @type {HTMLButtonElement} */ (find('redo')).disabled = !history.canRedo;
  });
}

function togglePanel() {
  const open = document.documentElement.toggleAttribute('data-panel');
  find('toggle-panel').setAttribute('aria-expanded', String(open));
}

/** On a phone, the panel's cards are behind tabs. @param {string | undefined} name */
function showTab(name) {
  if (!name) return;
  document.documentElement.dataset.tab = name;
  for (const button of find('tabs').children) button.setAttribute('aria-pressed', String(button.getAttribute('data-tab') === name));
  find('panel').scrollTo(0, 0);
  for (const id of ['plane-card', 'plots-card']) if (id === `${name}-card`) /** @type {HTMLDetailsElement} */ (find(id)).open = true;
}

/** @param {KeyboardEvent} event */
function pressed(event) {
  if (event.key === 'Escape' && document.documentElement.hasAttribute('data-panel') && !document.querySelector('dialog[open]')) {
    togglePanel();
    return find('toggle-panel').focus();
  }
  const typing = /** @type {HTMLElement} */ (event.target).matches?.('textarea, input:not([type=range], [type=radio])');
  if (!(event.ctrlKey || event.metaKey) || event.key.toLowerCase() !== 'z' || typing) return;
  event.preventDefault();
  if (event.shiftKey) redo();
  else undo();
}

/** @param {boolean} animated */
function solved(animated) {
  if (performance.getEntriesByName('first path').length === 0) {
    performance.mark('first path');
    requestAnimationFrame(() => setTimeout(() => performance.mark('first path drawn')));
  }
  if (animated) player.play();
  else player.stop();
  if (state.sketch.colour !== 'plain') recolour();
  refreshPlot();
}

/** Lets the browser do what waits: nothing on the way to the first picture keeps it for long. */
const breathe = () => new Promise((resolve) => setTimeout(resolve));

async function start() {
  live.warm();
  const loading = load();
  // Said below, when there is a place for it.
  loading.catch(() => {});
  await breathe();
  for (const begin of [
    startResult,
    // Its fields are there before the formula card looks for the one with a mistake.
    startMeasure,
    startFormula,
    startSliders,
    startPathCard,
    startGallery,
    startPlane,
    startPlots,
    startProgress,
  ])
    begin();
  try {
    connect(await loading, solved);
  } catch (error) {
    const reason = error instanceof Error ? error.message : String(error);
    removePoster();
    say(find('notice'), `The solver cannot run here; use a current browser with WebAssembly. (${reason})`);
    return say(find('status'), 'No solver');
  }
  // In place of a surface that is none there is nothing to see.
  onRender(({ problem }) => problem && removePoster());
  // The worker has its first task while the view is made.
  openAddress(location.hash);
  if (state.sketch.entry !== FIRST) removePoster();
  await breathe();
  const view = makeView();
  showIn(view);
  startExports(view);
  listen();
}

start();
