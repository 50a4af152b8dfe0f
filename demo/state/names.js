/** Names in formulas, as the library reads them. */

/** Each name of a formula. */
export const NAMES = /(?:(?!π)[\p{L}_])(?:(?!π)[\p{L}\d_₀-₉])*/gu;

/** @param {string} text */
export const isName = (text) => text.match(NAMES)?.[0] === text;
