//! W303: a rotation matrix that does more than turn.

use crate::diagnostics::{Applicability, Code, Diagnostic, Edit, Fix, Value};
use crate::geometry::Matrix;
use crate::lint::Context;
use crate::lint::spelling::spelled;
use crate::scene::record::Params;
use crate::syntax::Item;
use crate::syntax::table::RecordKind;

type Matrix3 = [[f64; 3]; 3];

/// Largest difference between an entry and that of the nearest rotation; the language has the same bound. Six decimals
/// are what a hand-written matrix has.
const TOLERANCE: f64 = 1e-6;

/// Decimals written by the fix: enough to be far below [`TOLERANCE`].
const DECIMALS: i32 = 12;

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    for item in &context.document.items {
        if let Item::Record(record) = item
            && record.kind == RecordKind::RotationMatrix
        {
            check_record(&Params::new(context.document, context.text, record), out);
        }
    }
}

fn check_record(p: &Params, out: &mut Vec<Diagnostic>) {
    let m = Matrix::from_rows(&p.numbers(0));
    if is_plainly_a_rotation(&m) {
        return;
    }
    // The resolver reports matrices with another last row, and singular ones.
    if m.0[3] != [0.0, 0.0, 0.0, 1.0] || m.is_singular() || m.inverse().is_none() {
        return;
    }
    let linear: Matrix3 = std::array::from_fn(|i| std::array::from_fn(|j| m.0[i][j]));
    let nearest = nearest_orthogonal(&linear);
    let moved = |n: &Matrix3| {
        (0..9).fold(0.0f64, |d, k| {
            d.max((n[k / 3][k % 3] - linear[k / 3][k % 3]).abs())
        })
    };
    let mirrors = m.orientation() < 0;
    let distance = nearest.as_ref().map_or(f64::INFINITY, moved);
    if distance <= TOLERANCE && !mirrors {
        return;
    }
    let mut finding = deed(
        Diagnostic::new(Code::W303, p.span_of(0, 16)),
        &linear,
        mirrors,
    );
    if let (Some(n), false) = (&nearest, mirrors) {
        finding = finding.fix(Fix {
            title: "fix",
            values: Vec::new(),
            // Even where it only completes digits, a pixel on an edge may change.
            applicability: Applicability::Unsafe,
            edits: edits(p, &linear, n),
        });
    }
    out.push(finding);
}

/// Whether a quick test proves that a matrix is a rotation. If the scalar products of the columns differ from those of
/// the unit vectors by at most ε, the singular values are within 3ε/2 of 1, and the entries within 3ε/2 of those of the
/// nearest rotation.
fn is_plainly_a_rotation(m: &Matrix) -> bool {
    let column = |j: usize| [m.0[0][j], m.0[1][j], m.0[2][j]];
    let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let [x, y, z] = [0, 1, 2].map(column);
    let across = [
        x[1] * y[2] - x[2] * y[1],
        x[2] * y[0] - x[0] * y[2],
        x[0] * y[1] - x[1] * y[0],
    ];
    let is = |product: f64, meant: f64| (product - meant).abs() <= TOLERANCE / 10.0;
    m.0[3] == [0.0, 0.0, 0.0, 1.0]
        && [x, y, z].iter().all(|v| is(dot(*v, *v), 1.0))
        && [(x, y), (x, z), (y, z)]
            .iter()
            .all(|(a, b)| is(dot(*a, *b), 0.0))
        && dot(across, z) > 0.0
}

/// Adds to the finding what the matrix does besides turning.
fn deed(finding: Diagnostic, m: &Matrix3, mirrors: bool) -> Diagnostic {
    let column = |j: usize| [m[0][j], m[1][j], m[2][j]];
    let length = |v: [f64; 3]| v[0].hypot(v[1]).hypot(v[2]);
    let lengths = [0, 1, 2].map(|j| length(column(j)));
    let skew = [(0, 1), (0, 2), (1, 2)].into_iter().any(|(i, j)| {
        let (a, b) = (
            column(i).map(|x| x / lengths[i]),
            column(j).map(|x| x / lengths[j]),
        );
        (a[0] * b[0] + a[1] * b[1] + a[2] * b[2]).abs() > TOLERANCE
    });
    let scales = lengths.iter().any(|l| (l - 1.0).abs() > TOLERANCE);
    let mut deeds = Vec::new();
    if mirrors {
        deeds.push("mirrors");
    }
    if scales {
        deeds.push("scales");
    }
    if skew {
        deeds.push("skews");
    }
    if deeds.is_empty() {
        deeds.push("rounded");
    }
    // As many digits as it takes to see the difference.
    let [x, y, z] = lengths.map(|l| {
        format!("{l:.7}")
            .trim_end_matches('0')
            .trim_end_matches('.')
            .to_owned()
    });
    (finding.with("deeds", Value::Phrases(deeds)))
        .with("x", Value::Decimal(x))
        .with("y", Value::Decimal(y))
        .with("z", Value::Decimal(z))
}

/// The orthogonal matrix nearest to an invertible one, its factor in the polar decomposition:
/// Newton's iteration X ← (γX + X⁻ᵀ/γ)/2 with the scaling γ = √(‖X⁻¹‖/‖X‖) (Higham, Functions of
/// Matrices, section 8.6). `None` where it does not settle.
fn nearest_orthogonal(m: &Matrix3) -> Option<Matrix3> {
    /// Scaled iterations settle within nine steps in double precision, whatever the condition
    /// (Higham, section 8.9).
    const STEPS: usize = 16;
    /// The iteration has converged if a step moves no entry by more than this: the next step would move entries by the
    /// square of it.
    const SETTLED: f64 = 1e-13;
    let norm = |m: &Matrix3| m.iter().flatten().fold(0.0f64, |s, x| s.hypot(*x));
    let size = norm(m);
    let mut x = m.map(|row| row.map(|e| e / size));
    for _ in 0..STEPS {
        let mut wide = Matrix::IDENTITY;
        for (to, from) in wide.0.iter_mut().zip(&x) {
            to[..3].copy_from_slice(from);
        }
        let back = wide.inverse()?.0;
        // The iteration needs the transpose of the inverse.
        let back: Matrix3 = std::array::from_fn(|i| std::array::from_fn(|j| back[j][i]));
        let scale = (norm(&back) / norm(&x)).sqrt();
        let next: Matrix3 = std::array::from_fn(|i| {
            std::array::from_fn(|j| (scale * x[i][j] + back[i][j] / scale) / 2.0)
        });
        let step = (0..9).fold(0.0f64, |d, k| {
            d.max((next[k / 3][k % 3] - x[k / 3][k % 3]).abs())
        });
        x = next;
        if !step.is_finite() {
            return None;
        }
        if step <= SETTLED {
            return Some(x);
        }
    }
    None
}

fn edits(p: &Params, written: &Matrix3, nearest: &Matrix3) -> Vec<Edit> {
    let unit = 10f64.powi(DECIMALS);
    (0..9)
        .map(|k| (k / 3, k % 3))
        .map(|(i, j)| (i, j, (nearest[i][j] * unit).round() / unit))
        .filter(|&(i, j, x)| x != written[i][j])
        .map(|(i, j, x)| Edit {
            span: p.span_of(4 * i + j, 1),
            text: spelled(x),
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    proptest::proptest! {
        /// A matrix that passes without further ado is within the tolerance of the nearest rotation.
        #[test]
        fn what_is_plainly_a_rotation_is_one(
            angles in proptest::array::uniform3(-180.0..180.0),
            off in proptest::array::uniform9(-1.0..1.0),
            size in -9.0..-5.0,
            mirror in proptest::bool::ANY,
        ) {
            let mut m = (0..3).fold(Matrix::IDENTITY, |m, axis| {
                m.after(&Matrix::rotation(angles[axis], axis))
            });
            for (k, x) in off.iter().enumerate() {
                m.0[k / 3][k % 3] += x * 10f64.powf(size);
            }
            if mirror {
                m.0.swap(0, 1);
            }
            if is_plainly_a_rotation(&m) {
                let linear: Matrix3 = std::array::from_fn(|i| std::array::from_fn(|j| m.0[i][j]));
                let nearest = nearest_orthogonal(&linear).unwrap();
                let off = (0..9).map(|k| (nearest[k / 3][k % 3] - linear[k / 3][k % 3]).abs());
                proptest::prop_assert!(off.fold(0.0, f64::max) <= TOLERANCE);
                proptest::prop_assert!(m.orientation() > 0 && !m.is_singular());
            }
        }
    }

    #[test]
    fn the_polar_factor_is_orthogonal_and_undoes_a_stretch() {
        // Rows of a rotation (3-4-5 triangle) times a stretch S = diag(1e6, 1, 1e-6): R·S has the
        // polar factor R.
        let r = [[0.6, -0.8, 0.0], [0.8, 0.6, 0.0], [0.0, 0.0, 1.0]];
        let s = [1e6, 1.0, 1e-6];
        let m: Matrix3 = std::array::from_fn(|i| std::array::from_fn(|j| r[i][j] * s[j]));
        let u = nearest_orthogonal(&m).unwrap();
        for k in 0..9 {
            // The condition 1e12 costs twelve of sixteen digits at most.
            assert!((u[k / 3][k % 3] - r[k / 3][k % 3]).abs() < 1e-4, "{u:?}");
        }
    }
}
