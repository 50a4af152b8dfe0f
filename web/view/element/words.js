/** What <surface-path> says in words: the length of a path, or why there is none. */

/** @typedef {import('../../path.js').Path} Path */

/** So many digits, or all before the point. */
const DIGITS = 5;

/** @type {Partial<Record<import('../../path.js').Status, string>>} */
const PROBLEMS = {
  disconnected: 'No path: the ends lie on different pieces of the surface.',
  'singular-metric': 'No path: the surface is not smooth on the way, or its metric not positive definite.',
  'sheet-jump': 'No path: its chords left the surface.',
  'off-surface': 'No path: an end does not lie on the surface.',
  'not-finite': 'No path: the formula has no value on the way.',
  'out-of-memory': 'No path: it takes too much memory.',
};

/** @param {number} length */
const format = (length) => Number(length < 10 ** DIGITS ? length.toPrecision(DIGITS) : length.toFixed());

/** @param {Path} path */
export function describePath({ status, converged, length }) {
  if (Number.isNaN(length)) return PROBLEMS[status] ?? 'No path.';
  return converged ? `Length ${format(length)}` : `Length about ${format(length)} (${status.replaceAll('-', ' ')})`;
}

/** Whether there is no WebGL: three says so, or it made no context. @param {Error} error */
const isWebGL = ({ message }) => /WebGL/.test(message);

/** @param {Error} error @param {Path | null} path that was found all the same */
export function describeProblem(error, path) {
  if (isWebGL(error)) return `${path ? `${describePath(path)}. ` : ''}No picture: this browser shows no 3D graphics (WebGL).`;
  if (/WebAssembly/.test(error.message)) return 'No path: this browser cannot run the solver (WebAssembly).';
  return error.message;
}
