import type { Path } from './element.js';

/* What is below is added to the types of the element, which JSDoc cannot say. */
declare global {
  interface HTMLElementTagNameMap {
    'surface-path': SurfacePathElement;
  }
}
/** What the element's events are. */
export interface SurfacePathEvents extends Omit<HTMLElementEventMap, 'error'> {
  path: CustomEvent<Path>;
  error: CustomEvent<Error>;
}
export interface SurfacePathElement {
  addEventListener<K extends keyof SurfacePathEvents>(
    type: K,
    listener: (this: SurfacePathElement, event: SurfacePathEvents[K]) => void,
    options?: boolean | AddEventListenerOptions,
  ): void;
  addEventListener(type: string, listener: EventListenerOrEventListenerObject | null, options?: boolean | AddEventListenerOptions): void;
  removeEventListener<K extends keyof SurfacePathEvents>(
    type: K,
    listener: (this: SurfacePathElement, event: SurfacePathEvents[K]) => void,
    options?: boolean | EventListenerOptions,
  ): void;
  removeEventListener(type: string, listener: EventListenerOrEventListenerObject | null, options?: boolean | EventListenerOptions): void;
}
