//! IDs whose record is commented out on its line, while other records still need it.

use rustc_hash::{FxHashMap, FxHashSet};

use super::whole::{records, references};
use super::{Engine, judge, named};
use crate::analysis::Analysis;
use crate::diagnostics::{Applicability, Code, Diagnostic, Edit, Fix, Span, Value};
use crate::scene::names;
use crate::syntax::commented_out::comment_out;
use crate::syntax::hidden::{self, Line};
use crate::syntax::lexer::Token;
use crate::syntax::quote;
use crate::syntax::table::{Effect, RecordKind};
use crate::syntax::{Item, Record};

/// The note of a finding about an ID whose record is commented out.
const NOTE: &str = "switched-off";
/// The most IDs for which guesses are tried.
const MAX_TRIED: usize = 4;

/// Whether a finding says that the record of its ID stands in a comment.
pub(super) fn is_told(d: &Diagnostic) -> bool {
    d.notes.contains(&NOTE)
}

/// Whether a finding is about an ID that is undefined or of a wrong kind, and has no other explanation yet.
fn is_of_id(d: &Diagnostic) -> bool {
    let is_open = matches!(d.case, "" | "changed");
    matches!(d.code, Code::E101 | Code::E103) && is_open && named(d).is_some()
}

impl Engine<'_> {
    /// Adds to findings about an ID that its record is commented out. Proposes to switch the record on again, or to do
    /// without it.
    pub(super) fn switched_off(&mut self) {
        if !self.findings.iter().any(is_of_id) {
            return;
        }
        let off = Off::new(self.analysis);
        if off.lines.is_empty() {
            return;
        }
        let ids = self.findings.iter().filter(|d| is_of_id(d));
        let mut seen = FxHashSet::default();
        let ids: Vec<u32> = (ids.filter_map(named))
            .filter(|id| off.defined.contains_key(id) && seen.insert(*id))
            .collect();
        for (i, id) in ids.into_iter().enumerate() {
            let mut fixes = Vec::new();
            if i < MAX_TRIED {
                fixes = off.guesses(id);
                fixes.retain(|fix| {
                    let scene = self.attempt(Some(fix), &[]);
                    scene.is_some_and(|s| judge::errors(&s) < judge::errors(self.analysis))
                });
            }
            self.say_switched_off(id, off.line_of(id), fixes);
        }
    }

    fn say_switched_off(&mut self, id: u32, line: u32, fixes: Vec<Fix>) {
        let is_mended = !fixes.is_empty();
        let mut fixes = Some(fixes);
        for d in self.findings.iter_mut() {
            // If something else has the ID, only a guess that repairs an error shows that the commented record is
            // meant.
            let is_meant = d.code == Code::E101 || is_mended;
            if is_of_id(d) && named(d) == Some(id) && is_meant {
                d.notes.push(NOTE);
                d.values.push(("line", line.to_string().into()));
                if d.code == Code::E101 {
                    d.case = NOTE;
                }
                d.fixes = fixes.take().unwrap_or_default();
            }
        }
    }
}

/// The lines that are commented out.
struct Off<'a> {
    analysis: &'a Analysis,
    lines: Vec<Line>,
    /// For each ID, the index of the last commented line that defines it.
    defined: FxHashMap<u32, usize>,
}

impl<'a> Off<'a> {
    fn new(analysis: &'a Analysis) -> Off<'a> {
        let lines = hidden::lines(&analysis.source.text, &analysis.document);
        let mut defined = FxHashMap::default();
        // A property defines an ID only where nothing else does.
        let may_define = |e: &Effect| matches!(e, Effect::DefinesOrChanges(..));
        let defines = |e: &Effect| matches!(e, Effect::Defines(_));
        for is_such in [may_define, defines] {
            for (i, line) in lines.iter().enumerate() {
                let records = line.document.items.iter().filter_map(Item::record);
                let defining = records.filter(|r| is_such(&r.ty().effect));
                defined.extend(defining.map(|r| (r.id, i)));
            }
        }
        Off {
            analysis,
            lines,
            defined,
        }
    }

    fn line_of(&self, id: u32) -> u32 {
        let span = self.lines[self.defined[&id]].span;
        self.analysis.source.position(span.start).line
    }

    /// The commented record that would define an ID, with its line.
    fn record(&self, id: u32) -> Option<(&Line, &Record)> {
        let line = &self.lines[*self.defined.get(&id)?];
        let mut records = line.document.items.iter().filter_map(Item::record);
        Some((line, records.find(|r| r.id == id)?))
    }

    /// The proposals for an ID, all of them choices: the record may be wanted or not.
    fn guesses(&self, id: u32) -> Vec<Fix> {
        // If the comment lacks its end, its `#` may be any mark before the record, and the record is wanted.
        let line = &self.lines[self.defined[&id]];
        let is_closed = self.analysis.source.text[line.span.range()].ends_with('#');
        let operand = || self.operand(id).filter(|_| is_closed);
        let all = [Some(self.on(id)), operand().or_else(|| self.without(id))];
        let choice = |fix: Fix| Fix {
            applicability: Applicability::Choice,
            ..fix
        };
        all.into_iter().flatten().map(choice).collect()
    }

    /// The fix that switches on the record of an ID and all records that it needs.
    fn on(&self, id: u32) -> Fix {
        let entities = self.analysis.scene.entities.iter();
        let known: FxHashSet<u32> = entities.map(|e| e.id).collect();
        let mut of_id: FxHashMap<u32, Vec<usize>> = FxHashMap::default();
        for (i, line) in self.lines.iter().enumerate() {
            for record in line.document.items.iter().filter_map(Item::record) {
                of_id.entry(record.id).or_default().push(i);
            }
        }
        let mut wanted: FxHashSet<usize> = FxHashSet::default();
        let mut seen: FxHashSet<u32> = FxHashSet::from_iter([id]);
        let mut todo = vec![id];
        while let Some(id) = todo.pop() {
            // Of several lines that define the ID, the last one is meant. Lines behind it that change the ID go with
            // it.
            let last = self.defined.get(&id).copied();
            let own = of_id.get(&id).into_iter().flatten();
            let is_meant = |i: &&usize| Some(**i) >= last;
            for &i in own.filter(is_meant).filter(|_| last.is_some()) {
                wanted.insert(i);
                let document = &self.lines[i].document;
                let records = document.items.iter().filter_map(Item::record);
                let needed = records.flat_map(|r| names::references(document, r));
                todo.extend(needed.filter(|id| !known.contains(id) && seen.insert(*id)));
            }
        }
        let mut wanted: Vec<usize> = wanted.into_iter().collect();
        wanted.sort_unstable();
        let edits = wanted.iter().map(|&i| Edit {
            span: self.lines[i].span,
            text: self.lines[i].text.clone(),
        });
        Fix::guess("fix-switch-on", edits.collect())
            .with("id", id.to_string())
            .with("count", Value::Count(wanted.len() as u64))
    }

    /// The fix that writes the first operand of a commented operation wherever the operation is used or changed.
    fn operand(&self, id: u32) -> Option<Fix> {
        let (line, record) = self.record(id)?;
        let operations = [
            RecordKind::Union,
            RecordKind::Intersection,
            RecordKind::Difference,
        ];
        if !operations.contains(&record.kind) {
            return None;
        }
        let first = names::references(&line.document, record).next()?;
        let start = line.span.start;
        let edits = instead(self.analysis, id, first, start);
        let fix = Fix::guess("fix-first-operand", edits);
        Some(
            fix.with("id", id.to_string())
                .with("number", quote(&first.to_string())),
        )
    }

    /// The fix that comments out the only record with the ID, if that is a union or a difference that takes the ID
    /// away. The other operand stands for the union or difference.
    fn without(&self, id: u32) -> Option<Fix> {
        let analysis = self.analysis;
        let is_user = |r: &&Record| {
            r.id == id || references(analysis, r).any(|(_, named)| named == i64::from(id))
        };
        let mut users = records(analysis).filter(is_user);
        let (Some(user), None) = (users.next(), users.next()) else {
            return None;
        };
        let operands: Vec<(Token, i64)> = references(analysis, user).collect();
        let &[(_, a), (_, b)] = operands.as_slice() else {
            return None;
        };
        let other = match user.kind {
            RecordKind::Union if a == i64::from(id) => b,
            RecordKind::Union | RecordKind::Difference if b == i64::from(id) => a,
            _ => return None,
        };
        let other = u32::try_from(other).ok().filter(|&other| other != id)?;
        let span = analysis.document.span(user.first, user.last);
        let source = &analysis.source;
        let line = source.line_span(source.line_index(span.start));
        let written = source.text[line.range()].trim_end();
        if span.start != line.start || !written.starts_with(&source.text[span.range()]) {
            return None;
        }
        let whole = Span::new(line.start, line.start + written.len() as u32);
        let mut edits = vec![Edit {
            span: whole,
            text: comment_out(written),
        }];
        edits.extend(instead(analysis, user.id, other, whole.end));
        let fix = Fix::guess("fix-switch-off", edits).with("id", id.to_string());
        let fix = fix.with("type", Value::Term(user.ty().title));
        Some(
            fix.with("other", user.id.to_string())
                .with("number", quote(&other.to_string())),
        )
    }
}

/// The edits that write the ID `new` in place of `id` in all records from `start` on that name or change it. The render
/// record counts wherever it stands.
pub(super) fn instead(analysis: &Analysis, id: u32, new: u32, start: u32) -> Vec<Edit> {
    let mut edits = Vec::new();
    let mut write = |token: &Token| {
        edits.push(Edit {
            span: token.span(),
            text: new.to_string(),
        });
    };
    for record in records(analysis) {
        let head = analysis.document.id_token(record);
        if head.start < start && record.kind != RecordKind::Render {
            continue;
        }
        if record.id == id && !matches!(record.ty().effect, Effect::Defines(_)) {
            write(head);
        }
        let named = references(analysis, record).filter(|r| r.1 == i64::from(id));
        named.for_each(|(token, _)| write(&token));
    }
    edits
}
