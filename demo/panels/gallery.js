/** The gallery: a dialog of pictures, opened from the panel. The pictures are real renders of this page, made by `make thumbnails`. */

import { choose } from '../state/change.js';
import { create, find, say } from './dom.js';
import { ENTRIES, GROUPS } from '../state/entries.js';
import { isGiven } from './formula.js';
import { FIRST, onRender } from '../state/state.js';

const picture = (/** @type {string} */ name) => `thumbnails/${name}.webp`;

export function startGallery() {
  const dialog = /** @type {HTMLDialogElement} */ (find('gallery'));
  find('open-gallery').addEventListener('click', () => {
    if (!find('gallery-groups').hasChildNodes()) find('gallery-groups').append(...GROUPS.flatMap(([title, names]) => group(title, names)));
    dialog.showModal();
  });
  find('close-gallery').addEventListener('click', () => dialog.close());
  dialog.addEventListener('click', ({ target }) => {
    const name = /** @type {HTMLElement} */ (target).closest?.('[data-entry]')?.getAttribute('data-entry');
    if (name) choose(name);
    if (name || target === dialog) dialog.close();
  });
  onRender(renderOpener);
}

/** @param {string} title @param {string[]} names */
function group(title, names) {
  const cards = names.map((name) => {
    const image = create('img', { src: picture(name), alt: '', width: 240, height: 180, loading: 'lazy' });
    const button = create('button', { type: 'button', className: 'entry' }, image, create('span', {}, ENTRIES[name].title));
    button.dataset.entry = name;
    return button;
  });
  return [create('h3', {}, title), create('div', { className: 'entries' }, ...cards)];
}

/** @param {import('../state/state.js').State} state */
function renderOpener({ sketch: { entry, kind } }) {
  const { title, source } = ENTRIES[entry];
  const given = isGiven();
  find('entry-title').textContent = given || entry.startsWith('own-') ? title : `${title}, changed`;
  say(find('source'), given ? source : null);
  const image = /** @type {HTMLImageElement} */ (find('entry-picture'));
  // That of the first scene is there already, small.
  const src = picture(entry === FIRST ? 'poster' : entry.startsWith('own-') ? `own-${kind}` : entry);
  if (image.getAttribute('src') !== src) image.setAttribute('src', src);
}
