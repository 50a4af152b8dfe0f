/* What is wrong with a formula, where, and what to write instead. */

/** An expression that cannot be understood. The message is one sentence that says what to write instead. */
export class ExpressionError extends Error {
  /** What a stack or a console shows: bundling shortens the name of the class itself. */
  static name = 'ExpressionError';

  /** @param {string} source @param {number} index @param {string} message one sentence, without the name of the argument @param {string} [argument] */
  constructor(source, index, message, argument = '') {
    super(argument ? `${argument}: ${message}` : message);
    this.name = 'ExpressionError';
    /** The whole text of the expression, or the name of the parameter at fault. */
    this.source = source;
    /** Position of the offending character in `source`, from 0, in UTF-16 units; the length of the text where it ends too early. */
    this.index = index;
    /** Which expression of the surface it is, such as 'x', 'f' or 'metric.E'; 'parameters' where a name is at fault. */
    this.argument = argument;
  }
}
