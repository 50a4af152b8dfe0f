/** What happens to an element from outside: it comes on screen, it is resized or printed, the reader's colours or the page's change. */

import { watchPixels } from '../pixels.js';

/**
 * Calls back until the signal is aborted, the first time soon.
 * @param {HTMLElement} element @param {AbortSignal} signal
 * @param {{ see: (isVisible: boolean) => void, resize: () => void, repaint: () => void, print: () => void }} on
 */
export function watch(element, signal, { see, resize, repaint, print }) {
  const seen = new IntersectionObserver((entries) => see(entries.at(-1)?.isIntersecting ?? false));
  for (const observer of [seen, new ResizeObserver(resize)]) {
    observer.observe(element);
    signal.addEventListener('abort', () => observer.disconnect());
  }
  watchPixels(resize, signal);
  addEventListener('beforeprint', print, { signal });
  // It does not leave the shadow tree.
  element.shadowRoot?.addEventListener('transitionend', repaint, { signal });
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', repaint, { signal });
}
