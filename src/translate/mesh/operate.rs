//! Operations on the pieces of things. Each piece is cut separately.

use std::collections::HashMap;

use super::assemble::{Assembly, MeshPart, Operand, Thing, crowded};
use super::budget::TooMany;
use super::csg::{Operation, combine};
use super::shape::{self, DROPPED};
use super::surface_label::SurfaceLabel;
use super::unite::Union;
use crate::geometry::Aabb;

impl Assembly<'_> {
    /// The pieces of what lies in all operands of `kept` and in none of `taken`.
    pub(super) fn intersection(
        &mut self,
        kept: Vec<Operand>,
        taken: Vec<Operand>,
        skins: &[SurfaceLabel],
    ) -> Result<Vec<MeshPart>, TooMany> {
        let tools = taken.into_iter().flat_map(|o| o.pieces);
        let tools = self.union_of_solids(tools, skins)?;
        let mut pieces = Vec::new();
        // Each operand's solids as one union, to cut the pieces of the other operands. The first operand's union is
        // needed only to cut surfaces.
        let has_surfaces = kept.iter().flat_map(|o| &o.pieces).any(|p| p.surface);
        let mut solids: Vec<Option<Union>> = Vec::with_capacity(kept.len());
        for (i, operand) in kept.iter().enumerate() {
            solids.push(match i > 0 || has_surfaces {
                true => Some(self.union_of_solids(operand.pieces.iter().cloned(), skins)?),
                false => None,
            });
        }
        for (i, operand) in kept.into_iter().enumerate() {
            for piece in operand.pieces {
                // The first operand gives the inside its material, so only its solids are pieces. Surfaces are kept
                // of every operand.
                if i > 0 && !piece.surface {
                    continue;
                }
                let others = solids.iter().enumerate().filter(|(j, _)| *j != i);
                let others = others.filter_map(|(_, u)| u.as_ref());
                pieces.extend(self.cut(piece, others, &tools));
            }
        }
        Ok(pieces)
    }

    fn union_of_solids(
        &mut self,
        pieces: impl Iterator<Item = MeshPart>,
        skins: &[SurfaceLabel],
    ) -> Result<Union, TooMany> {
        let meshes = pieces.filter(|p| !p.surface).map(|p| p.mesh).collect();
        let union = Union::of(meshes, &mut self.budget).map_err(|crowd| crowded(crowd, skins))?;
        self.troubles.unjoined += union.failures;
        Ok(union)
    }

    /// The part of a piece that lies in all of `kept` and outside of `taken`; `None` if nothing of it is seen.
    fn cut<'u>(
        &mut self,
        mut piece: MeshPart,
        kept: impl Iterator<Item = &'u Union>,
        taken: &Union,
    ) -> Option<MeshPart> {
        let steps = kept
            .map(|u| (u, Operation::Intersection))
            .chain([(taken, Operation::Difference)]);
        for (union, operation) in steps {
            let mut tool = union.near(&piece.bounds);
            if tool.is_empty() {
                match operation {
                    Operation::Intersection => return None,
                    _ => continue,
                }
            }
            if piece.surface {
                tool.label_all(DROPPED);
            }
            match combine(&piece.mesh, &tool, operation) {
                Ok(mesh) => {
                    piece.bounds = mesh.bounds();
                    piece.mesh = mesh;
                    piece.whole = false;
                }
                Err(_) => self.troubles.uncut += 1,
            }
            let gone = |l: &u32| piece.surface && *l == DROPPED;
            if piece.mesh.labels.iter().all(gone) {
                return None;
            }
        }
        Some(piece)
    }

    /// Cuts pieces that reach beyond the region, and labels the faces that close them again as caps. `boxed`: the
    /// region is the render box, so that a cut piece no longer counts as whole.
    pub(super) fn cut_to(&mut self, thing: &mut Thing, region: &Aabb, boxed: bool) {
        let mut caps: HashMap<u32, u32> = HashMap::new();
        let pieces = std::mem::take(&mut thing.pieces);
        for piece in pieces {
            if region.holds(&piece.bounds) {
                thing.pieces.push(piece);
                continue;
            }
            let skins = &mut thing.skins;
            let cap = *caps.entry(piece.inside).or_insert_with(|| {
                skins.push(SurfaceLabel::cap(skins.get(piece.inside as usize)));
                skins.len() as u32 - 1
            });
            let mut mesh = shape::flat::cuboid(region.min, region.max);
            mesh.label_all(cap);
            let all = Union {
                meshes: vec![(*region, mesh)],
                failures: 0,
            };
            let whole = piece.whole && !boxed;
            let cut = self.cut(piece, [&all].into_iter(), &Union::default());
            thing
                .pieces
                .extend(cut.map(|piece| MeshPart { whole, ..piece }));
        }
    }
}
