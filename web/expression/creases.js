/* Where formulas are not smooth: `abs`, `min`, `max` and `sign` change sides where a difference vanishes. Written for one side of each, a formula is smooth, beyond the crease,
 * too; with its creases rounded it is smooth everywhere, and another formula beside them. */

/** @typedef {import('./differentiate.js').Calculus} Calculus */
/** @typedef {import('./differentiate.js').Jet} Jet */
/** @typedef {import('./graph.js').Graph} Graph */

/** @typedef {{ sides: readonly number[] } | { widths: readonly number[] }} Way sides: of each crease, 1 or −1: the sign of what vanishes there; widths: the parameter that tells how widely each is rounded */

/** Takes down where formulas have creases, or writes them for given sides of these, or rounded. */
export class Creases {
  /** What vanishes on each crease: its node, one for each `abs`, `sign` and pair of `min` or `max`, in the order in which formulas are read. @type {number[]} */ nodes =
    [];
  /** What jumps wherever it changes: the node of each `floor`. @type {number[]} */ floors = [];
  /** @type {readonly number[] | undefined} */ #sides;
  /** @type {readonly number[] | undefined} */ #widths;

  /** @param {Way | null} [way] in which formulas are written; null: as they are */
  constructor(way = null) {
    if (way && 'sides' in way) this.#sides = way.sides;
    if (way && 'widths' in way) this.#widths = way.widths;
  }

  /** How many parameters the widths are. */
  get widthCount() {
    return new Set(this.#widths).size;
  }

  /** As {@link Calculus.call}. @param {Graph} graph @param {Calculus} calculus @param {string} name @param {Jet[]} operands @returns {Jet} */
  call(graph, calculus, name, operands) {
    if (this.#widths) return this.#round(this.#widths, graph, calculus, name, operands);
    const [a] = operands;
    if (name === 'abs' || name === 'sign') {
      const side = this.#pass(graph, a.value);
      if (!side) return calculus.call(name, operands);
      if (name === 'sign') return calculus.constant(graph.constant(side));
      return side > 0 ? a : calculus.call('negate', [a]);
    }
    if (name === 'floor') {
      const floor = calculus.call(name, operands);
      this.floors.push(floor.value);
      return floor;
    }
    if (name !== 'min' && name !== 'max') return calculus.call(name, operands);
    return operands.reduce((one, other) => {
      const side = this.#pass(graph, graph.subtract(one.value, other.value));
      if (!side) return calculus.call(name, [one, other]);
      return side > 0 === (name === 'max') ? one : other;
    });
  }

  /** As {@link call}, with √(g² + w²) for |g|. @param {readonly number[]} widths @param {Graph} graph @param {Calculus} calculus @param {string} name @param {Jet[]} operands @returns {Jet} */
  #round(widths, graph, calculus, name, operands) {
    const size = (/** @type {Jet} */ jet) => {
      this.nodes.push(jet.value);
      return calculus.call('hypot', [jet, calculus.constant(graph.parameter(widths[this.nodes.length - 1]))]);
    };
    const [a] = operands;
    if (name === 'abs') return size(a);
    if (name === 'sign') return calculus.call('divide', [a, size(a)]);
    if (name !== 'min' && name !== 'max') return calculus.call(name, operands);
    const half = calculus.constant(graph.constant(0.5));
    return operands.reduce((one, other) => {
      const gap = size(calculus.call('subtract', [one, other]));
      const both = calculus.call(name === 'max' ? 'add' : 'subtract', [calculus.call('add', [one, other]), gap]);
      return calculus.call('multiply', [half, both]);
    });
  }

  /** @param {Graph} graph @param {number} node @returns {number | undefined} the side that is wanted; where other sides leave no choice, as in max(0, sign(g)), the one there is */
  #pass(graph, node) {
    this.nodes.push(node);
    return this.#sides && (Math.sign(graph.numberOf(node)) || this.#sides[this.nodes.length - 1]);
  }
}
