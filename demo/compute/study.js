/** Series for the plots, measured on the surface and the points that the reader chose. Reports after every point of a series. */

import { runsOf } from './legs.js';

/** @typedef {import('./tasks.js').Opened} Opened */
/** @typedef {{ x: number, y: number }} Sample */
/** @typedef {{ label: string, samples: Sample[] }} Series */
/** @typedef {{ definition: any, ends: number[][], plot: string, path: import('surfpath').Path | null, legs: import('./legs.js').Leg[], options: { points: number } }} Request */

const POINTS_OF_ERROR = [4, 8, 16, 32, 64, 128, 256, 512, 1024];
const POINTS_OF_TIME = [10, 25, 50, 100, 150, 200, 300, 400, 500];
const METHODS = /** @type {const} */ (['polyline', 'paper']);
const NAMES = { polyline: 'Polyline', paper: 'The paper’s' };
const RUNS = 5;

/** @param {Opened} opened @param {Request} request @param {(progress: unknown) => void} report @returns {Series[]} */
export function study(opened, request, report) {
  if (request.plot === 'convergence') return convergence(opened, request);
  if (request.plot === 'error') return errors(opened, request, report);
  if (request.plot === 'time') return times(opened, request, report);
  return [curvatureAlong(request)];
}

/** ‖∇E‖ after each step. @param {Opened} opened @param {Request} request @returns {Series[]} */
function convergence({ surface }, { ends: [from, to], options: { points } }) {
  return METHODS.map((algorithm) => {
    const { history } = surface.shortestPath(from, to, { algorithm, points, start: 'straight' });
    return { label: NAMES[algorithm], samples: history.map(({ gradientNorm }, x) => ({ x, y: gradientNorm })) };
  });
}

/** Error of the length of K chords, and what is left of it with the estimate added. @param {Opened} opened @param {Request} request @param {(progress: unknown) => void} report */
function errors({ surface }, { ends: [from, to], path }, report) {
  /** @type {Series[]} */
  const series = [
    { label: 'Chords', samples: [] },
    { label: 'Chords, with the estimate', samples: [] },
  ];
  if (!path || path.points.length + (path.parameters?.length ?? 0) === 0) return series;
  const exact = surface.shortestPath(from, to, { start: path, tolerance: 1e-13 });
  for (const [i, points] of POINTS_OF_ERROR.entries()) {
    const { length, lengthError } = surface.shortestPath(from, to, { algorithm: 'polyline', points, start: path });
    for (const [k, value] of [length, length + lengthError].entries())
      series[k].samples.push({ x: points, y: Math.abs(value - exact.length) / exact.length });
    report({ share: (i + 1) / POINTS_OF_ERROR.length, series });
  }
  return series;
}

/** Milliseconds a solve from the straight start, the least of some. @param {Opened} opened @param {Request} request @param {(progress: unknown) => void} report */
function times({ surface }, { ends: [from, to] }, report) {
  /** @type {Series[]} */
  const series = METHODS.map((algorithm) => ({ label: NAMES[algorithm], samples: [] }));
  for (const [i, points] of POINTS_OF_TIME.entries()) {
    for (const [k, algorithm] of METHODS.entries()) {
      let least = Infinity;
      for (let run = 0; run < RUNS; run++) {
        const begin = performance.now();
        for (let j = 0; j < 4; j++) surface.shortestPath(from, to, { algorithm, points, start: 'straight' });
        least = Math.min(least, (performance.now() - begin) / 4);
      }
      series[k].samples.push({ x: points, y: least });
    }
    report({ share: (i + 1) / POINTS_OF_TIME.length, series });
  }
  return series;
}

/** Curvature of the path in space, 1/length, over the length from A: that of the circle through three points in a row. @param {Request} request @returns {Series} */
function curvatureAlong({ path, legs }) {
  /** @type {Sample[]} */
  const samples = [];
  const points = path?.points ?? new Float64Array(0);
  const side = (/** @type {number} */ i, /** @type {number} */ j) =>
    Math.hypot(...[0, 1, 2].map((k) => points[3 * j + k] - points[3 * i + k]));
  const runs = path ? runsOf(path, legs) : [];
  for (let i = 1; 3 * i + 3 < points.length; i++) {
    const [a, b, c] = [side(i - 1, i), side(i, i + 1), side(i - 1, i + 1)];
    const half = (a + b + c) / 2;
    const area = Math.sqrt(Math.max(half * (half - a) * (half - b) * (half - c), 0));
    if (a * b * c > 0) samples.push({ x: runs[i], y: (4 * area) / (a * b * c) });
  }
  return { label: 'Curvature', samples };
}
