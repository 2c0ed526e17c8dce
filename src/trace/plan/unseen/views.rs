//! The parts of the outermost union, divided into those that some camera may see and those that none sees.

use super::members::members;
use super::view::{Field, OutOfView};
use crate::geometry::{Aabb, Matrix};
use crate::scene::{NodeId, Scene, Vec3};
use crate::solids::bounds::NodeBounds;

/// A part that no camera sees in a picture of the usual size.
#[derive(Debug, Clone, Copy)]
pub struct Aside {
    /// The operand node, with its transformations and properties.
    pub node: NodeId,
    pub bounds: Aabb,
    /// The map from the coordinates of the part's core into those of the scene.
    pub moved: Matrix,
    /// The side on which the part lies, as seen by the camera that takes the picture.
    pub side: OutOfView,
}

/// The bounded parts, divided by whether some camera may see them.
pub struct Views {
    field: Field,
    /// The ID of the camera that takes the picture.
    pub camera: u32,
    /// Bounds of the parts that some camera may see.
    pub within: Vec<Aabb>,
    /// The parts that no camera sees.
    pub aside: Vec<Aside>,
}

impl Views {
    /// Divides the bounded parts of a scene. `None` if no camera is written, if a camera takes no pictures, or if the
    /// render record has a region, which may cut parts open.
    pub fn new(scene: &Scene, bounds: &[NodeBounds], root: NodeId) -> Option<Views> {
        let fields: Vec<Field> = scene.cameras.iter().map(Field::of).collect::<Option<_>>()?;
        let camera = scene.chosen_cameras().next()?;
        if scene.render.is_some_and(|r| r.clip.is_some()) {
            return None;
        }
        let mut views = Views {
            field: Field::of(camera)?,
            camera: camera.id,
            within: Vec::new(),
            aside: Vec::new(),
        };
        for part in members(scene, bounds, root) {
            if !part.bounds.is_bounded() {
                continue;
            }
            let side = views.field.side(&part.bounds);
            match side.filter(|_| fields.iter().all(|f| f.side(&part.bounds).is_some())) {
                None => views.within.push(part.bounds),
                Some(side) => views.aside.push(Aside {
                    node: part.node,
                    bounds: part.bounds,
                    moved: *part.matrix(),
                    side,
                }),
            }
        }
        Some(views)
    }

    /// Whether a place lies in the view of the camera that takes the picture.
    pub fn shows(&self, place: Vec3) -> bool {
        self.field.side(&Aabb::new(place, place)).is_none()
    }
}
