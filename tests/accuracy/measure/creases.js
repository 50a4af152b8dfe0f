/**
 * Random pairs on surfaces with creases, judged without the solver: flat faces unfold; what is joined along circles has known lengths on both sides of each, and the
 * shortest crossings are looked for on a grid. Where neither helps, a path must be as long as the points on it say, and no start that is bent sideways may lead to a
 * shorter one. Knows nothing of how answers are printed.
 */
import { add, scale, unit } from '../../helpers/reference.js';
import { unfold } from '../../helpers/unfold.js';

/** @typedef {import('../../../web/index.js').Path} Path */
/** @typedef {import('../../../web/index.js').Surface} Surface */
/** @typedef {import('../../../web/instance.js').AnyDefinition} AnyDefinition */
/** @typedef {import('../../helpers/random.js').Random} Random */
/** @typedef {(from: number[], to: number[]) => number} Distance */
/** @typedef {(from: number[], to: number[]) => number[]} Ways how long those are that no small change makes shorter, among others */
/**
 * ways: between two places x y z, the shortest among them; null: they are not known. height: z over x, y; or level: what vanishes on an implicit body around the origin.
 * @typedef {object} Creased
 * @property {AnyDefinition} definition
 * @property {Ways | null} ways
 * @property {(x: number, y: number) => number} [height]
 * @property {(x: number, y: number, z: number) => number} [level]
 */
/**
 * verdict: refused: not converged; longer: one of the ways, but not the shortest; wrong: off by more than tolerances allow, or not as long as its points say, or off the
 * surface, or longer than a path that a bent start leads to. expected: the shortest way or, where it is not known, the best of the path and those of the bent starts.
 * error: relative, of the length.
 * @typedef {{ from: number[], to: number[], status: string, length: number, expected: number, error: number, verdict: 'right' | 'longer' | 'wrong' | 'refused', milliseconds: number }} Answer
 */

/** Two tolerances of 1e-9, relative. */
const RIGHT = 2e-9;
/** Distance from the surface, in a value of its formula. */
const ON = 1e-9;
/** Inner points of a path that is measured; chords cut corners and curves by less than this part. */
const [SEEN, CHORDS] = [1000, 1e-3];
/** How far starts are bent sideways, in parts of the distance of the ends. */
const BENDS = [-0.6, -0.25, -0.08, 0.08, 0.25, 0.6];
const BEND_POINTS = 33;
const SIDE = 2;

// Flat faces

/** Corners of the square, and the origin, raised. @param {(x: number, y: number) => number} height @param {number[][]} corners @param {number[][]} faces */
const facesOver = (height, corners, faces) =>
  unfold(
    corners.map(([x, y]) => [x, y, height(x, y)]),
    faces,
  );

const OVER_HALVES = [
  [-SIDE, -SIDE],
  [0, -SIDE],
  [SIDE, -SIDE],
  [SIDE, SIDE],
  [0, SIDE],
  [-SIDE, SIDE],
];
const HALVES = [
  [0, 1, 4, 5],
  [1, 2, 3, 4],
];
const OVER_QUARTERS = [
  [0, 0],
  ...[0, 1, 2, 3, 4, 5, 6, 7].map((k) => [0, 2].map((turn) => SIDE * Math.sign(Math.round(2 * Math.cos(((k - turn) * Math.PI) / 4))))),
];
/** Between the diagonals, and between the axes. */
const [WEDGES, QUADRANTS] = [
  [1, 3, 5, 7].map((k) => [0, k + 1, ((k + 1) % 8) + 1, ((k + 2) % 8) + 1]),
  [0, 2, 4, 6].map((k) => [0, k + 1, k + 2, ((k + 2) % 8) + 1]),
];

function cubeFaces() {
  const corners = Array.from({ length: 8 }, (_, bits) => [0, 1, 2].map((k) => ((bits >> k) & 1 ? 1 : -1)));
  const faces = [0, 1, 2].flatMap((k) => {
    const [a, b] = [1 << ((k + 1) % 3), 1 << ((k + 2) % 3)];
    return [
      [1 << k, (1 << k) + a, (1 << k) + a + b, (1 << k) + b],
      [b, a + b, a, 0],
    ];
  });
  return unfold(corners, faces);
}

function octahedronFaces() {
  const corners = [0, 1, 2].flatMap((k) => [1, -1].map((sign) => [0, 1, 2].map((j) => (j === k ? sign : 0))));
  const faces = Array.from({ length: 8 }, (_, bits) => {
    const [x, y, z] = [0, 1, 2].map((k) => 2 * k + ((bits >> k) & 1));
    return (bits & 1) ^ ((bits >> 1) & 1) ^ ((bits >> 2) & 1) ? [y, x, z] : [x, y, z];
  });
  return unfold(corners, faces);
}

// Joined along circles

/** @typedef {{ at: (angle: number) => number[], joins: [string, string] }} Rim a circle, and the names of what it joins */

/**
 * Ways over parts that circles join, crossing these so often at most.
 * @param {(place: number[]) => string} partOf @param {Record<string, Distance>} within each part @param {Rim[]} rims @param {number} most @returns {Ways}
 */
function joined(partOf, within, rims, most) {
  /** Over these rims, one after the other. @param {number[]} from @param {number[]} to @param {Rim[]} over @param {string[]} parts */
  const over = (from, to, over, parts) =>
    lowPlaces(over.length, (angles) => {
      const places = [from, ...over.map(({ at }, i) => at(angles[i])), to];
      return parts.reduce((sum, part, i) => sum + within[part](places[i], places[i + 1]), 0);
    });
  return (from, to) => {
    const last = partOf(to);
    /** @param {Rim[]} crossed @param {string[]} parts @returns {number[]} */
    const goOn = (crossed, parts) => {
      const part = parts[parts.length - 1];
      const here = part === last ? over(from, to, crossed, parts) : [];
      const next = crossed.length < most ? rims.filter(({ joins }) => joins.includes(part)) : [];
      return [...here, ...next.flatMap((rim) => goOn([...crossed, rim], [...parts, rim.joins[rim.joins[0] === part ? 1 : 0]]))];
    };
    return goOn([], [partOf(from)]);
  };
}

/** A function of angles where it is lower than around: on a grid, then on ever finer ones. @param {number} count @param {(angles: number[]) => number} f */
function lowPlaces(count, f) {
  if (count === 0) return [f([])];
  const spaces = 24;
  const step = (2 * Math.PI) / spaces;
  const total = spaces ** count;
  const anglesOf = (/** @type {number} */ k) => Array.from({ length: count }, (_, j) => step * (Math.floor(k / spaces ** j) % spaces));
  const values = Float64Array.from({ length: total }, (_, k) => f(anglesOf(k)));
  const beside = (/** @type {number} */ k, /** @type {number} */ j, /** @type {number} */ by) => {
    const digit = Math.floor(k / spaces ** j) % spaces;
    return k + (((digit + by + spaces) % spaces) - digit) * spaces ** j;
  };
  return Array.from({ length: total }, (_, k) => k)
    .filter((k) =>
      Array.from({ length: count }, (_, j) => j).every((j) => values[k] <= Math.min(values[beside(k, j, 1)], values[beside(k, j, -1)])),
    )
    .map((k) => refine(anglesOf(k), step, f));
}

/** The lowest value near by. @param {number[]} centre @param {number} width @param {(angles: number[]) => number} f */
function refine(centre, width, f) {
  const side = 5;
  let at = centre;
  let value = f(at);
  for (let half = width; half > 1e-9; half *= 0.6) {
    const middle = at;
    for (let k = 0; k < side ** middle.length; k++) {
      const tried = middle.map((x, j) => x + half * ((2 * (Math.floor(k / side ** j) % side)) / (side - 1) - 1));
      const there = f(tried);
      if (there < value) [at, value] = [tried, there];
    }
  }
  return value;
}

/** @type {Distance} */
const straight = (a, b) => Math.hypot(...a.map((x, k) => x - b[k]));

/** The angle between two directions in a plane, 0 … π. @param {number} a @param {number} b */
const between = (a, b) => Math.abs(Math.atan2(Math.sin(a - b), Math.cos(a - b)));

/** Around a disc of radius 1 in the plane. @type {Distance} */
function aroundDisc([ax, ay], [bx, by]) {
  const [a, b] = [Math.hypot(ax, ay), Math.hypot(bx, by)];
  const wound = between(Math.atan2(ay, ax), Math.atan2(by, bx)) - Math.acos(Math.min(1, 1 / a)) - Math.acos(Math.min(1, 1 / b));
  if (!(wound > 0)) return Math.hypot(ax - bx, ay - by);
  return Math.sqrt(Math.max(0, a * a - 1)) + Math.sqrt(Math.max(0, b * b - 1)) + wound;
}

/** On a cone of slope 1 whose apex is over the origin, unrolled. @type {Distance} */
function onCone([ax, ay], [bx, by]) {
  const [a, b] = [Math.hypot(ax, ay), Math.hypot(bx, by)];
  const angle = between(Math.atan2(ay, ax), Math.atan2(by, bx)) / Math.SQRT2;
  return Math.SQRT2 * Math.hypot(a - b * Math.cos(angle), b * Math.sin(angle));
}

/** On a cylinder of radius 1 around the z axis. @type {Distance} */
const onCylinder = ([ax, ay, az], [bx, by, bz]) => Math.hypot(between(Math.atan2(ay, ax), Math.atan2(by, bx)), az - bz);

/** On the unit sphere. @type {Distance} */
const onSphere = (a, b) => 2 * Math.asin(Math.min(1, straight(a, b) / 2));

/** On a unit sphere around `middle` on the x axis, around its cap beyond the plane x = 0. @param {number} middle @returns {Distance} */
function aroundCap(middle) {
  const radius = Math.acos(Math.abs(middle));
  return (a, b) => {
    const [p, q] = [a, b].map(([x, y, z]) => {
      const far = Math.acos(Math.max(-1, Math.min(1, (x - middle) * -Math.sign(middle))));
      const tangent = Math.acos(Math.min(1, Math.cos(far) / Math.cos(radius)));
      const turn = far > radius ? Math.acos(Math.max(-1, Math.min(1, Math.tan(radius) / Math.tan(far)))) : 0;
      return { angle: Math.atan2(z, y), tangent, turn };
    });
    const wound = between(p.angle, q.angle) - p.turn - q.turn;
    return wound > 0 ? p.tangent + q.tangent + Math.sin(radius) * wound : onSphere(a, b);
  };
}

/** A circle across the z axis. @param {number} radius @param {number} z @param {[string, string]} joins @returns {Rim} */
const rimAt = (radius, z, joins) => ({ at: (angle) => [radius * Math.cos(angle), radius * Math.sin(angle), z], joins });

// The surfaces

/** A graph over the square. @param {string} z @param {(x: number, y: number) => number} height @param {Ways | null} ways @returns {Creased} */
const graph = (z, height, ways) => ({
  definition: { kind: 'graph', z, x: [-SIDE, SIDE], y: [-SIDE, SIDE] },
  height,
  ways,
});

/** A body around the origin. @param {string} f @param {(x: number, y: number, z: number) => number} level @param {Ways} ways @returns {Creased} */
const body = (f, level, ways) => {
  const range = /** @type {const} */ ([-SIDE, SIDE]);
  return { definition: { kind: 'implicit', f, bounds: [range, range, range] }, level, ways };
};

/** @type {Record<string, () => Creased>} */
export const SURFACES = {
  'max(0, x)'() {
    const height = (/** @type {number} */ x) => Math.max(0, x);
    return graph('max(0, x)', height, facesOver(height, OVER_HALVES, HALVES));
  },
  '|x|/2 + y'() {
    const height = (/** @type {number} */ x, /** @type {number} */ y) => Math.abs(x) / 2 + y;
    return graph('abs(x)/2 + y', height, facesOver(height, OVER_HALVES, HALVES));
  },
  '2 - max(|x|, |y|)'() {
    const height = (/** @type {number} */ x, /** @type {number} */ y) => 2 - Math.max(Math.abs(x), Math.abs(y));
    return graph('2 - max(abs(x), abs(y))', height, facesOver(height, OVER_QUARTERS, WEDGES));
  },
  'cone on a plane'() {
    const height = (/** @type {number} */ x, /** @type {number} */ y) => Math.max(0, 1 - Math.sqrt(x * x + y * y));
    const partOf = (/** @type {number[]} */ [x, y]) => (Math.hypot(x, y) > 1 ? 'plane' : 'cone');
    const ways = joined(partOf, { plane: aroundDisc, cone: onCone }, [rimAt(1, 0, ['plane', 'cone'])], 2);
    return graph('max(0, 1 - sqrt(x^2 + y^2))', height, ways);
  },
  'min(x², y²)': () => graph('min(x^2, y^2)', (x, y) => Math.min(x * x, y * y), null),
  '|x| + |y|'() {
    const height = (/** @type {number} */ x, /** @type {number} */ y) => Math.abs(x) + Math.abs(y);
    return graph('abs(x) + abs(y)', height, facesOver(height, OVER_QUARTERS, QUADRANTS));
  },
  cube: () => body('max(abs(x), abs(y), abs(z)) - 1', (x, y, z) => Math.max(Math.abs(x), Math.abs(y), Math.abs(z)) - 1, cubeFaces()),
  'capped cylinder'() {
    const partOf = (/** @type {number[]} */ [, , z]) => (z > 1 - ON ? 'top' : z < ON - 1 ? 'bottom' : 'side');
    const rims = [rimAt(1, 1, ['top', 'side']), rimAt(1, -1, ['bottom', 'side'])];
    const ways = joined(partOf, { top: straight, bottom: straight, side: onCylinder }, rims, 3);
    return body('max(x^2 + y^2 - 1, abs(z) - 1)', (x, y, z) => Math.max(x * x + y * y - 1, Math.abs(z) - 1), ways);
  },
  'ball cut by a plane'() {
    const partOf = (/** @type {number[]} */ [, , z]) => (z > 0.4 - ON ? 'cut' : 'ball');
    const ways = joined(partOf, { cut: straight, ball: onSphere }, [rimAt(Math.sqrt(1 - 0.4 ** 2), 0.4, ['cut', 'ball'])], 2);
    return body('max(x^2 + y^2 + z^2 - 1, z - 0.4)', (x, y, z) => Math.max(x * x + y * y + z * z - 1, z - 0.4), ways);
  },
  'two balls joined'() {
    const partOf = (/** @type {number[]} */ [x]) => (x < 0 ? 'left' : 'right');
    /** @type {Rim} */
    const rim = { at: (angle) => [0, 0.8 * Math.cos(angle), 0.8 * Math.sin(angle)], joins: ['left', 'right'] };
    const ways = joined(partOf, { left: aroundCap(-0.6), right: aroundCap(0.6) }, [rim], 1);
    const level = (/** @type {number} */ x, /** @type {number} */ y, /** @type {number} */ z) =>
      (Math.abs(x) - 0.6) ** 2 + y * y + z * z - 1;
    return body('min((x + 0.6)^2 + y^2 + z^2, (x - 0.6)^2 + y^2 + z^2) - 1', level, ways);
  },
  octahedron: () => body('abs(x) + abs(y) + abs(z) - 1', (x, y, z) => Math.abs(x) + Math.abs(y) + Math.abs(z) - 1, octahedronFaces()),
};

/** Two creases across the square, and a wave. @param {Random} random @returns {Creased} */
export function randomCreases(random) {
  const line = () => [random.between(0, Math.PI), random.between(-1, 1), random.between(0.2, 0.8)];
  const [[turnA, farA, steepA], [turnB, farB, steepB]] = [line(), line()];
  const [high, over, up] = [random.between(0.05, 0.2), random.between(1, 3), random.between(-3, 3)];
  const text = (/** @type {number} */ turn, /** @type {number} */ far) => `x*cos(${turn}) + y*sin(${turn}) - (${far})`;
  const value = (/** @type {number} */ turn, /** @type {number} */ far, /** @type {number} */ x, /** @type {number} */ y) =>
    x * Math.cos(turn) + y * Math.sin(turn) - far;
  return graph(
    `${steepA}*abs(${text(turnA, farA)}) + ${steepB}*max(0, ${text(turnB, farB)}) + ${high}*sin(${over}*x + (${up})*y)`,
    (x, y) =>
      steepA * Math.abs(value(turnA, farA, x, y)) + steepB * Math.max(0, value(turnB, farB, x, y)) + high * Math.sin(over * x + up * y),
    null,
  );
}

// Pairs

/** A place on a surface, as it is asked for and in space. @param {Creased} creased @param {Random} random */
function drawPlace({ height, level }, random) {
  if (height) {
    const [x, y] = [random.between(-SIDE, SIDE), random.between(-SIDE, SIDE)];
    return { asked: [x, y], place: [x, y, height(x, y)] };
  }
  const direction = unit([random.normal(), random.normal(), random.normal()]);
  let [low, high] = [0, 2 * SIDE];
  for (let halving = 0; halving < 60; halving++) {
    const middle = (low + high) / 2;
    const [x, y, z] = scale(direction, middle);
    if ((level?.(x, y, z) ?? 0) > 0) high = middle;
    else low = middle;
  }
  const place = scale(direction, low);
  return { asked: place, place };
}

/** Whether a path lies on the surface and is as long as its points say. @param {Creased} creased @param {Path} path */
function isMeasured({ height, level }, { points, length }) {
  let chords = 0;
  for (let i = 0; i < points.length; i += 3) {
    const [x, y, z] = points.subarray(i, i + 3);
    if (!(Math.abs(height ? z - height(x, y) : (level?.(x, y, z) ?? 0)) <= ON)) return false;
    if (i > 0) chords += Math.hypot(x - points[i - 3], y - points[i - 2], z - points[i - 1]);
  }
  return chords <= length * (1 + 1e-12) && chords >= length * (1 - CHORDS);
}

/** The shortest path that starts bent sideways lead to; those that are not solved count less their error. @param {Surface} surface @param {number[]} from @param {number[]} to */
function shortestBent(surface, from, to) {
  let best = Infinity;
  for (const bend of BENDS) {
    const start = Array.from({ length: BEND_POINTS }, (_, i) => {
      const part = i / (BEND_POINTS - 1);
      const aside = bend * Math.sin(Math.PI * part);
      const away = [aside * (from[1] - to[1]), aside * (to[0] - from[0])];
      return add(add(scale(from, 1 - part), scale(to, part)), away).map((x) => Math.max(-SIDE, Math.min(SIDE, x)));
    });
    const path = surface.shortestPath(from, to, { start: start.flat() });
    if (path.points.length > 0) best = Math.min(best, path.length + (path.converged ? 0 : path.lengthError));
  }
  return best;
}

/** Asks for random pairs, and judges the answers. @param {Creased} creased @param {Surface} surface of its definition @param {Random} random @param {number} pairs @returns {Answer[]} */
export function askAcross(creased, surface, random, pairs) {
  return Array.from({ length: pairs }, () => {
    const [a, b] = [drawPlace(creased, random), drawPlace(creased, random)];
    const [from, to] = [a.asked, b.asked];
    const begin = performance.now();
    const path = surface.shortestPath(from, to);
    const milliseconds = performance.now() - begin;
    const { status, length, converged } = path;
    const ways = creased.ways?.(a.place, b.place) ?? [length, shortestBent(surface, from, to)];
    const expected = Math.min(...ways);
    const error = Math.abs(length / expected - 1);
    const judge = () => {
      if (!converged) return 'refused';
      if (!isMeasured(creased, surface.shortestPath(from, to, { points: SEEN }))) return 'wrong';
      if (error <= RIGHT) return 'right';
      return creased.ways && ways.some((way) => Math.abs(length / way - 1) <= RIGHT) ? 'longer' : 'wrong';
    };
    return { from, to, status, length, expected, error, verdict: judge(), milliseconds };
  });
}
