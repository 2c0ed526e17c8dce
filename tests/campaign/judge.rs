//! What the kernel says against what is true.

use super::bars::Bars;
use super::exact::{Exact, Point, along, dot, point};
use super::kernel::{self, Number};
use super::lines::Case;
use super::shapes::Target;
use super::truth::{Answer, Truth, alternates, length, norm};
use std::time::Instant;
use zpg::internals::geometry::dd::Dd;
use zpg::internals::scene::Geometry;
use zpg::internals::trace::shapes::{Primitive, Roots};

/// Where sides are looked for between crossings, these are taken to be no farther from the surface than
/// this, in the unit of [`Row::worst`].
const MAX_ERROR_UNITS: f64 = 64.0;

/// How many failures of a row are described.
const DESCRIBED: usize = 12;

/// The exponent of half of the least double, by which zero is moved.
const LEAST: i64 = -1075;

/// The results of one kind of number.
#[derive(Default)]
pub struct Row {
    pub precision: &'static str,
    pub rays: u64,
    /// Lines whose number of crossings, or their sides, are not those of the exact answer.
    pub wrong: u64,
    /// Those of them where the exact answer is the same for all lines whose numbers are half a unit
    /// in the last place larger or smaller; and crossings out of order, infinite or of the wrong
    /// side, however close.
    pub outside: u64,
    /// Lines that the kernel could not decide.
    pub uncertain: u64,
    /// Those of them where the place of a crossing is all that it does not know well enough.
    pub coarse: u64,
    /// Lines as in pictures, and those of them that it could not decide.
    pub plain: u64,
    pub plain_uncertain: u64,
    /// The largest distance of a crossing from the surface, in ε times the larger of the origin's
    /// distance and the shape's size.
    pub worst: f64,
    /// Per line, one a batch.
    pub nanoseconds: Vec<f64>,
    /// The first lines that break a rule.
    pub failures: Vec<String>,
}

impl Row {
    fn new<R: Number>() -> Row {
        Row {
            precision: R::NAME,
            ..Row::default()
        }
    }

    pub fn and(mut self, other: Row) -> Row {
        self.rays += other.rays;
        self.wrong += other.wrong;
        self.outside += other.outside;
        self.uncertain += other.uncertain;
        self.coarse += other.coarse;
        self.plain += other.plain;
        self.plain_uncertain += other.plain_uncertain;
        self.worst = self.worst.max(other.worst);
        self.nanoseconds.extend(other.nanoseconds);
        self.failures.extend(other.failures);
        self.failures.truncate(DESCRIBED);
        self
    }

    /// The median over the batches, which other work on the machine does not move.
    pub fn nanoseconds(&self) -> f64 {
        let mut all = self.nanoseconds.clone();
        all.sort_by(f64::total_cmp);
        all.get(all.len() / 2).copied().unwrap_or(0.0)
    }

    fn fail(&mut self, what: String) {
        if self.failures.len() < DESCRIBED {
            self.failures.push(what);
        }
    }

    fn doubt(&mut self, case: &Case, uncertain: bool) {
        self.rays += 1;
        self.uncertain += u64::from(uncertain);
        self.plain += u64::from(case.plain);
        self.plain_uncertain += u64::from(case.plain && uncertain);
    }
}

pub fn empty() -> [Row; 3] {
    [Row::new::<f32>(), Row::new::<f64>(), Row::new::<Dd>()]
}

/// Exact lines, in the space they are traced in and in the shape's.
struct Lines {
    origin: Point,
    direction: Point,
    map: Option<[[Exact; 4]; 3]>,
}

impl Lines {
    fn new(case: &Case) -> Lines {
        Lines {
            origin: point(case.origin),
            direction: point(case.direction),
            map: case.map.map(|rows| rows.map(|row| row.map(Exact::of))),
        }
    }

    /// In the shape's space.
    fn inner(&self, origin: &Point, direction: &Point) -> (Point, Point) {
        let Some(rows) = &self.map else {
            return (origin.clone(), direction.clone());
        };
        let times = |v: &Point| -> Point {
            rows.each_ref()
                .map(|row| &row[0] * &v[0] + &row[1] * &v[1] + &row[2] * &v[2])
        };
        let mut o = times(origin);
        for (x, row) in o.iter_mut().zip(rows) {
            *x = &*x + &row[3];
        }
        (o, times(direction))
    }

    /// Whether the answer is another one where each number of the line is moved by half a unit in
    /// its last place: one number, or all.
    fn changes_nearby<R: Number>(&self, truth: &Truth, answer: Answer) -> bool {
        let moved = |x: &Exact, way: i64| {
            if way == 0 {
                return x.clone();
            }
            x + Exact::power_of_two((x.top() - R::HALF_ULP).max(LEAST)) * Exact::whole(way)
        };
        let singles = (0..12).map(|k| {
            let mut ways = [0; 6];
            ways[k / 2] = if k % 2 == 0 { 1 } else { -1 };
            ways
        });
        let corners =
            (0..64).map(|k: usize| std::array::from_fn(|i| if k >> i & 1 == 0 { 1 } else { -1 }));
        // Single precision is often wrong, and shown only: the first will do.
        let all = if R::NAME == f32::NAME { 12 } else { 12 + 64 };
        singles.chain(corners).take(all).any(|ways: [i64; 6]| {
            let o = std::array::from_fn(|i| moved(&self.origin[i], ways[i]));
            let d = std::array::from_fn(|i| moved(&self.direction[i], ways[i + 3]));
            let (o, d) = self.inner(&o, &d);
            truth.answer(&o, &d) != answer
        })
    }
}

/// Traces and judges lines through one shape: by f32 with everything rounded to it, by f64 with
/// what it cannot decide decided by dd, and by dd. A crossing may be as far from the surface as the
/// bars say, in the unit of [`Row::worst`].
pub fn batch(target: &Target, cases: &[Case], bars: &Bars) -> [Row; 3] {
    let [mut single, mut double, mut dd] = empty();
    let primitive = kernel::primitive(&target.geometry);
    let doubles = traced::<f64>(&primitive, cases, &mut double);
    let dds = traced::<Dd>(&primitive, cases, &mut dd);
    let truth = Truth::new(&target.geometry);
    for (i, case) in cases.iter().enumerate() {
        let lines = Lines::new(case);
        let judge = Judge::new(target, &truth, case, &lines, bars);
        double.doubt(case, doubles[i].uncertain);
        double.coarse += u64::from(doubles[i].coarse);
        dd.doubt(case, dds[i].uncertain);
        judge.judge::<Dd, Dd>(&dds[i], &mut dd);
        if doubles[i].uncertain {
            judge.judge::<f64, Dd>(&dds[i], &mut double);
        } else {
            judge.judge::<f64, f64>(&doubles[i], &mut double);
        }
    }

    let target = rounded_target(target);
    let primitive = kernel::primitive(&target.geometry);
    let cases: Vec<Case> = cases.iter().map(rounded_case).collect();
    let singles = traced::<f32>(&primitive, &cases, &mut single);
    let truth = Truth::new(&target.geometry);
    for (case, roots) in cases.iter().zip(&singles) {
        let lines = Lines::new(case);
        single.doubt(case, roots.uncertain);
        Judge::new(&target, &truth, case, &lines, bars).judge::<f32, f32>(roots, &mut single);
    }
    [single, double, dd]
}

fn traced<R: Number>(primitive: &Primitive, cases: &[Case], row: &mut Row) -> Vec<Roots<R>> {
    let mut all: Vec<Roots<R>> = cases.iter().map(|_| Roots::default()).collect();
    let start = Instant::now();
    for (case, roots) in cases.iter().zip(&mut all) {
        kernel::crossings(primitive, case, roots);
    }
    let time = start.elapsed().as_nanos() as f64;
    row.nanoseconds.push(time / cases.len() as f64);
    all
}

fn round(x: f64) -> f64 {
    f64::from(x as f32)
}

fn rounded_case(case: &Case) -> Case {
    Case {
        origin: case.origin.map(round),
        direction: case.direction.map(round),
        map: case.map.map(|rows| rows.map(|row| row.map(round))),
        plain: case.plain,
    }
}

fn rounded_target(target: &Target) -> Target {
    let mut geometry = target.geometry.clone();
    match &mut geometry {
        Geometry::Revolution { profile, .. } => {
            for x in profile.iter_mut().flatten() {
                *x = round(*x);
            }
        }
        Geometry::Plane(v) | Geometry::HalfSpace(v) => *v = v.map(round),
        Geometry::Rectangle { min, max } => (*min, *max) = (min.map(round), max.map(round)),
        Geometry::Triangle { vertices, .. } => **vertices = vertices.map(|v| v.map(round)),
        Geometry::Sphere { centre, radius } => {
            (*centre, *radius) = (centre.map(round), round(*radius));
        }
        Geometry::Ellipsoid { semi_axes } => *semi_axes = semi_axes.map(round),
        Geometry::Box { min, max } => (*min, *max) = (min.map(round), max.map(round)),
        Geometry::GeodesicSphere { radius, .. } => *radius = round(*radius),
        Geometry::Torus { major, minor } => (*major, *minor) = (round(*major), round(*minor)),
        Geometry::Quadric(q) => **q = q.map(round),
        Geometry::Cone { height, radius } | Geometry::DoubleCone { height, radius } => {
            (*height, *radius) = (round(*height), round(*radius));
        }
        Geometry::ParabolicCylinder { a } => *a = round(*a),
        Geometry::HyperbolicCylinder { a, b } | Geometry::HyperbolicParaboloid { a, b } => {
            (*a, *b) = (round(*a), round(*b));
        }
        Geometry::Hyperboloid { a, b, c, .. } => {
            (*a, *b, *c) = (round(*a), round(*b), round(*c));
        }
    }
    Target {
        geometry,
        anchors: vec![],
        marks: Default::default(),
        directions: vec![],
        ..*target
    }
}

/// A line with all that is true of it.
struct Judge<'a> {
    target: &'a Target,
    truth: &'a Truth,
    case: &'a Case,
    lines: &'a Lines,
    bars: &'a Bars,
    o: Point,
    d: Point,
    answer: Answer,
    /// The larger of the origin's distance and the shape's size. For a mapped line it is how far
    /// from the shape's origin the terms of the map reach, which is the distance of the line's
    /// origin, or of the shape, from the origin of the line's space.
    scale: f64,
}

impl<'a> Judge<'a> {
    fn new(
        target: &'a Target,
        truth: &'a Truth,
        case: &'a Case,
        lines: &'a Lines,
        bars: &'a Bars,
    ) -> Judge<'a> {
        let (o, d) = lines.inner(&lines.origin, &lines.direction);
        let own = norm(&o).max(length(target.centre) + target.size);
        let scale = own.max(case.terms(case.origin));
        Judge {
            answer: truth.answer(&o, &d),
            target,
            truth,
            case,
            lines,
            bars,
            o,
            d,
            scale,
        }
    }

    /// Judges crossings computed with the numbers `C` by the bars of `R`.
    fn judge<R: Number, C: Number>(&self, roots: &Roots<C>, row: &mut Row) {
        let finite = roots.list.iter().all(|r| r.t.is_finite());
        let ascending = roots.list.windows(2).all(|w| w[0].t < w[1].t);
        if !finite || !ascending {
            row.wrong += 1;
            row.outside += 1;
            row.fail(self.describe("crossings infinite or not ascending", roots));
            return;
        }
        let right = self.answer.admits(roots.list.len(), roots.inside);
        if !right {
            row.wrong += 1;
            if !self.lines.changes_nearby::<R>(self.truth, self.answer) {
                row.outside += 1;
                row.fail(self.describe("wrong number or side", roots));
                return;
            }
        }
        let t: Vec<Exact> = roots.list.iter().map(|r| r.t.exact()).collect();
        let mut worst: f64 = 0.0;
        let mut reach = self.scale;
        for t in &t {
            let p = along(&self.o, &self.d, t);
            let scale = if self.target.unbounded {
                let outer = along(&self.lines.origin, &self.lines.direction, t);
                let terms = self.case.terms(outer.map(|x| x.about()));
                self.scale.max(norm(&p)).max(terms)
            } else {
                self.scale
            };
            reach = reach.max(scale);
            let error = self.truth.distance(&p, &self.d) / (R::EPSILON * scale);
            worst = worst.max(error);
        }
        row.worst = row.worst.max(worst);
        let bar = self.bars.of(R::NAME);
        let good = worst <= bar;
        if !good {
            let what = format!("{worst:.1} ε away from the surface");
            row.fail(self.describe(&what, roots));
        }
        let tolerance = bar.min(MAX_ERROR_UNITS) * R::EPSILON * reach;
        if right
            && self.truth.is_solid()
            && !alternates(self.truth, (&self.o, &self.d), &t, roots.inside, tolerance)
        {
            row.wrong += 1;
            row.outside += 1;
            row.fail(self.describe("sides do not alternate", roots));
        }
    }

    fn describe<C: Number>(&self, what: &str, roots: &Roots<C>) -> String {
        let t: Vec<_> = roots.list.iter().map(|r| r.t).collect();
        let foot = (-dot(&self.o, &self.d)).over(&dot(&self.d, &self.d), 64).0;
        format!(
            "{what}: {:?}, o {:?} d {:?} map {:?}; exact {:?}, got inside {} t {t:?}{} (closest to \
             the shape's origin at t = {:e}, scale {:e})",
            self.target.geometry,
            self.case.origin,
            self.case.direction,
            self.case.map,
            self.answer,
            roots.inside,
            if roots.uncertain { " uncertain" } else { "" },
            foot.about(),
            self.scale,
        )
    }
}
