/**
 * A flat body stretched along its short axes, and the metric that makes lengths those of space. In space a rim may be as sharp as the square of what the body is thick: chords jump over
 * it, and nodes do not pass it. Stretched it is round. Compiled and installed when somebody asks for it. MATH.md, "Flat bodies".
 */

import { compile } from '../expression/compile.js';
import { diagonalOf, dot, unit } from '../vector.js';
import { touches } from './extent.js';
import { Graphs } from './graphs.js';
import { KIND, SHAPE } from './kind.js';
import { squareOf } from './metric.js';

/** @typedef {import('./extent.js').Extent} Extent */
/** @typedef {import('./sides.js').Installed} Installed */
/** @typedef {Pick<import('./sides.js').Given, 'measure' | 'shape' | 'parameters' | 'solver'> & { write: (shape: Installed, measured: Installed, extent: number) => Installed }} Given a surface, for the present values of its parameters */

export class Stretched {
  #given;
  #extent;
  /** By how much coordinates count along each axis. @type {number[]} */ #scale;
  /** @type {Installed[]} */ #installed = [];
  /** @type {import('../search/routes.js').Field} */ field;

  /** @param {Given} given @param {Extent} extent */
  constructor(given, extent) {
    this.#given = given;
    this.#extent = extent;
    const most = Math.max(...extent.half);
    this.#scale = extent.half.map((half) => half / most);
    const box = extent.half.flatMap((half, i) => [-1, 1].map((side) => (side * (half + extent.margin[i])) / this.#scale[i]));
    this.field = this.#install(box);
  }

  /** Places of space in the stretched coordinates. @param {ArrayLike<number>} places @returns {number[]} */
  into(places) {
    const { axes, middle } = this.#extent;
    return Array.from({ length: places.length }, (_, k) => {
      const first = k - (k % 3);
      const from = middle.map((x, j) => places[first + j] - x);
      return dot(axes[k % 3], from) / this.#scale[k % 3];
    });
  }

  /** Places in the stretched coordinates in space. @param {Float64Array} places */
  back(places) {
    const { axes, middle } = this.#extent;
    return places.map((_, k) => {
      const first = k - (k % 3);
      return axes.reduce((sum, axis, i) => sum + axis[k % 3] * this.#scale[i] * places[first + i], middle[k % 3]);
    });
  }

  /**
   * A mesh of it, in space; null: it is poor where it is stretched, or the surface larger than points told.
   * @param {number} resolution @param {(mesh: import('../mesh/mesh.js').Mesh) => boolean} isPoor @returns {import('../mesh/mesh.js').Mesh | null}
   */
  mesh(resolution, isPoor) {
    const { axes } = this.#extent;
    const { box, mesh } = this.field;
    const round = mesh(/** @type {number[]} */ (box), resolution);
    if (isPoor(round) || touches(round.positions, box, null)) return null;
    const { positions, normals, indices } = round;
    for (let k = 0; k < normals.length; k += 3) {
      const slope = this.#scale.map((scale, i) => normals[k + i] / scale);
      const normal = [0, 1, 2].map((j) => axes.reduce((sum, axis, i) => sum + axis[j] * slope[i], 0));
      normals.set(unit(normal), k);
    }
    return { positions: this.back(positions), normals, indices };
  }

  /** Gives back what the solver holds of it. @param {import('../runtime/heap.js').Heap | null} heap null: the memory is gone already */
  drop(heap) {
    this.field.graphs.drop(heap);
    if (heap) for (const installed of this.#installed) this.#given.solver.remove(installed);
  }

  /** @param {number[]} box @returns {import('../search/routes.js').Field} */
  #install(box) {
    const { solver, write } = this.#given;
    this.#installed = solver.installAll([this.#compile(false, SHAPE.implicit.valueOrder), this.#compile(true, 0)]);
    const [shape, metric] = this.#installed;
    const measured = write(shape, metric, diagonalOf(box));
    const { variables, jet } = SHAPE.implicit;
    /** @type {import('../search/routes.js').Field['run']} */
    const run = (call) => solver.run(() => call(solver.heap, measured.record, shape));
    return {
      kind: KIND.implicit,
      domain: null,
      box,
      graphs: new Graphs(KIND.implicit, false),
      isPlain: false,
      positions: null,
      run,
      jets: (places) => solver.evaluate(shape.call.jet, places, variables.length, jet),
      forms: () => [],
      mesh: (within, resolution) => run((heap, _, { value }) => heap.meshImplicit(value, within, resolution)),
      pieces: [],
    };
  }

  /** @param {boolean} isMeasured with what measures length there @param {0 | 1} valueOrder */
  #compile(isMeasured, valueOrder) {
    const { measure, shape, parameters, solver } = this.#given;
    const { axes, middle } = this.#extent;
    return compile({
      outputs: (formulas) => {
        const { graph, read, slope } = formulas;
        const along = this.#scale.map((scale, i) => graph.multiply(graph.constant(scale), graph.variable(i)));
        const at = middle.map((x, j) =>
          along.reduce((sum, node, i) => graph.add(sum, graph.multiply(graph.constant(axes[i][j]), node)), graph.constant(x)),
        );
        const space = Object.fromEntries(shape.variables.map((name, j) => [name, at[j]]));
        const shaped = read(/** @type {import('../definition.js').Expression[]} */ (shape.outputs)[0], shape.names[0], [], space);
        if (!isMeasured) return [shaped];
        const square = squareOf(formulas, measure, [], space);
        const gradient = shape.variables.map((name) => slope(shaped, name));
        const size = gradient.map((node) => graph.multiply(node, node)).reduce((sum, node) => graph.add(sum, node));
        const entry = (/** @type {number} */ i, /** @type {number} */ j) => {
          /* Nothing along the surface; but chords through the body are no short cuts. */
          const across = graph.divide(graph.multiply(gradient[i], gradient[j]), size);
          return graph.multiply(i === j ? graph.add(graph.constant(this.#scale[i] ** 2), across) : across, square);
        };
        return [shaped, entry(0, 0), entry(0, 1), entry(1, 1), entry(0, 2), entry(1, 2), entry(2, 2)];
      },
      names: [],
      variables: shape.variables,
      parameters,
      valueOrder,
      apply: solver.apply,
    });
  }
}
