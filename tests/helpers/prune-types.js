/**
 * What no entry of the package leads to in the .d.ts files of a folder, statement by statement. Run as a program by `make`, it deletes that, most of what tsc writes: it is of no
 * use to who installs the package. Statements of tsc's begin at the left margin.
 */

import { readdir, readFile, rm, writeFile } from 'node:fs/promises';
import { dirname, join, normalize, relative } from 'node:path';
import { fileURLToPath } from 'node:url';

/** @typedef {[file: string, name: string]} Use a name that a file declares, or all of them */
/** @typedef {{ text: string, names: string[], uses: Use[] }} Statement with the comments in front of it; names that it gives to others */

const ROOT = fileURLToPath(new URL('../..', import.meta.url));
const ALL = '*';
/** What has become a type of the same name. */
const TYPEDEF = /^\/\*\* @typedef .*\*\/\n/gm;
const COMMENT = /\/\*[\s\S]*?\*\/\s*/g;
const BEGIN = /^(?=\/\*|(?:export|import|declare) )/m;
const DECLARED = /^(?:export |declare |abstract )*(?:type|interface|class|const|function) ([\w$]+)/;
const HANDED_ON = /^(?:export|import) (?:\{(.*)\}|\*) from '(\..+)\.js'/;
const IMPORTED = /import\('(\.[^']+)\.js'\)(?:\.(\w+))?/g;

/** The entries' types, as package.json names them. @returns {Promise<string[]>} */
async function entries() {
  const { exports } = JSON.parse(await readFile(join(ROOT, 'package.json'), 'utf8'));
  return Object.values(exports).flatMap(({ types }) => (types ? [join(ROOT, types)] : []));
}

/** @param {string} code of a statement, without comments */
const namesOf = (code) =>
  HANDED_ON.exec(code)?.[1]
    ?.split(',')
    .map((name) => name.trim()) ?? [DECLARED.exec(code)?.[1] ?? ALL];

/** @param {string} file @param {string} text of it @returns {Statement[]} */
function statementsOf(file, text) {
  /** @type {string[]} */
  const texts = [''];
  for (const part of text.split(BEGIN)) {
    if (texts[texts.length - 1].replace(COMMENT, '')) texts.push('');
    texts[texts.length - 1] += part;
  }
  const at = (/** @type {string} */ name) => normalize(join(dirname(file), `${name}.d.ts`));
  const codes = texts.map((one) => one.replace(COMMENT, ''));
  const declared = codes.flatMap(namesOf);
  return codes.map((code, i) => {
    const names = namesOf(code);
    const words = new Set(code.replace(IMPORTED, '').match(/[\w$]+/g));
    const from = HANDED_ON.exec(code)?.[2];
    /** @type {Use[]} */
    const uses = [
      ...Array.from(code.matchAll(IMPORTED), ([, other, name = ALL]) => /** @type {Use} */ ([at(other), name])),
      ...(from ? names.map((name) => /** @type {Use} */ ([at(from), name])) : []),
      ...declared.filter((name) => name !== ALL && words.has(name)).map((name) => /** @type {Use} */ ([file, name])),
    ];
    return { text: texts[i], names, uses };
  });
}

/**
 * What is left of each file; '': nothing. Throws where one uses what no file of the folder gives.
 * @param {string} folder
 */
export async function pruned(folder) {
  const names = (await readdir(folder, { recursive: true })).filter((name) => name.endsWith('.d.ts')).map((name) => join(folder, name));
  const files = new Map(
    await Promise.all(names.map(async (name) => /** @type {const} */ ([name, statementsOf(name, await readFile(name, 'utf8'))]))),
  );
  /** @type {Set<Statement>} */
  const kept = new Set();
  /** @type {Use[]} */
  const left = (await entries()).map((file) => [file, ALL]);
  for (let use = left.pop(); use; use = left.pop()) {
    const [file, name] = use;
    const given = files.get(file)?.filter(({ names }) => name === ALL || names.includes(name) || names.includes(ALL));
    if (!given?.length) throw new Error(`${file} gives no ${name}, which another file of the package uses`);
    for (const statement of given) {
      if (kept.has(statement)) continue;
      kept.add(statement);
      left.push(...statement.uses);
    }
  }
  return new Map(
    Array.from(files, ([file, statements]) => [
      file,
      statements
        .filter((one) => kept.has(one))
        .map((one) => one.text.replace(TYPEDEF, ''))
        .join(''),
    ]),
  );
}

if (process.argv[1] === fileURLToPath(import.meta.url))
  for (const [file, text] of await pruned(join(ROOT, relative(ROOT, process.argv[2])))) await (text ? writeFile(file, text) : rm(file));
