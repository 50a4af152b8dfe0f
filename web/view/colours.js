/** What things look like unless they are told otherwise. */

export const SURFACE = '#d3d9de';
/** The path, and its ends. */
export const PATH = '#e8501f';
/** The start, from which a path converges. */
export const START = '#2f6fd6';
/** Around a line, and around an end. */
export const HALO = '#ffffff';
