/** The kinds of surfaces that the form knows: which fields each has, and what a formula of one's own starts from. Plain data. */

/** @typedef {'parametric' | 'implicit' | 'graph' | 'revolution' | 'tube' | 'sweep'} Kind */
/**
 * @typedef {object} Form of a kind of surface
 * @property {string} title
 * @property {string} hint
 * @property {Record<string, string>} formulas labels of the fields by name; `name[i]` is an element of a list of formulas
 * @property {string[]} ranges variables that have one
 * @property {string[]} coordinates of a point on the surface
 */

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
};

/** @type {Record<Kind, import('surfpath/gallery').GalleryEntry>} */
export const OWN = {
  parametric: own({
    kind: 'parametric',
    x: 'u',
    y: 'v',
    z: 'sin(u)*cos(v)',
    u: ['-pi', 'pi'],
    v: ['-pi', 'pi'],
    from: [-2.2, -1.5],
    to: [2.4, 1.2],
  }),
  implicit: own({
    kind: 'implicit',
    f: 'x^4+y^4+z^4-1',
    bounds: [
      [-1.2, 1.2],
      [-1.2, 1.2],
      [-1.2, 1.2],
    ],
    from: [0.2, -0.9, 0.6],
    to: [0.9, 0.3, 0.6],
  }),
  graph: own({ kind: 'graph', z: '0.6*cos(2*x)*cos(y)', x: [-2.5, 2.5], y: [-2.5, 2.5], from: [-1.9, -1.2], to: [1.8, 1.4] }),
  revolution: own({ kind: 'revolution', r: '1+0.3*sin(3*t)', z: 't', t: ['-pi/2', 'pi/2'], from: [5.6, -1.2], to: [3.6, 1.3] }),
  tube: own({
    kind: 'tube',
    centreline: ['2*cos(t)', '2*sin(t)', '0.5*t'],
    radius: '0.5',
    t: [0, '3*pi'],
    from: [1.2, 1],
    to: [4.4, 8],
  }),
  sweep: own({
    kind: 'sweep',
    profile: ['s', '0.3*cos(3*s)'],
    path: ['t', '0.5*sin(t)', '0'],
    s: [-1, 1],
    t: [0, 6],
    from: [-0.7, 0.5],
    to: [0.8, 5.4],
    camera: [0.24, -0.6, 0.76],
  }),
};

/**
 * @template {object} T
 * @param {T} definition
 */
function own(definition) {
  return { title: '', formula: '', source: '', ...definition };
}
