/* Where formulas are not smooth: `abs`, `min`, `max` and `sign` change sides where a difference vanishes. Written for one side of each, a formula is smooth, beyond the crease,
 * too; with its creases rounded it is smooth everywhere, and another formula beside them. */

/** @typedef {import('./differentiate.js').Calculus} Calculus */
/** @typedef {import('./differentiate.js').Jet} Jet */
/** @typedef {import('./graph.js').Graph} Graph */

/** @typedef {{ sides?: readonly number[], widths?: readonly number[] }} Way one of both; sides: of each crease, 1 or −1: the sign of what vanishes there; widths: the parameter that tells how widely each is rounded */

/** Takes down where formulas have creases, or writes them for given sides of these, or rounded. */
export class Creases {
  /** What vanishes on each crease: its node, one for each `abs`, `sign` and pair of `min` or `max`, in the order in which formulas are read. @type {number[]} */ nodes =
    [];
  /** What jumps wherever it changes: the node of each `floor`. @type {number[]} */ floors = [];
  /** @type {readonly number[] | undefined} */ #sides;
  /** @type {readonly number[] | undefined} */ #widths;

  /** @param {Way | null} [way] in which formulas are written; null: as they are */
  constructor(way = null) {
    this.#sides = way?.sides;
    this.#widths = way?.widths;
  }

  /** How many parameters the widths are. */
  get widthCount() {
    return new Set(this.#widths).size;
  }

  /**
   * As {@link Calculus.call}. The sign of a product, or its size, is that of its factors: where two of them vanish the product has no slope.
   * @param {Graph} graph @param {Calculus} calculus @param {string} name @param {Jet[]} operands @param {boolean} isSplit signs or sizes are asked for
   * @returns {Jet}
   */
  call(graph, calculus, name, operands, isSplit) {
    if (!isSplit) return this.#call(graph, calculus, name, operands);
    const isFixed = operands.every((operand) => operand.isFixed);
    const factors = name === 'abs' || name === 'sign' ? factorsOf(operands[0]) : [];
    if (factors.filter((factor) => !factor.isFixed).length > 1)
      return factors
        .map((factor) => (factor.isFixed ? calculus.call(name, [factor]) : this.#call(graph, calculus, name, [factor])))
        .reduce((one, other) => calculus.call('multiply', [one, other]));
    const jet = this.#call(graph, calculus, name, operands);
    return { ...jet, isFixed, factors: name === 'multiply' ? operands : undefined };
  }

  /** As {@link call}, of a product as it is. @param {Graph} graph @param {Calculus} calculus @param {string} name @param {Jet[]} operands @returns {Jet} */
  #call(graph, calculus, name, operands) {
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
    const number = (/** @type {number} */ x) => calculus.constant(graph.constant(x));
    const width = (/** @type {Jet} */ jet) => {
      this.nodes.push(jet.value);
      return calculus.constant(graph.parameter(widths[this.nodes.length - 1]));
    };
    const size = (/** @type {Jet} */ jet) => calculus.call('hypot', [jet, width(jet)]);
    const [a] = operands;
    if (name === 'abs') return size(a);
    if (name === 'sign') return jump(calculus, number, a, width(a));
    if (name !== 'min' && name !== 'max') return calculus.call(name, operands);
    return operands.reduce((one, other) => {
      const gap = size(calculus.call('subtract', [one, other]));
      const both = calculus.call(name === 'max' ? 'add' : 'subtract', [calculus.call('add', [one, other]), gap]);
      return calculus.call('multiply', [number(0.5), both]);
    });
  }

  /** @param {Graph} graph @param {number} node @returns {number | undefined} the side that is wanted; where other sides leave no choice, as in max(0, sign(g)), the one there is */
  #pass(graph, node) {
    this.nodes.push(node);
    return this.#sides && (Math.sign(graph.numberOf(node)) || this.#sides[this.nodes.length - 1]);
  }
}

/** What a jet is the product of, in order; itself, where it is none. @param {Jet} jet @returns {Jet[]} */
function factorsOf(jet) {
  const [open, factors] = [[jet], /** @type {Jet[]} */ ([])];
  for (let next = open.pop(); next; next = open.pop())
    if (next.factors) open.push(...[...next.factors].reverse());
    else factors.push(next);
  return factors;
}

/**
 * For the sign of g, ±(2((1 + x/√(1 + x²))/2)⁴ − 1), x = g/w: it jumps where g has the sign of w, the dear side's. On the other one (w/g)⁸ is left of it, which does not push paths away;
 * on this one (w/g)², which still draws them out of it.
 * @param {Calculus} calculus @param {(x: number) => Jet} number @param {Jet} g @param {Jet} w
 */
function jump(calculus, number, g, w) {
  const call = (/** @type {string} */ name, /** @type {Jet[]} */ ...operands) => calculus.call(name, operands);
  const x = call('divide', g, w);
  const risen = call('add', call('divide', x, call('hypot', x, number(1))), number(1));
  return call('multiply', call('sign', w), call('subtract', call('divide', call('pow', risen, number(4)), number(8)), number(1)));
}
