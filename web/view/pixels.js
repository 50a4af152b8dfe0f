/**
 * Tells when a CSS pixel has become more or fewer of the screen's, which changes no size of the layout: on another screen, or where the reader zooms.
 * @param {() => void} tell @param {AbortSignal} [signal] until when
 */
export function watchPixels(tell, signal) {
  const again = () => {
    tell();
    watchPixels(tell, signal);
  };
  matchMedia(`(resolution: ${devicePixelRatio}dppx)`).addEventListener('change', again, { once: true, ...(signal ? { signal } : {}) });
}
