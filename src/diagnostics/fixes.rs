//! Applies fixes to a text.

use super::source::line_break;
use super::{Applicability, Diagnostic, Edit, Fix, Span};

impl Diagnostic {
    /// The fix to apply: the first safe one; or else, with `unsafe_too`, the first of all, unless it is a choice.
    /// `None` if no fix may be applied.
    pub fn applicable_fix(&self, unsafe_too: bool) -> Option<&Fix> {
        let safe = |f: &&Fix| f.applicability == Applicability::Safe;
        let safe_one = self.fixes.iter().find(safe);
        let guess = |f: &&Fix| unsafe_too && f.applicability != Applicability::Choice;
        safe_one.or(self.fixes.first().filter(guess))
    }
}

/// Applies as many of the fixes as go together. Returns the new text and the number of these fixes.
pub fn apply<'a>(text: &str, fixes: impl Iterator<Item = &'a Fix>) -> (String, usize) {
    let (edits, count) = edits(text, fixes);
    (edited(text, &edits), count)
}

/// The edits of as many of the fixes as go together, in the order of the text, and the number of these fixes. If two
/// fixes touch the same place, only the first counts; the other may be found again in the new text. Line breaks in a
/// fix become those of the text.
pub fn edits<'a>(text: &str, fixes: impl Iterator<Item = &'a Fix>) -> (Vec<Edit>, usize) {
    let mut chosen: Vec<&Edit> = Vec::new();
    let mut count = 0;
    // The spans of the chosen edits, in order. An edit that only touches one of them is refused, too: two insertions in
    // one place would have no certain order.
    let mut taken: Vec<(u32, u32)> = Vec::new();
    for fix in fixes {
        let valid = |e: &Edit| text.get(e.span.range()).is_some();
        let meets = |e: &Edit| {
            // `taken` is sorted and has no overlaps: only the one before and the one after can meet.
            let at = taken.partition_point(|t| t.0 < e.span.start);
            let near = at.saturating_sub(1)..(at + 1).min(taken.len());
            taken[near]
                .iter()
                .any(|t| e.span.start <= t.1 && t.0 <= e.span.end)
        };
        if !fix.edits.iter().all(valid) || fix.edits.iter().any(meets) || fix.edits.is_empty() {
            continue;
        }
        for edit in &fix.edits {
            let at = taken.partition_point(|t| t.0 < edit.span.start);
            taken.insert(at, (edit.span.start, edit.span.end));
        }
        chosen.extend(&fix.edits);
        count += 1;
    }
    chosen.sort_by_key(|e| e.span);
    let line_break = line_break(text);
    let mut behind = 0;
    let edit = |e: &Edit| {
        let start = match e.text.is_empty() {
            true => without_space_before(text, e.span).max(behind),
            false => e.span.start,
        };
        behind = e.span.end;
        Edit {
            span: Span::new(start, e.span.end),
            text: e.text.replace('\n', line_break),
        }
    };
    (chosen.into_iter().map(edit).collect(), count)
}

/// The start of a part of the text that is removed. If only white space is behind the part on its line, the white space
/// before it is removed, too.
fn without_space_before(text: &str, span: Span) -> u32 {
    let rest = text[span.end as usize..].trim_start_matches([' ', '\t']);
    let is_tail = rest.is_empty() || rest.starts_with(['\r', '\n']);
    let before = &text[..span.start as usize];
    let kept = before.trim_end_matches([' ', '\t']);
    // A part that has nothing but its indentation before it on its line keeps the indentation.
    match is_tail && span.start < span.end && !kept.is_empty() && !kept.ends_with(['\r', '\n']) {
        true => kept.len() as u32,
        false => span.start,
    }
}

/// Applies edits to a text. They are in order of their spans, which do not overlap.
pub fn edited(text: &str, edits: &[Edit]) -> String {
    let mut out = String::with_capacity(text.len());
    let mut at = 0;
    for edit in edits {
        out.push_str(&text[at..edit.span.start as usize]);
        out.push_str(&edit.text);
        at = edit.span.end as usize;
    }
    out.push_str(&text[at..]);
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    fn fix(edits: &[(u32, u32, &str)]) -> Fix {
        let edit = |&(start, end, text): &(u32, u32, &str)| Edit {
            span: Span::new(start, end),
            text: text.to_owned(),
        };
        Fix {
            title: "fix",
            values: Vec::new(),
            applicability: Applicability::Safe,
            edits: edits.iter().map(edit).collect(),
        }
    }

    #[test]
    fn fixes_that_meet_wait_for_the_next_round() {
        let fixes = [
            fix(&[(6, 7, "X"), (0, 1, "Y")]),
            fix(&[(0, 1, "Z"), (3, 4, "Z")]),
            fix(&[(3, 4, "W")]),
            fix(&[(4, 4, "!")]),
        ];
        let (text, count) = apply("abcdefgh", fixes.iter());
        assert_eq!((text.as_str(), count), ("YbcWefXh", 2));
    }

    #[test]
    fn what_is_out_of_range_is_left_out() {
        let fixes = [fix(&[(1, 3, "x")]), fix(&[(2, 9, "x")]), fix(&[])];
        // The first would cut a character in two.
        let (text, count) = apply("až", fixes.iter());
        assert_eq!((text.as_str(), count), ("ax", 1));
        let (text, count) = apply("ž", [fix(&[(1, 2, "x")])].iter());
        assert_eq!((text.as_str(), count), ("ž", 0));
    }

    #[test]
    fn no_space_is_left_at_the_end_of_a_line() {
        let cut = |text: &str, start, end| apply(text, [fix(&[(start, end, "")])].iter()).0;
        assert_eq!(cut("a b\r\nc", 2, 3), "a\r\nc");
        assert_eq!(cut("a \tb", 3, 4), "a");
        assert_eq!(cut("a b c", 2, 3), "a  c");
        assert_eq!(cut("a\n b\n", 3, 4), "a\n \n");
        let two = [fix(&[(0, 1, "x")]), fix(&[(2, 3, "")])];
        assert_eq!(apply("a b", two.iter()).0, "x");
    }

    #[test]
    fn line_breaks_are_those_of_the_text() {
        let (text, _) = apply("a b\r\nc", [fix(&[(1, 2, "\n")])].iter());
        assert_eq!(text, "a\r\nb\r\nc");
        let (text, _) = apply("a b\rc", [fix(&[(1, 2, "\n")])].iter());
        assert_eq!(text, "a\rb\rc");
    }
}
