use super::facts::Facts;
use crate::scene::Geometry;

#[test]
fn points_in_shapes() {
    let inside = |g: &Geometry, p| g.holds(p);
    let spindle = Geometry::Torus {
        major: 0.5,
        minor: 1.0,
    };
    // The lemon about the axis is outside.
    assert!(!inside(&spindle, [0.0, 0.1, 0.0]));
    assert!(inside(&spindle, [1.0, 0.1, 0.0]));
    let down = Geometry::Cone {
        height: -2.0,
        radius: 1.0,
    };
    assert!(inside(&down, [0.4, -1.0, 0.0]));
    assert!(!inside(&down, [0.4, 1.0, 0.0]));
    let geodesic = Geometry::GeodesicSphere {
        radius: 1.0,
        splits: 0,
    };
    // An edge's middle is 0.85065 away.
    assert!(!inside(&geodesic, [0.0, 0.86, 0.0]));
    assert!(inside(&geodesic, [0.0, 0.85, 0.0]));
}
