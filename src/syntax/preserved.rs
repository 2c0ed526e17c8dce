//! Whether a text that a tool has changed still has the tokens that it had before. The tokens are compared as they are
//! written, whatever the parser makes of them.

use super::lexer::{self, Token, TokenKind};
use super::{Document, parse};
use crate::diagnostics::Edit;

/// Whether a text that is laid out anew has the tokens of the old one, unknown words and comments
/// included. Numbers may be spelled in another way, with the same value to the bit; notation marks may
/// be gone, and so may a `0` before a comment.
pub fn by_layout((old, document): (&str, &Document), new: &str) -> bool {
    let unclosed = unclosed(document);
    if unclosed.is_empty() && are_same_words(old.as_bytes(), new.as_bytes()) {
        return true;
    }
    let old_tokens = lexer::lex(old, &unclosed);
    // The comments that nobody closes are the same in the new text, if that is right, but at other offsets.
    let unclosed = match unclosed.as_slice() {
        [] => Vec::new(),
        _ => self::unclosed(&parse(new).0),
    };
    let new_tokens = lexer::lex(new, &unclosed);
    let matters = |t: &&Token| !t.kind().is_trivia() || t.kind().is_comment();
    let mut old_ones = old_tokens.iter().filter(matters).peekable();
    let mut new_ones = new_tokens.iter().filter(matters).peekable();
    while let Some(token) = old_ones.next() {
        let stays = new_ones
            .peek()
            .is_some_and(|other| other.text(new) == token.text(old));
        if token.kind() == TokenKind::DecimalComma && !stays && is_two(token, document) {
            let numbers = token.text(old).split(',');
            let mut values = numbers.map(|text| text.parse().ok().map(f64::to_bits));
            let mut next = || new_ones.next()?.number(new).map(f64::to_bits);
            if !values.all(|value| value.is_some() && value == next()) {
                return false;
            }
            continue;
        }
        let is_void = token.integer(old) == Some(0) && !token.text(old).starts_with('-');
        let introduces = is_void && old_ones.peek().is_some_and(|next| next.kind().is_comment());
        match new_ones.next_if(|other| is_same((old, token), (new, other))) {
            Some(_) => {}
            None if introduces => {}
            None => return false,
        }
    }
    new_ones.next().is_none()
}

/// Whether two texts differ only in the amount of white space where there is some, as most formatted texts do. All
/// comments must be closed. `false` says nothing: the texts may have the same tokens all the same.
fn are_same_words(old: &[u8], new: &[u8]) -> bool {
    let is_space = |c: &u8| matches!(c, b' ' | b'\t' | b'\n' | b'\r');
    let gap = |text: &[u8]| text.iter().take_while(|c| is_space(c)).count();
    let (mut old, mut new) = (old.trim_ascii(), new.trim_ascii());
    while let (Some(a), Some(b)) = (old.first(), new.first()) {
        (old, new) = match a {
            _ if is_space(a) && is_space(b) => (&old[gap(old)..], &new[gap(new)..]),
            // White space in a file name counts.
            b'"' => return false,
            b'#' => {
                let length = memchr::memchr(b'#', &old[1..]).map_or(old.len(), |i| i + 2);
                match new.strip_prefix(&old[..length]) {
                    Some(rest) => (&old[length..], rest),
                    None => return false,
                }
            }
            _ if a == b && a.is_ascii() => (&old[1..], &new[1..]),
            _ => return false,
        };
    }
    old.is_empty() && new.is_empty()
}

/// Whether the document reads a number with a comma as two numbers, as in `1,9999 2 0`.
fn is_two(token: &Token, document: &Document) -> bool {
    let tokens = &document.tokens;
    let found = tokens.binary_search_by_key(&token.start, |t| t.start);
    found.is_ok_and(|i| tokens[i].length() < token.length())
}

#[inline]
fn is_same((old, token): (&str, &Token), (new, other): (&str, &Token)) -> bool {
    let bits = |text, token: &Token| token.number(text).map(f64::to_bits);
    let value = bits(old, token);
    token.text(old) == other.text(new) || value.is_some() && value == bits(new, other)
}

/// Whether every token of the old text that no edit overlaps is a token of the new text, too. The edits are in order. A
/// token that an edit touches may have grown by the text of the edit.
pub fn by_edits(
    (old, document): (&str, &Document),
    edits: &[Edit],
    (new, edited): (&str, &Document),
) -> bool {
    let new_tokens = lexer::lex(new, &unclosed(edited));
    let mut new_ones = new_tokens.iter().peekable();
    let mut edits = edits.iter().peekable();
    // How many bytes the text behind the last edit has moved, and the range of the new text that this edit has written.
    let mut moved = 0;
    let mut inserted = (0, 0);
    for token in lexer::lex(old, &unclosed(document)) {
        if token.kind() == TokenKind::Newline {
            continue;
        }
        let (start, end) = (i64::from(token.start), i64::from(token.end()));
        while let Some(edit) = edits.next_if(|e| e.span.end <= token.start) {
            let at = i64::from(edit.span.start) + moved;
            let length = edit.text.len() as i64;
            moved += length - i64::from(edit.span.end - edit.span.start);
            let touches = inserted.1 == at;
            inserted = (if touches { inserted.0 } else { at }, at + length);
        }
        let next = edits.peek();
        if next.is_some_and(|e| e.span.start < token.end()) {
            continue;
        }
        let at = (start + moved, end + moved);
        if new.get(at.0 as usize..at.1 as usize) != Some(token.text(old)) {
            return false;
        }
        let before = if inserted.1 == at.0 { inserted.0 } else { at.0 };
        let after = match next {
            Some(edit) if i64::from(edit.span.start) == end => at.1 + edit.text.len() as i64,
            _ => at.1,
        };
        while new_ones.next_if(|t| i64::from(t.end()) < at.1).is_some() {}
        let found = new_ones.peek().is_some_and(|t| {
            let place = (i64::from(t.start), i64::from(t.end()));
            before <= place.0 && place.0 <= at.0 && at.1 <= place.1 && place.1 <= after
        });
        if !found {
            return false;
        }
    }
    true
}

/// The offsets of each `#` that opens a comment which nobody closes.
fn unclosed(document: &Document) -> Vec<u32> {
    let tokens = document.tokens.iter();
    let unclosed = tokens.filter(|t| t.kind() == TokenKind::UnterminatedComment);
    unclosed.map(|t| t.start).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnostics::Span;

    #[test]
    fn a_layout_keeps_the_tokens() {
        for (old, new, kept) in [
            ("2 9 1.0", "2 9 1", true),
            ("2 9 -0.0", "2 9 -0", true),
            ("2 9 -0", "2 9 0", false),
            ("2 9 0.1", "2 9 0.10000000000000001", true),
            ("2 9 0.1", "2 9 0.1000000000000001", false),
            ("2 <9>, 1;", "2 9 1", true),
            ("2 9 0,5", "2 9 0.5", true),
            ("2 9 0,5", "2 9 0.50000001", false),
            ("1,9999 2 0", "1 9999 2 0", true),
            ("01,9999 2 0", "1 9999 2 0", true),
            ("1 9999 2,0", "1 9999 2 0", true),
            ("2,9,\n1,9999\n2,0", "2,9,\n1,9999\n2 0", true),
            ("1,9999 2 0", "1 999 2 0", false),
            // Taken for two numbers, beside what is taken for none, and left as it is.
            ("4 12 0,5 7 1.2.3 1 2 3", "4 12 0,5 7 1.2.3 1 2 3", true),
            (
                "4 12 0,5 7 -4 -6 20 # 20 20 0 # a #\n0 # b #",
                "4 12 0,5 7 -4 -6 20 # 20 20 0 # a #\n\n0 # b #",
                true,
            ),
            ("1,9999 2 0", "1 9999 2", false),
            ("2 9 1 0 # a #", "2 9 1 # a #", true),
            ("2 9 1 0 # a #", "2 9 1 0 # a #", true),
            ("2 9 1 0", "2 9 1", false),
            ("2 9 1 -0 # a #", "2 9 1 # a #", false),
            ("2 9 1 # a #", "2 9 1 0 # a #", false),
            ("2 9 1 # a #", "2 9 1 # a  #", false),
            ("2 9 1 # a #", "2 9 1", false),
            ("2 9 1 # a\n3 9 1", "2 9 1 # a\n3 9 1", true),
            ("2 9 1 # a\n3 9 1", "2 9 1 # a 3 9 1", false),
            ("2 9 x", "2 9", false),
            ("2 9", "2 9 x", false),
            ("2 9 x y", "2 9 xy", false),
            ("2 9 \"a b\"", "2 9 \"a  b\"", false),
            ("2 9 1\n\n3 9 1", "2 9 1 3 9 1", true),
        ] {
            assert_eq!(
                by_layout((old, &parse(old).0), new),
                kept,
                "{old:?} {new:?}"
            );
        }
    }

    #[test]
    fn edits_leave_the_other_tokens() {
        for (old, edits, kept) in [
            ("2 9 0,5 7", &[(5, 6, ".")][..], true),
            ("2 9 1 x 3", &[(6, 8, "")], true),
            // Two tokens become one, or one two.
            ("2 9 1 3", &[(5, 6, "")], false),
            ("2 9 13", &[(5, 5, " ")], true),
            ("2 9 1,3", &[(5, 6, " ")], true),
            ("2 9 1 # a", &[(9, 9, " #")], true),
            ("2 9 1 # a\n3 9 1", &[(9, 9, " #")], true),
            // What was a record becomes a comment.
            ("2 9 1 # a\n3 9 1", &[(15, 15, " #")], false),
            ("2 9 1 3", &[(0, 0, "# ")], false),
            ("2 9 1 3 # a #", &[(0, 0, "# b # ")], true),
            ("2 9 1 3 # a #", &[(12, 13, "")], true),
            ("2 9 1 3 # a # 4 # b #", &[(12, 13, "")], false),
            ("2 201 1", &[(2, 2, "-")], true),
            ("2 201 1", &[(2, 5, "-201"), (6, 6, "0 ")], true),
        ] {
            let edit = |&(start, end, text): &(u32, u32, &str)| Edit {
                span: Span::new(start, end),
                text: text.to_owned(),
            };
            let edits: Vec<Edit> = edits.iter().map(edit).collect();
            let mut new = old.to_owned();
            for edit in edits.iter().rev() {
                new.replace_range(edit.span.range(), &edit.text);
            }
            let documents = (parse(old).0, parse(&new).0);
            let same = by_edits((old, &documents.0), &edits, (&new, &documents.1));
            assert_eq!(same, kept, "{old:?} {new:?}");
        }
    }
}
