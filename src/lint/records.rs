//! Queries that rules make of a file, following IDs from record to record.

use rustc_hash::{FxHashMap, FxHashSet};

use super::Context;
use crate::diagnostics::{Applicability, Fix, Span};
use crate::scene::Camera;
use crate::scene::names;
use crate::scene::record::Params;
use crate::syntax::lexer::{Token, TokenKind};
use crate::syntax::table::{Effect, Kind, RecordKind};
use crate::syntax::{Item, Record};

impl<'a> Context<'a> {
    /// The records that can be read, in file order.
    pub fn records(&self) -> impl Iterator<Item = &'a Record> {
        self.document.items.iter().filter_map(|item| match item {
            Item::Record(record) => Some(record),
            _ => None,
        })
    }

    /// Whether the file has text that could not be read. It may use, change or define anything.
    pub fn has_broken(&self) -> bool {
        self.document.contents.broken
    }

    pub fn record_params(&self, record: &Record) -> Params<'a> {
        Params::new(self.document, self.text, record)
    }

    /// The IDs that a record refers to, without those that are 0.
    pub fn references(&self, record: &'a Record) -> impl Iterator<Item = u32> + use<'a> {
        names::references(self.document, record)
    }

    /// The IDs of the records that meet a condition, and of all objects and properties that these are made of.
    pub fn with_parts(&self, is: impl Fn(&Record) -> bool) -> FxHashSet<u32> {
        let mut out = FxHashSet::default();
        let records: Vec<&Record> = self.records().collect();
        for record in records.into_iter().rev() {
            if out.contains(&record.id) || is(record) {
                out.insert(record.id);
                out.extend(self.references(record));
            }
        }
        out
    }

    /// A free ID, one above the largest of the file; `None` if the file has no IDs or the largest possible one.
    pub fn free_id(&self) -> Option<u32> {
        const LARGEST: u32 = i32::MAX as u32;
        let ids = self.document.items.iter().filter_map(|item| match item {
            Item::Record(r) => Some(r.id),
            Item::Broken(b) => b.id,
            Item::Void { .. } => None,
        });
        Some(ids.max()? + 1).filter(|&id| id <= LARGEST)
    }

    /// For each ID, the title of the record that defines it. Messages call the object by this title.
    pub fn titles(&self) -> FxHashMap<u32, &'static str> {
        let mut titles = FxHashMap::default();
        for record in self.records() {
            let placeholder = record.kind == RecordKind::Undefined;
            if !placeholder && !matches!(record.ty().effect, Effect::Changes(_)) {
                titles.entry(record.id).or_insert(record.ty().title);
            }
        }
        titles
    }

    /// A fix that puts lines behind a record. The line breaks of the lines become those of the text where the fix is
    /// applied.
    pub fn add_behind(
        &self,
        span: Span,
        title: &'static str,
        applicability: Applicability,
        lines: &[String],
    ) -> Fix {
        let tokens = &self.document.tokens;
        let next = tokens.partition_point(|t| t.start < span.end);
        // Comments behind the record on its line stay there, even if they have several lines.
        let rest = &tokens[next..];
        let comments = (rest.iter()).take_while(|t| t.kind().is_comment()).count();
        let (at, closes_line) = match rest.get(comments) {
            Some(t) if t.kind() == TokenKind::Newline => (t.start, true),
            Some(_) => (span.end, false),
            None => (self.text.trim_end().len() as u32, true),
        };
        let mut text: String = lines.iter().map(|l| format!("\n{l}")).collect();
        if !closes_line {
            text += "\n";
        }
        Fix::replace(title, applicability, Span::new(at, at), text)
    }

    /// A fix that removes a record, with its line if nothing else is on the line. A comment behind the record stays,
    /// behind a `0`. `None` if a comment is within the record.
    pub fn take_out(
        &self,
        record: &Record,
        title: &'static str,
        applicability: Applicability,
    ) -> Option<Fix> {
        let tokens = &self.document.tokens;
        let (first, last) = (record.first as usize, record.last as usize);
        if tokens[first..last].iter().any(|t| t.kind().is_comment()) {
            return None;
        }
        let ends_line = |t: Option<&Token>| t.is_none_or(|t| t.kind() == TokenKind::Newline);
        let before = first.checked_sub(1).map(|i| &tokens[i]);
        let behind = &tokens[last + 1..];
        let comments = (behind.iter())
            .take_while(|t| t.kind().is_comment())
            .count();
        let is_alone = ends_line(before) && ends_line(behind.get(comments));
        let own = Span::new(tokens[first].start, tokens[last].end());
        let line = before.map_or(0, |t| t.end());
        let (span, text) = match (before, behind.first()) {
            _ if is_alone && comments > 0 => (own, "0"),
            (_, Some(line_break)) if is_alone => (Span::new(line, line_break.end()), ""),
            (_, Some(next)) if ends_line(before) => (Span::new(own.start, next.start), ""),
            _ => (Span::new(line, own.end), ""),
        };
        Some(Fix::replace(title, applicability, span, text.to_owned()))
    }
}

/// The cameras that take the picture and are written in the file, each with the record that defines it.
pub(super) fn chosen_cameras<'c>(context: &'c Context) -> Vec<(&'c Camera, Params<'c>)> {
    let scene = context.scene;
    let mut chosen: Vec<usize> = scene.view.cameras().collect();
    // One camera may be both eyes.
    chosen.dedup();
    let of = |at: usize| {
        let camera = scene.cameras.get(at)?;
        let entity = (scene.entities.iter().rev())
            .find(|e| e.id == camera.id && e.kind == Some(Kind::Camera))?;
        Some((camera, context.params(entity.span)?))
    };
    chosen.into_iter().filter_map(of).collect()
}
