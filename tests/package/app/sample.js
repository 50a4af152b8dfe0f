/* What every consumer computes, through both entries: a line a path, with all digits, so that the same text means the same bits. */

import * as inlined from 'surfpath';
import { SurfacePathElement } from 'surfpath/element';
import { gallery } from 'surfpath/gallery';
import { createPool } from 'surfpath/pool';
import * as slim from 'surfpath/slim';
import { GeodesicLine, surfaceGeometry } from 'surfpath/three';
import { stayUnderFire } from './fire.js';

/** @returns {Promise<string>} */
export async function sample() {
  const said = await solve(inlined);
  const again = await solve(slim);
  if (again !== said) throw new Error(`the entries differ:\n${said}\n${again}`);
  return `${said}\n${await draw()}\n${await place()}\n${await share()}\n${await stayUnderFire()}`;
}

/** @param {typeof inlined | typeof slim} entry */
async function solve({ load, ExpressionError }) {
  const surfpath = await load();
  const lines = [gallery.saddle, gallery.torus].map((entry) => {
    const path = surfpath.surface(entry).shortestPath(entry.from, entry.to, { points: 9 });
    return `${entry.title}: ${path.status} ${path.length} ${path.points.slice(12, 15).join(' ')}`;
  });
  try {
    surfpath.implicit({ f: 'x +' });
  } catch (error) {
    if (error instanceof ExpressionError) lines.push(String(error));
  }
  surfpath.dispose();
  return lines.join('\n');
}

/** Lengths by two workers, and what they say of a formula. */
async function share() {
  const pool = createPool({ workers: 2 });
  const { torus } = gallery;
  const lengths = await pool.lengths(torus, [...torus.from, ...torus.to, ...torus.to, ...torus.from], { points: 9 });
  const error = await pool.lengths({ kind: 'implicit', f: 'x +' }, []).catch((problem) => problem);
  await pool.dispose();
  return `two workers: ${lengths.join(' ')}; ${error instanceof inlined.ExpressionError ? error : 'another class'}`;
}

/** The objects for three.js, as far as they go without a canvas. */
async function draw() {
  const surfpath = await inlined.load();
  const { torus } = gallery;
  const surface = surfpath.surface(torus);
  const geometry = surfaceGeometry(surface, { resolution: 12 });
  const line = new GeodesicLine(surface.shortestPath(torus.from, torus.to, { points: 9 }));
  return `three.js: ${geometry.getAttribute('position').count} vertices, a line is a ${line.type}`;
}

/** The length that <surface-path> tells where there are elements; elsewhere, where importing it does nothing, what it would tell. */
async function place() {
  const { from, to } = gallery.torus;
  if (!globalThis.customElements) return `element: ${(await inlined.load()).surface(gallery.torus).shortestPath(from, to).length}`;
  const element = document.createElement('surface-path');
  if (!(element instanceof SurfacePathElement)) throw new Error('<surface-path> is not defined');
  element.setAttribute('surface', 'torus');
  const path = await new Promise((resolve, reject) => {
    element.addEventListener('path', ({ detail }) => resolve(detail));
    element.addEventListener('error', ({ detail }) => reject(detail));
    document.body.append(element);
  });
  element.remove();
  return `element: ${path.length}`;
}
