//! Commas between digits, which may be separators or decimal commas.

use super::ast::{Document, Item, Record};
use super::lexer::{Token, TokenKind};
use super::table::ParamKind;
use crate::diagnostics::Span;

/// Finds each pair of integers with a comma between them that was read as a separator and may be a decimal comma, as in
/// `(0,5; 1)`. A pair is one token here. Commas of a longer list, such as `1,2,3`, are separators in any case.
pub fn pairs<'a>(text: &'a str, tokens: &'a [Token]) -> impl Iterator<Item = Token> + 'a {
    let is_comma = move |i: usize| {
        let token = tokens.get(i);
        token.is_some_and(|t| t.kind() == TokenKind::Separator && t.text(text) == ",")
    };
    let is_integer = |t: &Token| t.kind() == TokenKind::Integer;
    // Whether a token and the next one touch.
    let touches = |i: usize| {
        let ends = tokens.get(i).zip(tokens.get(i + 1));
        ends.is_some_and(|(a, b)| a.end() == b.start)
    };
    (1..tokens.len())
        .filter(move |&i| is_comma(i))
        .filter_map(move |i| {
            let (a, b) = (tokens[i - 1], *tokens.get(i + 1)?);
            let is_pair = is_integer(&a)
                && is_integer(&b)
                && b.text(text).bytes().all(|c| c.is_ascii_digit())
                && touches(i - 1)
                && touches(i);
            let follows = i > 2 && is_comma(i - 2) && touches(i - 3) && touches(i - 2);
            let is_followed = is_comma(i + 2) && touches(i + 1) && touches(i + 2);
            (is_pair && !follows && !is_followed)
                .then(|| Token::new(TokenKind::DecimalComma, a.start as usize, b.end() as usize))
        })
}

/// The spans of the pairs of integers in a scene that may be one number with a decimal comma each, as in `2 11 0 1
/// 0,5`. The record then lacks another number.
pub fn in_doubt(text: &str, document: &Document) -> Vec<Span> {
    if !document.contents.separators {
        return Vec::new();
    }
    let records = document.items.iter().filter_map(Item::record);
    records
        .flat_map(|record| in_doubt_of(text, document, record))
        .collect()
}

/// The commas of one record that are in doubt.
pub fn in_doubt_of(text: &str, document: &Document, record: &Record) -> Vec<Span> {
    let tokens = &document.tokens[record.first as usize..=record.last as usize];
    if !tokens.iter().any(|t| t.kind() == TokenKind::Separator) {
        return Vec::new();
    }
    let (ty, count) = (record.ty(), record.count());
    // A pair with brackets around it alone is a point of two coordinates.
    let is_bracket = |t: Option<&Token>| {
        t.is_some_and(|t| t.kind() == TokenKind::Separator && !matches!(t.text(text), "," | ";"))
    };
    let is_in_brackets = |pair: &Token| {
        let from = document.tokens.partition_point(|t| t.start < pair.start);
        let to = document.tokens.partition_point(|t| t.start < pair.end());
        let before = from.checked_sub(1).and_then(|i| document.tokens.get(i));
        is_bracket(before) && is_bracket(document.tokens.get(to))
    };
    // An ID, a count and an axis have no decimals.
    let params: Vec<u32> = document.params(record).map(|t| t.start).collect();
    let index = |pair: &Token| params.binary_search(&pair.start).ok();
    let is_real = |i: usize| {
        ty.param(i, count)
            .is_some_and(|p| p.kind == ParamKind::Real)
    };
    let all: Vec<Token> = pairs(text, tokens)
        .filter(|pair| index(pair).is_some_and(is_real))
        .collect();
    // As many pairs as the profile has points: each pair is a point.
    if ty.is_counted() && all.len() == count {
        return Vec::new();
    }
    let doubtful = all.iter().filter(|pair| !is_in_brackets(pair));
    doubtful.map(Token::span).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::syntax::parse;

    #[test]
    fn a_comma_that_may_be_a_decimal_one() {
        for (line, doubtful) in [
            ("2 11 0 1 0,5", &["0,5"][..]),
            ("2 11 0,5 1 1", &["0,5"]),
            ("2 11 0; 1; 0,5", &["0,5"]),
            ("2 11 0, 1, -0,5", &["-0,5"]),
            ("2 11 <0 1> 0,5", &["0,5"]),
            ("2 14 3,1", &["3,1"]),
            ("2 -2 30,2", &["30,2"]),
            (
                "2 10 1,5 2,5 1 # three axes #\n3 12 0,5 1 0,5 2",
                &["0,5", "0,5"],
            ),
            // Separators.
            ("2 11,0,1,0,5", &[]),
            ("2 11 0,1,0 5", &[]),
            ("2 11 0, 1, 0, 5", &[]),
            ("2 11 <0,1,0>,5", &[]),
            ("2 5 <0,0> <1,1>", &[]),
            ("2 1 3 0,0 1,1 0,2", &[]),
            ("2 1 3 (0,0)\n(1,1)\n(0,2)", &[]),
            ("2 9 1\n3 9 2\n4 -101 2,3\n5 -399 4,4 0 0", &[]),
            // Numbers with a decimal comma, read as such.
            ("2 11 0 1 0 0,5", &[]),
            ("2 11 (0,5; 1,25; 0) 0,75", &[]),
        ] {
            let (document, _) = parse(line);
            let spans = in_doubt(line, &document);
            let texts: Vec<&str> = spans.iter().map(|span| &line[span.range()]).collect();
            assert_eq!(texts, doubtful, "{line}");
        }
    }
}
