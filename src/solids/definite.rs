//! The signs that a quadratic form xᵀQx takes, with x = (x, y, z, 1): exactly, by eliminating one variable after the
//! other.

use dashu_int::IBig;

use crate::geometry::exact::{sign, whole};

/// The kind of the set xᵀQx ≤ 0.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum QuadricSet {
    /// The form is positive everywhere: no point at all.
    Empty,
    /// The form is nowhere positive, and not zero everywhere: all of space, with no surface.
    Full,
    /// The form is nowhere negative, and zero on a flat of this many dimensions, 0 to 2.
    Flat(u32),
    /// All 16 numbers cancel: the form is zero everywhere.
    Zero,
    /// A set with an inside and an outside.
    Other,
}

type ExactQuadric = [[IBig; 4]; 4];

/// Twice the symmetric part of a matrix, in whole numbers: all entries are scaled by one power of two.
fn form(q: &[f64; 16]) -> ExactQuadric {
    let q = whole(*q);
    std::array::from_fn(|i| std::array::from_fn(|j| &q[4 * i + j] + &q[4 * j + i]))
}

/// Whether xᵀQx ≤ 0 is an ellipsoid, a point or nothing: its square part is positive definite.
pub fn is_ellipsoid(q: &[f64; 16]) -> bool {
    matches!(lowest(form(q)), Some((_, 3)))
}

/// The kind of the quadric with these 16 numbers, row by row.
pub fn judge(q: &[f64; 16]) -> QuadricSet {
    let diagonal = [0, 5, 10, 15].map(|i| q[i]);
    // Most quadrics have an inside and an outside: the form goes up along one axis, and down along another one.
    if diagonal.iter().any(|&x| x > 0.0) && diagonal.iter().any(|&x| x < 0.0) {
        return QuadricSet::Other;
    }
    let form = form(q);
    if form.iter().flatten().all(IBig::is_zero) {
        return QuadricSet::Zero;
    }
    let below = diagonal.iter().any(|&x| x < 0.0);
    let form = if below {
        form.map(|row| row.map(|x| -x))
    } else {
        form
    };
    match (lowest(form), below) {
        (Some((1, _)), false) => QuadricSet::Empty,
        (Some((0, rank)), false) => QuadricSet::Flat(3 - rank),
        // Where the form is zero on a flat, the object lies on both sides of the flat.
        (Some((0.., _)), true) => QuadricSet::Full,
        _ => QuadricSet::Other,
    }
}

/// The sign of the least value of a form that is convex, and the rank of its square part; `None` for
/// forms that have no least value.
fn lowest(mut s: ExactQuadric) -> Option<(i32, u32)> {
    let mut left = vec![0usize, 1, 2];
    let mut rank = 0;
    // Every number is a minor of the form (Bareiss 1968): a number of the rest of the form times the product of the
    // coefficients of the completed squares, all of which are positive.
    let mut before = IBig::ONE;
    while let Some(at) = left.iter().position(|&i| sign(&s[i][i]) > 0) {
        // Completing the square in this variable.
        let pivot = left.swap_remove(at);
        rank += 1;
        let others: Vec<usize> = left.iter().copied().chain([3]).collect();
        let by = s[pivot].clone();
        for &i in &others {
            for &j in &others {
                s[i][j] = (&by[pivot] * &s[i][j] - &by[i] * &by[j]) / &before;
            }
        }
        before = by[pivot].clone();
    }
    // The rest must not depend on any variable that is left.
    let constant = |&i: &usize| left.iter().chain(&[3]).all(|&j| s[i][j].is_zero());
    left.iter().all(constant).then(|| (sign(&s[3][3]), rank))
}

#[cfg(test)]
mod tests {
    use super::*;
    use dashu_ratio::RBig;
    use proptest::prelude::*;

    fn diagonal(d: [f64; 4]) -> [f64; 16] {
        let mut q = [0.0; 16];
        (0..4).for_each(|i| q[5 * i] = d[i]);
        q
    }

    #[test]
    fn canonical_forms() {
        assert_eq!(judge(&diagonal([1.0, 1.0, 1.0, 1.0])), QuadricSet::Empty);
        assert_eq!(judge(&diagonal([1.0, 1.0, 1.0, -1.0])), QuadricSet::Other);
        assert_eq!(judge(&diagonal([1.0, 0.0, 0.0, 1e-300])), QuadricSet::Empty);
        assert_eq!(judge(&diagonal([-1.0, 0.0, -2.0, -1.0])), QuadricSet::Full);
        assert_eq!(judge(&diagonal([1.0, 1.0, 1.0, 0.0])), QuadricSet::Flat(0));
        assert_eq!(judge(&diagonal([1.0, 0.0, 2.0, 0.0])), QuadricSet::Flat(1));
        assert_eq!(judge(&diagonal([0.0, 0.1, 0.0, 0.0])), QuadricSet::Flat(2));
        assert_eq!(judge(&diagonal([1.0, 1.0, -1.0, 5.0])), QuadricSet::Other);
        assert_eq!(judge(&[0.0; 16]), QuadricSet::Zero);
    }

    #[test]
    fn turned_round_a_flat_fills_space() {
        for d in [
            [-1.0, -1.0, -1.0, 0.0],
            [-1.0, 0.0, -2.0, 0.0],
            [0.0, -0.1, 0.0, 0.0],
        ] {
            assert_eq!(judge(&diagonal(d)), QuadricSet::Full, "{d:?}");
        }
        // −(x − 2)² + e, with e none, half an ulp of 4 either way.
        let moved = |c: f64| {
            let mut q = diagonal([-1.0, 0.0, 0.0, c]);
            (q[3], q[12]) = (2.0, 2.0);
            q
        };
        assert_eq!(judge(&moved(-4.0)), QuadricSet::Full);
        assert_eq!(judge(&moved((-4.0f64).next_down())), QuadricSet::Full);
        assert_eq!(judge(&moved((-4.0f64).next_up())), QuadricSet::Other);
        // −(x − 0.1)²: 0.1·0.1 is rounded, downwards or upwards.
        let odd = |square: f64| {
            let mut q = diagonal([-1.0, 0.0, 0.0, -square]);
            (q[3], q[12]) = (0.1, 0.1);
            q
        };
        let square: f64 = 0.1 * 0.1;
        let [low, high] = match 0.1f64.mul_add(0.1, -square) < 0.0 {
            true => [square.next_down(), square],
            false => [square, square.next_up()],
        };
        assert_eq!(
            [low, high].map(|s| judge(&odd(s))),
            [QuadricSet::Other, QuadricSet::Full]
        );
        // −x² + y, −x² + z²: surfaces.
        let mut bowl = diagonal([-1.0, 0.0, 0.0, 0.0]);
        (bowl[7], bowl[13]) = (0.5, 0.5);
        assert_eq!(judge(&bowl), QuadricSet::Other);
        assert_eq!(judge(&diagonal([-1.0, 0.0, 1.0, 0.0])), QuadricSet::Other);
    }

    #[test]
    fn at_the_edge_it_is_right() {
        // (x − 0.1)² + e: 0.1 is no double, so that the square's constant is not the square of 0.1.
        let moved = |e: f64| {
            let mut q = diagonal([1.0, 0.0, 0.0, 0.1 * 0.1 + e]);
            (q[3], q[12]) = (-0.1, -0.1);
            q
        };
        let rounded_up = 0.1f64.mul_add(0.1, -(0.1 * 0.1)) < 0.0;
        let as_it_is = if rounded_up {
            QuadricSet::Empty
        } else {
            QuadricSet::Other
        };
        assert_eq!(judge(&moved(0.0)), as_it_is);
        assert_eq!(judge(&moved(1e-16)), QuadricSet::Empty);
        assert_eq!(judge(&moved(-1e-16)), QuadricSet::Other);
        // (x − 2)² exactly, a plane; and with an asymmetric matrix of the same symmetric part.
        let mut plane = diagonal([1.0, 0.0, 0.0, 4.0]);
        plane[3] = -4.0;
        assert_eq!(judge(&plane), QuadricSet::Flat(2));
        // (x + y)² + z + 1 has points wherever z < −1.
        let mut trough = diagonal([1.0, 1.0, 0.0, 1.0]);
        (trough[1], trough[4], trough[14]) = (1.0, 1.0, 1.0);
        assert_eq!(judge(&trough), QuadricSet::Other);
        trough[14] = 0.0;
        assert_eq!(judge(&trough), QuadricSet::Empty);
    }

    #[test]
    fn extreme_numbers_decide_nothing_wrongly() {
        for scale in [1e-320, 1e-300, 1e300, f64::MAX] {
            assert_eq!(judge(&diagonal([scale; 4])), QuadricSet::Empty, "{scale}");
            let ball = diagonal([scale, scale, scale, -scale]);
            assert_eq!(judge(&ball), QuadricSet::Other, "{scale}");
        }
        // x² + 2·1e-200·x: negative between −2e-200 and 0, though the square underflows.
        let mut q = diagonal([1.0, 0.0, 0.0, 0.0]);
        q[3] = 2e-200;
        assert_eq!(judge(&q), QuadricSet::Other);
    }

    /// The kind of a form by its minors (Sylvester's criterion: nowhere negative where no principal minor is), in
    /// fractions.
    fn by_minors(q: &[f64; 16]) -> QuadricSet {
        let exact = |x: f64| RBig::try_from(x).unwrap();
        let entry = |i: usize, j: usize| exact(q[4 * i + j]) + exact(q[4 * j + i]);
        let form: Vec<Vec<RBig>> = (0..4)
            .map(|i| (0..4).map(|j| entry(i, j)).collect())
            .collect();
        let minor = |rows: usize, columns: usize, turned: bool| {
            let of = |set: usize| (0..4).filter(move |i| set >> i & 1 == 1);
            let row = |i: usize| of(columns).map(|j| form[i][j].clone()).collect();
            let minor: Vec<Vec<RBig>> = of(rows).map(row).collect();
            let odd = turned && minor.len() % 2 == 1;
            let x = determinant(&minor);
            if odd { -x } else { x }
        };
        let rank = |variables: usize| {
            let sets = || (1..16usize).filter(move |set| set & !variables == 0);
            let zero = |a: usize, b: usize| minor(a, b, false) == RBig::ZERO;
            let pairs = sets().flat_map(|a| sets().map(move |b| (a, b)));
            let same = pairs.filter(|(a, b)| a.count_ones() == b.count_ones());
            let full = same.filter(|&(a, b)| !zero(a, b));
            full.map(|(a, _)| a.count_ones()).max().unwrap_or(0)
        };
        let nowhere = |turned: bool| (1..16).all(|set| minor(set, set, turned) >= RBig::ZERO);
        match (nowhere(false), nowhere(true)) {
            (true, true) => QuadricSet::Zero,
            (false, true) => QuadricSet::Full,
            // It is zero where its gradient is: at a point of space unless the last coordinate of all
            // of these is zero.
            (true, false) if rank(15) > rank(7) => QuadricSet::Empty,
            (true, false) => QuadricSet::Flat(3 - rank(7)),
            (false, false) => QuadricSet::Other,
        }
    }

    fn determinant(m: &[Vec<RBig>]) -> RBig {
        if m.is_empty() {
            return RBig::ONE;
        }
        (0..m.len()).fold(RBig::ZERO, |sum, j| {
            let rest: Vec<Vec<RBig>> = (m[1..].iter())
                .map(|row| [&row[..j], &row[j + 1..]].concat())
                .collect();
            let term = &m[0][j] * determinant(&rest);
            if j % 2 == 0 { sum + term } else { sum - term }
        })
    }

    /// AᵀDA: a form that is what the signs of D are, seen obliquely; some of it is then rounded.
    fn oblique() -> impl Strategy<Value = [f64; 16]> {
        let plain = prop::collection::vec((-3..4i32).prop_map(f64::from), 16);
        let entries = prop_oneof![plain, prop::collection::vec(-1.0..1.0f64, 16)];
        let square = prop::sample::select(vec![1.0, 1.0, 1.0, 0.0, 0.5, 1e-9, -1e-9, -1.0]);
        let squares = prop::collection::vec(square, 4);
        let nudge = (
            0..16usize,
            prop::sample::select(vec![0.0, 0.0, 1e-16, -1e-16, -1e-3]),
        );
        let all = (entries, squares, any::<bool>(), nudge);
        all.prop_map(|(a, d, turned, (at, nudge))| {
            let mut q: [f64; 16] = std::array::from_fn(|k| {
                let (i, j) = (k / 4, k % 4);
                (0..4).map(|r| d[r] * a[4 * r + i] * a[4 * r + j]).sum()
            });
            q[at] += nudge;
            if turned { q.map(|x| -x) } else { q }
        })
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(2000))]
        #[test]
        fn oblique_forms(q in oblique()) {
            prop_assert_eq!(judge(&q), by_minors(&q));
        }
    }

    /// Random forms are of each kind many times.
    #[test]
    fn oblique_forms_are_of_all_kinds() {
        use proptest::strategy::ValueTree;
        let mut runner = proptest::test_runner::TestRunner::deterministic();
        let mut kinds = std::collections::BTreeMap::new();
        for _ in 0..1000 {
            let q = oblique().new_tree(&mut runner).unwrap().current();
            *kinds.entry(format!("{:?}", judge(&q))).or_insert(0) += 1;
        }
        for kind in ["Empty", "Full", "Flat(0)", "Flat(1)", "Other"] {
            assert!(kinds.get(kind).is_some_and(|&n| n > 0), "{kinds:?}");
        }
    }
}
