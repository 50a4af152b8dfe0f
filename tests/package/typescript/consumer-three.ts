// A stranger's TypeScript with three.js. Checked by package.test.js where the package, three and its types are installed.
import { load, type Path } from 'surfpath';
import { SurfacePathElement } from 'surfpath/element';
import { type ColourScale, DragHandle, GeodesicLine, PathPlayer, surfaceGeometry, surfaceMaterial } from 'surfpath/three';
import { Mesh, PerspectiveCamera, Scene } from 'three';

const surfpath = await load();
const torus = surfpath.implicit({ f: '(sqrt(x^2 + y^2) - 3)^2 + z^2 - 1' });
const path = torus.shortestPath([4, 0, 0], [0, 3, 1], { record: true });
const geometry = surfaceGeometry(torus, { colour: 'distance', from: [4, 0, 0], resolution: 64 });
const scale: ColourScale = geometry.userData.scale;
const mesh = new Mesh(geometry, surfaceMaterial(geometry, { roughness: 0.5, lines: false }));
const line = new GeodesicLine(path, { colour: '#e8501f', halo: null });
const domElement = document.createElement('canvas');
const handle = new DragHandle(torus, [4, 0, 0], {
  camera: new PerspectiveCamera(),
  domElement,
  onDrag: (point: number[]) => line.setPath(torus.shortestPath(point, [0, 3, 1])),
});
const player = new PathPlayer(line, path, { onFrame: (moment, iteration) => console.log(moment + iteration) });
new Scene().add(mesh, line, handle);
await player.play();

const element = document.querySelector('surface-path');
if (element instanceof SurfacePathElement) {
  const length: number | undefined = element.path?.length;
  element.from = [0.5, 0.6];
  element.definition = { kind: 'graph', z: 'x y', x: [-1, 1], y: [-1, 1] };
  element.addEventListener('path', ({ detail }) => console.log(detail.length));
  const listen = ({ detail }: CustomEvent<Path>) => console.log(detail.length);
  element.addEventListener('path', listen);
  element.removeEventListener('path', listen);
  element.addEventListener('error', ({ detail }) => console.log(detail.message));
  element.addEventListener('pointerdown', ({ clientX }) => console.log(clientX));
  element.addEventListener('mine', { handleEvent: ({ type }) => console.log(type) });
  console.log(length, element.from, element.definition.kind);
  // @ts-expect-error: the path is read, not set
  element.path = path;
}

// @ts-expect-error: there is no such colouring
surfaceGeometry(torus, { colour: 'red' });
// @ts-expect-error: a handle needs a camera
new DragHandle(torus, [4, 0, 0], { domElement });

export { scale };
