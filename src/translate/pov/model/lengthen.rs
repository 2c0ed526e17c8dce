//! How far faces are moved outwards that are flush with something.

use crate::geometry::Aabb;
use crate::scene::Geometry;
use crate::solids::shapes::AnyShape;

/// Distance of faces that are in one place, as a part of the numbers: what a few hundred roundings may do.
pub(super) const FACE_REL_EPS: f64 = 1e-13;

/// The part of its own length that a tool is made longer by, where nothing is in the way.
pub(super) const HALF: f64 = 0.5;

/// The box outside of which a solid may be longer than it is, and by how much.
#[derive(Debug, Clone, Copy)]
pub(super) struct Cut {
    pub around: Aabb,
    /// By this part of its length.
    pub by: f64,
    /// By so much at most.
    pub most: f64,
}

impl Cut {
    /// How far the end of something of that length is moved out.
    pub(super) fn step(&self, length: f64) -> f64 {
        (self.by * length).clamp(-self.most, self.most)
    }

    /// A profile whose flat ends are moved out where they are flush with the box.
    pub(super) fn profile(&self, profile: &[[f64; 2]]) -> Option<Vec<[f64; 2]>> {
        let cut = &self.around;
        let heights = || profile.iter().map(|p| p[1]);
        let low = heights().fold(f64::INFINITY, f64::min);
        let high = heights().fold(f64::NEG_INFINITY, f64::max);
        let hair = FACE_REL_EPS * (high - low);
        let step = self.step(high - low);
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
}

/// Where a face goes that is flush with an end of what is cut: a step away from it.
pub(super) fn outward(at: f64, (low, high): (f64, f64), hair: f64, step: f64) -> Option<f64> {
    if (at - high).abs() <= hair {
        Some(step)
    } else if (at - low).abs() <= hair {
        Some(-step)
    } else {
        None
    }
}

impl Geometry {
    /// Where it has flat faces across an axis that [`lengthened`](Self::lengthened) can move.
    pub(super) fn ends(&self, axis: usize) -> Vec<f64> {
        match AnyShape::of(self) {
            AnyShape::Cone(s) => match axis == 1 && !s.double {
                true => vec![s.height],
                false => Vec::new(),
            },
            AnyShape::Cuboid(s) => {
                vec![s.min[axis], s.max[axis]]
            }
            AnyShape::Revolution(s) => match axis == 1 {
                true => s.profile.iter().map(|p| p[1]).collect(),
                false => Vec::new(),
            },
            AnyShape::Ellipsoid(_)
            | AnyShape::GeodesicSphere(_)
            | AnyShape::HalfSpace(_)
            | AnyShape::Quadric(_)
            | AnyShape::Rectangle(_)
            | AnyShape::Sphere(_)
            | AnyShape::Torus(_)
            | AnyShape::Triangle(_) => Vec::new(),
        }
    }

    /// The shape with its flush faces farther out, if it has any that can be moved.
    pub(super) fn lengthened(&self, longer: &Cut) -> Option<Geometry> {
        match AnyShape::of(self) {
            AnyShape::Cone(s) => {
                if s.double {
                    return None;
                }
                let (cut, height, radius) = (&longer.around, s.height, s.radius);
                let size = height.abs();
                let near = |y: f64| (height - y).abs() <= FACE_REL_EPS * size;
                let flush =
                    (height > 0.0 && near(cut.max[1])) || (height < 0.0 && near(cut.min[1]));
                let by = 1.0 + longer.step(height.abs()) / height.abs();
                flush.then_some(Geometry::Cone {
                    height: by * height,
                    radius: by * radius,
                })
            }
            AnyShape::Cuboid(s) => {
                let cut = &longer.around;
                let (mut low, mut high) = (s.min, s.max);
                let mut any = false;
                for i in 0..3 {
                    let size = s.max[i] - s.min[i];
                    let hair = FACE_REL_EPS * size;
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
            AnyShape::Revolution(s) => {
                if !s.colours.is_empty() {
                    return None;
                }
                Some(Geometry::Revolution {
                    profile: longer.profile(s.profile)?,
                    colours: Vec::new(),
                })
            }
            AnyShape::Ellipsoid(_)
            | AnyShape::GeodesicSphere(_)
            | AnyShape::HalfSpace(_)
            | AnyShape::Quadric(_)
            | AnyShape::Rectangle(_)
            | AnyShape::Sphere(_)
            | AnyShape::Torus(_)
            | AnyShape::Triangle(_) => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const CUT: Aabb = Aabb {
        min: [-1.0, 0.0, -1.0],
        max: [1.0, 2.0, 1.0],
    };

    fn made_longer(geometry: &Geometry) -> Option<Geometry> {
        geometry.lengthened(&Cut {
            around: CUT,
            by: HALF,
            most: f64::INFINITY,
        })
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
