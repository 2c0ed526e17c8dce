//! Flat surfaces among solids that light goes through.
//!
//! A flat surface has no inside, yet it is a medium to POV-Ray: a ray that goes through a sheet is in it from then on.
//! Where a sheet lies in a face of a solid, rounding decides which of the two a ray meets first; it should be the
//! sheet, from either side. So the sheet is written as a thin plate: one side shows the texture, the other lets the ray
//! out again, and the solid's face is within the plate. The plate is of the densest medium around, so that no light is
//! totally reflected where it enters.

use std::borrow::Cow;

use super::media::Members;
use crate::geometry::array::{add, cross, length, sub};
use crate::scene::{Geometry, NodeId, TriangleNormals, Vec3};
use crate::translate::pov::model::Model;
use crate::translate::pov::model::displacement::Change;
use crate::translate::pov::model::state::State;
use crate::translate::pov::model::tables::DEFAULT;
use crate::translate::pov::tree::{Body, Object, Operation};

impl Model<'_> {
    /// The number of the change that makes a plate of a surface. `None` unless light goes through the surface, and it
    /// touches a group that is seen into.
    pub(crate) fn plate(
        &mut self,
        (node, state): (NodeId, State),
        groups: &[Members],
    ) -> Option<u32> {
        let holds = self.holds_sheets.get(node as usize) == Some(&true);
        if !holds || !self.is_transparent(node, state.look) {
            return None;
        }
        let own = self.box_of(node);
        let mut densest = None;
        for group in groups.iter().filter(|g| g.seen_into) {
            if !group.boxes.iter().any(|b| own.overlaps(b)) {
                continue;
            }
            let index = match group.medium {
                Some((_, index)) => index,
                None => self.densest,
            };
            let known = densest.unwrap_or(DEFAULT);
            densest = Some(self.tables.denser(known, index));
        }
        let thick = state.flush.and_then(|f| self.changes.plate(f));
        let by = thick.map_or(self.hair / 2.0, |(by, _)| by);
        Some(self.changes.number(Change::Plate(by, densest?)))
    }
}

/// A flat surface as a plate that reaches `by` to both sides of it. `None` for shapes that are not flat, and for
/// triangles without a normal.
pub(crate) fn plate<'a>(geometry: &Geometry, by: f64) -> Option<Body<'a>> {
    let shape = |geometry: Geometry| Body::Shape(Cow::Owned(geometry));
    Some(match geometry {
        Geometry::Rectangle { min, max } => shape(Geometry::Box {
            min: [min[0], min[1], -by],
            max: [max[0], max[1], by],
        }),
        Geometry::Plane([a, b, c, d]) => {
            let by = by * length([*a, *b, *c]);
            let sides = [[*a, *b, *c, d - by], [-a, -b, -c, -d - by]];
            let sides = sides.map(|side| Object::new(shape(Geometry::HalfSpace(side))));
            Body::Operation(Operation::Intersection, sides.into())
        }
        Geometry::Triangle {
            vertices,
            normals: TriangleNormals::Flat,
        } => {
            let [p, q, r] = **vertices;
            let n = cross(sub(q, p), sub(r, p));
            let by = by / length(n);
            if !by.is_finite() {
                return None;
            }
            let side = |corners: [Vec3; 3], by: f64| Geometry::Triangle {
                vertices: Box::new(corners.map(|corner| add(corner, n, by))),
                normals: TriangleNormals::Flat,
            };
            // Each triangle is clockwise seen from outside. Single triangles lose that in POV-Ray where they are moved,
            // so they are a mesh.
            Body::Mesh(vec![side([p, r, q], by), side([p, q, r], -by)])
        }
        Geometry::Triangle { .. }
        | Geometry::Revolution { .. }
        | Geometry::HalfSpace(_)
        | Geometry::Sphere { .. }
        | Geometry::Ellipsoid { .. }
        | Geometry::Box { .. }
        | Geometry::GeodesicSphere { .. }
        | Geometry::Torus { .. }
        | Geometry::Quadric(_)
        | Geometry::Cone { .. }
        | Geometry::DoubleCone { .. }
        | Geometry::ParabolicCylinder { .. }
        | Geometry::HyperbolicCylinder { .. }
        | Geometry::Hyperboloid { .. }
        | Geometry::HyperbolicParaboloid { .. } => return None,
    })
}
