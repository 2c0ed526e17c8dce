//! The reference ray tracer.
//!
//! A [`Scene`] is compiled once into a [`graph`] in which shared parts stay shared; a [`Tracer`]
//! holds that and everything else a picture needs, and knows what cannot be drawn before the first
//! ray. In the order in which a pixel comes about: [`camera`] and [`sampling`] make rays,
//! [`nearest`] and [`spans`] find what they meet in the graph ([`walk`], [`shapes`], [`join`]),
//! [`hit`] says what is there, [`shade`] adds up the light, [`film`] keeps it. [`probe`] and
//! [`membership`] answer questions about single rays and points.
//!
//! All that is between a ray and its hits is generic over the number it computes with ([`precision`],
//! and [`geometry`](crate::geometry) for the numbers themselves). Every decision knows its rounding
//! errors ([`order`], and the shapes); what is closer than these in doubles, [`decide`] asks again in
//! double-double, and some shapes ask once more in quad-double.

pub mod adaptive;
pub mod camera;
mod compile;
pub mod costs;
mod crowd;
mod decide;
pub mod film;
mod finish;
pub mod graph;
pub mod hit;
pub mod image;
mod intern;
mod join;
pub mod membership;
pub mod nearest;
mod order;
mod passage;
mod picture;
pub mod plan;
pub mod precision;
mod probe;
mod quartic;
pub mod ray;
pub mod sampling;
pub mod shade;
pub mod shapes;
pub mod spans;
pub mod stats;
pub mod surfaces;
pub mod walk;

pub use costs::CostMap;
pub use decide::Walkers;
pub use film::Film;
pub use hit::Hit;
pub use image::Images;
pub use membership::{Membership, members};
pub use picture::{Crop, Numbers, Picture, Settings, selected_camera};
pub use probe::{Crossing, Probe};
pub use ray::Ray;

use crate::diagnostics::{Complaint, Error, Span};
use crate::geometry::aabb::Aabb;
use crate::geometry::line::Beam;
use crate::geometry::vec::Vec3;
use crate::scene::Scene;
use graph::Graph;
use plan::{Effect, Plan};
use precision::Precision;
use shade::Light;

/// What a record asks for cannot be drawn. `what` is a message of the catalogues, `id` the entity of the
/// record, 0 where there is none.
fn cannot_draw(what: &'static str, span: Span, id: u32) -> Error {
    let what = Complaint::new(what);
    Error::at(
        span,
        match id {
            0 => what,
            id => Complaint::new("cannot-draw")
                .with("what", what)
                .with("id", id.to_string()),
        },
    )
}

/// A scene made ready for tracing.
pub struct Tracer {
    pub graph: Graph,
    ambient: Vec3,
    /// `None`: there is no light at all, and the camera brings one.
    lights: Option<Vec<Light>>,
    background: Vec3,
    /// The region that is drawn, where it cuts anything.
    clip: Option<Aabb>,
    /// Which effects there are.
    pub plan: Plan,
}

impl Tracer {
    /// Compiles what the render record names, by the plan of the scene.
    ///
    /// # Errors
    ///
    /// Names the first shape or texture found that cannot be drawn, or the missing render record.
    /// Image textures cannot: their pictures come with [`Tracer::with_images`].
    pub fn new(scene: &Scene) -> Result<Tracer, Error> {
        Tracer::with_images(scene, &Images::default())
    }

    /// Compiles what the render record names, with its pictures.
    ///
    /// # Errors
    ///
    /// As [`Tracer::new`], but image textures only where their picture is missing.
    pub fn with_images(scene: &Scene, images: &Images) -> Result<Tracer, Error> {
        let plan = Plan::new(scene).ok_or_else(Error::nothing_to_draw)?;
        Tracer::planned(scene, images, plan)
    }

    /// [`Tracer::with_images`] with the plan already made.
    ///
    /// # Errors
    ///
    /// As there.
    pub fn planned(scene: &Scene, images: &Images, plan: Plan) -> Result<Tracer, Error> {
        let render = scene.render.ok_or_else(Error::nothing_to_draw)?;
        let graph = compile::compile(scene, images, render.root, &plan.left_out)?;
        let ambient = scene
            .ambient_lights
            .iter()
            .fold(Vec3::ZERO, |sum, l| sum + Vec3(l.colour) * l.intensity);
        let points = scene.point_lights.iter().map(|l| Light {
            position: l.position.into(),
            power: Vec3(l.colour) * l.intensity,
        });
        let dark = scene.ambient_lights.is_empty() && scene.point_lights.is_empty();
        let region = render.clip.map(|(min, max)| Aabb::new(min, max));
        Ok(Tracer {
            ambient,
            lights: (!dark).then(|| points.collect()),
            background: render.background.into(),
            clip: region.filter(|_| plan.on(Effect::ClipBox)),
            graph,
            plan,
        })
    }

    /// Gives each ray as much memory as this, in bytes; `false` where that will surely not do.
    pub fn confine(&mut self, bytes: u64) -> bool {
        self.graph.room = crowd::Room::of(bytes);
        !self.graph.is_crowded()
    }

    /// The part of (0, to] in which a ray can see anything.
    fn window<R: Precision>(&self, ray: &Ray<R>, to: R) -> Option<(R, R)> {
        match &self.clip {
            None => Some((R::ZERO, to)),
            Some(clip) => {
                let (from, end) =
                    clip.clip(&Beam::exact(&R::coarse(&ray.line)), 0.0, to.to_f64())?;
                Some((R::of(from), R::of(end)))
            }
        }
    }
}
