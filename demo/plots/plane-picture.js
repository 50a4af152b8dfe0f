/** The picture of the parameter rectangle: grid, path, neighbours, starts and ends; on the page, and as a file of its own. */

import { coordinates } from '../state/definition.js';
import { inside, liftNear, unrollings } from '../state/lifts.js';
import { pointsOf } from '../state/sketch.js';
import { chosenPath, state } from '../state/state.js';
import { indicatrices } from './indicatrices.js';
import { frameOf, MARGIN, WIDTH } from './plane-frame.js';
import { pointList, svg, ticks } from './svg.js';

/** @typedef {import('./plane-frame.js').Frame} Frame */

/** Why there is no picture. */
export const NO_PLANE = 'A surface f(x, y, z) = 0 has no parameters.';

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
    svg('text', { x: left, y: top - 3, 'text-anchor': 'middle', class: 'axis' }, names[1]),
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
export function picture(frame) {
  const { sketch, solved, chosen } = state;
  const path = chosenPath();
  // What is half written has no place, nor what lies where SVG, which has 32 bits, has no numbers.
  const isPlace = (/** @type {number[]} */ point) => frame.to(point).every((x) => Number.isFinite(Math.fround(x)));
  const [ends, via] = [pointsOf(sketch).slice(0, 2), pointsOf(sketch).slice(2)];
  const handles = ends.flatMap((end, i) => (isPlace(end) ? [handleOf(frame, end, i)] : []));
  const others = solved.paths.filter((_, i) => i !== chosen).flatMap(({ parameters }) => curve(parameters ?? [], frame, 'other'));
  const isWay = ends.length === 2 && ends.every(isPlace) && via.length === 0;
  const starts = isWay ? startsOf(frame).flatMap((line) => curve(line, frame, 'straight')) : [];
  const clip = svg(
    'clipPath',
    { id: 'plane-clip' },
    svg('rect', { x: MARGIN.left, y: MARGIN.top, width: frame.size[0], height: frame.size[1] }),
  );
  const inner = svg('g', { 'clip-path': 'url(#plane-clip)' }, ...indicatrices(frame), ...starts, ...others);
  if (path?.parameters) inner.append(...curve(path.parameters, frame, 'path-halo'), ...curve(path.parameters, frame, 'path'));
  const vias = via.filter(isPlace).map((point) => {
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
