/* The program of every page: computes the sample and shows it where a test finds it. */

import { sample } from './sample.js';

const shown = document.querySelector('output');
try {
  shown.textContent = await sample();
} catch (error) {
  shown.textContent = `failed: ${error.stack}`;
}
shown.dataset.done = '';
