//! The scene as triangles, for every program that reads meshes.
//!
//! [`shape`] makes each shape of triangles that keep within a tolerance of it; [`assemble`] places and
//! combines them as the scene says, by [`operate`], with [`csg`] for two solids, [`unite`] for many, of which
//! [`crowds`] finds those that overlap, and [`carve`] for those of different media; [`shared`] finds surfaces that are there twice; [`skin`] knows
//! what each triangle shows; [`ply`], [`obj`] and [`glb`] write files.

mod assemble;
mod budget;
mod carve;
pub mod corners;
mod crowds;
mod csg;
mod extent;
mod flush;
pub mod glb;
mod material;
mod needles;
pub mod obj;
mod operate;
pub mod picture;
pub mod ply;
mod refine;
mod sets;
pub mod shape;
mod shared;
mod skin;
mod soup;
#[cfg(test)]
mod tests;
mod unite;
mod verdict;

pub use assemble::Piece;
pub use carve::Medium;
pub use extent::Extent;
pub use material::{Coloured, Material};
pub use skin::Skin;
pub use soup::Mesh;

use std::collections::BTreeMap;

use super::{Fidelity, Report};
use crate::diagnostics::Error;
use crate::geometry::{Aabb, Matrix};
use crate::scene::{Scene, Vec3};
use crate::trace::graph::Graph;
use assemble::{Assembly, Thing, Troubles, crowded};
use budget::{Budget, Crowd, TooMany};
use shape::DROPPED;
use unite::Union;

/// What the scene itself does not say.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Options {
    /// How far a triangle may be from the surface it stands for, in scene units; by default
    /// [`DEFAULT_TOLERANCE`] of the scene's size.
    pub tolerance: Option<f64>,
    /// Where the scene is seen from, if that matters: parts without end reach that far, too.
    pub eye: Option<Vec3>,
    /// Textures are pictures, so that triangles need not be small for their sake.
    pub pictured: bool,
    /// How much memory triangles may take, in bytes, if that matters.
    pub memory: Option<u64>,
}

/// The tolerance by the radius of the sphere around the scene: a quarter of a pixel where the scene fills
/// a picture of 480 rows.
pub const DEFAULT_TOLERANCE: f64 = 1e-3;

/// The scene as one mesh.
#[derive(Debug)]
pub struct Model {
    /// Solids joined into closed meshes, then surfaces; labels are indices into `skins`.
    pub mesh: Mesh,
    /// How many of the triangles belong to solids.
    pub solid: usize,
    pub skins: Vec<Skin>,
    pub extent: Extent,
    troubles: Troubles,
}

/// The scene as pieces that are not joined.
#[derive(Debug)]
pub struct Parts {
    /// Cut to the region. Labels are indices into `skins`, or [`shape::DROPPED`].
    pub pieces: Vec<Piece>,
    pub skins: Vec<Skin>,
    pub extent: Extent,
    troubles: Troubles,
}

impl Parts {
    /// Makes the scene of pieces.
    ///
    /// # Errors
    /// There would be too many triangles.
    pub fn of(scene: &Scene, graph: &Graph, options: &Options) -> Result<Parts, Error> {
        let extent = Extent::of(scene, options);
        let (thing, troubles) = pieces(scene, graph, &extent, options)?;
        Ok(Parts {
            pieces: thing.pieces,
            skins: thing.skins,
            extent,
            troubles,
        })
    }

    /// Joins those solids that overlap, are chosen (by number and piece) and of one kind, and have the same around them; the
    /// others stay as they are, and so do those that are too many.
    ///
    /// # Errors
    /// It takes too long.
    pub fn join_by<K: Ord>(
        &mut self,
        kind: impl Fn(usize, &Piece) -> Option<K>,
    ) -> Result<(), Error> {
        let mut budget = Budget::default();
        let mut groups: BTreeMap<(K, Option<u32>), Vec<Piece>> = BTreeMap::new();
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
                self.pieces.push(Piece {
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

    /// Moves everything; lengths are to be stretched alike.
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

    /// Adds to a report what became of this scene in particular.
    pub fn account(&self, report: &mut Report) {
        account(report, &self.extent, &self.troubles);
    }
}

/// Makes the scene of triangles.
///
/// # Errors
/// There would be too many.
pub fn model(scene: &Scene, graph: &Graph, options: &Options) -> Result<Model, Error> {
    let extent = Extent::of(scene, options);
    let (thing, mut troubles) = pieces(scene, graph, &extent, options)?;
    let (mut solids, mut surfaces) = (Vec::new(), Mesh::default());
    for piece in thing.pieces {
        if piece.surface {
            surfaces.append(&piece.mesh.only(|label| label != DROPPED));
        } else {
            solids.push(piece.mesh);
        }
    }
    let union = Union::of(solids, &mut Budget::default())
        .map_err(|crowd| refusal(&crowded(crowd, &thing.skins)))?;
    troubles.unjoined += union.failures;
    let mut mesh = Mesh::default();
    for (_, part) in &union.meshes {
        mesh.append(part);
    }
    let textured: Vec<bool> = thing
        .skins
        .iter()
        .map(|skin| {
            let pictured = options.pictured && picture::is_pictured(skin, graph);
            skin.plain_colour(graph).is_none() && !pictured
        })
        .collect();
    for part in [&mut mesh, &mut surfaces] {
        part.refine(|label| textured[label as usize], |_| extent.grain());
        part.drop_needles();
    }
    let solid = mesh.triangles.len();
    mesh.append(&surfaces);
    Ok(Model {
        mesh,
        solid,
        skins: thing.skins,
        extent,
        troubles,
    })
}

/// The scene as pieces that are not joined yet.
fn pieces(
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

fn refusal(e: &TooMany) -> Error {
    Error::scene(e.complaint())
}

/// The report on a mesh for one of the targets.
pub fn report(target: &'static str, scene: &Scene, model: &Model) -> Report {
    let mut report = Report::of(target, scene, |feature| {
        verdict::verdict(target, feature, model.extent.tolerance)
    });
    account(&mut report, &model.extent, &model.troubles);
    report
}

/// What became of this scene in particular.
fn account(report: &mut Report, extent: &Extent, troubles: &Troubles) {
    for _ in 0..troubles.endless {
        let fidelity = Fidelity::Approximate(extent.cut_off());
        report.count("parts without end", fidelity, "");
    }
    for _ in 0..troubles.uncut {
        let fidelity = Fidelity::Approximate("an operand was left as it is".to_owned());
        report.count("operations that failed", fidelity, "");
    }
    for _ in 0..troubles.unjoined {
        let fidelity = Fidelity::Approximate("both are there, one in the other".to_owned());
        report.count("overlapping parts that were not joined", fidelity, "");
    }
}
