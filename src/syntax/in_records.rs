//! Whether the numbers of a text are in records. That tells a scene from a table, a list or a mesh, whose lines begin
//! with numbers, too.

use super::ast::{Document, Fault, Item};
use super::lexer::{Token, TokenKind};
use super::scene_lines::SceneLines;
use super::table::{RecordKind, RecordType};
use crate::diagnostics::{Code, Diagnostic, Value};

/// A text with fewer numbers may be a scene that was just begun.
const BEGUN: usize = 12;

/// Reports a text that is no scene because too few of its numbers are in records; `None` for a scene. Half of the
/// numbers must be in records, or a fifth if some lines begin as only those of scenes do. A `0` that introduces a
/// comment does not count.
///
/// Records with a number more or less, and records that do not fill their lines, count only in a text with fewer than
/// twelve numbers or with lines of a scene. A table of integers has many of both: its rows differ from records by a
/// number, and some records can be read from the middle of a row on.
pub fn by_records(text: &str, document: &Document) -> Option<Diagnostic> {
    if !document.contents.broken && document.items.iter().any(|i| i.record().is_some()) {
        return None;
    }
    let tokens = &document.tokens;
    let (mut all, mut right, mut slips) = (0, 0, 0);
    let mut wrong = None;
    for item in &document.items {
        let (first, last) = item.ends();
        // `complete` is the type of an item that has as many numbers as its type takes.
        let (count, complete) = match item {
            Item::Record(r) => (2 + r.params as usize, Some(r.ty())),
            Item::Void { .. } => {
                let mut behind = tokens[last as usize + 1..].iter();
                let next = behind.find(|t| t.kind() != TokenKind::Newline);
                all += usize::from(!next.is_some_and(|t| t.kind().is_comment()));
                continue;
            }
            Item::Broken(b) => {
                let inside = document.significant(first, last);
                let count = inside.filter(|t| t.kind().is_numeric()).count();
                if !b.is_slip {
                    all += count;
                    if count > 0 {
                        wrong.get_or_insert(document.item_span(item));
                    }
                    continue;
                }
                let is_complete = b.fault == Fault::Form && b.id.is_some();
                (count, b.ty().filter(|_| is_complete))
            }
        };
        all += count;
        let is_right = |ty: &RecordType| {
            ty.kind != RecordKind::Undefined && is_in_lines(tokens, (first, last), ty)
        };
        match complete.is_some_and(is_right) {
            true => right += count,
            false => slips += count,
        }
    }
    let headed = SceneLines::of(text, tokens).headed();
    if headed.is_some() || all < BEGUN && right + slips == all {
        right = (right + slips).max(headed.unwrap_or_default());
    }
    let least = all.div_ceil(if headed.is_some() { 5 } else { 2 });
    let finding = || {
        let first = document.items.first().map(|item| document.item_span(item));
        Diagnostic::new(Code::E014, wrong.or(first).unwrap_or_default())
            .case("numbers")
            .with("numbers", right.to_string())
            .with("all", Value::Count(all as u64))
    };
    (right < least).then(finding)
}

/// Whether a record is on one line, or takes up whole lines as people lay them out: its parameters begin on a line of
/// their own, or its first line has as many parameters as the next one. The rows of a table differ: the first one has
/// as many numbers as the others only with the ID and the type.
fn is_in_lines(tokens: &[Token], (first, last): (u32, u32), ty: &RecordType) -> bool {
    let (first, last) = (first as usize, last as usize);
    let mut lines = tokens[first..=last]
        .split(|t| t.kind() == TokenKind::Newline)
        .map(|line| line.iter().filter(|t| !t.kind().is_trivia()).count())
        .filter(|&count| count > 0);
    let own = lines.next().unwrap_or_default();
    let Some(next) = lines.next() else {
        return true;
    };
    let ends = |token: Option<&Token>| token.is_none_or(|t| t.kind() == TokenKind::Newline);
    let counts = |t: &&Token| t.kind() == TokenKind::Newline || !t.kind().is_trivia();
    let before = tokens[..first].iter().rev().find(counts);
    let behind = tokens[last + 1..].iter().find(counts);
    let head = 2 + usize::from(ty.is_counted());
    ends(before) && ends(behind) && (own <= head || own - head == next)
}

#[cfg(test)]
mod tests {
    use super::super::parse;
    use super::*;

    fn is_scene(text: &str) -> bool {
        by_records(text, &parse(text).0).is_none()
    }

    #[test]
    fn tables_lists_and_meshes_are_no_scenes() {
        for text in [
            "OFF\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n3 0 1 3\n3 0 2 3\n3 1 2 3\n",
            "4 1 0 0\n3 0 1 2\n3 0 1 3\n4 0 1 2 3\n0 0 1\n0 1 0\n",
            "1,2,3\n4,5,6\n7,8,9\n10,11,12\n13,14,15\n",
            "# Title\n\n1. one\n2. two\n",
            "1. one\n2. two\n3. three\n",
            "1 box of nails 5\n2 light bulbs 40 60\n3 cut boards 200 30 20\n4 plane tickets 99 99 120\n",
            "1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n",
            "0 0 0\n0 0 0\n",
        ] {
            assert!(!is_scene(text), "{text:?}");
        }
    }

    #[test]
    fn line_breaks_make_no_difference() {
        for text in [
            // A lathe with a point a line, a matrix in rows, a camera over lines; each with a slip behind it.
            "2 1 4\n0 2\n1 1\n1 0\n0 0\n3 9 x\n",
            "2 9 1\n2 -4\n0 -1 0 0\n1 0 0 0\n0 0 1 0\n0 0 0 1\n3 9\n1 9999 2 0\n",
            "9 -501\n0 0 9\n0 0 -1\n0 1 0\n45\n2 9 1 1\n1 9999 2 0\n",
            "2 11 0 0 0 1 3 9 1 4 -101 2 3 1 9999 4 0 x",
            "2\n9\n1\n1\n9999\n2\n0\n3\n",
        ] {
            assert!(is_scene(text), "{text:?}");
        }
    }

    #[test]
    fn a_scene_with_mistakes_is_one() {
        for text in [
            "",
            "# a comment #",
            "0 # a title #\n",
            // The first record is under way.
            "2",
            "0 # a title #\n2",
            "2 11 0 0\n",
            "2 9 0,5\n",
            "2 sphere 0 0 0 1\n",
            "2 11 0 0 0 1\n3 11 0 0 0\n4 11 0 0 0 x\n",
            "2 9 1\n10 77 1 0 2\n11 77 1 0 2\n12 77 1 0 2\n1 9999 2 0\n",
            "2 9\n3 9\n4 9\n5 9\n6 101 2 3\n1 9999 6 0\n",
            "2 sphere <0,1,0>, 1\n3 plane 0 1 0 0\n4 union 2 3\n5 light 1\n9 camera 0 1 5 0 0 -1 0 1 0 45\n\
             1 render 4 0\n",
            "2 koule 0 1 0 1\n3 rovina 0 1 0 0\n4 sjednocení 2 3\n5 bodové světlo 1\n5 posunutí 1 2 3\n",
        ] {
            assert!(is_scene(text), "{text:?}");
        }
    }
}
