/** The curves of the view: starts, paths and other geodesics as wide lines, reused while their number stays. Knows colours and order, nothing of paths. */

import { Color, Group } from 'three';
import { GeodesicLine } from 'surfpath/three';

/** @typedef {{ starts: Float64Array[], paths: Float64Array[], others: Float64Array[], warmth: number }} Curves x y z … each; warmth: from 0, the start's colour, to 1, the path's */
/** @typedef {'starts' | 'paths' | 'others'} Role */

/** Drawn after one another; the markers of handles come after all. */
const ORDER = { others: 1, starts: 4, paths: 7 };
const WIDTH = { others: 2.5, starts: 2, paths: 4 };

export class CurveLines extends Group {
  /** @type {Record<Role, GeodesicLine[]>} */ #lines = { starts: [], paths: [], others: [] };
  /** @type {Partial<Record<Role, GeodesicLine>>} */ #spare = {};
  #warmth = 1;

  constructor() {
    super();
    // One of each waits without a path: its shaders can be compiled before there is any.
    for (const role of /** @type {Role[]} */ (['starts', 'paths', 'others'])) this.#spare[role] = this.#makeLine(role);
  }

  /** @param {Curves} curves */
  setCurves(curves) {
    this.#warmth = curves.warmth;
    for (const role of /** @type {Role[]} */ (['starts', 'paths', 'others'])) this.#fill(role, curves[role]);
  }

  /** @param {Role} role @param {Float64Array[]} curves */
  #fill(role, curves) {
    const lines = this.#lines[role];
    while (lines.length > curves.length) lines.pop()?.dispose();
    for (const [i, points] of curves.entries()) {
      lines[i] ??= this.#takeLine(role);
      lines[i].setPath(points);
    }
  }

  /** @param {Role} role */
  #takeLine(role) {
    const line = this.#spare[role] ?? this.#makeLine(role);
    delete this.#spare[role];
    return line;
  }

  /** @param {Role} role */
  #makeLine(role) {
    const line = new GeodesicLine(null, { width: WIDTH[role] });
    line.setOrder(ORDER[role]);
    this.add(line);
    return line;
  }

  /** @param {{ start: string, path: string, other: string, halo: string }} theme */
  paint({ start, path, other, halo }) {
    const cool = new Color(start);
    const colours = { starts: cool, paths: cool.clone().lerp(new Color(path), this.#warmth), others: new Color(other) };
    for (const role of /** @type {Role[]} */ (Object.keys(colours)))
      for (const line of this.#lines[role]) line.setColours({ colour: colours[role], halo });
  }
}
