//! Guesses at another type, or at numbers that fit the written one.

use std::cmp::Ordering;

use super::axes::along_axis;
use super::cylinders::CONE;
use super::{Candidate, Habit, LineContext, MAX_CANDIDATES, header};
use crate::analysis::materials;
use crate::diagnostics::{Applicability, Code, Diagnostic, Edit, Fix, Span, Value};
use crate::lint::spelling::decimal;
use crate::scene::background;
use crate::syntax::lexer::{Token, TokenKind};
use crate::syntax::table::{Family, Kind, RecordKind, RecordType, ShapeKind};
use crate::syntax::words;
use crate::syntax::{hex, quote};

/// Types that people take for each other by their numbers: a written type, and those that may be meant. Of the
/// transformations, only rotation and rotation matrix are among them.
const SIBLINGS: &[(i32, &[i32])] = &[
    (9, &[11, 10, 13]),
    (10, &[9, 11]),
    (11, &[9, 10]),
    (13, &[9]),
    (3, &[4]),
    (5, &[12]),
    (6, &[7, 8]),
    (7, &[6, 8]),
    (8, &[6, 7]),
    (1, &[2]),
    (2, &[1]),
    (12, &[5, 11]),
    (-2, &[-4]),
    (-4, &[-2]),
    (-101, &[-104, -105]),
    (-103, &[-104]),
    (-104, &[-103, -102, -101]),
    (-105, &[-101]),
    (-201, &[-202]),
    (-202, &[-201, -203]),
    (-203, &[-202]),
    (-502, &[-503]),
    (-503, &[-502]),
    (-601, &[-602]),
    (-602, &[-601]),
];

/// Beginnings of words for glass, without accents.
const GLASS: [&str; 2] = ["glass", "skl"];
impl LineContext<'_> {
    /// Guesses at the type for a word, or several, in the place of the type's number.
    pub(super) fn words(&self, out: &mut Vec<Candidate>) {
        let behind = self.tokens.get(1..).unwrap_or(&[]);
        let count = (behind.iter())
            .take_while(|t| t.kind() == TokenKind::Word)
            .count();
        // An axis before its angle is no word of the name.
        let count = match self.axis_number(behind.get(count.saturating_sub(1)..).unwrap_or(&[])) {
            Some(_) if count > 1 => count - 1,
            _ if count > 1 && along_axis(behind[count - 1].text(self.text)).is_some() => count - 1,
            _ => count,
        };
        // The name of a colour, of two words or one, may stand for the numbers of a colour.
        let is_colour = |of: &usize| self.colour_name(&behind[count - of..count]).is_some();
        let colour = [2, 1]
            .into_iter()
            .find(|of| behind.len() == count && count > *of && is_colour(of));
        let count = count - colour.unwrap_or(0);
        let Some(last) = count.checked_sub(1).map(|last| behind[last]) else {
            return;
        };
        let span = behind[0].span().to(last.span());
        let params = &behind[count..];
        if words::is_cylinder(&self.text[span.range()]) {
            self.cylinder(span, params, out);
        }
        if words::is_cone(&self.text[span.range()]) && params.len() == CONE {
            self.cylinder(span, params, out);
        }
        let named = words::types(&self.text[span.range()]);
        let fitting = named.iter().filter(|ty| self.fit(ty, params));
        let start = out.len();
        out.extend(fitting.map(|ty| {
            let mut candidate = self.write_type(Habit::Word, ty);
            candidate.fix.edits[0].span = span;
            let axis = (self.axis_number(params)).filter(|_| ty.kind == RecordKind::Rotation);
            let axis = axis.into_iter().flatten();
            candidate
                .fix
                .edits
                .extend(
                    (axis.filter(|(t, new)| t.text(self.text) != new)).map(|(t, text)| Edit {
                        span: t.span(),
                        text,
                    }),
                );
            candidate
        }));
        out.extend(self.material(span, params));
        if out.len() == start {
            out.extend(named.iter().flat_map(|ty| self.named(span, ty, params)));
        }
    }

    /// Guesses at the type and the numbers of optics for the name of a material.
    fn material(&self, word: Span, params: &[Token]) -> Option<Candidate> {
        let numbers = materials::numbers(RecordKind::Optics, &self.text[word.range()])?;
        let ty = RecordType::of(RecordKind::Optics);
        let text = format!("{} {numbers}", ty.code);
        params
            .is_empty()
            .then(|| Candidate::writing(Habit::Word, word, text))
    }

    /// Guesses that the minus of the type is lost or too many.
    pub(super) fn signs(&self, out: &mut Vec<Candidate>) {
        let ty = self.int(1).and_then(i64::checked_neg);
        if let Some(ty) = ty.and_then(RecordType::by_code)
            && self.fits(ty)
        {
            out.push(self.write_type(Habit::Sign, ty));
        }
    }

    /// Guesses at a sibling type that the numbers fit, or at numbers that fit the written type.
    pub(crate) fn siblings(&self, out: &mut Vec<Candidate>) {
        let Some(ty) = self.ty().filter(|ty| !self.fits(ty)) else {
            return;
        };
        let (kind, [sphere, ellipsoid]) = (
            ty.kind,
            [ShapeKind::Sphere, ShapeKind::Ellipsoid].map(RecordKind::Shape),
        );
        // If there are unused objects, an operand is missing, and no other operation was meant.
        let spare = self.spare_operands(ty);
        let siblings = SIBLINGS
            .iter()
            .filter(|s| s.0 == ty.code && spare.is_empty());
        for &code in siblings.flat_map(|s| s.1) {
            if let Some(ty) = RecordType::by_code(code.into()).filter(|ty| self.fits(ty)) {
                let mut candidate = self.write_type(Habit::Sibling, ty);
                // A sphere may lack its radius, too.
                let is_size = |t: &Token| t.number(self.text).is_some_and(|x| x > 0.0);
                if (ty.kind, kind) == (ellipsoid, sphere) {
                    if !self.params().iter().all(is_size) {
                        continue;
                    }
                    candidate.fix.applicability = Applicability::Choice;
                }
                out.push(candidate);
            }
        }
        let new = |title, text: String| {
            let params = self.params();
            let span = params[0].span().to(params[params.len() - 1].span());
            Candidate::new(
                Habit::Sibling,
                Fix::replace(title, Applicability::Unsafe, span, text.clone())
                    .with("number", quote(&text)),
            )
        };
        let texts: Vec<&str> = (self.params().iter()).map(|t| t.text(self.text)).collect();
        let is_part = |t: &Token| {
            let x = t.number(self.text);
            x.is_some_and(|x| (0.0..=1.0).contains(&x))
        };
        // Nobody can tell which of two texts is meant.
        let choose = |texts: [String; 2], out: &mut Vec<Candidate>| {
            out.extend(texts.map(|text| {
                let mut candidate = new("fix-write", text);
                candidate.fix.applicability = Applicability::Choice;
                candidate
            }));
        };
        let sum = || {
            self.params()
                .iter()
                .filter_map(|t| t.number(self.text))
                .sum::<f64>()
        };
        let is_byte = |t: &Token| {
            let x = t.number(self.text);
            x.is_some_and(|x| (0.0..=255.0).contains(&x))
        };
        // The type may be that of a difference with a wrong digit, as in `6 -203 3 4`.
        let is_object = |t: &Token| {
            let id = t.integer(self.text);
            id.and_then(|id| self.kind_of(id)) == Some(Kind::Object)
        };
        if ty.kind == RecordKind::RefractiveIndex
            && texts.len() == 2
            && self.params().iter().all(is_object)
        {
            let difference = RecordType::of(RecordKind::Difference);
            out.push(self.write_type(Habit::Digit, difference));
        }
        // Three parts with a sum above 1 are not those of one surface, but may be tinted glass.
        if let (RecordKind::OpticsRgb, &[r, g, b]) = (ty.kind, texts.as_slice())
            && self.params().iter().all(is_part)
            && sum() > 1.0
        {
            let is_glass = self.own_index().is_some() || self.is_called(&GLASS);
            let is_other = |c: &Candidate| {
                let kind = c.ty.map(|ty| ty.kind);
                kind != Some(RecordKind::Optics)
                    && !(is_glass && kind == Some(RecordKind::RefractiveIndex))
            };
            out.retain(is_other);
            let mut tinted = new("fix-tinted", format!("0 0 {r}  0 0 {g}  0 0 {b}"));
            if !is_glass {
                let all = out.iter_mut().chain([&mut tinted]);
                all.for_each(|c| c.fix.applicability = Applicability::Choice);
            }
            out.push(tinted);
        }
        match (ty.kind, texts.as_slice(), self.id()) {
            (RecordKind::PointLight | RecordKind::AmbientLight, &[a, b, c], Some(id)) => {
                let is_colour = self.params().iter().all(is_part);
                if is_colour || ty.kind == RecordKind::AmbientLight {
                    out.push(new("fix-lamp", format!("1\n{id} -701 {a} {b} {c}")));
                } else {
                    out.push(new("fix-lamp-place", format!("1\n{id} -1 {a} {b} {c}")));
                }
            }
            (RecordKind::Scaling | RecordKind::RefractiveIndex, &[s], _) => {
                out.push(new("fix-write", format!("{s} {s} {s}")));
            }
            (RecordKind::Scaling, &[a, b], _) => {
                choose([format!("{a} {b} 1"), format!("{a} {b} {b}")], out);
            }
            // One number is a grey, unless it is six digits, a colour in other programs. A grey in bytes or per cent
            // gets another finding later.
            (RecordKind::Colour, &[s], _)
                if hex::colour(s).is_none() && self.params().iter().all(is_byte) =>
            {
                out.push(new("fix-write", format!("{s} {s} {s}")));
            }
            (RecordKind::Optics, &[s], _) => out.extend(self.one_part(ty, s)),
            // Only the colours are given: each gets one field in a unit.
            (RecordKind::Checkerboard, &[a, b], _)
                if self.params().iter().all(|t| self.is_texture(t)) =>
            {
                out.push(new("fix-write", format!("1 1 {a} {b}")));
            }
            (RecordKind::Optics, &[a, b], _)
                if self.params().iter().all(is_part) && sum() <= 1.0 =>
            {
                choose([format!("{a} {b} 0"), format!("{a} 0 {b}")], out);
            }
            (RecordKind::Render, &[one], _) => {
                let (document, scene) = (&self.analysis.document, &self.analysis.scene);
                let of = background::meant(document, self.text, &scene.entities);
                let of = of.map_or(0, |b| b.id);
                out.push(new("fix-write", format!("{one} {of}")));
            }
            (RecordKind::Union | RecordKind::Intersection | RecordKind::Difference, &[one], _) => {
                let others = self.entities(&[Kind::Object]).map(|e| e.id);
                let others = others.filter(|id| id.to_string() != one);
                let mut others: Vec<u32> = match spare.is_empty() {
                    true => others.collect(),
                    false => spare,
                };
                // The objects that are defined last come first.
                others.reverse();
                let begin = |id: u32| {
                    let mut entities = self.analysis.scene.entities.iter();
                    entities.find(|e| e.id == id).map(|e| e.span.start)
                };
                let own = one.parse().ok().and_then(begin);
                for id in others.into_iter().take(MAX_CANDIDATES / 2) {
                    let mut orders = [format!("{one} {id}"), format!("{id} {one}")];
                    // A hole is defined behind the object that it is cut from.
                    if ty.kind == RecordKind::Difference && begin(id) < own {
                        orders.reverse();
                    }
                    out.extend(orders.map(|text| new("fix-write", text)));
                }
            }
            (RecordKind::Assignment, &[one], _) if self.colour_of_glass().is_none() => {
                out.push(new("fix-write", format!("0 {one}")));
                out.push(new("fix-write", format!("{one} 0")));
            }
            _ => {}
        }
    }

    /// Guesses that a property record which has the ID of a property for its numbers is an assignment: `12 -203 31`,
    /// `2 -399 32`.
    pub(super) fn assignment(&self) -> Option<Candidate> {
        let (ty, [property]) = (self.ty()?, self.params()) else {
            return None;
        };
        let written = property.text(self.text);
        // A number up to 1 is a part of a colour, and no ID.
        let id = property.integer(self.text).filter(|&id| id > 1)?;
        if let Some(colour) = self.colour_of_glass() {
            return Some(colour);
        }
        let places = match (ty.kind, self.kind_of(id)?) {
            (RecordKind::Colour, Kind::Colour | Kind::Texture)
            | (
                RecordKind::ImageTexture | RecordKind::SolidTexture | RecordKind::Checkerboard,
                Kind::Texture,
            ) => format!("{written} 0"),
            (
                RecordKind::Optics | RecordKind::OpticsRgb | RecordKind::RefractiveIndex,
                Kind::Optics,
            ) => format!("0 {written}"),
            _ => return None,
        };
        let text = format!("{} {places}", RecordType::of(RecordKind::Assignment).code);
        let span = self.tokens[1].span().to(property.span());
        Some(Candidate::writing(Habit::Sibling, span, text))
    }

    /// Guesses at all three parts of light if only one is given, as a share or in per cent. It may be any of them, and
    /// the rest is diffuse.
    fn one_part(&self, ty: &'static RecordType, written: &str) -> Vec<Candidate> {
        let part = match self.params()[0].number(self.text) {
            Some(x) if x > 0.0 && x <= 1.0 => x,
            Some(x) if x > 1.0 && x <= 100.0 => x / 100.0,
            _ => return Vec::new(),
        };
        let (own, rest) = (decimal(part), decimal(1.0 - part));
        let rows = [
            format!("{own} 0 0"),
            format!("{rest} {own} 0"),
            format!("{rest} 0 {own}"),
        ];
        let span = self.params()[0].span();
        let candidates = ty.params.iter().zip(rows).map(|(param, row)| {
            let fix = Fix::replace("fix-part", Applicability::Choice, span, row.clone());
            let fix = fix.with("text", quote(written)).with("number", quote(&row));
            Candidate::new(
                Habit::Sibling,
                fix.with("parameter", Value::Term(param.doc)),
            )
        });
        candidates.collect()
    }

    /// Whether a number is the ID of a colour or of another texture.
    fn is_texture(&self, t: &Token) -> bool {
        let id = t.integer(self.text);
        let kind = id.and_then(|id| self.kind_of(id));
        matches!(kind, Some(Kind::Colour | Kind::Texture))
    }

    /// The unused objects above an operation that has one operand too few; empty for any other record.
    fn spare_operands(&self, ty: &RecordType) -> Vec<u32> {
        let [one] = self.params() else {
            return Vec::new();
        };
        if ty.family != Family::Operation || ty.params.len() == 1 {
            return Vec::new();
        }
        let mut used = self.named_ids();
        used.extend(one.integer(self.text).and_then(|id| u32::try_from(id).ok()));
        let objects = self.entities(&[Kind::Object]).map(|e| e.id);
        objects.filter(|id| !used.contains(id)).collect()
    }

    /// Guesses at other types that take as many numbers: first slips of the written type, then the nearest ones.
    pub(super) fn types(&self, finding: &Diagnostic, out: &mut Vec<Candidate>) {
        // A property with the ID of a property of another kind needs an ID of its own, not another type.
        if finding.code == Code::E103 && self.other_property().is_some() {
            return;
        }
        let known = self.ty().is_some_and(|ty| self.fits(ty));
        let unknown = match finding.code {
            Code::E007 => true,
            Code::E103 | Code::E101 => known && finding.span == self.tokens[0].span(),
            _ => false,
        };
        let Some(code) = self.int(1).filter(|_| unknown) else {
            return;
        };
        out.extend(self.lost_assignment(code));
        let mut fitting: Vec<&'static RecordType> = crate::syntax::table::RECORD_TYPES
            .iter()
            .filter(|ty| self.fits(ty) && i64::from(ty.code) != code)
            .filter(|ty| ty.family != Family::Void && ty.family != Family::Render)
            // A record that changes something, and fits its type, was not meant as a shape.
            .filter(|ty| finding.code == Code::E007 || ty.family != Family::Shape)
            .collect();
        let written = self.tokens[1].text(self.text);
        let is_slip = |ty: &RecordType| is_slip(written, &ty.code.to_string());
        fitting.sort_by_key(|ty| (!is_slip(ty), i64::from(ty.code).abs_diff(code)));
        out.extend(fitting.into_iter().take(MAX_CANDIDATES / 2).map(|ty| {
            let habit = match is_slip(ty) {
                true => Habit::Digit,
                false => Habit::Type,
            };
            self.write_type(habit, ty)
        }));
    }

    /// Guesses at an assignment that has lost its type and its 0, as in `20 45` where 45 is a property.
    fn lost_assignment(&self, property: i64) -> Option<Candidate> {
        let is_one = self.params().is_empty();
        let text = match self.kind_of(property).filter(|_| is_one)? {
            Kind::Optics => format!("0 {property}"),
            Kind::Texture | Kind::Colour => format!("{property} 0"),
            _ => return None,
        };
        let ty = RecordType::of(RecordKind::Assignment);
        let text = format!("{} {text}", ty.code);
        let fix = Fix::replace(
            "fix-write",
            Applicability::Unsafe,
            self.tokens[1].span(),
            text.clone(),
        );
        Some(Candidate {
            habit: Habit::Digit,
            fix: (fix.with("number", quote(&text))).with("type", Value::Term(ty.title)),
            ty: Some(ty),
        })
    }

    /// The finding that the line has too few numbers for its type, or too many.
    pub(crate) fn wrong_count(&self) -> Option<Diagnostic> {
        let (ty, got) = (self.ty()?, self.params().len());
        let wanted = self.wanted(ty);
        if got == wanted {
            return None;
        }
        let code = if got < wanted { Code::E008 } else { Code::E009 };
        let span = match self.params().get(wanted) {
            Some(surplus) => surplus.span().to(self.tokens[got + 1].span()),
            None => self.line,
        };
        let count = |n: usize| Value::Count(n as u64);
        let least = ty.params.len();
        let (full, fewer) = match ty.optional.len() {
            0 => (wanted, "none".to_owned()),
            more => (least + more, least.to_string()),
        };
        Some(
            Diagnostic::new(code, span)
                .with("type", Value::Term(ty.title))
                .with("got", count(got))
                .with("off", count(got.abs_diff(wanted)))
                .with("wanted", count(full))
                .with("fewer", fewer)
                .with("header", header(ty)),
        )
    }
}

/// Whether `written` is a slip of `meant`: a digit is lost or doubled, or two are exchanged. In a number of three
/// digits one may also be wrong; in one of two that tells nothing, since most of them differ by one digit.
pub(super) fn is_slip(written: &str, meant: &str) -> bool {
    let digits = |text: &'_ str| text.bytes().filter(u8::is_ascii_digit).count();
    let sorted = |text: &str| {
        let mut all = text.as_bytes().to_vec();
        all.sort_unstable();
        all
    };
    let is_doubled = || {
        let mut pairs = written.as_bytes().windows(2).enumerate();
        pairs.any(|(i, two)| {
            two[0] == two[1] && [&written[..i], &written[i + 1..]].concat() == meant
        })
    };
    written.starts_with('-') == meant.starts_with('-')
        && strsim::osa_distance(written, meant) == 1
        && match digits(written).cmp(&digits(meant)) {
            Ordering::Less => true,
            Ordering::Equal => digits(meant) > 2 || sorted(written) == sorted(meant),
            Ordering::Greater => digits(meant) > 2 || is_doubled(),
        }
}

#[cfg(test)]
mod tests {
    use super::is_slip;

    #[test]
    fn slips_of_types() {
        for (written, meant) in [
            ("-71", "-701"),
            ("-13", "-103"),
            ("-013", "-103"),
            ("41", "14"),
            ("114", "14"),
            ("-7011", "-701"),
            ("-711", "-701"),
            ("-1011", "-101"),
        ] {
            assert!(is_slip(written, meant), "{written} {meant}");
        }
        for (written, meant) in [
            ("41", "17"),
            ("19", "10"),
            ("19", "9"),
            ("-13", "13"),
            ("-71", "-1"),
        ] {
            assert!(!is_slip(written, meant), "{written} {meant}");
        }
    }
}
