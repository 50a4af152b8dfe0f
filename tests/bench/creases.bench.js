/** Paths across creases, through the public API, by surface: where a density jumps or has a valley, and over edges of bodies. */
import { load } from 'surfpath';
import { quick, report, sumLeast } from './bench.js';

const ROUNDS = quick ? 1 : 9;

const plane = { kind: 'graph', z: '0', x: [-1.5, 1.5], y: [-1.5, 1.5] };
const bounds = Array(3).fill([-1.2, 1.2]);
/** Definition and ends. @type {Record<string, [any, number[], number[]]>} */
const questions = {
  'a density jumps: Snell’s law': [{ ...plane, density: '1 + 0.5*sign(x)' }, [-1, 0.3], [1, -0.5]],
  'chessboard of a density': [{ ...plane, density: '1 + 0.5*sign(sin(3*x)*sin(3*y))' }, [-1, 0.8], [1, -0.7]],
  'valley of a density': [{ ...plane, density: '0.2 + abs(y)' }, [-1.3, 0.5], [1.4, -0.3]],
  'folded graph': [{ ...plane, z: '0.7*abs(x) + 0.2*sin(3*y)' }, [-0.8, 0.3], [0.7, 0.2]],
  pyramid: [{ ...plane, z: 'max(0, 1 - max(abs(x), abs(y)))' }, [-1.2, 0.3], [0.7, 1.2]],
  cube: [{ kind: 'implicit', f: 'max(abs(x), abs(y), abs(z)) - 1', bounds }, [1, 0.9, 0.3], [-1, -0.9, -0.2]],
  'cube, drilled': [
    { kind: 'implicit', f: 'max(abs(x) - 1, abs(y) - 1, abs(z) - 1, 0.4 - sqrt(x^2 + y^2))', bounds },
    [1, 0.95, 0.3],
    [-1, -0.93, 0.1],
  ],
};
const surfpath = await load();

/** @param {string} name */
function measure(name) {
  const [definition, from, to] = questions[name];
  const surface = surfpath.surface(definition);
  const begin = performance.now();
  const { converged } = surface.shortestPath(from, to);
  const first = performance.now() - begin;
  const { next } = sumLeast({ next: [() => surface.shortestPath(from, to)] }, ROUNDS);
  surface.dispose();
  return { surface: name, 'ms first': first, 'ms next': 1e-6 * next, converged };
}

report('creases', 'A path across creases, default options', Object.keys(questions).map(measure));
surfpath.dispose();
