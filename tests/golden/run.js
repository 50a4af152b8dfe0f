// Solves all golden cases with what was built, and prints the hashes as JSON: `node run.js [share]`.
import { runCases } from './cases.js';

const built = (/** @type {string} */ name) => import(String(new URL(`../../dist/${name}.js`, import.meta.url)));
const [library, { gallery }] = [await built('index'), await built('gallery')];
console.log(JSON.stringify(await runCases(library, gallery, Number(process.argv[2] ?? 1))));
