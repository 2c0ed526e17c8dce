//! Lines that pass spheres, boxes, planes and rectangles so closely that rounding decides: whatever doubles are sure
//! of, double-double finds as well.

mod by_hand;

use super::*;
use crate::geometry::Matrix;
use crate::geometry::affine::Affine;
use crate::geometry::dd::Dd;
use crate::geometry::exponent::shifted;
use crate::geometry::number::Real;
use std::array::from_fn;

/// The unit roundoff of doubles.
const U: f64 = f64::EPSILON / 2.0;

/// Steele, Lea and Flood's SplitMix64.
struct Random(u64);

impl Random {
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    fn within(&mut self, from: f64, to: f64) -> f64 {
        from + (to - from) * ((self.bits() >> 11) as f64 / (1u64 << 53) as f64)
    }

    fn below(&mut self, n: usize) -> usize {
        (self.bits() % n as u64) as usize
    }

    fn power(&mut self, from: f64, to: f64) -> f64 {
        10f64.powf(self.within(from, to))
    }

    fn sign(&mut self) -> f64 {
        if self.bits() & 1 == 0 { 1.0 } else { -1.0 }
    }

    fn unit(&mut self) -> Vec3 {
        loop {
            let v = Vec3::new(
                self.within(-1.0, 1.0),
                self.within(-1.0, 1.0),
                self.within(-1.0, 1.0),
            );
            if (0.01..1.0).contains(&v.dot(v)) {
                return v.unit();
            }
        }
    }

    /// A number between zero and a few times the rounding of numbers of this size, with either sign.
    fn hair(&mut self, size: f64) -> f64 {
        match self.below(4) {
            0 => 0.0,
            _ => self.sign() * size * self.power(-17.0, -12.0),
        }
    }
}

fn line<R: Traced>(o: Vec3, d: Vec3) -> Line<R> {
    Line::new(o.cast(), d.cast())
}

/// The crossings, which are finite, ascend and, for a solid, alternate; and their places.
fn meet<R: Traced>(shape: &Primitive, line: &Line<R>) -> Roots<R> {
    let mut roots = Roots::default();
    let kernel = shape.intersect::<R>();
    kernel.crossings(line, &mut roots);
    assert!(roots.list.windows(2).all(|w| w[0].t < w[1].t), "{roots:?}");
    for &root in &roots.list {
        assert!(root.t.is_finite());
        let at = kernel.locate(line, root);
        // At the very end of the numbers there may be none for the place.
        let at_the_end = !(line.at(root.t) * R::of(8.0)).is_finite();
        let placed = at.point.is_finite() && at.error.is_finite();
        assert!(placed || at_the_end, "{at:?}");
        assert!(at.normal.is_finite() && at.normal.any(), "{at:?}");
    }
    if matches!(shape, Primitive::Sphere(_) | Primitive::Cuboid(_)) {
        assert!(!roots.inside && roots.list.len().is_multiple_of(2));
    } else {
        assert!(roots.list.len() < 2);
    }
    roots
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Kind {
    Sphere,
    Cuboid,
    HalfSpace,
    Plane,
    Rectangle,
}

const KINDS: [Kind; 5] = [
    Kind::Sphere,
    Kind::Cuboid,
    Kind::HalfSpace,
    Kind::Plane,
    Kind::Rectangle,
];

/// A shape, its size, and a line that all but touches it: an origin and a direction.
struct Case {
    geometry: Geometry,
    size: f64,
    origin: Vec3,
    direction: Vec3,
}

impl Case {
    fn shape(&self) -> Primitive {
        Primitive::new(&self.geometry)
    }
}

/// Perpendicular to n, about.
fn across(r: &mut Random, n: Vec3) -> Vec3 {
    n.cross(r.unit()).unit()
}

/// A close call; `reach` is the greatest distance of origins in powers of ten of the size.
fn close_call(r: &mut Random, kind: Kind, reach: f64) -> Case {
    let size = r.power(-6.0, 6.0);
    let away = size * r.power(-1.0, reach);
    let (geometry, target, mut d) = match kind {
        Kind::Sphere => {
            let centre = r.unit() * (size * r.power(-2.0, 2.0));
            let n = r.unit();
            let target = centre + n * (size + r.hair(size + 1e-2 * away));
            let centre = centre.0;
            (
                Geometry::Sphere {
                    centre,
                    radius: size,
                },
                target,
                across(r, n),
            )
        }
        Kind::Cuboid => {
            let min = r.unit() * (size * r.power(-1.0, 1.0));
            let max = min + Vec3::new(1.0, r.power(-2.0, 0.0), r.within(0.1, 1.0)) * size;
            // On an edge, seen from outside, or in the plane of a face.
            let corner: [f64; 3] = from_fn(|i| if r.below(2) == 0 { min[i] } else { max[i] });
            let mut target = Vec3(corner);
            let axis = r.below(3);
            target[axis] = r.within(min[axis], max[axis]);
            let mut d = r.unit();
            if r.below(2) == 0 {
                d[(axis + 1) % 3] = if r.below(2) == 0 { 0.0 } else { r.hair(1.0) };
            }
            target[(axis + 1) % 3] += r.hair(size + 1e-2 * away);
            (
                Geometry::Box {
                    min: min.0,
                    max: max.0,
                },
                target,
                d,
            )
        }
        Kind::HalfSpace | Kind::Plane => {
            let n = match r.below(3) {
                0 => Vec3::new(0.0, r.sign(), 0.0),
                1 => Vec3::new(1.0, r.sign(), 0.0),
                _ => r.unit() * r.power(-3.0, 3.0),
            };
            let target = r.unit() * size;
            let abcd = [n[0], n[1], n[2], -n.dot(target)];
            let d = across(r, n) + n.unit() * r.hair(1.0);
            let geometry = match kind {
                Kind::Plane => Geometry::Plane(abcd),
                _ => Geometry::HalfSpace(abcd),
            };
            (geometry, target + n.unit() * r.hair(size), d)
        }
        Kind::Rectangle => {
            let min: [f64; 2] = from_fn(|_| r.within(-1.0, 1.0) * size);
            let max = min.map(|x| x + size * r.within(0.01, 1.0));
            let axis = r.below(2);
            let mut target = Vec3::ZERO;
            target[axis] = if r.below(2) == 0 {
                min[axis]
            } else {
                max[axis]
            };
            target[1 - axis] = r.within(min[1 - axis], max[1 - axis]);
            target[axis] += r.hair(size + 1e-2 * away);
            let mut d = r.unit();
            match r.below(4) {
                0 => d[2] = r.hair(1.0),
                1 => d[axis] = 0.0,
                _ => {}
            }
            (Geometry::Rectangle { min, max }, target, d)
        }
    };
    if !d.any() {
        d = Vec3::ONE;
    }
    Case {
        geometry,
        size,
        origin: target - d * away,
        direction: d * r.power(-6.0, 6.0),
    }
}

/// How far a point is from the surface: an upper bound that is less than twice too large.
fn distance(geometry: &Geometry, p: Vec3<Dd>) -> f64 {
    let off = match *geometry {
        Geometry::Sphere { centre, radius } => {
            let f = p - Vec3(centre).cast();
            (f.dot(f).sqrt() - Dd::of(radius)).abs()
        }
        Geometry::Box { min, max } => {
            let (mut outside, mut inside) = (Dd::ZERO, Dd::INFINITY);
            for i in 0..3 {
                let (low, high) = (p[i] - Dd::of(min[i]), Dd::of(max[i]) - p[i]);
                outside = outside.max(-low).max(-high);
                inside = inside.min(low.abs()).min(high.abs());
            }
            outside.max(inside)
        }
        Geometry::Plane([a, b, c, d]) | Geometry::HalfSpace([a, b, c, d]) => {
            let n = Vec3::new(a, b, c).cast::<Dd>();
            (n.dot(p) + Dd::of(d)).abs() / n.dot(n).sqrt()
        }
        Geometry::Rectangle { min, max } => (0..2).fold(p[2].abs(), |off, i| {
            off.max(Dd::of(min[i]) - p[i]).max(p[i] - Dd::of(max[i]))
        }),
        _ => unreachable!(),
    };
    off.to_f64()
}

/// A decision in doubles is the same in double-double, and near it points are where the lines meet the surfaces.
fn doubles_are_sure_of_what_double_double_finds(kind: Kind) {
    const LINES: usize = 40_000;
    let mut r = Random(kind as u64);
    let (mut decided, mut crossings) = (0, 0);
    for _ in 0..LINES {
        let case = close_call(&mut r, kind, 8.0);
        let shape = case.shape();
        let (o, d) = (case.origin, case.direction);
        let plain = meet::<f64>(&shape, &line(o, d));
        let fine = meet::<Dd>(&shape, &line(o, d));
        let say = || format!("{:?} {o:?} {d:?} {plain:?} {fine:?}", case.geometry);
        if !plain.uncertain {
            decided += 1;
            assert!(!fine.uncertain, "{}", say());
            assert_eq!(plain.list.len(), fine.list.len(), "{}", say());
            assert_eq!(plain.inside, fine.inside, "{}", say());
        }
        // A crossing of a plane that may be parallel is anywhere.
        if plain.uncertain && matches!(kind, Kind::HalfSpace | Kind::Plane) {
            continue;
        }
        let exact = line::<Dd>(o, d);
        for root in &plain.list {
            crossings += 1;
            let p = exact.at(Dd::of(root.t));
            let mut size = case.size.max(o.abs().max_component());
            if matches!(kind, Kind::HalfSpace | Kind::Plane) {
                size = size.max(p.abs().max_component().to_f64());
            }
            let off = distance(&case.geometry, p);
            assert!(off <= 64.0 * f64::EPSILON * size, "{off:e} {}", say());
        }
    }
    let share = decided as f64 / LINES as f64;
    assert!((0.1..0.95).contains(&share), "{kind:?} {share}");
    assert!(crossings > LINES / 10, "{kind:?} {crossings}");
}

/// The same through maps that round: rotated by any angle, or by right angles whose cosine is not
/// quite zero, scaled and moved.
fn what_maps_round_is_reckoned_with(kind: Kind) {
    const LINES: usize = 40_000;
    let mut r = Random(100 + kind as u64);
    let mut decided = 0;
    for i in 0..LINES {
        let case = close_call(&mut r, kind, 4.0);
        let angle = match r.below(3) {
            0 => 90.0,
            _ => r.within(-180.0, 180.0),
        };
        let p = r.unit() * (case.size * r.power(-3.0, 3.0));
        let turn = Matrix::rotation(angle, i % 3);
        let scale = Matrix::scaling(r.power(-3.0, 3.0), r.sign(), r.power(-3.0, 3.0));
        let placed = Matrix::translation(p[0], p[1], p[2]).after(&turn.after(&scale));
        // The line's way back into the shape's space, where it is a close call.
        let Some(back) = placed.inverse() else {
            continue;
        };
        let out = Affine::<f64>::new(&placed);
        let (o, d) = (out.point(case.origin), out.vector(case.direction));
        let shape = case.shape();
        let plain = line::<f64>(o, d).through(&Affine::new(&back));
        let fine = line::<Dd>(o, d).through(&Affine::new(&back));
        let (plain, fine) = (meet(&shape, &plain), meet(&shape, &fine));
        if !plain.uncertain {
            decided += 1;
            let say = || format!("{:?} {o:?} {d:?} {back:?} {fine:?}", case.geometry);
            assert!(!fine.uncertain, "{}", say());
            assert_eq!(plain.list.len(), fine.list.len(), "{}", say());
            assert_eq!(plain.inside, fine.inside, "{}", say());
        }
    }
    let share = decided as f64 / LINES as f64;
    assert!((0.02..0.95).contains(&share), "{kind:?} {share}");
}

/// Lines that come close from a few sizes away are doubtful about as often as the last digits of
/// numbers decide: never, in so many.
fn few_lines_are_doubtful(kind: Kind) {
    let mut r = Random(7);
    let mut met = 0;
    for _ in 0..50_000 {
        let case = close_call(&mut r, kind, 0.0);
        let shape = case.shape();
        let target = case.origin + r.unit() * case.size;
        let o = target + r.unit() * (4.0 * case.size);
        let d = target + r.unit() * case.size - o;
        let turn = Matrix::rotation(r.within(-180.0, 180.0), 1);
        let exact = meet::<f64>(&shape, &line(o, d));
        let turned = line(o, d).through(&Affine::new(&turn));
        let mapped = meet::<f64>(&shape, &turned);
        assert!(!exact.uncertain && !mapped.uncertain, "{:?}", case.geometry);
        met += exact.list.len();
    }
    assert!(met > 100, "{kind:?} {met}");
}

/// Coordinates up to half the exponents: powers of two change nothing but the unit of t.
fn powers_of_two_change_no_digit(kind: Kind) {
    let mut r = Random(200 + kind as u64);
    for _ in 0..2_000 {
        let case = close_call(&mut r, kind, 2.0);
        let k = r.within(-900.0, 900.0) as i32;
        let m = (r.within(-100.0, 100.0) as i32 + k).clamp(-900, 900);
        let by = |x: f64, k: i32| shifted(x, k);
        let grown = match case.geometry {
            Geometry::Sphere { centre, radius } => Geometry::Sphere {
                centre: centre.map(|x| by(x, k)),
                radius: by(radius, k),
            },
            Geometry::Box { min, max } => Geometry::Box {
                min: min.map(|x| by(x, k)),
                max: max.map(|x| by(x, k)),
            },
            Geometry::Plane([a, b, c, d]) => Geometry::Plane([a, b, c, by(d, k)]),
            Geometry::HalfSpace([a, b, c, d]) => Geometry::HalfSpace([a, b, c, by(d, k)]),
            Geometry::Rectangle { min, max } => Geometry::Rectangle {
                min: min.map(|x| by(x, k)),
                max: max.map(|x| by(x, k)),
            },
            _ => unreachable!(),
        };
        let (o, d) = (case.origin, case.direction);
        let plain = meet::<f64>(&case.shape(), &line(o, d));
        let scaled = line(o.map(|x| by(x, k)), d.map(|x| by(x, m)));
        let scaled = meet::<f64>(&Primitive::new(&grown), &scaled);
        if plain.uncertain || scaled.uncertain {
            continue;
        }
        assert_eq!(plain.inside, scaled.inside);
        assert_eq!(plain.list.len(), scaled.list.len());
        for (a, b) in plain.list.iter().zip(&scaled.list) {
            // The scaled sphere may move its squares by powers of two only; so do the others.
            assert_eq!(shifted(a.t, k - m), b.t, "{:?} {k} {m}", case.geometry);
        }
    }
}

/// Extreme but finite coordinates give numbers alone ([`meet`] looks).
#[test]
fn extreme_numbers_give_numbers() {
    let mut r = Random(9);
    let number = |r: &mut Random| match r.below(8) {
        0 => 0.0,
        1 => r.sign() * f64::MAX,
        2 => r.sign() * f64::from_bits(1),
        _ => r.sign() * r.power(-320.0, 308.0),
    };
    for i in 0..60_000 {
        let vector = |r: &mut Random| -> [f64; 3] { from_fn(|_| number(r)) };
        let (a, b) = (vector(&mut r), vector(&mut r));
        let (o, d) = (Vec3(vector(&mut r)), Vec3(vector(&mut r)));
        if !d.any() {
            continue;
        }
        let (min, max): ([f64; 3], [f64; 3]) =
            (from_fn(|i| a[i].min(b[i])), from_fn(|i| a[i].max(b[i])));
        let geometry = match KINDS[i % 5] {
            Kind::Sphere => Geometry::Sphere {
                centre: a,
                radius: b[0].abs().max(f64::from_bits(1)),
            },
            Kind::Cuboid => Geometry::Box { min, max },
            Kind::HalfSpace => Geometry::HalfSpace([a[0], a[1], a[2], b[0]]),
            Kind::Plane => Geometry::Plane([a[0], a[1], a[2], b[0]]),
            Kind::Rectangle => Geometry::Rectangle {
                min: [min[0], min[1]],
                max: [max[0], max[1]],
            },
        };
        let shape = Primitive::new(&geometry);
        let plain = meet::<f64>(&shape, &line(o, d));
        let fine = meet::<Dd>(&shape, &line(o, d));
        if !plain.uncertain && !fine.uncertain {
            assert_eq!(plain.inside, fine.inside, "{geometry:?} {o:?} {d:?}");
            let counts = (plain.list.len(), fine.list.len());
            assert_eq!(counts.0, counts.1, "{geometry:?} {o:?} {d:?}");
        }
        let few: Line<f32> = line(o, d);
        if few.origin.is_finite() && few.direction.is_finite() && few.direction.any() {
            meet(&shape, &few);
        }
    }
}

/// Single precision, where the numbers of the shape are rounded, too.
fn single_precision_knows_what_it_rounds(kind: Kind) {
    let mut r = Random(300 + kind as u64);
    let mut decided = 0;
    for _ in 0..20_000 {
        let case = close_call(&mut r, kind, 3.0);
        // Off by something that single precision can tell, at times.
        let aside = r.unit() * (case.size * r.power(-8.0, -1.0));
        let o = (case.origin + aside).cast::<f32>();
        let d = case.direction.cast::<f32>();
        let few = meet(&case.shape(), &Line::new(o, d));
        let fine = meet(&case.shape(), &line::<Dd>(o.cast(), d.cast()));
        if !few.uncertain {
            decided += 1;
            assert_eq!(few.list.len(), fine.list.len(), "{:?}", case.geometry);
            assert_eq!(few.inside, fine.inside, "{:?}", case.geometry);
        }
    }
    assert!(decided > 1_000, "{kind:?} {decided}");
}

macro_rules! for_each_kind {
    ($($name:ident: $kind:expr),*) => {
        $(mod $name {
            use super::*;

            #[test]
            fn doubles_are_sure_of_what_double_double_finds() {
                super::doubles_are_sure_of_what_double_double_finds($kind);
            }

            #[test]
            fn what_maps_round_is_reckoned_with() {
                super::what_maps_round_is_reckoned_with($kind);
            }

            #[test]
            fn few_lines_are_doubtful() {
                super::few_lines_are_doubtful($kind);
            }

            #[test]
            fn powers_of_two_change_no_digit() {
                super::powers_of_two_change_no_digit($kind);
            }

            #[test]
            fn single_precision_knows_what_it_rounds() {
                super::single_precision_knows_what_it_rounds($kind);
            }
        })*
    };
}

for_each_kind!(
    sphere_lines: Kind::Sphere,
    cuboid_lines: Kind::Cuboid,
    half_space_lines: Kind::HalfSpace,
    plane_lines: Kind::Plane,
    rectangle_lines: Kind::Rectangle
);
