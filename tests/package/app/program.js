/* The program of every runtime: prints the sample. */

import { sample } from './sample.js';

console.log(await sample());
