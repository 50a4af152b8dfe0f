/**
 * How a parameter rectangle is glued to itself: directions that close, straight, or turned over as a Möbius strip does. What comes after a seam is the
 * formulas' own continuation. Where one turn brings back the surface with its other coordinate changed, several bring back everything: the rectangle of so
 * many turns is periodic like any other, and each point of the surface is in it as often. MATH.md, "Seams".
 */

import { dot, gap } from '../vector.js';
import { diagonal, linePlaces, POSITION_GAP, reach, vector } from './rectangle.js';

/** @typedef {import('./rectangle.js').Range} Range */
/** @typedef {import('./rectangle.js').Jets} Jets */
/** @typedef {import('./rectangle.js').Sampled} Sampled */
/** @typedef {Range & { caller: string }} Asked a range, and for whom it was read */
/** @typedef {{ sign: number, offset: number }} Gluing one turn on, the place with the other coordinate w is the one that had it at sign · w + offset */
/** @typedef {ReturnType<typeof sampleEdge>} Edge */
/** @typedef {Gluing & { direction: number, span: number, folds: number }} Turn span: one turn of this coordinate; folds: so many bring back everything */
/** @typedef {Range & { periodic: boolean[], turn: Turn | null }} Glued the rectangle after which everything repeats: as many turns of it as were written as `turn` has folds */

/** Where the two edges of a possible seam are compared: irregular, so that no symmetry hides a difference. */
const TEST_FRACTIONS = [0.0371, 0.1618, 0.3183, 0.4669, 0.6181, 0.7724, 0.9143];
/** And where, in turns, the formulas are compared with themselves a turn on. */
const TEST_TURNS = [-0.8291, -0.3717, 0.2893, 0.7137];
const DERIVATIVE_GAP = 1e-7;
/** An offset this near to a simple part of the period, in periods, is that. */
const SIMPLE = 1e-9;
/** Places among which the one that an edge is glued to is looked for, and Newton steps from there. */
const [MATCHES, STEPS] = [64, 6];
const MOST_FOLDS = 6;
/** @type {Gluing} */
const STRAIGHT = { sign: 1, offset: 0 };

/** The partners of places: where the surface is the same a turn before. @param {number[]} places @param {number} direction @param {Gluing} gluing @param {number} span what the direction's coordinate is less */
function partners(places, direction, { sign, offset }, span) {
  return places.map((x, i) => ((i & 1) === direction ? x - span : sign * x + offset));
}

/** Whether two numbers, or neither of them, are there, and no farther apart than this. @param {number} a @param {number} b @param {number} near */
const isNear = (a, b, near) => Math.abs(a - b) <= near || !(Number.isFinite(a) || Number.isFinite(b));

/**
 * The upper edge across a direction, and how large the surface is along the lines across it: what is small is judged on each of them, for the surface may be
 * far larger elsewhere.
 * @param {Jets} jets @param {Range} range @param {number} direction 0: u, 1: v
 */
function sampleEdge(jets, range, direction) {
  const places = linePlaces(range, direction, 1, TEST_FRACTIONS);
  const sizes = TEST_FRACTIONS.map((fraction) => {
    const line = jets(linePlaces(range, 1 - direction, fraction));
    return reach(line, vector(line, 0, 0));
  });
  return { direction, span: range.upper[direction] - range.lower[direction], places, jets: jets(places), sizes };
}

/**
 * Whether the formulas themselves repeat after a turn, over the rectangle and beyond: else what comes after the seam is not the surface.
 * @param {Sampled} surface @param {Range} range @param {Edge} edge @param {Gluing} gluing
 */
function repeats({ jets, metrics, tensors }, range, { direction, span, sizes }, gluing) {
  const beyond = TEST_TURNS.flatMap((turn) => linePlaces(range, direction, turn + 1, TEST_FRACTIONS));
  const within = partners(beyond, direction, gluing, span);
  const measured = (/** @type {number[]} */ places) =>
    tensors ? tensors(places).map((list) => Array.from(list).slice(0, 9)) : metrics(places);
  if (!agree([...measured(within), ...measured(beyond)], signsOf(direction, gluing, tensors !== null))) return false;
  const [before, after] = [jets(within), jets(beyond)];
  return Array.from({ length: beyond.length / 2 }, (_, i) => i).every((i) => {
    const near = POSITION_GAP * sizes[i % sizes.length];
    return [0, 1, 2].every((k) => isNear(before[18 * i + k], after[18 * i + k], near));
  });
}

/**
 * Whether a surface closes smoothly in a direction: S, or E, F and G, and the first derivatives agree on both edges, the edges are curves, not
 * points, and the formulas repeat. A density that does may have a crease there, as elsewhere.
 * @param {Sampled} surface @param {Range} range @param {Edge} edge @param {Gluing} gluing
 */
function closes(surface, range, edge, gluing) {
  const { direction, span, places, jets: high, sizes } = edge;
  const before = partners(places, direction, gluing, span);
  const low = surface.jets(before);
  const meets = sizes.every((size, i) => gap(vector(low, i, 0), vector(high, i, 0)) <= POSITION_GAP * size);
  if (!meets || !(reach(low, vector(low, 0, 0)) > POSITION_GAP * Math.max(...sizes))) return false;
  const list = (/** @type {Float64Array} */ jets, /** @type {number} */ k) => sizes.map((_, i) => vector(jets, i, 3 + 3 * k));
  const turned = (/** @type {number} */ k) => Array(3).fill(k === direction ? 1 : gluing.sign);
  return (
    [0, 1].every((k) =>
      agree([...list(low, k), ...list(high, k)], turned(k), (POSITION_GAP * Math.max(...sizes)) / (range.upper[k] - range.lower[k])),
    ) &&
    (!surface.tensors || agree([...surface.metrics(before), ...surface.metrics(places)], signsOf(direction, gluing, true))) &&
    repeats(surface, range, edge, gluing)
  );
}

/**
 * The sign that each number of what measures length, its values and both first derivatives, changes by across a seam.
 * @param {number} direction @param {Gluing} gluing @param {boolean} isTensor E, F, G, of which F changes; else x, y, z and ρ
 */
function signsOf(direction, { sign }, isTensor) {
  const values = isTensor ? [1, sign, 1] : [1, 1, 1, 1];
  return [1, direction === 0 ? 1 : sign, direction === 0 ? sign : 1].flatMap((own) => values.map((value) => own * value));
}

/** Whether the second half of the lists repeats the first, but for these signs, and for so much as is zero. @param {ArrayLike<number>[]} lists @param {number[]} signs */
function agree(lists, signs, zero = 0) {
  const half = lists.length / 2;
  let largest = 0;
  for (const list of lists) for (const x of Array.from(list)) if (Math.abs(x) > largest && Math.abs(x) < Infinity) largest = Math.abs(x);
  const near = Math.max(DERIVATIVE_GAP * largest, zero);
  return lists.slice(0, half).every((list, i) => Array.from(list).every((x, k) => isNear(signs[k] * x, lists[half + i][k], near)));
}

/** A number, or the multiple of a unit that it nearly is. @param {number} x @param {number} unit */
function snap(x, unit) {
  const multiple = Math.round(x / unit) * unit;
  return Math.abs(x - multiple) < SIMPLE * unit ? multiple : x;
}

/**
 * How a direction may be glued turned over, or shifted: the edges' middle stays in its place, or, where the other direction is closed, any place does.
 * @param {Jets} jets @param {Range} range @param {Edge} edge @param {boolean} isRound the other direction is closed
 * @returns {(Gluing & { folds: number })[]}
 */
function gluings(jets, range, edge, isRound) {
  const other = 1 - edge.direction;
  const [low, high] = [range.lower[other], range.upper[other]];
  if (!isRound) return [{ sign: -1, offset: low + high, folds: 2 }];
  const period = high - low;
  const from = edge.places[other];
  const to = matchOf(jets, range, edge);
  const mirrored = { sign: -1, offset: low + high + snap(to + from - low - high, period / 4), folds: 2 };
  for (let folds = 2; folds <= MOST_FOLDS; folds++) {
    const parts = ((to - from) / period) * folds;
    const whole = Math.round(parts);
    if (Math.abs(parts - whole) < SIMPLE) return [mirrored, { sign: 1, offset: (whole / folds) * period, folds }];
  }
  return [mirrored];
}

/** The other coordinate on the lower edge of the place that is the first one of the upper edge. @param {Jets} jets @param {Range} range @param {Edge} edge */
function matchOf(jets, range, { direction, jets: [...first] }) {
  const other = 1 - direction;
  const fractions = Array.from({ length: MATCHES }, (_, i) => i / MATCHES);
  const places = linePlaces(range, direction, 0, fractions);
  const sampled = jets(places);
  const away = fractions.map((_, i) => gap(vector(sampled, i, 0), first));
  const nearest = 2 * away.indexOf(Math.min(...away));
  const place = places.slice(nearest, nearest + 2);
  for (let step = 0; step < STEPS; step++) {
    const jet = jets(place);
    const speed = vector(jet, 0, other ? 6 : 3);
    const error = [0, 1, 2].map((k) => jet[k] - first[k]);
    place[other] -= dot(error, speed) / dot(speed, speed) || 0;
  }
  return place[other];
}

/**
 * Refuses to close a direction in which the surface does not close, or closes but its formulas go on to somewhere else.
 * @param {Sampled} surface @param {Asked} range @param {Edge} edge
 */
function checkCloses(surface, range, edge) {
  const { jets, tensors } = surface;
  const { direction, span } = edge;
  const name = 'uv'[direction];
  const low = jets(linePlaces(range, direction, 0, TEST_FRACTIONS));
  const gaping = Math.max(...TEST_FRACTIONS.map((_, i) => gap(vector(low, i, 0), vector(edge.jets, i, 0))));
  const refuse = (/** @type {string} */ why) => {
    throw new RangeError(`${range.caller}: periodic.${name}: ${why}`);
  };
  if (!tensors && !(gaping <= POSITION_GAP * diagonal(jets, range)))
    refuse(
      `the surface does not close: it is ${gaping} apart at the ends of ${name}; leave ${name} open, or mend its range, as in [0, '2pi']`,
    );
  if (!repeats(surface, range, edge, STRAIGHT))
    refuse(
      `${tensors ? 'E, F and G do' : 'the surface closes, but its formulas do'} not repeat beyond the ends of ${name}; leave ${name} open, or write ${name} - ${span}*floor((${name} - ${range.lower[direction]})/${span}) for it`,
    );
}

/** How a direction that does not close straight is closed, if it is. @param {Sampled} surface @param {Range} range @param {Edge} edge @param {boolean} isRound the other direction is closed @returns {Turn | null} */
function findTurn(surface, range, edge, isRound) {
  const found = gluings(surface.jets, range, edge, isRound).find((gluing) => closes(surface, range, edge, gluing));
  return found ? { ...found, direction: edge.direction, span: edge.span } : null;
}

/**
 * Which directions are closed: as asked, or, 'auto', where the surface closes smoothly. At most one is turned over or shifted.
 * @param {'auto' | { u?: boolean, v?: boolean }} asked @param {Sampled} surface @param {Asked} range
 * @returns {Glued}
 */
export function findSeams(asked, surface, range) {
  const wanted = asked === 'auto' ? [true, true] : [asked.u === true, asked.v === true];
  const edges = [0, 1].map((direction) => (wanted[direction] ? sampleEdge(surface.jets, range, direction) : null));
  const periodic = edges.map((edge) => edge !== null && closes(surface, range, edge, STRAIGHT));
  /* Without positions nothing tells how edges that do not meet straight are meant to be glued. */
  const hasPositions = asked === 'auto' || !surface.tensors;
  /** @type {Turn | null} */
  let turn = null;
  for (const edge of edges) {
    if (!edge || periodic[edge.direction]) continue;
    const { direction } = edge;
    /** @type {Turn | null} */
    const found = hasPositions && !turn ? findTurn(surface, range, edge, periodic[1 - direction]) : null;
    if (!found && asked !== 'auto') checkCloses(surface, range, edge);
    periodic[direction] = asked !== 'auto' || found !== null;
    turn ??= found;
  }
  const upper = range.upper.map((end, j) => (turn?.direction === j ? range.lower[j] + turn.folds * turn.span : end));
  return { lower: range.lower, upper, periodic, turn };
}
