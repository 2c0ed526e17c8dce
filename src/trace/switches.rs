//! Switches that take parts of a tracer out, or replace them, to measure their costs and benefits.

use super::shapes::Roots;
use crate::geometry::line::Line;
use std::fmt::Debug;

/// Effects that are taken out of a tracer, although its scene calls for them. For some effects the shading code is
/// compiled twice, and the version without the effect is chosen; the others are tested at run time.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Without {
    /// Whether shadows are left out: every light is seen from everywhere.
    pub shadows: bool,
    /// Whether transparent shadows are left out: every object in the way of a light blocks it.
    pub transparent_shadows: bool,
    /// Whether mirrors and total reflection are left out.
    pub reflection: bool,
    /// Whether light through surfaces is left out.
    pub refraction: bool,
    /// Whether dispersion is left out: all channels go the way of the first one.
    pub dispersion: bool,
    /// Whether textures are left out: patterns, pictures and colours along profiles are white.
    pub textures: bool,
    /// Whether smooth normals are left out: shading uses the geometric normal.
    pub smooth_normals: bool,
    /// Whether the quick kernel is left out: see [`kernel`](super::kernel).
    pub kernel: bool,
}

/// A solver that finds crossings in place of the shapes' own code, in doubles only.
pub trait Solver: Debug + Send + Sync {
    /// Appends all crossings of a line with the shape of this number in
    /// [`Graph::primitives`](super::graph::Graph::primitives), in the shape's space and ascending, to the cleared
    /// `roots`. Returns `false` if the shape's own code is to find them.
    fn crossings(&self, primitive: u32, line: &Line, roots: &mut Roots) -> bool;
}
