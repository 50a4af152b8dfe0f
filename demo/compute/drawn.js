/** What stands for an abstract metric in space: the plane of its parameters. */

/** @typedef {import('surfpath').Surface} Surface */
/** @typedef {import('surfpath').Path} Path */

/** What is drawn of a surface: itself, or, of a metric, the plane of its parameters. @param {import('surfpath').Surfpath} surfpath @param {Surface} surface @param {any} definition */
export function drawnOf(surfpath, surface, { u, v, parameters }) {
  return surface.kind === 'metric' ? surfpath.parametric({ x: 'u', y: 'v', z: 0, u, v, parameters, periodic: {} }) : surface;
}

/** Positions of a path: its own, or, without any, its parameters in the plane. @param {Path} path */
export function placesOf({ points, parameters }) {
  if (points.length > 0 || !parameters) return points;
  const places = new Float64Array((3 * parameters.length) / 2);
  for (let i = 0; i < parameters.length / 2; i++) places.set(parameters.subarray(2 * i, 2 * i + 2), 3 * i);
  return places;
}
