/** The plane of the parameters beside the view: the rectangle, the path in it, its neighbours, and both ends, which can be dragged here too. */

import { change } from '../state/change.js';
import { coordinates } from '../state/definition.js';
import { determinantOf } from '../compute/tensor.js';
import { find, say } from '../panels/dom.js';
import { onHover, setHover } from '../state/hover.js';
import { inside, liftNear, unrollings } from '../state/lifts.js';
import { chosenPath, onRender, state } from '../state/state.js';
import { pointList, svg, ticks } from './svg.js';

/** @typedef {[number, number]} Point */
/** @typedef {{ domain: import('../state/lifts.js').Domain, low: Point, high: Point, periodic: boolean[], size: Point, to: (point: ArrayLike<number>) => Point, from: (place: Point) => number[] }} Frame */

const WIDTH = 320;
/** Room for the numbers, in units of the picture: left, right, top, bottom. */
const MARGIN = { left: 38, right: 10, top: 10, bottom: 28 };
const [LEAST_HEIGHT, MOST_HEIGHT] = [150, 300];

/** @type {{ frame: Frame, handles: SVGElement[] } | null} */ let drawn = null;
let held = -1;

export function startPlane() {
  const place = find('plane');
  place.addEventListener('pointerdown', (event) => {
    const handle = /** @type {Element} */ (event.target).closest('[data-end]');
    if (!handle) return;
    held = Number(handle.getAttribute('data-end'));
    place.setPointerCapture(event.pointerId);
    event.preventDefault();
  });
  place.addEventListener('pointermove', (event) => (held < 0 ? pointAt(event) : drag(event)));
  place.addEventListener('pointerleave', () => setHover(null));
  for (const type of ['pointerup', 'pointercancel', 'lostpointercapture'])
    place.addEventListener(type, () => {
      held = -1;
    });
  find('plane-card').addEventListener('toggle', renderPlane);
  onRender(renderPlane);
  onHover(renderHover);
}

/** The parameters at a place of the window. @param {PointerEvent} event @returns {number[] | null} */
function parametersAt({ clientX, clientY }) {
  const picture = find('plane').querySelector('svg');
  if (!drawn || !picture) return null;
  const { x, y } = new DOMPoint(clientX, clientY).matrixTransform(picture.getScreenCTM()?.inverse());
  return drawn.frame.from([x, y]);
}

/** @param {PointerEvent} event */
function pointAt(event) {
  const parameters = event.pointerType === 'touch' ? null : parametersAt(event);
  const { low, high } = drawn?.frame ?? { low: [], high: [] };
  const isInside = parameters?.every((x, k) => x >= low[k] && x <= high[k]);
  setHover(isInside ? { place: null, parameters, run: null } : null);
}

/** Marks what is pointed at, here or elsewhere. @param {import('../state/hover.js').Hover | null} hover */
function renderHover(hover) {
  const dot = find('plane').querySelector('.hover');
  if (!drawn || !dot) return;
  dot.toggleAttribute('hidden', !hover?.parameters);
  if (!hover?.parameters) return;
  const [x, y] = drawn.frame.to(inside(drawn.frame.domain, hover.parameters));
  for (const [name, value] of [
    ['cx', x],
    ['cy', y],
  ])
    dot.setAttribute(String(name), String(value));
}

/** @param {PointerEvent} event */
function drag(event) {
  const at = parametersAt(event);
  if (!at || !drawn || state.building) return;
  const { low, high, periodic } = drawn.frame;
  const point = at.map((x, i) => (periodic[i] ? x : Math.min(Math.max(x, low[i]), high[i])));
  change({ ends: state.sketch.ends.map((end, i) => (i === held ? point : end)) }, `plane ${held}`);
}

/** @param {NonNullable<import('surfpath').Surface['domain']>} domain @returns {Frame} */
function frameOf(domain) {
  const { u, v, periodic } = domain;
  const wide = WIDTH - MARGIN.left - MARGIN.right;
  const high = Math.min(Math.max((wide * (v[1] - v[0])) / (u[1] - u[0]), LEAST_HEIGHT), MOST_HEIGHT);
  const scale = [wide / (u[1] - u[0]), high / (v[1] - v[0])];
  return {
    domain,
    low: [u[0], v[0]],
    high: [u[1], v[1]],
    periodic: [periodic.u, periodic.v],
    size: [wide, high],
    to: (point) => [MARGIN.left + (point[0] - u[0]) * scale[0], MARGIN.top + (v[1] - point[1]) * scale[1]],
    from: ([x, y]) => [u[0] + (x - MARGIN.left) / scale[0], v[1] - (y - MARGIN.top) / scale[1]],
  };
}

/** A curve, each part of it in the rectangle once. @param {ArrayLike<number>} parameters @param {Frame} frame @param {string} className */
function curve(parameters, frame, className) {
  if (parameters.length === 0) return [];
  return unrollings(frame.domain, parameters).map((points) =>
    svg('polyline', { points: pointList(points.map((point) => frame.to(point))), class: className }),
  );
}

/** @param {Frame} frame @param {string[]} names */
function grid({ low, high, size, to }, names) {
  const [left, top] = to([low[0], high[1]]);
  const bottom = top + size[1];
  const lines = [0, 1].flatMap((k) =>
    ticks(low[k], high[k], k === 0 ? 6 : 4).flatMap((value) => {
      const [x, y] = to(k === 0 ? [value, low[1]] : [low[0], value]);
      const line = k === 0 ? { x1: x, x2: x, y1: top, y2: bottom } : { x1: left, x2: left + size[0], y1: y, y2: y };
      const label = k === 0 ? { x, y: bottom + 14, 'text-anchor': 'middle' } : { x: left - 5, y: y + 4, 'text-anchor': 'end' };
      return [svg('line', { ...line, class: 'grid' }), svg('text', { ...label, class: 'tick' }, String(value).replace('-', '−'))];
    }),
  );
  return [
    svg('rect', { x: left, y: top, width: size[0], height: size[1], class: 'ground' }),
    ...lines,
    svg('text', { x: left + size[0], y: bottom + 26, 'text-anchor': 'end', class: 'axis' }, names[0]),
    svg('text', { x: left - 36, y: top + 8, class: 'axis' }, names[1]),
    svg('rect', { x: left, y: top, width: size[0], height: size[1], class: 'edge' }),
  ];
}

/** From A to B, where a direction is periodic by at most half a turn: as the straight start. @param {number[][]} ends @param {Frame['domain']} domain */
const straightLine = ([from, to], domain) => [...from, ...liftNear(domain, to, from)];

/** The lines that are started from: several, or the straight one. @param {Frame} frame @returns {ArrayLike<number>[]} */
function startsOf({ domain }) {
  const { ends, start, task } = state.sketch;
  const several = start === 'several' && task === 'path';
  return several ? state.solved.starts.flatMap(({ parameters }) => (parameters ? [parameters] : [])) : [straightLine(ends, domain)];
}

/** An ellipse at points of a lattice: all that is equally far from its centre, where length is not that of space, and is one. @param {Frame} frame */
function indicatrices(frame) {
  const { gauge } = state;
  if (gauge?.kind !== 'metric') return [];
  const cells = 9;
  const places = Array.from({ length: cells * cells }, (_, i) =>
    [i % cells, Math.floor(i / cells)].map((x, k) => frame.low[k] + ((x + 0.5) / cells) * (frame.high[k] - frame.low[k])),
  );
  const values = gauge.evaluate(Float64Array.from(places.flat()));
  const metrics = places
    .map((place, i) => ({ place, metric: values.subarray(3 * i, 3 * i + 3) }))
    .filter(({ metric: [E, F, G] }) => E > 0 && determinantOf(E, F, G) > 0);
  const size = (0.42 * (frame.high[0] - frame.low[0])) / cells / Math.max(...metrics.map(({ metric }) => longestRadius(metric)));
  return metrics.map(({ place, metric }) => ellipse(place, metric, size, frame));
}

/** Of an ellipse E a² + 2F ab + G b² = 1. @param {Float64Array} metric */
const longestRadius = ([E, F, G]) => 1 / Math.sqrt((E + G) / 2 - Math.hypot((E - G) / 2, F));

/** @param {number[]} place @param {Float64Array} metric E F G @param {number} size @param {Frame} frame */
function ellipse(place, [E, F, G], size, frame) {
  const points = Array.from({ length: 48 }, (_, i) => {
    const [a, b] = [Math.cos((i * Math.PI) / 24), Math.sin((i * Math.PI) / 24)];
    const radius = size / Math.sqrt(E * a * a + 2 * F * a * b + G * b * b);
    return frame.to([place[0] + radius * a, place[1] + radius * b]);
  });
  return svg('polygon', { points: pointList(points), class: 'indicatrix' });
}

/** @param {Frame} frame @param {number[]} end @param {number} index */
function handleOf(frame, end, index) {
  const [x, y] = frame.to(inside(frame.domain, end));
  return svg(
    'g',
    { class: 'end-handle', 'data-end': index },
    svg('circle', { cx: x, cy: y, r: 15, class: 'target' }),
    svg('circle', { cx: x, cy: y, r: 5.5, class: 'dot' }),
    svg('text', { x: x + 9, y: y - 7, class: 'letter' }, 'AB'[index]),
  );
}

/** The plane as SVG. @param {Frame} frame */
function picture(frame) {
  const { sketch, solved, chosen } = state;
  const path = chosenPath();
  // What is half written has no place.
  const isPlace = (/** @type {number[]} */ point) => point.every(Number.isFinite);
  const ends = sketch.task === 'trace' ? sketch.ends.slice(0, 1) : sketch.ends;
  const handles = ends.flatMap((end, i) => (isPlace(end) ? [handleOf(frame, end, i)] : []));
  const others = solved.paths.filter((_, i) => i !== chosen).flatMap(({ parameters }) => curve(parameters ?? [], frame, 'other'));
  const isWay = ends.length === 2 && ends.every(isPlace) && sketch.via.length === 0;
  const starts = isWay ? startsOf(frame).flatMap((line) => curve(line, frame, 'straight')) : [];
  const clip = svg(
    'clipPath',
    { id: 'plane-clip' },
    svg('rect', { x: MARGIN.left, y: MARGIN.top, width: frame.size[0], height: frame.size[1] }),
  );
  const inner = svg('g', { 'clip-path': 'url(#plane-clip)' }, ...indicatrices(frame), ...starts, ...others);
  if (path?.parameters) inner.append(...curve(path.parameters, frame, 'path-halo'), ...curve(path.parameters, frame, 'path'));
  const vias = sketch.via.filter(isPlace).map((point) => {
    const [x, y] = frame.to(inside(frame.domain, point));
    return svg('circle', { cx: x, cy: y, r: 4, class: 'via' });
  });
  const height = frame.size[1] + MARGIN.top + MARGIN.bottom;
  const root = svg('svg', { viewBox: `0 0 ${WIDTH} ${height}`, role: 'img', 'aria-label': 'The path in the plane of the parameters' });
  root.append(
    clip,
    ...grid(frame, coordinates(sketch.kind)),
    inner,
    ...vias,
    ...handles,
    svg('circle', { r: 4, class: 'hover', hidden: '' }),
  );
  return { root, handles };
}

function renderPlane() {
  const { domain } = state.surface ?? { domain: null };
  say(
    find('plane-hint'),
    domain ? 'The ends can be dragged here too.' : state.surface ? 'A surface f(x, y, z) = 0 has no parameters.' : null,
  );
  if (!(/** @type {HTMLDetailsElement} */ (find('plane-card')).open)) return;
  if (!domain) {
    drawn = null;
    return find('plane').replaceChildren();
  }
  const frame = frameOf(domain);
  const { root, handles } = picture(frame);
  drawn = { frame, handles };
  find('plane').replaceChildren(root);
}

/** The picture of the plane as a file of its own, with its colours in it; null where there is none. */
export function planeFile() {
  const { domain } = state.surface ?? { domain: null };
  if (!domain) return null;
  const { root } = picture(frameOf(domain));
  root.setAttribute('xmlns', 'http://www.w3.org/2000/svg');
  root.setAttribute('width', '960');
  for (const helper of root.querySelectorAll('.target, .hover')) helper.remove();
  // As text: a style element in this document would be refused by its policy.
  return new XMLSerializer().serializeToString(root).replace(/<\/svg>$/, `<style>${STYLE}</style></svg>`);
}

const STYLE = `text{font:10px system-ui,sans-serif;fill:#5b6876}.letter{font-weight:600;fill:#1d2733;stroke:#f7f9fb;stroke-width:3px;paint-order:stroke}
.ground{fill:#f7f9fb}.grid{stroke:#d9e1e8;stroke-width:.7}.edge{fill:none;stroke:#9aa8b6}
polyline{fill:none;stroke-linecap:round;stroke-linejoin:round}.path{stroke:#d8430c;stroke-width:2.6}.path-halo{stroke:#fff;stroke-width:5}
.straight{stroke:#2166c4;stroke-width:1.3}.other{stroke:#5b6876;stroke-width:1.5}.indicatrix{fill:none;stroke:#9aa8b6;stroke-width:.8}
.dot{fill:#d8430c;stroke:#fff;stroke-width:1.5}.via{fill:#1d2733;stroke:#fff;stroke-width:1.5}`;
