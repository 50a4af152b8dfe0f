/** The picture on paper: in the light theme, of one size whatever the screen's. */

import { find } from '../panels/dom.js';
import { render } from '../state/state.js';

/** Room on a sheet of A4 or Letter, upright or not, in CSS pixels, as in the style sheet; formula and result stand below. */
const SIZE = { width: 640, height: 460 };
/** What the legend and the scale cover of it. */
const COVERED = { top: 30, bottom: 30 };
/** Pixels of the picture a CSS pixel: 192 an inch. */
const RATIO = 2;

/** Cards that say what the surface is; on paper they are open. */
const CARDS = ['formula-card', 'measure-card'];

/** @param {import('./scene.js').View} view @param {() => void} applyTheme has the view take the colours of the style sheet */
export function startPrinting(view, applyTheme) {
  const root = document.documentElement;
  /** @type {HTMLDetailsElement[]} */ let opened = [];
  const turn = (/** @type {boolean} */ isPrinting) => {
    root.toggleAttribute('data-printing', isPrinting);
    if (isPrinting) opened = CARDS.map((id) => /** @type {HTMLDetailsElement} */ (find(id))).filter(({ open }) => !open);
    for (const card of opened) card.open = isPrinting;
    applyTheme();
    render();
  };
  addEventListener('beforeprint', () => {
    turn(true);
    // It is drawn now: a frame that was drawn before is gone from the canvas.
    view.setSize(SIZE, COVERED, RATIO);
  });
  addEventListener('afterprint', () => {
    turn(false);
    view.resize();
  });
}
