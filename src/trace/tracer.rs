//! A scene made ready for tracing.

#![warn(missing_docs)]

use super::compile::compile;
use super::graph::Graph;
use super::image::Images;
use super::memory_limit::MemoryLimit;
use super::plan::{Effect, Plan};
use super::precision::Precision;
use super::ray::Ray;
use crate::diagnostics::Error;
use crate::geometry::aabb::Aabb;
use crate::geometry::vec::Vec3;
use crate::scene::Scene;

/// A point light, its colour times its intensity.
#[derive(Debug, Clone, Copy)]
pub struct Light {
    pub position: Vec3,
    pub power: Vec3,
}

/// A scene made ready for tracing.
pub struct Tracer {
    /// The scene as the tracer walks it.
    pub graph: Graph,
    pub(super) ambient: Vec3,
    pub(super) lights: Vec<Light>,
    pub(super) background: Vec3,
    /// The region that is drawn; `None` if it cuts nothing off.
    pub(super) clip: Option<Aabb>,
    /// The effects that the scene calls for.
    pub plan: Plan,
}

impl Tracer {
    /// Compiles the object that the render record names, by the plan of the scene.
    ///
    /// # Errors
    ///
    /// Names the first shape or texture found that cannot be drawn, or the missing render record.
    /// Image textures cannot be drawn here: their pictures come with [`Tracer::with_images`].
    pub fn new(scene: &Scene) -> Result<Tracer, Error> {
        Tracer::with_images(scene, &Images::default())
    }

    /// Compiles the object that the render record names, with the pictures of its textures.
    ///
    /// # Errors
    ///
    /// The errors of [`Tracer::new`], but an image texture is an error only if its picture is missing.
    pub fn with_images(scene: &Scene, images: &Images) -> Result<Tracer, Error> {
        let plan = Plan::new(scene).ok_or_else(Error::nothing_to_draw)?;
        Tracer::planned(scene, images, plan)
    }

    /// [`Tracer::with_images`] with the plan already made.
    ///
    /// # Errors
    ///
    /// The errors of [`Tracer::with_images`].
    pub fn planned(scene: &Scene, images: &Images, plan: Plan) -> Result<Tracer, Error> {
        let render = scene.render.ok_or_else(Error::nothing_to_draw)?;
        let graph = compile(scene, images, render.root, &plan.left_out)?;
        let ambient = scene
            .ambient_lights
            .iter()
            .fold(Vec3::ZERO, |sum, l| sum + Vec3(l.colour) * l.intensity);
        let points = scene.point_lights.iter().map(|l| Light {
            position: l.position.into(),
            power: Vec3(l.colour) * l.intensity,
        });
        let region = render.clip.map(|(min, max)| Aabb::new(min, max));
        Ok(Tracer {
            ambient,
            lights: points.collect(),
            background: render.background.into(),
            clip: region.filter(|_| plan.on(Effect::ClipBox)),
            graph,
            plan,
        })
    }

    /// Limits the memory that each thread may take for a ray, in bytes. Returns `false` if that is surely too little.
    pub fn confine(&mut self, bytes: u64) -> bool {
        self.graph.room = MemoryLimit::of(bytes);
        !self.graph.is_crowded()
    }

    /// The start and the end of the part of (0, to] in which a ray is in the region that is drawn; `None` if there is
    /// none.
    #[inline]
    pub(super) fn window<R: Precision>(&self, ray: &Ray<R>, to: R) -> Option<(R, R)> {
        match &self.clip {
            None => Some((R::ZERO, to)),
            Some(clip) => {
                let (from, end) = clip.clip(&R::coarse(&ray.line), 0.0, to.to_f64())?;
                Some((R::of(from), R::of(end)))
            }
        }
    }
}
