/** Gauss's rule of three places on 0 … 1: where, and how much each counts. Right for polynomials of the fifth degree. */
export const GAUSS = [-1, 0, 1].map((side) => ({ at: 0.5 + side * Math.sqrt(0.15), weight: side ? 5 / 18 : 8 / 18 }));
