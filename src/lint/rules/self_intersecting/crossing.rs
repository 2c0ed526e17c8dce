//! Crossings of a profile with itself.

type Point = [f64; 2];

/// A place where a surface runs through itself.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Crossing {
    /// A tube, around the axis of its ring.
    Tube,
    /// Two pieces of a profile, at (x, y). Piece i runs from point i to the next; the piece after the last
    /// runs from the axis to the first point, the one after that from the last point to the axis.
    Pieces {
        pieces: (usize, usize),
        at: [f64; 2],
    },
}

/// Most comparisons of pieces, per piece of the profile, before the search is given up. In a profile whose pieces all
/// overlap in height the number of pairs is the square of the number of pieces.
const COMPARISONS: usize = 32;

/// A crossing of two pieces in their inner points, if there is one for certain. A profile that merely touches itself
/// has none.
pub(super) fn first_crossing(profile: &[Point]) -> Option<Crossing> {
    let (&first, &last) = (profile.first()?, profile.last()?);
    let mut pieces: Vec<(usize, Point, Point)> = (0..profile.len() - 1)
        .map(|i| (i, profile[i], profile[i + 1]))
        .collect();
    if first != last {
        let n = profile.len();
        pieces.push((n - 1, [0.0, first[1]], first));
        pieces.push((n, last, [0.0, last[1]]));
    }
    // A piece on the axis makes no surface.
    pieces.retain(|(_, a, b)| (a[0] > 0.0 || b[0] > 0.0) && a != b);
    let low = |s: &(usize, Point, Point)| s.1[1].min(s.2[1]);
    let high = |s: &(usize, Point, Point)| s.1[1].max(s.2[1]);
    pieces.sort_by(|s, t| low(s).total_cmp(&low(t)));
    // A line sweeps upwards; `open` are the pieces that it may still meet.
    let mut open: Vec<usize> = Vec::new();
    let mut left = COMPARISONS * pieces.len();
    for i in 0..pieces.len() {
        let s = pieces[i];
        left = left.checked_sub(open.len())?;
        open.retain(|&j| high(&pieces[j]) >= low(&s));
        for &j in &open {
            let t = pieces[j];
            if let Some(at) = crossing_point((s.1, s.2), (t.1, t.2)) {
                return Some(Crossing::Pieces {
                    pieces: (s.0.min(t.0), s.0.max(t.0)),
                    at,
                });
            }
        }
        open.push(i);
    }
    None
}

/// The crossing of two pieces in their inner points, if that is certain.
fn crossing_point((a, b): (Point, Point), (c, d): (Point, Point)) -> Option<Point> {
    let (sc, sd) = (side(a, b, c)?, side(a, b, d)?);
    let (sa, sb) = (side(c, d, a)?, side(c, d, b)?);
    if (sc > 0.0) == (sd > 0.0) || (sa > 0.0) == (sb > 0.0) {
        return None;
    }
    let share = sa / (sa - sb);
    Some([0, 1].map(|i| a[i] + (b[i] - a[i]) * share))
}

/// The side of the line a → b that a point is on: positive on the left. `None` where rounding leaves the side open. The
/// bound is that of Shewchuk's adaptive predicate, (3 + 16u)u with u = ε/2, on the sum of the two products' sizes
/// ("Adaptive precision floating-point arithmetic and fast robust geometric predicates", 1997, section 4.3).
fn side(a: Point, b: Point, p: Point) -> Option<f64> {
    const U: f64 = f64::EPSILON / 2.0;
    const BOUND: f64 = (3.0 + 16.0 * U) * U;
    let left = (a[0] - p[0]) * (b[1] - p[1]);
    let right = (a[1] - p[1]) * (b[0] - p[0]);
    let x = left - right;
    (x.abs() > BOUND * (left.abs() + right.abs())).then_some(x)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn touching_is_not_crossing() {
        // A point of the profile on another piece of it, and a piece that goes back on itself.
        assert!(
            first_crossing(&[[0.0, 0.0], [2.0, 0.0], [1.0, 2.0], [1.0, 0.0], [0.5, 3.0]]).is_none()
        );
        assert!(
            first_crossing(&[
                [1.0, 0.0],
                [1.0, 2.0],
                [1.0, 1.0],
                [2.0, 1.0],
                [2.0, 0.0],
                [1.0, 0.0]
            ])
            .is_none()
        );
        assert!(first_crossing(&[[0.0, 0.0], [0.0, 2.0], [0.0, 1.0], [1.0, 1.0]]).is_none());
    }

    #[test]
    fn through_a_closing_disc() {
        // The vase's foot reaches below its closed bottom.
        let c = first_crossing(&[[2.0, 0.0], [3.0, 2.0], [1.0, -1.0], [0.0, -1.0]]).unwrap();
        let Crossing::Pieces { pieces, at } = c else {
            panic!("{c:?}")
        };
        assert_eq!(pieces, (1, 3));
        assert!((at[0] - 5.0 / 3.0).abs() < 1e-15 && at[1].abs() < 1e-15);
    }

    #[test]
    fn long_profiles_are_quick() {
        // A vase of many points, and a comb whose teeth all overlap in height.
        let vase: Vec<Point> = (0..200_000)
            .map(|i| [2.0 + (f64::from(i) / 1e4).sin(), f64::from(i)])
            .collect();
        assert!(first_crossing(&vase).is_none());
        let comb: Vec<Point> = (0..200_000)
            .map(|i| [f64::from(i) + 1.0, f64::from(i % 2)])
            .collect();
        assert!(first_crossing(&comb).is_none());
    }
}
