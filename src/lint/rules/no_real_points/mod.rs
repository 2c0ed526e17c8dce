//! W306: a quadric with no surface: no real point satisfies it, or every one does.

use crate::diagnostics::{Applicability, Code, Diagnostic, Fix};
use crate::lint::Context;
use crate::lint::spelling::spelled;
use crate::scene::Geometry;
use crate::solids::definite::{Verdict, judge};

pub fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    for shape in &context.scene.shapes {
        let Geometry::Quadric(q) = &shape.geometry else {
            continue;
        };
        let case = match judge(q) {
            Verdict::Empty => "",
            Verdict::Full => "full",
            Verdict::Zero => "zero",
            Verdict::Flat(_) | Verdict::Other => continue,
        };
        let Some(p) = context.params(shape.span) else {
            continue;
        };
        let finding = Diagnostic::new(Code::W306, p.span_of(0, 16))
            .case(case)
            .with("id", shape.id.to_string());
        let mut other = *q;
        other[15] = -q[15];
        out.push(match q[15] > 0.0 && judge(&other) == Verdict::Other {
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

#[cfg(test)]
mod tests {
    use crate::lint::testing::{fixed, found};

    #[test]
    fn a_ball_with_the_wrong_sign() {
        let scene = "2 15 1 0 0 0  0 1 0 0  0 0 1 0  0 0 0 4 # r² #\n";
        assert_eq!(found(scene), ["W306 1:6"]);
        assert_eq!(
            fixed(scene),
            "2 15 1 0 0 0  0 1 0 0  0 0 1 0  0 0 0 -4 # r² #\n"
        );
        assert!(found(&fixed(scene)).is_empty());
    }

    #[test]
    fn all_of_space_has_no_fix() {
        let scene = "2 15 -1 0 0 0  0 -1 0 0  0 0 0 0  0 0 0 -4\n";
        assert_eq!(found(scene), ["W306 1:6"]);
        assert_eq!(fixed(scene), scene);
        assert_eq!(
            found(&"0 ".repeat(17).replacen("0 ", "2 15 ", 1)),
            ["W306 1:6"]
        );
    }

    #[test]
    fn a_form_that_is_nowhere_positive() {
        let scene = "2 15 -1 0 0 0  0 -1 0 0  0 0 -1 0  0 0 0 0\n";
        assert_eq!(found(scene), ["W306 1:6"]);
        assert_eq!(fixed(scene), scene);
        // −(x + y)² ≤ 0 everywhere; −x² + 2xy ≤ 0 is one of two pairs of wedges.
        assert_eq!(
            found("2 15 -1 -1 0 0  -1 -1 0 0  0 0 0 0  0 0 0 0\n"),
            ["W306 1:6"]
        );
        assert!(found("2 15 -1 1 0 0  1 0 0 0  0 0 0 0  0 0 0 0\n").is_empty());
    }

    #[test]
    fn what_has_a_surface_or_is_not_proved() {
        // A ball moved to (1, 2, 3): 14 − 13.9 is positive, so it is empty; 14 − 14.1 is a ball.
        let moved = |c: &str| format!("2 15 1 0 0 -1  0 1 0 -2  0 0 1 -3  -1 -2 -3 {c}\n");
        assert_eq!(found(&moved("14.1")), ["W306 1:6"]);
        assert!(found(&moved("13.9")).is_empty());
        // Outside of a ball, a cylinder, two planes.
        for q in [
            "-1 0 0 0 0 -1 0 0 0 0 -1 0 0 0 0 1",
            "1 0 0 0 0 1 0 0 0 0 0 0 0 0 0 -1",
        ] {
            assert!(found(&format!("2 15 {q}\n")).is_empty());
        }
    }
}
