// A stranger's TypeScript: what must be accepted, and what must not. Checked by package.test.js where the package is installed.
import { createPool } from 'surfpath/pool';
import { type DistanceField, ExpressionError, type FieldOptions, type Iterate, load, type LoadOptions } from 'surfpath';
import { type GalleryEntry, gallery } from 'surfpath/gallery';
import { load as loadSlim, type LoadOptions as SlimOptions } from 'surfpath/slim';

const options: LoadOptions & SlimOptions = {};
const surfpath = await load(options);
const torus = surfpath.implicit({ f: '(sqrt(x^2 + y^2) - R)^2 + z^2 - 1', parameters: { R: 3 } });
const path = torus.shortestPath([4, 0, 0], [0, 3, 1], { points: 100, start: 'straight' });
const length: number = path.length;
const points: Float64Array = path.points;
const converged: boolean = path.converged;
const range: [number, number] | undefined = torus.domain?.u;
const slim = await loadSlim({ wasm: new URL('./surfpath.wasm', 'file:///') });
slim.dispose();
const wanted: FieldOptions = { resolution: 8, exact: false };
const field: DistanceField = torus.distanceField([4, 0, 0], wanted);

const decrements: number[] = path.history.map(({ decrement }: Iterate) => decrement);
const entries: GalleryEntry[] = Object.values(gallery);
const named: string[] = entries.map(({ title, parameters = {} }) => `${title}: ${Object.keys(parameters)}`);

const pool = createPool({ workers: 2 });
const sphere = { kind: 'implicit', f: 'x^2 + y^2 + z^2 - 1' } as const;
const report = ({ done, total }: { done: number; total: number }) => console.log(done / total);
const lengths: Float64Array = await pool.lengths(sphere, [1, 0, 0, 0, 1, 0], { signal: AbortSignal.timeout(50), onProgress: report });
{
  using short = surfpath.implicit({ f: 'x^2 + y^2 + z^2 - 1' });
  using instance = await load();
  await using workers = createPool();
  console.log(short.kind, instance.surface(sphere).kind, workers);
}
const one: number = (await pool.shortestPath(sphere, [1, 0, 0], [0, 1, 0], { tolerance: 1e-6 })).length;
await pool.dispose();

try {
  surfpath.parametric({ x: 'u', y: 'v', z: 'sin u', u: [0, 1], v: [0, 1] });
} catch (error) {
  if (error instanceof ExpressionError) console.log(error.source, error.index.toFixed());
}

// @ts-expect-error: no such status
export const impossible = path.status === 'perfect';
// @ts-expect-error: one path has no progress
pool.shortestPath(sphere, [1, 0, 0], [0, 1, 0], { onProgress: report });
// @ts-expect-error: a point is numbers
torus.shortestPath('4, 0, 0', [0, 3, 1]);
// @ts-expect-error: an implicit surface needs f
surfpath.implicit({
  bounds: [
    [-1, 1],
    [-1, 1],
    [-1, 1],
  ],
});

export { converged, decrements, field, length, lengths, named, one, points, range };
