//! Parts of the outermost union that an opaque plane hides from every camera.
//!
//! A plane has no end, so a ray from a camera to a place behind it crosses the plane. There the ray ends, on the plane
//! or on an opaque solid that owns the point: only mirrors and glass send it elsewhere.

use super::members::{Member, TOUCHING_SHARE, definitions, members};
use super::sides::Sides;
use crate::diagnostics::Span;
use crate::scene::{Geometry, NodeId, Scene, Vec3, View};
use crate::solids::bounds::NodeBounds;
use crate::solids::{Named, named};

/// The most planes that are looked at: the first ones of the union.
const MAX_PLANES: usize = 16;

/// A part that lies behind a plane.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Screened {
    /// The operand node, with its transformations and properties.
    pub node: NodeId,
    /// The place in the text where the part is defined.
    pub span: Span,
    pub plane: Named,
}

/// The bounded parts that lie behind an opaque plane as seen from every camera that is written, also balls that touch
/// the plane in a single point. Empty if something mirrors or lets light through, if a camera is automatic or has a
/// projection matrix, or if the render record has a region, which cuts planes open.
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
