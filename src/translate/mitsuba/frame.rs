//! Placement of the scene for Mitsuba, which computes in single precision.

use crate::geometry::{Aabb, Matrix};
use crate::scene::{Camera, Vec3};

/// Distance from the origin, in sizes of the scene, beyond which the scene is moved: seven digits are enough up to
/// there.
const MAX_ORIGIN_SIZES: f64 = 100.0;

/// Sizes at which nothing is scaled. Mitsuba starts rays at a distance of about 1e-4 from surfaces, a thousandth of the
/// smallest size. For lengths up to a thousand times the largest size, squares and products of squares fit single
/// precision.
const SIZES: std::ops::RangeInclusive<f64> = 1e-1..=4e6;

/// The map from the scene's coordinates to Mitsuba's: a place p of the scene is at `scale` · (p − `origin`).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SceneFrame {
    pub scale: f64,
    pub origin: Vec3,
}

impl SceneFrame {
    /// The frame of a region: the scene's own, unless the region is too far away, too large or too small.
    pub fn of(region: &Aabb) -> SceneFrame {
        let (centre, radius) = (region.centre(), region.radius());
        let power = radius.log2().floor();
        if !power.is_finite() {
            return SceneFrame::PLAIN;
        }
        let unit = power.exp2();
        let away = centre.iter().any(|x| x.abs() > MAX_ORIGIN_SIZES * radius);
        let origin = centre.map(|x| match away {
            // A round number, for those who read the file.
            true => (x / unit).round() * unit,
            false => 0.0,
        });
        let scale = if SIZES.contains(&radius) {
            1.0
        } else {
            1.0 / unit
        };
        SceneFrame { scale, origin }
    }

    const PLAIN: SceneFrame = SceneFrame {
        scale: 1.0,
        origin: [0.0; 3],
    };

    pub fn is_plain(&self) -> bool {
        *self == SceneFrame::PLAIN
    }

    pub fn matrix(&self) -> Matrix {
        let [x, y, z] = self.origin.map(|x| -x);
        let s = self.scale;
        Matrix::scaling(s, s, s).after(&Matrix::translation(x, y, z))
    }

    /// The place in Mitsuba's coordinates of a place `p` of the scene.
    pub fn place(&self, p: Vec3) -> Vec3 {
        std::array::from_fn(|i| self.scale * (p[i] - self.origin[i]))
    }

    /// The place of the scene that is at `p` in Mitsuba's coordinates.
    pub fn back(&self, p: Vec3) -> Vec3 {
        std::array::from_fn(|i| p[i] / self.scale + self.origin[i])
    }

    pub fn camera(&self, camera: &Camera) -> Camera {
        let back = 1.0 / self.scale;
        Camera {
            position: self.place(camera.position),
            projection: camera
                .projection
                .map(|p| p.after(&Matrix::scaling(back, back, back))),
            ..*camera
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ordinary_scenes_stay_where_they_are() {
        let frame = SceneFrame::of(&Aabb::new([-3.0, 0.0, 5.0], [4.0, 2.0, 9.0]));
        assert!(frame.is_plain());
        assert!(SceneFrame::of(&Aabb::new([0.0; 3], [0.0; 3])).is_plain());
    }

    #[test]
    fn what_is_far_away_is_brought_near() {
        let frame = SceneFrame::of(&Aabb::new(
            [1e8, 1e8, -1e8],
            [1e8 + 4.0, 1e8 + 4.0, 4.0 - 1e8],
        ));
        assert_eq!(frame.scale, 1.0);
        let p = [1e8 + 3.0, 1e8 + 1.0, 2.0 - 1e8];
        let there = frame.place(p);
        assert!(there.iter().all(|x| x.abs() < 8.0), "{there:?}");
        assert_eq!(frame.back(there), p);
        assert_eq!(frame.matrix().point(p), there);
    }

    #[test]
    fn sizes_become_ordinary() {
        for size in [1e-9, 1e12] {
            let frame = SceneFrame::of(&Aabb::new([-size; 3], [size; 3]));
            let [x, ..] = frame.place([size; 3]);
            assert!((0.5..2.0).contains(&x), "{x}");
        }
    }
}
