//! Notations of mathematics: `4 = 2 ∪ 3`, `4 2 ∪ 3` by the type's number, and names before numbers, `r = 1`.

use super::{Candidate, Habit, LineContext};
use crate::diagnostics::{Applicability, Edit, Fix, Value};
use crate::lint::spelling::decimal;
use crate::syntax::lexer::{Token, TokenKind};
use crate::syntax::table::{Family, Kind, RecordKind, RecordType, ShapeKind};
use crate::syntax::{calculated, quote};

/// Signs between a name and its number.
const EQUALS: [char; 2] = ['=', ':'];

/// The factor in a product such as `1.5*3`, by which the other number is meant for all three parameters of a record.
const TIMES: &str = "3";

/// A number that may have its name before it.
struct Named<'t> {
    name: Option<&'t str>,
    /// The name and the number as one token.
    whole: Token,
    number: &'t str,
}

impl LineContext<'_> {
    /// An operation as an equation of sets: `4 = 2 - 3`.
    pub(super) fn equation(&self) -> Option<Candidate> {
        let (first, last) = (self.tokens.first()?, self.tokens.last()?);
        let span = first.span().to(last.span());
        let (id, sets) = self.text[span.range()].split_once('=')?;
        let number = |text: &str| text.trim().parse().ok().filter(|&id: &u32| id > 1);
        let id = number(id.trim_end().trim_end_matches(':'))?;
        let at = sets.find(|c: char| !c.is_ascii_digit() && !c.is_whitespace())?;
        let sign = sets[at..].chars().next()?;
        let kind = match sign {
            '+' | '∪' | '|' => RecordKind::Union,
            '*' | '·' | '∩' | '&' => RecordKind::Intersection,
            '-' | '−' | '–' | '\\' | '∖' => RecordKind::Difference,
            _ => return None,
        };
        let (a, b) = (number(&sets[..at])?, number(&sets[at + sign.len_utf8()..])?);
        let ty = RecordType::of(kind);
        let text = format!("{id} {} {a} {b}", ty.code);
        let fix = Fix::replace("fix-equation", Applicability::Unsafe, span, text.clone());
        let fix = fix.with("number", quote(&text));
        Some(Candidate::new(
            Habit::Characters,
            fix.with("type", Value::Term(ty.title)),
        ))
    }

    /// An operation whose type stands between its operands: `52 51 -101 34`.
    pub(super) fn infix(&self) -> Option<Candidate> {
        let &[id, a, sign, b] = self.tokens.as_slice() else {
            return None;
        };
        let ty = RecordType::by_code(sign.integer(self.text)?)?;
        let is_operation = ty.family == Family::Operation && ty.params.len() == 2;
        let is_object = |t: &Token| {
            let id = t.integer(self.text);
            id.and_then(|id| self.kind_of(id)) == Some(Kind::Object)
        };
        if !is_operation || self.id().is_none() || ![a, b].iter().all(is_object) {
            return None;
        }
        let [id, first, second] = [id, a, b].map(|t| t.text(self.text));
        let text = format!("{id} {} {first} {second}", ty.code);
        let edit = |t: Token, text: &str| Edit {
            span: t.span(),
            text: text.to_owned(),
        };
        Some(Candidate::new(
            Habit::Infix,
            Fix {
                title: "fix-equation",
                values: vec![
                    ("number", quote(&text).into()),
                    ("type", Value::Term(ty.title)),
                ],
                applicability: Applicability::Unsafe,
                edits: vec![edit(a, sign.text(self.text)), edit(sign, first)],
            },
        ))
    }

    /// Guesses at parameters that have names before them, as `r = 1`, and drops the names. If the names are those of
    /// all parameters of the type, the numbers are put into the type's order.
    pub(super) fn named_values(&self) -> Option<Candidate> {
        let ty = self.ty().filter(|ty| !ty.is_counted())?;
        let mut all: Vec<Named> = Vec::new();
        let mut rest = self.params();
        while !rest.is_empty() {
            let (of, value) = self.value(rest)?;
            all.push(value);
            rest = &rest[of..];
        }
        let (first, last) = (all.first()?.whole, all.last()?.whole);
        if all.iter().all(|v| v.name.is_none()) || all.len() != ty.params.len() {
            return None;
        }
        let named = |name: &str| all.iter().find(|v| v.name == Some(name));
        let in_order: Option<Vec<&str>> =
            (ty.params.iter().map(|p| named(p.name).map(|v| v.number))).collect();
        let written: Vec<&str> = all.iter().map(|v| v.number).collect();
        if let Some(in_order) = in_order.filter(|new| *new != written) {
            let all = Token::new(first.kind(), first.start as usize, last.end() as usize);
            return self.write(Habit::Characters, &[(all, in_order.join(" "))]);
        }
        let new: Vec<(Token, String)> = (all.iter())
            .map(|v| (v.whole, v.number.to_owned()))
            .collect();
        self.write(Habit::Characters, &new)
    }

    /// Guesses at a product for the three numbers of a record, `1.5*3`: it means 1.5 three times, or, where one number
    /// may stand for three, the value of the product three times.
    pub(super) fn product(&self, out: &mut Vec<Candidate>) {
        let (Some(ty), [product]) = (self.ty(), self.params()) else {
            return;
        };
        let written = product.text(self.text);
        let number = |text: &str| text.parse().is_ok_and(f64::is_finite);
        let (Some((a, b)), Some(value)) = (written.split_once('*'), calculated(written)) else {
            return;
        };
        let times = match (a, b) {
            (one, TIMES) | (TIMES, one) if number(one) => one,
            _ => return,
        };
        if ty.is_counted() || ty.params.len() != 3 {
            return;
        }
        let is_alike = matches!(
            ty.kind,
            RecordKind::Scaling | RecordKind::RefractiveIndex | RecordKind::Colour
        );
        let value = is_alike.then_some(value.as_str());
        for one in [Some(times), value].into_iter().flatten() {
            let all = [one; 3].join(" ");
            if let Some(mut candidate) = self.write(Habit::Characters, &[(*product, all)]) {
                candidate.fix.applicability = Applicability::Choice;
                out.push(candidate);
            }
        }
    }

    /// A plane across an axis as its equation: `2 4 y = 0`.
    pub(super) fn axis_equation(&self) -> Option<Candidate> {
        let planes = [ShapeKind::HalfSpace, ShapeKind::Plane].map(RecordKind::Shape);
        self.ty().filter(|ty| planes.contains(&ty.kind))?;
        let (first, last) = (self.params().first()?, self.params().last()?);
        let whole = self.joined(first, last);
        let (axis, value) = whole.text(self.text).split_once('=')?;
        let normal = match axis.trim() {
            "x" => "1 0 0",
            "y" => "0 1 0",
            "z" => "0 0 1",
            _ => return None,
        };
        let value: f64 = value.trim().parse().ok().filter(|x: &f64| x.is_finite())?;
        let record = format!("{normal} {}", decimal(0.0 - value));
        self.write(Habit::Characters, &[(whole, record)])
    }

    /// The number that some tokens begin with, with a name if it has one, and how many tokens both take.
    fn value(&self, tokens: &[Token]) -> Option<(usize, Named<'_>)> {
        let first = *tokens.first()?;
        if first.kind().is_number() {
            let number = first.text(self.text);
            return Some((
                1,
                Named {
                    name: None,
                    whole: first,
                    number,
                },
            ));
        }
        (1..=tokens.len().min(3)).find_map(|of| {
            let span = first.span().to(tokens[of - 1].span());
            let (name, number) = self.text[span.range()].split_once(EQUALS)?;
            let (name, number) = (name.trim(), number.trim());
            let is_name =
                name.starts_with(char::is_alphabetic) && name.chars().all(char::is_alphanumeric);
            let is_number = number.parse().is_ok_and(f64::is_finite)
                && number.contains(|c: char| c.is_ascii_digit());
            let value = Named {
                name: Some(name),
                whole: Token::new(TokenKind::Word, span.start as usize, span.end as usize),
                number,
            };
            (is_name && is_number).then_some((of, value))
        })
    }
}
