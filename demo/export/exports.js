/** What can be taken away: a link, a picture, the plane, the points, everything as data, and the surface with its path for 3D programs. */

import { linkNow } from '../state/change.js';
import { question } from '../compute/flow.js';
import { coordinates } from '../state/definition.js';
import { find, say } from '../panels/dom.js';
import { NO_PLANE, planeFile } from '../plots/plane-picture.js';
import { runsOf } from '../compute/legs.js';
import { chosenPath, onRender, state } from '../state/state.js';

/** @typedef {import('../stage/scene.js').View} View */
/** @typedef {{ name: string, type: string, content: BlobPart }} File */

/** @type {Record<string, (view: View | null) => Promise<File | string> | File | string>} a string: why there is none */
const EXPORTS = {
  png: (view) => picture(view),
  svg: () => {
    const content = planeFile();
    return content ? { name: 'plane.svg', type: 'image/svg+xml', content } : NO_PLANE;
  },
  csv: () => {
    const path = chosenPath();
    return path && exists(path) ? { name: 'path.csv', type: 'text/csv', content: table(path) } : 'There is no path.';
  },
  json: () => ({ name: 'surfpath.json', type: 'application/json', content: `${JSON.stringify(contents(), listed, 1)}\n` }),
  gltf: (view) => model(view),
};

/** Whether there is a path, not only why there is none. @param {import('surfpath').Path} path */
const exists = ({ length }) => Number.isFinite(length);

/** The sketch that the words below the buttons are about. @type {unknown} */ let wordsOf = null;

/** @param {string | null} words */
function tell(words) {
  wordsOf = state.sketch;
  say(find('export-words'), words);
}

/** @param {View | null} view */
export function startExports(view) {
  find('exports').addEventListener('click', async ({ target }) => {
    const name = /** @type {HTMLElement} */ (target).dataset.export;
    if (!name) return;
    if (name === 'link') return copyLink();
    const made = await EXPORTS[name](view);
    if (typeof made === 'string') return tell(made);
    save(made);
    tell(`Saved ${made.name}.`);
  });
  const plane = /** @type {HTMLButtonElement} */ (find('exports').querySelector('[data-export=svg]'));
  const { title } = plane;
  onRender(({ sketch, surface }) => {
    // Once something is changed, it is not what was copied or saved.
    if (sketch !== wordsOf) tell(null);
    plane.disabled = surface?.domain === null;
    plane.title = plane.disabled ? NO_PLANE : title;
  });
}

async function copyLink() {
  const link = `${location.href.replace(/#.*$/, '')}${linkNow()}`;
  history.replaceState(null, '', link);
  const copied = await navigator.clipboard?.writeText(link).then(
    () => true,
    () => false,
  );
  tell(copied ? 'The link is copied.' : 'The link is in the address bar.');
}

/** @param {File} file */
function save({ name, type, content }) {
  const address = URL.createObjectURL(new Blob([content], { type }));
  const anchor = Object.assign(document.createElement('a'), { href: address, download: name });
  anchor.click();
  setTimeout(() => URL.revokeObjectURL(address), 10_000);
}

/** @param {View | null} view @returns {Promise<File | string>} */
function picture(view) {
  if (!view) return Promise.resolve('There is no picture without 3D.');
  // The buffer is emptied after each frame: draw and read in one go.
  view.draw();
  return new Promise((resolve) =>
    view.canvas.toBlob((blob) =>
      resolve(blob ? { name: 'surfpath.png', type: 'image/png', content: blob } : 'The browser made no picture.'),
    ),
  );
}

/** One line a point: length from A, position, parameters, which a graph has in its position. @param {import('surfpath').Path} path */
function table(path) {
  const { kind } = state.shown ?? state.sketch;
  const { points } = path;
  const parameters = kind === 'graph' ? null : path.parameters;
  const runs = runsOf(path, state.solved.legs);
  const names = coordinates(kind);
  const head = ['s', ...(points.length > 0 ? ['x', 'y', 'z'] : []), ...(parameters ? names : [])];
  const rows = runs.map((run, i) => [run, ...points.subarray(3 * i, 3 * i + 3), ...(parameters?.subarray(2 * i, 2 * i + 2) ?? [])].join());
  return `${[head.join(), ...rows].join('\n')}\n`;
}

/** What is seen: where a formula is wrong, the last good surface, as the path is of that one. */
function contents() {
  const { definition: surface, ends, via, options } = question();
  return { surface, from: ends[0], to: ends[1], via, options, path: chosenPath() };
}

/** Typed arrays as lists. @param {string} _name @param {unknown} value */
const listed = (_name, value) => (value instanceof Float64Array ? Array.from(value) : value);

/** @param {View | null} view @returns {Promise<File | string>} */
async function model(view) {
  if (!view) return 'There is no model without 3D.';
  const { toGltf } = await import('./gltf.js');
  return { name: 'surfpath.gltf', type: 'model/gltf+json', content: await toGltf(view.surface.geometry, chosenPath()) };
}
