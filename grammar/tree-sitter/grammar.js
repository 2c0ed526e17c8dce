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
    separator: () => /[,;<>(){}⟨⟩〈〉‹›]/,
  },
});
