//! A plane or a half-space across an axis whose comment gives its place there, as `y = 1`, with the other sign.

use crate::diagnostics::{Applicability, Code, Diagnostic, Fix, Value};
use crate::lint::Context;
use crate::lint::records::chosen_cameras;
use crate::lint::rules::{PLACE_REL_GAP, buried_shape::hiders};
use crate::lint::spelling::{decimal, opposite};
use crate::scene::record::Params;
use crate::syntax::table::{Family, RecordKind, ShapeKind};
use crate::syntax::{Record, quote, words};

const LETTERS: [char; 3] = ['x', 'y', 'z'];
/// What may join a letter or a number to a longer formula.
const OPERATORS: [char; 8] = ['+', '-', '*', '/', '^', '²', '·', '.'];
/// Beginnings of words by which a comment speaks of something else, without accents.
const OTHERS: [&str; 14] = [
    "normal", "camer", "kamer", "lamp", "light", "svetl", "up", "not", "was", "instead", "misto",
    "neni", "byl", "mirrored",
];
/// The place of the constant term in the record.
const CONSTANT: usize = 3;

/// The letter and the place, by its comment, of a plane whose numbers have it at the opposite one.
pub(super) fn said(p: &Params) -> Option<(char, f64)> {
    let normal: [f64; 3] = p.numbers(0);
    let axis = (0..3).find(|&i| (0..3).all(|j| (i == j) == (normal[j] != 0.0)))?;
    let (letter, said) = p.own_comments().find_map(equation)?;
    let place = -p.number(CONSTANT) / normal[axis];
    let is_opposite = said != 0.0 && (place + said).abs() <= PLACE_REL_GAP * said.abs();
    (p.len() == 4 && letter == LETTERS[axis] && is_opposite).then_some((letter, said))
}

/// The only equation of a comment, where it gives a coordinate.
fn equation(comment: &str) -> Option<(char, f64)> {
    let text = comment.to_lowercase().replace(['−', '–'], "-");
    if words::has(&text, &OTHERS) {
        return None;
    }
    let (left, right) = text.split_once('=')?;
    let left = left.trim_end();
    let letter = left.chars().next_back().filter(|c| LETTERS.contains(c))?;
    let before = &left[..left.len() - 1];
    let is_formula = before.ends_with(char::is_alphanumeric)
        || before.trim_end().ends_with(OPERATORS)
        || right.contains('=');
    let right = right.trim_start();
    let sign = usize::from(right.starts_with('-'));
    let is_part = |c: char| c.is_ascii_digit() || c == '.' || c == ',';
    let digits = right[sign..].trim_start();
    let end = digits.find(|c| !is_part(c)).unwrap_or(digits.len());
    let number = digits[..end].trim_end_matches(['.', ',']).replace(',', ".");
    let rest = &digits[end..];
    let goes_on =
        rest.starts_with(char::is_alphanumeric) || rest.trim_start().starts_with(OPERATORS);
    let x: f64 = number.parse().ok()?;
    (!is_formula && !goes_on).then_some((letter, if sign == 1 { -x } else { x }))
}

pub(super) fn check(
    context: &Context,
    planes: &[(&Record, (char, f64))],
    out: &mut Vec<Diagnostic>,
) {
    if planes.is_empty() {
        return;
    }
    let moved = context.with_parts(|r| r.ty().family == Family::Transformation);
    let eyes: Vec<_> = chosen_cameras(context)
        .iter()
        .map(|(c, _)| c.position)
        .collect();
    // Of what hides something W335 speaks.
    let hiders = hiders(context);
    for (record, (letter, said)) in planes.iter().filter(|(r, _)| !moved.contains(&r.id)) {
        let p = context.record_params(record);
        let [a, b, c, d] = p.numbers(0);
        // Of a half-space that a camera is inside of W325 speaks.
        let holds = |d: f64| {
            eyes.iter()
                .any(|[x, y, z]| a * x + b * y + c * z + d <= 0.0)
        };
        let is_solid = p.ty.kind == RecordKind::Shape(ShapeKind::HalfSpace);
        if hiders.contains(&p.span()) || is_solid && (holds(d) || holds(-d)) {
            continue;
        }
        let at = |place: f64| quote(&format!("{letter} = {}", decimal(place)));
        let (span, text) = (p.span_of(CONSTANT, 1), opposite(&p, CONSTANT));
        let fix = Fix::replace("fix", Applicability::Unsafe, span, text.clone());
        out.push(
            Diagnostic::new(Code::W344, span)
                .case("height")
                .with("type", Value::Term(p.ty.title))
                .with("id", p.id.to_string())
                .with("said", at(*said))
                .with("place", at(-said))
                .fix(fix.with("number", quote(&text))),
        );
    }
}
