//! Parts of the outermost union in the pictures of cameras, and out of all of them.

use super::members::members;
use super::view::{Field, OutOfView};
use crate::geometry::{Aabb, Matrix};
use crate::scene::{NodeId, Scene, Vec3};
use crate::solids::bounds::NodeBounds;

/// A part that no camera sees in a picture of the usual size.
#[derive(Debug, Clone, Copy)]
pub struct Aside {
    /// The operand as it is written.
    pub node: NodeId,
    pub bounds: Aabb,
    /// From the coordinates of its core into those of the scene.
    pub moved: Matrix,
    /// The side of the view of the camera that takes the picture.
    pub side: OutOfView,
}

/// The parts that have an end, as the cameras see them.
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
    /// `None` where no camera is written, one takes no pictures, or the render record cuts parts open.
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
