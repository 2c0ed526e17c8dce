//! Shapes with some of their faces farther out.

use super::coplanar::Plane;
use crate::geometry::Aabb;
use crate::geometry::array::{length, sub};
use crate::scene::Geometry;

/// Faces that are this near, as a part of the numbers, are in one place: what a few hundred roundings may do.
pub const HAIR: f64 = 1e-13;

/// The part of its own length that a tool is made longer by, where nothing is in the way.
pub const HALF: f64 = 0.5;

/// Normals that are this near are one: what rotations may do.
const FLAT: f64 = 1e-9;
/// Planes that are nearer than this part of what they are moved by are one.
const NEAR: f64 = 1e-3;

/// What a solid may be longer than it is outside of.
#[derive(Debug, Clone, Copy)]
pub struct Cut {
    pub around: Aabb,
    /// By this part of its length.
    pub by: f64,
    /// By so much at most.
    pub most: f64,
}

impl Cut {
    /// As long as it may be.
    pub fn of(around: Aabb, by: f64) -> Cut {
        let most = f64::INFINITY;
        Cut { around, by, most }
    }

    /// How far the end of something of that length is moved out.
    fn step(&self, length: f64) -> f64 {
        (self.by * length).clamp(-self.most, self.most)
    }
}

/// Where a face goes that is flush with an end of what is cut: a step away from it.
fn outward(at: f64, (low, high): (f64, f64), hair: f64, step: f64) -> Option<f64> {
    if (at - high).abs() <= hair {
        Some(step)
    } else if (at - low).abs() <= hair {
        Some(-step)
    } else {
        None
    }
}

/// The shape with its flush faces farther out, if it has any that can be moved.
pub fn lengthened(geometry: &Geometry, longer: &Cut) -> Option<Geometry> {
    let cut = &longer.around;
    let finite = |a: f64, b: f64| {
        if (a - b).is_finite() {
            (a - b).abs()
        } else {
            0.0
        }
    };
    match geometry {
        Geometry::Box { min, max } => {
            let (mut low, mut high) = (*min, *max);
            let mut any = false;
            for i in 0..3 {
                let size = max[i] - min[i];
                let hair = HAIR * size.max(finite(cut.max[i], cut.min[i]));
                let step = longer.step(size);
                for end in [&mut low[i], &mut high[i]] {
                    if let Some(by) = outward(*end, (cut.min[i], cut.max[i]), hair, step) {
                        *end += by;
                        any = true;
                    }
                }
            }
            any.then_some(Geometry::Box {
                min: low,
                max: high,
            })
        }
        Geometry::HalfSpace([a, b, c, d]) => {
            let n = [*a, *b, *c];
            let mut along = (0..3).filter(|i| n[*i] != 0.0);
            let (Some(i), None) = (along.next(), along.next()) else {
                return None;
            };
            let at = -d / n[i];
            let size = finite(cut.max[i], cut.min[i]);
            let hair = HAIR * size.max(at.abs());
            let step = (size.max(1.0) / 2.0).min(longer.most);
            let at = at + outward(at, (cut.min[i], cut.max[i]), hair, step)?;
            Some(Geometry::HalfSpace([*a, *b, *c, -at * n[i]]))
        }
        Geometry::Cone { height, radius } => {
            let size = height.abs().max(finite(cut.max[1], cut.min[1]));
            let near = |y: f64| (height - y).abs() <= HAIR * size;
            let flush = (*height > 0.0 && near(cut.max[1])) || (*height < 0.0 && near(cut.min[1]));
            let by = 1.0 + longer.step(height.abs()) / height.abs();
            flush.then_some(Geometry::Cone {
                height: by * height,
                radius: by * radius,
            })
        }
        Geometry::Revolution { profile, colours } if colours.is_empty() => {
            Some(Geometry::Revolution {
                profile: longer_profile(profile, longer)?,
                colours: Vec::new(),
            })
        }
        _ => None,
    }
}

/// The shape with its flat faces in some planes farther out, if it has any there.
pub fn with_planes_moved(geometry: &Geometry, planes: &[(Plane, f64)]) -> Option<Geometry> {
    let mut out: Option<Geometry> = None;
    for (plane, by) in planes {
        let now = out.as_ref().unwrap_or(geometry);
        let near = |a: f64, b: f64| (a - b).abs() <= NEAR * by;
        if let Geometry::HalfSpace([a, b, c, d]) = now {
            let n = [*a, *b, *c];
            let here = Plane::of(n, *d)?;
            if length(sub(here.n, plane.n)) <= FLAT && near(here.d, plane.d) {
                let d = d - by * length(n);
                out = Some(Geometry::HalfSpace([*a, *b, *c, d]));
            }
            continue;
        }
        // All others have such faces across their axes only.
        let Some(axis) = (0..3).find(|i| plane.n[*i].abs() > 1.0 - FLAT) else {
            continue;
        };
        let sign = plane.n[axis].signum();
        let at = -plane.d * sign;
        let Some(end) = ends(now, axis).into_iter().find(|end| near(*end, at)) else {
            continue;
        };
        let mut around = Aabb::ALL;
        match sign > 0.0 {
            true => around.max[axis] = end,
            false => around.min[axis] = end,
        }
        let most = *by;
        out = lengthened(
            now,
            &Cut {
                around,
                by: HALF,
                most,
            },
        )
        .or(out);
    }
    out
}

/// Where a shape has flat faces along an axis.
fn ends(geometry: &Geometry, axis: usize) -> Vec<f64> {
    match geometry {
        Geometry::Box { min, max } => vec![min[axis], max[axis]],
        Geometry::Cone { height, .. } if axis == 1 => vec![*height],
        Geometry::Revolution { profile, .. } if axis == 1 => profile.iter().map(|p| p[1]).collect(),
        _ => Vec::new(),
    }
}

/// The shape with the flat faces that are flush with the box moved outwards by so much.
pub fn with_ends_moved(geometry: &Geometry, around: Aabb, by: f64) -> Option<Geometry> {
    if let Geometry::Box { min, max } = *geometry {
        // One axis at a time: a change is a part of a length.
        let mut moved = (min, max);
        for i in 0..3 {
            let mut one = Aabb::ALL;
            (one.min[i], one.max[i]) = (around.min[i], around.max[i]);
            let by = by / (max[i] - min[i]);
            if let Some(Geometry::Box { min, max }) = lengthened(geometry, &Cut::of(one, by)) {
                (moved.0[i], moved.1[i]) = (min[i], max[i]);
            }
        }
        let (min, max) = moved;
        return Some(Geometry::Box { min, max });
    }
    let height = match geometry {
        Geometry::Cone { height, .. } => height.abs(),
        Geometry::Revolution { profile, .. } => {
            let ys = || profile.iter().map(|p| p[1]);
            ys().fold(f64::NEG_INFINITY, f64::max) - ys().fold(f64::INFINITY, f64::min)
        }
        _ => return None,
    };
    let by = by / height;
    lengthened(geometry, &Cut::of(around, by))
}

/// A profile whose flat ends are moved out where they are flush with the box.
fn longer_profile(profile: &[[f64; 2]], longer: &Cut) -> Option<Vec<[f64; 2]>> {
    let cut = &longer.around;
    let heights = || profile.iter().map(|p| p[1]);
    let low = heights().fold(f64::INFINITY, f64::min);
    let high = heights().fold(f64::NEG_INFINITY, f64::max);
    let hair = HAIR * (high - low);
    let step = longer.step(high - low);
    // A ring begins anywhere: only profiles from the axis to the axis, one flat piece at each end.
    if profile.first() == profile.last() || low == high {
        return None;
    }
    let mut out = profile.to_vec();
    let mut any = false;
    for (end, at, by) in [(low, cut.min[1], -step), (high, cut.max[1], step)] {
        if (end - at).abs() > hair {
            continue;
        }
        let level = |p: &[f64; 2]| p[1] == end;
        let first = out.iter().position(level)?;
        let last = out.iter().rposition(level)?;
        if !out[first..=last].iter().all(level) {
            continue;
        }
        let beyond = |p: [f64; 2], before: Option<[f64; 2]>| match before {
            // On along the piece that ends there: a point at this height would be one too many, since
            // POV-Ray cannot tell on which side of the profile others at its height are.
            Some(q) => {
                let slope = (p[0] - q[0]) / (p[1] - q[1]);
                // It becomes half as wide at least, and twice as wide at most.
                let most = if slope * by < 0.0 {
                    p[0] / 2.0 / -slope
                } else if slope * by > 0.0 && p[0] > 0.0 {
                    p[0] / slope
                } else {
                    by
                };
                let by = if most.abs() < by.abs() { most } else { by };
                [p[0] + slope * by, p[1] + by]
            }
            None => [p[0], end + by],
        };
        let before = first.checked_sub(1).map(|i| out[i]);
        let after = out.get(last + 1).copied();
        if first == last && before.is_some() && after.is_some() {
            continue;
        }
        let run = out[first..=last].to_vec();
        let count = run.len();
        let moved = run.iter().enumerate().map(|(i, p)| match i {
            0 if count == 1 => beyond(*p, before.or(after)),
            0 => beyond(*p, before),
            i if i + 1 == count => beyond(*p, after),
            _ => beyond(*p, None),
        });
        out.splice(first..=last, moved);
        any = true;
    }
    any.then_some(out)
}

#[cfg(test)]
mod tests {
    use super::*;

    const CUT: Aabb = Aabb {
        min: [-1.0, 0.0, -1.0],
        max: [1.0, 2.0, 1.0],
    };

    fn made_longer(geometry: &Geometry) -> Option<Geometry> {
        lengthened(geometry, &Cut::of(CUT, HALF))
    }

    #[test]
    fn flush_faces_move_away_from_what_is_cut() {
        let tool = Geometry::Box {
            min: [-0.5, 1.0, -1.0],
            max: [0.5, 2.0, 0.0],
        };
        let longer = Geometry::Box {
            min: [-0.5, 1.0, -1.5],
            max: [0.5, 2.5, 0.0],
        };
        assert_eq!(made_longer(&tool), Some(longer));
        let inside = Geometry::Box {
            min: [-0.5, 0.5, -0.5],
            max: [0.5, 1.5, 0.5],
        };
        assert_eq!(made_longer(&inside), None);
        // One that lies against it from outside moves away from it.
        let against = Geometry::Box {
            min: [-0.5, 2.0, -0.5],
            max: [0.5, 4.0, 0.5],
        };
        let away = Geometry::Box {
            min: [-0.5, 3.0, -0.5],
            max: [0.5, 4.0, 0.5],
        };
        assert_eq!(made_longer(&against), Some(away));
    }

    #[test]
    fn flat_ends_of_profiles_grow_straight() {
        let tool = |profile: &[[f64; 2]]| Geometry::Revolution {
            profile: profile.to_vec(),
            colours: Vec::new(),
        };
        let cylinder = tool(&[[0.5, 0.0], [0.5, 2.0]]);
        let longer = [[0.5, -1.0], [0.5, 3.0]];
        assert_eq!(made_longer(&cylinder), Some(tool(&longer)));
        let cup = tool(&[[0.0, 1.0], [0.25, 2.0], [0.5, 2.0], [0.5, 0.5]]);
        let taller = [[0.0, 1.0], [0.4375, 2.75], [0.5, 2.75], [0.5, 0.5]];
        assert_eq!(made_longer(&cup), Some(tool(&taller)));
    }
}
