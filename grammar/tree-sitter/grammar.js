// The ZPG scene language. A record's type says how many numbers follow, so an external scanner tells IDs, types and
// parameters apart (src/scanner.c); what is left for the grammar is short.

module.exports = grammar({
  name: "zpg",

  // In the order of `enum TokenType` in src/scanner.c.
  externals: ($) => [
    $.comment,
    $.void,
    $.id,
    $.type,
    $.number,
    $.reference,
    $.colour,
    $.angle,
    $.file,
    $.word,
    // In no rule: a number too many is an error.
    $.surplus,
  ],

  extras: ($) => [/\s/, "\uFEFF", $.comment, $.separator],

  rules: {
    scene: ($) => repeat(choice($.record, $.void, $.word)),

    record: ($) =>
      prec.right(
        seq(
          field("id", $.id),
          optional(field("type", $.type)),
          repeat(choice($.number, $.reference, $.colour, $.angle, $.file, $.word)),
        ),
      ),

    // Read as white space.
    separator: () => /[,;<>(){}\u27E8\u27E9\u2329\u232A\u3008\u3009\u2039\u203A\u00AB\u00BB\u27EA\u27EB\u300A\u300B\u276C\u276D\u276E\u276F\u2770\u2771\uFF1C\uFF1E\uFE64\uFE65\uFF08\uFF09\uFE59\uFE5A\uFF5B\uFF5D\uFE5B\uFE5C\uFF0C\uFE50\u3001\uFF1B\uFE54\uFF3B\uFF3D\u037E\u005B\u005D]/,
  },
});
