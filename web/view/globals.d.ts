import type { SurfacePathElement } from './element.js';

/* What is below is added to the types of the element, which JSDoc cannot say. */
declare global {
  interface HTMLElementTagNameMap {
    'surface-path': SurfacePathElement;
  }
}
