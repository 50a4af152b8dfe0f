/** The plane of the parameters beside the view: drawn anew with the state, pointed at, and its ends dragged. */

import { change } from '../state/change.js';
import { find, say } from '../panels/dom.js';
import { onHover, setHover } from '../state/hover.js';
import { inside } from '../state/lifts.js';
import { onRender, state } from '../state/state.js';
import { frameOf } from './plane-frame.js';
import { NO_PLANE, picture } from './plane-picture.js';

/** @typedef {import('./plane-frame.js').Frame} Frame */

/** @type {{ frame: Frame, handles: SVGElement[] } | null} */ let drawn = null;
let held = -1;

export function startPlane() {
  const place = find('plane');
  place.addEventListener('pointerdown', (event) => {
    const handle = /** @type {Element} */ (event.target).closest('[data-end]');
    if (!handle) return;
    held = Number(handle.getAttribute('data-end'));
    place.setPointerCapture(event.pointerId);
    event.preventDefault();
  });
  place.addEventListener('pointermove', (event) => (held < 0 ? pointAt(event) : drag(event)));
  place.addEventListener('pointerleave', () => setHover(null));
  for (const type of ['pointerup', 'pointercancel', 'lostpointercapture'])
    place.addEventListener(type, () => {
      held = -1;
    });
  find('plane-card').addEventListener('toggle', renderPlane);
  onRender(renderPlane);
  onHover(renderHover);
}

/** The parameters at a place of the window. @param {PointerEvent} event @returns {number[] | null} */
function parametersAt({ clientX, clientY }) {
  const picture = find('plane').querySelector('svg');
  if (!drawn || !picture) return null;
  const { x, y } = new DOMPoint(clientX, clientY).matrixTransform(picture.getScreenCTM()?.inverse());
  return drawn.frame.from([x, y]);
}

/** @param {PointerEvent} event */
function pointAt(event) {
  const parameters = event.pointerType === 'touch' ? null : parametersAt(event);
  const { low, high } = drawn?.frame ?? { low: [], high: [] };
  const isInside = parameters?.every((x, k) => x >= low[k] && x <= high[k]);
  setHover(isInside ? { place: null, parameters, run: null } : null);
}

/** Marks what is pointed at, here or elsewhere. @param {import('../state/hover.js').Hover | null} hover */
function renderHover(hover) {
  const dot = find('plane').querySelector('.hover');
  if (!drawn || !dot) return;
  dot.toggleAttribute('hidden', !hover?.parameters);
  if (!hover?.parameters) return;
  const [x, y] = drawn.frame.to(inside(drawn.frame.domain, hover.parameters));
  for (const [name, value] of [
    ['cx', x],
    ['cy', y],
  ])
    dot.setAttribute(String(name), String(value));
}

/** @param {PointerEvent} event */
function drag(event) {
  const at = parametersAt(event);
  if (!at || !drawn || state.building) return;
  const { low, high, periodic } = drawn.frame;
  const point = at.map((x, i) => (periodic[i] ? x : Math.min(Math.max(x, low[i]), high[i])));
  change({ ends: state.sketch.ends.map((end, i) => (i === held ? point : end)) }, `plane ${held}`);
}

function renderPlane() {
  const { domain } = state.surface ?? { domain: null };
  say(find('plane-hint'), domain ? 'The ends can be dragged here too.' : state.surface ? NO_PLANE : null);
  if (!(/** @type {HTMLDetailsElement} */ (find('plane-card')).open)) return;
  if (!domain) {
    drawn = null;
    return find('plane').replaceChildren();
  }
  const frame = frameOf(domain);
  const { root, handles } = picture(frame);
  drawn = { frame, handles };
  find('plane').replaceChildren(root);
}
