/* Where formulas are not smooth: `abs`, `min`, `max` and `sign` change sides where a difference vanishes. Written for one side of each, a formula is smooth, beyond the crease, too. */

/** @typedef {import('./differentiate.js').Calculus} Calculus */
/** @typedef {import('./differentiate.js').Jet} Jet */
/** @typedef {import('./graph.js').Graph} Graph */

/** Takes down where formulas have creases, or writes them for given sides of these. */
export class Creases {
  /** What vanishes on each crease: its node, one for each `abs`, `sign` and pair of `min` or `max`, in the order in which formulas are read. @type {number[]} */ nodes =
    [];
  #sides;

  /** @param {readonly number[] | null} [sides] of each of them, 1 or −1: the sign of what vanishes there; null: formulas stay as they are */
  constructor(sides = null) {
    this.#sides = sides;
  }

  /** As {@link Calculus.call}. @param {Graph} graph @param {Calculus} calculus @param {string} name @param {Jet[]} operands @returns {Jet} */
  call(graph, calculus, name, operands) {
    const [a] = operands;
    if (name === 'abs' || name === 'sign') {
      const side = this.#pass(a.value);
      if (!side) return calculus.call(name, operands);
      if (name === 'sign') return calculus.constant(graph.constant(side));
      return side > 0 ? a : calculus.call('negate', [a]);
    }
    if (name !== 'min' && name !== 'max') return calculus.call(name, operands);
    return operands.reduce((one, other) => {
      const side = this.#pass(graph.subtract(one.value, other.value));
      if (!side) return calculus.call(name, [one, other]);
      return side > 0 === (name === 'max') ? one : other;
    });
  }

  /** @param {number} node @returns {number | undefined} the side that is wanted */
  #pass(node) {
    this.nodes.push(node);
    return this.#sides?.[this.nodes.length - 1];
  }
}
