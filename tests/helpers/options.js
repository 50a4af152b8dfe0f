/** What tests of the polyline ask for: neither the elements nor the graph search, so that only Newton's method on chords is judged. */

/** @type {Readonly<{ algorithm: 'polyline', start: 'straight' }>} */
export const STRAIGHT = Object.freeze({ algorithm: 'polyline', start: 'straight' });

/** For solves that are given their start. @type {Readonly<{ algorithm: 'polyline' }>} */
export const POLYLINE = Object.freeze({ algorithm: 'polyline' });
