//! Random lines that come close to a shape in every awkward way.

use super::rng::Rng;
use super::shapes::{Spread, Target, cross};
use super::truth::length;
use zpg::internals::geometry::Matrix;
use zpg::internals::geometry::affine::Affine;

/// A line in the space it is traced in, and how that is mapped into the shape's space.
#[derive(Debug, Clone)]
pub struct Case {
    pub origin: [f64; 3],
    pub direction: [f64; 3],
    /// The rows of the map into the shape's space, with the offsets last.
    pub map: Option<[[f64; 4]; 3]>,
    /// Whether the line is like those of a picture, not made to be awkward.
    pub plain: bool,
}

impl Case {
    /// How far from the shape's origin the terms of the map reach for a point; 0 without a map.
    pub fn terms(&self, p: [f64; 3]) -> f64 {
        let rows = self.map.unwrap_or_default();
        length(rows.map(|r| {
            let sum: f64 = (0..3).map(|j| (r[j] * p[j]).abs()).sum();
            sum + r[3].abs()
        }))
    }

    /// The map with the numbers of a kind.
    pub fn affine<R: zpg::internals::geometry::number::Real>(&self) -> Option<Affine<R>> {
        self.map
            .map(|[x, y, z]| Affine::new(&Matrix([x, y, z, [0.0, 0.0, 0.0, 1.0]])))
    }
}

/// How far away, in sizes of the shape, lines begin: powers of ten.
const AWAY: (f64, f64) = (-1.0, 8.0);

/// How far from grazing lines are moved, in sizes of the shape: powers of ten.
const ASIDE: (f64, f64) = (-17.0, -3.0);

fn plus(a: [f64; 3], b: [f64; 3], times: f64) -> [f64; 3] {
    std::array::from_fn(|i| a[i] + times * b[i])
}

fn unit(v: [f64; 3]) -> [f64; 3] {
    let size = length(v);
    if size > 0.0 {
        v.map(|x| x / size)
    } else {
        [1.0, 0.0, 0.0]
    }
}

pub fn case(target: &Target, spread: Spread, rng: &mut Rng) -> Case {
    let away = target.size * rng.decade(AWAY.0, AWAY.1);
    let (origin, direction, plain) = match rng.below(20) {
        // Past or through the shape, as the rays of a picture are.
        0..5 => {
            let through = plus(target.centre, target.within(1.2, rng), 1.0);
            let d = rng.direction();
            (plus(through, d, -away), d, true)
        }
        // At a point of the surface, from anywhere.
        5..8 => {
            let (p, _) = target.surface(rng);
            let d = rng.direction();
            (plus(p, d, -away), d, false)
        }
        // Along the surface.
        8..13 => {
            let (p, n) = target.surface(rng);
            let mut d = unit(cross(n, rng.direction()));
            if rng.chance(0.2) {
                d = unit(plus(d, n, rng.sign() * rng.decade(-16.0, -3.0)));
            }
            let aside = if rng.chance(0.2) {
                0.0
            } else {
                rng.sign() * target.size * rng.decade(ASIDE.0, ASIDE.1)
            };
            (plus(plus(p, n, aside), d, -away), d, false)
        }
        // Parallel to an axis.
        13 | 14 => {
            let (p, _) = target.surface(rng);
            let axis = rng.below(3);
            let mut d = [0.0; 3];
            d[axis] = rng.sign();
            (plus(p, d, -away), d, false)
        }
        // Through an apex, a rim, a seam, a vertex, the centre, or two of them.
        15..18 => {
            let mut places = target.anchors.clone();
            places.push(target.centre);
            let p = *rng.pick(&places);
            let q = *rng.pick(&places);
            let choice = rng.below(4);
            let d = if choice == 0 && p != q {
                plus(q, p, -1.0)
            } else if choice == 1 && !target.directions.is_empty() {
                *rng.pick(&target.directions)
            } else if choice == 2 {
                let mut d = [0.0; 3];
                d[rng.below(3)] = rng.sign();
                d
            } else {
                rng.direction()
            };
            let d = if choice == 0 {
                d.map(|x| x / target.size)
            } else {
                d
            };
            (plus(p, d, -away), d, false)
        }
        // Touching, or just not, on numbers that are exact.
        _ => {
            let axis = rng.below(3);
            let mut o: [f64; 3] = std::array::from_fn(|i| *rng.pick(&target.marks[i]));
            let across = &mut o[(axis + 1) % 3];
            match rng.below(4) {
                _ if *across == 0.0 => {}
                0 => *across = across.next_up(),
                1 => *across = across.next_down(),
                _ => {}
            }
            let mut d = [0.0; 3];
            d[axis] = rng.sign();
            o[axis] -= d[axis] * away;
            // At times on a diagonal through the same point.
            if rng.chance(0.2) {
                let other = (axis + 1 + rng.below(2)) % 3;
                d[other] = rng.sign();
                o[other] -= d[other] * away;
            }
            (o, d, false)
        }
    };
    let case = Case {
        origin,
        direction,
        map: None,
        plain,
    };
    let mut case = if rng.chance(0.3) {
        placed(case, target, spread, rng)
    } else {
        case
    };
    // The direction's length is nobody's business.
    let scale = match rng.below(3) {
        0 => 1.0,
        1 => rng.decade(-6.0, 6.0),
        _ => 2f64.powi(rng.below(41) as i32 - 20),
    };
    case.direction = case.direction.map(|x| x * scale);
    case
}

/// The line out in the world, and the map that brings it back, but for rounding: a rotation, a
/// scaling by 10^±3 that may differ between the axes by a factor of 4, or of 10⁸ where all is stretched, and a
/// translation of up to 10³ sizes. One map in four is exact.
fn placed(case: Case, target: &Target, spread: Spread, rng: &mut Rng) -> Case {
    let exact = rng.chance(0.25);
    let (rows, scales, shift) = if exact {
        let turn = rng.below(3);
        let rows: [[f64; 3]; 3] = std::array::from_fn(|i| {
            let mut row = [0.0; 3];
            row[(i + turn) % 3] = rng.sign();
            row
        });
        let scale = 2f64.powi(rng.below(21) as i32 - 10);
        (
            rows,
            [scale; 3],
            rng.cube().map(|x| (x * 8.0).round() * scale),
        )
    } else {
        let x = rng.direction();
        let y = unit(cross(x, rng.direction()));
        let z = cross(x, y);
        let all = rng.decade(-3.0, 3.0);
        let each = rng.chance(0.3);
        let scales = [0; 3].map(|_| match spread {
            Spread::Stretched => all * rng.decade(-4.0, 4.0),
            Spread::Usual if each => all * rng.range(0.5, 2.0),
            Spread::Usual => all,
        });
        let far = all * target.size * rng.decade(-1.0, 3.0);
        ([x, y, z], scales, rng.cube().map(|x| x * far))
    };
    // Out: Rᵀ S p + shift, where R has these rows; back: S⁻¹ R (p − shift).
    let out = |v: [f64; 3]| -> [f64; 3] {
        std::array::from_fn(|j| (0..3).map(|i| rows[i][j] * scales[i] * v[i]).sum())
    };
    let map = std::array::from_fn(|i| {
        let back = |j: usize| rows[i][j] / scales[i];
        let offset: f64 = (0..3).map(|j| back(j) * shift[j]).sum();
        [back(0), back(1), back(2), -offset]
    });
    Case {
        origin: plus(out(case.origin), shift, 1.0),
        direction: out(case.direction),
        map: Some(map),
        ..case
    }
}
