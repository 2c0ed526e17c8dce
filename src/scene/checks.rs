//! Checks of a record that concern several parameters at once.

use super::record::Params;
use super::sight::{Blind, Sight};
use crate::diagnostics::{Applicability, Code, Diagnostic, Edit, Fix, Value};
use crate::geometry::Matrix;

/// E203 unless the three parameters from `first` on make a vector with a direction.
pub fn non_zero(
    p: &Params,
    first: usize,
    what: &'static str,
    out: &mut Vec<Diagnostic>,
) -> Option<()> {
    if p.numbers::<3>(first).iter().any(|&x| x != 0.0) {
        return Some(());
    }
    out.push(
        Diagnostic::new(Code::E203, p.span_of(first, 3))
            .with("vector", Value::Term(what))
            .with("type", Value::Term(p.ty.title)),
    );
    None
}

/// E202 unless each of `n` lower bounds from `first` on is below its upper bound, `n` further on.
pub fn ordered(p: &Params, first: usize, n: usize, out: &mut Vec<Diagnostic>) -> Option<()> {
    let inverted: Vec<usize> = (first..first + n)
        .filter(|&i| p.number(i) > p.number(i + n))
        .collect();
    if inverted.is_empty() {
        return Some(());
    }
    let name = |i: usize| p.param(i).map_or("", |q| q.name);
    let mut edits: Vec<Edit> = (inverted.iter())
        .flat_map(|&i| [(i, i + n), (i + n, i)])
        .map(|(to, from)| Edit {
            span: p.span_of(to, 1),
            text: p.text_of(from).to_owned(),
        })
        .collect();
    edits.sort_by_key(|e| e.span);
    let at = inverted[0];
    out.push(
        Diagnostic::new(Code::E202, p.span_of(at, 1))
            .with("lower", name(at))
            .with("upper", name(at + n))
            .with("type", Value::Term(p.ty.title))
            .with("others", Value::Count(inverted.len() as u64 - 1))
            .label(p.span_of(at + n, 1), "other")
            .fix(Fix {
                title: "fix",
                applicability: Applicability::Safe,
                edits,
            }),
    );
    None
}

/// E204 unless the matrix is affine (last row 0 0 0 1) and can be inverted.
pub fn affine(p: &Params, out: &mut Vec<Diagnostic>) -> Option<Matrix> {
    let m = Matrix::from_rows(&p.numbers(0));
    if m.0[3] != [0.0, 0.0, 0.0, 1.0] {
        out.push(Diagnostic::new(Code::E204, p.span_of(12, 4)).case("row"));
        return None;
    }
    invertible(p, m, out)
}

/// The matrix of a -99 record: E204 unless it can be inverted, E207 unless it has a ray for every
/// point of the picture.
pub fn projection(p: &Params, out: &mut Vec<Diagnostic>) -> Option<Matrix> {
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

/// E204 unless the matrix can be inverted.
fn invertible(p: &Params, m: Matrix, out: &mut Vec<Diagnostic>) -> Option<Matrix> {
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
