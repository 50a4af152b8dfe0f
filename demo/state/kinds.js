/** The kinds of surfaces that the form knows: which fields each has, and what a formula of one's own starts from. Plain data. */

/** @typedef {import('surfpath').AnyDefinition['kind']} Kind */
/**
 * @typedef {object} Form of a kind of surface
 * @property {string} title
 * @property {string} hint
 * @property {Record<string, string>} formulas labels of the fields by name; `name[i]` is an element of a list of formulas
 * @property {string[]} ranges variables that have one
 * @property {string[]} coordinates of a point on the surface
 */

/** Entries of a metric in place of that of space: of u and v, or, on an implicit surface, of x, y, z. @param {Kind} kind */
export const tensorNames = (kind) => (kind === 'implicit' ? ['xx', 'xy', 'xz', 'yy', 'yz', 'zz'] : ['E', 'F', 'G']);

/** @type {Record<Kind, Form>} */
export const KINDS = {
  parametric: {
    title: 'Parametric',
    hint: 'Each point is computed from two parameters u and v',
    formulas: { x: 'x(u, v)', y: 'y(u, v)', z: 'z(u, v)' },
    ranges: ['u', 'v'],
    coordinates: ['u', 'v'],
  },
  implicit: {
    title: 'Implicit',
    hint: 'All points where f(x, y, z) = 0',
    formulas: { f: 'f(x, y, z) = 0' },
    ranges: ['x', 'y', 'z'],
    coordinates: ['x', 'y', 'z'],
  },
  graph: {
    title: 'Graph',
    hint: 'A height z over each point x, y of a rectangle',
    formulas: { z: 'z(x, y)' },
    ranges: ['x', 'y'],
    coordinates: ['x', 'y'],
  },
  revolution: {
    title: 'Revolution',
    hint: 'A profile turned about the z axis; u is the angle',
    formulas: { r: 'r(t), distance from the axis', z: 'z(t), height' },
    ranges: ['t'],
    coordinates: ['u', 't'],
  },
  tube: {
    title: 'Tube',
    hint: 'Circles across a curve; u is the angle',
    formulas: {
      'centreline[0]': 'x(t) of the centreline',
      'centreline[1]': 'y(t) of the centreline',
      'centreline[2]': 'z(t) of the centreline',
      radius: 'radius(t), also over the angle u',
    },
    ranges: ['t'],
    coordinates: ['u', 't'],
  },
  sweep: {
    title: 'Sweep',
    hint: 'A profile carried along a path',
    formulas: {
      'profile[0]': 'left(s) of the profile, also over t',
      'profile[1]': 'up(s) of the profile, also over t',
      'path[0]': 'x(t) of the path',
      'path[1]': 'y(t) of the path',
      'path[2]': 'z(t) of the path',
    },
    ranges: ['s', 't'],
    coordinates: ['s', 't'],
  },
  metric: {
    title: 'Metric',
    hint: 'No surface in space: length is ds²\u00a0= E\u00a0du² + 2F\u00a0du\u00a0dv + G\u00a0dv²; drawn in the plane of u and v',
    formulas: { E: 'E(u, v)', F: 'F(u, v)', G: 'G(u, v)' },
    ranges: ['u', 'v'],
    coordinates: ['u', 'v'],
  },
};
