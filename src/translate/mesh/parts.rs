//! The scene as pieces that are not joined.

use std::collections::BTreeMap;

use super::assemble::{Assembly, MeshPart, Thing, Troubles, crowded};
use super::budget::{Budget, Crowd, TooMany};
use super::extent::Extent;
use super::options::Options;
use super::shape;
use super::surface_label::SurfaceLabel;
use super::unite::{self, Union};
use crate::diagnostics::Error;
use crate::geometry::{Aabb, Matrix};
use crate::scene::Scene;
use crate::solids::bounds::NodeBounds;
use crate::trace::graph::Graph;
use crate::translate::{Fidelity, Report};

/// The scene as pieces that are not joined.
#[derive(Debug)]
pub struct Parts {
    /// Cut to the region. Labels are indices into `skins`, or [`shape::DROPPED`].
    pub pieces: Vec<MeshPart>,
    pub skins: Vec<SurfaceLabel>,
    pub extent: Extent,
    pub(super) troubles: Troubles,
}

impl Parts {
    /// Builds the scene's pieces.
    ///
    /// # Errors
    /// There would be too many triangles.
    pub fn of(
        scene: &Scene,
        bounds: &[NodeBounds],
        graph: &Graph,
        options: &Options,
    ) -> Result<Parts, Error> {
        let extent = Extent::of(scene, bounds, options);
        let (thing, troubles) = pieces(scene, graph, &extent, options)?;
        Ok(Parts {
            pieces: thing.pieces,
            skins: thing.skins,
            extent,
            troubles,
        })
    }

    /// Joins solids that overlap, are of the same kind, and have the same medium around them. `kind` gets a piece's
    /// index and the piece; `None` leaves the piece as it is. A group of too many solids stays as it is, too.
    ///
    /// # Errors
    /// The work takes too long.
    pub fn join_by<K: Ord>(
        &mut self,
        kind: impl Fn(usize, &MeshPart) -> Option<K>,
    ) -> Result<(), Error> {
        let mut budget = Budget::default();
        let mut groups: BTreeMap<(K, Option<u32>), Vec<MeshPart>> = BTreeMap::new();
        for (i, piece) in std::mem::take(&mut self.pieces).into_iter().enumerate() {
            match kind(i, &piece).filter(|_| !piece.surface) {
                Some(k) => groups.entry((k, piece.around)).or_default().push(piece),
                None => self.pieces.push(piece),
            }
        }
        for ((_, around), group) in groups {
            let boxes: Vec<Aabb> = group.iter().map(|p| p.bounds).collect();
            let overlapping = unite::overlapping(&boxes);
            let mut together = Vec::new();
            for (piece, overlaps) in group.into_iter().zip(overlapping) {
                match overlaps {
                    true => together.push(piece),
                    false => self.pieces.push(piece),
                }
            }
            let Some(inside) = together.first().map(|p| p.inside) else {
                continue;
            };
            let crowd = Crowd {
                solids: together.len(),
                label: inside,
            };
            if crowd.is_hopeless(together.iter().map(|p| p.mesh.triangles.len()).sum()) {
                self.troubles.unjoined += together.len() as u64;
                self.pieces.append(&mut together);
                continue;
            }
            let together = together.into_iter().map(|p| p.mesh).collect();
            let union = Union::of(together, &mut budget)
                .map_err(|crowd| refusal(&crowded(crowd, &self.skins)))?;
            self.troubles.unjoined += union.failures;
            for (bounds, mesh) in union.meshes {
                self.pieces.push(MeshPart {
                    mesh,
                    bounds,
                    inside,
                    surface: false,
                    whole: false,
                    around,
                });
            }
        }
        Ok(())
    }

    /// Maps all pieces, skins and lengths. `m` has to stretch all directions alike.
    pub fn place(&mut self, m: &Matrix) {
        for piece in &mut self.pieces {
            piece.mesh.transform(m);
            piece.bounds = piece.mesh.bounds();
        }
        for skin in &mut self.skins {
            *skin.matrix = m.after(&skin.matrix);
            if let Some(texture) = &mut skin.texture {
                texture.matrix = m.after(&texture.matrix);
            }
        }
        let by = shape::stretch(m);
        self.extent.region = self.extent.region.transformed(m);
        self.extent.cut = self.extent.cut.transformed(m);
        self.extent.tolerance *= by;
        self.extent.radius *= by;
    }

    /// Whether the render box cuts some solid open.
    pub fn is_cut_open(&self) -> bool {
        let caps = |l: &u32| {
            self.skins
                .get(*l as usize)
                .is_some_and(|s| s.primitive.is_none())
        };
        let mut solids = self.pieces.iter().filter(|p| !p.surface);
        self.extent.boxed && solids.any(|p| p.mesh.labels.iter().any(caps))
    }

    /// Adds to a report what was approximated in this scene. `endless` is the number of endless parts that were
    /// written as such and do not count.
    pub fn account(&self, report: &mut Report, endless: u64) {
        let troubles = Troubles {
            endless: self.troubles.endless.saturating_sub(endless),
            ..self.troubles
        };
        account(report, &self.extent, &troubles);
    }
}

/// The scene as pieces that are not joined yet.
pub(super) fn pieces(
    scene: &Scene,
    graph: &Graph,
    extent: &Extent,
    options: &Options,
) -> Result<(Thing, Troubles), Error> {
    let budget = Budget::of(options.memory);
    let mut assembly = Assembly::new(scene, graph, &extent.cut, extent.tolerance, budget);
    let thing = assembly
        .pieces(&extent.cut, extent.boxed)
        .map_err(|e| refusal(&e))?;
    Ok((thing, assembly.troubles))
}

pub(super) fn refusal(e: &TooMany) -> Error {
    Error::scene(e.complaint())
}

/// Adds to a report what was approximated in this scene: endless parts, and operations that failed.
pub(super) fn account(report: &mut Report, extent: &Extent, troubles: &Troubles) {
    for _ in 0..troubles.endless {
        let fidelity = Fidelity::Approximate(extent.cut_off());
        report.count("parts without end", fidelity, "");
    }
    for _ in 0..troubles.uncut {
        let fidelity = Fidelity::approximate("an operand was left as it is");
        report.count("operations that failed", fidelity, "");
    }
    for _ in 0..troubles.unjoined {
        let fidelity = Fidelity::approximate("both are there, one in the other");
        report.count("overlapping parts that were not joined", fidelity, "");
    }
}
