//! Checks of the matrices in records.

use super::record::Params;
use super::sight::{Blind, Sight};
use crate::diagnostics::{Code, Diagnostic, Edit, Fix, Value};
use crate::geometry::Matrix;

/// The matrix of a record. Reports E204 unless it is affine (last row 0 0 0 1) and can be inverted.
pub(super) fn affine(p: &Params, out: &mut Vec<Diagnostic>) -> Option<Matrix> {
    let m = Matrix::from_rows(&p.numbers(0));
    if m.0[3] != [0.0, 0.0, 0.0, 1.0] {
        let d = Diagnostic::new(Code::E204, p.span_of(12, 4));
        let is_transposed = m.0.map(|row| row[3]) == [0.0, 0.0, 0.0, 1.0];
        out.push(match is_transposed {
            true => d.case("transposed").fix(transpose(p)),
            false => d.case("row"),
        });
        return None;
    }
    invertible(p, m, out)
}

/// The fix that exchanges rows and columns: in other programs matrices act on row vectors.
fn transpose(p: &Params) -> Fix {
    let new = (0..16).map(|i| (i, p.text_of(i % 4 * 4 + i / 4)));
    let edits = new
        .filter(|&(i, text)| p.text_of(i) != text)
        .map(|(i, text)| Edit {
            span: p.span_of(i, 1),
            text: text.to_owned(),
        });
    Fix::guess("fix", edits.collect())
}

/// The matrix of a -99 record. Reports E204 unless it can be inverted, and E207 unless it has a ray for every point of
/// the picture.
pub(super) fn projection(p: &Params, out: &mut Vec<Diagnostic>) -> Option<Matrix> {
    let m = Matrix::from_rows(&p.numbers(0));
    match Sight::of(&m) {
        Ok(_) => Some(m),
        Err(Blind::Singular) => {
            singular(p, "", out);
            None
        }
        Err(Blind::InPart) => {
            out.push(Diagnostic::new(Code::E207, p.span_of(0, 16)).case("projection"));
            None
        }
    }
}

/// Returns the matrix if it can be inverted, and reports E204 if not.
fn invertible(p: &Params, m: Matrix, out: &mut Vec<Diagnostic>) -> Option<Matrix> {
    if m.is_plainly_invertible() {
        return Some(m);
    }
    match (m.is_singular(), m.inverse()) {
        (false, Some(_)) => return Some(m),
        (true, _) => singular(p, "", out),
        (false, None) => singular(p, "rounded", out),
    }
    None
}

fn singular(p: &Params, case: &'static str, out: &mut Vec<Diagnostic>) {
    out.push(
        Diagnostic::new(Code::E204, p.span_of(0, 16))
            .case(case)
            .with("type", Value::Term(p.ty.title)),
    );
}
