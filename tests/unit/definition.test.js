// Definitions of surfaces: what is refused, and how.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { gallery } from '../../web/gallery.js';
import { ExpressionError, load } from '../../web/index.js';
import { anything, refuses } from '../helpers/refuses.js';

const surfpath = await load();

describe('definitions', () => {
  /** @type {[string, unknown, Function, RegExp][]} */
  const bad = [
    ['nothing', undefined, TypeError, /parametric: the definition must be an object, not undefined/],
    [
      'E, F and G alone',
      { metric: { E: 1, F: 0, G: 1 }, u: [0, 1], v: [0, 1] },
      TypeError,
      /x is missing; surfpath\.metric takes E, F and G alone/,
    ],
    ['a missing range', { x: 'u', y: 'v', z: 0, u: [0, 1] }, TypeError, /v is missing/],
    ['a range that is no range', { ...gallery.saddle, u: 3 }, TypeError, /u must be a range \[from, to\], not 3/],
    ['a range of three', { ...gallery.saddle, u: [0, 1, 2] }, TypeError, /u must be a range/],
    ['a reversed range', { ...gallery.saddle, u: [1, 0] }, RangeError, /u must be a range of two numbers, the smaller first/],
    ['an end of a range that is missing', { ...gallery.saddle, u: [0, undefined] }, TypeError, /parametric: u\[1\] must be a formula/],
    ['an empty range', { ...gallery.saddle, v: [1, 1] }, RangeError, /v must be a range/],
    [
      'an infinite range',
      { ...gallery.saddle, v: [0, Infinity] },
      RangeError,
      /parametric: v\[1\] must be a formula in a string, or a finite number, not Infinity/,
    ],
    ['a range that is NaN', { ...gallery.saddle, v: ['sqrt(-1)', 1] }, RangeError, /v must be a range/],
    ['an unknown name in a range', { ...gallery.saddle, u: [0, '2*q'] }, ExpressionError, /u: unknown name q/],
    ['an unknown name', { ...gallery.saddle, z: 'w' }, ExpressionError, /z: unknown name w/],
    ['an empty formula', { ...gallery.saddle, z: '' }, ExpressionError, /z: the expression is empty/],
    [
      'null for a formula',
      { ...gallery.saddle, x: null },
      TypeError,
      /parametric: x must be a formula in a string, or a finite number, not null/,
    ],
    ['NaN for a formula', { ...gallery.saddle, x: NaN }, RangeError, /parametric: x must be .* not NaN/],
    ['a function for a formula', { ...gallery.saddle, x: Math.sin }, TypeError, /parametric: x must be/],
    ['a periodic that is a word', { ...gallery.saddle, periodic: 'yes' }, TypeError, /periodic must be 'auto' or .* not 'yes'/],
    ['a periodic that is a list', { ...gallery.saddle, periodic: ['u'] }, TypeError, /periodic must be 'auto' or .* not an array of 1/],
    ['a periodic that is a number', { ...gallery.saddle, periodic: { u: 1 } }, TypeError, /periodic must be .* not u: 1/],
    [
      'a parameter that is a BigInt',
      { ...gallery.saddle, parameters: { a: 1n } },
      TypeError,
      /parameter a must be a finite number, not 1n$/,
    ],
    ['a parameter that is NaN', { ...gallery.saddle, parameters: { a: NaN } }, RangeError, /parameter a must be a finite number/],
    ['a parameter that is text', { ...gallery.saddle, parameters: { a: '1' } }, TypeError, /parameter a must be a finite number, not '1'/],
    ['parameters that are no object', { ...gallery.saddle, parameters: 3 }, TypeError, /parameters must be an object of numbers/],
    ['a Map of parameters', { ...gallery.saddle, parameters: new Map([['a', 1]]) }, TypeError, /not an object of type Map$/],
    [
      'parameters in a list',
      { ...gallery.saddle, parameters: [1] },
      TypeError,
      /parameters must be an object of numbers, not an array of 1/,
    ],
    ['a parameter called like a function', { ...gallery.saddle, parameters: { sin: 1 } }, ExpressionError, /sin is a function/],
    ['a field misspelt', { ...gallery.saddle, densty: '1 + u' }, TypeError, /has no field 'densty'; did you mean density\?/],
    ['a field in capitals', { ...gallery.saddle, Parameters: { a: 1 } }, TypeError, /did you mean parameters\?/],
    ['a density by another name', { ...gallery.saddle, weight: '1 + u' }, TypeError, /has no field 'weight'; did you mean density\?/],
    ['parameters cut short', { ...gallery.saddle, params: { a: 1 } }, TypeError, /has no field 'params'; did you mean parameters\?/],
    ['bounds', { ...gallery.saddle, bounds: [] }, TypeError, /takes no bounds; the ranges of its parameters bound it/],
    ['a reference', { ...gallery.saddle, reference: [0, 0, 1] }, TypeError, /takes no reference; tube and sweep do/],
    ['a density that is no formula', { ...gallery.saddle, density: null }, TypeError, /parametric: density must be/],
    ['a metric without G', { ...gallery.saddle, metric: { E: 1, F: 0 } }, TypeError, /metric must be \{ E, F, G \}; G is missing/],
  ];
  for (const [what, definition, kind, message] of bad)
    test(`parametric refuses ${what}`, () => refuses(() => surfpath.parametric(anything(definition)), kind, message));

  test('ranges may be arrays of any type, and are copied', () => {
    const range = new Float64Array([-1, 1]);
    const plane = surfpath.graph(anything({ z: 0, x: range, y: range }));
    assert.deepEqual(plane.domain?.u, [-1, 1]);
    const ball = surfpath.implicit(anything({ f: 'x^2+y^2+z^2-1', bounds: [range, [-1, 1], range] }));
    range.fill(0);
    assert.equal(ball.shortestPath([1, 0, 0], [0, 1, 0]).status, 'converged');
    plane.set({});
    assert.deepEqual(plane.domain?.v, [-1, 1]);
  });

  test('implicit refuses bounds that are no box', () => {
    const f = 'x^2+y^2+z^2-1';
    refuses(() => surfpath.implicit(anything({ f, bounds: [[0, 1]] })), TypeError, /bounds must be three ranges, \[\[xmin, xmax\], \[ymin/);
    refuses(() => surfpath.implicit(anything({ f, bounds: [[0, 1], [0, 1], 2] })), TypeError, /bounds\[2\] must be \[min, max\]/);
    refuses(
      () =>
        surfpath.implicit({
          f,
          bounds: [
            [0, 1],
            [0, 1],
            [Number.NaN, 1],
          ],
        }),
      RangeError,
      /bounds\[2\]\[0\] must be a finite number, not NaN/,
    );
    const reversed = anything([
      [0, 1],
      [1, 0],
      [0, 1],
    ]);
    refuses(() => surfpath.implicit({ f, bounds: reversed }), RangeError, /bounds\[1\] must be two numbers, the smaller first/);
    refuses(() => surfpath.implicit(anything({})), TypeError, /f is missing/);
  });

  test('implicit refuses bounds by another name, and what closes parametric surfaces', () => {
    const f = 'x^2+y^2+z^2-1';
    for (const name of ['bbox', 'box', 'box3', 'boundingBox', 'bounding_box', 'Limits', 'bound'])
      refuses(
        () => surfpath.implicit(anything({ f, [name]: 1 })),
        TypeError,
        /implicit: the definition has no field '.*'; did you mean bounds\?/,
      );
    refuses(() => surfpath.implicit(anything({ f, periodic: 'auto' })), TypeError, /takes no periodic; an implicit surface closes where/);
  });

  test('what people keep with a definition is no mistake', () => {
    const notes = {
      title: 'A ball',
      name: 'ball',
      id: 7,
      formula: 'x² + y² + z² = 1',
      source: 'me',
      camera: [1, 0, 0],
      from: [],
      to: [],
      points: [],
      colour: 'red',
    };
    const bounds = gallery.torus.bounds;
    surfpath.implicit(anything({ f: 'x^2+y^2+z^2-1', bounds, box: 'what is drawn', ...notes })).dispose();
    surfpath.parametric(anything({ ...gallery.saddle, ...notes, weight: undefined })).dispose();
  });

  test('surface refuses kinds that do not exist', () => {
    refuses(() => surfpath.surface(anything(null)), TypeError, /surface: the definition must be an object/);
    refuses(() => surfpath.surface(anything({ f: 'x' })), TypeError, /kind must be one of parametric, .*, not undefined/);
    refuses(() => surfpath.surface(anything({ kind: 'constructor' })), RangeError, /kind must be one of .*, not 'constructor'/);
    refuses(() => surfpath.surface(anything({ kind: 'metric' })), TypeError, /the definition needs E, F, G, u, v; E is missing/);
  });

  test('names of Object.prototype are unknown like any other', () => {
    for (const name of ['constructor', '__proto__', 'toString', 'hasOwnProperty'])
      refuses(() => surfpath.implicit({ f: `${name}*x` }), ExpressionError, /unknown name/);
  });

  test('an ExpressionError says where', () => {
    try {
      surfpath.implicit({ f: 'x + sinus(y)' });
      assert.fail('accepted');
    } catch (error) {
      assert.ok(error instanceof ExpressionError && error instanceof Error);
      assert.deepEqual([error.name, error.source, error.index, error.argument], ['ExpressionError', 'x + sinus(y)', 4, 'f']);
      assert.match(error.message, /did you mean sin\?/);
    }
  });

  test('changing a definition afterwards changes nothing', () => {
    const definition = { x: 'cos(2pi u)', y: 'sin(2pi u) + v', z: 'h', u: [0, 1], v: [0, 1], parameters: { h: 1 }, periodic: { u: true } };
    const plane = surfpath.parametric(anything(definition));
    definition.u[1] = 5;
    definition.parameters.h = 7;
    definition.periodic.u = false;
    plane.set({ h: 2 });
    assert.deepEqual(plane.domain, { u: [0, 1], v: [0, 1], periodic: { u: true, v: false } });
    assert.equal(plane.evaluate([0, 0])[2], 2);
  });
});
