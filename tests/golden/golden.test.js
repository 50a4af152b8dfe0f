// A sample of `make golden`: the same bits in Node and in a native build of the same sources by gcc.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { gallery } from '../../web/gallery.js';
import { load } from '../../web/index.js';
import { solveStraight, straightProblems } from './cases.js';
import { buildGolden, hashNatively, makeSurfaces } from './native.js';

const COUNT = 24;
const core = fileURLToPath(new URL('../../build/native/core.o', import.meta.url));

test('straight starts have the same bits natively', async () => {
  const surfpath = await load();
  const surfaces = makeSurfaces(surfpath, gallery);
  const binary = buildGolden('gcc', '-O1', [core], surfaces);
  for (const [name, { entry, surface }] of Object.entries(surfaces)) {
    const problems = straightProblems(surface, entry, COUNT);
    assert.equal(hashNatively(binary, name, problems), solveStraight(surface, problems), name);
  }
  surfpath.dispose();
});
