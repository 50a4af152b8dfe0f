/** Boxes with rounded edges, as formulas, and how long paths over their edges are. Knows nothing of the solver. */

/** @typedef {readonly [number, number, number]} Half half sides, rounding included */

const AXES = ['x', 'y', 'z'];

/** `hypot(max(|x| - a, 0), …) - r`, the same all around inside; with its inside; and a 64th power, for which r says nothing. @type {Record<string, (half: Half, r: number) => string>} */
export const FORMS = {
  clamped: (half, r) => `hypot(${AXES.map((axis, k) => `max(abs(${axis}) - ${half[k] - r}, 0)`)}) - ${r}`,
  whole: (half, r) => `${FORMS.clamped(half, r)} + min(max(${AXES.map((axis, k) => `abs(${axis}) - ${half[k] - r}`)}), 0)`,
  power: (half) => `${AXES.map((axis, k) => `(${axis}/${half[k]})^64`).join(' + ')} - 1`,
};

/**
 * A place at random on the upper face and one on the lower, and the shortest way between them straight over one rounded edge, down the face and over the next: no shortest path is longer.
 * @param {Half} half @param {number} r 0: of sharp edges, than which rounded ones are shorter @param {import('../../helpers/random.js').Random} random @param {number} [margin] so far from the edges
 */
export function pickOver(half, r, random, margin = r) {
  const [from, to] = [1, -1].map((side) => [...[0, 1].map((k) => random.between(-1, 1) * (half[k] - margin)), side * half[2]]);
  const ways = [0, 1].flatMap((k) =>
    [1, -1].map((side) => {
      const down = 2 * (half[k] + half[2]) - side * (from[k] + to[k]) - (4 - Math.PI) * r;
      return Math.hypot(down, from[1 - k] - to[1 - k]);
    }),
  );
  return { from, to, over: Math.min(...ways) };
}
