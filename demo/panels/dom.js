/** The few lines of DOM that the page's modules share. */

/** The element with an id; the page's own html has it. @template {HTMLElement} [T=HTMLElement] @param {string} id @returns {T} */
export function find(id) {
  const element = document.getElementById(id);
  if (!element) throw new Error(`The page has no element “${id}”`);
  return /** @type {T} */ (element);
}

/**
 * A new element.
 * @template {keyof HTMLElementTagNameMap} T
 * @param {T} tag @param {Record<string, unknown>} properties @param {(Node | string)[]} children
 * @returns {HTMLElementTagNameMap[T]}
 */
export function create(tag, properties = {}, ...children) {
  const element = Object.assign(document.createElement(tag), properties);
  element.append(...children);
  return element;
}

/** Shows a text, or hides its place. @param {HTMLElement} element @param {string | null} text */
export function say(element, text) {
  element.hidden = !text;
  if (element.textContent !== (text ?? '')) element.textContent = text ?? '';
}

/** @param {string} name of a colour in the style sheet */
export const themeColor = (name) => getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
