//! A token that is several numbers, since the spaces between them are lost: `-12.5 1 0` is `-1 2.5 1 0`.

use super::cylinders::CYLINDERS;
use super::sizes::BOX;
use super::{Candidate, Habit, LineContext};
use crate::diagnostics::{Applicability, Code, Diagnostic};
use crate::syntax::Item;
use crate::syntax::allows;
use crate::syntax::lexer::Token;
use crate::syntax::quote;
use crate::syntax::table::{Family, Param, ParamKind, RecordKind, RecordType};

/// The most numbers that one token is split into.
const MAX_PARTS: usize = 3;

/// The most bytes of a token that is split.
const MAX_BYTES: usize = 24;

impl LineContext<'_> {
    /// Guesses that a type or a reference and the numbers behind it are one token. Split, the record has as many
    /// numbers as it takes, and its references name entities of the right kinds.
    pub(super) fn lost_spaces(&self, out: &mut Vec<Candidate>) {
        if self.ty().is_some_and(|ty| self.fits(ty)) {
            return;
        }
        let Some(token) = self.tokens.get(1).filter(|_| self.id().is_some()) else {
            return;
        };
        let rest: Vec<&str> = self.params().iter().map(|t| t.text(self.text)).collect();
        // A number before a type is an ID, which is not split.
        let (behind, params) = self.params().split_first().unzip();
        let behind = behind.and_then(|t| RecordType::by_code(t.integer(self.text)?));
        let is_id = behind.filter(|ty| ty.family != Family::Void).zip(params);
        let is_id = is_id.is_some_and(|(ty, params)| self.fit(ty, params));
        let glued = match self.ty().is_none() && !is_id {
            true => split_glued(token.text(self.text)),
            false => Vec::new(),
        };
        for parts in glued {
            let code = parts[0].parse().ok();
            // Only one parameter is split off a positive number, which may well be a parameter itself.
            let is_type = |ty: &&RecordType| ty.code < 0 || parts.len() == 2;
            if let Some(ty) = code.and_then(RecordType::by_code).filter(is_type)
                && self.is_record(ty, &[&parts[1..], &rest].concat())
            {
                let mut apart = self.glued_apart(token, &parts);
                if parts.len() == 2 && self.is_type_beside(ty) {
                    apart
                        .iter_mut()
                        .for_each(|c| c.habit = Habit::GluedAsBeside);
                }
                out.extend(apart);
            }
        }
        out.extend(self.profile_without_space(token, &rest));
        let Some(ty) = self.ty() else { return };
        for (i, token) in self.params().iter().enumerate() {
            let is_reference = |p: &Param| matches!(p.kind, ParamKind::Reference { .. });
            let is_double_zero = token.text(self.text).starts_with("00.");
            if !(is_double_zero || ty.param(i, 0).is_some_and(is_reference)) {
                continue;
            }
            for parts in (split_glued(token.text(self.text)).into_iter())
                .chain(dashed(token.text(self.text)))
            {
                let params = [&rest[..i], &parts, &rest[i + 1..]].concat();
                if self.is_record(ty, &params) {
                    out.extend(self.glued_apart(token, &parts));
                }
            }
        }
    }

    /// A guess that the type of a profile and its number of points are one token, which is a type itself: `12` for `1 2`.
    /// `None` unless a comment names a cylinder, or a record beside this one is a profile.
    fn profile_without_space(&self, token: &Token, rest: &[&str]) -> Option<Candidate> {
        let (code, count) = token.text(self.text).split_at_checked(1)?;
        let ty = RecordType::by_code(code.parse().ok()?).filter(|ty| ty.is_counted())?;
        let is_meant =
            self.is_called(&CYLINDERS) || self.is_type_beside(ty) && !self.is_called(&BOX);
        let points: usize = count.parse().ok()?;
        let numbers: Vec<f64> = rest.iter().flat_map(|text| text.parse()).collect();
        let mut radii = numbers.iter().step_by(2).take(points);
        let is_profile = (2..=rest.len()).contains(&points)
            && ty.arity(points as u64) == rest.len() as u64 + 1
            && numbers.len() == rest.len()
            && radii.all(|&r| r >= 0.0);
        (self.ty().is_some() && is_meant && is_profile)
            .then(|| self.glued_apart(token, &[code, count]))
            .flatten()
            .map(|candidate| Candidate {
                habit: Habit::GluedAsBeside,
                ..candidate
            })
    }

    /// Whether the record above or the one below is of this type.
    fn is_type_beside(&self, ty: &RecordType) -> bool {
        let document = &self.analysis.document;
        let at = (document.items)
            .partition_point(|item| document.item_span(item).start < self.line.start);
        let above = document.items[..at].iter().rev().find_map(Item::record);
        let below = document.items[at..].iter().skip(1).find_map(Item::record);
        [above, below]
            .into_iter()
            .flatten()
            .any(|r| r.kind == ty.kind)
    }

    /// Guesses at a record with too few numbers: one of them is two digits, or stands for two equal numbers.
    pub(super) fn one_too_few(&self, finding: &Diagnostic, out: &mut Vec<Candidate>) {
        if finding.code != Code::E008 {
            return;
        }
        if out.iter().all(|c| c.habit == Habit::Lost) && self.is_only_one(finding) {
            out.extend(self.two_digits());
        }
        self.both_ways(out);
    }

    /// Whether no other finding says that a record of the same type has too few numbers. If many records lack one, it
    /// is not for a lost space.
    fn is_only_one(&self, finding: &Diagnostic) -> bool {
        let ty = |d: &Diagnostic| d.values.iter().find(|v| v.0 == "type").cloned();
        let is_same = |d: &&Diagnostic| d.code == finding.code && ty(d) == ty(finding);
        self.analysis
            .findings()
            .iter()
            .filter(is_same)
            .nth(1)
            .is_none()
    }

    /// Guesses that a whole number is two digits of one vector, if the record has just one such number: split, the
    /// record has as many numbers as it takes, and all are allowed in their places. A number with a 0 is not split.
    fn two_digits(&self) -> Option<Candidate> {
        let ty = self.ty()?;
        let rest: Vec<&str> = self.params().iter().map(|t| t.text(self.text)).collect();
        let colour = ty.first_colour(0).unwrap_or(usize::MAX);
        let split = |i: usize| {
            let text = rest[i];
            let digits = text.strip_prefix('-').unwrap_or(text);
            let is_two = digits.len() == 2 && digits.bytes().all(|c| matches!(c, b'1'..=b'9'));
            let is_two = is_two && is_within_vector(ty, i);
            let parts = is_two.then(|| text.split_at(text.len() - 1))?;
            let params = [&rest[..i], &[parts.0, parts.1], &rest[i + 1..]].concat();
            let is_share = |text: &&str| text.parse().is_ok_and(|x: f64| x <= 1.0);
            let has_colours = params.iter().skip(colour).all(is_share);
            (has_colours && self.is_record(ty, &params))
                .then(|| (self.params()[i], format!("{} {}", parts.0, parts.1)))
        };
        let mut all = (0..rest.len()).filter_map(split);
        let (Some(only), None) = (all.next(), all.next()) else {
            return None;
        };
        let mut candidate = self.write(Habit::Split, &[only])?;
        candidate.fix.title = "fix-space";
        Some(candidate)
    }

    /// Guesses that the one number of fields of a checkerboard with both colours is meant in both directions. The guess
    /// comes before the others, and all of them are choices, since nobody can tell.
    fn both_ways(&self, out: &mut Vec<Candidate>) {
        let ty = (self.ty()).filter(|ty| ty.kind == RecordKind::Checkerboard);
        let (Some(ty), [fields, ..]) = (ty, self.params()) else {
            return;
        };
        let rest: Vec<&str> = self.params().iter().map(|t| t.text(self.text)).collect();
        let params = [&rest[..1], &rest].concat();
        if !self.is_record(ty, &params) {
            return;
        }
        let text = format!("{0} {0}", rest[0]);
        let both = self.write(Habit::Split, &[(*fields, text)]);
        let both = both.map(|mut both| {
            both.fix.title = "fix-both-ways";
            both
        });
        out.splice(0..0, both);
        (out.iter_mut()).for_each(|c| c.fix.applicability = Applicability::Choice);
    }

    fn glued_apart(&self, token: &Token, parts: &[&str]) -> Option<Candidate> {
        self.write(Habit::Glued, &[(*token, parts.join(" "))])
    }

    /// Whether a record of a type may have these parameters: they are as many as it takes, each number is allowed, and
    /// each ID is that of an entity of the right kind.
    fn is_record(&self, ty: &'static RecordType, params: &[&str]) -> bool {
        let may_be = |(param, text): (&Param, &&str)| match param.kind {
            ParamKind::Reference { kinds, or_none } => match text.parse::<u32>() {
                Ok(0) => or_none,
                Ok(id) => self.entities(kinds).any(|e| e.id == id),
                Err(_) => false,
            },
            _ => text.parse().is_ok_and(|x| allows(param, x)),
        };
        !ty.is_counted()
            && params.len() == ty.params.len()
            && ty.params.iter().zip(params).all(may_be)
    }

    /// The finding that a token is several numbers.
    pub(super) fn several_numbers(&self, candidate: &Candidate) -> Option<Diagnostic> {
        let edit = candidate.fix.edits.first()?;
        let d = Diagnostic::new(Code::E003, edit.span).case("glued");
        let d = d.with("text", quote(&self.text[edit.span.range()]));
        Some(d.with("number", quote(&edit.text)))
    }
}

/// Whether the parameter at an index and the one behind it are parts of one vector.
fn is_within_vector(ty: &RecordType, i: usize) -> bool {
    if ty.vectors.is_empty() {
        return ty.params.len() == 3;
    }
    let mut first = 0;
    ty.vectors.iter().any(|&n| {
        let is_within = (first..first + n).contains(&i) && i + 1 < first + n;
        first += n;
        is_within
    })
}

/// All ways to take a number apart into several, of which only the first may have a sign: `-12.5` is `-1 2.5`.
fn split_glued(text: &str) -> Vec<Vec<&str>> {
    let mut out = Vec::new();
    let mut open = vec![vec![text]];
    open.retain(|_| text.len() <= MAX_BYTES);
    while let Some(parts) = open.pop() {
        let Some((last, before)) = parts.split_last() else {
            continue;
        };
        for at in (1..last.len()).filter(|&at| last.is_char_boundary(at)) {
            let (first, rest) = last.split_at(at);
            if is_plain(first, before.is_empty()) && is_plain(rest, false) {
                let parts = [before, &[first, rest]].concat();
                out.push(parts.clone());
                if parts.len() < MAX_PARTS {
                    open.push(parts);
                }
            }
        }
    }
    out
}

/// Two IDs with a dash between them, `20-21`.
fn dashed(text: &str) -> Option<Vec<&str>> {
    let (a, b) = text.split_once(['-', '–'])?;
    let is_digits = |text: &str| !text.is_empty() && text.bytes().all(|c| c.is_ascii_digit());
    (is_digits(a) && is_digits(b)).then(|| vec![a, b])
}

/// Whether a text is a number as people write it: digits on both sides of a point, and no zero before other digits.
fn is_plain(text: &str, may_be_signed: bool) -> bool {
    let unsigned = match text.strip_prefix('-') {
        Some(rest) if may_be_signed => rest,
        _ => text,
    };
    let is_digits = |text: &str| !text.is_empty() && text.bytes().all(|c| c.is_ascii_digit());
    let (whole, fraction) = unsigned.split_once('.').unwrap_or((unsigned, "0"));
    is_digits(whole) && is_digits(fraction) && (whole == "0" || !whole.starts_with('0'))
}

#[cfg(test)]
mod tests {
    use super::split_glued;

    #[test]
    fn numbers_without_a_space() {
        let all = |text: &'static str| -> Vec<String> {
            split_glued(text).iter().map(|p| p.join(" ")).collect()
        };
        assert_eq!(all("-12.5"), ["-1 2.5"]);
        assert_eq!(all("7051"), ["70 51", "705 1", "70 5 1"]);
        assert!(all("-4020.9").contains(&"-402 0.9".to_owned()));
        assert_eq!(all("-101"), ["-10 1"]);
        assert!(all("1-2").is_empty() && all("1.5e3").is_empty());
    }
}
