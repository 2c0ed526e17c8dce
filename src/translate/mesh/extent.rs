//! The region of a scene that becomes triangles, and how fine the triangles are.

use super::options::{DEFAULT_TOLERANCE, Options};
use crate::diagnostics::Complaint;
use crate::geometry::{Aabb, Matrix};
use crate::scene::{Geometry, Node, Scene, Texture, Vec3, fold_up};
use crate::solids::bounds::NodeBounds;
use crate::solids::shapes::facts::Facts;
use crate::solids::staging::seen_box;

/// Factor by which the region is larger than the scene's bounded parts. Endless shapes are cut to the region: a floor
/// reaches beyond what stands on it.
const AROUND: f64 = 2.0;

/// Further factor for scenes whose endless shapes are all flat, if a camera looks along them: they need few triangles
/// however far they reach.
const FLAT_EXTENT_FACTOR: f64 = 16.0;

/// Half the side of the cube that stands for the bounded parts in a scene that has none.
const NOTHING_BOUNDED: f64 = 5.0;

/// Distance up to which walls, skies and planes around a scene belong to the region, in radii of the scene.
const MAX_ENCLOSURE_SIZES: f64 = 100.0;

/// The region that the mesh is made in, and how fine the mesh is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Extent {
    /// A box that holds everything that has an end, with room around it; or the render box.
    pub region: Aabb,
    /// The box that meshes are cut off at: the region, or a larger box.
    pub cut: Aabb,
    /// Whether the region is the render record's box.
    pub boxed: bool,
    pub tolerance: f64,
    /// The radius of the sphere around what is seen.
    pub radius: f64,
}

impl Extent {
    /// The greatest length of the edges of triangles with a texture.
    pub fn grain(&self) -> f64 {
        self.radius / 64.0
    }

    /// The message that says where endless shapes are cut off.
    pub fn cut_off(&self) -> Complaint {
        if self.boxed {
            return Complaint::term("cut to the render box");
        }
        let times = match self.cut == self.region {
            true => AROUND,
            false => AROUND * FLAT_EXTENT_FACTOR,
        };
        Complaint::new("fidelity-cut").with("times", times.to_string())
    }

    /// The region and the tolerance for a scene.
    pub fn of(scene: &Scene, bounds: &[NodeBounds], options: &Options) -> Extent {
        let seen = seen_box(scene, bounds);
        let boxed = scene.render.is_some_and(|r| r.clip.is_some());
        let seen = if seen.is_empty() || seen.radius() == 0.0 && !boxed {
            Aabb::new([-NOTHING_BOUNDED; 3], [NOTHING_BOUNDED; 3])
        } else {
            seen
        };
        let all = seen.hull(&faces(scene, bounds, &seen));
        let region = match options.eye {
            _ if boxed => widened(&seen),
            Some(eye) => around(&all.hull(&Aabb::new(eye, eye))),
            None => around(&all),
        };
        Extent {
            region,
            cut: match options.eye {
                Some(_) if !boxed && is_flat(scene) => grown(&region, FLAT_EXTENT_FACTOR),
                _ => region,
            },
            boxed,
            radius: seen.radius(),
            tolerance: options
                .tolerance
                .unwrap_or(DEFAULT_TOLERANCE * seen.radius()),
        }
    }
}

/// The box enlarged by less than can be seen, so that faces of the scene that lie in the box's faces are in it.
fn widened(b: &Aabb) -> Aabb {
    let hair = 1e-6 * b.radius();
    Aabb::new(b.min.map(|x| x - hair), b.max.map(|x| x + hair))
}

/// The box enlarged by the factor `by` about its centre.
fn grown(b: &Aabb, by: f64) -> Aabb {
    let c = b.centre();
    let end = |corner: Vec3| std::array::from_fn(|i| c[i] + by * (corner[i] - c[i]));
    Aabb::new(end(b.min), end(b.max))
}

/// Whether all endless shapes are flat and need few triangles: a solid texture in the scene needs many small ones.
fn is_flat(scene: &Scene) -> bool {
    let is_solid = |t: &Texture| matches!(t, Texture::Solid { .. });
    let mut textures = scene.paints.iter().filter_map(|p| p.texture.as_ref());
    let flat = |g: &Geometry| g.plane().is_some();
    let ends = |g: &Geometry| g.bounds(&Matrix::IDENTITY).radius().is_finite();
    !textures.any(is_solid) && (scene.shapes.iter()).all(|s| flat(&s.geometry) || ends(&s.geometry))
}

/// The box with room around it on all sides, also in a direction in which it is flat.
fn around(seen: &Aabb) -> Aabb {
    let least = seen.radius() / 4.0;
    let c = seen.centre();
    let half: [f64; 3] =
        std::array::from_fn(|i| (AROUND * (seen.max[i] / 2.0 - seen.min[i] / 2.0)).max(least));
    Aabb::new(
        std::array::from_fn(|i| c[i] - half[i]),
        std::array::from_fn(|i| c[i] + half[i]),
    )
}

/// A box around the bounded faces of solids without end, such as walls of rooms and skies, and around the nearest
/// points of planes. Empty if the box reaches farther than [`MAX_ENCLOSURE_SIZES`] radii of `seen`.
fn faces(scene: &Scene, bounds: &[NodeBounds], seen: &Aabb) -> Aabb {
    let Some(root) = scene.render.map(|r| r.root) else {
        return Aabb::EMPTY;
    };
    let mut boxes = fold_up(scene.up_to(root), |id, node, boxes: &[Aabb]| {
        let bounds = &bounds[id as usize];
        let of = |id: u32| boxes[id as usize];
        let all = match node {
            Node::Shape(shape) => match plane_foot(&scene.shapes[shape as usize].geometry) {
                Some(foot) => Aabb::new(foot, foot),
                None => bounds.bounded(),
            },
            Node::Union(a, b) | Node::Intersection(a, b) | Node::Difference(a, b) => {
                of(a).hull(&of(b))
            }
            Node::Complement(a) => of(a),
            Node::Transform { child, matrix } => {
                of(child).transformed(&scene.matrices[matrix as usize])
            }
            Node::Paint { child, .. } | Node::Copy { child, .. } => of(child),
        };
        all.intersection(&bounds.all)
    });
    let far = MAX_ENCLOSURE_SIZES * seen.radius();
    let c = seen.centre();
    let near = Aabb::new(c.map(|x| x - far), c.map(|x| x + far));
    match boxes.pop() {
        Some(all) if near.holds(&all) => all,
        _ => Aabb::EMPTY,
    }
}

/// The point nearest to the origin of a plane, or of a half-space's face; `None` for other shapes.
fn plane_foot(geometry: &Geometry) -> Option<Vec3> {
    let [a, b, c, d] = geometry.plane()?;
    let n = [a, b, c];
    let foot = n.map(|x| -d * x / (a * a + b * b + c * c));
    foot.iter().all(|x| x.is_finite()).then_some(foot)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solids::bounds::node_bounds;
    use crate::testing::scene;

    fn region(text: &str) -> Aabb {
        let scene = scene(text);
        Extent::of(&scene, &node_bounds(&scene), &Options::default()).region
    }

    #[test]
    fn flat_things_go_on_before_a_camera() {
        let seen = |text: &str| {
            let scene = scene(text);
            let eye = Some([0.0, 1.0, 3.0]);
            let extent = Extent::of(
                &scene,
                &node_bounds(&scene),
                &Options {
                    eye,
                    ..Options::default()
                },
            );
            extent.cut.radius() / extent.region.radius()
        };
        let water = "2 9 1\n3 4 0 1 0 0\n4 -103 3 2\n1 9999 4 0";
        assert!((seen(water) - FLAT_EXTENT_FACTOR).abs() < 1e-9);
        // Something curved without end would take many triangles, and so would a texture in space.
        let curved = "2 18 1\n3 4 0 1 0 0\n4 -103 3 2\n1 9999 4 0";
        assert_eq!(seen(curved), 1.0);
        let marble =
            "5 -701 1 1 1\n6 -302 5 5 0.5\n2 9 1\n3 4 0 1 0 0\n3 -299 6 0\n4 -103 3 2\n1 9999 4 0";
        assert_eq!(seen(marble), 1.0);
        let boxed = "2 9 1\n3 4 0 1 0 0\n4 -103 3 2\n1 9999 4 0 -1 -1 -1 1 1 1";
        assert_eq!(seen(boxed), 1.0);
    }

    #[test]
    fn walls_are_in_reach() {
        // A ball in a room, and before a wall thirty away.
        let ball = "2 9 1\n";
        let room = region(&format!(
            "{ball}3 12 -9 -9 -9 9 9 9\n4 -104 3\n5 -101 2 4\n1 9999 5 0"
        ));
        assert!(room.holds(&Aabb::new([-9.0; 3], [9.0; 3])));
        let wall = region(&format!("{ball}3 3 0 0 2 60\n5 -101 2 3\n1 9999 5 0"));
        assert!(wall.min[2] < -30.0 && wall.max[2] > 1.0);
        // What is as far away as a sky is left out.
        let far = region(&format!("{ball}3 3 0 0 1 1e6\n5 -101 2 3\n1 9999 5 0"));
        assert_eq!(far, region(&format!("{ball}1 9999 2 0")));
        // What is taken away has no walls where there is nothing.
        let cut = region(&format!(
            "{ball}3 12 -9 -9 -9 9 9 0\n5 -103 2 3\n1 9999 5 0"
        ));
        assert!(cut.max[2] < 9.0);
    }
}
