/** Distances from one point to all vertices of a mesh: one search of the graph, exact ones from neighbour to neighbour, and each by a search of its own. */
import { load } from 'surfpath';
import { gallery } from 'surfpath/gallery';
import { compete, quick, report } from './bench.js';

/** @typedef {'saddle' | 'globe' | 'parametricTorus' | 'trefoil' | 'moebius'} Name of a surface */
/** @type {Name[]} */
const NAMES = quick ? ['saddle'] : ['saddle', 'globe', 'parametricTorus', 'trefoil', 'moebius'];
/** Meshes of fewer vertices are searched one by one. */
const RESOLUTION = quick ? 26 : 32;
const ROUNDS = quick ? 1 : 3;
/** Of so many vertices one is searched for alone. */
const EVERY = quick ? 97 : 13;

const surfpath = await load();
let sink = 0;

/** @param {Name} name */
function measure(name) {
  const { from, ...definition } = gallery[name];
  const surface = surfpath.surface(definition);
  const rough = surface.distanceField(from, { resolution: RESOLUTION });
  const places = /** @type {Float64Array} */ (rough.mesh.parameters);
  const count = rough.distances.length;
  const chosen = Array.from({ length: Math.floor(count / EVERY) }, (_, k) => EVERY * k);
  const time = (/** @type {() => number} */ run, /** @type {number} */ vertices) => () => {
    const start = performance.now();
    sink += run();
    return (performance.now() - start) / vertices;
  };
  const field = (/** @type {boolean} */ exact) => surface.distanceField(from, { resolution: RESOLUTION, exact }).distances;
  const single = (/** @type {number} */ i) => surface.shortestPath(from, Array.from(places.subarray(2 * i, 2 * i + 2))).length;
  const { graph, exact, alone } = compete(
    {
      graph: time(() => field(false)[1], count),
      exact: time(() => field(true)[1], count),
      alone: time(() => chosen.reduce((sum, i) => sum + single(i), 0), chosen.length),
    },
    ROUNDS,
  );
  const lengths = field(true);
  const off = (/** @type {ArrayLike<number>} */ given) =>
    Math.max(...chosen.map((i) => (lengths[i] > 0 ? Math.abs(given[i] / lengths[i] - 1) : 0)));
  const alike = Math.max(...chosen.map((i) => (lengths[i] > 0 ? Math.abs(single(i) / lengths[i] - 1) : 0)));
  surface.dispose();
  return {
    surface: name,
    vertices: count,
    'graph, µs a vertex': 1e3 * graph.minimum,
    'exact, ms a vertex': exact.minimum,
    'alone, ms a vertex': alone.minimum,
    'alone against exact': alone.minimum / exact.minimum,
    'exact differs from alone by': alike,
    'graph by at most': off(rough.distances),
  };
}

report('field', 'Distance fields: the time that a vertex takes, and by what part of the length the answers differ', NAMES.map(measure), [
  'minima',
  `alone: one of ${EVERY} vertices, each by shortestPath`,
]);
if (!(sink >= 0)) throw new Error('no distances');
