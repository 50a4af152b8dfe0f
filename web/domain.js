/** The parameter rectangle of a surface: its ranges, which directions are closed, and lifts of points across a seam. Knows only evaluations of S and its derivatives. */

/** @typedef {{ lower: number[], upper: number[] }} Range */
/** @typedef {Range & { caller: string }} Asked a range, and for whom it was read */
/** @typedef {{ pole: number, beyond: number, at: Float64Array | null, radius: number, smooth: boolean }} Tip an edge, 1 + 2 · coordinate + side; how far beyond it, in the coordinate across, the surface collapses to a point; negative: inside the rectangle; that point, where it is known; how far the edge is from it, in space; and whether the surface is smooth there and closed around it */
/** @typedef {Range & { periodic: boolean[], poles: number[], tips: Tip[], around: { along: number, most: number }[] }} Domain poles: edges that collapse to a point, 1 + 2 · coordinate + side; tips: these, and edges that almost do; around: of the edges of tips along which the direction across turns by more than half a turn, the coordinate along them, and what that changes by in HALF_AROUND */
/** @typedef {(points: number[]) => Float64Array} Jets 18 numbers a point (u, v): S, S_u, S_v, S_uu, S_uv, S_vv */
/** @typedef {(points: number[]) => ArrayLike<number>[]} Sampler */
/** @typedef {{ jets: Jets, metrics: Sampler, tensors: Sampler | null }} Sampled `metrics`: for each point what measures length there, and its first derivatives; none where space does. `tensors`: E F G, where they do */

/** Where the two edges of a possible seam are compared: irregular, so that no symmetry hides a difference. */
const TEST_FRACTIONS = [0.0371, 0.1618, 0.3183, 0.4669, 0.6181, 0.7724, 0.9143];
const GRID = 16;
const FRACTIONS = Array.from({ length: GRID + 1 }, (_, i) => i / GRID);
const POSITION_GAP = 1e-9;
const DERIVATIVE_GAP = 1e-7;
/** An edge that is almost a point: the point is so near, in parts of the range, and equally near everywhere along the edge, up to this part of that. */
const NEAR_POINT = 0.05;
const SAME_POINT = 0.1;
/** The surface is smooth at a point if derivatives around it differ from those of a plane by less, as SMOOTH of wasm/polar.c. */
const FLAT = 1e-5;
/** So near to a point, in parts of the range, a metric is as at it. */
const BESIDE = 1e-4;
/** Radians: half a turn, and some. */
const HALF_AROUND = 1.2 * Math.PI;
/** Of the range. */
const ROUNDING = 2e-15;

/** @param {Float64Array} jets @param {number} i @param {number} offset of three numbers in a jet */
const vector = (jets, i, offset) => jets.subarray(18 * i + offset, 18 * i + offset + 3);

/** @param {ArrayLike<number>} a @param {ArrayLike<number>} b */
export const gap = (a, b) => Math.sqrt((a[0] - b[0]) ** 2 + (a[1] - b[1]) ** 2 + (a[2] - b[2]) ** 2);

/** @param {ArrayLike<number>} a @param {ArrayLike<number>} b */
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

/** The largest distance from a point to those of these samples that are finite. @param {Float64Array} jets @param {ArrayLike<number>} point */
function reach(jets, point) {
  let farthest = 0;
  for (let i = 0; i < jets.length / 18; i++) {
    const away = gap(vector(jets, i, 0), point);
    if (away > farthest && away < Infinity) farthest = away;
  }
  return farthest;
}

/** 17 × 17 places. @param {Range} range */
function gridPlaces({ lower, upper }) {
  const places = [];
  for (let i = 0; i <= GRID; i++)
    for (let j = 0; j <= GRID; j++)
      places.push(lower[0] + (i / GRID) * (upper[0] - lower[0]), lower[1] + (j / GRID) * (upper[1] - lower[1]));
  return places;
}

/** Diagonal of the bounding box of those of these samples that are finite. @param {Jets} jets @param {Range} range */
function diagonal(jets, range) {
  const places = gridPlaces(range);
  const sampled = jets(places);
  const [low, high] = [
    [Infinity, Infinity, Infinity],
    [-Infinity, -Infinity, -Infinity],
  ];
  for (let i = 0; i < places.length / 2; i++)
    for (let k = 0; k < 3; k++) {
      if (Number.isFinite(sampled[18 * i + k])) {
        low[k] = Math.min(low[k], sampled[18 * i + k]);
        high[k] = Math.max(high[k], sampled[18 * i + k]);
      }
    }
  return gap(low, high);
}

/** Places along a line of the rectangle. @param {Range} range @param {number} direction of the coordinate that is constant there @param {number} side where: 0, the lower edge, to 1, the upper @param {number[]} fractions */
function linePlaces({ lower, upper }, direction, side, fractions) {
  const other = 1 - direction;
  const constant = (1 - side) * lower[direction] + side * upper[direction];
  return fractions.flatMap((fraction) => {
    const along = lower[other] + fraction * (upper[other] - lower[other]);
    return direction === 0 ? [constant, along] : [along, constant];
  });
}

/**
 * Edges that are one point: a pole, an apex. They are compared with the line beside them: the surface may be far larger elsewhere.
 * @param {Sampled} surface @param {Range} range
 */
function findPoles({ jets, tensors }, range) {
  const isPoint = tensors ? hasNoLength(tensors, range) : isOnePlace(jets);
  return [0, 1, 2, 3]
    .filter((edge) => {
      const [direction, side] = [edge >> 1, edge & 1];
      const beside = linePlaces(range, direction, Math.abs(side - 1 / GRID), FRACTIONS);
      return isPoint(linePlaces(range, direction, side, FRACTIONS), beside, 1 - direction);
    })
    .map((edge) => edge + 1);
}

/**
 * An edge that is almost a point, as where 3.14 stands for π: the speed along it vanishes at a point a little beyond, extrapolated, or before.
 * @param {Jets} jets @param {Range} range @param {boolean[]} periodic @param {number} pole the edge
 * @returns {Tip[]} none or one
 */
function findHole(jets, range, periodic, pole) {
  const [direction, side] = [(pole - 1) >> 1, (pole - 1) & 1];
  const span = range.upper[direction] - range.lower[direction];
  const place = (/** @type {number} */ fraction) => linePlaces(range, direction, fraction, FRACTIONS);
  /** Where the speed vanishes, in parts of the range from here; NaN where it turns instead. @param {number} fraction */
  const offsetsAt = (fraction) => {
    const sampled = jets(place(fraction));
    return FRACTIONS.map((_, i) => {
      const [speed, change] = [vector(sampled, i, direction ? 3 : 6), vector(sampled, i, 12)];
      const [product, squared] = [dot(speed, change), dot(change, change)];
      return product ** 2 >= (1 - SAME_POINT) * dot(speed, speed) * squared ? -product / (squared * span) : Number.NaN;
    });
  };
  const offsets = offsetsAt(side);
  const [first] = offsets;
  const isNear = Math.abs(first) <= NEAR_POINT && offsets.every((offset) => Math.abs(offset - first) <= SAME_POINT * Math.abs(first));
  if (!isNear) return [];
  const exact = side + first + offsetsAt(side + first)[0];
  /* Not behind the point, not even by rounding: there the normal has turned over. */
  const before = exact - ROUNDING * (2 * side - 1);
  if (isOnePlace(jets)(place(before), place(Math.abs(side - 1 / GRID)))) return [tipAt(jets, range, periodic, pole, before)];
  const beyond = (side ? span : -span) * first;
  return beyond > 0 ? [{ pole, beyond, at: null, radius: 0, smooth: false }] : [];
}

/** The point to which lines across lead. @param {Jets} jets @param {Range} range @param {boolean[]} periodic @param {number} pole @param {number} fraction where @returns {Tip} */
function tipAt(jets, range, periodic, pole, fraction) {
  const [direction, side] = [(pole - 1) >> 1, (pole - 1) & 1];
  const sampled = jets(linePlaces(range, direction, fraction, FRACTIONS));
  const at = vector(sampled, 0, 0);
  const beyond = (fraction - side) * (side ? 1 : -1) * (range.upper[direction] - range.lower[direction]);
  return {
    pole,
    beyond,
    at,
    radius: reach(jets(linePlaces(range, direction, side, FRACTIONS)), at),
    smooth: periodic[1 - direction] && isFlat(sampled, direction),
  };
}

/** Whether the derivatives across a point are those of a plane around it, a cos θ + b sin θ, equal steps of the coordinate along those of θ. @param {Float64Array} sampled @param {number} direction */
function isFlat(sampled, direction) {
  const across = (/** @type {number} */ i) => vector(sampled, i, direction ? 6 : 3);
  /* 2 cos(2π/16), as GRID is 16. */
  const twice = Math.sqrt(2 + Math.SQRT2);
  const size = Math.max(...FRACTIONS.map((_, i) => Math.sqrt(dot(across(i), across(i)))));
  return FRACTIONS.slice(2).every(
    (_, i) =>
      gap(
        across(i).map((x, k) => x + across(i + 2)[k]),
        across(i + 1).map((x) => twice * x),
      ) <=
      FLAT * size,
  );
}

/**
 * By how much the direction across turns along a line of the rectangle: radians, exact where it stays in a plane.
 * @param {Jets} jets @param {number[]} places @param {number} direction
 */
function turning(jets, places, direction) {
  const sampled = jets(places);
  const across = FRACTIONS.map((_, i) => vector(sampled, i, direction ? 6 : 3)).map((x) => x.map((part) => part / Math.sqrt(dot(x, x))));
  return across.slice(1).reduce((sum, x, i) => {
    /* Twice the arcsine of half the chord, as in wasm/pole.c. */
    const [chord, square] = [gap(x, across[i]), gap(x, across[i]) ** 2];
    return sum + chord * (1 + (square / 24) * (1 + ((9 * square) / 80) * (1 + (25 * square) / 168)));
  }, 0);
}

/** @param {Jets} jets */
function isOnePlace(jets) {
  return (/** @type {number[]} */ places, /** @type {number[]} */ beside) => {
    const sampled = jets(places);
    const first = vector(sampled, 0, 0);
    const near = POSITION_GAP * reach(jets(beside), first);
    return FRACTIONS.every((_, i) => gap(vector(sampled, i, 0), first) <= near);
  };
}

/** Where E, F and G measure length they tell what is a point: the speed along the edge vanishes. @param {Sampler} tensors @param {Range} range */
function hasNoLength(tensors, range) {
  const span = [0, 1].map((j) => range.upper[j] - range.lower[j]);
  const lengthOf = (/** @type {ArrayLike<number>} */ tensor, /** @type {number} */ j) => Math.sqrt(Math.abs(tensor[2 * j])) * span[j];
  return (/** @type {number[]} */ places, /** @type {number[]} */ beside, /** @type {number} */ along) => {
    const lengths = tensors(beside).flatMap((tensor) => [lengthOf(tensor, 0), lengthOf(tensor, 1)]);
    const least = POSITION_GAP * Math.max(0, ...lengths.filter(Number.isFinite));
    return tensors(places).every((tensor) => lengthOf(tensor, along) <= least);
  };
}

/**
 * Whether E, F and G around an edge that is a point are those of a plane around it, once around.
 * @param {Sampler} tensors @param {Range} range @param {number} pole
 */
function isRound(tensors, range, pole) {
  const [across, side] = [(pole - 1) >> 1, (pole - 1) & 1];
  const [away, turn] = [across, 1 - across].map((j) => range.upper[j] - range.lower[j]);
  const circle = (2 * Math.PI * BESIDE * away) / turn;
  const edge = tensors(linePlaces(range, across, side, FRACTIONS)).map((tensor) => tensor[2 * across]);
  const beside = tensors(linePlaces(range, across, Math.abs(side - BESIDE), FRACTIONS));
  const is = (/** @type {number} */ x, /** @type {number} */ expected) => Math.abs(x / edge[0] - expected) <= FLAT;
  return beside.every((tensor, i) => is(edge[i], 1) && is(tensor[1] / circle, 0) && is(tensor[2 - 2 * across] / circle ** 2, 1));
}

/**
 * Whether a surface closes smoothly in a direction: S, what measures length on it, and the first derivatives agree on both edges, and the edges
 * are curves, not points.
 * A seam that turns the surface over (Möbius strip) is not closed in this sense: its edges stay walls. What is small is judged on each line across:
 * the surface may be far larger elsewhere.
 * @param {Sampled} surface @param {Range} range @param {number} direction 0: u, 1: v
 */
function closes({ jets, metrics }, range, direction) {
  const edges = [0, 1].map((side) => linePlaces(range, direction, side, TEST_FRACTIONS));
  const [low, high] = edges.map(jets);
  if (!agree(metrics(edges.flat()))) return false;
  const sizes = TEST_FRACTIONS.map((fraction, i) => reach(jets(linePlaces(range, 1 - direction, fraction, FRACTIONS)), vector(low, i, 0)));
  const meets = sizes.every((size, i) => gap(vector(low, i, 0), vector(high, i, 0)) <= POSITION_GAP * size);
  return meets && reach(low, vector(low, 0, 0)) > POSITION_GAP * Math.max(...sizes) && [3, 6].every((offset) => agreeIn(low, high, offset));
}

/** Whether a derivative is the same on both edges. @param {Float64Array} low @param {Float64Array} high jets there @param {number} offset of the derivative */
function agreeIn(low, high, offset) {
  const list = (/** @type {Float64Array} */ jets) => TEST_FRACTIONS.map((_, i) => vector(jets, i, offset));
  return agree([...list(low), ...list(high)]);
}

/**
 * Refuses to close a direction in which the surface does not close, or in which it closes turned over: a lift would have to turn the other coordinate round.
 * @param {Jets} jets @param {Asked} range @param {number} size of the surface @param {number} direction
 */
function checkCloses(jets, range, size, direction) {
  const low = jets(linePlaces(range, direction, 0, TEST_FRACTIONS));
  const apart = (/** @type {number[]} */ fractions) => {
    const high = jets(linePlaces(range, direction, 1, fractions));
    return Math.max(...fractions.map((_, i) => gap(vector(low, i, 0), vector(high, i, 0))));
  };
  const gaping = apart(TEST_FRACTIONS);
  if (gaping <= POSITION_GAP * size) return;
  const name = 'uv'[direction];
  const why =
    apart(TEST_FRACTIONS.map((fraction) => 1 - fraction)) <= POSITION_GAP * size
      ? `meets itself turned over at the ends of ${name}, as a Möbius strip does; leave ${name} open, or double its range`
      : `does not close: it is ${gaping} apart at the ends of ${name}; leave ${name} open, or mend its range, as in [0, '2pi']`;
  throw new RangeError(`${range.caller}: periodic.${name}: the surface ${why}`);
}

/** Whether the second half of the lists repeats the first. @param {ArrayLike<number>[]} lists */
function agree(lists) {
  const half = lists.length / 2;
  let [apart, largest] = [0, 0];
  for (let i = 0; i < half; i++)
    for (let k = 0; k < lists[i].length; k++) {
      apart = Math.max(apart, Math.abs(lists[i][k] - lists[half + i][k]));
      largest = Math.max(largest, Math.abs(lists[i][k]));
    }
  return apart <= DERIVATIVE_GAP * largest;
}

/**
 * What a rectangle is glued to: which directions are periodic, as asked, or, 'auto', where the surface closes; and which edges are points.
 * @param {'auto' | { u?: boolean, v?: boolean }} asked @param {Sampled} surface @param {Asked} range
 * @returns {Domain}
 */
export function findDomain(asked, surface, range) {
  const { lower, upper } = range;
  if (asked !== 'auto' && !surface.tensors) {
    const size = diagonal(surface.jets, range);
    for (const direction of [0, 1]) if ([asked.u, asked.v][direction]) checkCloses(surface.jets, range, size, direction);
  }
  const periodic = asked === 'auto' ? [0, 1].map((direction) => closes(surface, range, direction)) : [asked.u === true, asked.v === true];
  const poles = findPoles(surface, range);
  const { jets, tensors } = surface;
  /** Radians by which the direction across turns along an edge. @param {number} pole */
  const turned = (pole) => {
    const direction = (pole - 1) >> 1;
    return turning(jets, linePlaces(range, direction, (pole - 1) & 1, FRACTIONS), direction);
  };
  const winding = tensors ? [] : [1, 2, 3, 4].filter((pole) => turned(pole) > Math.PI);
  const holes = winding.filter((pole) => !poles.includes(pole)).flatMap((pole) => findHole(jets, range, periodic, pole));
  /* Where E, F and G measure length, positions tell nothing. */
  const tips = [
    ...poles.map((pole) =>
      tensors
        ? { pole, beyond: 0, at: null, radius: 0, smooth: periodic[pole > 2 ? 0 : 1] && isRound(tensors, range, pole) }
        : tipAt(jets, range, periodic, pole, (pole - 1) & 1),
    ),
    ...holes,
  ];
  const around = winding
    .filter((pole) => tips.some((tip) => tip.pole === pole))
    .map((pole) => {
      const along = pole > 2 ? 0 : 1;
      return { along, most: (HALF_AROUND / turned(pole)) * (upper[along] - lower[along]) };
    });
  return { lower, upper, periodic, poles, tips, around };
}

/**
 * A point of the rectangle: inside it up to rounding, anywhere in a periodic direction.
 * @param {Domain} domain @param {number[]} point @param {string} name for messages
 */
export function enterDomain({ lower, upper, periodic }, point, name) {
  return point.map((x, j) => {
    const [low, high] = [lower[j], upper[j]];
    const slack = 1e-12 * (high - low);
    if (periodic[j]) return x;
    if (x < low - slack || x > high + slack)
      throw new RangeError(`${name}[${j}] = ${x} lies outside the range of ${'uv'[j]}, [${low}, ${high}]`);
    return Math.min(Math.max(x, low), high);
  });
}

/**
 * The ends on the lifts where they are solved: near each other, or near the given start; the lexicographically smaller one stays, so that
 * exchanging the ends gives the same problem.
 * @param {Domain} domain @param {number[]} from @param {number[]} to @param {Float64Array | null} start u v of its points
 */
export function liftEnds(domain, from, to, start) {
  if (start) return [liftNear(domain, from, [start[0], start[1]]), liftNear(domain, to, Array.from(start.subarray(-2)))];
  const swap = from[0] !== to[0] ? from[0] > to[0] : from[1] > to[1];
  return swap ? [liftNear(domain, from, to), to] : [from, liftNear(domain, to, from)];
}

/**
 * The lift of a point nearest to another: moved by whole periods.
 * @param {Domain} domain @param {number[]} point @param {number[]} near
 */
export function liftNear({ lower, upper, periodic }, point, near) {
  return point.map((x, j) => {
    const period = upper[j] - lower[j];
    return periodic[j] ? x - period * Math.round((x - near[j]) / period) : x;
  });
}

/** Whether a point lies on this edge of the rectangle. @param {Range} range @param {number[]} point @param {number} pole 1 + 2 · coordinate + side */
export function isAtPole({ lower, upper }, point, pole) {
  const [across, side] = [(pole - 1) >> 1, (pole - 1) & 1];
  return point[across] === (side ? upper : lower)[across];
}

/** Whether a point lies on an edge that is one point, so that its coordinate along that edge says nothing. @param {Domain} domain @param {number[]} point @returns {number} that coordinate: 0, 1, or -1 */
function freeCoordinate(domain, point) {
  const at = domain.poles.find((pole) => isAtPole(domain, point, pole));
  return at === undefined ? -1 : 1 - ((at - 1) >> 1);
}

/**
 * Two ends, one that is a pole moved along its edge to face the other: a path leaves a pole along the meridian of its other end, and would else have to turn
 * round in the chart first.
 * @param {Domain | null} domain @param {number[]} a @param {number[]} b @returns {number[][]}
 */
export function facePoles(domain, a, b) {
  if (!domain) return [a, b];
  const face = (/** @type {number[]} */ point, /** @type {number[]} */ other) => {
    const free = freeCoordinate(domain, point);
    return free < 0 ? point : point.map((x, j) => (j === free ? other[j] : x));
  };
  const second = face(b, a);
  return freeCoordinate(domain, b) < 0 ? [face(a, b), b] : [a, second];
}
