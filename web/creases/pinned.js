/** Paths that turn at corners: from each to the next as a path of its own. MATH.md, "Corners". */

import { concatenate } from '../search/join.js';
import { relax } from '../search/routes.js';
import { cornersNear, passing } from './corners.js';
import { lengthOf, lineOf, nodesOf, span } from './legs.js';
import { ahead, apart, sizeBy } from './linear.js';
import { SKETCH_POINTS } from './sketches.js';

/** @typedef {import('./corners.js').Corner} Corner */
/** @typedef {import('./legs.js').Question} Question */
/** @typedef {import('./legs.js').Route} Route */
/** @typedef {(question: Question, line: Float64Array, length: number) => Route | null} Follow the path that a polyline leads to, of about so long */

/** A polyline passes corners that are nearer to it than this part of its length; one that came to rest where it does not hold, and passes none, those nearer than the second. */
const [NEAR, FARTHER] = [0.03, 0.4];
/** Beside a corner so many nodes of a polyline do not tell where a path leads. */
const UNCLEAR = 2;
/** What leads past a corner does so at this part of the shorter leg that meets there. */
const BESIDE = 0.1;
/** So often a path that came to rest where it does not hold tells which corners it slid over. */
const MOST_ROUNDS = 3;
/** Corners nearer to each other than this part of the path are one. */
const SAME = 1e-6;

/**
 * The path that a polyline leads to, through corners that hold it and past those that do not.
 * @param {Question} question @param {Float64Array} line @param {number} length of it @param {Follow} follow what leads from one corner to the next
 * @returns {{ route: Route, isClear: boolean } | null} isClear: no corner is near
 */
export function followPinned(question, line, length, follow) {
  const { sides, budget } = question;
  const near = SAME * span(line, sides.scale);
  /** @type {Corner[]} */
  const passed = [];
  const isPassed = (/** @type {Corner} */ { place }) => passed.some((other) => apart(other.place, place, sides.scale) <= near);
  for (let round = 0; round < MOST_ROUNDS; round++) {
    const within = (/** @type {number} */ near) => cornersNear(question, line, near).filter((corner) => !isPassed(corner));
    let corners = within(NEAR);
    if (round > 0 && corners.length === 0) corners = within(FARTHER);
    if (round > 0 && corners.length === 0) break;
    budget.lost = null;
    const found = corners.length > 0 ? pin(question, line, corners, passed, follow) : follow(question, line, length);
    if (found) return { route: found, isClear: round === 0 && corners.length === 0 };
    if (!budget.lost) break;
    line = budget.lost;
  }
  return null;
}

/**
 * The path near a polyline through these corners, or past them. null: what leads from one to the next is not found; then what is lost is the whole polyline.
 * @param {Question} question @param {Float64Array} line @param {Corner[]} corners @param {Corner[]} passed takes those that do not hold it @param {Follow} follow @returns {Route | null}
 */
function pin(question, line, corners, passed, follow) {
  const { field, ends, budget } = question;
  const width = ends[0].length;
  const endsOf = (/** @type {number} */ i) => [corners[i - 1]?.place ?? ends[0], corners[i]?.place ?? ends[1]];
  /** @type {{ route: Route | null, lost: Float64Array }[]} */
  const parts = between(line, width, corners).map((inner, i) => {
    const [from, to] = endsOf(i);
    const start = Float64Array.from([...from, ...inner, ...to]);
    const { parameters, points, length } = relax(field, [from, to], start, SKETCH_POINTS);
    return length >= 0 ? tryPart([from, to], parameters ?? points, length) : tryPart([from, to], start, span(start, question.sides.scale));
  });
  /** @param {number[][]} places @param {Float64Array} start @param {number} length */
  function tryPart(places, start, length) {
    budget.lost = null;
    const route = follow({ ...question, ends: places }, start, length);
    return { route, lost: budget.lost ?? start };
  }
  while (parts.every(({ route }) => route)) {
    const found = parts.map(({ route }) => /** @type {Route} */ (route));
    const ways = corners.map((corner, i) => passing(question, corner, lastOf(found[i].legs), found[i + 1].legs[0]));
    const loose = ways.findIndex((way) => !way?.isHeld);
    if (loose < 0) return joined(found, corners);
    const way = ways[loose];
    if (!way) return null;
    const [before, after] = found.slice(loose, loose + 2);
    const past = around(question.sides.scale, before, after, corners[loose], way.rays);
    passed.push(...corners.splice(loose, 1));
    parts.splice(loose, 2, tryPart(endsOf(loose), past, lengthOf([...before.legs, ...after.legs])));
  }
  budget.lost = concatenate(
    parts.map(({ route, lost }) => (route ? lineOf(route.legs, width) : lost)),
    width,
  );
  return null;
}

/** The nodes of a polyline between corners, but for those beside them. @param {Float64Array} line @param {number} width @param {Corner[]} corners */
function between(line, width, corners) {
  const last = line.length / width - 1;
  return [...corners, null].map((corner, i) => {
    const from = i > 0 ? corners[i - 1].at + UNCLEAR + 1 : 1;
    const to = corner ? corner.at - UNCLEAR : last;
    return line.subarray(width * from, width * Math.max(from, to));
  });
}

/** @template T @param {T[]} list @returns {T} */
const lastOf = (list) => list[list.length - 1];

/** A polyline along two paths that meet at a corner, past that. @param {readonly number[]} scale @param {Route} before @param {Route} after @param {Corner} corner @param {number[][]} rays directions of creases between them */
function around(scale, before, after, { place }, rays) {
  const width = place.length;
  const [last, first] = [lastOf(before.legs), after.legs[0]];
  const reach = BESIDE * Math.min(span(last.line, scale), span(first.line, scale));
  const isClear = (/** @type {number[]} */ node) => apart(node, place, scale) > reach;
  const nodes = [before, after].map(({ legs }) => legs.flatMap(({ line }) => nodesOf(line, width)));
  const turned = rays.map((ray) => ahead(place, ray, reach / sizeBy(ray, scale)));
  return Float64Array.from([...nodes[0].filter(isClear), ...turned, ...nodes[1].filter(isClear)].flat());
}

/** @param {Route[]} parts @param {Corner[]} corners between them @returns {Route} */
const joined = (parts, corners) => ({
  legs: parts.flatMap(({ legs }) => legs),
  joints: parts.flatMap(({ joints }, i) => (i ? [jointAt(corners[i - 1]), ...joints] : joints)),
});

/** @param {Corner} corner @returns {import('./legs.js').Joint} */
const jointAt = ({ creases: [crease], signs, place }) => ({ crease, signs, place, isCorner: true });
