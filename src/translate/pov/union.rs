//! Unions. Opaque ones are plain: what lies inside is never seen. In transparent ones the faces
//! inside have to go, except where two media meet; there the first medium owns the overlap.

use super::aspects::DEFAULT;
use super::build::{Builder, inside_medium};
use super::piece::{Group, Look, Medium, Modifier, Part, Piece, State};
use crate::scene::{Aabb, NodeId};
use crate::translate::fidelity::Fidelity;

/// Operands of an operation.
type Operands = Vec<(NodeId, State)>;

/// Operands of a union that are one medium.
pub(super) struct Members {
    /// Optics and index; `None` where the one operand is of several media by itself.
    medium: Option<(u32, u32)>,
    pub nodes: Operands,
    pub boxes: Vec<Aabb>,
    transparent: bool,
    /// Position of the first and last among all operands.
    first: usize,
    last: usize,
}

impl Builder<'_> {
    /// The union of operands that are no unions themselves.
    pub(super) fn union(&mut self, members: Vec<(NodeId, State)>) -> Option<Piece> {
        let transparent = |&(node, state): &(NodeId, State)| {
            self.facts[node as usize].has_solid
                && state.part != Part::Surface
                && self.is_transparent(node, state.look)
        };
        if !members.iter().any(transparent) {
            let pieces = self.pieces(&members);
            return non_empty(Group::Union, pieces);
        }
        let (solids, surfaces) = self.by_part(&members);
        let mut groups = self.by_medium(&solids);
        let mut pieces = Vec::new();
        for i in 0..groups.len() {
            let mut clips = Vec::new();
            for earlier in 0..i {
                if groups[earlier].transparent && meet(&groups[earlier].boxes, &groups[i].boxes) {
                    self.overlap(&groups[earlier], &groups[i]);
                    clips.extend(self.outside_of(&groups[earlier]));
                }
            }
            let piece = self.one_medium_union(&mut groups[i]);
            pieces.extend(piece.map(|p| p.with(clips)));
        }
        pieces.extend(self.pieces(&surfaces));
        non_empty(Group::Union, pieces)
    }

    /// Solids and surfaces apart: a merge has no place for surfaces.
    fn by_part(&self, members: &[(NodeId, State)]) -> (Operands, Operands) {
        let (mut solids, mut surfaces) = (Vec::new(), Vec::new());
        for &(node, state) in members {
            let f = self.facts[node as usize];
            if f.has_solid && state.part != Part::Surface {
                solids.push((node, state.part(Part::Solid)));
            }
            if f.has_surface && state.part != Part::Solid {
                surfaces.push((node, state.part(Part::Surface)));
            }
        }
        (solids, surfaces)
    }

    fn by_medium(&self, solids: &[(NodeId, State)]) -> Vec<Members> {
        let mut groups: Vec<Members> = Vec::new();
        let mut known = std::collections::HashMap::new();
        for (at, &(node, state)) in solids.iter().enumerate() {
            let medium = self.medium(node, state);
            let next = groups.len();
            let group = medium.map_or(next, |m| *known.entry(m).or_insert(next));
            if group == next {
                groups.push(Members {
                    medium,
                    nodes: Vec::new(),
                    boxes: Vec::new(),
                    transparent: self.is_transparent(node, state.look),
                    first: at,
                    last: at,
                });
            }
            groups[group].nodes.push((node, state));
            groups[group].boxes.push(self.box_of(node));
            groups[group].last = at;
        }
        groups
    }

    /// The optics and index of a node that is one medium. What an object around the node gives is
    /// the same for all operands and counts as the default.
    fn medium(&self, node: NodeId, state: State) -> Option<(u32, u32)> {
        let f = &self.facts[node as usize];
        let optics = match state.look {
            Look::Above { .. } => Some(DEFAULT),
            Look::Own {
                optics: Some(o), ..
            } => Some(o),
            Look::Own { optics: None, .. } => f.optics.uniform.then_some(f.optics.first),
        };
        let index = match state.medium {
            Medium::Above => Some(DEFAULT),
            Medium::Own => f.index.uniform.then_some(f.index.first),
        };
        optics.zip(index)
    }

    /// Operands of one medium as one object; its inside is one, too.
    fn one_medium_union(&mut self, group: &mut Members) -> Option<Piece> {
        let merged = group.transparent && group.nodes.len() > 1 && meet_each_other(&group.boxes);
        if !merged {
            let pieces = self.pieces(&group.nodes);
            return non_empty(Group::Union, pieces);
        }
        let index = group.medium.map_or(DEFAULT, |(_, index)| index);
        for (_, state) in &mut group.nodes {
            *state = inside_medium(*state);
        }
        let pieces = self.pieces(&group.nodes);
        let piece = non_empty(Group::Merge, pieces)?;
        Some(piece.with((index != DEFAULT).then_some(Modifier::Interior(index))))
    }

    /// Keeps of an object what no operand of a group holds.
    fn outside_of(&mut self, group: &Members) -> Option<Modifier> {
        let by = self.geometry(group)?;
        Some(Modifier::Clip {
            by: std::boxed::Box::new(by),
            outside: true,
        })
    }

    /// The bare solid of a group.
    pub(super) fn geometry(&mut self, group: &Members) -> Option<Piece> {
        let members: Vec<_> = group
            .nodes
            .iter()
            .map(|&(node, _)| (node, State::GEOMETRY))
            .collect();
        let pieces = self.pieces(&members);
        non_empty(Group::Union, pieces)
    }

    /// Says what two overlapping media cost.
    pub(super) fn overlap(&mut self, earlier: &Members, later: &Members) {
        let index = |g: &Members| g.medium.map(|(_, index)| index);
        if index(earlier) != Some(DEFAULT) || index(later) != Some(DEFAULT) {
            self.media_are_approximate();
        }
        if earlier.last > later.first {
            self.report.count(
                "order of overlapping media",
                Fidelity::Approximate("overlaps may belong to another part".to_owned()),
                "parts of one medium are joined first",
            );
        }
    }
}

pub(super) fn non_empty(kind: Group, pieces: Vec<Piece>) -> Option<Piece> {
    (!pieces.is_empty()).then(|| Piece::group(kind, pieces))
}

/// So many pairs of boxes are looked at before two sets are taken to meet.
const PATIENCE: usize = 1 << 20;

/// Whether a box of one set touches one of the other.
pub(super) fn meet(a: &[Aabb], b: &[Aabb]) -> bool {
    sweep(a, b)
}

/// Whether two boxes of a set touch.
fn meet_each_other(boxes: &[Aabb]) -> bool {
    sweep(boxes, &[])
}

/// Sweeps a plane along x over both sets and compares boxes that it cuts at the same time: each of
/// one set with each of the other, or, where the other set is empty, all with all.
fn sweep(a: &[Aabb], b: &[Aabb]) -> bool {
    let tagged = |set: &[Aabb], tag: bool| -> Vec<(Aabb, bool)> {
        let full = set.iter().filter(|s| !s.is_empty());
        full.map(|s| (*s, tag)).collect()
    };
    let mut all = tagged(a, false);
    all.extend(tagged(b, true));
    all.sort_by(|x, y| x.0.min[0].total_cmp(&y.0.min[0]));
    let within = b.is_empty();
    let mut open: Vec<(Aabb, bool)> = Vec::new();
    let mut compared = 0;
    for (this, tag) in all {
        open.retain(|(o, _)| o.max[0] >= this.min[0]);
        compared += open.len();
        let hit = |(o, t): &(Aabb, bool)| (within || *t != tag) && o.overlaps(&this);
        if compared > PATIENCE || open.iter().any(hit) {
            return true;
        }
        open.push((this, tag));
    }
    false
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cube(x: f64, y: f64) -> Aabb {
        Aabb::new([x, y, 0.0], [x + 1.0, y + 1.0, 1.0])
    }

    #[test]
    fn boxes_meet() {
        assert!(!meet(&[cube(0.0, 0.0)], &[cube(0.5, 2.0), cube(3.0, 0.0)]));
        assert!(meet(&[cube(0.0, 0.0)], &[cube(5.0, 0.0), cube(0.5, 0.5)]));
        assert!(!meet_each_other(&[cube(0.0, 0.0), cube(0.0, 3.0)]));
        assert!(meet_each_other(&[
            cube(0.0, 0.0),
            cube(0.0, 3.0),
            Aabb::ALL
        ]));
    }
}
