//! Differences. All of the boundary of A − B has the properties of A, cut faces too, so B is
//! written with A's look. Where A is a union of different looks, each of its parts is cut by itself.

use super::descend::{End, Stop};
use crate::geometry::{Aabb, Matrix};
use crate::scene::NodeId;
use crate::translate::fidelity::Fidelity;
use crate::translate::pov::model::Model;
use crate::translate::pov::model::grouping::{self, Group, meet};
use crate::translate::pov::model::looks::Substance;
use crate::translate::pov::model::state::{Appearance, Layer, Medium, State};
use crate::translate::pov::model::tables::{DEFAULT, PROFILE, TextureUse};
use crate::translate::pov::tree::{Modifier, Object, Operation};

/// Parts of the object that is cut, all of one substance.
type Cut = Group<Substance, (NodeId, State)>;

impl<'a> Model<'a> {
    /// The object of A − B. If A is a difference itself, all that is taken away is taken from its base at once. `None`
    /// if nothing is left.
    pub(crate) fn difference(&mut self, a: NodeId, b: NodeId, state: State) -> Option<Object<'a>> {
        let (base, cutters) = self.cut_chain(a, b, state);
        if self.is_within(base.0, &cutters) {
            return None;
        }
        match self.substance(a, state) {
            Some((look, _)) => self.cut(base, &cutters, look, state.flush),
            None => self.cut_by_part(base, &cutters),
        }
    }

    /// Takes a chain of differences apart: ((A − B) − C) − D gives A, and B, C, D.
    fn cut_chain(&mut self, a: NodeId, b: NodeId, state: State) -> ((NodeId, State), Vec<NodeId>) {
        let mut base = (a, state);
        let mut cutters = vec![b];
        while let Some(End::Difference(a, b, state)) =
            self.descend(base.0, base.1, Stop::AtShared).bare()
        {
            cutters.push(b);
            base = (a, state);
        }
        cutters.reverse();
        (base, cutters)
    }

    /// The base without the cutters. The cut faces have the look `look`; `change` is the number of the whole
    /// difference's change. `None` if nothing is left.
    fn cut(
        &mut self,
        base: (NodeId, State),
        cutters: &[NodeId],
        look: Appearance,
        change: Option<u32>,
    ) -> Option<Object<'a>> {
        let of = base.0;
        let base = self.without_what_goes(base, cutters)?;
        let offset = change.and_then(|c| self.changes.offset(c));
        let offset = offset.map(|c| self.changes.turned(c));
        let taken = self.cutters(cutters, look, Some(of), offset);
        Some(difference(Operation::Difference, base, taken, Vec::new()))
    }

    /// The object of a base, without the parts of it that certainly lie within the cutters: such parts have faces in
    /// one place with them. `None` if nothing is left.
    fn without_what_goes(
        &mut self,
        (node, state): (NodeId, State),
        cutters: &[NodeId],
    ) -> Option<Object<'a>> {
        let descent = self.descend(node, state, Stop::BelowStart);
        let Some(End::Union(a, b, inner)) = descent.bare() else {
            return Some(self.refer(node, state));
        };
        let mut parts = self.flat_union(&[a, b], inner);
        let all = parts.len();
        parts.retain(|(part, _)| !self.is_within(*part, cutters));
        match parts.len() == all {
            true => Some(self.refer(node, state)),
            false => self.union(parts),
        }
    }

    /// The objects to be taken away, with the look of the base. `base` is the base's node if it lies in the same
    /// coordinates, and `offset` the number of a change of the objects' shapes.
    fn cutters(
        &mut self,
        nodes: &[NodeId],
        look: Appearance,
        base: Option<NodeId>,
        offset: Option<u32>,
    ) -> Vec<Object<'a>> {
        let look = match look {
            // The colours of a profile are on its own surface only.
            Appearance::Own {
                texture: Some(t),
                optics,
            } if t.texture == PROFILE => Appearance::Own {
                texture: Some(TextureUse::DEFAULT),
                optics,
            },
            look => look,
        };
        let state = State {
            layer: Layer::Solid,
            look,
            medium: Medium::Above,
            flush: offset,
        };
        let mut out = Vec::new();
        // The looks that the cutters have themselves do not count, so a look that can be given from outside is given to
        // each cutter as a whole.
        let (look, modifier) = match look {
            Appearance::Own {
                texture: Some(t),
                optics: Some(o),
            } if !self.tables.is_laid_on_shapes(t.texture) => (
                State::GEOMETRY.look,
                self.textures.number(t, o, None).map(Modifier::Texture),
            ),
            look => (look, None),
        };
        let mut tools = self.flat_union(nodes, state.look(look));
        let cut = base.map_or(Aabb::ALL, |base| self.box_of(base));
        if offset.is_none() {
            self.overlap_tools(&mut tools, cut);
        }
        for (node, state) in tools {
            let piece = match base {
                Some(base) => self.cutter(base, node, state),
                None => Some(self.refer(node, state)),
            };
            out.extend(piece.map(|p| p.with(modifier.clone())));
        }
        out
    }

    /// The object to be taken away for one cutter; `None` if it takes nothing away. A − (A′ ∩ X) is written as A − X if
    /// A is in A′, and A − (B − A) as A: their common faces would be speckled.
    fn cutter(&mut self, base: NodeId, node: NodeId, state: State) -> Option<Object<'a>> {
        let longer = self.longer_tool(node, base);
        let change = match state.flush {
            Some(change) => Some(self.changes.both(longer, change)),
            None => longer,
        };
        let state = state.flush(change);
        let (whole, tool) = (self.solids.place(base), self.solids.place(node));
        if self.solids.is_apart(whole, tool) {
            return None;
        }
        let descent = self.descend(node, state, Stop::BelowStart);
        let Some(End::Intersection(a, b, inner)) = descent.bare() else {
            return Some(self.refer(node, state));
        };
        let members = self.flat_intersection(a, b, inner);
        let mut kept = members.clone();
        kept.retain(|(m, _)| !self.is_within(base, &[*m]));
        if kept.len() == members.len() || kept.is_empty() {
            return Some(self.refer(node, state));
        }
        Some(Object::of(Operation::Intersection, self.refer_all(kept)))
    }

    /// Cuts a base of several substances: each group of parts of one substance is cut by itself. `None` if nothing is
    /// left.
    fn cut_by_part(&mut self, base: (NodeId, State), cutters: &[NodeId]) -> Option<Object<'a>> {
        let descent = self.descend(base.0, base.1, Stop::Never);
        let moved = (descent.modifiers.iter()).try_fold(Matrix::IDENTITY, |before, m| match m {
            Modifier::Matrix(m) => Some(m.after(&before)),
            _ => None,
        });
        let back = moved.and_then(|m| m.inverse());
        let (End::Union(a, b, state), Some(back)) = (descent.end, back) else {
            let base = self.refer(base.0, base.1);
            return Some(self.cut_away(base, cutters, &Matrix::IDENTITY, Vec::new()));
        };
        let mut parts = self.flat_union(&[a, b], state);
        if back == Matrix::IDENTITY {
            parts.retain(|(node, _)| !self.is_within(*node, cutters));
        }
        let substance = |&(node, state): &(NodeId, State)| self.substance(node, state);
        let operands =
            (parts.into_iter()).map(|part| (substance(&part), part, self.box_of(part.0)));
        let groups = grouping::in_order(operands, self.budget);
        let mut pieces = Vec::new();
        for (i, group) in groups.iter().enumerate() {
            let mut others = Vec::new();
            for earlier in &groups[..i] {
                if meet(&[&earlier.boxes, &group.boxes]) {
                    others.extend(self.taken_first(earlier, group));
                }
            }
            pieces.extend(self.cut_group(group, cutters, &back, others));
        }
        Some(Object::unless_empty(Operation::Union, pieces)?.with(descent.modifiers))
    }

    /// The solids of an earlier group that are taken from a later one. Where parts of different substance overlap, the
    /// first one owns the overlap.
    fn taken_first(&mut self, earlier: &Cut, later: &Cut) -> Vec<Object<'a>> {
        let mut both = earlier.members.iter().chain(&later.members);
        if both.any(|&(node, state)| self.is_transparent(node, state.look)) {
            self.report.count(
                "cut faces through overlapping transparent parts",
                Fidelity::approximate("faces between the parts may show twice"),
                "",
            );
        } else if self.cut_open {
            self.report.count(
                "cut faces through overlapping parts that are seen from within",
                Fidelity::approximate("faces between the parts show"),
                "",
            );
        }
        let bare = |(node, _): &(NodeId, State)| (*node, State::GEOMETRY);
        self.refer_all(earlier.members.iter().map(bare))
    }

    fn cut_group(
        &mut self,
        group: &Cut,
        cutters: &[NodeId],
        back: &Matrix,
        others: Vec<Object<'a>>,
    ) -> Option<Object<'a>> {
        let Some((look, index)) = group.key else {
            let base = self.union(group.members.clone())?;
            return Some(self.cut_away(base, cutters, back, others));
        };
        let nodes = group.members.iter();
        let nodes = nodes.map(|(node, state)| (*node, state.medium(Medium::Above)));
        let base = self.union(nodes.collect())?;
        let first = group.members.first();
        let transparent = first.is_some_and(|(node, _)| self.is_transparent(*node, look));
        let look = match look {
            Appearance::Own {
                texture: Some(t),
                optics,
            } => Appearance::Own {
                // The cutters lie outside the transformations that the base is in, so the texture is brought there.
                texture: Some(self.tables.moved_back(t, back)),
                optics,
            },
            look => look,
        };
        let taken = moved(self.cutters(cutters, look, None, None), back);
        let interior = (transparent && index != DEFAULT).then(|| self.index(index));
        Some(difference(Operation::Difference, base, taken, others).with(interior))
    }

    /// The last resort for a base of several substances: POV-Ray finds out at every point of a cut
    /// face what it cuts.
    fn cut_away(
        &mut self,
        base: Object<'a>,
        cutters: &[NodeId],
        back: &Matrix,
        others: Vec<Object<'a>>,
    ) -> Object<'a> {
        self.report.count(
            "cut faces of composite objects",
            Fidelity::approximate(
                "where parts overlap the mean of their textures; textures laid on shapes are misplaced",
            ),
            "cutaway_textures",
        );
        let taken = self.cutters(cutters, State::GEOMETRY.look, None, None);
        difference(
            Operation::CutawayDifference,
            base,
            moved(taken, back),
            others,
        )
    }
}

fn difference<'a>(
    operation: Operation,
    base: Object<'a>,
    taken: Vec<Object<'a>>,
    others: Vec<Object<'a>>,
) -> Object<'a> {
    let members = std::iter::once(base).chain(taken).chain(others);
    Object::of(operation, members.collect())
}

fn moved<'a>(pieces: Vec<Object<'a>>, m: &Matrix) -> Vec<Object<'a>> {
    if *m == Matrix::IDENTITY {
        return pieces;
    }
    let moved = |p: Object<'a>| p.with([Modifier::Matrix(*m)]);
    pieces.into_iter().map(moved).collect()
}
