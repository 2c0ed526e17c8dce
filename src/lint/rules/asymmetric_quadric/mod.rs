//! W304: a quadric whose matrix is not symmetric.

use crate::diagnostics::{Applicability, Code, Diagnostic, Edit, Fix, Value};
use crate::lint::Context;
use crate::lint::spelling::spelled;
use crate::scene::Geometry;

/// Two numbers whose relative difference is at most this are one number that was rounded in two ways. A program that
/// scales a quadric, or turns it about a coordinate axis, computes each entry of AᵀQA as a sum of up to four products of
/// three factors. A product rounds twice and the sum three times, by ε/2 each: 2.5 ε. The entry's mirror image may be
/// off by as much again: 5 ε.
const ROUNDED: f64 = 5.0 * f64::EPSILON;

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    for (shape, span) in context.scene.written_shapes() {
        let Geometry::Quadric(q) = &shape.geometry else {
            continue;
        };
        let unequal: Vec<(usize, usize)> = (0..4)
            .flat_map(|i| (i + 1..4).map(move |j| (4 * i + j, 4 * j + i)))
            .filter(|&(a, b)| (q[a] - q[b]).abs() > ROUNDED * q[a].abs().max(q[b].abs()))
            .collect();
        let (Some(&(first, mirror)), Some(p)) = (unequal.first(), context.params(span)) else {
            continue;
        };
        let mut edits: Vec<Edit> = Vec::new();
        for &(a, b) in &unequal {
            let mean = spelled(q[a] / 2.0 + q[b] / 2.0);
            for i in [a, b] {
                edits.push(Edit {
                    span: p.span_of(i, 1),
                    text: mean.clone(),
                });
            }
        }
        edits.sort_by_key(|e| e.span);
        // The last numbers of a doubted record may belong to another record: W314 reports it, and no fix is offered
        // here.
        let is_doubted = context.is_doubted(span);
        let name = |i: usize| format!("m{}{}", i / 4 + 1, i % 4 + 1);
        let finding = Diagnostic::new(Code::W304, p.span_of(first, 1))
            .with("id", shape.id.to_string())
            .with("first", name(first))
            .with("first-number", p.text_of(first).to_owned())
            .with("mirror", name(mirror))
            .with("mirror-number", p.text_of(mirror).to_owned())
            .with("pairs", Value::Count(unequal.len() as u64))
            .with("more", Value::Count(unequal.len() as u64 - 1))
            .label(p.span_of(mirror, 1), "other");
        let fix = Fix {
            title: "fix",
            values: Vec::new(),
            applicability: Applicability::Safe,
            edits,
        };
        out.push(match is_doubted {
            true => finding,
            false => finding.fix(fix),
        });
    }
}
