//! Small pictures: of the scene, or of one object fitted into view.

use std::borrow::Cow;
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use crate::analysis::Analysis;
use crate::diagnostics::Error;
use crate::scene::{Camera, NodeId, Render, Scene, View};
use crate::solids::staging::{Viewpoint, staged};
use crate::trace::film::Packing;
use crate::trace::plan::Plan;
use crate::trace::{Images, Settings, Tracer};

use super::entity;

/// The objects that a picture shows.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Subject {
    /// The objects that the render record names, with the scene's own camera and lights.
    Scene,
    /// An object, with the automatic camera and lights.
    Object(u32),
}

/// A scene ready to be drawn, at any size.
pub struct Stage {
    tracer: Tracer,
    camera: Camera,
}

impl Stage {
    /// Prepares pictures of the given aspect ratio: width divided by height.
    ///
    /// # Errors
    ///
    /// There is nothing to draw, or the tracer cannot draw it.
    pub fn new(analysis: &Analysis, subject: Subject, aspect: f64) -> Result<Stage, Error> {
        let scene = match subject {
            Subject::Scene => staged(&analysis.scene, Viewpoint::Scene, aspect),
            Subject::Object(id) => {
                let node = entity::entity(analysis, id).and_then(|e| e.node());
                let node = node.ok_or_else(Error::nothing_to_draw)?;
                let alone = alone(&analysis.scene, id, node);
                Cow::Owned(staged(&alone, Viewpoint::Scene, aspect).into_owned())
            }
        };
        let scene = &*scene;
        let plan = Plan::of_picture(scene).ok_or_else(Error::nothing_to_draw)?;
        let folder = analysis.source.folder().unwrap_or(Path::new("."));
        let images = Images::load(scene, folder)?;
        let tracer = Tracer::planned(scene, &images, plan)?;
        let camera = scene.chosen_cameras().next().copied();
        let camera = camera.ok_or_else(Error::nothing_to_draw)?;
        Ok(Stage { tracer, camera })
    }

    /// Draws a picture, as a PNG. `None` if it was stopped.
    ///
    /// # Errors
    ///
    /// The camera cannot take pictures.
    pub fn draw(
        &self,
        [width, height]: [u32; 2],
        stop: &Arc<AtomicBool>,
    ) -> Result<Option<Vec<u8>>, Error> {
        let settings = Settings {
            width,
            height,
            stop: Some(stop.clone()),
            ..Settings::default()
        };
        let picture = self.tracer.render(&self.camera, &settings, || ())?;
        if stop.load(Ordering::Relaxed) {
            return Ok(None);
        }
        let mut png = Vec::new();
        let written = picture.film.write_png(&mut png, Packing::Small);
        Ok(written.is_ok().then_some(png))
    }
}

/// The scene with one object drawn alone, by the automatic camera and lights.
fn alone(scene: &Scene, id: u32, node: NodeId) -> Scene {
    let mut scene = scene.clone();
    let span = scene.origins[node as usize].span;
    scene.render = Some(Render {
        root: node,
        root_id: id,
        background: [0.03; 3],
        clip: None,
        span,
    });
    scene.view = View::Automatic;
    scene.cameras.clear();
    scene.ambient_lights.clear();
    scene.point_lights.clear();
    scene
}
