/** Paths over fields of waves, and shorter ones that are found by pushing them aside at random. Knows nothing of the solver's graph, nor of what it does about waves. */

/** @typedef {import('../../../web/index.js').Surface} Surface */
/** @typedef {import('../../../web/index.js').AnyDefinition} Definition */
/** @typedef {import('../../../web/index.js').Path} Path */
/** @typedef {import('../../helpers/random.js').Random} Random */

/** Heights over |x|, |y| ≤ 2. */
export const WAVES = [
  '0.15*sin(14x)*cos(12y)',
  '0.2*sin(10x)*cos(10y)',
  '0.1*sin(20x)*sin(20y)',
  '0.25*sin(12x + 3y)*cos(9y - 2x)',
  '0.07*sin(16x)*cos(16y)',
  '0.3*sin(8x)*cos(8y)',
];
export const SIDE = 2;
/** @param {[string, string, string]} centreline @param {number} end @returns {Definition} */
const pipe = (centreline, end) => ({ kind: 'tube', centreline, radius: 0.3, t: [0, end] });
/** Pipes with bends, and a sheet and a tube of many waves, far longer than wide. @type {[string, Definition][]} */
export const LONG = [
  ['pipe 1.5sin(t), t to 50', pipe(['t', '1.5*sin(t)', '0'], 50)],
  ['pipe 1.5sin(t), t to 25', pipe(['t', '1.5*sin(t)', '0'], 25)],
  ['pipe 1.5sin(t), 0.3cos(t/2)', pipe(['t', '1.5*sin(t)', '0.3cos(t/2)'], 50)],
  ['pipe of four waves', pipe(['t', 'sin(1.1t) + 0.5*sin(0.53t + 1)', 'cos(0.9t) + 0.4*sin(1.7t)'], 40)],
  ['sheet 0.4sin(2u)*cos(2.5v)', { kind: 'parametric', x: 'u', y: 'v', z: '0.4sin(2u)*cos(2.5v)', u: [0, 80], v: [-3, 3] }],
  ['tube 1 + 0.1cos(8u)*cos(6t)', { kind: 'tube', centreline: ['0', '0', 't'], radius: '1 + 0.1cos(8u)*cos(6t)', t: [0, 30] }],
];
const START_POINTS = 97;
/** Rough: what looks longer by more is not solved to the tolerance; by less, it is the same. */
const [ROUGHLY, LONGER, SAME] = [
  { algorithm: /** @type {const} */ ('polyline'), points: 191, gradientTolerance: 1e-5, maxIterations: 60 },
  3e-5,
  1e-7,
];

/**
 * The shortest of a path and of what it becomes when it is bent aside at random places or, where u is an angle, wound around, again and again.
 * @param {Surface} surface @param {Path} path @param {Random} random @param {number} bends
 */
export function shortestBeside(surface, path, random, bends) {
  let best = path;
  const domain = /** @type {NonNullable<Surface['domain']>} */ (surface.domain);
  const isRound = domain.periodic.u;
  const walls = [isRound ? [-Infinity, Infinity] : domain.u, domain.v];
  for (let k = 0; k < bends; k++) {
    const line = /** @type {Float64Array} */ (best.parameters);
    const start = isRound && random.integer(2) ? wound(line, random) : bent(line, random, walls);
    const [from, to] = [start.slice(0, 2), start.slice(-2)];
    const rough = surface.shortestPath(from, to, { start, ...ROUGHLY });
    const off = (rough.length + rough.lengthError) / best.length - 1;
    if (!rough.converged || !(off < LONGER) || Math.abs(off) < SAME) continue;
    const next = surface.shortestPath(from, to, { start: rough });
    if (next.converged && next.length < best.length) best = next;
  }
  return best;
}

/** A line, bent aside at one place or, every fourth time, along all of it. @param {Float64Array} line u v @param {Random} random @param {ArrayLike<number>[]} walls */
function bent(line, random, walls) {
  const chords = line.length / 2 - 1;
  const direct = Math.hypot(line[2 * chords] - line[0], line[2 * chords + 1] - line[1]);
  const far = (random.integer(2) ? 1 : -1) * (0.03 + 0.3 * random.next() ** 2) * Math.min(1, direct);
  const [middle, width, waves, phase] = [
    random.next(),
    (0.1 + 0.3 * random.next()) / direct,
    random.between(1, 9),
    random.between(0, 2 * Math.PI),
  ];
  const everywhere = random.integer(4) === 0;
  return Array.from({ length: START_POINTS }, (_, i) => {
    const t = i / (START_POINTS - 1);
    const k = Math.min(Math.floor(t * chords), chords - 1);
    const [u, v, du, dv] = [line[2 * k], line[2 * k + 1], line[2 * k + 2] - line[2 * k], line[2 * k + 3] - line[2 * k + 1]];
    const bump = everywhere ? Math.sin(waves * Math.PI * t + phase) * Math.sin(Math.PI * t) : Math.exp(-(((t - middle) / width) ** 2));
    const aside = (far * bump * Math.min(1, 20 * t * (1 - t))) / (Math.hypot(du, dv) || 1);
    return [u + (t * chords - k) * du - aside * dv, v + (t * chords - k) * dv + aside * du].map((x, j) =>
      Math.min(walls[j][1], Math.max(walls[j][0], x)),
    );
  }).flat();
}

/** A line, wound once more around from a place on, every second time back again. @param {Float64Array} line u v @param {Random} random */
function wound(line, random) {
  const last = line.length / 2 - 1;
  const turn = (random.integer(2) ? 1 : -1) * 2 * Math.PI;
  const [on, width] = [random.next(), random.between(0.01, 0.05)];
  const off = random.integer(2) ? on + random.between(0.02, 0.4) : Infinity;
  const part = (/** @type {number} */ t, /** @type {number} */ middle) => Math.min(1, Math.max(0, (t - middle) / width + 0.5));
  return Array.from(line, (x, i) => {
    const t = (i >> 1) / last;
    const inner = t === 0 ? 0 : t < 1 ? part(t, on) - part(t, off) : off < 1 ? 0 : 1;
    return x + (i & 1 ? 0 : turn * inner);
  });
}
