/** surfpath/three: surfaces and paths as three.js objects. Needs the optional peer dependency `three`; importing it has no effects. */

export { fitCamera } from './fit.js';
export { surfaceGeometry } from './geometry.js';
export { DragHandle } from './handle.js';
export { GeodesicLine } from './line.js';
export { Marker } from './marker.js';
export { surfaceMaterial } from './material.js';
export { PathPlayer } from './player.js';

/** @typedef {import('./geometry.js').GeometryOptions} GeometryOptions */
/** @typedef {import('./colouring.js').ColourScale} ColourScale */
/** @typedef {import('./line.js').GeodesicLineOptions} GeodesicLineOptions */
/** @typedef {import('./handle.js').DragHandleOptions} DragHandleOptions */
/** @typedef {import('./player.js').PathPlayerOptions} PathPlayerOptions */
