//! The objects that operations of the scene become.

use super::descend::End;
use crate::translate::pov::model::Model;
use crate::translate::pov::model::displacement::Change;
use crate::translate::pov::model::state::{Layer, State};
use crate::translate::pov::tree::{Body, Modifier, Object, Operation};

impl<'a> Model<'a> {
    /// The object at the end of a descent. `None` if nothing is left of it, and for a shape.
    pub(crate) fn body(&mut self, end: &End) -> Option<Object<'a>> {
        if let End::Union(part, ..)
        | End::Intersection(part, ..)
        | End::Difference(part, ..)
        | End::CrossedSurfaces(part, ..)
        | End::Split(part, _) = *end
        {
            self.turn_to(part);
        }
        Some(match *end {
            End::Nothing | End::Shape(..) => return None,
            End::Everything => Object::new(Body::Everything),
            End::Shared(shared) => self.refer(shared.node, shared.state),
            End::Union(a, b, state) => {
                let members = self.flat_union(&[a, b], state);
                self.union(members)?
            }
            End::Intersection(a, b, state) => {
                let members = self.flat_intersection(a, b, state);
                let nodes: Vec<_> = members.iter().map(|m| m.0).collect();
                if self.solids.is_empty(&nodes) {
                    return None;
                }
                let mut members = self.without_wider(members);
                self.longer_holes(&mut members);
                Object::of(Operation::Intersection, self.refer_all(members))
            }
            End::Difference(a, b, state) => self.difference(a, b, state)?,
            End::CrossedSurfaces(a, b, state) => {
                let members = [(a, b), (b, a)].map(|(shown, by)| {
                    let by = Modifier::inside(self.refer(by, State::GEOMETRY));
                    self.refer(shown, state).with([by])
                });
                Object::of(Operation::Union, members.into())
            }
            End::Split(node, state) => {
                let surface = state.layer(Layer::Surface);
                let plate = Change::Plate(self.hair / 2.0, self.densest);
                let clear = self.is_transparent(node, state.look);
                let plate = clear.then(|| self.changes.number(plate));
                let parts = [
                    (node, state.layer(Layer::Solid)),
                    (node, surface.flush(surface.flush.or(plate))),
                ];
                Object::of(Operation::Union, self.refer_all(parts))
            }
        })
    }
}
