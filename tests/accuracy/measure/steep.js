/** Heights over |u| ≤ side, |v| ≤ across, or as much, that are steep, mostly test functions of optimisation as they stand. */

/** Two paths may each be wrong by their tolerance, 1e-9 in parts of the length. */
export const RIGHT = 2e-9;

/** @type {Record<string, { z: string, side: number, across?: number }>} */
export const STEEP = {
  Rastrigin: { z: '20 + u^2 + v^2 - 10cos(2pi*u) - 10cos(2pi*v)', side: 5.12 },
  Himmelblau: { z: '(u^2 + v - 11)^2 + (u + v^2 - 7)^2', side: 5 },
  Rosenbrock: { z: '(1 - u)^2 + 100(v - u^2)^2', side: 2 },
  'Styblinski–Tang': { z: '0.5(u^4 - 16u^2 + 5u + v^4 - 16v^2 + 5v)', side: 5 },
  Beale: { z: '(1.5 - u + u*v)^2 + (2.25 - u + u*v^2)^2 + (2.625 - u + u*v^3)^2', side: 3 },
  Schwefel: { z: '838 - u*sin(sqrt(sqrt(u^2 + 1))) - v*sin(sqrt(sqrt(v^2 + 1)))', side: 500 },
  Levy: { z: 'sin(3pi*u)^2 + (u - 1)^2*(1 + sin(3pi*v)^2) + (v - 1)^2*(1 + sin(2pi*v)^2)', side: 10 },
  'peaks × 100': { z: '100(3(1 - u)^2*exp(-u^2 - (v + 1)^2) - 10(u/5 - u^3 - v^5)*exp(-u^2 - v^2) - exp(-(u + 1)^2 - v^2)/3)', side: 3 },
  Booth: { z: '(u + 2v - 7)^2 + (2u + v - 5)^2', side: 10 },
  Camel: { z: '2u^2 - 1.05u^4 + u^6/6 + u*v + v^2', side: 5 },
  Bohachevsky: { z: 'u^2 + 2v^2 - 0.3cos(3pi*u) - 0.4cos(4pi*v) + 0.7', side: 5 },
  waves: { z: 'sin(6u) + 0.3v^2', side: 4, across: 1 },
  'egg box': { z: '20sin(3u)*sin(3v)', side: 4 },
  ripples: { z: '30cos(3sqrt(u^2 + v^2 + 0.01))', side: 4 },
  terrain: { z: '50(sin(2u)*cos(3v) + 0.5sin(5u + 1)*sin(4v) + 0.2cos(9u - 7v))', side: 3 },
};
