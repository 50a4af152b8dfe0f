/**
 * Simpson's rule.
 * @param {(x: number) => number} f smooth @param {number} from @param {number} to less than `from`: the integral's sign changes @param {number} [parts] even
 */
export function simpson(f, from, to, parts = 2000) {
  const at = (/** @type {number} */ i) => f(from + ((to - from) * i) / parts);
  let sum = at(0) + at(parts);
  for (let i = 1; i < parts; i++) sum += (i % 2 ? 4 : 2) * at(i);
  return (sum * (to - from)) / (3 * parts);
}
