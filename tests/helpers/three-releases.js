/** surfpath/three with each release of three.js that it is tested with, for tests in Node: three needs no WebGL until it draws. */

import { mkdir } from 'node:fs/promises';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { build } from 'esbuild';
import { RELEASES } from './scene.js';

const root = fileURLToPath(new URL('../..', import.meta.url));

/** @typedef {{ draw: typeof import('../../web/view/three.js'), THREE: typeof import('three') }} Release */

/** @param {string} name a folder of node_modules @returns {Promise<Release>} */
async function loadWith(name) {
  // What npm calls three is what the sources import.
  if (name === 'three') return { draw: await import('../../web/view/three.js'), THREE: await import('three') };
  const outfile = `${root}/build/view/${name}-${process.pid}.js`;
  await build({
    stdin: { contents: "export * as draw from './web/view/three.js';\nexport * as THREE from 'three';", resolveDir: root },
    alias: { three: name },
    bundle: true,
    format: 'esm',
    outfile,
  });
  return import(pathToFileURL(outfile).href);
}

/** @returns {Promise<[string, Release][]>} with what each is called */
export async function loadReleases() {
  await mkdir(`${root}/build/view`, { recursive: true });
  return Promise.all(
    Object.entries(RELEASES).map(async ([title, name]) => /** @type {[string, Release]} */ ([title, await loadWith(name)])),
  );
}
