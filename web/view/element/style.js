/** The look of <surface-path>, as one constructed sheet for all of a document: a strict Content-Security-Policy allows it. Custom properties are what a page may set. */

import { PATH, START, SURFACE } from '../colours.js';

const CSS = /* css */ `
:host {
  --surface: var(--surfpath-surface, ${SURFACE});
  --line: var(--surfpath-line, ${PATH});
  --start: var(--surfpath-start, ${START});
  --halo: var(--surfpath-halo, #fbfbf9);
  --ink: var(--surfpath-ink, #23282d);
  --paper: var(--surfpath-paper, linear-gradient(#fbfbf9, #e9ecec));
  position: relative;
  display: block;
  aspect-ratio: 4 / 3;
  min-width: 120px;
  overflow: hidden;
  contain: content;
  border-radius: 8px;
  background: var(--paper);
  color: var(--ink);
  font: 14px/1.4 system-ui, sans-serif;
  /* That one has ended tells that a page has changed a colour. */
  transition: --surface 1ms, --line 1ms, --start 1ms, --halo 1ms;
  transition-behavior: allow-discrete;
}
:host([hidden]) { display: none; }
canvas { position: absolute; inset: 0; width: 100%; height: 100%; }
p {
  box-sizing: border-box;
  position: absolute;
  left: 12px;
  bottom: 10px;
  max-width: calc(100% - 24px);
  margin: 0;
  padding: 1px 8px;
  border-radius: 6px;
  background: color-mix(in srgb, var(--halo) 78%, transparent);
  font-variant-numeric: tabular-nums;
  pointer-events: none;
}
p:empty { display: none; }
@media (prefers-color-scheme: dark) {
  :host {
    --surface: var(--surfpath-surface, #99a4ae);
    --line: var(--surfpath-line, #ff7a45);
    --start: var(--surfpath-start, #6aa3ff);
    --halo: var(--surfpath-halo, #14181c);
    --ink: var(--surfpath-ink, #e8ebed);
    --paper: var(--surfpath-paper, linear-gradient(#23292f, #14181c));
  }
}
`;

/** One for each document: no other takes it. @type {WeakMap<Document, CSSStyleSheet>} */ const sheets = new WeakMap();

/** @param {ShadowRoot} root */
export function adoptStyle(root) {
  const { ownerDocument } = root;
  const sheet = sheets.get(ownerDocument) ?? new (ownerDocument.defaultView ?? globalThis).CSSStyleSheet();
  if (!sheets.has(ownerDocument)) sheet.replaceSync(CSS);
  sheets.set(ownerDocument, sheet);
  root.adoptedStyleSheets = [sheet];
}

/** @typedef {Record<'surface' | 'line' | 'start' | 'halo', string>} Theme colours */

/** @param {Element} element @returns {Theme} */
export function readTheme(element) {
  const style = getComputedStyle(element);
  const colour = (/** @type {string} */ name) => style.getPropertyValue(`--${name}`).trim();
  return { surface: colour('surface'), line: colour('line'), start: colour('start'), halo: colour('halo') };
}
