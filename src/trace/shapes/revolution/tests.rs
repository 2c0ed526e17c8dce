use super::*;
use crate::geometry::affine::Affine;
use crate::geometry::dd::Dd;
use crate::geometry::number::Real;

/// splitmix64.
struct Random(u64);

impl Random {
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * (self.bits() >> 11) as f64 / (1u64 << 53) as f64
    }

    fn point(&mut self, size: f64) -> Vec3 {
        Vec3([(); 3].map(|()| self.within(-size, size)))
    }

    fn below(&mut self, n: u64) -> u64 {
        self.bits() % n
    }
}

/// Whether (ρ, y) is in the closed profile: the even-odd rule, counted towards ρ = ∞.
fn inside(profile: &[[f64; 2]], p: Vec3) -> bool {
    let (rho, y) = (p[0].hypot(p[2]), p[1]);
    let mut closed = profile.to_vec();
    if profile.first() != profile.last() {
        closed.insert(0, [0.0, profile[0][1]]);
        closed.push([0.0, profile[profile.len() - 1][1]]);
    }
    let crossed = closed.windows(2).filter(|s| {
        let ([x0, y0], [x1, y1]) = (s[0], s[1]);
        (y0 > y) != (y1 > y) && x0 + (x1 - x0) * (y - y0) / (y1 - y0) > rho
    });
    crossed.count() % 2 == 1
}

fn cast<R: Traced>(line: &Line) -> Line<R> {
    Line::new(line.origin.cast(), line.direction.cast())
}

fn roots<R: Traced>(shape: &Revolution, line: &Line) -> Roots<R> {
    let mut roots: Roots<R> = Roots::default();
    shape.crossings(&cast(line), &mut roots);
    assert!(!roots.inside);
    assert_eq!(roots.list.len() % 2, 0);
    assert!(roots.list.windows(2).all(|w| w[0].t < w[1].t));
    assert!(roots.list.iter().all(|r| r.t.is_finite()));
    roots
}

fn ts(profile: &[[f64; 2]], origin: [f64; 3], direction: [f64; 3]) -> Vec<f64> {
    let shape = Revolution::new(profile, &[]);
    let line = Line::new(origin.into(), direction.into());
    let fine = list(&roots::<Dd>(&shape, &line));
    let plain = list(&roots::<f64>(&shape, &line));
    assert_eq!(fine.len(), plain.len());
    for (a, b) in fine.iter().zip(&plain) {
        assert!(
            (a - b).abs() <= 1e-12 * a.abs().max(1.0),
            "{fine:?} {plain:?}"
        );
    }
    fine
}

fn list<R: Traced>(roots: &Roots<R>) -> Vec<f64> {
    roots.list.iter().map(|r| r.t.to_f64()).collect()
}

/// Profiles with coordinates on a coarse grid, so that points repeat, segments are level, upright,
/// on the axis and on one another.
fn random_profile(r: &mut Random, grid: bool) -> Vec<[f64; 2]> {
    let n = 2 + r.below(9) as usize;
    let mut profile: Vec<[f64; 2]> = (0..n)
        .map(|_| match grid {
            true => [r.below(4) as f64 / 2.0, r.below(5) as f64 / 2.0 - 1.0],
            false => [r.within(0.0, 1.5), r.within(-1.0, 1.0)],
        })
        .collect();
    if r.below(3) == 0 {
        profile.push(profile[0]);
    }
    profile
}

/// Lines of all kinds past a shape of size 2.
fn random_line(r: &mut Random, grid: bool) -> Line {
    let mut from = r.point(2.0);
    let mut to = r.point(2.0);
    if grid {
        (from, to) = (
            from.map(|x| (2.0 * x).round() / 2.0),
            to.map(|x| (2.0 * x).round() / 2.0),
        );
    }
    if from == to {
        to = from + Vec3::new(0.0, 0.0, 1.0);
    }
    Line::new(from, to - from)
}

/// Along the line the parity of the crossings is that of the definition, wherever the next
/// crossing is farther than `margin`.
fn agrees(profile: &[[f64; 2]], line: &Line, t: &[f64], margin: f64) {
    let (low, high) = (-30.0, 30.0);
    for i in 0..=240 {
        let at = low + (high - low) * (f64::from(i) + 0.37) / 241.0;
        let near = t.iter().any(|t| (t - at).abs() <= margin);
        if !near {
            let odd = t.iter().filter(|&&t| t < at).count() % 2 == 1;
            assert_eq!(
                odd,
                inside(profile, line.at(at)),
                "{profile:?} {line:?} {at} {t:?}"
            );
        }
    }
}

#[test]
fn random_profiles_agree_with_the_definition() {
    let mut r = Random(1);
    for _ in 0..3000 {
        let profile = random_profile(&mut r, false);
        let shape = Revolution::new(&profile, &[]);
        let line = random_line(&mut r, false);
        let plain = roots::<f64>(&shape, &line);
        agrees(&profile, &line, &list(&plain), 1e-9);
        let fine = roots::<Dd>(&shape, &line);
        agrees(&profile, &line, &list(&fine), 1e-9);
        if !plain.uncertain {
            assert_eq!(plain.list.len(), fine.list.len());
            for (a, b) in plain.list.iter().zip(&fine.list) {
                assert_eq!(a.face, b.face);
                assert!((a.t - b.t.to_f64()).abs() <= 1e-7, "{a:?} {b:?}");
            }
        }
    }
}

/// Lines through points, along segments and surfaces, level and upright.
#[test]
fn lines_through_seams_agree_with_the_definition() {
    let mut r = Random(2);
    for _ in 0..6000 {
        let profile = random_profile(&mut r, true);
        let shape = Revolution::new(&profile, &[]);
        let line = random_line(&mut r, true);
        roots::<f64>(&shape, &line);
        roots::<f32>(&shape, &line);
        // Off the surface by what no rounding reaches, so that membership is well defined.
        let apart = Line::new(line.origin + r.point(1e-4), line.direction);
        agrees(&profile, &apart, &list(&roots::<f64>(&shape, &apart)), 1e-6);
    }
}

#[test]
fn grazing_a_wall_is_no_crossing() {
    // The lathe (0,2)(1,1)(1,0)(0,0).
    let lathe = [[0.0, 2.0], [1.0, 1.0], [1.0, 0.0], [0.0, 0.0]];
    assert!(ts(&lathe, [1.0, 5.0, 0.0], [0.0, -1.0, 0.0]).is_empty());
    // Half-way in: the cone at y = 1.5, the floor at 0.
    assert_eq!(ts(&lathe, [0.5, 5.0, 0.0], [0.0, -1.0, 0.0]), [3.5, 5.0]);
    assert_eq!(ts(&lathe, [0.5, 5.0, 0.0], [0.0, -1e-6, 0.0]), [3.5e6, 5e6]);
    // Level with a seam: the circle of radius 1.
    assert_eq!(ts(&lathe, [-5.0, 1.0, 0.0], [1.0, 0.0, 0.0]), [4.0, 6.0]);
    // Down the axis, through the apex.
    assert_eq!(ts(&lathe, [0.0, 5.0, 0.0], [0.0, -1.0, 0.0]), [3.0, 5.0]);
    // A touch of the apex from the side.
    assert!(ts(&lathe, [-5.0, 2.0, 0.0], [1.0, 0.0, 0.0]).is_empty());
}

#[test]
fn rings_discs_and_doubled_layers() {
    // A tube of square section: 1 ≤ ρ ≤ 2, 0 ≤ y ≤ 1.
    let tube = [[1.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 1.0], [1.0, 0.0]];
    let across = ts(&tube, [-4.0, 0.5, 0.0], [1.0, 0.0, 0.0]);
    assert_eq!(across, [2.0, 3.0, 5.0, 6.0]);
    assert!(ts(&tube, [0.0, 4.0, 0.0], [0.0, -1.0, 0.0]).is_empty());
    // A cylinder: one upright segment, closed by two discs.
    let cylinder = [[1.0, 0.0], [1.0, 1.0]];
    assert_eq!(
        ts(&cylinder, [0.25, 4.0, 0.0], [0.0, -2.0, 0.0]),
        [1.5, 2.0]
    );
    // There and back again: nothing.
    let doubled = [[0.0, 0.0], [1.0, 0.5], [0.0, 1.0], [1.0, 0.5], [0.0, 0.0]];
    assert!(ts(&doubled, [-3.0, 0.6, 0.1], [1.0, 0.01, 0.0]).is_empty());
}

/// Number of crossings of the line, by double-double.
fn final_count(profile: &[[f64; 2]], origin: [f64; 3], direction: [f64; 3]) -> usize {
    let line = Line::new(origin.into(), direction.into());
    roots::<Dd>(&Revolution::new(profile, &[]), &line)
        .list
        .len()
}

#[test]
fn a_line_in_a_disc_crosses_nothing() {
    let ahead = [1.0, 0.0, 0.0];
    let cylinder = [[1.0, 0.0], [1.0, 1.0]];
    let least = f64::MIN_POSITIVE;
    for (y, count) in [
        (0.0, 0),
        (1.0, 0),
        (0.5, 2),
        (least, 2),
        (-least, 0),
        (1.0f64.next_down(), 2),
        (1.0f64.next_up(), 0),
    ] {
        for z in [0.0, 0.25, -0.75] {
            assert_eq!(final_count(&cylinder, [-5.0, y, z], ahead), count, "{y}");
        }
    }
    // A seam in a wall; a step, where only the narrower part is inside above and below.
    let wall = [[1.0, 0.0], [1.0, 1.0], [1.0, 2.0]];
    assert_eq!(final_count(&wall, [-5.0, 1.0, 0.0], ahead), 2);
    for step in [
        [[2.0, 0.0], [2.0, 1.0], [1.0, 1.0], [1.0, 2.0]],
        [[1.0, 0.0], [1.0, 1.0], [2.0, 1.0], [2.0, 2.0]],
    ] {
        let line = Line::new([-5.0, 1.0, 0.0].into(), ahead.into());
        let found = roots::<Dd>(&Revolution::new(&step, &[]), &line);
        assert_eq!(list(&found), [4.0, 6.0]);
    }
}

/// Above a seam a solid is inside of a ring, below it outside of it: nothing is inside on both sides,
/// wherever rounding puts the ring.
#[test]
fn solids_that_meet_in_a_ring_have_nothing_in_common() {
    let mut r = Random(53);
    for _ in 0..200 {
        let (y, ring) = (r.within(-0.5, 0.5), r.within(0.5, 1.0));
        let profile = [
            [r.within(0.3, 2.0), 1.0],
            [ring, y],
            [r.within(1.5, 2.0), y],
            [r.within(1.1, 2.0), -1.0],
            [r.within(0.3, 1.0), -1.0],
            [ring, y],
        ];
        let along = Vec3::new(r.within(-1.0, 1.0), 0.0, r.within(-1.0, 1.0));
        let o = [r.within(-4.0, 4.0), y, r.within(-4.0, 4.0)];
        assert_eq!(final_count(&profile, o, along.0), 0, "{profile:?}");
        // Through the upper solid alone, at a height that no corner has.
        let o = [0.0, (y + 1.0) / 2.0, 0.0];
        assert_eq!(final_count(&profile, o, along.0), 2, "{profile:?}");
    }
}

/// Counts from an evaluation in rational numbers.
#[test]
fn close_crossings_of_two_segments_are_told_from_layers() {
    // A layer of no thickness, which no line can meet, nor doubt.
    let k = 1024.0;
    let folded = [
        [k, k],
        [3.0 * k, 3.0 * k],
        [0.0, 0.0],
        [k, k],
        [k, 0.0],
        [0.0, 2.0 * k],
    ];
    let line = Line::new(
        [-62861.750222083036, -23336.5630898876, -22872.57136861603].into(),
        [0.8742412470684342, 0.3491475642273439, 0.33733991806239266].into(),
    );
    let shape = Revolution::new(&folded, &[]);
    assert!(!roots::<f64>(&shape, &line).uncertain);
    assert!(roots::<f64>(&shape, &line).list.is_empty());
    assert!(roots::<Dd>(&shape, &line).list.is_empty());
    // Both sides of a corner within 1e-28 of it.
    let corner = [
        [8.535388298251762e-5, -8.991066914243096e-5],
        [2.8354665802887205e-5, 9.515068917339723e-5],
        [6.44975178804683e-5, 7.131260302755073e-7],
        [6.869244029708267e-5, 8.116787871717261e-5],
        [5.416178419378307e-5, 8.546883901368096e-5],
        [3.852686283616863e-5, -9.360218911422926e-5],
    ];
    let o = [
        0.014336365918735631,
        -0.00414830123580167,
        -2.8354665802887205e-5,
    ];
    let d = [-3.8355100402065614, 1.1352809042147514, 0.0];
    assert_eq!(final_count(&corner, o, d), 6);
    // Upwards in a needle 1e-17 wide, and past it.
    let needle = [[0.0, -1.0], [1e-17, 1.0]];
    for (x, count) in [(3e-18, 2), (-9.9e-18, 2), (1.01e-17, 0), (-1.01e-17, 0)] {
        assert_eq!(final_count(&needle, [x, -5.0, 0.0], [0.0, 1.0, 0.0]), count);
    }
}

/// A waist of radius 1: at x = −2η the line (x, η + x/2, 1) is level with it and 2η² outside, and
/// else it is inside, where |y| exceeds half of x². The gap is as wide as 8η².
#[test]
fn a_corner_is_passed_at_any_distance() {
    let waist = [[2.0, -1.0], [1.0, 0.0], [2.0, 1.0]];
    let shape = Revolution::new(&waist, &[]);
    let map = Affine::<Dd>::of(
        [[0.0, 2.0, 0.0], [0.0, 0.0, -2.0], [-2.0, 0.0, 0.0]].map(|row| Vec3(row.map(Dd::of))),
        Vec3::new(Dd::ZERO, Dd::of(1.0), Dd::of(-3.0)),
    );
    for eta in [1e-3, 1e-7, 1e-8, 1e-9, 1e-15, 1e-16, 1e-17, 1e-22, 1e-28] {
        for eta in [eta, -eta] {
            let line = Line::new([0.0, eta, 1.0].into(), [1.0, 0.5, 0.0].into());
            let plain = roots::<f64>(&shape, &line);
            assert!(plain.uncertain || plain.list.len() == 4, "{eta}");
            let fine = roots::<Dd>(&shape, &line);
            assert_eq!(fine.list.len(), 4, "{eta}");
            assert!(!fine.uncertain);
        }
    }
    // At the corner itself.
    assert_eq!(final_count(&waist, [0.0, 0.0, 1.0], [1.0, 0.5, 0.0]), 2);
    // A map that rounds nothing changes nothing: z = 1 is x = −2, and y = η is z = (1 − η)/2.
    for eta in [2f64.powi(-30), 2f64.powi(-50), -(2f64.powi(-52))] {
        let o = [-2.0, 0.0, 0.5 - 0.5 * eta].map(Dd::of);
        let d = [0.0, 0.5, -0.25].map(Dd::of);
        let line = Line::new(Vec3(o), Vec3(d)).through(&map);
        let mut found = Roots::default();
        shape.crossings(&line, &mut found);
        assert_eq!(found.list.len(), 4, "{eta}");
    }
}

/// Needles from an apex at y = −1 to a rim at y = 1.
#[test]
fn needles_have_an_inside() {
    for width in [1e-3, 1e-9, 1e-16, 1e-17, 1e-25, 1e-60, 1e-150] {
        let needle = [[0.0, -1.0], [width, 1.0]];
        let shape = Revolution::new(&needle, &[]);
        let (less, more) = (width.next_down(), width.next_up());
        for (o, d, count) in [
            // Through the rim's disc, and past it.
            ([less, -5.0, 0.0], [0.0, 1.0, 0.0], 2),
            ([width, -5.0, 0.0], [0.0, 1.0, 0.0], 0),
            ([more, -5.0, 0.0], [0.0, 1.0, 0.0], 0),
            ([0.0, -5.0, 0.0], [0.0, 1.0, 0.0], 2),
            // From the apex along the surface.
            ([0.0, -1.0, 0.0], [less, 2.0, 0.0], 2),
            ([0.0, -1.0, 0.0], [width, 2.0, 0.0], 0),
            ([0.0, -1.0, 0.0], [more, 2.0, 0.0], 0),
            // Across, half-way up, where it is half as wide.
            ([-1.0, 0.0, 0.0], [1.0, 0.0, 0.0], 2),
            ([-1.0, 0.0, 0.5 * less], [1.0, 0.0, 0.0], 2),
            ([-1.0, 0.0, 0.5 * width], [1.0, 0.0, 0.0], 0),
            ([-1.0, 0.0, 0.5 * more], [1.0, 0.0, 0.0], 0),
        ] {
            let line = Line::new(o.into(), d.into());
            let plain = roots::<f64>(&shape, &line);
            let fine = roots::<Dd>(&shape, &line);
            assert_eq!(fine.list.len(), count, "{width:e} {o:?} {d:?}");
            let agree = plain.list.len() == count;
            assert!(plain.uncertain || agree, "{width:e} {o:?} {d:?}");
        }
    }
}

#[test]
fn a_thousand_seams_alternate() {
    let mut r = Random(3);
    let profile: Vec<[f64; 2]> = (0..=1000)
        .map(|i| {
            let a = std::f64::consts::PI * f64::from(i) / 1000.0;
            [a.sin().abs(), -a.cos()]
        })
        .collect();
    let shape = Revolution::new(&profile, &[]);
    for _ in 0..3000 {
        let [x, y] = profile[1 + r.below(999) as usize];
        let a = r.within(0.0, TAU);
        let seam = Vec3::new(x * a.cos(), y, x * a.sin());
        let mut from = r.point(4.0);
        if r.below(4) == 0 {
            from[1] = y;
        }
        let line = Line::new(from, seam - from);
        let found = roots::<f64>(&shape, &line);
        assert!(found.list.len() <= 2);
        let fine = roots::<Dd>(&shape, &line);
        assert!(found.uncertain || found.list.len() == fine.list.len());
        // The chord of the unit sphere, if there is one worth the name: it is the polygon's to
        // within the sagitta 1 − cos(π/2000) < 1.3e-6.
        let d = line.direction;
        let b = line.origin.dot(d) / d.length();
        let chord2 = b * b - line.origin.dot(line.origin) + 1.0;
        if chord2 > 1e-2 {
            assert_eq!(found.list.len(), 2);
            for (root, sign) in found.list.iter().zip([-1.0, 1.0]) {
                let t = (-b + sign * chord2.sqrt()) / d.length();
                assert!((root.t - t).abs() * d.length() < 1e-4);
            }
        }
    }
}

#[test]
fn located_points_lie_on_the_surface_and_normals_look_outwards() {
    let mut r = Random(4);
    let (mut all, mut unsure) = (0, 0);
    for _ in 0..3000 {
        let profile = random_profile(&mut r, false);
        let size = [1e-3, 1.0, 1e3][r.below(3) as usize];
        let scaled: Vec<[f64; 2]> = profile.iter().map(|p| p.map(|x| x * size)).collect();
        let shape = Revolution::new(&scaled, &[]);
        let line = random_line(&mut r, false);
        let far = [0.0, -100.0, 1e6][r.below(3) as usize];
        let stretch = [1e-6, 1.0, 1e6][r.below(3) as usize];
        let line = Line::new(
            (line.origin + line.direction * far) * size,
            line.direction * stretch,
        );
        let (plain, fine) = (roots::<f64>(&shape, &line), roots::<Dd>(&shape, &line));
        // Two points there and back are a doubled layer, whose crossings coincide.
        if profile.len() > 3 {
            all += 1;
            unsure += usize::from(plain.uncertain);
        }
        if !plain.uncertain {
            assert_eq!(plain.list.len(), fine.list.len());
            for (a, b) in plain.list.iter().zip(&fine.list) {
                assert_eq!(a.face, b.face);
                let length = line.direction.length();
                let near = 1e-7 * size + 4.0 * f64::EPSILON * a.t.abs() * length;
                assert!((a.t - b.t.to_f64()).abs() * length <= near);
            }
        }
        for (i, root) in plain.list.into_iter().enumerate() {
            let at = Intersect::<f64>::locate(&shape, &line, root);
            assert!(at.point.is_finite() && at.error.is_finite() && at.normal.any());
            let sure = at.normal.unit().dot(line.direction.unit());
            if sure.abs() > 1e-6 {
                assert_eq!(sure < 0.0, i % 2 == 0);
            }
            // To the rounding of the origin.
            let off = (at.point - line.at(root.t)).length();
            assert!(off <= 1e-9 * size * (1.0 + far.abs()), "{off} {size} {far}");
            assert!(surface_is_in_the_box(&shape, &at, root.face));
            let [u, v] = shape.uv(at.point, root.face);
            assert!((0.0..=1.0).contains(&u) && (0.0..=1.0).contains(&v));
        }
    }
    // Few lines need another look.
    assert!(unsure * 100 < all, "{unsure} of {all}");
}

/// In twice the precision, the distance of a point from its segment's cone against what the error
/// box reaches across it.
fn surface_is_in_the_box(shape: &Revolution, at: &Located, face: u32) -> bool {
    let i = shape.segment(face);
    let [[ax, ay], [bx, by]] = [shape.points[i], shape.points[i + 1]].map(|p| p.map(Dd::of));
    let [x, y, z] = at.point.0.map(|c| Dd::of(c) * Dd::of(shape.scale));
    let (w, h) = (bx - ax, by - ay);
    let rho = (x * x + z * z).sqrt();
    let off = ((rho - ax) * h - (y - ay) * w).abs().to_f64();
    let [ex, ey, ez] = at.error.0.map(|e| e * shape.scale);
    let reach = ex.hypot(ez) * h.abs().to_f64() + ey * w.abs().to_f64();
    off <= reach
}

#[test]
fn any_finite_line_gives_finite_crossings() {
    let lathe = [[0.0, 2.0], [1.0, 1.0], [1.0, 0.0], [0.0, 0.0]];
    let sizes = [0.0, 1e-320, 1e-160, 1.0, 1e6, 1e160, 1e308];
    for scale in [1e-300, 1e-3, 1.0, 1e300] {
        let shape = Revolution::new(&lathe.map(|p| p.map(|x| x * scale)), &[]);
        for i in 0..7usize.pow(4) {
            let [a, b, c, d] = [i % 7, i / 7 % 7, i / 49 % 7, i / 343].map(|k| sizes[k]);
            if c == 0.0 && d == 0.0 {
                continue;
            }
            let line = Line::new(Vec3::new(a, b, 0.0), Vec3::new(c, -d, c));
            roots::<f64>(&shape, &line);
            roots::<f32>(&shape, &line);
            roots::<Dd>(&shape, &line);
        }
    }
}

#[test]
fn colours_and_coordinates_follow_the_arc() {
    let colours = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    // Arc lengths 2 and 1.
    let shape = Revolution::new(&[[1.0, 0.0], [1.0, 2.0], [2.0, 2.0]], &colours);
    let wall = Vec3::new(0.0, 0.5, -1.0);
    assert_eq!(shape.colour(wall, 0), Some([0.75, 0.25, 0.0]));
    assert_eq!(shape.uv(wall, 0), [0.25, 0.5 / 3.0]);
    assert_eq!(
        shape.colour(Vec3::new(1.5, 2.0, 0.0), 1),
        Some([0.0, 0.5, 0.5])
    );
    assert_eq!(shape.uv(Vec3::new(1.5, 2.0, 0.0), 1), [0.0, 2.5 / 3.0]);
    // The discs.
    assert_eq!(shape.colour(Vec3::new(0.5, 0.0, 0.0), 2), Some(colours[0]));
    assert_eq!(shape.uv(Vec3::new(0.5, 0.0, 0.0), 2), [0.0, 0.0]);
    assert_eq!(shape.colour(Vec3::new(0.5, 2.0, 0.0), 3), Some(colours[2]));
    assert_eq!(shape.uv(Vec3::new(0.5, 2.0, 0.0), 3), [0.0, 1.0]);
}

/// A spring of 100 000 segments: few runs of the tree concern a line.
#[test]
fn long_profiles_are_searched_by_the_tree() {
    let n = 100_000;
    let profile: Vec<[f64; 2]> = (0..=n)
        .map(|i| {
            let y = f64::from(i) / f64::from(n);
            [1.0 + 0.1 * (40.0 * y).sin(), y]
        })
        .collect();
    let shape = Revolution::new(&profile, &[]);
    let mut r = Random(5);
    let mut seen = 0;
    for _ in 0..1000 {
        let (from, to) = (r.point(3.0), r.point(1.0));
        let line = Line::new(from, to - from);
        let path = Path::new(&line, shape.scale, shape.centre).unwrap();
        let mut i = 0;
        while let Some(run) = shape.tree.get(i) {
            seen += 1;
            i = if path.misses(run) {
                run.next as usize
            } else {
                i + 1
            };
        }
        roots::<f64>(&shape, &line);
    }
    // Seventeen levels, some crossings each.
    assert!(seen / 1000 < 400, "{seen}");
}
