/** Who the wheel is for, where a view stands in a page that scrolls: nobody is held on the way past it. */

/**
 * The wheel scrolls the page, unless the view was pressed since the pointer came, or with Ctrl.
 * @param {HTMLElement} canvas what the controls listen to @param {() => { enableZoom: boolean } | null} controls those that there are at the time
 * @param {{ signal?: AbortSignal, scrolls?: () => boolean }} [options] until when, and whether the page scrolls
 */
export function shareWheel(canvas, controls, { signal, scrolls = () => true } = {}) {
  let isPressed = false;
  const allow = (/** @type {boolean} */ zooms) => {
    const present = controls();
    if (present) present.enableZoom = zooms;
  };
  const press = () => {
    isPressed = true;
    // Two fingers pinch.
    allow(true);
  };
  const leave = () => {
    isPressed = false;
  };
  const weigh = (/** @type {WheelEvent} */ event) => allow(isPressed || event.ctrlKey || event.metaKey || !scrolls());
  const options = { capture: true, ...(signal ? { signal } : {}) };
  canvas.addEventListener('pointerdown', press, options);
  canvas.addEventListener('pointerleave', leave, options);
  canvas.addEventListener('wheel', weigh, options);
}
