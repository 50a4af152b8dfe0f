/** A plot of a few series as SVG: linear or logarithmic axes, round numbers, and the values under the pointer. Knows nothing of what it shows. */

import { tenTo } from '../panels/words.js';
import { pointList, svg, ticks } from './svg.js';

/** @typedef {import('../compute/study.js').Series} Series */
/** @typedef {{ label: string, log?: boolean, zero?: boolean }} Axis zero: begins there */

const [WIDTH, HEIGHT] = [320, 210];
/** At the right there is room for the half of a number that stands under the last mark. */
const BOX = { left: 46, right: 305, top: 10, bottom: 172 };
const MARKS = ['mark-round', 'mark-square'];

/** @param {number[]} values @param {Axis} axis @param {number} from @param {number} to on the picture */
function scaleOf(values, { log, zero }, from, to) {
  const inner = log ? Math.log10 : (/** @type {number} */ x) => x;
  const good = values.map(inner).filter(Number.isFinite);
  let [low, high] = [Math.min(...good), Math.max(...good)];
  if (zero) low = Math.min(low, 0);
  if (log) [low, high] = [Math.floor(low), Math.ceil(high)];
  if (!(high > low)) high = low + 1;
  if (!log && !zero) high += 0.04 * (high - low);
  const every = Math.ceil((high - low) / 6);
  const marks = log ? Array.from({ length: Math.floor((high - low) / every) + 1 }, (_, i) => low + i * every) : ticks(low, high, 5);
  const at = (/** @type {number} */ x) => from + ((inner(x) - low) / (high - low)) * (to - from);
  const valueAt = (/** @type {number} */ place) => low + ((place - from) / (to - from)) * (high - low);
  return {
    at,
    valueAt,
    marks: marks.map((mark) => ({ place: from + ((mark - low) / (high - low)) * (to - from), text: log ? tenTo(mark) : String(mark) })),
  };
}

/** @typedef {{ root: Element, valueAt: (x: number) => number, guide: (value: number | null) => void }} Plot valueAt: on the axis across, of a place of the picture; guide: a line there, or none */

/** @param {Series[]} series @param {Axis} across @param {Axis} up @returns {Plot} */
export function plot(series, across, up) {
  const root = svg('svg', { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, role: 'img', 'aria-label': `${up.label} against ${across.label}` });
  const good = series.map(({ label, samples }) => ({
    label,
    samples: samples.filter(({ x, y }) => Number.isFinite(x + y) && (!up.log || y > 0) && (!across.log || x > 0)),
  }));
  const all = good.flatMap(({ samples }) => samples);
  if (all.length === 0) return { root, valueAt: () => Number.NaN, guide: () => {} };
  const x = scaleOf(
    all.map((sample) => sample.x),
    across,
    BOX.left,
    BOX.right,
  );
  const y = scaleOf(
    all.map((sample) => sample.y),
    up,
    BOX.bottom,
    BOX.top,
  );
  for (const { place, text } of x.marks)
    root.append(
      svg('line', { x1: place, x2: place, y1: BOX.top, y2: BOX.bottom, class: 'grid' }),
      svg('text', { x: place, y: BOX.bottom + 14, 'text-anchor': 'middle', class: 'tick' }, text),
    );
  for (const { place, text } of y.marks)
    root.append(
      svg('line', { x1: BOX.left, x2: BOX.right, y1: place, y2: place, class: 'grid' }),
      svg('text', { x: BOX.left - 5, y: place + 4, 'text-anchor': 'end', class: 'tick' }, text.replace('-', '−')),
    );
  root.append(svg('text', { x: BOX.right, y: HEIGHT - 6, 'text-anchor': 'end', class: 'axis' }, across.label));
  for (const [i, { label, samples }] of good.entries()) {
    const points = samples.map((sample) => /** @type {[number, number]} */ ([x.at(sample.x), y.at(sample.y)]));
    root.append(svg('polyline', { points: pointList(points), class: `series series-${i}` }));
    if (samples.length < 40)
      root.append(...points.map((point, k) => mark(point, i, `${label}: ${samples[k].x} → ${samples[k].y.toPrecision(3)}`)));
  }
  const line = svg('line', { y1: BOX.top, y2: BOX.bottom, class: 'guide', hidden: '' });
  root.append(line);
  const guide = (/** @type {number | null} */ value) => {
    line.toggleAttribute('hidden', value === null);
    for (const name of ['x1', 'x2']) if (value !== null) line.setAttribute(name, String(x.at(value)));
  };
  return { root, valueAt: x.valueAt, guide };
}

/** The shape tells the series as well as the colour does. @param {[number, number]} point @param {number} i @param {string} words */
function mark([x, y], i, words) {
  const shape = i === 0 ? svg('circle', { cx: x, cy: y, r: 3.2 }) : svg('rect', { x: x - 3, y: y - 3, width: 6, height: 6 });
  shape.setAttribute('class', `${MARKS[i % 2]} series-${i}`);
  shape.append(svg('title', {}, words));
  return shape;
}
