/** Plays how a path converges: the iterates that `record` kept, one melting into the next, from cool to warm. */

import { Color } from 'three';
import { checkBoolean, checkOptions, refuse, refuseNumber } from '../arguments.js';
import { readPoints, setColours } from './check.js';
import { PATH, START } from './colours.js';

/** @typedef {import('../path.js').Path} Path */

/**
 * @typedef {object} PathPlayerOptions
 * @property {number} [duration] in milliseconds, ≥ 0, default 1200
 * @property {import('three').ColorRepresentation} [cool] colour of the start, default a blue
 * @property {import('three').ColorRepresentation} [warm] colour of the converged path, default an orange-red
 * @property {boolean} [reducedMotion] show the final path at once; default: what the reader's system asks for
 * @property {(moment: number, iteration: number) => void} [onFrame] after each change: draw again; moment in [0, 1]
 */

const NAMES = ['duration', 'cool', 'warm', 'reducedMotion', 'onFrame'];

/** Slow at both ends. @param {number} t in [0, 1] */
const ease = (t) => (t < 0.5 ? 4 * t * t * t : 1 - (2 - 2 * t) ** 3 / 2);

/**
 * A polyline through the same places with another number of points, equally spaced by length.
 * @param {ArrayLike<number>} points x y z … @param {number} count at least 2
 */
function resample(points, count) {
  const pieces = points.length / 3 - 1;
  const reached = new Float64Array(pieces + 1);
  for (let i = 0; i < pieces; i++) {
    const [dx, dy, dz] = [0, 1, 2].map((k) => points[3 * i + 3 + k] - points[3 * i + k]);
    reached[i + 1] = reached[i] + Math.hypot(dx, dy, dz);
  }
  const result = new Float64Array(3 * count);
  for (let i = 0, piece = 0; i < count; i++) {
    const target = (i / (count - 1)) * reached[pieces];
    while (piece < pieces - 1 && reached[piece + 1] < target) piece++;
    const share = Math.min((target - reached[piece]) / (reached[piece + 1] - reached[piece]) || 0, 1);
    for (let k = 0; k < 3; k++) result[3 * i + k] = (1 - share) * points[3 * piece + k] + share * points[3 * piece + 3 + k];
  }
  return result;
}

export class PathPlayer {
  #line;
  #duration;
  #colours;
  #colour = new Color();
  /** @type {NonNullable<PathPlayerOptions['onFrame']>} */ #onFrame = () => {};
  /** @type {boolean | undefined} */ #reducedMotion;
  /** The iterates, all with as many points as the path; last the path itself, null where it was not found. None: it was let go of. @type {(Float64Array | null)[]} */ #frames =
    [];
  #request = 0;
  /** @type {(() => void) | null} */ #finish = null;
  #moment = 1;

  /**
   * @param {import('./line.js').GeodesicLine} line that shows it; stays the caller's
   * @param {Path | null} path of `shortestPath(…, { record: true })`; without `record` there is only the end to play
   * @param {PathPlayerOptions} [options]
   */
  constructor(line, path, options = {}) {
    if (typeof line?.setPath !== 'function') refuse('PathPlayer: line', 'a GeodesicLine', line);
    checkOptions('PathPlayer', options, NAMES);
    const { duration = 1200, cool = START, warm = PATH, reducedMotion, onFrame = () => {} } = options;
    if (!(duration >= 0 && duration < Infinity))
      refuseNumber('PathPlayer: options.duration', 'a finite number that is not negative', duration);
    if (typeof onFrame !== 'function') refuse('PathPlayer: options.onFrame', 'a function', onFrame);
    if (reducedMotion !== undefined) checkBoolean('PathPlayer', 'reducedMotion', reducedMotion);
    this.#line = line;
    this.#duration = duration;
    this.#colours = { cool: new Color(cool), warm: new Color(warm) };
    this.#reducedMotion = reducedMotion;
    this.setPath(path);
    // From now on: who makes the player is not ready to draw yet.
    this.#onFrame = onFrame;
  }

  /** How many iterates there are to show before the path itself. */
  get iterations() {
    return Math.max(this.#frames.length - 1, 0);
  }

  /** In [0, 1]: 1 is the path itself. */
  get moment() {
    return this.#moment;
  }

  /** Takes another path, and shows it. @param {Path | null} path */
  setPath(path) {
    this.stop();
    const points = readPoints('PathPlayer', path);
    const iterates = (path?.history ?? []).flatMap((iterate) => (iterate.points && iterate.points.length >= 6 ? [iterate.points] : []));
    this.#frames = points ? [...iterates, points].map((frame) => resample(frame, points.length / 3)) : [null];
    // The path itself as it is: its points may be spaced otherwise.
    if (points) this.#frames[this.#frames.length - 1] = Float64Array.from(points);
    this.scrub(1);
  }

  /**
   * Shows a moment of the convergence.
   * @param {number} moment in [0, 1], from the start to the path
   */
  scrub(moment) {
    if (!(moment >= 0 && moment <= 1)) refuseNumber('PathPlayer: moment', 'a number between 0 and 1', moment);
    this.#moment = moment;
    const place = moment * this.iterations;
    const first = Math.max(Math.ceil(place) - 1, 0);
    const [before, after] = this.#frames.slice(first);
    if (before === undefined) return;
    const share = place - first;
    const { cool, warm } = this.#colours;
    this.#line.setPath(before && after ? before.map((x, i) => (1 - share) * x + share * after[i]) : before);
    this.#line.setColours({ colour: this.#colour.lerpColors(cool, warm, after ? moment : 1) });
    this.#onFrame(moment, Math.round(place));
  }

  /** What is not named stays. @param {{ cool?: import('three').ColorRepresentation, warm?: import('three').ColorRepresentation }} colours */
  setColours(colours) {
    setColours(this.#colours, colours);
    this.scrub(this.#moment);
  }

  /**
   * Plays from the start.
   * @returns {Promise<void>} when it has ended, or was stopped
   */
  play() {
    this.stop();
    const isReduced = this.#reducedMotion ?? globalThis.matchMedia?.('(prefers-reduced-motion: reduce)').matches ?? false;
    if (isReduced || this.iterations === 0) {
      this.scrub(1);
      return Promise.resolve();
    }
    return new Promise((resolve) => {
      this.#finish = resolve;
      /** @type {number | null} */ let begin = null;
      const step = (/** @type {number} */ now) => {
        begin ??= now;
        const share = this.#duration > 0 ? Math.min((now - begin) / this.#duration, 1) : 1;
        // Before it is shown: onFrame may stop it, or play again.
        if (share < 1) this.#request = requestAnimationFrame(step);
        else this.stop();
        this.scrub(ease(share));
      };
      this.#request = requestAnimationFrame(step);
      this.scrub(0);
    });
  }

  /** Stops where it is. */
  stop() {
    if (this.#finish) cancelAnimationFrame(this.#request);
    this.#finish?.();
    this.#finish = null;
  }

  /** Stops, and shows the end. */
  finish() {
    this.stop();
    this.scrub(1);
  }

  /** Stops and lets go of the frames; the line stays the caller's. */
  dispose() {
    this.stop();
    this.#frames = [];
  }
}
