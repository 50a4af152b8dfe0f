/** Fuzzes what callers hand over: definitions, points and options of every shape, by fast-check. Nothing but a result, or an error that names the mistake. */
import fc from 'fast-check';
import { gallery } from '../../web/gallery.js';
import { ExpressionError, load } from '../../web/index.js';
import { STATUS } from '../../web/runtime/status.js';

/** @typedef {import('../helpers/random.js').Random} Random */

/** Milliseconds that no call may take, on a machine that does other things too. */
const HANG = 60_000;
const STATUSES = [...STATUS.values()];
/** An error of this library begins with the function, or says its name. */
const OWN =
  /^(surface|parametric|implicit|metric|graph|revolution|tube|sweep|shortestPath|shortestPaths|geodesics|lengths|trace|evaluate|project|mesh|distanceField|set)\b.*:|^periodic\.[uv]: |^surfpath: |^the (parameter|expression) |^[\w.[\]]+ must be/s;

const number = fc.oneof(
  { weight: 4, arbitrary: fc.double({ min: -2, max: 2, noNaN: true }) },
  fc.double(),
  fc.constantFrom(0, -0, 1e308, -1e308, 5e-324, 1e-9, 2 ** 31, 2 ** 53),
);
const formula = fc.oneof(
  {
    weight: 5,
    arbitrary: fc.constantFrom(
      'u',
      'v',
      'x',
      'y',
      'z',
      't',
      's',
      'cos(u)',
      'sin(v)',
      'u*v',
      'x^2+y^2+z^2-1',
      '1/u',
      'sqrt(u)',
      'log(v)',
      '1',
      'a*u',
      'floor(3*u)',
      't^2+1',
      '2*pi',
    ),
  },
  number,
  fc.string({ maxLength: 8 }),
);
/** Mostly what belongs there, now and then anything. @template T @param {fc.Arbitrary<T>} arbitrary */
const mostly = (arbitrary) => fc.oneof({ weight: 30, arbitrary }, { weight: 1, arbitrary: fc.anything() });
const range = mostly(
  fc.oneof(
    { weight: 5, arbitrary: fc.constantFrom([-1, 1], [0, '2*pi'], ['-pi', 'pi'], [0, 1]) },
    fc.tuple(formula, formula),
    fc.array(number, { maxLength: 3 }),
  ),
);
const formulas = mostly(fc.oneof(fc.tuple(formula, formula, formula), fc.tuple(formula, formula)));
const parameters = mostly(
  fc.dictionary(fc.constantFrom('a', 'b', 'R', 'sin', 'u', '__proto__', 'constructor', ''), number, { maxKeys: 3 }),
);
const kinds = ['parametric', 'implicit', 'metric', 'graph', 'revolution', 'tube', 'sweep'];

/** Mostly without what other kinds alone take, which is refused at once. @param {any} drawn */
const fitting = (drawn) => {
  const misplaced = drawn.kind === 'implicit' ? ['periodic', 'reference'] : ['bounds'];
  return Object.fromEntries(Object.entries(drawn).filter(([name]) => !misplaced.includes(name)));
};

const definition = fc.record(
  {
    kind: mostly(fc.constantFrom(...kinds)),
    ...Object.fromEntries(['f', 'E', 'F', 'G', 'r', 'radius'].map((name) => [name, mostly(formula)])),
    ...Object.fromEntries(['u', 'v', 's'].map((name) => [name, range])),
    ...Object.fromEntries(['x', 'y', 'z', 't'].map((name) => [name, fc.oneof(mostly(formula), range)])),
    ...Object.fromEntries(['centreline', 'path', 'profile'].map((name) => [name, formulas])),
    bounds: mostly(
      fc.oneof(
        fc.constant([
          [-2, 2],
          [-2, 2],
          [-2, 2],
        ]),
        fc.tuple(range, range, range),
      ),
    ),
    density: fc.oneof({ weight: 4, arbitrary: fc.constant(undefined) }, mostly(formula)),
    metric: fc.oneof({ weight: 6, arbitrary: fc.constant(undefined) }, mostly(fc.record({ E: formula, F: formula, G: formula }))),
    periodic: fc.oneof({ weight: 3, arbitrary: fc.constant(undefined) }, fc.constantFrom('auto', { u: true }, { v: false }), fc.anything()),
    reference: fc.oneof({ weight: 6, arbitrary: fc.constant(undefined) }, formulas),
    parameters: fc.oneof({ weight: 2, arbitrary: fc.constant({ a: 1 }) }, parameters),
  },
  { requiredKeys: ['kind'] },
);
const fit = fc.oneof({ weight: 30, arbitrary: definition.map(fitting) }, definition);
/** Of the gallery, with a field or two changed: these become surfaces. */
const known = fc
  .tuple(
    fc.constantFrom(...Object.values(gallery)),
    definition,
    fc.subarray(['periodic', 'parameters', 'density', 'u', 'v', 'bounds', 'z', 'f'], { maxLength: 2 }),
  )
  .map(([entry, other, names]) =>
    fitting({ ...entry, ...Object.fromEntries(names.map((name) => [name, /** @type {any} */ (other)[name]])) }),
  );

const point = mostly(
  fc.oneof(fc.array(number, { minLength: 2, maxLength: 3 }), fc.array(number, { maxLength: 4 }), fc.float64Array({ maxLength: 4 })),
);
const options = mostly(
  fc.record(
    {
      algorithm: mostly(fc.constantFrom('elements', 'polyline', 'paper')),
      tolerance: mostly(fc.constantFrom(1e-3, 1e-6, 1e-9, 1)),
      points: mostly(fc.integer({ min: -1, max: 200 })),
      start: mostly(fc.oneof(fc.constantFrom('global', 'straight'), fc.array(number, { maxLength: 12 }))),
      via: mostly(fc.array(point, { maxLength: 2 })),
      maxIterations: mostly(fc.integer({ min: -1, max: 60 })),
      gradientTolerance: mostly(number),
      record: mostly(fc.boolean()),
      max: mostly(fc.integer({ min: -1, max: 5 })),
      resolution: mostly(fc.integer({ min: -1, max: 12 })),
      exact: mostly(fc.constant(false)),
    },
    { requiredKeys: [] },
  ),
);
/** One or two of the options, for functions that know few. */
const some = fc.oneof(options, {
  weight: 2,
  arbitrary: fc.constantFrom(undefined, { points: 9 }, { resolution: 6 }, { start: 'straight' }, { algorithm: 'polyline', points: 12 }),
});
const call = fc.record({
  name: fc.constantFrom(
    'shortestPath',
    'geodesics',
    'shortestPaths',
    'lengths',
    'trace',
    'evaluate',
    'project',
    'mesh',
    'distanceField',
    'set',
  ),
  points: fc.tuple(point, point),
  numbers: mostly(fc.array(number, { maxLength: 12 })),
  length: mostly(number),
  /** Between the points that the gallery suggests. */
  suggested: fc.boolean(),
  options: some,
  parameters,
});

/** @type {Record<string, (surface: any, asked: any) => unknown>} */
const CALLS = {
  shortestPath: (surface, { points, options }) => surface.shortestPath(...points, options),
  geodesics: (surface, { points, options }) => surface.geodesics(...points, options),
  shortestPaths: (surface, { numbers, options }) => surface.shortestPaths(numbers, options),
  lengths: (surface, { numbers, options }) => surface.lengths(numbers, options),
  trace: (surface, { points, length, options }) => surface.trace(...points, length, options),
  evaluate: (surface, { numbers }) => surface.evaluate(numbers),
  project: (surface, { points }) => surface.project(...points),
  mesh: (surface, { options }) => surface.mesh(options),
  // At its default resolution a field of a hundred thousand vertices is no hang.
  distanceField: (surface, { points, options }) => surface.distanceField(points[0], { resolution: 8, ...options }),
  set: (surface, { parameters }) => surface.set(parameters),
};

/** Runs something that may refuse. @param {() => any} run @param {{ refused: number }} counts */
function attempt(run, counts) {
  try {
    return run();
  } catch (error) {
    const { message } = /** @type {Error} */ (error);
    const isOwn = error instanceof ExpressionError || ((error instanceof TypeError || error instanceof RangeError) && OWN.test(message));
    if (!isOwn) throw error;
    counts.refused++;
    return undefined;
  }
}

/** A path is of a status of the list: with numbers that are finite, or without any. @param {any} path */
export function checkPath({ status, converged, length, lengthError, points, parameters, index }) {
  if (!STATUSES.includes(status)) throw new Error(`status ${status}`);
  if (converged !== (status === 'converged')) throw new Error(`converged ${converged}, status ${status}`);
  const all = [...points, ...(parameters ?? [])];
  if (Number.isNaN(length) && all.length > 0) throw new Error(`${status}: points without a length`);
  if (!Number.isNaN(length) && !(length >= 0 && length < Infinity && lengthError >= 0 && all.every(Number.isFinite)))
    throw new Error(`${status}: length ${length}, error ${lengthError}`);
  if (converged && !(lengthError < Infinity && index <= 0 && length >= 0))
    throw new Error(`converged: error ${lengthError}, index ${index}`);
}

/**
 * @param {Random} random @param {number} milliseconds
 * @returns {Promise<{ count: number, notes: string }>}
 */
export async function fuzzDefinitions(random, milliseconds) {
  const counts = { count: 0, refused: 0, surfaces: 0, paths: 0, slowest: 0, name: '' };
  const surfpath = await load();
  const property = fc.property(
    fc.oneof(fit, { weight: 2, arbitrary: known }),
    fc.array(call, { minLength: 1, maxLength: 4 }),
    (what, calls) => {
      counts.count++;
      const surface = attempt(() => surfpath.surface(/** @type {any} */ (what)), counts);
      if (!surface) return;
      counts.surfaces++;
      for (const each of calls) {
        const asked = each.suggested && 'from' in what ? { ...each, points: [what.from, what.to] } : each;
        const start = performance.now();
        const answer = attempt(() => CALLS[asked.name](surface, asked), counts);
        const took = performance.now() - start;
        if (took > HANG) throw new Error(`${asked.name} took ${took} ms`);
        if (took > counts.slowest) Object.assign(counts, { slowest: took, name: asked.name });
        const paths = [answer].flat().filter((one) => one?.status !== undefined);
        counts.paths += paths.length;
        for (const path of paths) checkPath(path);
      }
      surface.dispose();
    },
  );
  fc.assert(property, {
    seed: random.seed,
    numRuns: Infinity,
    interruptAfterTimeLimit: milliseconds,
    markInterruptAsFailure: false,
    endOnFailure: false,
  });
  surfpath.dispose();
  const { count, surfaces, paths, refused, slowest, name } = counts;
  return { count, notes: `${surfaces} surfaces, ${paths} paths, ${refused} refused, slowest: ${name}, ${slowest.toFixed(0)} ms` };
}
