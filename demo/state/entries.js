/** Everything that the page can open: the library's gallery, the paper's measures of length, abstract metrics, and formulas of one's own. Plain data. */

import { gallery } from 'surfpath/gallery';
import { KINDS } from './kinds.js';

/** @typedef {import('./kinds.js').Kind} Kind */
/** As an entry of the library's gallery. @typedef {import('surfpath/gallery').Description} Description */
/** @typedef {{ density?: string, metric?: { E: string, F: string, G: string }, parameters?: Readonly<Record<string, number>> }} Measure */
/** @typedef {Omit<Description, 'formula' | 'camera'> & { camera?: readonly number[] } & Measure & { kind: Kind } & Record<string, any>} Entry */

/** A square of the plane, seen from above. */
const PLATE = /** @type {const} */ ({ kind: 'parametric', x: 'u', y: 'v', z: '0', u: [-2, 2], v: [-2, 2], camera: [0, -0.5, 0.866] });

/** A metric that counts all directions alike. @param {string} factor */
const conformal = (factor) => ({ E: factor, F: '0', G: factor });

/** Length measured otherwise than by space. @type {Record<string, Entry>} */
const MEASURES = {
  hindered: {
    ...PLATE,
    title: 'Slow hill (Fig. 5a)',
    source: 'Liu, Xiao, Meng, Fig. 5a: a plane whose middle is hard to cross',
    density: '1+h*exp(-(u^2+v^2)/s)',
    parameters: { h: 3, s: 0.32 },
    from: [1.3, 1.1],
    to: [-1.3, -1.05],
  },
  grained: {
    ...PLATE,
    title: 'Turning grain (Fig. 5b)',
    source: 'Liu, Xiao, Meng, Fig. 5b: short along a grain that turns',
    metric: {
      E: '9*cos(u+k*v)^2+sin(u+k*v)^2',
      F: '8*sin(u+k*v)*cos(u+k*v)',
      G: '9*sin(u+k*v)^2+cos(u+k*v)^2',
    },
    parameters: { k: 0.7 },
    from: [-1.5, -1.2],
    to: [1.5, 1.1],
  },
  lake: {
    ...PLATE,
    title: 'Round a lake',
    source: 'a density that jumps: dear inside, so that paths follow the shore',
    density: '1+d/2*(1+sign(r+0.3*cos(3*atan2(v,u))-hypot(u,v)))',
    parameters: { d: 4, r: 0.9 },
    from: [-1.7, -0.5],
    to: [1.65, 0.9],
  },
  halfPlane: {
    kind: 'metric',
    title: 'Hyperbolic half-plane',
    source: 'H. Poincaré: its shortest paths are arcs of circles',
    ...conformal('1/v^2'),
    u: [-3, 3],
    v: [0.15, 4],
    from: [-2.2, 0.5],
    to: [2.3, 0.7],
    camera: [0, 0, 1],
  },
  hyperbolicDisc: {
    kind: 'metric',
    title: 'Poincaré disc',
    source: 'the hyperbolic plane in a disc; here a square of it',
    ...conformal('4/(1-u^2-v^2)^2'),
    u: [-0.68, 0.68],
    v: [-0.68, 0.68],
    from: [-0.6, -0.5],
    to: [0.62, -0.3],
    camera: [0, 0, 1],
  },
};

/** What a formula of one's own starts from. @type {Record<Kind, Entry>} */
const OWN = {
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
  metric: own({ kind: 'metric', E: '1+2*exp(-(u^2+v^2))', F: 0, G: '1', u: [-2, 2], v: [-2, 2], from: [-1.5, -0.3], to: [1.6, 0.4] }),
};

/** @param {any} definition @returns {Entry} */
function own(definition) {
  return { title: `Your own, ${KINDS[/** @type {Kind} */ (definition.kind)].title.toLowerCase()}`, formula: '', source: '', ...definition };
}

/** By name; those of one's own are called own- and their kind. @type {Readonly<Record<string, Entry>>} */
export const ENTRIES = {
  .../** @type {Record<string, Entry>} */ (/** @type {unknown} */ (gallery)),
  ...MEASURES,
  ...Object.fromEntries(Object.values(OWN).map((entry) => [`own-${entry.kind}`, entry])),
};

/** Groups of the gallery, with the names in them. @type {[string, string[]][]} */
export const GROUPS = [
  ['Formulas of u and v', namesOf(({ kind }) => !['implicit', 'metric'].includes(kind))],
  ['Where f(x, y, z) = 0', namesOf(({ kind }) => kind === 'implicit')],
  ['Other measures of length', Object.keys(MEASURES)],
];

/** @param {(entry: Entry) => boolean} test */
function namesOf(test) {
  return Object.keys(gallery).filter((name) => test(ENTRIES[name]));
}
