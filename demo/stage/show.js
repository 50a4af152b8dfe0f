/** Shows the state in the 3D view: the surface's colours, the curves at the moment that is played, the handles, the legend and the scale. */

import { startAnchors } from './anchors.js';
import { blend, mayLeap, smooth, unbroken } from '../compute/curves.js';
import { create, find, say, themeColor } from '../panels/dom.js';
import { placesOf } from '../compute/drawn.js';
import { planeStrokes, spaceStrokes } from './grain.js';
import { startPointing } from './pointing.js';
import { startPrinting } from './print.js';
import { chosenPath, stepsShown, onRender, render, state } from '../state/state.js';
import { formatNumber, namePath } from '../panels/words.js';

/** @typedef {import('./scene.js').View} View */

const THEME = /** @type {const} */ (['surface', 'halo', 'path', 'start', 'other', 'sky', 'ground', 'via']);
/** @type {unknown} */ let shadeShown = null;
/** @type {unknown} */ let meshShown = null;

/** @param {View} view */
export function startShow(view) {
  applyTheme(view);
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => {
    applyTheme(view);
    render();
  });
  startPrinting(view, () => applyTheme(view));
  onRender(() => renderShade(view));
  onRender(() => renderCurves(view));
  startAnchors(view);
  startPointing(view);
}

/** @param {View} view */
function applyTheme(view) {
  view.setTheme(/** @type {import('./scene.js').Theme} */ (Object.fromEntries(THEME.map((name) => [name, themeColor(name)]))));
}

/** What lies between two iterates, t from 0, the first, to 1, the last. @param {Float64Array[]} film @param {number} t */
function frameAt(film, t) {
  const place = t * (film.length - 1);
  const first = Math.max(Math.ceil(place) - 1, 0);
  const [before, after] = film.slice(first);
  return after ? blend(before, after, place - first) : before;
}

/** @param {View} view */
function renderCurves(view) {
  const { solved, moment, chosen, sketch, moving, dragged } = state;
  const path = chosenPath();
  const several = solved.starts.length > 0;
  const playing = stepsShown() > 0 && moment < 1;
  const final = path && placesOf(path).length > 0 ? [placesOf(path)] : [];
  const films = several || playing ? solved.films.map((film) => frameAt(film, moment)) : [];
  const curves = {
    starts: several ? solved.starts.map(({ places }) => places) : solved.straight ? [solved.straight] : [],
    paths: playing ? films : final,
    others: several && !playing ? [] : solved.paths.filter((_, i) => i !== chosen).map(placesOf),
    warmth: playing ? moment : 1,
  };
  const whole = !path || !mayLeap(path, sketch);
  const drawn = (/** @type {Float64Array[]} */ list) =>
    list
      .flatMap((points) => (whole ? [points] : unbroken(points)))
      .filter(({ length }) => length >= 6)
      .map(smooth);
  view.setCurves({ ...curves, starts: drawn(curves.starts), paths: drawn(curves.paths), others: drawn(curves.others) });
  renderLegend({
    path: path && curves.paths.length > 0 ? namePath(path.status, sketch, chosen === 0 && !moving) : '',
    start: curves.starts.length > 0 ? (several ? 'Starts' : 'Straight start') : '',
    other: curves.others.length > 0 ? 'Other geodesics' : '',
    // A metric is drawn in the plane, which hides nothing.
    hidden: curves.paths.length > 0 && sketch.kind !== 'metric' ? 'Hidden part' : '',
    drag: dragged || !path ? '' : sketch.task === 'trace' ? 'Drag A' : 'Drag A and B',
  });
}

/** @type {string} */ let legendShown = '';

/** @param {Record<'path' | 'start' | 'other' | 'hidden' | 'drag', string>} names of what is drawn; '': it is not */
function renderLegend(names) {
  const rows = Object.entries(names).filter(([, text]) => text);
  if (legendShown === rows.join()) return;
  legendShown = rows.join();
  find('legend').replaceChildren(...rows.map(([what, text]) => create('li', { className: `legend-${what}` }, text)));
}

/** Part of the largest number, or curvature times the square of the surface's size, of which not more is left than rounding leaves. */
const NOTHING = 1e-6;
/** Relative difference of numbers that are one but for rounding, of which differences far from the origin leave most. */
const SAME = 1e-6;
const SCALES = { curvature: 'Gaussian curvature', distance: 'Distance from A', density: 'Length counts', plain: '' };

/** What shows the metric that is measured by. */
function strokesNow() {
  const { gauge, drawn, mesh } = state;
  if (!gauge || !drawn || !mesh) return null;
  return gauge.kind === 'space' ? spaceStrokes(gauge, drawn, mesh) : planeStrokes(gauge, drawn);
}

/** @param {View} view */
function renderShade(view) {
  const { shade, mesh, sketch, shadeProblem } = state;
  say(find('colour-problem'), shadeProblem);
  /** @type {HTMLSelectElement} */ (find('colour')).value = sketch.colour;
  if (mesh !== meshShown) view.setStrokes(strokesNow());
  if (shade === shadeShown && mesh === meshShown) return;
  [shadeShown, meshShown] = [shade, mesh];
  const colours = view.setValues(sketch.colour, shade);
  const scale = find('scale');
  scale.hidden = !colours;
  if (!colours) return;
  const bar = create('i', {});
  bar.style.background = `linear-gradient(90deg, ${colours.palette.join(', ')})`;
  scale.replaceChildren(
    create('span', {}, SCALES[sketch.colour]),
    bar,
    ...endsOfScale(colours, shade, view.surface.geometry.boundingSphere?.radius ?? 1).map((text) => create('b', {}, text)),
  );
}

/** What stands at the ends of a scale; one text, where there is one number. @param {import('surfpath/three').ColourScale} scale @param {ArrayLike<number> | null} values @param {number} size */
function endsOfScale({ quantity, low, high }, values, size) {
  const unit = quantity === 'curvature' ? 1 / size ** 2 : Math.max(Math.abs(low), Math.abs(high));
  const [first, last] = [low, high].map((x) => (Math.abs(x) < NOTHING * unit ? '0' : formatNumber(x, 3)));
  const isOne = values && Array.from(values).every((x) => Math.abs(x - values[0]) <= SAME * Math.abs(values[0]));
  if (isOne) return [`${first === last ? first : formatNumber(values[0], 3)} everywhere`];
  return first === '0' && last === '0' ? ['0 everywhere'] : [first, last];
}
