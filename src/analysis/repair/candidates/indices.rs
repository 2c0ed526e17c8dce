//! Refractive indices among the parts of light: they have the type of the parts, or stand behind them.

use super::{Candidate, Habit, LineContext};
use crate::analysis::repair::whole::records;
use crate::diagnostics::{Applicability, Code, Diagnostic, Edit, Fix, Span, Value};
use crate::lint::spelling::decimal;
use crate::syntax::ast::Record;
use crate::syntax::lexer::Token;
use crate::syntax::quote;
use crate::syntax::table::{Kind, RecordKind, RecordType};

/// How many numbers a refractive index has, one for each channel.
const CHANNELS: usize = 3;

/// The limit below which the refractive indices of transparent materials are; that of diamond is 2.42.
const INDEX_MAX: f64 = 3.0;

impl LineContext<'_> {
    /// Whether all of some numbers may be refractive indices of transparent materials.
    fn are_indices(&self, numbers: &[Token]) -> bool {
        let is_index = |t: &Token| {
            t.number(self.text)
                .is_some_and(|x| (1.0..INDEX_MAX).contains(&x))
        };
        numbers.iter().all(is_index)
    }

    /// The other records with the ID of this one that give it optics. An assignment would take those optics back.
    fn optics(&self) -> impl Iterator<Item = &Record> {
        let id = self.id();
        let is_other = move |r: &&Record| {
            let head = self.analysis.document.id_token(r).span();
            Some(r.id) == id && r.ty().gives_optics() && !head.touches(self.tokens[0].span())
        };
        records(self.analysis).filter(is_other)
    }

    /// The first other record with the ID of this one that is a refractive index.
    pub(super) fn own_index(&self) -> Option<&Record> {
        self.optics()
            .find(|r| r.kind == RecordKind::RefractiveIndex)
    }

    /// Whether the three parts of light of the record are rather a refractive index.
    pub(super) fn is_index(&self) -> bool {
        let is_optics = self.ty().is_some_and(|ty| ty.kind == RecordKind::Optics);
        is_optics && self.params().len() == CHANNELS && self.are_indices(self.params())
    }

    /// Guesses that optics whose numbers are a refractive index should have that type. If the ID has a refractive index
    /// already, that one has the parts of light, and the two types change places.
    pub(super) fn index(&self, finding: &Diagnostic) -> Option<Candidate> {
        if finding.code != Code::E206 || !self.is_index() {
            return None;
        }
        let [optics, index] = [RecordKind::Optics, RecordKind::RefractiveIndex].map(RecordType::of);
        let mut candidate = self.write_type(Habit::Type, index);
        let Some(other) = self.own_index() else {
            // Without other optics of the object, the numbers may be something else.
            if self.optics().next().is_none() {
                candidate.fix.applicability = Applicability::Choice;
            }
            return Some(candidate);
        };
        let document = &self.analysis.document;
        let values = document.values(other);
        let are_parts = values.iter().all(|x| (0.0..=1.0).contains(x));
        let ty = document.significant(other.first, other.last).nth(1)?;
        candidate.fix.title = "fix-types";
        candidate.fix.edits.push(Edit {
            span: ty.span(),
            text: optics.code.to_string(),
        });
        candidate.fix.edits.sort_by_key(|e| e.span.start);
        are_parts.then_some(candidate)
    }

    /// Guesses that the transmitted part is a refractive index, which gets a record of its own; `kt` takes its place.
    /// `None` if the ID has an index already.
    pub(super) fn index_for_part(&self, kt: f64) -> Option<Candidate> {
        let (last, id) = (self.params().last()?, self.id()?);
        if self.own_index().is_some() {
            return None;
        }
        let index = RecordType::of(RecordKind::RefractiveIndex);
        let numbers = [last.text(self.text); CHANNELS].join(" ");
        let text = format!("{}\n{id} {} {numbers}", decimal(kt), index.code);
        let fix = Fix::replace("fix-apart", Applicability::Choice, last.span(), text);
        Some(Candidate::new(
            Habit::Proposed,
            fix.with("type", Value::Term(index.title))
                .with("text", quote(&numbers)),
        ))
    }

    /// Guesses at a colour with the numbers of another one in place of its ID: `2 -701 20`, `2 -299 20`. An assignment
    /// of that colour would take back the optics of the object.
    pub(super) fn colour_of_glass(&self) -> Option<Candidate> {
        let ty = self.ty()?;
        let [property] = self.params() else {
            return None;
        };
        let has_optics = || self.optics().next().is_some();
        let is_one = matches!(ty.kind, RecordKind::Colour | RecordKind::Assignment);
        let named = property.integer(self.text).filter(|&id| id > 1)?;
        if !is_one || !has_optics() || self.kind_of(named) != Some(Kind::Colour) {
            return None;
        }
        let document = &self.analysis.document;
        let is_colour = |r: &&Record| i64::from(r.id) == named && r.kind == RecordKind::Colour;
        let given = records(self.analysis).filter(is_colour).last()?;
        let numbers: Vec<&str> = document.params(given).map(|t| t.text(self.text)).collect();
        let colour = RecordType::of(RecordKind::Colour);
        let text = format!("{} {}", colour.code, numbers.join(" "));
        let span = self.tokens[1].span().to(property.span());
        Some(Candidate::writing(Habit::Sibling, span, text))
    }

    /// Guesses at a refractive index behind the parts of light, once or for each channel. It gets a record of its own,
    /// if the ID has no index yet.
    pub(super) fn index_behind(&self, finding: &Diagnostic) -> Option<Candidate> {
        let ty = self.ty().filter(|_| finding.code == Code::E009)?;
        if !matches!(ty.kind, RecordKind::Optics | RecordKind::OpticsRgb) {
            return None;
        }
        let (own, rest) = self.params().split_at_checked(ty.params.len())?;
        let (last, first) = (own.last()?, rest.first()?);
        let is_one = matches!(rest.len(), 1 | CHANNELS) && self.are_indices(rest);
        let is_part = |t: &Token| {
            t.number(self.text)
                .is_some_and(|x| (0.0..=1.0).contains(&x))
        };
        if !is_one || !own.iter().all(is_part) || self.own_index().is_some() {
            return None;
        }
        let index = RecordType::of(RecordKind::RefractiveIndex);
        let numbers = match rest {
            [one] => [one.text(self.text); CHANNELS].join(" "),
            all => self.spaced(all)?,
        };
        let between = Span::new(last.end(), first.start);
        let start = if self.is_gap(between) {
            between.start
        } else {
            first.start
        };
        let span = Span::new(start, rest[rest.len() - 1].end());
        let id = self.id()?;
        let text = format!("\n{id} {} {numbers}", index.code);
        let fix = Fix::replace("fix-apart", Applicability::Unsafe, span, text);
        Some(Candidate::new(
            Habit::Apart,
            fix.with("type", Value::Term(index.title))
                .with("text", quote(&numbers)),
        ))
    }
}
