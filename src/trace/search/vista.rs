//! What rays from a fixed point, or to it, may meet: found by their direction, without a tree.
//!
//! A cube around the point has a grid of cells on each face. A cell lists the parts whose boxes are behind it as seen
//! from the point, the nearest first. That is POV-Ray's vista buffer where the point is the eye, and a light buffer
//! where it is a light (Haines and Greenberg, "The Light Buffer", IEEE CG&A 6(9), 1986).
//!
//! No box that a ray meets is missed: boxes are widened by more than a ray in doubles may be off the straight line
//! between its ends.

use crate::geometry::aabb::Aabb;
use crate::geometry::vec::Vec3;
use crate::geometry::wide_bvh::{above, below};
use crate::trace::graph::{Graph, Operation};
use std::sync::Arc;
use wide::f32x4;

/// What is in which direction from a point.
#[derive(Debug)]
pub struct Vista {
    parts: Arc<[(u32, Aabb)]>,
    /// By axis and, below and above, by the sign of a direction's largest component.
    faces: [[Face; 2]; 3],
    /// Rays that come from farther away may be off by more than boxes are widened.
    far: f64,
}

/// What is seen from the eye and from each light, where that is known.
#[derive(Debug, Default)]
pub struct Vistas {
    pub eye: Option<Vista>,
    /// Beside the lights.
    pub lights: Vec<Option<Vista>>,
}

/// Whether one end of a ray is a point from which it is known what lies in which direction.
#[derive(Debug, Clone, Copy)]
pub enum End<'v> {
    /// The ray starts there, and has a direction of length 1.
    At(&'v Vista),
    /// The ray is there at t = 1.
    To(&'v Vista),
    /// Neither end is such a point.
    Anywhere,
}

/// One face of the cube. Its coordinates are the other two components of a direction over the largest one.
#[derive(Debug, Default)]
struct Face {
    /// The lower corner of what is seen, and cells per unit.
    lower: [f64; 2],
    scale: [f64; 2],
    /// Cells in a row, and rows.
    side: usize,
    /// Where the list of each cell begins in `lists`; the last one is the end of all.
    starts: Vec<u32>,
    lists: Vec<Seen>,
}

/// A part as it is seen through a face.
#[derive(Debug, Clone, Copy)]
struct Seen {
    /// Which of the vista's parts.
    index: u32,
    /// No point of it is nearer.
    near: f32,
    /// The rectangle around it, in cells: lower x, lower y, −upper x, −upper y. One comparison with (x, y, −x, −y) tests
    /// all four sides.
    sides: [f32; 4],
}

/// Boxes are wider by this part of the largest coordinate there is.
const WIDER: f64 = 1e-9;
/// So many times that coordinate away a ray may start. Its direction is rounded once, which takes it less than 10⁻¹²
/// of that coordinate off: a thousandth of what boxes are wider by.
const FAR: f64 = 1e3;
/// Distances are known to this part of themselves.
const KNOWN: f64 = 1e-6;
/// Rectangles are wider by this part of a cell: in single precision a place in the last cell of a row is known to 2⁻¹⁷.
const MARGIN: f64 = 1e-4;
/// What two roundings may do to a coordinate of a face, several times over.
const ROUNDED: f64 = 16.0 * f64::EPSILON;
/// So many cells for each part that is seen through a face, and so many cells in a row at most.
const CELLS: f64 = 4.0;
const MOST: f64 = 256.0;

/// The parts with bounds that a scene is a union of, in their boxes; `None` where there are more than so many.
pub fn parts(graph: &Graph, most: usize) -> Option<Arc<[(u32, Aabb)]>> {
    let root = graph.root();
    let Operation::Union(group) = &root.operation else {
        return None;
    };
    let is_small = group.tree.items().take(most + 1).count() <= most;
    is_small.then(|| group.tree.boxes(&root.frame).collect())
}

impl Vista {
    /// What of some parts is seen from a point; `None` where there are no numbers for it.
    pub fn new(parts: &Arc<[(u32, Aabb)]>, point: Vec3) -> Option<Vista> {
        let reaches = parts.iter().map(|(_, b)| b.reach());
        let reach = reaches.fold(point.abs().max_component(), f64::max);
        let wider = WIDER * reach;
        if !(wider.is_normal() && reach.is_finite()) {
            return None;
        }
        let mut around: Vec<(f64, u32, Aabb)> = (0..)
            .zip(parts.iter())
            .map(|(index, (_, b))| {
                let min = [0, 1, 2].map(|i| b.min[i] - point[i] - wider);
                let max = [0, 1, 2].map(|i| b.max[i] - point[i] + wider);
                let gap = Vec3([0, 1, 2].map(|i| min[i].max(-max[i]).max(0.0)));
                (gap.length() * (1.0 - KNOWN), index, Aabb { min, max })
            })
            .collect();
        around.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        let face = |axis: usize, sign: f64| {
            let seen = around.iter().filter_map(|(near, index, b)| {
                let [lower, upper] = footprint(b, axis, sign)?;
                Some((*index, *near, lower, upper))
            });
            Face::new(&seen.collect::<Vec<_>>())
        };
        Some(Vista {
            parts: Arc::clone(parts),
            faces: [0, 1, 2].map(|axis| [-1.0, 1.0].map(|sign| face(axis, sign))),
            far: FAR * reach,
        })
    }

    /// What a ray from the point may meet: the least distance of each part, its number, and its box.
    pub fn leaving(&self, direction: Vec3) -> impl Iterator<Item = (f64, &(u32, Aabb))> {
        let [x, y, z] = direction.abs().0;
        let axis = match () {
            () if x >= y && x >= z => 0,
            () if y >= z => 1,
            () => 2,
        };
        let largest = direction[axis];
        let face = &self.faces[axis][usize::from(largest > 0.0)];
        let behind = face.behind(others(axis).map(|i| direction[i] * largest.abs().recip()));
        behind.map(|seen| (f64::from(seen.near), &self.parts[seen.index as usize]))
    }

    /// What a ray may meet that comes to the point by a way: as [`leaving`](Self::leaving). `None`: it comes from too
    /// far away.
    pub fn arriving(&self, way: Vec3) -> Option<impl Iterator<Item = (f64, &(u32, Aabb))>> {
        let size = way.abs().max_component();
        let length = way.length() * (1.0 + KNOWN);
        let is_within = move |(near, _): &(f64, _)| *near <= length;
        (size <= self.far).then(|| self.leaving(-way).take_while(is_within))
    }
}

/// The axes across.
fn others(axis: usize) -> [usize; 2] {
    [(axis + 1) % 3, (axis + 2) % 3]
}

/// The rectangle around a box, as seen from the origin through a face, whose own coordinates are between −1 and 1;
/// `None` where it is not seen.
fn footprint(b: &Aabb, axis: usize, sign: f64) -> Option<[[f64; 2]; 2]> {
    let [near, far] = match sign > 0.0 {
        true => [b.min[axis], b.max[axis]],
        false => [-b.max[axis], -b.min[axis]],
    };
    if far <= 0.0 {
        return None;
    }
    let near = near.max(0.0);
    let edge = 1.0 + ROUNDED;
    // Of what is on one side, the nearest is farthest aside.
    let lower = others(axis).map(|i| {
        let low = b.min[i];
        (low / if low < 0.0 { near } else { far }).max(-edge)
    });
    let upper = others(axis).map(|i| {
        let high = b.max[i];
        (high / if high > 0.0 { near } else { far }).min(edge)
    });
    let is_seen = (0..2).all(|i| lower[i] <= edge && upper[i] >= -edge);
    is_seen.then_some([lower, upper])
}

impl Face {
    /// Of parts with their distances and rectangles, the nearest first.
    fn new(parts: &[(u32, f64, [f64; 2], [f64; 2])]) -> Face {
        if parts.is_empty() {
            return Face::default();
        }
        let mut lower = [f64::INFINITY; 2];
        let mut upper = [f64::NEG_INFINITY; 2];
        for (_, _, from, to) in parts {
            lower = [0, 1].map(|i| lower[i].min(from[i]));
            upper = [0, 1].map(|i| upper[i].max(to[i]));
        }
        let size = [0, 1].map(|i| (upper[i] - lower[i]).max(KNOWN));
        // How many parts lie behind one another, on average.
        let share = |i: usize, from: &[f64; 2], to: &[f64; 2]| (to[i] - from[i]) / size[i];
        let shares = parts
            .iter()
            .map(|(_, _, from, to)| share(0, from, to) * share(1, from, to));
        let depth = shares.sum::<f64>().max(1.0);
        let side = (CELLS * parts.len() as f64 / depth)
            .sqrt()
            .ceil()
            .clamp(1.0, MOST);
        let scale = size.map(|size| side / size);
        let seen: Vec<Seen> = parts
            .iter()
            .map(|&(index, near, from, to)| {
                let margin = [0, 1].map(|i| MARGIN + ROUNDED * scale[i]);
                Seen {
                    index,
                    // Infinite ones are far, but not beyond what a ray may meet.
                    near: below(near.min(f32::MAX.into())),
                    sides: [
                        below((from[0] - lower[0]) * scale[0] - margin[0]),
                        below((from[1] - lower[1]) * scale[1] - margin[1]),
                        -above((to[0] - lower[0]) * scale[0] + margin[0]),
                        -above((to[1] - lower[1]) * scale[1] + margin[1]),
                    ],
                }
            })
            .collect();
        let side = side as usize;
        let mut starts = vec![0; side * side + 1];
        let cells = |seen: &Seen| {
            let [columns, rows] =
                [0, 1].map(|i| cell(seen.sides[i], side)..=cell(-seen.sides[i + 2], side));
            rows.flat_map(move |row| columns.clone().map(move |column| row * side + column))
        };
        for cell in seen.iter().flat_map(cells) {
            starts[cell + 1] += 1;
        }
        for i in 1..starts.len() {
            starts[i] += starts[i - 1];
        }
        let mut ends = starts.clone();
        let mut lists = vec![seen[0]; starts[side * side] as usize];
        for seen in &seen {
            for cell in cells(seen) {
                lists[ends[cell] as usize] = *seen;
                ends[cell] += 1;
            }
        }
        Face {
            lower,
            scale,
            side,
            starts,
            lists,
        }
    }

    /// The parts behind a point of the face, the nearest first.
    fn behind(&self, [u, v]: [f64; 2]) -> impl Iterator<Item = &Seen> {
        let x = ((u - self.lower[0]) * self.scale[0]) as f32;
        let y = ((v - self.lower[1]) * self.scale[1]) as f32;
        let list = match self.side {
            0 => &[][..],
            side => {
                let cell = cell(y, side) * side + cell(x, side);
                &self.lists[self.starts[cell] as usize..self.starts[cell + 1] as usize]
            }
        };
        // One branch: the processor could not predict four.
        let at = f32x4::new([x, y, -x, -y]);
        list.iter()
            .filter(move |seen| f32x4::new(seen.sides).simd_le(at).all())
    }
}

/// The cell of a row that a coordinate is in, or that is nearest to it.
fn cell(x: f32, side: usize) -> usize {
    (x.max(0.0) as usize).min(side - 1)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::dd::Dd;
    use crate::testing::{random, scene};
    use crate::trace::search::hit::Hit;
    use crate::trace::{Ray, Tracer};
    use std::fmt::Write;

    /// A number from −1 to 1.
    fn number(next: &mut impl FnMut(u64) -> u64) -> f64 {
        next(2_000_001) as f64 / 1e6 - 1.0
    }

    fn vector(next: &mut impl FnMut(u64) -> u64) -> Vec3 {
        Vec3([0; 3].map(|_| number(next)))
    }

    /// Boxes of many sizes, some of them flat, near a point and around it.
    fn boxes(next: &mut impl FnMut(u64) -> u64, scale: f64) -> Arc<[(u32, Aabb)]> {
        (0..40)
            .map(|part| {
                let size = 10f64.powi(-(next(4) as i32));
                let middle = vector(next);
                let half = Vec3([0; 3].map(|_| size * (next(4) as f64 / 4.0)));
                let [min, max] = [middle - half, middle + half].map(|corner| corner * scale);
                (part, Aabb::new(min, max))
            })
            .collect()
    }

    #[test]
    fn no_box_on_a_rays_way_is_missed() {
        let mut next = random();
        let (mut met, mut listed) = (0, 0);
        for round in 0..400 {
            let scale = 10f64.powi(round % 25 - 12);
            let parts = boxes(&mut next, scale);
            let point = vector(&mut next) * scale * [0.5, 1.0, 20.0][next(3) as usize];
            let vista = Vista::new(&parts, point).unwrap();
            for _ in 0..200 {
                // To the corner of a box, along an axis, on an edge of the cube, or anywhere.
                let (_, b) = &parts[next(40) as usize];
                let to = match next(5) {
                    0 => Vec3([0, 1, 2].map(|i| [b.min, b.max][next(2) as usize][i])),
                    1 => {
                        let mut to = point;
                        to[next(3) as usize] += number(&mut next) * scale;
                        to
                    }
                    2 => point + Vec3([1.0, 1.0, number(&mut next)]) * scale,
                    _ => vector(&mut next) * scale,
                };
                let way = point - to;
                if !way.any() {
                    continue;
                }
                let list: Vec<u32> = vista
                    .arriving(way)
                    .unwrap()
                    .map(|(_, (part, _))| *part)
                    .collect();
                let line = Ray::new(to, way).line;
                for (part, b) in parts.iter() {
                    // But for what is rounded where it is clipped.
                    let hair = Vec3::ONE * (1e-12 * scale);
                    let inner = Aabb::new(Vec3(b.min) + hair, Vec3(b.max) - hair);
                    let meets = inner.clip(&line, 0.0, 1.0).is_some();
                    met += u32::from(meets);
                    assert!(!meets || list.contains(part), "{point:?} {to:?} {b:?}");
                }
                listed += list.len() as u32;
                let near: Vec<f64> = vista.leaving(-way).map(|(near, _)| near).collect();
                assert!(near.is_sorted());
            }
        }
        // The lists are short.
        assert!(met > 50_000 && listed < 2 * met, "{met} of {listed}");
    }

    #[test]
    fn points_without_numbers_have_no_vista() {
        let parts: Arc<[(u32, Aabb)]> = Arc::new([(0, Aabb::new([0.0; 3], [1.0; 3]))]);
        let far = Vec3::new(f64::INFINITY, 0.0, 0.0);
        assert!(Vista::new(&parts, far).is_none());
        assert!(Vista::new(&Arc::default(), Vec3::ZERO).is_none());
        let vista = Vista::new(&parts, Vec3::ONE * 3.0).unwrap();
        assert!(vista.arriving(Vec3::ONE * 1e5).is_none());
        assert!(vista.arriving(Vec3::ONE * f64::NAN).is_none());
        assert_eq!(vista.leaving(Vec3::ONE).count(), 0);
        assert_eq!(vista.leaving(-Vec3::ONE).count(), 1);
    }

    /// A union of shapes of all kinds, some of them cut and in groups, and a half-space.
    fn things(next: &mut impl FnMut(u64) -> u64) -> String {
        let mut text = String::from("3 4 0 1 0 5\n");
        let mut root = 3;
        for id in (10..210).step_by(5) {
            let size = 0.2 + number(next).abs();
            let half = size / 2.0;
            let _ = match next(7) {
                0 => writeln!(text, "{id} 9 {size}"),
                1 => writeln!(text, "{id} 14 {size} {half}"),
                2 => writeln!(text, "{id} 16 {size} {half}"),
                3 => writeln!(text, "{id} 12 0 0 0 {size} {half} 1"),
                4 => writeln!(text, "{id} 10 {size} {half} 1"),
                5 => writeln!(
                    text,
                    "{0} 9 {size}\n{1} 9 {half}\n{id} -103 {0} {1}",
                    id + 1,
                    id + 2
                ),
                _ => writeln!(
                    text,
                    "{0} 9 {half}\n{1} 17 {size} {half}\n{id} -101 {0} {1}",
                    id + 1,
                    id + 2
                ),
            };
            let [x, y, z] = (vector(next) * 4.0).0;
            let _ = writeln!(
                text,
                "{id} -2 {} {}\n{id} -1 {x} {y} {z}",
                next(360),
                1 + next(2)
            );
            let _ = writeln!(text, "{} -101 {root} {id}", id + 3);
            root = id + 3;
        }
        text + &format!("1 9999 {root} 0\n")
    }

    #[test]
    fn rays_meet_what_they_meet_without_a_vista() {
        let mut next = random();
        let (mut hits, mut hidden) = (0, 0);
        for _ in 0..60 {
            let scene = scene(&things(&mut next));
            let tracer = Tracer::new(&scene).unwrap();
            let parts = parts(&tracer.graph, 1000).unwrap();
            let mut walkers = tracer.walker::<f64>();
            let [eye, light] = [vector(&mut next), vector(&mut next)]
                .map(|v| Vec3::new(v[0], v[1].abs(), v[2]).unit() * 9.0);
            let [from_eye, from_light] = [eye, light].map(|p| Vista::new(&parts, p).unwrap());
            for _ in 0..300 {
                let mut ray = Ray::new(eye, (vector(&mut next) * 4.0 - eye).unit());
                ray.outside = true;
                let [known, hit] = [End::At(&from_eye), End::Anywhere]
                    .map(|end| walkers.first_hit::<false>(&ray, end));
                let told = |hit: &Hit| (hit.t, hit.surface, hit.normal.0);
                assert_eq!(known.as_ref().map(told), hit.as_ref().map(told));
                let Some(hit) = hit else { continue };
                let way = light - hit.point;
                if hit.facing().dot(way) <= 0.0 {
                    continue;
                }
                let ray = hit.leave(way, false);
                let [known, seen] = [End::To(&from_light), End::Anywhere]
                    .map(|end| walkers.visibility::<false>(&ray, 0, end));
                assert_eq!(known, seen);
                let exact =
                    tracer
                        .walker()
                        .visibility::<false>(&ray.cast::<Dd>(), 0, End::Anywhere);
                assert_eq!(exact, seen);
                hits += 1;
                hidden += u32::from(!seen.any());
            }
        }
        assert!(hits > 5_000 && hidden > 1_500, "{hidden} of {hits}");
    }
}
