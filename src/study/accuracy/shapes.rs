//! Time and error of a ray for each shape, each kind of numbers and each solver, without a scene.

use super::sample_tiles::Random;
use crate::geometry::dd::Dd;
use crate::geometry::line::Line;
use crate::geometry::vec::Vec3;
use crate::scene::Geometry;
use crate::study::naive::Wide;
use crate::study::naive::form::{self, NaiveShape};
use crate::study::naive::number::{Number, Ray, V, cross, unit, vector};
use crate::study::plain::solver::{self, Method};
use crate::trace::shapes::{Primitive, Roots};
use cpu_time::ThreadTime;
use serde::Serialize;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

/// The results for one shape, one solver and one sort of lines.
#[derive(Debug, Clone, Serialize)]
pub struct ShapeResult {
    pub shape: &'static str,
    /// The kernel and its numbers, or the solver: `plain-f32`, …, `dd`, `recentred`, `polished-dd`.
    pub way: &'static str,
    /// The sort of lines: `plain` or `tangent`.
    pub lines: &'static str,
    pub nanoseconds: f64,
    /// The share of lines on which another number of crossings was found than there are.
    pub wrong: f64,
    /// The median error of a crossing on the other lines, divided by its distance or, where that is less, the size of
    /// the shape.
    pub median_error: f64,
    /// The largest error of a crossing, divided likewise.
    pub max_error: f64,
    /// The share of lines that the numbers could not decide. In `f64` double-double decides them, which is not timed.
    pub uncertain: f64,
}

/// The number of lines of each sort.
const LINES: usize = 400;

/// The shapes that are tried, of a size of about 1.
fn shapes() -> Vec<(&'static str, Geometry)> {
    let torus = |minor| Geometry::Torus { major: 1.0, minor };
    vec![
        (
            "sphere",
            Geometry::Sphere {
                centre: [0.5, -0.25, 0.125],
                radius: 1.0,
            },
        ),
        (
            "box",
            Geometry::Box {
                min: [-0.5, -0.75, -1.0],
                max: [1.0, 0.5, 0.75],
            },
        ),
        ("half-space", Geometry::HalfSpace([0.3, 0.9, 0.1, 0.2])),
        (
            "rectangle",
            Geometry::Rectangle {
                min: [-1.0, -0.5],
                max: [0.5, 1.0],
            },
        ),
        (
            "triangle",
            Geometry::Triangle {
                vertices: Box::new([[-1.0, -0.8, 0.1], [1.0, -0.6, 0.0], [0.1, 0.9, -0.2]]),
                normals: crate::scene::TriangleNormals::Flat,
            },
        ),
        (
            "ellipsoid",
            Geometry::Ellipsoid {
                semi_axes: [1.0, 0.4, 0.7],
            },
        ),
        (
            "cone",
            Geometry::Cone {
                height: 1.2,
                radius: 0.8,
            },
        ),
        (
            "double cone",
            Geometry::DoubleCone {
                height: 0.9,
                radius: 0.7,
            },
        ),
        (
            "hyperboloid",
            Geometry::Hyperboloid {
                a: 0.5,
                b: 0.7,
                c: 0.6,
                sheets: 1,
            },
        ),
        (
            "hyperbolic paraboloid",
            Geometry::HyperbolicParaboloid { a: 0.9, b: 1.1 },
        ),
        ("torus, tube 1/4", torus(0.25)),
        ("torus, tube 1e-4", torus(1e-4)),
        ("torus, spindle", torus(1.25)),
        (
            "lathe, 4 points",
            Geometry::Revolution {
                profile: vec![[0.5, -1.0], [1.0, 0.0], [0.25, 0.6], [0.4, 1.0]],
                colours: Vec::new(),
            },
        ),
        (
            "lathe, 40 points",
            Geometry::Revolution {
                profile: (0..40)
                    .map(|i| {
                        let y = f64::from(i) / 19.5 - 1.0;
                        [0.6 + 0.3 * (5.0 * y).sin(), y]
                    })
                    .collect(),
                colours: Vec::new(),
            },
        ),
        (
            "geodesic sphere, 4 splits",
            Geometry::GeodesicSphere {
                radius: 1.0,
                splits: 4,
            },
        ),
    ]
}

/// A line with the exact t of its crossings.
struct ReferenceLine {
    origin: V<f64>,
    direction: V<f64>,
    exact: Vec<Wide>,
}

fn exact(form: &NaiveShape<Wide>, origin: V<f64>, direction: V<f64>) -> ReferenceLine {
    let mut roots = form::Roots::default();
    let ray = Ray {
        origin: vector(origin),
        direction: vector(direction),
    };
    form.cross(&ray, &mut roots);
    ReferenceLine {
        origin,
        direction,
        exact: roots.list.into_iter().map(|r| r.0).collect(),
    }
}

fn direction(random: &mut Random) -> V<f64> {
    loop {
        let v = [0, 1, 2].map(|_| 2.0 * random.unit() - 1.0);
        let square: f64 = v.iter().map(|x| x * x).sum();
        if (0.01..1.0).contains(&square) {
            return unit(v);
        }
    }
}

/// Makes lines that pass the shape at random, as the rays of a picture do.
fn plain_lines(form: &NaiveShape<Wide>, random: &mut Random) -> Vec<ReferenceLine> {
    (0..LINES)
        .map(|_| {
            let d = direction(random);
            let aim = [0, 1, 2].map(|_| 2.4 * random.unit() - 1.2);
            let far = 4.0 + 6.0 * random.unit();
            exact(form, [0, 1, 2].map(|i| aim[i] - far * d[i]), d)
        })
        .collect()
}

/// Makes lines along tangents of the surface, shifted along the normal by 1e-3 to 1e-12.
fn tangent_lines(
    form: &NaiveShape<Wide>,
    plain: &[ReferenceLine],
    random: &mut Random,
) -> Vec<ReferenceLine> {
    let mut lines = Vec::new();
    let met: Vec<&ReferenceLine> = plain.iter().filter(|k| !k.exact.is_empty()).collect();
    while lines.len() < LINES && !met.is_empty() {
        let known = met[random.below(met.len())];
        let t = known.exact[random.below(known.exact.len())].wide();
        let p = [0, 1, 2].map(|i| known.origin[i] + t * known.direction[i]);
        let mut roots = form::Roots::default();
        let ray = Ray {
            origin: vector(known.origin),
            direction: vector(known.direction),
        };
        form.cross(&ray, &mut roots);
        let face = roots
            .list
            .iter()
            .find(|r| (r.0.wide() - t).abs() < 1e-9)
            .map_or(0, |r| r.1);
        let n = unit(form.normal(vector(p), face).map(Wide::wide));
        let d = unit(cross(n, direction(random)));
        let aside =
            10f64.powf(-3.0 - 9.0 * random.unit()) * if random.below(2) == 0 { 1.0 } else { -1.0 };
        let far = 4.0 + 6.0 * random.unit();
        lines.push(exact(
            form,
            [0, 1, 2].map(|i| p[i] + aside * n[i] - far * d[i]),
            d,
        ));
    }
    lines
}

/// A function that appends the t of a line's crossings, each as a sum of two parts, and returns whether they are
/// certain.
type CrossingSolver<'w> = Box<dyn Fn(&Line, &mut Vec<(f64, f64)>) -> bool + 'w>;

fn ways<'w>(
    geometry: &'w Geometry,
    primitive: &'w Primitive,
) -> Vec<(&'static str, CrossingSolver<'w>)> {
    fn ours<R: crate::geometry::line::Traced>(primitive: &Primitive) -> CrossingSolver<'_> {
        let roots = std::cell::RefCell::new(Roots::<R>::default());
        Box::new(move |line, out| {
            let mut roots = roots.borrow_mut();
            roots.clear();
            primitive
                .intersect::<R>()
                .crossings(&line.cast(), &mut roots);
            out.extend(roots.list.iter().map(|r| r.t.parts()));
            !roots.uncertain
        })
    }
    fn plain<T: Number + 'static>(geometry: &Geometry) -> Option<CrossingSolver<'static>> {
        let form = NaiveShape::<T>::new(geometry)?;
        let roots = std::cell::RefCell::new(form::Roots::<T>::default());
        Some(Box::new(move |line, out| {
            let mut roots = roots.borrow_mut();
            let ray = Ray {
                origin: vector(line.origin.0),
                direction: vector(line.direction.0),
            };
            form.cross(&ray, &mut roots);
            out.extend(roots.list.iter().map(|r| (r.0.wide(), 0.0)));
            true
        }))
    }
    let mut all: Vec<(&'static str, CrossingSolver)> = Vec::new();
    all.extend(plain::<f32>(geometry).map(|w| ("plain-f32", w)));
    all.extend(plain::<f64>(geometry).map(|w| ("plain-f64", w)));
    all.push(("f32", ours::<f32>(primitive)));
    all.push(("f64", ours::<f64>(primitive)));
    all.push(("dd", ours::<Dd>(primitive)));
    for (name, method) in [
        ("recentred", Method::Recentred),
        ("polished-dd", Method::Polished),
    ] {
        if let Some(solver) = solver::of_shape(geometry, method) {
            let roots = std::cell::RefCell::new(Roots::default());
            let way: CrossingSolver = Box::new(move |line, out| {
                let mut roots = roots.borrow_mut();
                roots.clear();
                solver.crossings(0, line, &mut roots);
                out.extend(roots.list.iter().map(|r| (r.t, 0.0)));
                !roots.uncertain
            });
            all.push((name, way));
        }
    }
    all
}

/// Measures a solver for about `seconds` seconds. Returns nanoseconds a line, the share of wrong lines, the median and
/// the largest error, and the share of uncertain lines. An uncertain line is given to `finer`, if there is one, but
/// this is not timed.
fn measure(
    way: &CrossingSolver,
    finer: Option<&CrossingSolver>,
    lines: &[ReferenceLine],
    seconds: f64,
) -> (f64, f64, f64, f64, f64) {
    let traced: Vec<Line> = (lines.iter())
        .map(|k| Line::new(Vec3(k.origin), Vec3(k.direction)))
        .collect();
    let mut found = Vec::new();
    let (mut wrong, mut uncertain, mut errors) = (0, 0, Vec::new());
    for (known, line) in lines.iter().zip(&traced) {
        found.clear();
        if !way(line, &mut found) {
            uncertain += 1;
            if let Some(finer) = finer {
                found.clear();
                finer(line, &mut found);
            }
        }
        if found.len() != known.exact.len() {
            wrong += 1;
            continue;
        }
        for (t, exact) in found.iter().zip(&known.exact) {
            let off = Wide::of(t.0) + Wide::of(t.1) - *exact;
            errors.push(off.abs().wide() / exact.wide().abs().max(1.0));
        }
    }
    errors.sort_by(f64::total_cmp);
    let each = Duration::from_secs_f64(seconds / 5.0);
    let mut least = f64::INFINITY;
    for _ in 0..5 {
        let (start, mut runs) = (ThreadTime::now(), 0);
        while runs == 0 || start.elapsed() < each {
            for line in &traced {
                found.clear();
                std::hint::black_box(way(line, &mut found));
            }
            runs += 1;
        }
        let per_line = start.elapsed().as_secs_f64() / (runs * traced.len()) as f64;
        least = least.min(per_line * 1e9);
    }
    let n = lines.len().max(1) as f64;
    (
        least,
        wrong as f64 / n,
        errors.get(errors.len() / 2).copied().unwrap_or(0.0),
        errors.last().copied().unwrap_or(0.0),
        uncertain as f64 / n,
    )
}

/// Measures all shapes with all solvers, in about `seconds` seconds. `progress` gets the share that is done.
pub fn run(seconds: f64, stop: &AtomicBool, progress: &dyn Fn(f64)) -> Vec<ShapeResult> {
    let all = shapes();
    let mut entries = Vec::new();
    // Each shape has about six solvers and two sorts of lines.
    let each = 0.8 * seconds / (all.len() * 12) as f64;
    for (i, (shape, geometry)) in all.iter().enumerate() {
        let Some(form) = NaiveShape::<Wide>::new(geometry) else {
            continue;
        };
        let mut random = Random::new(i as u64);
        let plain = plain_lines(&form, &mut random);
        let tangent = tangent_lines(&form, &plain, &mut random);
        let primitive = Primitive::new(geometry);
        let ways = ways(geometry, &primitive);
        let dd = ways.iter().find(|w| w.0 == "dd").map(|w| &w.1);
        for (name, way) in &ways {
            for (sort, lines) in [("plain", &plain), ("tangent", &tangent)] {
                if stop.load(Ordering::Relaxed) {
                    return entries;
                }
                let (nanoseconds, wrong, median_error, max_error, uncertain) =
                    measure(way, dd.filter(|_| *name == "f64"), lines, each);
                entries.push(ShapeResult {
                    shape,
                    way: name,
                    lines: sort,
                    nanoseconds,
                    wrong,
                    median_error,
                    max_error,
                    uncertain,
                });
            }
        }
        progress((i + 1) as f64 / all.len() as f64);
    }
    entries
}

/// The results as a table in Markdown, which the terminal shows, too. `head` is its first line.
pub fn table(entries: &[ShapeResult], head: &str) -> String {
    let share = |x: f64| match x {
        0.0 => "0".to_owned(),
        x => format!("{:.1} %", 100.0 * x),
    };
    let cells: Vec<[String; 8]> = (entries.iter())
        .map(|e| {
            [
                e.shape.to_owned(),
                e.way.to_owned(),
                e.lines.to_owned(),
                format!("{:.0}", e.nanoseconds),
                share(e.wrong),
                format!("{:.0e}", e.median_error),
                format!("{:.0e}", e.max_error),
                share(e.uncertain),
            ]
        })
        .collect();
    let heads: Vec<&str> = head.trim_matches('|').split('|').map(str::trim).collect();
    let width = |c: usize| {
        let own = heads.get(c).map_or(0, |h| h.chars().count());
        cells
            .iter()
            .map(|row| row[c].chars().count())
            .fold(own, usize::max)
    };
    let widths: Vec<usize> = (0..8).map(width).collect();
    let line = |row: &dyn Fn(usize) -> String| -> String {
        let cells: Vec<String> = (0..8)
            .map(|c| {
                let text = row(c);
                let pad = " ".repeat(widths[c].saturating_sub(text.chars().count()));
                if c < 3 { text + &pad } else { pad + &text }
            })
            .collect();
        format!("| {} |\n", cells.join(" | "))
    };
    let mut out = line(&|c| heads.get(c).copied().unwrap_or_default().to_owned());
    let rule: Vec<String> = (0..8)
        .map(|c| {
            let dashes = "-".repeat(widths[c]);
            if c < 3 {
                format!("-{dashes}-")
            } else {
                format!("-{dashes}:")
            }
        })
        .collect();
    out += &format!("|{}|\n", rule.join("|"));
    for row in &cells {
        out += &line(&|c| row[c].clone());
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The tracer's doubles must be right wherever they are certain, and closer than any size matters.
    #[test]
    fn exact_crossings_are_those_of_the_tracer_where_it_is_certain() {
        for (name, geometry) in shapes() {
            let form = NaiveShape::<Wide>::new(&geometry).unwrap();
            let primitive = Primitive::new(&geometry);
            let mut random = Random::new(5);
            let mut certain = 0;
            for known in plain_lines(&form, &mut random).iter().take(60) {
                let line = Line::new(Vec3(known.origin), Vec3(known.direction));
                let mut roots = Roots::<f64>::default();
                primitive.intersect().crossings(&line, &mut roots);
                if roots.uncertain {
                    continue;
                }
                certain += 1;
                assert_eq!(roots.list.len(), known.exact.len(), "{name} {line:?}");
                for (root, exact) in roots.list.iter().zip(&known.exact) {
                    let off = (Wide::of(root.t) - *exact).abs().wide();
                    assert!(off < 1e-9, "{name} {off:e} {line:?}");
                }
            }
            assert!(certain > 40, "{name} {certain}");
        }
    }
}
