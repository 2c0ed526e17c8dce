//! Which effects a scene calls for.

use super::Tracer;
use super::graph::{Graph, Part};
use crate::scene::{Optics, Rgb, Texture};

/// Optics and refractive index of every paint in the graph, the defaults among them.
///
/// Each aspect on its own: which optics meet which index on a part is decided by the way down to
/// it, so a paint that is overridden everywhere is listed too.
pub fn coats(graph: &Graph) -> impl Iterator<Item = (&Optics, &Rgb)> {
    graph.paints.iter().map(|coat| {
        (
            &graph.optics[coat.optics.unwrap_or(0) as usize],
            &graph.indices[coat.index.unwrap_or(0) as usize],
        )
    })
}

impl Tracer {
    pub(super) fn list_effects(&self) -> Vec<&'static str> {
        let graph = &self.graph;
        let any = |f: fn(&Optics) -> Rgb| coats(graph).any(|c| f(c.0) != [0.0; 3]);
        let diffuse_surface = any(|o| o.kd);
        let lit = self
            .lights
            .as_ref()
            .is_none_or(|lights| lights.iter().any(|l| l.power.any()));
        let diffuse = diffuse_surface && lit;
        let shadows = diffuse && !self.lone_convex;
        let uneven = graph.indices.iter().any(|i| i[0] != i[1] || i[1] != i[2]);
        let textured = |f: fn(&Texture) -> bool| graph.textures.iter().any(f);
        let unbounded = |p: &Part| p.inverted;
        [
            ("ambient", diffuse_surface && self.ambient.any()),
            ("diffuse", diffuse),
            ("shadows", shadows),
            ("transparent-shadows", shadows && self.transparent),
            ("reflection", any(|o| o.ks)),
            ("refraction", self.transparent),
            ("dispersion", self.transparent && uneven),
            (
                "image-texture",
                textured(|t| matches!(t, Texture::Image { .. })),
            ),
            (
                "solid-texture",
                textured(|t| matches!(t, Texture::Solid { .. })),
            ),
            (
                "checkerboard",
                textured(|t| matches!(t, Texture::Checkerboard { .. })),
            ),
            ("csg", graph.has_intersections()),
            (
                "unbounded",
                graph.parts.iter().any(unbounded)
                    || graph.shapes().any(|s| !s.shape().bounds().is_finite()),
            ),
            ("clip-box", self.clip.is_some()),
        ]
        .into_iter()
        .filter_map(|(name, on)| on.then_some(name))
        .collect()
    }
}
