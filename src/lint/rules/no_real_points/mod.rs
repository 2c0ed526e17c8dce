//! W306: a quadric with no surface: no real point satisfies it, or every one does.

use crate::diagnostics::{Applicability, Code, Diagnostic, Fix};
use crate::lint::Context;
use crate::lint::spelling::spelled;
use crate::scene::Geometry;
use crate::solids::definite::{QuadricSet, judge};

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    for (shape, span) in context.scene.written_shapes() {
        let Geometry::Quadric(q) = &shape.geometry else {
            continue;
        };
        let case = match judge(q) {
            QuadricSet::Empty => "",
            QuadricSet::Full => "full",
            QuadricSet::Zero => "zero",
            QuadricSet::Flat(_) | QuadricSet::Other => continue,
        };
        let Some(p) = context.params(span) else {
            continue;
        };
        let finding = Diagnostic::new(Code::W306, p.span_of(0, 16))
            .case(case)
            .with("id", shape.id.to_string());
        let mut other = **q;
        other[15] = -q[15];
        out.push(match q[15] > 0.0 && judge(&other) == QuadricSet::Other {
            true => finding.case("ball").fix(Fix::replace(
                "fix",
                Applicability::Unsafe,
                p.span_of(15, 1),
                spelled(other[15]),
            )),
            false => finding,
        });
    }
}
