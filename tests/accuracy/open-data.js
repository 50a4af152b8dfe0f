// What becomes of the stored cases at two tolerances: converged, right, wrong though called converged, errors that lengthError owns up to, time.
// Prints a table a tolerance and the cases that are not right. `node tests/accuracy/open-data.js [families]`
import { load } from '../../web/index.js';
import { solveOpenData } from './measure/open-data.js';

/** @typedef {import('./measure/open-data.js').Outcome} Outcome */

const families = process.argv[2] ?? 'ABCDEF';

/** @param {string} name @param {Outcome[]} outcomes */
function row(name, outcomes) {
  const solved = outcomes.filter(({ refused }) => !refused);
  const count = (/** @type {(outcome: Outcome) => boolean} */ is) => String(solved.filter(is).length);
  const times = solved.map(({ milliseconds }) => milliseconds).sort((a, b) => a - b);
  const columns = [
    String(outcomes.length),
    String(outcomes.length - solved.length),
    count(({ converged }) => converged),
    count(({ right }) => right),
    count(({ converged, right }) => converged && !right),
    count(({ converged, honest }) => converged && !honest),
    (times[times.length >> 1] ?? Number.NaN).toFixed(2),
    (times.at(-1) ?? Number.NaN).toFixed(1),
  ];
  return [name.padEnd(6), ...columns.map((column) => column.padStart(9))].join(' ');
}

const surfpath = await load();
for (const tolerance of [1e-9, 1e-12]) {
  const outcomes = solveOpenData(surfpath, { tolerance, families });
  console.log(`tolerance ${tolerance}`);
  console.log('family     cases   refused converged     right     wrong dishonest median ms    max ms');
  for (const family of families)
    console.log(
      row(
        family,
        outcomes.filter((outcome) => outcome.family === family),
      ),
    );
  console.log(row('all', outcomes));
  for (const { id, status, error, lengthError, right, honest, refused } of outcomes)
    if (!refused && !(right && honest))
      console.log(`  ${id}: ${status}, error ${error.toExponential(2)}, lengthError ${lengthError.toExponential(2)} of the length`);
  if (outcomes.some(({ converged, right }) => converged && !right)) process.exitCode = 1;
}
surfpath.dispose();
