/* The paper's surfaces as expressions, and one surface that uses everything an expression can contain. */

const SQUARE = '(x^2+y^2+z^2+R^2-a^2)^2';
const RING = (/** @type {string} */ a, /** @type {string} */ b) => `(${SQUARE}-4R^2*(${a}^2+${b}^2))`;
const BALL = (/** @type {string} */ shift) => `sqrt(${shift})`;

/** @typedef {{ outputs: string[], names: string[], variables: string[], parameters: Record<string, number>, box: [number, number][] }} TestSurface */

/** @param {string[]} outputs @param {[number, number][]} box @param {Record<string, number>} [parameters] @returns {TestSurface} */
const parametric = (outputs, box, parameters = {}) => ({ outputs, names: ['x', 'y', 'z'], variables: ['u', 'v'], parameters, box });

/** @param {string} output @param {number} size half the box @param {Record<string, number>} [parameters] @returns {TestSurface} */
const implicit = (output, size, parameters = {}) => ({
  outputs: [output],
  names: ['f'],
  variables: ['x', 'y', 'z'],
  parameters,
  box: [
    [-size, size],
    [-size, size],
    [-size, size],
  ],
});

/** By name. @type {Record<string, TestSurface>} */
export const SURFACES = {
  saddle: parametric(
    ['u', 'v', 'u^2-v^2'],
    [
      [-1, 1],
      [-1, 1],
    ],
  ),
  paraboloid: parametric(
    ['u', 'v', 'u^2+v^2'],
    [
      [-1, 1],
      [-1, 1],
    ],
  ),
  helicoid: parametric(
    ['u*cos(v)', 'u*sin(v)', 'v'],
    [
      [-1, 1],
      [-3, 3],
    ],
  ),
  cylinder: parametric(
    ['cos(u)', 'sin(u)', 'v'],
    [
      [0, 6],
      [-1, 1],
    ],
  ),
  dini: parametric(
    ['2cos(u)sin(v)', '2sin(u)sin(v)', '2(cos(v)+ln(tan(v/2))+0.4u)'],
    [
      [-6, 6],
      [0.1, 1.5],
    ],
  ),
  threeTori: implicit(`${RING('x', 'y')}*${RING('x', 'z')}*${RING('y', 'z')}-r`, 2, { R: 1, a: 0.2, r: 0.01 }),
  metamorphosis: implicit(
    `${BALL('(x-1)^2+y^2+z^2')}*${BALL('(x+1)^2+y^2+z^2')}*${BALL('x^2+(y-1)^2+z^2')}*${BALL('x^2+(y+1)^2+z^2')}-1.1`,
    2,
  ),
  genusTwo: implicit('2y*(y^2-3x^2)*(1-z^2)+(x^2+y^2)^2-(9z^2-1)*(1-z^2)', 2),
  torus: implicit(`${SQUARE}-4R^2*(x^2+y^2)`, 5.7, { R: 4, a: 1.5 }),
  everything: parametric(
    [
      'sin(u)+cos(v)-tan(u v/4)*asin(u/4)/acos(v/4)+atan(3u)*atan2(u, v)^3-sinh(u)+cosh(v)*tanh(u+v)',
      'exp(-u)*ln(2+u^2)+cbrt(u-v)-pow(2+u, v)+(3+v)^p+|u|*sign(v)+floor(2u)*u-√(5+u)',
      'min(u, v, 0.5u v)+max(u, -v)^2-(u^2+1)^-3+p*sqrt(p)*sin(p)*cos(p)+e^u+2^0.5',
    ],
    [
      [-1.9, 1.9],
      [-1.9, 1.9],
    ],
    { p: 1.7 },
  ),
};
