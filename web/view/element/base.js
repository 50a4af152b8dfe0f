/** What <surface-path> is before it shows anything: an element whose attributes frameworks may set as properties. A class of nothing where there are no elements. */

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

export class BaseElement extends Base {}

/* The attribute `animate` has the name of a method of all elements. React sets attributes as properties where there are such: set, it is the attribute. */
Object.defineProperty(BaseElement.prototype, 'animate', {
  configurable: true,
  get: () => Base.prototype.animate,
  /** @this {BaseElement} @param {unknown} on */
  set(on) {
    this.toggleAttribute('animate', on !== null && on !== undefined && on !== false);
  },
});
