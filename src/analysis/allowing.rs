//! Comments that allow findings, such as `# zpg: allow(W307) #`, and the places where they are written.
//!
//! A comment for a finding is written, in this order of preference,
//!
//! 1. into the comment of this kind that covers it already;
//! 2. at the end of its record's last line;
//! 3. straight behind the record, where a comment begins that goes on over several lines or never ends;
//! 4. alone on the line above the record, as `allow-next(…)` above the first one;
//! 5. at the head of the file, which covers all of it, where the finding is in no record.
//!
//! Each place is tried: the scene is read again, and must have fewer findings and no new one. Editors offer the same
//! comments for single findings.

use std::cell::{Cell, RefCell};
use std::collections::{BTreeMap, BTreeSet};

use rustc_hash::FxHashMap;

use super::Analysis;
use super::worse::{counts, has_new_errors};
use crate::diagnostics::source::line_break;
use crate::diagnostics::{Code, Diagnostic, Edit, SourceFile, Span, fixes};
use crate::syntax::Item;
use crate::syntax::directive::{Allow, is_directive};
use crate::syntax::lexer::{Token, TokenKind};

/// The kinds of places, the best first.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    Merged,
    EndOfLine,
    BehindRecord,
    LineAbove,
    Head,
}

const KINDS: [Kind; 5] = [
    Kind::Merged,
    Kind::EndOfLine,
    Kind::BehindRecord,
    Kind::LineAbove,
    Kind::Head,
];

/// The most times that a scene is read again to find out which of many comments does harm.
const TRIALS: usize = 64;

/// The most bytes that are read again for the fixes that are offered at one place.
pub const TRIED_BYTES: usize = 1_000_000;

/// The place of a comment or of a part of it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum CommentSlot {
    /// A place in the list of an existing comment, as its first entry or behind others.
    List { at: u32, first: bool },
    /// A comment behind the text on the line.
    Line(u32),
    /// A comment on a line of its own.
    Own(u32),
    /// A comment on the line above the first record, about that record alone.
    AboveFirst(u32),
}

impl CommentSlot {
    fn edit(self, codes: &BTreeSet<Code>, text: &str) -> Edit {
        let codes: Vec<&str> = codes.iter().map(|c| c.as_str()).collect();
        let codes = codes.join(", ");
        let (at, text) = match self {
            CommentSlot::List { at, first: true } => (at, codes),
            CommentSlot::List { at, first: false } => (at, format!(", {codes}")),
            CommentSlot::Line(at) => {
                // The formatter puts two spaces before the first comment, and one between comments.
                let space = match text[..at as usize].ends_with('#') {
                    true => " ",
                    false => "  ",
                };
                (at, format!("{space}# zpg: allow({codes}) #"))
            }
            CommentSlot::Own(at) => (at, format!("# zpg: allow({codes}) #{}", line_break(text))),
            CommentSlot::AboveFirst(at) => {
                let end = line_break(text);
                (at, format!("# zpg: allow-next({codes}) #{end}"))
            }
        };
        Edit {
            span: Span::new(at, at),
            text,
        }
    }
}

/// A scene whose comments allow all findings that can be allowed.
pub struct Allowed {
    pub analysis: Analysis,
    /// How many findings the comments have taken away.
    pub count: usize,
}

/// Writes comments that allow all findings, as far as possible. `again` reads the scene with another text.
pub fn all(mut analysis: Analysis, again: impl Fn(SourceFile) -> Analysis) -> Allowed {
    let total = analysis.findings().len();
    let mut trials = TRIALS;
    for kind in KINDS {
        let edits = Finder::new(&analysis).edits(kind);
        if edits.is_empty() {
            continue;
        }
        if let Some(better) = attempt(&analysis, &edits, &again) {
            analysis = better;
            continue;
        }
        // Edits from the end come first, so that the places before them stay as they are.
        for edit in edits.iter().rev() {
            if trials == 0 || edits.len() == 1 {
                break;
            }
            trials -= 1;
            let one = std::slice::from_ref(edit);
            if let Some(better) = attempt(&analysis, one, &again) {
                analysis = better;
            }
        }
    }
    let count = total.saturating_sub(analysis.findings().len());
    Allowed { analysis, count }
}

/// The scene after some edits, if it has fewer findings and no new one; else `None`.
fn attempt(
    analysis: &Analysis,
    edits: &[Edit],
    again: impl Fn(SourceFile) -> Analysis,
) -> Option<Analysis> {
    let text = fixes::edited(&analysis.source.text, edits);
    let after = again(analysis.source.with_text(text));
    let is_better = after.findings().len() < analysis.findings().len() && no_harm(analysis, &after);
    is_better.then_some(after)
}

/// Whether a scene has no new findings after an edit, and is the same but for comments.
fn no_harm(analysis: &Analysis, after: &Analysis) -> bool {
    let [old, new] = [analysis, after].map(|a| counts(a.findings().iter()));
    let is_new = |(code, count): (&Code, &usize)| old.get(code).is_none_or(|old| count > old);
    after.is_scene()
        && !new.iter().any(is_new)
        && !has_new_errors(analysis, after)
        && says_the_same(analysis, after)
}

/// Whether an edit takes a finding away, and does no harm.
fn is_silenced(analysis: &Analysis, finding: &Diagnostic, edit: &Edit) -> bool {
    let text = fixes::edited(&analysis.source.text, std::slice::from_ref(edit));
    let after = Analysis::of(analysis.source.with_text(text));
    let after = after.with_settings(analysis.settings.clone());
    let mut at = finding.span.start;
    if edit.span.start <= at {
        at += edit.text.len() as u32;
    }
    let is_it = |d: &Diagnostic| d.code == finding.code && d.span.start == at;
    !after.findings().iter().any(is_it) && no_harm(analysis, &after)
}

/// Whether two scenes are the same but for comments.
fn says_the_same(a: &Analysis, b: &Analysis) -> bool {
    fn tokens(analysis: &Analysis) -> impl Iterator<Item = &str> {
        let counts = |t: &&Token| !t.kind().is_comment() && t.kind() != TokenKind::Newline;
        let all = analysis.document.tokens.iter().filter(counts);
        all.map(|t| t.text(&analysis.source.text))
    }
    tokens(a).eq(tokens(b))
}

/// Finds places for comments in a scene.
pub struct Finder<'a> {
    analysis: &'a Analysis,
    /// Indices of the items that are not void.
    records: Vec<u32>,
    /// Indices of the comments that allow something.
    directives: Vec<u32>,
    /// The results of `end_of_line` by line, kept because a file may be a single line with many records.
    ends: RefCell<FxHashMap<usize, Option<u32>>>,
    /// How many more bytes may be read to find out what a comment does.
    left: Cell<usize>,
}

impl<'a> Finder<'a> {
    pub fn new(analysis: &'a Analysis) -> Finder<'a> {
        let document = &analysis.document;
        let is_record = |item: &Item| !matches!(item, Item::Void { .. });
        let items = (0..).zip(&document.items);
        // A comment that is never closed allows nothing.
        let text = &analysis.source.text;
        let is_one = |t: &Token| t.kind() == TokenKind::Comment && is_directive(t, text);
        let tokens = (0..).zip(&document.tokens);
        Finder {
            analysis,
            records: items
                .filter(|(_, i)| is_record(i))
                .map(|(n, _)| n)
                .collect(),
            directives: tokens.filter(|(_, t)| is_one(t)).map(|(n, _)| n).collect(),
            ends: RefCell::default(),
            left: Cell::new(TRIED_BYTES),
        }
    }

    /// The edit that writes a comment which allows a finding. `None` for errors of the language, and if no comment
    /// takes the finding away.
    ///
    /// In a scene with errors the edit is tried, as long as that is quick: there, a comment may change how others are
    /// read.
    pub fn edit(&self, finding: &Diagnostic) -> Option<Edit> {
        let analysis = self.analysis;
        let text = &analysis.source.text;
        let codes = BTreeSet::from([finding.code]);
        let places = KINDS.iter().filter_map(|&kind| self.place(finding, kind));
        let mut edits = places.map(|place| place.edit(&codes, text));
        if analysis.errors.is_empty() {
            return edits.next();
        }
        edits.find(|edit| match self.left.get().checked_sub(text.len()) {
            Some(left) => {
                self.left.set(left);
                is_silenced(analysis, finding, edit)
            }
            None => true,
        })
    }

    /// The edits that allow all findings at places of a kind.
    fn edits(&self, kind: Kind) -> Vec<Edit> {
        let mut all: BTreeMap<CommentSlot, BTreeSet<Code>> = BTreeMap::new();
        for finding in self.analysis.findings() {
            if let Some(place) = self.place(finding, kind) {
                all.entry(place).or_default().insert(finding.code);
            }
        }
        let text = &self.analysis.source.text;
        let mut edits: Vec<Edit> = all
            .iter()
            .map(|(place, codes)| place.edit(codes, text))
            .collect();
        edits.sort_by_key(|edit| edit.span.start);
        edits
    }

    fn place(&self, finding: &Diagnostic, kind: Kind) -> Option<CommentSlot> {
        if finding.code.is_never_allowed() {
            return None;
        }
        let at = finding.span.start;
        if finding.code == Code::S504 {
            // The finding is about a comment that allows findings. Only that comment can allow it, and nothing allows
            // faults in its list.
            if !finding.case.is_empty() {
                return None;
            }
            let is_it = |&&i: &&u32| self.token(i).start == at;
            let own = self
                .directives
                .iter()
                .find(is_it)
                .filter(|_| kind == Kind::Merged)?;
            return self.list(*own, finding.code);
        }
        let Some(record) = self.record_at(at) else {
            return self.of_file(finding.code, kind);
        };
        match kind {
            Kind::Merged => self.merged(record, finding.code),
            Kind::EndOfLine => self.end_of_line(record).map(CommentSlot::Line),
            Kind::BehindRecord => Some(CommentSlot::Line(self.span(record).end)),
            Kind::LineAbove => self.line_above(record),
            Kind::Head => self.of_file(finding.code, kind),
        }
    }

    fn token(&self, i: u32) -> &'a Token {
        &self.analysis.document.tokens[i as usize]
    }

    /// The span of a record, which is given by its index in `records`.
    fn span(&self, record: usize) -> Span {
        let document = &self.analysis.document;
        document.item_span(&document.items[self.records[record] as usize])
    }

    fn line(&self, at: u32) -> usize {
        self.analysis.source.line_index(at)
    }

    /// The index of the record that contains a place, or that shares its line.
    fn record_at(&self, at: u32) -> Option<usize> {
        let next = self.records.partition_point(|&i| {
            let document = &self.analysis.document;
            document.item_span(&document.items[i as usize]).end <= at
        });
        if next < self.records.len() {
            let span = self.span(next);
            // A place before the record on the record's line counts, too.
            if span.start <= at || self.line(span.start) == self.line(at) {
                return Some(next);
            }
        }
        let before = next.checked_sub(1)?;
        let end = self.span(before).end.saturating_sub(1);
        (self.line(end) == self.line(at)).then_some(before)
    }

    /// The lines from where a record begins to where it ends.
    fn lines(&self, record: usize) -> std::ops::RangeInclusive<usize> {
        let span = self.span(record);
        self.line(span.start)..=self.line(span.end.saturating_sub(1))
    }

    /// The slot in a comment that is on the lines of a record, or alone on the line above it.
    fn merged(&self, record: usize, code: Code) -> Option<CommentSlot> {
        let lines = self.lines(record);
        let line = |i: u32| self.line(self.token(i).start);
        let first = self
            .directives
            .partition_point(|&i| line(i) < *lines.start());
        let on_lines = self.directives[first..]
            .iter()
            .take_while(|&&i| line(i) <= *lines.end());
        let mut on_lines = on_lines.copied().filter(|&i| !self.is_about_next(i));
        let on_lines = on_lines.find_map(|i| self.list(i, code));
        let above = || {
            let above = *self.directives[..first].last()?;
            let is_of_record = !self.is_at_head(above) || self.is_about_next(above);
            let is_next = line(above) + 1 == *lines.start() && is_of_record;
            let is_alone = is_next && self.record_at(self.token(above).start).is_none();
            self.list(above, code).filter(|_| is_alone)
        };
        on_lines.or_else(above)
    }

    /// Whether no record begins before a comment.
    fn is_at_head(&self, directive: u32) -> bool {
        self.records.is_empty() || self.token(directive).start < self.span(0).start
    }

    /// Whether a comment is `allow-next`, which is about the record below it, wherever it stands.
    fn is_about_next(&self, directive: u32) -> bool {
        let allow = Allow::read(self.token(directive), &self.analysis.source.text);
        allow.is_some_and(|allow| allow.is_about_next)
    }

    /// The slot behind the last entry between the brackets of a comment; `None` if the code is there already.
    fn list(&self, directive: u32, code: Code) -> Option<CommentSlot> {
        let token = self.token(directive);
        let Allow { list, entries, .. } = Allow::read(token, &self.analysis.source.text)?;
        let has = |entry: &&str| entry.eq_ignore_ascii_case(code.as_str());
        if entries.iter().any(has) {
            return None;
        }
        Some(CommentSlot::List {
            at: list.end,
            first: entries.iter().all(|entry| entry.is_empty()),
        })
    }

    /// The offset behind all text on a record's last line, which is the same for all records that end on it.
    fn end_of_line(&self, record: usize) -> Option<u32> {
        let line = *self.lines(record).end();
        if let Some(&known) = self.ends.borrow().get(&line) {
            return known;
        }
        let end = self.find_end_of_line(record);
        self.ends.borrow_mut().insert(line, end);
        end
    }

    fn find_end_of_line(&self, record: usize) -> Option<u32> {
        let document = &self.analysis.document;
        let (_, last) = document.items[self.records[record] as usize].ends();
        let mut end = self.span(record).end;
        let on_line = document.tokens[last as usize + 1..].iter();
        for token in on_line.take_while(|t| t.kind() != TokenKind::Newline) {
            // A comment over several lines ends on another line.
            let ends_here = self.line(token.end()) == self.line(end);
            if token.kind() == TokenKind::UnterminatedComment || !ends_here {
                return None;
            }
            end = token.end();
        }
        Some(end)
    }

    /// The slot above the line that a record begins on, if nothing stands before the record there.
    fn line_above(&self, record: usize) -> Option<CommentSlot> {
        let source = &self.analysis.source;
        let start = self.span(record).start;
        let line = source.line_span(self.line(start)).start;
        let before = &source.text[line as usize..start as usize];
        let place = match record {
            0 => CommentSlot::AboveFirst(line),
            _ => CommentSlot::Own(line),
        };
        before.trim().is_empty().then_some(place)
    }

    /// The slot at the head of the file for a comment that allows `code` in the whole file: in the comment that is
    /// there for [`Kind::Merged`], in a new one for [`Kind::Head`].
    fn of_file(&self, code: Code, kind: Kind) -> Option<CommentSlot> {
        let of_file = |i: &u32| !self.is_about_next(*i);
        let first = self.directives.iter().copied().find(of_file);
        let head =
            first.filter(|&i| self.is_at_head(i) && self.record_at(self.token(i).start).is_none());
        match (kind, head) {
            (Kind::Merged, Some(head)) => self.list(head, code),
            (Kind::Head, _) => {
                let mark = self.analysis.source.text.starts_with('\u{feff}');
                Some(CommentSlot::Own(u32::from(mark) * 3))
            }
            _ => None,
        }
    }
}
