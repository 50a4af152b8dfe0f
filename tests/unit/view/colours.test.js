// The colours of the page and of surfpath/three are told apart by readers with any colour vision, in the light theme and in the dark one.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { describe, test } from 'node:test';
import { DIVERGING, SEQUENTIAL } from '../../../web/view/colouring.js';

/** Machado, Oliveira, Fernandes 2009, severity 1: linear RGB as it is seen. @type {Record<string, number[][]>} */
const VISIONS = {
  normal: [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ],
  protanopia: [
    [0.152286, 1.052583, -0.204868],
    [0.114503, 0.786281, 0.099216],
    [-0.003882, -0.048116, 1.051998],
  ],
  deuteranopia: [
    [0.367322, 0.860646, -0.227968],
    [0.280085, 0.672501, 0.047413],
    [-0.01182, 0.04294, 0.968881],
  ],
  tritanopia: [
    [1.255528, -0.076749, -0.178779],
    [-0.078411, 0.930809, 0.147602],
    [0.004733, 0.691367, 0.3039],
  ],
};
/** Rows: X, Y, Z of linear sRGB, over the white point D65. */
const XYZ = [
  [0.4124 / 0.9505, 0.3576 / 0.9505, 0.1805 / 0.9505],
  [0.2126, 0.7152, 0.0722],
  [0.0193 / 1.089, 0.1192 / 1.089, 0.9505 / 1.089],
];

/** @param {number[][]} matrix @param {number[]} vector */
const times = (matrix, vector) => matrix.map((row) => row.reduce((sum, x, i) => sum + x * vector[i], 0));

/** CIE L* a* b* of a colour as somebody sees it. @param {string} hex @param {string} vision */
function seen(hex, vision) {
  const linear = [1, 3, 5].map((i) => {
    const x = Number.parseInt(hex.slice(i, i + 2), 16) / 255;
    return x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4;
  });
  const light = times(VISIONS[vision], linear).map((x) => Math.min(Math.max(x, 0), 1));
  const [x, y, z] = times(XYZ, light).map((t) => (t > 0.008856 ? Math.cbrt(t) : 7.787 * t + 16 / 116));
  return [116 * y - 16, 500 * (x - y), 200 * (y - z)];
}

/** How far apart two colours are: 2 is just noticeable. @param {string} one @param {string} other @param {string} vision */
function distance(one, other, vision) {
  const [a, b] = [seen(one, vision), seen(other, vision)];
  return Math.hypot(...a.map((x, i) => x - b[i]));
}

/** The colours of both themes by name. */
async function themes() {
  const text = await readFile(new URL('../../../demo/styles/theme.css', import.meta.url), 'utf8');
  return text
    .split('@media')
    .map((part) => Object.fromEntries([...part.matchAll(/--([\w-]+): (#[0-9a-f]{6});/g)].map(([, name, hex]) => [name, hex])));
}

for (const vision of Object.keys(VISIONS))
  describe(vision, () => {
    test('path, start and other geodesics differ from each other and from the surface', async () => {
      for (const theme of await themes())
        for (const [one, other] of [
          ['path', 'start'],
          ['path', 'other'],
          ['path', 'surface'],
          ['start', 'surface'],
          ['path', 'halo'],
        ])
          assert.ok(distance(theme[one], theme[other], vision) > 18, `${one} ${theme[one]}, ${other} ${theme[other]}`);
    });

    test('the stops of both palettes differ from each other, neighbours of a scale without steps less so', () => {
      for (const palette of [DIVERGING, SEQUENTIAL])
        for (const [i, one] of palette.entries())
          for (const [k, other] of palette.slice(i + 1).entries()) {
            const apart = distance(one, other, vision);
            assert.ok(apart > (k === 0 ? 5 : 14), `${one}, ${other}: ${apart}`);
          }
    });

    test('the long palette goes from light to dark, so that it reads in grey', () => {
      const lightness = SEQUENTIAL.map((hex) => seen(hex, vision)[0]);
      for (let i = 1; i < lightness.length; i++) assert.ok(lightness[i] < lightness[i - 1] - 2, `${lightness}`);
    });
  });
