/**
 * How much of a slow test is done: a sample in `make test`, all of it in `make samples`.
 * @template T @param {T} few @param {T} all @returns {T}
 */
export const ofAll = (few, all) => (process.env.EVERY_SAMPLE ? all : few);
