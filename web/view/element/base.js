/** What <surface-path> is before it shows anything: an element whose attributes frameworks may set as properties, and whose events have types. A class of nothing where there are no elements. */

/** @typedef {import('../element.js').SurfacePathElement} SurfacePathElement */
/** @typedef {import('../../path.js').Path} Path */

const Base = /** @type {typeof HTMLElement} */ (globalThis.HTMLElement ?? Object);

/** Set or taken away. @param {Element} element @param {string} name @param {string | null | undefined} value */
export function reflect(element, name, value) {
  if (value === null || value === undefined) element.removeAttribute(name);
  else element.setAttribute(name, value);
}

/** What was set before the element was defined does not reach its setters: set it again. @param {any} element */
export function adopt(element) {
  for (const name of ['definition', 'from', 'to', 'path', 'animate']) {
    if (!Object.hasOwn(element, name)) continue;
    const value = element[name];
    delete element[name];
    element[name] = value;
  }
}

export class TypedElement extends Base {
  /**
   * @overload @param {'path'} type @param {(this: SurfacePathElement, event: CustomEvent<Path>) => void} listener @param {boolean | AddEventListenerOptions} [options]
   * @returns {void}
   */
  /**
   * @overload @param {'error'} type @param {(this: SurfacePathElement, event: CustomEvent<Error>) => void} listener @param {boolean | AddEventListenerOptions} [options]
   * @returns {void}
   */
  /**
   * @template {keyof HTMLElementEventMap} K
   * @overload @param {K} type @param {(this: SurfacePathElement, event: HTMLElementEventMap[K]) => void} listener @param {boolean | AddEventListenerOptions} [options]
   * @returns {void}
   */
  /**
   * @overload @param {string} type @param {EventListenerOrEventListenerObject | null} listener @param {boolean | AddEventListenerOptions} [options]
   * @returns {void}
   */
  /** As everywhere; here the types know what events of the element bring. @param {string} type @param {any} listener @param {boolean | AddEventListenerOptions} [options] */
  addEventListener(type, listener, options) {
    super.addEventListener(type, listener, options);
  }
}

/* The attribute `animate` has the name of a method of all elements. React sets attributes as properties where there are such: set, it is the attribute. */
Object.defineProperty(TypedElement.prototype, 'animate', {
  configurable: true,
  get: () => Base.prototype.animate,
  /** @this {TypedElement} @param {unknown} on */
  set(on) {
    this.toggleAttribute('animate', on !== null && on !== undefined && on !== false);
  },
});
