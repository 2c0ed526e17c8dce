//! The kinds of numbers that scenes are traced in, and how each treats decisions that rounding makes doubtful.

use super::graph::Graph;
use crate::geometry::affine::Affine;
use crate::geometry::dd::Dd;
use crate::geometry::line::Traced;
use std::cell::RefCell;
use std::collections::HashMap;

/// The treatment of a decision that is closer than the rounding errors behind it: which of two crossings comes first,
/// whether there is one at all, on which side of a surface a ray starts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Doubt {
    /// The decision stands as it was rounded.
    Stands,
    /// The ray is traced again in double-double.
    GoesOn,
    /// Crossings that cannot be told apart count as one place.
    Merges,
}

/// A number that scenes are traced in.
pub trait Precision: Traced {
    const DOUBT: Doubt;

    /// The last share of the way to a lamp, on which nothing throws a shadow: a lamp on a surface is not in the shadow
    /// of that surface. Doubles, and the finer numbers that check them, have the same share. It is far above the
    /// rounding errors of doubles and far below what a picture shows.
    const AT_LAMP: f64 = 1.0 / (1u64 << 27) as f64;

    /// The inverse maps of placements that a walker has met, in the walker's precision.
    type Maps: Default;

    /// The map of a placement from the space below it into the space above.
    fn out(graph: &Graph, placement: u32) -> Affine<Self> {
        Affine::new(&graph.matrices[placement as usize])
    }

    /// The map of a placement from the space above it into the space below.
    fn back(maps: &Self::Maps, graph: &Graph, placement: u32) -> Affine<Self>;
}

impl Precision for f64 {
    const DOUBT: Doubt = Doubt::GoesOn;
    type Maps = ();

    #[inline]
    fn out(graph: &Graph, placement: u32) -> Affine {
        graph.placements[placement as usize].out
    }

    #[inline]
    fn back(_: &(), graph: &Graph, placement: u32) -> Affine {
        graph.placements[placement as usize].back
    }
}

impl Precision for f32 {
    const DOUBT: Doubt = Doubt::Stands;
    // Crossings are known to a few units of 2⁻²⁴.
    const AT_LAMP: f64 = 1.0 / (1u64 << 16) as f64;
    type Maps = ();

    fn back(_: &(), graph: &Graph, placement: u32) -> Affine<f32> {
        graph.placements[placement as usize].back.cast()
    }
}

impl Precision for Dd {
    const DOUBT: Doubt = Doubt::Merges;
    type Maps = RefCell<HashMap<u32, Affine<Dd>>>;

    /// The inverse map is computed when a placement is first met. Few rays need it, and the inverses of all placements
    /// would take twice the memory.
    fn back(maps: &Self::Maps, graph: &Graph, placement: u32) -> Affine<Dd> {
        *maps.borrow_mut().entry(placement).or_insert_with(|| {
            let out = Affine::new(&graph.matrices[placement as usize]);
            let coarse = || graph.placements[placement as usize].back.cast();
            out.inverse().unwrap_or_else(coarse)
        })
    }
}
