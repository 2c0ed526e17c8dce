//! Scenes of flat pieces made from the given scene: meshes within a tolerance, and geodesic spheres of other levels.

use super::configurations::{Axis, Configuration, Settings, variant};
use super::runner::Runner;
use crate::diagnostics::{Error, Span};
use crate::scene::{Geometry, Node, Paint, Scene, Shape, Texture, TriangleNormals};
use crate::solids::bounds::node_bounds;
use crate::syntax::table::ShapeKind;
use crate::trace::plan::Effect;
use crate::translate::mesh::{self, Options, SurfaceLabel};
use std::sync::Arc;
use std::time::Instant;

/// The largest number of triangles of a mesh that is drawn for comparison.
const MAX_TRIANGLES: usize = 400_000;

/// The tolerances of the meshes, as shares of the scene's radius.
const TOLERANCES: [f64; 4] = [0.03, 0.01, 0.003, 0.001];

/// The reason why meshes cannot stand for the scene, as the name of a message; `None` where they can.
pub fn unfit(runner: &Runner) -> Option<&'static str> {
    let plan = &runner.tracer().plan;
    let patterns = [
        Effect::ImageTexture,
        Effect::SolidTexture,
        Effect::Checkerboard,
        Effect::VertexColour,
    ];
    let curved = |geometry: &Geometry| {
        !matches!(
            geometry,
            Geometry::Plane(_)
                | Geometry::HalfSpace(_)
                | Geometry::Rectangle { .. }
                | Geometry::Box { .. }
                | Geometry::Triangle { .. }
                | Geometry::GeodesicSphere { .. }
        )
    };
    let geometry = |r: &u32| &runner.scene().shapes[*r as usize].geometry;
    match () {
        () if plan.on(Effect::Refraction) => Some("accuracy-skip-glass"),
        () if !runner
            .tracer()
            .graph
            .records
            .iter()
            .map(geometry)
            .any(curved) =>
        {
            Some("accuracy-skip-flat")
        }
        () if patterns.into_iter().any(|e| plan.on(e)) => Some("accuracy-skip-patterns"),
        () if runner.tracer().graph.parts.len() > 20_000 => Some("accuracy-skip-mesh"),
        () => None,
    }
}

/// The configurations of an axis of flat pieces, and the settings of their reference, which draws the true shapes.
pub struct Facets {
    pub configurations: Vec<Configuration>,
    pub reference: Settings,
}

/// Makes meshes of the scene and adds them to the runner. Meshes and reference are drawn without the render box, which
/// caps a solid but cuts a mesh open. A finer mesh is begun only if it would be done within `seconds`. `None` if no
/// mesh was made.
///
/// # Errors
///
/// As [`Runner::add`].
pub fn meshes(runner: &mut Runner, seconds: f64) -> Result<Option<Facets>, Error> {
    let mut whole = runner.scene().clone();
    let mut base = 0;
    if let Some(render) = &mut whole.render
        && render.clip.take().is_some()
    {
        base = runner.add(Arc::new(whole.clone()))?;
    }
    let bounds = node_bounds(&whole);
    let radius = (whole.render).map_or(1.0, |r| bounds[r.root as usize].bounded().radius());
    let mut configurations = Vec::new();
    let mut before = 0;
    let start = Instant::now();
    let mut last = 0.0;
    for share in TOLERANCES {
        let spent = start.elapsed().as_secs_f64();
        // A finer mesh takes three times as long as the one before it.
        if spent + 3.0 * (spent - last) > seconds {
            break;
        }
        last = spent;
        let options = Options {
            tolerance: Some(share * radius),
            eye: Some(runner.camera().position),
            ..Options::default()
        };
        let Ok(model) = mesh::model(&whole, &bounds, &runner.tracer().graph, &options) else {
            continue;
        };
        let triangles = model.mesh.triangles.len();
        if triangles > MAX_TRIANGLES {
            break;
        }
        if std::mem::replace(&mut before, triangles) == triangles {
            // The finer tolerance gives the same mesh: only its last configuration is kept.
            configurations.pop();
        }
        let Some(made) = scene_of(&whole, &model, runner) else {
            continue;
        };
        let number = runner.add(Arc::new(made))?;
        let digits = share * radius;
        let label = if digits >= 0.01 {
            format!("{digits:.3}")
        } else {
            format!("{digits:.1e}")
        };
        configurations.push(variant(Axis::Tessellation, label, number));
    }
    if configurations.is_empty() {
        return Ok(None);
    }
    configurations.push(variant(Axis::Tessellation, "true".into(), base));
    Ok(Some(Facets {
        configurations,
        reference: Settings {
            variant: base,
            ..Settings::default()
        },
    }))
}

/// Makes a scene of a mesh's triangles, with the optics and colours of their skins; `None` without triangles.
fn scene_of(whole: &Scene, model: &mesh::Model, runner: &Runner) -> Option<Scene> {
    let graph = &runner.tracer().graph;
    let mut made = Scene {
        ambient_lights: whole.ambient_lights.clone(),
        point_lights: whole.point_lights.clone(),
        cameras: whole.cameras.clone(),
        view: whole.view,
        ..Scene::default()
    };
    let mut by_skin: Vec<Vec<usize>> = vec![Vec::new(); model.skins.len()];
    for (i, &label) in model.mesh.labels.iter().enumerate() {
        // Faces without a skin are not shown.
        if let Some(own) = by_skin.get_mut(label as usize) {
            own.push(i);
        }
    }
    let origin = |id| crate::scene::Origin {
        id,
        span: Span::default(),
    };
    let mut root = None;
    for (skin, triangles) in model.skins.iter().zip(by_skin) {
        let mut union = None;
        for i in triangles {
            let vertices = model.mesh.corners(i).map(Into::into);
            let shape = made.shapes.len() as u32;
            made.shapes.push(Shape {
                id: SurfaceLabel::object(skin),
                kind: ShapeKind::Triangle,
                geometry: Geometry::Triangle {
                    vertices: Box::new(vertices),
                    normals: TriangleNormals::Flat,
                },
            });
            made.nodes.push(Node::Shape(shape));
            let node = made.nodes.len() as u32 - 1;
            union = Some(joined(&mut made, union, node));
        }
        let Some(child) = union else { continue };
        let paint = made.paints.len() as u32;
        made.paints.push(Paint {
            owner: SurfaceLabel::object(skin),
            texture: skin.plain_colour(graph).map(Texture::Colour),
            optics: Some(graph.optics[skin.optics.unwrap_or(0) as usize]),
            index: None,
        });
        made.nodes.push(Node::Paint { child, paint });
        let node = made.nodes.len() as u32 - 1;
        root = Some(joined(&mut made, root, node));
    }
    made.origins = made.nodes.iter().map(|_| origin(0)).collect();
    made.render = whole.render.map(|r| crate::scene::Render {
        root: root.unwrap_or(0),
        clip: None,
        ..r
    });
    root.map(|_| made)
}

fn joined(made: &mut Scene, before: Option<u32>, node: u32) -> u32 {
    match before {
        None => node,
        Some(before) => {
            made.nodes.push(Node::Union(before, node));
            made.nodes.len() as u32 - 1
        }
    }
}

/// Adds scenes whose geodesic spheres have levels 0 to 6, and as their reference a scene with true spheres.
///
/// # Errors
///
/// As [`Runner::add`].
pub fn levels(runner: &mut Runner) -> Result<Option<Facets>, Error> {
    let with = |change: &dyn Fn(f64, u32) -> Geometry| {
        let mut scene = runner.scene().clone();
        for shape in &mut scene.shapes {
            if let Geometry::GeodesicSphere { radius, splits } = shape.geometry {
                shape.geometry = change(radius, splits);
            }
        }
        Arc::new(scene)
    };
    let smooth = with(&|radius, _| Geometry::Sphere {
        centre: [0.0; 3],
        radius,
    });
    let leveled: Vec<_> = (0..=6)
        .map(|splits| {
            (
                splits,
                with(&|radius, _| Geometry::GeodesicSphere { radius, splits }),
            )
        })
        .collect();
    let reference = runner.add(smooth)?;
    let mut configurations = vec![variant(Axis::Levels, "as written".into(), 0)];
    for (splits, scene) in leveled {
        let number = runner.add(scene)?;
        configurations.push(variant(Axis::Levels, splits.to_string(), number));
    }
    Ok(Some(Facets {
        configurations,
        reference: Settings {
            variant: reference,
            ..Settings::default()
        },
    }))
}
