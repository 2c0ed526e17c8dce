//! Starts of the rays of cameras.

use super::is_apart;
use crate::geometry::array::{add, cross, dot, sub, unit};
use crate::geometry::{Aabb, Matrix};
use crate::scene::sight::Sight;
use crate::scene::{Camera, Scene, Vec3, View};
use crate::solids::bounds::NodeBounds;
use crate::solids::staging::{Basis, automatic_camera};
use crate::solids::within::{CLEARANCE_REL, PlacedShape, far};

/// A set of places at which rays may start.
enum Start {
    Point(Vec3),
    /// Some point in this box, which may reach to infinity.
    Way(Aabb),
    /// Some point between four points of a plane.
    Face([Vec3; 4]),
    Anywhere,
}

/// The starts of the rays of all cameras: those that are written, since any may be chosen, and the automatic one, for a
/// picture of any width and height.
pub struct Starts(Vec<Start>);

impl Starts {
    pub fn new(scene: &Scene, bounds: &[NodeBounds]) -> Starts {
        let mut all: Vec<Start> = scene.cameras.iter().map(Start::of).collect();
        if scene.cameras.is_empty() || scene.view == View::Automatic {
            // The narrower a picture is, the further away is its camera.
            let Camera { position, .. } = automatic_camera(scene, bounds, 1.0);
            // The camera goes away to the right, up and to the front.
            all.push(Start::Way(Aabb::new(position, [f64::INFINITY; 3])));
        }
        Starts(all)
    }

    /// The largest absolute value of a coordinate of a start; infinite if rays start anywhere.
    pub fn reach(&self) -> f64 {
        let of = |start: &Start| match start {
            Start::Point(p) => far(p),
            Start::Way(b) => far(&b.min),
            Start::Face(corners) => corners.iter().map(far).fold(0.0, f64::max),
            Start::Anywhere => f64::INFINITY,
        };
        self.0.iter().map(of).fold(0.0, f64::max)
    }

    /// Whether no ray starts in a thing. `thing` is its box; `shape` is given if the thing is a single shape.
    pub fn are_clear_of(&self, thing: &Aabb, shape: Option<&PlacedShape>) -> bool {
        let apart = |b: &Aabb| is_apart(thing, b, CLEARANCE_REL * thing.far().max(b.far()));
        self.0.iter().all(|start| match start {
            Start::Point(p) => {
                apart(&Aabb::new(*p, *p)) || shape.is_some_and(|s| s.is_clear_of(*p))
            }
            Start::Way(b) => apart(b),
            Start::Face(corners) => {
                let around = corners
                    .iter()
                    .fold(Aabb::EMPTY, |b, &p| b.hull(&Aabb::new(p, p)));
                apart(&around) || beside_plane(corners, thing)
            }
            Start::Anywhere => false,
        })
    }
}

impl Start {
    fn of(camera: &Camera) -> Start {
        match &camera.projection {
            None => Start::Point(camera.position),
            Some(projection) => face(camera, projection).map_or(Start::Anywhere, Start::Face),
        }
    }
}

/// The corners of the plane on which the rays of a projection matrix start; `None` if the corners are out of range.
fn face(camera: &Camera, projection: &Matrix) -> Option<[Vec3; 4]> {
    let (basis, sight) = (Basis::of(camera)?, Sight::of(projection).ok()?);
    let corner = |(x, y): (f64, f64)| {
        let (start, _) = sight.ray(x, y)?;
        let place = add(camera.position, basis.turned(start), 1.0);
        place.iter().all(|c| c.is_finite()).then_some(place)
    };
    let mut corners = [[0.0; 3]; 4];
    for (place, at) in corners
        .iter_mut()
        .zip([(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)])
    {
        *place = corner(at)?;
    }
    Some(corners)
}

/// Whether all of a box lies on one side of the plane through four points.
fn beside_plane(corners: &[Vec3; 4], b: &Aabb) -> bool {
    let [p, q, r, _] = *corners;
    let Some(normal) = unit(cross(sub(q, p), sub(r, p))) else {
        return false;
    };
    // The products of the normal with the corners in the plane, and the least and the largest with points of the box.
    let flat = corners.map(|c| dot(normal, c));
    let span = |ends: &dyn Fn(f64, f64) -> f64| -> f64 {
        let side = |i: usize| ends(normal[i] * b.min[i], normal[i] * b.max[i]);
        (0..3).map(side).sum()
    };
    let (low, high) = (span(&f64::min), span(&f64::max));
    let size = corners
        .iter()
        .chain([&b.min, &b.max])
        .map(far)
        .fold(0.0, f64::max);
    let clear = CLEARANCE_REL * size;
    flat.iter().all(|f| f + clear < low) || flat.iter().all(|f| high + clear < *f)
}
