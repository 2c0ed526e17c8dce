//! Cameras that go around what they look at.

use crate::geometry::array::{add, cross, dot, middle, sub, unit};
use crate::geometry::matrix::sin_cos_degrees;
use crate::scene::{Camera, Vec3};

/// A turn around an axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Orbit {
    /// A unit vector.
    axis: Vec3,
    /// A point of the axis.
    pivot: Vec3,
}

impl Orbit {
    /// The turn of a camera around its up direction, through the point of its line of sight that is nearest to
    /// `centre`. Two cameras have one turn: the up direction is that of the first, and their line of sight begins
    /// halfway between them. `None` where they have no direction in common.
    pub fn of(cameras: &[Camera], centre: Vec3) -> Option<Orbit> {
        let positions: Vec<Vec3> = cameras.iter().map(|c| c.position).collect();
        let directions: Option<Vec<Vec3>> = cameras.iter().map(|c| unit(c.direction)).collect();
        let (eye, forward) = (middle(&positions), unit(middle(&directions?))?);
        // The pivot is never behind the eye.
        let ahead = dot(sub(centre, eye), forward).max(0.0);
        Some(Orbit {
            axis: unit(cameras.first()?.up)?,
            pivot: add(eye, forward, ahead),
        })
    }

    /// A camera after a turn by this many degrees, counter-clockwise seen from the tip of the axis.
    pub fn turned(&self, camera: &Camera, degrees: f64) -> Camera {
        let (sin, cos) = sin_cos_degrees(degrees);
        if (sin, cos) == (0.0, 1.0) {
            return *camera;
        }
        // Rodrigues' formula.
        let turn = |v: Vec3| {
            let across = add(v.map(|x| x * cos), cross(self.axis, v), sin);
            add(across, self.axis, dot(self.axis, v) * (1.0 - cos))
        };
        // An up vector along the axis stays as it is: turning it would only round it.
        let up = match cross(unit(camera.up).unwrap_or(self.axis), self.axis) {
            [0.0, 0.0, 0.0] => camera.up,
            _ => turn(camera.up),
        };
        Camera {
            position: add(self.pivot, turn(sub(camera.position, self.pivot)), 1.0),
            direction: turn(camera.direction),
            up,
            ..*camera
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::array::length;

    fn camera(position: Vec3, direction: Vec3, up: Vec3) -> Camera {
        Camera {
            id: 9,
            position,
            direction,
            up,
            fovy: 45.0,
            projection: None,
        }
    }

    #[test]
    fn a_quarter_turn_is_to_the_right() {
        let front = camera([0.0, 0.0, 8.0], [0.0, 0.0, -2.0], [0.0, 3.0, 0.0]);
        // The sphere is beside the line of sight: the axis goes through (0, 0, 1).
        let orbit = Orbit::of(&[front], [0.5, 0.7, 1.0]).unwrap();
        let right = orbit.turned(&front, 90.0);
        assert_eq!(right.position, [7.0, 0.0, 1.0]);
        assert_eq!(right.direction, [-2.0, 0.0, 0.0]);
        assert_eq!(right.up, front.up);
        assert_eq!(orbit.turned(&front, 360.0), front);
        // Nothing that is drawn lies ahead: the camera turns where it stands.
        let away = Orbit::of(&[front], [0.0, 0.0, 20.0]).unwrap();
        assert_eq!(away.turned(&front, 45.0).position, front.position);
    }

    #[test]
    fn a_slanted_camera_keeps_its_distance_and_its_point() {
        let start = camera([3.0, 4.0, 5.0], [-3.0, -4.0, -5.0], [0.1, 1.0, -0.2]);
        let orbit = Orbit::of(&[start], [0.0; 3]).unwrap();
        for step in 0..36 {
            let turned = orbit.turned(&start, 10.0 * f64::from(step));
            // It looks at the origin, from as far away, and its up direction stays.
            assert!((length(turned.position) - 50f64.sqrt()).abs() < 1e-13);
            let off = add(turned.position, turned.direction, 1.0);
            assert!(length(off) < 1e-13, "{off:?}");
            assert_eq!(turned.up, start.up);
            // A circle around the axis: the height above the origin along it is the same.
            let height = |c: &Camera| dot(c.position, start.up);
            assert!((height(&turned) - height(&start)).abs() < 1e-13);
        }
    }

    #[test]
    fn two_eyes_turn_together() {
        let eye = |x| camera([x, 0.0, 8.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]);
        let eyes = [eye(-0.25), eye(0.25)];
        let orbit = Orbit::of(&eyes, [0.0; 3]).unwrap();
        let [left, right] = eyes.map(|eye| orbit.turned(&eye, 90.0));
        // From the right, the left eye is nearer to the front.
        assert_eq!(left.position, [8.0, 0.0, 0.25]);
        assert_eq!(right.position, [8.0, 0.0, -0.25]);
    }
}
