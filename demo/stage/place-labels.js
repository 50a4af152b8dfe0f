/** Where labels of lines stand on the screen: each beside a point of its own line, where the other lines are far, and over nothing else. Pure geometry. */

/** @typedef {{ left: number, top: number, right: number, bottom: number }} Box in CSS pixels */
/** @typedef {'right' | 'left' | 'above' | 'below'} Side of its point that a label stands on */
/** @typedef {{ x: number, y: number, side: Side, at: number }} Place x, y: the point of the line; at: its index */
/** @typedef {{ line: number[][], size: readonly number[], last?: Place | null }} Label line: points x y; size: width and height; last: where it stood */

/** From a label to its point. */
export const LEADER = 12;
/** What stays free around a label. */
const GAP = 3;
/** Places along a line that are tried. */
const TRIED = 24;
/** A line nearer than the first may be taken for the label's own; farther than the second none is. */
const [CONFUSED, DISTINCT] = [5, 16];
/** What a place gains that was the last one: a label stays until another place is plainly better. */
const STAYS = 6;
/** What a place loses at the ends of its line, where all lines meet, against one in the middle. */
const OFF_MIDDLE = 6;

const SIDES = /** @type {const} */ ({ right: [1, 0], left: [-1, 0], below: [0, 1], above: [0, -1] });
const NAMES = /** @type {Side[]} */ (Object.keys(SIDES));

/** @param {number} x @param {number} y @param {Side} side @param {readonly number[]} size @returns {Box} */
export function boxOf(x, y, side, [width, height]) {
  const [across, down] = SIDES[side];
  const [cx, cy] = [x + across * (LEADER + width / 2), y + down * (LEADER + height / 2)];
  return { left: cx - width / 2, top: cy - height / 2, right: cx + width / 2, bottom: cy + height / 2 };
}

/** The point that a label is tied to. @param {Place} place @returns {Box} */
const pointOf = ({ x, y }) => ({ left: x, top: y, right: x, bottom: y });

/** @param {Box} a @param {Box} b */
export const overlap = (a, b) => a.left < b.right + GAP && b.left < a.right + GAP && a.top < b.bottom + GAP && b.top < a.bottom + GAP;

/** @param {Box} box @param {Box} frame */
export const isInside = (box, frame) =>
  box.left >= frame.left && box.right <= frame.right && box.top >= frame.top && box.bottom <= frame.bottom;

/** Distance of a point from a piece of a line. @param {number[]} point @param {number[]} from @param {number[]} to */
function distanceTo([x, y], [ax, ay], [bx, by]) {
  const [dx, dy] = [bx - ax, by - ay];
  const t = Math.min(Math.max(((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy || 1), 0), 1);
  return Math.hypot(x - ax - t * dx, y - ay - t * dy);
}

/** How far the nearest of other lines is, up to where it does not matter. @param {number[]} point @param {number[][][]} others */
function clearanceOf(point, others) {
  let least = DISTINCT;
  for (const line of others) for (let i = 1; i < line.length; i++) least = Math.min(least, distanceTo(point, line[i - 1], line[i]));
  return least;
}

/** How many points of lines a box covers, in parts of a line. @param {Box} box @param {number[][][]} lines */
function coveredBy(box, lines) {
  let sum = 0;
  for (const line of lines) {
    const inside = line.filter(([x, y]) => x > box.left && x < box.right && y > box.top && y < box.bottom);
    sum += inside.length / line.length;
  }
  return sum;
}

/** The best place for a label; null: there is none. @param {Label} label @param {number[][][]} lines of all labels @param {Box[]} taken @param {Box} frame @param {boolean} must have one if it fits at all */
function placeOne({ line, size, last }, lines, taken, frame, must) {
  const others = lines.filter((other) => other !== line);
  /** @type {Place | null} */ let best = null;
  let most = -Infinity;
  for (let k = 1; k < TRIED; k++) {
    const at = Math.round((k / TRIED) * (line.length - 1));
    const clearance = clearanceOf(line[at], others);
    if (clearance < CONFUSED && !must) continue;
    const [x, y] = line[at];
    for (const side of NAMES) {
      const box = boxOf(x, y, side, size);
      if (!isInside(box, frame) || taken.some((other) => overlap(box, other))) continue;
      const stays = last?.at === at && last.side === side ? STAYS : 0;
      const middle = OFF_MIDDLE * Math.abs((2 * k) / TRIED - 1);
      const score = clearance + stays - middle - DISTINCT * coveredBy(box, lines);
      if (score > most) [best, most] = [{ x, y, side, at }, score];
    }
  }
  return best;
}

/**
 * Places labels one after the other: an earlier one has the choice, and what does not fit any more has no place.
 * @param {Label[]} labels the first has a place wherever it fits, even if its line cannot be told from another one
 * @param {Box[]} obstacles what no label may cover @param {Box} frame that labels stay in
 * @returns {(Place | null)[]} null: no place
 */
export function placeLabels(labels, obstacles, frame) {
  const lines = labels.map(({ line }) => line);
  const taken = [...obstacles];
  return labels.map((label, i) => {
    const place = label.line.length > 1 ? placeOne(label, lines, taken, frame, i === 0) : null;
    if (place) taken.push(boxOf(place.x, place.y, place.side, label.size), pointOf(place));
    return place;
  });
}
