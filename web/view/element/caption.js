/** The words in the element: a length, or what is wrong. They are the name of the picture, too, for those who do not see it. */

import { describePath, describeProblem } from './words.js';

/** @typedef {import('../../path.js').Path} Path */

export class Caption {
  /** What the surface is called. */
  title = 'Surface';
  element = document.createElement('p');
  #canvas;

  /** @param {HTMLCanvasElement} canvas of the picture */
  constructor(canvas) {
    this.#canvas = canvas;
    canvas.setAttribute('role', 'img');
    this.element.setAttribute('part', 'length');
    this.element.setAttribute('role', 'status');
  }

  /** Says why there is nothing to see yet, where nothing else is said. */
  wait() {
    if (!this.element.textContent) this.#say('Computing…', false);
  }

  /** Says the length, in place of any complaint. @param {Path | null} path */
  tell(path) {
    this.#say(path ? describePath(path) : '', false);
  }

  /** @param {Error} error @param {Path | null} path that was found all the same */
  complain(error, path) {
    this.#say(describeProblem(error, path), true);
  }

  /** @param {string} words @param {boolean} isProblem */
  #say(words, isProblem) {
    for (const part of [this.element, this.#canvas]) part.toggleAttribute('data-problem', isProblem);
    // The same words again would be read out again.
    if (words !== this.element.textContent) this.element.textContent = words;
    this.#canvas.setAttribute('aria-label', words ? `${this.title}. ${words}` : this.title);
  }
}
