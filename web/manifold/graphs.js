/** The graphs of one surface: built when they are first needed, finer ones where a coarser one separates two ends, freed together. */

import { CONVERGED, OUT_OF_MEMORY } from '../runtime/status.js';
import { gap } from '../vector.js';

/** @typedef {import('../runtime/heap.js').Heap} Heap */
/** @typedef {import('../runtime/heap.js').Graph} Graph */

/**
 * Cells a direction, by level of refinement; a surface that the first does not resolve begins with the second (a parametric one if it is far from that). The last
 * is loose on implicit surfaces: it joins what its cells join, creases or not. Before it they have one as fine that is not.
 */
const RESOLUTION = [
  [64, 128, 256],
  [40, 56, 96, 96],
];
/** Where the last of them that is not loose is still coarse, and has fewer vertices, as that of steep heights in a tall box, so many cells in its place. */
const [FEW, FINEST] = [16_000, 160];
/** Without a box: cells between the ends; more than the third only where that does not resolve the surface. */
const FLOOD_RESOLUTION = [14, 22, 34, 100, 300, 1000];
/** A flood reaches as far as a path leads that is longer than the one that is known by this factor, as that one's chords are too short, and so many cells more. */
const [LONGER, BESIDE] = [1.02, 6];
const IMPLICIT = 1;
/** Which cells that share a face are joined though their sheets part: none, all, or those with a crease between them. As in wasm/graph.h. */
const [STRICT, ANYHOW, OVER_CREASES] = [0, 1, 2];

export class Graphs {
  /** What nodes there are, and what hangs together without them, once that is known. @type {ReturnType<typeof import('../pieces/nodes.js').findNet> | null} */ net =
    null;
  /** The branch points of a parametric surface, once they are known. @type {import('../search/branches.js').Branch[] | null} */ branches =
    null;
  /** Legs between branch points, and from these to ends, by what was asked. @type {Map<string, import('../path.js').Path>} */ legs =
    new Map();
  /** How steep the surface is over x and y (lowered.js), once that is known. @type {number | null} */ steepness = null;
  #kind;
  /** @type {number[]} by level */ #resolutions;
  /** How cells on both sides of a crease are joined. */ #creases;
  /** @type {Graph[]} by level */ #graphs = [];
  /** @type {Graph | null} around the last point that was asked for */ #flood = null;

  /** @param {number} kind 0: parametric, 1: implicit @param {boolean} isCreased its formulas have creases */
  constructor(kind, isCreased) {
    this.#kind = kind;
    this.#resolutions = RESOLUTION[kind];
    this.#creases = isCreased ? OVER_CREASES : STRICT;
  }

  /**
   * The graph of all of the surface, the next finer one if it is coarse; null: there is none so fine. One of status out-of-memory holds nothing, and is tried
   * again by the next call.
   * @param {Heap} heap @param {number} record address of the surface's record @param {{ domain: import('./domain.js').Domain | null, box: number[] | null }} where the surface
   *   lies: in the rectangle of some turns so many times, and so many times as many cells @param {number} level how often it is refined
   * @returns {Graph | null}
   */
  find(heap, record, where, level) {
    const graph = this.#graphs[level] ?? this.#make(heap, record, where, level);
    if (!graph) return null;
    if (graph.status !== OUT_OF_MEMORY) this.#graphs[level] = graph;
    /* The last one is only for what stays apart without it. */
    /** @type {Graph | null} */
    const finer = graph.coarse && this.#resolutions[level + 2] ? this.find(heap, record, where, level + 1) : null;
    return finer?.status === CONVERGED ? finer : usable(graph);
  }

  /** @param {Heap} heap @param {number} record @param {Parameters<Graphs['find']>[2]} where @param {number} level @returns {Graph | null} null: there is none so fine */
  #make(heap, record, where, level) {
    const { domain } = where;
    const resolutions = this.#resolutions;
    const box = domain ? domain.lower.flatMap((x, j) => [x, domain.upper[j]]) : where.box;
    const resolution = Math.round(resolutions[level] * Math.sqrt(domain?.turn?.folds ?? 1));
    if (!box || !resolution) return null;
    const loose = resolutions[level + 1] ? this.#creases : ANYHOW;
    const build = (/** @type {number} */ cells) => heap.buildGraph(record, this.#kind, { box, cell: 0, resolution: cells, loose, level });
    const graph = build(resolution);
    if (!graph.coarse || resolutions[level + 2] || graph.vertices >= FEW) return graph;
    heap.releaseGraph(graph);
    return build(FINEST);
  }

  /**
   * The graph of an implicit surface around a point, whatever its bounds, with cells a part of the distance to another wide. Valid until the next one.
   * @param {Heap} heap @param {number} record @param {number[]} from @param {number[]} to @param {number} level
   * @param {number} length in space: no cell is needed that no shorter path can reach; 0: all are
   * @param {number} wide so many times as wide are cells
   */
  flood(heap, record, from, to, level, length, wide) {
    const cell = (wide * gap(from, to)) / FLOOD_RESOLUTION[level];
    if (this.#kind !== IMPLICIT || !(cell > 0)) return null;
    if (this.#flood) heap.releaseGraph(this.#flood);
    this.#flood = null;
    this.#flood = heap.buildGraph(record, this.#kind, {
      box: from.flatMap((x, j) => [x, to[j]]),
      cell,
      resolution: 0,
      loose: level > 1 ? ANYHOW : this.#creases,
      reach: length && length * LONGER + BESIDE * cell,
    });
    return usable(this.#flood);
  }

  /** Frees all. @param {Heap | null} heap null: the memory is gone already */
  drop(heap) {
    if (heap) for (const graph of [...this.#graphs, this.#flood]) if (graph) heap.releaseGraph(graph);
    this.#graphs = [];
    this.#flood = null;
    this.net = this.branches = this.steepness = null;
    this.legs.clear();
  }
}

/** @param {Graph} graph */
const usable = (graph) => ([CONVERGED, OUT_OF_MEMORY].includes(graph.status) ? graph : null);
