use super::*;
use crate::geometry::line::{Line, Traced};

/// Random numbers (splitmix64; Steele, Lea and Flood, 2014).
pub(crate) struct Random(pub u64);

impl Random {
    pub(crate) fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    pub(crate) fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * (self.next() >> 11) as f64 / (1u64 << 53) as f64
    }

    /// A point of the cube (−size … size)³.
    pub(crate) fn point(&mut self, size: f64) -> Vec3 {
        Vec3([0; 3].map(|_| self.within(-size, size)))
    }

    /// Lengths from 10^low to 10^high.
    pub(crate) fn length(&mut self, low: f64, high: f64) -> f64 {
        10f64.powf(self.within(low, high))
    }
}

/// The crossing of a line with a triangle by solving for the barycentric weights (Möller and
/// Trumbore, 1997) in double-double: t, and the least of the three weights.
pub(crate) fn solve(line: &Line, [a, b, c]: [Vec3<Dd>; 3]) -> Option<(Dd, Dd)> {
    let (o, d) = (lift::<Dd>(line.origin), lift::<Dd>(line.direction));
    let (e1, e2, s) = (b - a, c - a, o - a);
    let p = d.cross(e2);
    let determinant = e1.dot(p);
    if determinant == Dd::ZERO {
        return None;
    }
    let q = s.cross(e1);
    let (v, w) = (s.dot(p) / determinant, d.dot(q) / determinant);
    let least = v.min(w).min(Dd::ONE - v - w);
    Some((e2.dot(q) / determinant, least))
}

/// Lines that no formula likes: components from nothing to everything.
pub(crate) fn wild_line<R: Traced>(random: &mut Random) -> Line<R> {
    let mut component = || match random.next() % 8 {
        0 => 0.0,
        1 => 1.0,
        2 => 1e308 * random.within(-1.0, 1.0),
        3 => 1e-320 * random.within(-1.0, 1.0),
        4 => -f64::MIN_POSITIVE,
        5 => random.within(-1.0, 1.0) * random.length(-300.0, 300.0),
        _ => random.within(-1.0, 1.0),
    };
    let origin = Vec3([0; 3].map(|_| component()));
    let direction = Vec3([0; 3].map(|_| component()));
    Line::new(lift(origin), lift(direction))
}

/// Swapping the ends of an edge changes the sign of its function and nothing else, and the sign is
/// that of the exact value: here of x·y − y·x for neighbouring doubles, whose products round to the
/// same number.
#[test]
fn edge_functions_have_exact_signs() {
    let up = 1.0 + f64::EPSILON;
    let at = |x: f64, y: f64| Projected { x, y, depth: 0.0 };
    // (1 + ε)² − (1 + 2ε) · 1 = ε² and both products round to 1 + 2ε.
    let (p, q) = (at(up, 1.0 + 2.0 * f64::EPSILON), at(1.0, up));
    assert_eq!(edge(p, q), f64::EPSILON * f64::EPSILON);
    assert_eq!(edge(q, p), -f64::EPSILON * f64::EPSILON);
    let mut random = Random(1);
    for _ in 0..10_000 {
        let p = at(random.within(-1.0, 1.0), random.within(-1.0, 1.0));
        // On the line through p and the origin, but for rounding.
        let s = random.within(-2.0, 2.0);
        let q = at(p.x * s, p.y * s);
        // The products of doubles are exact in double-double.
        let exact = Dd::of(p.x) * Dd::of(q.y) - Dd::of(p.y) * Dd::of(q.x);
        let sign = |x: f64| x.partial_cmp(&0.0);
        assert_eq!(sign(edge(p, q)), sign(exact.to_f64()));
        assert_eq!(edge(p, q), -edge(q, p));
    }
}
