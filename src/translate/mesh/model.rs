//! The scene as one mesh.

use super::assemble::{Troubles, crowded};
use super::budget::Budget;
use super::degenerate_triangles::Precision;
use super::extent::Extent;
use super::glb_scenery::has_counterpart;
use super::options::Options;
use super::parts::{account, pieces, refusal};
use super::picture;
use super::precision;
use super::shape::DROPPED;
use super::surface_label::SurfaceLabel;
use super::triangle_mesh::Mesh;
use super::unite::Union;
use super::verdict::{self, Bounds};
use crate::diagnostics::Error;
use crate::scene::Scene;
use crate::solids::bounds::NodeBounds;
use crate::syntax::table::RecordKind;
use crate::trace::graph::Graph;
use crate::translate::{Feature, FeatureSupport, Report};

/// The scene as one mesh.
#[derive(Debug)]
pub struct Model {
    /// Solids joined into closed meshes, then surfaces; labels are indices into `skins`.
    pub mesh: Mesh,
    /// The number of triangles that belong to solids; they come first.
    pub solid: usize,
    pub skins: Vec<SurfaceLabel>,
    pub extent: Extent,
    /// The largest distance that a point was moved so that every triangle has an area in the file.
    pub moved: f64,
    pub(super) troubles: Troubles,
}

/// Builds the scene as one mesh of triangles.
///
/// # Errors
/// There would be too many triangles, or too many overlapping solids to join.
pub fn model(
    scene: &Scene,
    bounds: &[NodeBounds],
    graph: &Graph,
    options: &Options,
) -> Result<Model, Error> {
    let extent = Extent::of(scene, bounds, options);
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
            !options.plain && !pictured && skin.plain_colour(graph).is_none()
        })
        .collect();
    let mut moved = 0.0f64;
    for part in [&mut mesh, &mut surfaces] {
        part.refine(|label| textured[label as usize], |_| extent.grain());
        let precision = match options.digits && !precision::is_single_enough(part, extent.tolerance)
        {
            true => Precision::Double,
            false => Precision::Single,
        };
        moved = moved.max(part.drop_needles(precision, extent.tolerance));
    }
    let solid = mesh.triangles.len();
    mesh.append(&surfaces);
    Ok(Model {
        mesh,
        solid,
        skins: thing.skins,
        extent,
        moved,
        troubles,
    })
}

/// The report on a mesh for one of the targets. `off` is the largest distance that the file's numbers move a point.
pub fn report(target: &'static str, scene: &Scene, model: &Model, off: f64) -> Report {
    let bounds = Bounds {
        tolerance: model.extent.tolerance,
        off: off + model.moved,
    };
    let cameras = scene.cameras.iter().all(has_counterpart);
    let mut report = Report::of(target, scene, |feature| match feature {
        Feature::Record(RecordKind::ProjectionMatrix) if target == "glb" && !cameras => {
            FeatureSupport::dropped("glTF has none that look askew or mirror")
        }
        _ => verdict::verdict(target, feature, bounds),
    });
    account(&mut report, &model.extent, &model.troubles);
    bounds.account(target, &mut report);
    report
}
