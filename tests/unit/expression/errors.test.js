/* Every way of writing a formula wrong: where the error points, and that it says what to write instead. */

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { compile, evaluateConstant } from '../../../web/expression/compile.js';
import { ExpressionError } from '../../../web/expression/error.js';
import { createRandom } from '../../helpers/random.js';

const apply = () => Number.NaN;

/** @param {any} source @param {Record<string, any>} [parameters] */
const build = (source, parameters) => compile({ outputs: [source], names: ['f'], variables: ['u', 'v'], parameters, apply });

/** Source, index of the offending character, what the message says. @type {[string, number, RegExp][]} */
const MISTAKES = [
  ['', 0, /empty; write/],
  ['   ', 0, /empty; write/],
  ['1/2u', 3, /a\/\(b\*c\)/],
  ['u/2 v', 4, /a\/\(b\*c\)/],
  ['1/2(u+1)', 3, /a\/\(b\*c\)/],
  ['2u/3v', 4, /a\/\(b\*c\)/],
  ['u/v^2 u', 6, /a\/\(b\*c\)/],
  ['1/2√u', 3, /a\/\(b\*c\)/],
  ['sin u', 0, /write sin\(…\) with brackets/],
  ['2+sin', 2, /write sin\(…\) with brackets/],
  ['sin*u', 0, /write sin\(…\) with brackets/],
  ['|u|v|2|', 4, /write abs\(…\)/],
  ['|u||v|', 3, /write abs\(…\)/],
  ['2|u|', 1, /write abs\(…\)/],
  ['(|u)', 1, /write abs\(…\)/],
  ['sin^2(u)', 0, /sin\(…\)\^2/],
  ['sin²(u)', 0, /sin\(…\)\^2/],
  ['sin⁻¹(u)', 0, /write asin\(…\)/],
  ['1+tanh^-1(u)', 2, /write atanh\(…\)/],
  ['cos^(-1)(u)', 0, /write acos\(…\)/],
  ['exp⁻¹(u)', 0, /exp\(…\)\^2/],
  ['1+cos**2(u)', 2, /cos\(…\)\^2/],
  ['u(v+1)', 0, /write u\*\(…\)/],
  ['2+v (u)', 2, /write v\*\(…\)/],
  ['pi(u)', 0, /write pi\*\(…\)/],
  ['2 3', 2, /two numbers stand side by side/],
  ['u^2 3', 4, /two numbers stand side by side/],
  ['u = 1', 2, /a - \(b\)/],
  ['u == 1', 2, /a - \(b\)/],
  ['u > 1', 2, /min, max/],
  ['u <= 1', 2, /min, max/],
  ['1.2.3', 3, /only one decimal point/],
  ['1..2', 2, /only one decimal point/],
  ['.', 0, /digit beside its decimal point/],
  ['u+.', 2, /digit beside its decimal point/],
  ['1e400', 0, /too large/],
  ['u+9e999', 2, /too large/],
  ['1,5', 1, /decimals with a point/],
  ['(1,5)', 2, /decimals with a point/],
  ['(u', 0, /not closed; write a \)/],
  ['1+sin(u', 5, /not closed; write a \)/],
  ['((u)', 0, /not closed/],
  ['|u', 0, /not closed; write the second \|/],
  ['u)', 1, /no opening bracket/],
  ['sin(u))', 6, /no opening bracket/],
  ['()', 1, /missing before \)/],
  ['u+', 2, /ends too early/],
  ['u + ', 4, /ends too early/],
  ['-', 1, /ends too early/],
  ['sin(', 4, /ends too early/],
  ['*u', 0, /missing before \*/],
  ['u+*v', 2, /missing before \*/],
  ['u***v', 3, /missing before \*/],
  ['(u+)', 3, /missing before \)/],
  ['^2', 0, /missing before \^/],
  ['²', 0, /missing before ²/],
  ['max(,u)', 4, /missing before ,/],
  ['max(u,)', 6, /missing before \)/],
  ['w+1', 0, /unknown name w; the names here are u, v/],
  ['1+U', 2, /unknown name U; did you mean u\?/],
  ['uv', 0, /unknown name uv; did you mean u\*v\?/],
  ['2pie', 1, /unknown name pie; did you mean pi\*e\?/],
  ['2pii', 1, /unknown name pii; did you mean pi\?/],
  ['1+sinu', 2, /unknown name sinu; did you mean sin\(u\)\?/],
  ['2piu', 1, /unknown name piu; did you mean pi\*u\?/],
  ['u2+v', 0, /unknown name u2; did you mean u\^2 or 2\*u\?/],
  ['usin(v)', 0, /unknown function usin; did you mean u\*sin\(…\)\?/],
  ['z = u*v', 0, /write only what stands behind "="/],
  ['f(u, v) = u*v', 0, /write only what stands behind "="/],
  ['u = v', 2, /for an equation a = b write a - \(b\)/],
  ['u\u200b+v', 1, /invisible character, U\+200B; remove it/],
  ['sine(u)', 0, /unknown function sine; did you mean sin\?/],
  ['sinn(u)', 0, /unknown function sinn; did you mean sin\?/],
  ['2radius', 1, /unknown name radius; the names here are u, v, pi, e, tau; or give it a value in parameters/],
  ['u – v', 2, /a dash is no minus sign; write -$/],
  ['1+sec(u)', 2, /unknown function sec; write 1\/cos\(…\)$/],
  ['cosec(u)', 0, /unknown function cosec; write 1\/sin\(…\)$/],
  ['csch(u)', 0, /unknown function csch; write 1\/sinh\(…\)$/],
  ['coth(u)', 0, /unknown function coth; write 1\/tanh\(…\)$/],
  ['и+v', 0, /unknown name и in Cyrillic; the names here are u, v, /],
  ['sin(х)', 4, /unknown name х in Cyrillic; /],
  ['u≤v', 1, /comparisons are not available/],
  ['u‑v', 1, /a dash is no minus sign; write -$/],
  ['Math.sin(u)', 0, /unknown name Math; write the name alone, as in sin\(…\)$/],
  ['arctan(u)', 0, /unknown function arctan; did you mean atan\?/],
  ['clamp(u,0,1)', 0, /unknown function clamp; write min\(max\(…, low\), high\)/],
  ['u+length(u,v)', 2, /unknown function length; write hypot\(…\)/],
  ['Sin(u)', 0, /unknown function Sin; did you mean sin\?/],
  ['foo(u)', 0, /unknown function foo/],
  ['constructor', 0, /unknown name constructor/],
  ['__proto__', 0, /unknown name __proto__/],
  ['toString', 0, /unknown name toString/],
  ['u+hasOwnProperty(v)', 2, /unknown function hasOwnProperty/],
  ['valueOf(u)', 0, /unknown function valueOf/],
  ['sin()', 0, /takes one argument, not none/],
  ['2*sin(u, v)', 2, /takes one argument, not 2/],
  ['atan2(u)', 0, /takes two arguments, not 1; write atan2\(…, …\)/],
  ['pow(u, v, 2)', 0, /takes two arguments, not 3/],
  ['min()', 0, /at least one argument/],
  ['√u^2', 2, /root of a power or the power of a root/],
  ['√(u)²', 4, /root of a power/],
  ['√2u', 2, /under the root or not/],
  ['√-u', 1, /√\(…\)/],
  ['u²^3', 2, /two powers/],
  ['u² ²', 3, /two powers/],
  ['u[0]', 1, /round brackets/],
  ['{u}', 0, /round brackets/],
  ['u%2', 1, /floor/],
  ['1.5sin(v) // height', 10, /comment/],
  ['u /* wide */ + 1', 2, /comment/],
  ['u//2', 1, /floor\(a\/b\)/],
  ['30°', 2, /pi\/180/],
  ['u;v', 1, /without ";"/],
  ['u # v', 2, /"#" is no part/],
  ['u+😀', 2, /"😀" is no part/],
  ['"u"', 0, /is no part/],
  ['u!', 1, /is no part/],
  ['\\sin(u)', 0, /"\\" is no part/],
  ['u.v', 1, /digit beside|side by side/],
];

test('every mistake is pointed at and answered', () => {
  for (const [source, index, message] of MISTAKES) {
    assert.throws(
      () => build(source),
      (error) => {
        assert.ok(error instanceof ExpressionError, `${source}: ${error}`);
        assert.deepEqual({ source: error.source, index: error.index }, { source, index }, `${source}: ${error.message}`);
        assert.equal(error.argument, 'f');
        assert.match(error.message, message);
        assert.match(error.message, /^f: .+/);
        return true;
      },
      source,
    );
  }
});

test('what is no text or finite number is a TypeError', () => {
  for (const source of [undefined, null, {}, [], () => 1, true, 1n, Number.NaN, Number.POSITIVE_INFINITY, Symbol('u'), new String('u')]) {
    assert.throws(() => build(source), { name: 'TypeError', message: /^f must be a string or a finite number, not/ });
  }
});

test('parameters', () => {
  const refused = /** @type {[Record<string, any>, string, RegExp][]} */ ([
    [{ sin: 1 }, 'sin', /sin is a function/],
    [{ R: 1, v: 2 }, 'v', /v is a variable/],
    [{ '2R': 1 }, '2R', /cannot name a parameter/],
    [{ 'a b': 1 }, 'a b', /cannot name a parameter/],
    [{ '': 1 }, '', /cannot name a parameter/],
    [Object.fromEntries(Array.from({ length: 65 }, (_, k) => [`p${k}`, k])), 'p64', /more than 64 parameters/],
  ]);
  for (const [parameters, source, message] of refused)
    assert.throws(() => build('u', parameters), { name: 'ExpressionError', source, index: 0, message });
  for (const value of [Number.NaN, Number.POSITIVE_INFINITY, '1', undefined, null]) {
    assert.throws(() => build('u', { R: value }), { name: 'TypeError', message: /^the parameter R must be a finite number/ });
  }
  assert.deepEqual(build('u', Object.fromEntries(Array.from({ length: 64 }, (_, k) => [`p${k}`, k]))).data.length, 64 + 2);
  assert.deepEqual(build('__proto__ u', JSON.parse('{"__proto__": 3}')).parameterNames, ['__proto__']);
});

test('names are variables before parameters before constants', () => {
  const value = (/** @type {string} */ source, /** @type {Record<string, number>} */ parameters) =>
    evaluateConstant(source, parameters, apply);
  assert.equal(value('2e', {}), 2 * Math.E);
  assert.equal(value('2e', { e: 0.5 }), 1);
  assert.equal(value('2π', { pi: 3 }), 6);
  assert.throws(() => value('2u', {}), { name: 'ExpressionError', source: '2u', index: 1 });
  const shadowing = compile({ outputs: ['e'], names: ['f'], variables: ['e'], apply });
  assert.equal(shadowing.data.length, 2);
});

test('random garbage is read or refused, never anything else', () => {
  const random = createRandom(7);
  const pieces = [
    'u',
    'v',
    'sin',
    'max',
    '(',
    ')',
    '|',
    ',',
    '+',
    '-',
    '*',
    '/',
    '^',
    '**',
    '²',
    '√',
    '2',
    '.5',
    'e',
    ' ',
    'π',
    '=',
    'x',
    '\u0000',
    '😀',
  ];
  for (let k = 0; k < 20_000; k++) {
    const source = Array.from({ length: 1 + random.integer(12) }, () => random.pick(pieces)).join('');
    try {
      build(source);
    } catch (error) {
      assert.ok(error instanceof ExpressionError, `seed 7: ${source}: ${error}`);
      assert.ok(error.index >= 0 && error.index <= source.length && Number.isInteger(error.index), source);
    }
  }
});
