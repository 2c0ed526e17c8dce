//! W306: a quadric with no surface: no real point satisfies it, or every one does.

use crate::diagnostics::{Applicability, Code, Diagnostic, Fix};
use crate::lint::definite::{Verdict, judge};
use crate::lint::{Context, spelled};
use crate::scene::Geometry;

pub fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    for shape in &context.scene.shapes {
        let Geometry::Quadric(q) = &shape.geometry else {
            continue;
        };
        let (what, then) = match judge(q) {
            Verdict::Empty => (
                "no point satisfies the quadric",
                "xᵀQx is greater than 0 everywhere: the object is empty, nothing of it is drawn, and \
                 taking it away from another one changes nothing",
            ),
            Verdict::Full => (
                "every point satisfies the quadric",
                "xᵀQx is nowhere greater than 0: the object fills all of space, has no surface that \
                 could be drawn, and leaves nothing of what it is taken away from",
            ),
            Verdict::Zero => (
                "every point satisfies the quadric",
                "xᵀQx is 0 everywhere: the object fills all of space and has no surface that could \
                 be drawn",
            ),
            Verdict::Flat(_) | Verdict::Other => continue,
        };
        let Some(p) = context.params(shape.span) else {
            continue;
        };
        let mut finding =
            Diagnostic::new(Code::W306, p.span_of(0, 16), format!("{what} {}", shape.id))
                .here("this matrix")
                .note(then);
        let mut other = *q;
        other[15] = -q[15];
        if q[15] > 0.0 && judge(&other) == Verdict::Other {
            finding = finding
                .help("for a ball of radius r, m11 to m33 are 1 and m44 is -r²")
                .fix(Fix::replace(
                    "turn the sign of m44",
                    Applicability::Unsafe,
                    p.span_of(15, 1),
                    spelled(other[15]),
                ));
        }
        out.push(finding);
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
