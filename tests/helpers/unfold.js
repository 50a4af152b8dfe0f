/**
 * Ways on surfaces of flat faces, exactly: every row of faces, none twice, is unfolded into a plane, and a string drawn taut through the edges between them.
 * Knows nothing of the solver.
 */
import { cross, dot, norm, subtract, unit } from './reference.js';

/** @typedef {import('./reference.js').Vector} Vector */
/** @typedef {[number, number]} Flat a place in the plane */
/** @typedef {[Flat, Flat]} Gate both ends of an edge between two faces */
/** @typedef {(place: Vector) => Flat} Unfolding of one face */

/** A place is on a face within this. */
const ON = 1e-9;
/** A string passes beside the end of an edge by rounding only. */
const BESIDE = 1e-12;

/**
 * @param {Vector[]} vertices
 * @param {number[][]} faces the vertices of each, convex, all seen anticlockwise from the same side of the surface
 * @returns {(from: Vector, to: Vector) => number[]} how long the ways between two places on faces are, over each row of faces the shortest
 */
export function unfold(vertices, faces) {
  const normals = faces.map(([a, b, c]) => unit(cross(subtract(vertices[b], vertices[a]), subtract(vertices[c], vertices[b]))));
  const holds = (/** @type {number} */ face, /** @type {Vector} */ place) =>
    Math.abs(dot(normals[face], subtract(place, vertices[faces[face][0]]))) <= ON &&
    edgesOf(faces[face]).every(([i, j]) => {
      const inwards = cross(normals[face], subtract(vertices[j], vertices[i]));
      return dot(inwards, subtract(place, vertices[i])) >= -ON;
    });
  const faceOf = (/** @type {Vector} */ place) => {
    const found = faces.findIndex((_, face) => holds(face, place));
    if (found < 0) throw new RangeError(`${place} is on no face`);
    return found;
  };
  /** A face laid down with one of its edges. @param {number} face @param {number} i @param {number} j @param {Gate} gate where its vertices i and j come to lie @returns {Unfolding} */
  const layDown = (face, i, j, [start, end]) => {
    const along = unit(subtract(vertices[j], vertices[i]));
    const inwards = cross(normals[face], along);
    const length = Math.hypot(end[0] - start[0], end[1] - start[1]);
    const [x, y] = [(end[0] - start[0]) / length, (end[1] - start[1]) / length];
    return (place) => {
      const away = subtract(place, vertices[i]);
      const [s, t] = [dot(away, along), dot(away, inwards)];
      return [start[0] + s * x - t * y, start[1] + s * y + t * x];
    };
  };
  return (from, to) => {
    const [first, last] = [faceOf(from), faceOf(to)];
    /** The ways on from the last face of a row. @param {number[]} row @param {Unfolding} place @param {Flat} start @param {Gate[]} gates @returns {number[]} */
    const goOn = (row, place, start, gates) => {
      const face = row[row.length - 1];
      if (face === last) return [taut(start, gates, place(to))];
      return edgesOf(faces[face]).flatMap(([i, j]) => {
        const next = faces.findIndex((other) => edgesOf(other).some(([a, b]) => a === j && b === i));
        if (next < 0 || row.includes(next)) return [];
        /** @type {Gate} */
        const gate = [place(vertices[i]), place(vertices[j])];
        return goOn([...row, next], layDown(next, i, j, gate), start, [...gates, gate]);
      });
    };
    const [i, j] = faces[first];
    const place = layDown(first, i, j, [
      [0, 0],
      [norm(subtract(vertices[j], vertices[i])), 0],
    ]);
    return goOn([first], place, place(from), []);
  };
}

/** @param {number[]} face */
const edgesOf = (face) => face.map((vertex, k) => [vertex, face[(k + 1) % face.length]]);

/** How long a string is that is drawn taut through gates: it bends at their ends only. @param {Flat} from @param {Gate[]} gates @param {Flat} to */
function taut(from, gates, to) {
  const rows = [[from], ...gates, [to]];
  /** From the start to each place where it may bend. */
  const lengths = rows.map((row) => row.map(() => Infinity));
  lengths[0][0] = 0;
  for (let j = 1; j < rows.length; j++)
    for (const [l, end] of rows[j].entries())
      for (let i = 0; i < j; i++)
        for (const [k, start] of rows[i].entries()) {
          if (!gates.slice(i, j - 1).every((gate) => passes(start, end, gate))) continue;
          lengths[j][l] = Math.min(lengths[j][l], lengths[i][k] + Math.hypot(end[0] - start[0], end[1] - start[1]));
        }
  return lengths[rows.length - 1][0];
}

/** Whether a line from start to end passes through a gate. @param {Flat} start @param {Flat} end @param {Gate} gate */
function passes(start, end, [a, b]) {
  const beside = (/** @type {Flat} */ p) => (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
  const [before, after] = [beside(start), beside(end)];
  const part = before / (before - after);
  if (!(part >= -BESIDE && part <= 1 + BESIDE)) return false;
  const at = [0, 1].map((k) => start[k] + part * (end[k] - start[k]));
  const along = ((at[0] - a[0]) * (b[0] - a[0]) + (at[1] - a[1]) * (b[1] - a[1])) / ((b[0] - a[0]) ** 2 + (b[1] - a[1]) ** 2);
  return along >= -BESIDE && along <= 1 + BESIDE;
}
