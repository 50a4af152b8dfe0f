/**
 * Surfaces with names: plain data that `surfpath.surface(definition)` takes as it is.
 *
 * Every surface of Liu, Xiao, Meng ("the paper", with its equation's number), with the boxes and domains that its text gets wrong put right, and
 * others that are worth a look. This file computes nothing.
 */

/**
 * What an entry has besides its definition.
 *
 * @typedef {object} Description
 * @property {string} title
 * @property {string} formula for people: plain text
 * @property {string} source where the surface comes from
 * @property {readonly number[]} from a pair of points, [u, v] or [x, y, z] on the surface, whose shortest path …
 * @property {readonly number[]} to … visibly differs from the straight start (not on the cylinder and the sphere, where that is the path)
 * @property {readonly [number, number, number]} [camera] unit vector towards a good place to look from, z upwards
 */

/** @template T @typedef {T extends object ? { readonly [K in keyof T]: Frozen<T[K]> } : T} Frozen */
/** @typedef {import('./instance.js').AnyDefinition} AnyDefinition */
/** @typedef {Extract<AnyDefinition, { kind: 'implicit' }>} ImplicitDefinition */
/** @typedef {ImplicitDefinition & Required<Pick<ImplicitDefinition, 'bounds'>>} BoundedDefinition */
/** @typedef {Readonly<Description & (Exclude<AnyDefinition, { kind: 'implicit' | 'metric' }> | BoundedDefinition)>} GalleryEntry */

/** @type {(half: number) => readonly [readonly [number, number], readonly [number, number], readonly [number, number]]} */
const cube = (half) => [
  [-half, half],
  [-half, half],
  [-half, half],
];

/* The paper's Eq. 43 multiplies three tori; its Eq. 44 the distances from four points. */
const threeTori = ['x^2+y^2', 'x^2+z^2', 'y^2+z^2'].map((axes) => `((x^2+y^2+z^2+R^2-a^2)^2-4*R^2*(${axes}))`).join('*');
const fourDistances = ['(x-1)^2+y^2', '(x+1)^2+y^2', 'x^2+(y-1)^2', 'x^2+(y+1)^2'].map((square) => `sqrt(${square}+z^2)`).join('*');

/** @satisfies {Record<string, GalleryEntry>} */
const entries = {
  saddle: {
    kind: 'parametric',
    title: 'Saddle',
    formula: 'z = x² − y²',
    source: 'Liu, Xiao, Meng, Eq. 39',
    x: 'u',
    y: 'v',
    z: 'u^2-v^2',
    u: [-1, 1],
    v: ['-pi/3', 'pi/3'],
    from: [-0.86, 0.58],
    to: [0.86, 0.83],
    camera: [0.43, 0.75, 0.5],
  },
  paraboloid: {
    kind: 'parametric',
    title: 'Paraboloid',
    formula: 'z = x² + y²',
    source: 'Liu, Xiao, Meng, Eq. 40',
    x: 'u',
    y: 'v',
    z: 'u^2+v^2',
    u: [-1, 1],
    v: ['-pi/3', 'pi/3'],
    from: [0.83, -0.1],
    to: [-0.78, -0.55],
    camera: [-0.12, 0.7, 0.71],
  },
  helicoid: {
    kind: 'parametric',
    title: 'Helicoid',
    formula: 'x = u cos v, y = u sin v, z = v',
    source: 'Liu, Xiao, Meng, Eq. 41 ("spiral")',
    x: 'u*cos(v)',
    y: 'u*sin(v)',
    z: 'v',
    u: [-1, 1],
    v: ['-pi', 'pi'],
    from: [0.77, -1.91],
    to: [0.86, 1.31],
    camera: [0.48, -0.84, 0.26],
  },
  cylinder: {
    kind: 'parametric',
    title: 'Cylinder',
    formula: 'x = cos u, y = sin u, z = v',
    source: 'Liu, Xiao, Meng, Eq. 42',
    x: 'cos(u)',
    y: 'sin(u)',
    z: 'v',
    u: [0, '2*pi'],
    v: [-1, 1],
    from: [0.6, -0.8],
    to: [3.4, 0.8],
    camera: [0.66, 0.24, 0.71],
  },
  dini: {
    kind: 'parametric',
    title: 'Dini’s surface',
    formula: 'x = 2 cos u sin v, y = 2 sin u sin v, z = 2 (cos v + ln tan(v/2) + 0.4 u)',
    source: 'Liu, Xiao, Meng, Eq. 48, short of its cuspidal edge v = π/2',
    x: '2*cos(u)*sin(v)',
    y: '2*sin(u)*sin(v)',
    z: '2*(cos(v)+log(tan(v/2))+0.4*u)',
    u: ['-2*pi', '2*pi'],
    v: [0.1, 1.5],
    from: [2.01, 0.36],
    to: [-1.72, 1.33],
    camera: [-0.38, -0.32, 0.87],
  },
  threeTori: {
    kind: 'implicit',
    title: 'Three tori',
    formula: '(s² − 4R²(x² + y²)) (s² − 4R²(x² + z²)) (s² − 4R²(y² + z²)) = r, s = x² + y² + z² + R² − a²',
    source: 'Liu, Xiao, Meng, Eq. 43',
    f: `${threeTori}-r`,
    bounds: cube(2),
    parameters: { R: 1, a: 0.2, r: 0.01 },
    from: [0.64, 0.88, 0.18096367336850627],
    to: [-1.0620743135838966, 0.56, 0.01],
    camera: [-0.47, -0.17, 0.87],
  },
  metamorphosis: {
    kind: 'implicit',
    title: 'Metamorphosis',
    formula: '√((x−1)² + y² + z²) √((x+1)² + y² + z²) √(x² + (y−1)² + z²) √(x² + (y+1)² + z²) = 1.1',
    source: 'Liu, Xiao, Meng, Eq. 44',
    f: `${fourDistances}-c`,
    bounds: cube(2),
    parameters: { c: 1.1 },
    from: [-0.71, -0.04, -0.2754515027752106],
    to: [0.22, 0.58, 0.18274845945628287],
    camera: [-0.15, 0.85, 0.5],
  },
  genus2: {
    kind: 'implicit',
    title: 'Genus 2',
    formula: '2y(y² − 3x²)(1 − z²) + (x² + y²)² = (9z² − 1)(1 − z²)',
    source: 'Liu, Xiao, Meng, Eq. 45',
    f: '2*y*(y^2-3*x^2)*(1-z^2)+(x^2+y^2)^2-(9*z^2-1)*(1-z^2)',
    bounds: cube(2),
    from: [-1.11, 0.77, 0.8099765185816116],
    to: [1.367883512819138, 0.42, 0.67],
    camera: [0.66, 0.56, 0.5],
  },
  torus: {
    kind: 'implicit',
    title: 'Torus, implicit',
    formula: '(x² + y² + z² + R² − a²)² = 4R²(x² + y²)',
    source: 'Liu, Xiao, Meng, Eq. 46, in a box that holds it',
    f: '(x^2+y^2+z^2+R^2-a^2)^2-4*R^2*(x^2+y^2)',
    bounds: cube(5.7),
    parameters: { R: 4, a: 1.5 },
    from: [3.55, 2.77, 1.4132129005459257],
    to: [-3.87, -1.75, 1.4794768899590203],
    camera: [0.43, -0.75, 0.5],
  },
  printed47: {
    kind: 'implicit',
    title: 'Eq. 47 as printed',
    formula: '(3(x−1)x²(x+1) + 2y²)² + (z² − 0.85)² (3(y−1)y²(y+1) + 2z²)² + (x² − 0.85)² (3(z−1)z²(z+1) + 2x²)² = 0.12 (y² − 0.85)²',
    source: 'Liu, Xiao, Meng, Eq. 47, called Banchoff–Chmutov there',
    f: '(3*(x-1)*x^2*(x+1)+2*y^2)^2+(z^2-0.85)^2*(3*(y-1)*y^2*(y+1)+2*z^2)^2+(x^2-0.85)^2*(3*(z-1)*z^2*(z+1)+2*x^2)^2-0.12*(y^2-0.85)^2',
    bounds: cube(1.5),
    from: [-0.65, -0.6186491060227134, 0.89],
    to: [0.28, -0.05, 0.9125795608273517],
    camera: [0.48, -0.84, 0.26],
  },
  banchoffChmutov: {
    kind: 'implicit',
    title: 'Banchoff–Chmutov surface',
    formula: 'T₄(x) + T₄(y) + T₄(z) = 0, T₄(t) = 8t⁴ − 8t² + 1',
    source: 'S. V. Chmutov, T. F. Banchoff: a sum of Chebyshev polynomials',
    f: '8*(x^4+y^4+z^4)-8*(x^2+y^2+z^2)+3',
    bounds: cube(1.25),
    from: [0.85, 0.45, 0.993384930108047],
    to: [0.09, -0.9279770987560512, 0.67],
    camera: [-0.38, -0.32, 0.87],
  },
  sphere: {
    kind: 'implicit',
    title: 'Sphere',
    formula: 'x² + y² + z² = r²',
    source: 'classical',
    f: 'x^2+y^2+z^2-r^2',
    bounds: cube(1.2),
    parameters: { r: 1 },
    from: [0.6, 0, 0.8],
    to: [-0.48, 0.6, -0.64],
    camera: [-0.17, 0.86, 0.48],
  },
  globe: {
    kind: 'parametric',
    title: 'Globe',
    formula: 'x = cos v cos u, y = cos v sin u, z = sin v',
    source: 'longitude and latitude',
    x: 'cos(v)*cos(u)',
    y: 'cos(v)*sin(u)',
    z: 'sin(v)',
    u: ['-pi', 'pi'],
    v: ['-pi/2', 'pi/2'],
    from: [0.76, -0.24],
    to: [-1.83, 0.87],
    camera: [0.81, -0.3, 0.5],
  },
  ellipsoid: {
    kind: 'implicit',
    title: 'Ellipsoid, three axes',
    formula: 'x²/a² + y²/b² + z²/c² = 1',
    source: 'C. G. J. Jacobi, 1839: its geodesics in closed form',
    f: 'x^2/a^2+y^2/b^2+z^2/c^2-1',
    bounds: [
      [-3.3, 3.3],
      [-2.2, 2.2],
      [-1.1, 1.1],
    ],
    parameters: { a: 3, b: 2, c: 1 },
    from: [-1.4, -1.44, 0.513636274246886],
    to: [0.87, 1.8420640596895648, -0.26],
    camera: [0.12, 0.7, 0.71],
  },
  parametricTorus: {
    kind: 'parametric',
    title: 'Torus, parametric',
    formula: 'x = (R + a cos v) cos u, y = (R + a cos v) sin u, z = a sin v',
    source: 'Eq. 46 of Liu, Xiao, Meng in parameters',
    x: '(R+a*cos(v))*cos(u)',
    y: '(R+a*cos(v))*sin(u)',
    z: 'a*sin(v)',
    u: [0, '2*pi'],
    v: [0, '2*pi'],
    parameters: { R: 4, a: 1.5 },
    from: [1.77, 1.76],
    to: [3.91, 0.52],
    camera: [-0.12, -0.7, 0.71],
  },
  catenoid: {
    kind: 'parametric',
    title: 'Catenoid',
    formula: 'x = cosh v cos u, y = cosh v sin u, z = v',
    source: 'L. Euler, 1744: the first minimal surface',
    x: 'cosh(v)*cos(u)',
    y: 'cosh(v)*sin(u)',
    z: 'v',
    u: ['-pi', 'pi'],
    v: [-1.5, 1.5],
    from: [1.4, 1.26],
    to: [-0.95, 1.06],
    camera: [-0.66, -0.24, 0.71],
  },
  enneper: {
    kind: 'parametric',
    title: 'Enneper’s surface',
    formula: 'x = u − u³/3 + u v², y = v − v³/3 + u² v, z = u² − v²',
    source: 'A. Enneper, 1864: a minimal surface that meets itself',
    x: 'u-u^3/3+u*v^2',
    y: 'v-v^3/3+u^2*v',
    z: 'u^2-v^2',
    u: [-1.5, 1.5],
    v: [-1.5, 1.5],
    from: [1.2, -0.9],
    to: [1.08, 0.95],
    camera: [0.91, -0.33, 0.26],
  },
  moebius: {
    kind: 'parametric',
    title: 'Möbius strip',
    formula: 'x = (1 + v cos(u/2)) cos u, y = (1 + v cos(u/2)) sin u, z = v sin(u/2)',
    source: 'A. F. Möbius, J. B. Listing, 1858',
    x: '(1+v*cos(u/2))*cos(u)',
    y: '(1+v*cos(u/2))*sin(u)',
    z: 'v*sin(u/2)',
    u: [0, '2*pi'],
    v: [-0.4, 0.4],
    from: [0.6, -0.08],
    to: [2.97, 0.25],
    camera: [0.66, -0.56, 0.5],
  },
  bumpy: {
    kind: 'parametric',
    title: 'Bumpy height field',
    formula: 'z = 0.5 sin 3x sin 3y',
    source: 'many local minima',
    x: 'u',
    y: 'v',
    z: 'h*sin(3*u)*sin(3*v)',
    u: ['-pi', 'pi'],
    v: ['-pi', 'pi'],
    parameters: { h: 0.5 },
    from: [-2.29, -1.49],
    to: [0.96, -1.7],
    camera: [-0.25, 0.43, 0.87],
  },
  hills: {
    kind: 'graph',
    title: 'Two hills',
    formula: 'z = 1.4 exp(−(x + 0.9)² − (y + 0.3)²) + h exp(−(x − 1)² − 2(y − 0.3)²)',
    source: 'a graph over the plane: u and v are x and y',
    z: '1.4*exp(-(x+0.9)^2-(y+0.3)^2)+h*exp(-(x-1)^2-2*(y-0.3)^2)',
    x: [-2.5, 2.5],
    y: [-2, 2],
    parameters: { h: 1 },
    from: [-2.2, -0.5],
    to: [2.1, 0.4],
    camera: [-0.4, -0.68, 0.61],
  },
  vase: {
    kind: 'revolution',
    title: 'Vase',
    formula: 'r = 0.8 + 0.45 cos(2t − 1.2), z = 0.9 t',
    source: 'a surface of revolution: u is the angle, v is t',
    r: '0.8+b*cos(2*t-1.2)',
    z: '0.9*t',
    t: [0, 4],
    parameters: { b: 0.45 },
    from: [0.4, 0.5],
    to: [3, 3.7],
    camera: [0.45, 0.78, 0.44],
  },
  trefoil: {
    kind: 'tube',
    title: 'Trefoil knot',
    formula: 'tube of radius 0.5 around x = sin t + 2 sin 2t, y = cos t − 2 cos 2t, z = −sin 3t',
    source: 'a tubular surface: u is the angle across, v is t',
    centreline: ['sin(t)+2*sin(2*t)', 'cos(t)-2*cos(2*t)', '-sin(3*t)'],
    radius: 'a',
    t: [0, '2*pi'],
    parameters: { a: 0.5 },
    from: [1.2, 0.4],
    to: [4.9, 2.3],
    camera: [0.3, -0.5, 0.81],
  },
};

/**
 * @template T
 * @param {T} value plain data
 * @returns {Frozen<T>} the same, unchangeable all the way down
 */
function freeze(value) {
  if (typeof value === 'object' && value !== null) Object.values(value).forEach(freeze);
  return /** @type {any} */ (Object.freeze(value));
}

/** Named surfaces with a title, a formula to show, a source and a pair of points that makes a good picture: plain data, frozen. */
export const gallery = freeze(entries);
