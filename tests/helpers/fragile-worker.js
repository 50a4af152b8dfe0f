/* A worker of a pool that dies of a pair, or of a point, with MORTAL in it: at once, as for want of memory. Else it is the true one. */

import '../../web/runtime/worker.js';
import { Surface } from '../../web/surface.js';

const MORTAL = 0.123456789;

for (const method of /** @type {const} */ (['lengths', 'shortestPaths', 'shortestPath'])) {
  /** @type {any} */ const prototype = Surface.prototype;
  const answer = prototype[method];
  prototype[method] = function (/** @type {ArrayLike<number>} */ numbers, /** @type {any[]} */ ...others) {
    if (Array.from(numbers).includes(MORTAL)) process.exit(1);
    return answer.call(this, numbers, ...others);
  };
}
