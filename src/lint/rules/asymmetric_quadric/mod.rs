//! W304: a quadric whose matrix is not symmetric.

use crate::diagnostics::{Applicability, Code, Diagnostic, Edit, Fix, Value};
use crate::lint::Context;
use crate::lint::spelling::spelled;
use crate::scene::Geometry;

/// Two numbers this near, as a share of the larger, are one number that was rounded in two ways. A
/// program that turns or scales a quadric computes each entry of AᵀQA as a sum of up to four products
/// of three: two roundings for a product and three for the sum, of half an ε each, and the same again
/// for the entry's mirror image.
const ROUNDED: f64 = 5.0 * f64::EPSILON;

pub fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    for shape in &context.scene.shapes {
        let Geometry::Quadric(q) = &shape.geometry else {
            continue;
        };
        let unequal: Vec<(usize, usize)> = (0..4)
            .flat_map(|i| (i + 1..4).map(move |j| (4 * i + j, 4 * j + i)))
            .filter(|&(a, b)| (q[a] - q[b]).abs() > ROUNDED * q[a].abs().max(q[b].abs()))
            .collect();
        let (Some(&(first, mirror)), Some(p)) = (unequal.first(), context.params(shape.span))
        else {
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
        let name = |i: usize| format!("m{}{}", i / 4 + 1, i % 4 + 1);
        out.push(
            Diagnostic::new(Code::W304, p.span_of(first, 1))
                .with("id", shape.id.to_string())
                .with("first", name(first))
                .with("first-number", p.text_of(first).to_owned())
                .with("mirror", name(mirror))
                .with("mirror-number", p.text_of(mirror).to_owned())
                .with("pairs", Value::Count(unequal.len() as u64))
                .with("more", Value::Count(unequal.len() as u64 - 1))
                .label(p.span_of(mirror, 1), "other")
                .fix(Fix {
                    title: "fix",
                    applicability: Applicability::Safe,
                    edits,
                }),
        );
    }
}

#[cfg(test)]
mod tests {
    use crate::lint::testing::{fixed, found};

    #[test]
    fn one_of_a_pair() {
        let scene = "2 15 1 4 0 0  0 1 0 0  0 0 -1 0  0 0 0 -1\n";
        assert_eq!(found(scene), ["W304 1:8"]);
        assert_eq!(fixed(scene), "2 15 1 2 0 0  2 1 0 0  0 0 -1 0  0 0 0 -1\n");
        // The same number spelled in two ways is no difference.
        let symmetric = "2 15 1 .5 0 0  5e-1 1 0 0  0 0 -1 -0  0 0 0 -1\n";
        assert!(found(symmetric).is_empty());
    }

    #[test]
    fn rounding_is_no_difference() {
        let scene = |m21: f64| format!("2 15 1 0.5 0 0  {m21:?} 1 0 0  0 0 -1 0  0 0 0 -1\n");
        // As a program writes it: one digit at the end.
        assert!(found(&scene(0.5 + f64::EPSILON / 2.0)).is_empty());
        // Near 0.5 numbers are ε/2 apart: 5ε of the larger is five steps.
        assert!(found(&scene(0.5 + 5.0 * f64::EPSILON / 2.0)).is_empty());
        assert_eq!(found(&scene(0.5 + 6.0 * f64::EPSILON / 2.0)), ["W304 1:8"]);
        assert!(found(&scene(0.5 - 5.0 * f64::EPSILON / 2.0)).is_empty());
        assert_eq!(found(&scene(0.5 - 6.0 * f64::EPSILON / 2.0)), ["W304 1:8"]);
        // Relative to the two, not to the rest of the matrix; and no sign is rounding.
        let small = "2 15 1 1e-30 0 0  2e-30 1 0 0  0 0 -1 0  0 0 0 -1\n";
        assert_eq!(found(small), ["W304 1:8"]);
        let signs = "2 15 1 1e-300 0 0  -1e-300 1 0 0  0 0 -1 0  0 0 0 -1\n";
        assert_eq!(found(signs), ["W304 1:8"]);
        // A pair that is only rounded is left alone by the fix of another one.
        let both = "2 15 1 0.3 1 0  0.30000000000000004 1 3 0  1 5 -1 0  0 0 0 -1\n";
        assert_eq!(
            fixed(both),
            "2 15 1 0.3 1 0  0.30000000000000004 1 4 0  1 4 -1 0  0 0 0 -1\n"
        );
    }

    #[test]
    fn all_pairs_and_a_comment() {
        let scene = "2 15 1 1 1 1 # upper # 0 1 1 1  0 0 -3 1  0 0 0 -1\n";
        assert_eq!(found(scene), ["W304 1:8"]);
        assert_eq!(
            fixed(scene),
            "2 15 1 0.5 0.5 0.5 # upper # 0.5 1 0.5 0.5  0.5 0.5 -3 0.5  0.5 0.5 0.5 -1\n"
        );
    }
}
