/** Turns among all elements of a page: between two of them the browser may answer the reader and draw, so that a page with many is not held while they open. */

/** Ends when whoever came last has had its turn. */
let queue = Promise.resolve();

/** The browser has seen to what waits; a timer, which pages out of sight get once a second, would do it too. @returns {Promise<void>} */
const breathe = () =>
  new Promise((resolve) => {
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = () => {
      port1.close();
      resolve();
    };
    port2.postMessage(null);
  });

/** Comes soon where nobody else is at work. What is done after it without waiting is the turn. */
export function turn() {
  const mine = queue;
  queue = mine.then(breathe);
  return mine;
}

/** The browser has drawn what there is, or has not within a tenth of a second: of a page out of sight it draws nothing. @returns {Promise<void>} */
export const drawn = () =>
  new Promise((resolve) => {
    requestAnimationFrame(() => setTimeout(resolve));
    setTimeout(resolve, 100);
  });
