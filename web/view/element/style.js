/** The look of <surface-path>, as one constructed sheet for all of a document: a strict Content-Security-Policy allows it. Custom properties are what a page may set. */

import { PATH, START, SURFACE } from '../colours.js';

/**
 * The canvas has a border that is not there: of it the browser says what colours those are, whatever a page calls them; that its transition has ended tells
 * that a page has changed one. Of a picture that is not what was asked for little is left. A long complaint is scrolled in a small element. Paper is white: dark is for screens.
 */
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
  container-type: inline-size;
  border-radius: 8px;
  background: var(--paper);
  color: var(--ink);
  font: 14px/1.4 system-ui, sans-serif;
}
:host([hidden]) { display: none; }
canvas {
  position: absolute;
  inset: 0;
  width: 100%;
  height: 100%;
  border: 0 solid;
  border-color: var(--surface) var(--line) var(--start) var(--halo);
  forced-color-adjust: none;
  transition: border-color 1ms;
}
canvas:focus-visible { outline: 2px solid var(--line); outline-offset: -2px; border-radius: inherit; }
p {
  box-sizing: border-box;
  position: absolute;
  left: min(12px, 4%);
  bottom: min(10px, 4%);
  max-width: 92%;
  max-height: calc(100% - 20px);
  overflow: auto;
  margin: 0;
  padding: 0.1em 0.5em;
  border-radius: 6px;
  background: color-mix(in srgb, var(--halo) 78%, transparent);
  font-size: clamp(10px, 10cqw, 1em);
  font-variant-numeric: tabular-nums;
  overflow-wrap: anywhere;
  pointer-events: none;
}
p[data-problem] { pointer-events: auto; }
canvas[data-problem] { opacity: 0.3; }
p:empty { display: none; }
@media screen and (prefers-color-scheme: dark) {
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

/** @typedef {Record<'surface' | 'line' | 'start' | 'halo', string>} Theme colours, as three.js reads them */

/** @param {HTMLCanvasElement} canvas in a root that has adopted the style @returns {Theme} */
export function readTheme(canvas) {
  const { borderTopColor, borderRightColor, borderBottomColor, borderLeftColor } = getComputedStyle(canvas);
  const [surface, line, start, halo] = [borderTopColor, borderRightColor, borderBottomColor, borderLeftColor].map(toBytes);
  return { surface, line, start, halo };
}

/** Browsers answer in bytes what was asked for in bytes; three.js knows nothing else, and warns of rgba(…). @param {string} colour as computed: rgb(…), or oklch(…), color(…) and their like */
function toBytes(colour) {
  const context = colour.startsWith('rgb(') ? null : new OffscreenCanvas(1, 1).getContext('2d');
  if (!context) return colour;
  context.fillStyle = colour;
  context.fillRect(0, 0, 1, 1);
  const [red, green, blue] = context.getImageData(0, 0, 1, 1).data;
  return `rgb(${red}, ${green}, ${blue})`;
}
