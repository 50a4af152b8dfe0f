// Texts made to overflow, to hang or to reach what they must not: refused at once, in time that does not grow with them.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { compile } from '../../../web/expression/compile.js';
import { ExpressionError } from '../../../web/expression/error.js';
import { allowance } from '../../helpers/allowance.js';

const MEGABYTE = 2 ** 20;
const apply = () => Number.NaN;
/** @param {string} source @param {Record<string, number>} [parameters] */
const build = (source, parameters) => compile({ outputs: [source], names: ['f'], variables: ['u', 'v'], parameters, apply });

/** Milliseconds that a call takes: the least of many, if it must be. @param {() => void} call @param {number} times @param {number} enough no call is needed after one that took no more */
function leastTime(call, times, enough) {
  let least = Infinity;
  for (let i = 0; i < times && !(least <= enough); i++) {
    const start = performance.now();
    call();
    least = Math.min(least, performance.now() - start);
  }
  return least;
}

/** Milliseconds of the processor that a call takes, whatever else the machine does. @param {() => void} call */
function processorTime(call) {
  const start = process.cpuUsage();
  call();
  const { user, system } = process.cpuUsage(start);
  return (user + system) / 1000;
}

/** @type {Record<string, [string, Record<string, number>?]>} */
const HOSTILE = {
  '5,000 nested brackets': [`${'('.repeat(5000)}u${')'.repeat(5000)}`],
  '5,000 open brackets': ['('.repeat(5000)],
  '5,000 signs': [`${'-'.repeat(4000)}(`],
  '2,000 nested calls': ['sin('.repeat(1000)],
  'a tower of powers': [`u${'^2'.repeat(2000)}`],
  'a megabyte of sum': [`u${'+u'.repeat(MEGABYTE / 2)}`],
  'a megabyte of digits': ['9'.repeat(MEGABYTE)],
  'a megabyte of space': [' '.repeat(MEGABYTE)],
  'a megabyte of a name': ['x'.repeat(MEGABYTE)],
  '65 parameters': ['u', Object.fromEntries(Array.from({ length: 65 }, (_, k) => [`p${k}`, k]))],
  __proto__: ['__proto__'],
  'constructor.constructor': ['constructor.constructor("return 1")()'],
  'a call of toString': ['toString(u)'],
  'full-width letters': ['ｓｉｎ(u)'],
  'a Cyrillic letter': ['ѕin(u)'],
  'a Greek letter': ['υ+1'],
  'an invisible letter': ['u\u200b+v'],
  'text from right to left': ['\u202eu+v'],
  'half a character': ['u+\ud800'],
  'a null character': ['u\u0000'],
  '1e400': ['1e400'],
  'an exponent of many digits': [`1e${'9'.repeat(4000)}`],
};

describe('hostile texts are refused in a millisecond', () => {
  for (const [name, [source, parameters]] of Object.entries(HOSTILE))
    test(name, () => {
      const refuse = () =>
        assert.throws(
          () => build(source, parameters),
          (/** @type {any} */ error) => error instanceof ExpressionError && error.message.length < 500,
        );
      // The least of many, so that the machine's other work does not count.
      const most = allowance(1);
      const milliseconds = leastTime(refuse, 400, most);
      assert.ok(milliseconds <= most, `${milliseconds} ms`);
    });
});

test('the time grows with the text, not faster', () => {
  const text = (/** @type {number} */ terms) => Array.from({ length: terms }, (_, i) => `sin(${i}u)`).join('+');
  const texts = [40, 320].map(text);
  const least = [Infinity, Infinity];
  // Eight times the text: twice that for caches and tables that grow. Each in the other's company, and as long as the machine's other work makes them differ.
  for (let i = 0; i < 400 && !(i >= 40 && least[1] <= 16 * least[0]); i++)
    for (const [k, source] of texts.entries())
      least[k] = Math.min(
        least[k],
        processorTime(() => build(source)),
      );
  assert.ok(least[1] <= 16 * least[0], `${least.join(' and ')} ms`);
});

/** Texts of so many like parts, which derivatives could multiply. @type {Record<string, (count: number) => string>} */
const REPEATED = {
  sums: (count) => parts(count, (i) => `sin(${i}u)`).join('+'),
  products: (count) => parts(count, (i) => `(u+${i}v)`).join('*'),
  quotients: (count) => parts(count, (i) => `(u+${i}v)`).join('/'),
  powers: (count) => parts(count, (i) => `u^${i + 1}`).join('+'),
  'products without a sign': (count) => 'u v '.repeat(count),
  maxima: (count) => parts(count, (i) => `max(u,${i}v)`).join('+'),
};
/** The same, one inside the other. @type {Record<string, (count: number) => string>} */
const NESTED = {
  functions: (count) => `${'sin('.repeat(count)}u*v${')'.repeat(count)}`,
  'functions of sums': (count) => `${'exp(v+'.repeat(count)}u*v${')'.repeat(count)}`,
  squares: (count) => `${'('.repeat(count)}u${'+v)^2'.repeat(count)}`,
  'polynomials of Horner': (count) => `${'(1+u*'.repeat(count)}v${')'.repeat(count)}`,
};

/** @param {number} count @param {(i: number) => string} write */
const parts = (count, write) => Array.from({ length: count }, (_, i) => write(i + 1));

describe('what is compiled grows with the text, not faster', () => {
  for (const [shapes, few] of /** @type {const} */ ([
    [REPEATED, 20],
    [NESTED, 7],
  ]))
    for (const [name, write] of Object.entries(shapes))
      test(name, () => {
        const [short, long] = [few, 8 * few].map((count) => build(write(count)).module.length);
        // Eight times the text, with numbers of locals that take a byte more.
        assert.ok(long <= 10 * short, `${short} and ${long} bytes`);
      });
});
