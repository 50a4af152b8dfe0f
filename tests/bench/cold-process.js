/* One fresh process: how long from nothing to the first path, and to surfaces from text, cold and warm. Milliseconds, as JSON. */
const started = performance.now();
const { load } = await import('surfpath');
const { gallery } = await import('surfpath/gallery');
const imported = performance.now();
const surfpath = await load();
const loaded = performance.now();
const surface = surfpath.surface(gallery.saddle);
const compiled = performance.now();
const path = surface.shortestPath(gallery.saddle.from, gallery.saddle.to);
const solved = performance.now();

/** Milliseconds from a definition to a surface that is ready. @param {import('surfpath/gallery').GalleryEntry} entry */
function compileTime(entry) {
  const start = performance.now();
  surfpath.surface(entry);
  return performance.now() - start;
}

const cold = { saddle: compiled - loaded, dini: compileTime(gallery.dini), threeTori: compileTime(gallery.threeTori) };
for (let i = 0; i < 8; i++) for (const entry of Object.values(gallery)) surfpath.surface(entry).dispose();

/* Engines keep modules that they have compiled before: exchanged, x and y give one of the same size that is new. */
const { saddle, dini, threeTori } = gallery;
const warm = {
  saddle: compileTime({ ...saddle, x: saddle.y, y: saddle.x }),
  dini: compileTime({ ...dini, x: dini.y, y: dini.x }),
  threeTori: compileTime({ ...threeTori, f: `(${threeTori.f})*2` }),
};
const first = { import: imported - started, load: loaded - imported, compile: compiled - loaded, solve: solved - compiled };
console.log(JSON.stringify({ first, total: solved - imported, cold, warm, length: path.length }));
