// README.md keeps its word: its JavaScript runs as written and prints what it says, its web page names files that exist, its names are all there are.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { before, describe, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { gallery } from '../../web/gallery.js';
import { load } from '../../web/index.js';
import { STATUS } from '../../web/runtime/status.js';

const root = fileURLToPath(new URL('../..', import.meta.url));
const readme = readFileSync(`${root}/README.md`, 'utf8');

/** Fenced blocks of a language. @param {string} language */
const blocks = (language) => [...readme.matchAll(new RegExp(`^\`\`\`${language}\n(.*?)^\`\`\`$`, 'gms'))].map(([, text]) => text);

/** Inside the package, so that it finds itself by its name. */
const PROGRAM = `${root}/build/readme.mjs`;

/** Words and numbers of a text; of an array as Node prints it, its elements. @param {string} text */
const tokens = (text) =>
  text
    .replace(/Float64Array\(\d+\) /g, '')
    .split(/[\s,[\]]+/)
    .filter(Boolean);

/** Whether a printed word is the promised one, a number to the digits shown. @param {string} printed @param {string} promised */
function agrees(printed, promised) {
  if (!/^-?\d+(\.\d+)?$/.test(promised)) return printed === promised;
  const digits = promised.split('.')[1]?.length ?? 0;
  return Math.abs(Number(printed) - Number(promised)) <= 0.5001 * 10 ** -digits;
}

describe('the JavaScript of README.md', () => {
  const source = blocks('js').join('\n');
  const promised = [...source.matchAll(/console\.log\(.*\); \/\/ → (.*)$/gm)].map(([line, text]) => ({ line, text }));
  /** @type {string[]} */ let printed;

  before(() => {
    mkdirSync(`${root}/build`, { recursive: true });
    const program = `import { inspect } from 'node:util';\ninspect.defaultOptions.breakLength = Infinity;\n${source}`;
    writeFileSync(PROGRAM, program);
    printed = execFileSync(process.execPath, [PROGRAM], { encoding: 'utf8' }).trim().split('\n');
  });

  test('prints a line for every arrow, and an arrow stands at every line', () => {
    assert.ok(promised.length > 20);
    assert.equal(promised.length, [...source.matchAll(/console\.log/g)].length);
    assert.equal(printed.length, promised.length);
  });

  for (const [i, { line, text }] of promised.entries())
    test(line, () => {
      const [actual, expected] = [tokens(printed[i]), tokens(text)];
      assert.ok(actual.length === expected.length && actual.every((word, k) => agrees(word, expected[k])), `printed ${printed[i]}`);
    });
});

describe('every public name', async () => {
  const surfpath = await load();
  const surface = surfpath.graph({ z: 0, x: [0, 1], y: [0, 1] });
  const source = blocks('js').join('\n');
  const names = (/** @type {object} */ instance) => {
    const all = Object.getOwnPropertyNames(Object.getPrototypeOf(instance)).filter((name) => name !== 'constructor');
    assert.ok(all.length > 5);
    return all;
  };

  for (const name of new Set([...names(surfpath), ...names(surface)]))
    test(`${name} has a heading or is in one, and an example`, () => {
      assert.match(readme, new RegExp(`^#+ .*\\b${name}\\b`, 'm'));
      assert.match(source, new RegExp(`\\.${name}\\b`));
    });

  test('every option of shortestPath is in its table, and in an example', () => {
    const nonsense = /** @type {any} */ ({ nonsense: 1 });
    /** @type {string[]} */ let options = [];
    assert.throws(
      () => surface.shortestPath([0, 0], [1, 1], nonsense),
      ({ message }) => {
        options = message.split('the options are ')[1].split(', ');
        return options.length > 5;
      },
    );
    for (const option of options) {
      assert.ok(readme.includes(`| \`${option}\` |`), option);
      assert.match(source, new RegExp(`{[^}]*\\b${option}\\b[^}]*}\\)`), option);
    }
  });

  test('every field of a path is in the table', () => {
    for (const field of Object.keys(surface.shortestPath([0, 0], [1, 1])))
      assert.match(readme, new RegExp(`^\\| [^|]*\`${field}\``, 'm'), field);
  });
});

describe('the first web page of README.md', () => {
  // The others are opened by tests/browser.
  const [page] = blocks('html');

  test('maps surfpath to the file that the package exports', () => {
    const map = JSON.parse(/** @type {RegExpExecArray} */ (/<script type="importmap">(.*?)<\/script>/s.exec(page))[1]);
    const { exports } = JSON.parse(readFileSync(`${root}/package.json`, 'utf8'));
    assert.deepEqual(map.imports, { surfpath: exports['.'].default });
    assert.ok(existsSync(`${root}/${map.imports.surfpath}`));
  });

  test('runs: its script writes the path into the page', () => {
    const [, script] = /** @type {RegExpExecArray} */ (/<script type="module">(.*?)<\/script>/s.exec(page));
    const program = `${root}/build/readme-page.mjs`;
    writeFileSync(program, `globalThis.document = { body: { append: console.log } };\n${script}`);
    const printed = execFileSync(process.execPath, [program], { encoding: 'utf8' });
    assert.match(printed, /^converged: 1\.5707/);
  });
});

describe('the tables and lists of README.md', () => {
  test('name every status', () => {
    for (const status of STATUS.values()) assert.ok(readme.includes(`\`${status}\``), status);
  });

  test('name every surface of the gallery, and no other', () => {
    const [, section] = /** @type {RegExpExecArray} */ (/^## Gallery$(.*?)^## /ms.exec(readme));
    const listed = section
      .split('```')
      .at(-1)
      ?.match(/(?<=`)\w+(?=`)/g);
    assert.deepEqual(listed, Object.keys(gallery));
  });

  test('name files and headings that exist', () => {
    const headings = [...readme.matchAll(/^#+ (.*)$/gm)].map(([, heading]) =>
      heading
        .toLowerCase()
        .replace(/[^\w -]/g, '')
        .replaceAll(' ', '-'),
    );
    for (const [, target] of readme.matchAll(/\]\((?!https:)([^)]+)\)/g))
      assert.ok(target.startsWith('#') ? headings.includes(target.slice(1)) : existsSync(`${root}/${target}`), target);
  });
});
