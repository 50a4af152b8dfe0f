/** A transparent button of the page that follows a point of a canvas: what is pressed, dragged, focused and moved by arrow keys. Knows no geometry. */

/**
 * @typedef {object} Gestures
 * @property {(x: number, y: number) => [number, number]} press at a place of the window; gives what to add to places from then on
 * @property {(x: number, y: number) => void} move while pressed
 * @property {() => void} release after a press, or after arrow keys
 * @property {(right: number, up: number) => void} nudge by an arrow key: steps
 * @property {(on: boolean) => void} highlight pointed at, pressed or focused, or no longer
 */

/** CSS pixels: what a mouse and what a finger can hit. */
const [FINE, COARSE] = [24, 44];
const FAST = 5;
const NAME = 'surfpath-handle';
/** @type {Record<string, [number, number]>} */
const ARROWS = { ArrowRight: [1, 0], ArrowLeft: [-1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

export class HandleButton {
  element = document.createElement('button');
  #canvas;
  #gestures;
  #size = FINE;
  /** The pointer that holds it. @type {number | null} */ #pointer = null;
  #offset = [0, 0];
  #isPointedAt = false;
  #isMoving = false;
  #listening = new AbortController();

  /** @param {HTMLElement} canvas after which it is put @param {string} label @param {Gestures} gestures */
  constructor(canvas, label, gestures) {
    this.#canvas = canvas;
    this.#gestures = gestures;
    this.element.type = 'button';
    this.element.className = NAME;
    this.element.setAttribute('aria-label', label);
    this.element.setAttribute('aria-description', 'Drag it, or use the arrow keys');
    Object.assign(this.element.style, {
      ...{ position: 'absolute', left: '0', top: '0', margin: '0', padding: '0', border: '0', borderRadius: '50%' },
      // The browser would take a finger's drag for scrolling.
      ...{ background: 'none', cursor: 'grab', touchAction: 'none', visibility: 'hidden' },
    });
    this.#resize(matchMedia('(pointer: coarse)').matches ? COARSE : FINE);
    this.#settleIn();
    this.#listen();
  }

  /** After those that are there: the tabulator goes from the first to the last. */
  #settleIn() {
    let last = this.#canvas;
    while (last.nextElementSibling?.classList.contains(NAME)) last = /** @type {HTMLElement} */ (last.nextElementSibling);
    last.after(this.element);
  }

  #listen() {
    const on = (/** @type {string} */ type, /** @type {(event: any) => void} */ listener) =>
      this.element.addEventListener(type, listener, { signal: this.#listening.signal });
    on('pointerdown', (event) => this.#press(event));
    on('pointermove', (event) => this.#drag(event));
    on('lostpointercapture', (event) => this.#release(event));
    on('pointerenter', (event) => this.#point(event, true));
    on('pointerleave', (event) => this.#point(event, false));
    on('focus', () => this.#highlight());
    on('blur', () => this.#settle());
    on('keydown', (event) => this.#key(event));
    on('keyup', () => this.#settle());
    on('wheel', (event) => this.#pass(event));
    on('contextmenu', (event) => event.preventDefault());
  }

  /** @param {PointerEvent} event */
  #press(event) {
    if (this.#pointer !== null || event.button !== 0) return;
    event.preventDefault();
    this.#pointer = event.pointerId;
    this.element.setPointerCapture(event.pointerId);
    this.element.focus({ preventScroll: true });
    this.element.style.cursor = 'grabbing';
    this.#offset = this.#gestures.press(event.clientX, event.clientY);
    this.#highlight();
  }

  /** @param {PointerEvent} event */
  #drag({ pointerId, clientX, clientY }) {
    if (pointerId === this.#pointer) this.#gestures.move(clientX + this.#offset[0], clientY + this.#offset[1]);
  }

  /** @param {{ pointerId: number }} event */
  #release({ pointerId }) {
    if (pointerId !== this.#pointer) return;
    this.#pointer = null;
    this.element.style.cursor = 'grab';
    this.#gestures.release();
    this.#highlight();
  }

  /** Ends a drag, as if it were let go: at once, where the browser tells that the pointer is lost with its next move. */
  letGo() {
    const pointerId = this.#pointer;
    if (pointerId === null) return;
    this.#release({ pointerId });
    this.element.releasePointerCapture(pointerId);
  }

  /** @param {PointerEvent} event @param {boolean} on */
  #point({ pointerType }, on) {
    this.#isPointedAt = on;
    this.#resize(pointerType === 'touch' ? COARSE : FINE);
    this.#highlight();
  }

  /** @param {KeyboardEvent} event */
  #key(event) {
    const arrow = ARROWS[event.key];
    if (!arrow || event.altKey || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    event.stopPropagation();
    this.#isMoving = true;
    const steps = event.shiftKey ? FAST : 1;
    this.#gestures.nudge(steps * arrow[0], steps * arrow[1]);
  }

  /** Ends a movement by keys. */
  #settle() {
    if (this.#isMoving) this.#gestures.release();
    this.#isMoving = false;
    this.#highlight();
  }

  #highlight() {
    // Focus by a mouse press is no reason to stay large; focus by the keyboard is.
    this.#gestures.highlight(this.#isPointedAt || this.#pointer !== null || this.element.matches(':focus-visible'));
  }

  /** The wheel turns what it turns beside the button. @param {WheelEvent} event */
  #pass(event) {
    const copy = new WheelEvent('wheel', event);
    if (!this.#canvas.dispatchEvent(copy)) event.preventDefault();
  }

  /** @param {number} size */
  #resize(size) {
    this.#size = size;
    Object.assign(this.element.style, { width: `${size}px`, height: `${size}px` });
  }

  /** @param {number} x in CSS pixels from the canvas's corner @param {number} y @param {boolean} seen whether that is inside the view */
  place(x, y, seen) {
    const { style, parentNode } = this.element;
    // The canvas may have come into a page since.
    if (!parentNode) this.#settleIn();
    const { offsetLeft, offsetTop, clientLeft, clientTop } = this.#canvas;
    const [left, top] = [offsetLeft + clientLeft + x - this.#size / 2, offsetTop + clientTop + y - this.#size / 2];
    style.visibility = seen || this.#pointer !== null ? 'visible' : 'hidden';
    if (seen) style.transform = `translate(${left.toFixed(1)}px, ${top.toFixed(1)}px)`;
  }

  dispose() {
    this.#listening.abort();
    if (this.#pointer !== null) this.#gestures.release();
    this.#pointer = null;
    this.element.remove();
  }
}
