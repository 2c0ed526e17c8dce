//! Parts of the outermost union that an opaque plane hides from every camera.
//!
//! A plane has no end, so what comes from behind it goes through it. There it meets the plane, or an opaque solid that
//! owns the point: only mirrors and glass lead elsewhere.

use super::members::{Member, TOUCHING_SHARE, definitions, members};
use super::sides::Sides;
use crate::diagnostics::Span;
use crate::scene::{Geometry, NodeId, Scene, Vec3, View};
use crate::solids::bounds::NodeBounds;
use crate::solids::{Named, named};

/// Number of planes that are looked at, the first ones.
const MAX_PLANES: usize = 16;

/// A part that lies behind a plane.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Screened {
    /// The operand as it is written.
    pub node: NodeId,
    /// The place of the definition.
    pub span: Span,
    pub plane: Named,
}

/// The parts that have an end and lie behind an opaque plane, or are balls that touch it in a point, as seen from every
/// camera that is written. There are none where something mirrors or lets light through, where a camera is automatic or
/// projects in its own way, or where the render record cuts planes open.
pub fn screened(scene: &Scene, bounds: &[NodeBounds], root: NodeId) -> Vec<Screened> {
    let eyes: Vec<Vec3> = scene.cameras.iter().map(|c| c.position).collect();
    let is_sure = scene.view != View::Automatic
        && scene.render.is_none_or(|r| r.clip.is_none())
        && scene.cameras.iter().all(|c| c.projection.is_none())
        && !scene.has_mirrors_or_glass();
    if eyes.is_empty() || !is_sure {
        return Vec::new();
    }
    let parts = members(scene, bounds, root);
    let plane = |own: &Member| match own.geometry(scene) {
        Some(Geometry::Plane(numbers)) if !own.clear => {
            Some((named(scene, own.node)?, *numbers, Sides::of(own, &parts)?))
        }
        _ => None,
    };
    let planes: Vec<_> = parts.iter().filter_map(plane).take(MAX_PLANES).collect();
    if planes.is_empty() {
        return Vec::new();
    }
    let spans = definitions(scene);
    let hidden = |m: &Member| {
        let mut planes = planes.iter();
        let (plane, ..) = planes.find(|(_, numbers, sides)| {
            let bounds = m.bounds_less(scene, TOUCHING_SHARE);
            bounds.is_bounded() && sides.is_between(*numbers, &eyes, &bounds)
        })?;
        Some(Screened {
            node: m.node,
            span: spans.get(&m.id(scene)).copied().unwrap_or_default(),
            plane: *plane,
        })
    };
    parts.iter().filter_map(hidden).collect()
}
