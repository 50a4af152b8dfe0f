/** Plays a number from 0 to 1 in a fixed time, slow at both ends; at once for readers who asked for less motion. */

const DURATION = 1200;

const ease = (/** @type {number} */ t) => (t < 0.5 ? 4 * t * t * t : 1 - (2 - 2 * t) ** 3 / 2);

export class Player {
  #show;
  #frame = 0;

  /** @param {(moment: number) => void} show */
  constructor(show) {
    this.#show = show;
  }

  play() {
    this.stop();
    if (matchMedia('(prefers-reduced-motion: reduce)').matches) return this.#show(1);
    const begin = performance.now();
    const step = (/** @type {number} */ now) => {
      const t = Math.min(Math.max((now - begin) / DURATION, 0), 1);
      this.#show(ease(t));
      if (t < 1) this.#frame = requestAnimationFrame(step);
    };
    this.#frame = requestAnimationFrame(step);
    this.#show(0);
  }

  stop() {
    cancelAnimationFrame(this.#frame);
  }
}
