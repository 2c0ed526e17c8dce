//! The reference ray tracer.
//!
//! A [`Scene`] is compiled once into a [`graph`] in which shared parts stay shared; a [`Tracer`]
//! holds that and everything else a picture needs, and knows what cannot be drawn before the first
//! ray. In the order in which a pixel comes about: [`camera`] and [`sampling`] make rays,
//! [`nearest`] and [`spans`] find what they meet in the graph ([`walk`], [`bvh`], [`shapes`],
//! [`join`]), [`hit`] says what is there, [`shade`] adds up the light, [`film`] keeps it. [`probe`]
//! and [`membership`] answer questions about single rays and points.

pub mod adaptive;
pub mod affine;
pub mod bounds;
pub mod bvh;
pub mod camera;
mod compile;
pub mod costs;
pub mod dd;
mod effects;
mod exponent;
pub mod film;
mod finish;
pub mod graph;
pub mod hit;
pub mod image;
mod intern;
mod join;
pub mod membership;
pub mod nearest;
pub mod number;
mod picture;
mod probe;
mod quartic;
pub mod ray;
pub mod sampling;
pub mod shade;
pub mod shapes;
pub mod spans;
pub mod stats;
pub mod vec;
pub mod walk;

pub use costs::CostMap;
pub use film::Film;
pub use hit::Hit;
pub use image::Images;
pub use membership::{Membership, Unanswered, members};
pub use picture::{Crop, Picture, Settings, selected_camera};
pub use probe::{Crossing, Probe};
pub use ray::Ray;

use crate::diagnostics::Span;
use crate::scene::Scene;
use bounds::Bounds;
use graph::{Graph, Operation, Target};
use shade::Light;
use spans::State;
use std::fmt;
use vec::Vec3;
use walk::Walker;

/// Why a scene cannot be drawn.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Unsupported {
    /// What it is that cannot be drawn, with its article.
    pub what: String,
    /// The record that asks for it.
    pub span: Span,
    /// The entity of that record.
    pub id: u32,
}

impl fmt::Display for Unsupported {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} cannot be drawn yet (object {})", self.what, self.id)
    }
}

impl std::error::Error for Unsupported {}

/// A scene made ready for tracing.
pub struct Tracer {
    pub graph: Graph,
    ambient: Vec3,
    /// `None`: there is no light at all, and the camera brings one.
    lights: Option<Vec<Light>>,
    background: Vec3,
    /// The region that is drawn, where it cuts anything.
    clip: Option<Bounds>,
    /// Some part lets light through.
    transparent: bool,
    /// Nothing can be in the way of anything.
    lone_convex: bool,
    effects: Vec<&'static str>,
}

impl Tracer {
    /// Compiles what the render record names.
    ///
    /// # Errors
    ///
    /// Names the first shape or texture found that cannot be drawn, or the missing render record.
    /// Image textures cannot: their pictures come with [`Tracer::with_images`].
    pub fn new(scene: &Scene) -> Result<Tracer, Unsupported> {
        Tracer::with_images(scene, &Images::default())
    }

    /// Compiles what the render record names, with its pictures.
    ///
    /// # Errors
    ///
    /// As [`Tracer::new`], but image textures only where their picture is missing.
    pub fn with_images(scene: &Scene, images: &Images) -> Result<Tracer, Unsupported> {
        let Some(render) = &scene.render else {
            return Err(Unsupported {
                what: "a scene without a render record".into(),
                span: Span::default(),
                id: 0,
            });
        };
        let graph = compile::compile(scene, images, render.root)?;
        let ambient = scene
            .ambient_lights
            .iter()
            .fold(Vec3::ZERO, |sum, l| sum + Vec3(l.colour) * l.intensity);
        let points = scene.point_lights.iter().map(|l| Light {
            position: l.position.into(),
            power: Vec3(l.colour) * l.intensity,
        });
        let dark = scene.ambient_lights.is_empty() && scene.point_lights.is_empty();
        let region = render
            .clip
            .map(|(min, max)| Bounds::new(min.into(), max.into()));
        let transparent = effects::coats(&graph).any(|c| c.0.kt != [0.0; 3]);
        let mut tracer = Tracer {
            ambient,
            lights: (!dark).then(|| points.collect()),
            background: render.background.into(),
            clip: region.filter(|c| !c.holds(&graph.root().bounds)),
            transparent,
            lone_convex: graph.lone_convex(),
            graph,
            effects: Vec::new(),
        };
        tracer.effects = tracer.list_effects();
        Ok(tracer)
    }

    /// Names of the effects the scene calls for, in the order of `zpg plan`.
    pub fn effects(&self) -> &[&'static str] {
        &self.effects
    }

    /// Scratch for one thread.
    pub fn walker(&self) -> Walker<'_> {
        Walker::new(&self.graph)
    }

    /// The first visible point on a ray.
    pub fn hit(&self, walker: &mut Walker, ray: &Ray) -> Option<Hit> {
        let (from, to) = self.window(ray, f64::INFINITY)?;
        walker.first_hit(ray, from, to, self.clip.is_some())
    }

    /// Whether a point is inside some solid of the scene.
    pub fn holds(&self, walker: &mut Walker, point: Vec3) -> bool {
        let ray = Ray::new(point, Vec3::new(0.0, 0.0, 1.0));
        let (start, _) = walker.trace_spans(&ray, 0.0, 0.0);
        start.is_some_and(|s: State| s.inside)
    }

    /// The part of (0, to] in which a ray can see anything.
    fn window(&self, ray: &Ray, to: f64) -> Option<(f64, f64)> {
        match &self.clip {
            None => Some((0.0, to)),
            Some(clip) => clip.clip(&ray.line, 0.0, to),
        }
    }
}

impl Graph {
    fn shapes(&self) -> impl Iterator<Item = &shapes::Primitive> {
        self.parts.iter().filter_map(|p| match p.target {
            Target::Shape(p) => self.primitives.get(p as usize),
            Target::Object(_) => None,
        })
    }

    fn has_intersections(&self) -> bool {
        let cut = |o: &graph::Object| matches!(o.operation, Operation::Intersection { .. });
        self.objects.iter().any(cut) || self.parts.iter().any(|p| p.inverted)
    }
}
