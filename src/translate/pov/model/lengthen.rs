//! Shapes with one of their flat ends farther out.

use crate::scene::Geometry;
use crate::solids::shapes::AnyShape;

/// The largest distance of two faces that count as one place, as a fraction of the shape's length: a few hundred
/// roundings may move faces this far.
const FACE_REL_EPS: f64 = 1e-13;
/// The most by which a shape is made longer, as a fraction of its length.
const MAX_REL_STEP: f64 = 0.5;

/// The move of a flat end that is perpendicular to an axis.
pub(super) struct EndMove {
    pub axis: usize,
    /// Whether the end faces in the positive direction of the axis; otherwise it faces in the negative one.
    pub upper: bool,
    /// The distance outwards. A short shape is moved by less.
    pub by: f64,
}

impl EndMove {
    /// The signed distance along the axis by which the end of a shape of this length moves.
    fn step(&self, length: f64) -> f64 {
        let step = (MAX_REL_STEP.copysign(self.by) * length).clamp(-self.by.abs(), self.by.abs());
        if self.upper { step } else { -step }
    }

    /// The profile with its flat end moved. `None` if no flat end lies at a height for which `near` holds, or the end
    /// cannot be moved.
    fn profile(&self, profile: &[[f64; 2]], near: impl Fn(&f64) -> bool) -> Option<Vec<[f64; 2]>> {
        let heights = || profile.iter().map(|p| p[1]);
        let at = heights().find(near)?;
        let low = heights().fold(f64::INFINITY, f64::min);
        let high = heights().fold(f64::NEG_INFINITY, f64::max);
        let end = if self.upper { high } else { low };
        // A ring begins anywhere, so only profiles from the axis to the axis are changed, each of whose ends is one
        // flat piece.
        let is_ring = profile.first() == profile.last();
        if is_ring || low == high || (end - at).abs() > FACE_REL_EPS * (high - low) {
            return None;
        }
        let by = self.step(high - low);
        let mut out = profile.to_vec();
        let level = |p: &[f64; 2]| p[1] == end;
        let first = out.iter().position(level)?;
        let last = out.iter().rposition(level)?;
        if !out[first..=last].iter().all(level) {
            return None;
        }
        let beyond = |p: [f64; 2], before: Option<[f64; 2]>| match before {
            // The piece that ends here is extended in its own direction. An additional point at this height would do
            // harm: POV-Ray cannot tell on which side of the profile other points at the height of a profile's point
            // are.
            Some(q) => {
                let slope = (p[0] - q[0]) / (p[1] - q[1]);
                // The end becomes half as wide at least, and twice as wide at most.
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
            return None;
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
        Some(out)
    }
}

impl Geometry {
    /// The shape with a flat end moved outwards. `None` if no such end lies at a coordinate for which `near` holds, or
    /// the end cannot be moved.
    pub(super) fn with_end_moved(
        &self,
        end: &EndMove,
        near: impl Fn(&f64) -> bool,
    ) -> Option<Geometry> {
        match AnyShape::of(self) {
            AnyShape::Cone(s) => {
                let is_end = end.axis == 1 && !s.double && end.upper == (s.height > 0.0);
                let by = 1.0 + end.step(s.height.abs()) / s.height;
                (is_end && near(&s.height)).then_some(Geometry::Cone {
                    height: by * s.height,
                    radius: by * s.radius,
                })
            }
            AnyShape::Cuboid(s) => {
                let (mut min, mut max) = (s.min, s.max);
                let size = max[end.axis] - min[end.axis];
                let ends = [&mut min[end.axis], &mut max[end.axis]];
                let at = ends.iter().map(|x| **x).find(near)?;
                for x in ends {
                    if (*x - at).abs() <= FACE_REL_EPS * size {
                        *x += end.step(size);
                    }
                }
                Some(Geometry::Box { min, max })
            }
            AnyShape::Revolution(s) => {
                let is_plain = end.axis == 1 && s.colours.is_empty();
                let profile = is_plain.then(|| end.profile(s.profile, near)).flatten()?;
                let colours = Vec::new();
                Some(Geometry::Revolution { profile, colours })
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

    /// The geometry with its ends at `at` across an axis moved out as far as they go.
    fn made_longer(geometry: &Geometry, axis: usize, upper: bool, at: f64) -> Option<Geometry> {
        let by = f64::INFINITY;
        geometry.with_end_moved(&EndMove { axis, upper, by }, |x| *x == at)
    }

    #[test]
    fn ends_move_by_half_a_length_at_most() {
        let cube = |min, max| Geometry::Box { min, max };
        let tool = cube([-0.5, 1.0, -1.0], [0.5, 2.0, 0.0]);
        let higher = cube([-0.5, 1.0, -1.0], [0.5, 2.5, 0.0]);
        assert_eq!(made_longer(&tool, 1, true, 2.0), Some(higher));
        let deeper = cube([-0.5, 1.0, -1.5], [0.5, 2.0, 0.0]);
        assert_eq!(made_longer(&tool, 2, false, -1.0), Some(deeper));
        assert_eq!(made_longer(&tool, 0, true, 1.0), None);
    }

    #[test]
    fn flat_ends_of_profiles_grow_straight() {
        let tool = |profile: &[[f64; 2]]| Geometry::Revolution {
            profile: profile.to_vec(),
            colours: Vec::new(),
        };
        let cylinder = tool(&[[0.5, 0.0], [0.5, 2.0]]);
        let longer = tool(&[[0.5, 0.0], [0.5, 3.0]]);
        assert_eq!(made_longer(&cylinder, 1, true, 2.0), Some(longer));
        let cup = tool(&[[0.0, 1.0], [0.25, 2.0], [0.5, 2.0], [0.5, 0.5]]);
        let taller = [[0.0, 1.0], [0.4375, 2.75], [0.5, 2.75], [0.5, 0.5]];
        assert_eq!(made_longer(&cup, 1, true, 2.0), Some(tool(&taller)));
    }
}
