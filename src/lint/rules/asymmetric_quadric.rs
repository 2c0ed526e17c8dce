//! W304: a quadric whose matrix is not symmetric.

use crate::diagnostics::{Applicability, Code, Diagnostic, Edit, Fix, Value};
use crate::lint::{Context, spelled};
use crate::scene::Geometry;

pub fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    for shape in &context.scene.shapes {
        let Geometry::Quadric(q) = &shape.geometry else {
            continue;
        };
        let unequal: Vec<(usize, usize)> = (0..4)
            .flat_map(|i| (i + 1..4).map(move |j| (4 * i + j, 4 * j + i)))
            .filter(|&(a, b)| q[a] != q[b])
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
                .with("first-number", p.text_of(first))
                .with("mirror", name(mirror))
                .with("mirror-number", p.text_of(mirror))
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
    fn all_pairs_and_a_comment() {
        let scene = "2 15 1 1 1 1 # upper # 0 1 1 1  0 0 -3 1  0 0 0 -1\n";
        assert_eq!(found(scene), ["W304 1:8"]);
        assert_eq!(
            fixed(scene),
            "2 15 1 0.5 0.5 0.5 # upper # 0.5 1 0.5 0.5  0.5 0.5 -3 0.5  0.5 0.5 0.5 -1\n"
        );
    }
}
