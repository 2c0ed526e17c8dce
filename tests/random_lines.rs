//! A short run of the randomised campaign; the long one is `cargo bench --bench campaign`.

use crate::campaign;
use crate::campaign::Spread;
use crate::campaign::exact::{Exact, point};
use crate::campaign::roots::{Root, between, sign_changes, sorted};
use crate::campaign::truth::Truth;
use zpg::internals::scene::Geometry;

/// Lines a kind of shape.
const RAYS: usize = 2000;

/// The same every time.
const SEED: u64 = 20;

/// Everything that is counted and measured but times is the same however many threads there are.
#[test]
fn threads_change_nothing() {
    let result = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
        let bars = campaign::Bars::NONE;
        let kind = pool
            .unwrap()
            .install(|| campaign::run(0, campaign::Spread::Usual, 400, SEED, &bars));
        kind.rows.map(|r| {
            let counts = [
                r.rays,
                r.wrong,
                r.outside,
                r.uncertain,
                r.plain,
                r.plain_uncertain,
            ];
            (counts, r.worst, r.failures)
        })
    };
    assert_eq!(result(1), result(3));
}

/// One kind of shape must meet the bars in f64, with dd for what that cannot decide, and in dd: the
/// right number of crossings wherever moving the line by half a unit in the last place does not
/// change it, and every crossing as near to the surface as the ratchet says.
fn meets_the_bars(name: &str, spread: Spread) {
    let kind = campaign::KINDS.iter().position(|k| *k == name);
    let kind = kind.expect("a kind of shape");
    let bars = campaign::Bars::of_kind(&spread.name(kind));
    let rays = match spread {
        Spread::Usual => RAYS,
        Spread::Stretched => RAYS / 4,
    };
    let result = campaign::run(kind, spread, rays, SEED, &bars);
    let failures = result.failures();
    assert!(
        failures.is_empty(),
        "{}\n{}",
        campaign::table(&[result]),
        failures.join("\n")
    );
}

macro_rules! kinds {
    ($($name:ident: $kind:literal,)*) => {
        $(
            mod $name {
                use super::*;

                #[test]
                fn usual() {
                    meets_the_bars($kind, Spread::Usual);
                }

                #[test]
                fn stretched() {
                    meets_the_bars($kind, Spread::Stretched);
                }
            }
        )*

        #[test]
        fn every_kind_is_tested() {
            assert_eq!(campaign::KINDS, [$($kind),*]);
        }
    };
}

kinds! {
    surface_of_revolution: "surface of revolution",
    plane: "plane",
    half_space: "half-space",
    rectangle: "rectangle",
    triangle: "triangle",
    sphere: "sphere",
    sphere_off_the_origin: "sphere off the origin",
    ellipsoid: "ellipsoid",
    box_: "box",
    geodesic_sphere: "geodesic sphere",
    torus_tube_1_4: "torus, tube 1/4",
    torus_tube_1: "torus, tube 1",
    torus_tube_1e_4: "torus, tube 1e-4",
    torus_spindle: "torus, spindle",
    quadric: "quadric",
    cone: "cone",
    double_cone: "double cone",
    parabolic_cylinder: "parabolic cylinder",
    hyperbolic_cylinder: "hyperbolic cylinder",
    hyperboloid_one_sheet: "hyperboloid, one sheet",
    hyperboloid_two_sheets: "hyperboloid, two sheets",
    hyperbolic_paraboloid: "hyperbolic paraboloid",
    cylinder: "cylinder",
}

/// The product of (x − root) for all roots, times another polynomial.
fn with_roots(roots: &[f64], times: &[f64]) -> Vec<Exact> {
    let mut f: Vec<Exact> = times.iter().map(|&c| Exact::of(c)).collect();
    for &r in roots {
        let mut next = vec![Exact::zero(); f.len() + 1];
        for (i, c) in f.iter().enumerate() {
            next[i + 1] = &next[i + 1] + c;
            next[i] = &next[i] - c * Exact::of(r);
        }
        f = next;
    }
    f
}

#[test]
fn sign_changes_are_roots_of_odd_multiplicity() {
    let no_root = [1.0, 0.0, 3.0];
    for (roots, changes) in [
        (&[1.0, 2.0, -3.0, 4.5][..], 4),
        (&[1.0, 1.0, 2.0, 3.0], 2),
        (&[1.0, 1.0, 2.0, 2.0], 0),
        (&[1.0, 1.0, 1.0, 2.0], 2),
        (&[1.0, 1.0, 1.0, 1.0], 0),
        (&[1e-9, 2e-9, 1e9, 3.0], 4),
        (&[5.0, 5.0, 5.0], 1),
        (&[], 0),
    ] {
        for times in [&[-1.0][..], &[7.0], &no_root] {
            let f = with_roots(roots, times);
            assert_eq!(sign_changes(&f), changes, "{roots:?} {times:?}");
        }
    }
    // Rows 12 and 13 of a well-known table of hard quartics: two roots close together, none.
    let f = [26471900.25, -1325880.0, 25449.0, -240.0, 1.0].map(Exact::of);
    assert_eq!(sign_changes(&f), 2);
    let f = [6.52025e6, -508127.0, 15006.6, -198.995, 1.0].map(Exact::of);
    assert_eq!(sign_changes(&f), 0);
}

#[test]
fn roots_are_where_they_are() {
    let n = Exact::of;
    // (t − 3)(2t + 1) = 2t² − 5t − 3.
    let list = sorted(Root::quadratic(n(2.0), n(-2.5), n(-3.0)));
    let about: Vec<f64> = list.iter().map(|r| r.low.about()).collect();
    assert_eq!(about, [-0.5, 3.0]);
    // Roots that differ by 2⁻²⁰⁰, equal roots of different polynomials, and a linear one.
    let tiny = Exact::power_of_two(-200);
    let mut all = Root::quadratic(n(1.0), n(0.0), n(-2.0));
    all.extend(Root::quadratic(n(-1.0), n(0.0), n(2.0) + tiny));
    all.extend(Root::quadratic(n(0.0), n(1.0), n(-2.0)));
    all.extend(Root::quadratic(n(-3.0), n(0.0), n(6.0)));
    let list = sorted(all);
    assert_eq!(list.len(), 5);
    for pair in list.windows(2) {
        assert!(pair[0].high < pair[1].low);
        let middle = between(&pair[0].high, &pair[1].low);
        assert!(pair[0].high < middle && middle < pair[1].low);
    }
    assert!(Root::quadratic(n(1.0), n(0.0), n(1.0)).is_empty());
    assert_eq!(Root::quadratic(n(1.0), n(1.0), n(1.0)).len(), 1);
}

/// Answers that can be worked out by hand.
#[test]
fn the_evaluation_knows_touches() {
    let torus = |major, minor| Truth::new(&Geometry::Torus { major, minor });
    let sphere = Truth::new(&Geometry::Sphere {
        centre: [0.0; 3],
        radius: 1.0,
    });
    let cone = Truth::new(&Geometry::Cone {
        height: 1.0,
        radius: 1.0,
    });
    let double = Truth::new(&Geometry::DoubleCone {
        height: 1.0,
        radius: 1.0,
    });
    let cuboid = Truth::new(&Geometry::Box {
        min: [-1.0; 3],
        max: [1.0; 3],
    });
    let ahead = [0.0, 0.0, 1.0];
    let up = [0.0, 1.0, 0.0];
    for (truth, o, d, crossings) in [
        // The plane on top of a torus touches it in a circle; its inner equator is passed inside.
        (&torus(1.0, 0.25), [1.0, 0.25, -5.0], ahead, 0),
        (&torus(1.0, 0.25), [0.0, 0.25, -5.0], ahead, 0),
        (&torus(1.0, 0.25), [1.25, 0.0, -5.0], ahead, 0),
        (&torus(1.0, 0.25), [1.25 - 1e-9, 0.0, -5.0], ahead, 2),
        (&torus(1.0, 0.25), [0.75, 0.0, -5.0], ahead, 2),
        (&torus(1.0, 0.25), [0.0, 0.0, -5.0], ahead, 4),
        // The axis of a horn torus touches it in the centre; that of a spindle lies in the lemon or
        // outside. Beside it there are the tube, the lemon and the tube.
        (&torus(1.0, 1.0), [0.0, 5.0, 0.0], up, 0),
        (&torus(1.0, 2.0), [0.0, 5.0, 0.0], up, 0),
        (&torus(1.0, 2.0), [0.5, 0.0, -5.0], ahead, 4),
        (&sphere, [1.0, 0.0, -5.0], ahead, 0),
        (&sphere, [1.0f64.next_down(), 0.0, -5.0], ahead, 2),
        // The apex, a generator, the base, and through the apex from one half to the other.
        (&cone, [-5.0, 0.0, 0.0], [1.0, 0.0, 0.0], 0),
        (&cone, [-5.0, -5.0, 0.0], [1.0, 1.0, 0.0], 0),
        (&cone, [-5.0, 1.0, 0.0], [1.0, 0.0, 0.0], 0),
        (&cone, [0.0, -5.0, 0.0], up, 2),
        (&double, [0.0, -5.0, 0.0], up, 2),
        (&double, [0.001, -5.0, 0.0], up, 4),
        (&cuboid, [1.0, 0.0, -5.0], ahead, 0),
        (&cuboid, [1.0f64.next_down(), 0.0, -5.0], ahead, 2),
        (&cuboid, [-5.0, 0.0, -4.0], [1.0, 0.0, 1.0], 2),
        (&cuboid, [-5.0, 0.0, -3.0], [1.0, 0.0, 1.0], 0),
    ] {
        let answer = truth.answer(&point(o), &point(d));
        assert_eq!(answer.crossings, crossings, "{o:?} {d:?}");
        assert!(!answer.inside);
    }
}
