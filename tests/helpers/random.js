/**
 * Seeded random numbers for tests: the same sequence on every machine, so that a printed seed reproduces a failure.
 *
 * sfc32 (Chris Doty-Humphrey's small fast counter, 128 bits of state, period at least 2^32), warmed up so that neighbouring seeds give
 * unrelated sequences.
 */

/**
 * A generator of random numbers.
 *
 * @typedef {object} Random
 * @property {number} seed what it was made from; print it when a test fails
 * @property {() => number} next uniform in [0, 1), a multiple of 2^-32
 * @property {(low: number, high: number) => number} between uniform in [low, high)
 * @property {(count: number) => number} integer uniform in 0 … count - 1
 * @property {<T>(items: readonly T[]) => T} pick one of the items
 * @property {() => number} normal mean 0, variance 1
 */

/**
 * Makes a generator.
 *
 * @param {number} seed any integer; its lowest 32 bits count
 * @returns {Random}
 */
export function createRandom(seed) {
  const word = sfc32(seed);
  for (let i = 0; i < 16; i++) word();
  const next = () => word() / 2 ** 32;
  const between = (/** @type {number} */ low, /** @type {number} */ high) => low + (high - low) * next();
  const integer = (/** @type {number} */ count) => Math.floor(count * next());
  return {
    seed,
    next,
    between,
    integer,
    pick: (items) => items[integer(items.length)],
    normal: () => Math.sqrt(-2 * Math.log(1 - next())) * Math.cos(2 * Math.PI * next()),
  };
}

/**
 * @param {number} seed
 * @returns {() => number} uniform in 0 … 2^32 - 1
 */
function sfc32(seed) {
  let a = seed | 0;
  let b = 0x9e3779b9 | 0;
  let c = 0x243f6a88 | 0;
  let counter = 1;
  return () => {
    const sum = (a + b + counter++) | 0;
    a = b ^ (b >>> 9);
    b = (c + (c << 3)) | 0;
    c = (((c << 21) | (c >>> 11)) + sum) | 0;
    return sum >>> 0;
  };
}
