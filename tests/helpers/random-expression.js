/* Random formulas in all the notation that mathjs reads too, so that it can be asked what they mean. */

/** @typedef {import('./random.js').Random} Random */

const TOTAL = ['sin', 'cos', 'tan', 'atan', 'sinh', 'cosh', 'tanh', 'asinh', 'exp', 'cbrt', 'abs', 'sign', 'floor'];
/** Not defined everywhere, so drawn less often. */
const PARTIAL = ['asin', 'acos', 'acosh', 'atanh', 'log', 'log2', 'log10', 'sqrt'];
const BINARY = ['atan2', 'pow', 'min', 'max', 'hypot'];
const NUMBERS = ['2', '3', '0.5', '.25', '1.5e1', '7', '1e-1'];

/**
 * A formula: sums of products of powers, with implicit products, signs and brackets here and there.
 * @param {Random} random
 * @param {number} depth how deep brackets nest at most
 * @param {readonly string[]} names of variables and constants
 * @returns {string}
 */
export function randomExpression(random, depth, names) {
  const terms = Array.from({ length: 1 + random.integer(3) }, () => randomTerm(random, depth, names));
  return terms.reduce((sum, term) => `${sum}${random.pick([' + ', '-', ' - ', '+'])}${term}`);
}

/** @param {Random} random @param {number} depth @param {readonly string[]} names */
function randomTerm(random, depth, names) {
  let term = randomFactor(random, depth, names, random.next() < 0.5);
  while (random.next() < 0.5) {
    const divides = random.next() < 0.3;
    term += random.pick(divides ? ['/', ' / '] : ['*', ' * ']) + randomFactor(random, depth, names, !divides);
  }
  return term;
}

/** @param {Random} random @param {number} depth @param {readonly string[]} names @param {boolean} mayJoin whether it may be an implicit product */
function randomFactor(random, depth, names, mayJoin) {
  const sign = random.next() < 0.15 ? '-' : '';
  if (!mayJoin || random.next() < 0.5) return sign + randomPower(random, depth, names);
  const first = random.pick([random.pick(NUMBERS), randomCall(random, depth, names)]);
  const second = random.pick([random.pick(names), randomCall(random, depth, names), `(${inner(random, depth, names)})`]);
  return `${sign}${first} ${second}${random.next() < 0.3 ? '^2' : ''}`;
}

/** @param {Random} random @param {number} depth @param {readonly string[]} names */
function randomPower(random, depth, names) {
  const base = randomAtom(random, depth, names);
  if (random.next() < 0.7) return base;
  const exponent = random.pick(['2', '3', '-1', '-2', '0.5', '2^2', '-u', '2^-1']);
  return `${base}${random.pick(['^', ' ^ '])}${exponent}`;
}

/** @param {Random} random @param {number} depth @param {readonly string[]} names */
function randomAtom(random, depth, names) {
  const choice = random.next();
  if (choice < 0.35) return random.pick(names);
  if (choice < 0.55) return random.pick(NUMBERS);
  return choice < 0.8 ? randomCall(random, depth, names) : `(${inner(random, depth, names)})`;
}

/** @param {Random} random @param {number} depth @param {readonly string[]} names */
function randomCall(random, depth, names) {
  if (random.next() < 0.75) return `${random.pick(random.next() < 0.25 ? PARTIAL : TOTAL)}(${inner(random, depth, names)})`;
  return `${random.pick(BINARY)}(${inner(random, depth, names)}, ${inner(random, depth, names)})`;
}

/** @param {Random} random @param {number} depth @param {readonly string[]} names */
function inner(random, depth, names) {
  return depth > 0 ? randomExpression(random, depth - 1, names) : random.pick(names);
}
