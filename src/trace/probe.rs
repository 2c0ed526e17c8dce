//! The crossings on a ray, for questions about geometry.

#![warn(missing_docs)]

use super::precision::Precision;
use super::ray::Ray;
use super::search::events::{Event, Kind};
use super::search::hit::Hit;
use super::search::walk::Walker;
use super::tracer::Tracer;
use crate::geometry::vec::Vec3;

/// A crossing of a boundary or a surface.
#[derive(Debug, Clone, Copy)]
pub struct Crossing<R = f64> {
    /// The place of the crossing.
    pub hit: Hit<R>,
    /// Unit geometric normal. It points out of the solid whose boundary is crossed, also where a cut made the boundary.
    /// For a surface without inside it is the normal of the shape.
    pub normal: Vec3<R>,
    /// Surface coordinates of the shape.
    pub uv: [f64; 2],
    /// Whether the ray goes against the normal, into the solid; `None` for surfaces without inside.
    pub entering: Option<bool>,
    /// ID of the entity whose record made the surface.
    pub shape: u32,
    /// ID of the entity whose properties apply.
    pub object: u32,
}

/// All crossings on a ray, and the state at its start.
#[derive(Debug, Clone)]
pub struct Probe<R = f64> {
    /// Whether the ray starts in a solid, just after its origin. The region that is drawn does not matter.
    pub inside_at_origin: bool,
    /// The crossings, ascending in t.
    pub crossings: Vec<Crossing<R>>,
}

impl<R: Precision> Probe<R> {
    /// The probe in another kind of number, rounded.
    pub fn cast<S: Precision>(&self) -> Probe<S> {
        let cast = |c: &Crossing<R>| Crossing {
            hit: c.hit.cast(),
            normal: c.normal.cast(),
            uv: c.uv,
            entering: c.entering,
            shape: c.shape,
            object: c.object,
        };
        Probe {
            inside_at_origin: self.inside_at_origin,
            crossings: self.crossings.iter().map(cast).collect(),
        }
    }
}

impl<R: Precision> Probe<R> {
    /// Combines the probes of two rays that run side by side, closer than doubles can tell: the result is inside where
    /// both are. Stretches that are no longer than `least`, in t, are left out.
    pub(super) fn common(self, other: Probe<R>, least: R) -> Probe<R> {
        let mut inside = [self.inside_at_origin, other.inside_at_origin];
        let mut rest = [self.crossings, other.crossings].map(|c| c.into_iter().peekable());
        let mut common = Probe {
            inside_at_origin: inside == [true; 2],
            crossings: Vec::new(),
        };
        // Crossings that doubles cannot tell apart are in one place.
        let apart = |a: &Crossing<R>, b: &Crossing<R>| {
            let (s, t) = (a.hit.t, b.hit.t);
            (s - t).abs() > R::of(4.0 * f64::EPSILON) * s.abs().max(t.abs())
        };
        loop {
            let [a, b] = &mut rest;
            let both = match (a.peek(), b.peek()) {
                (None, None) => break,
                (Some(a), Some(b)) => !apart(a, b),
                _ => false,
            };
            let first = match (a.peek(), b.peek()) {
                (Some(a), Some(b)) => usize::from(b.hit.t < a.hit.t),
                (None, _) => 1,
                _ => 0,
            };
            let before = inside == [true; 2];
            let mut found = None;
            for i in (0..2).filter(|&i| both || i == first) {
                let crossing = rest[i].next();
                if let Some(crossing) = &crossing {
                    inside[i] = crossing.hit.inside[1];
                }
                found = found.or(crossing);
            }
            let after = inside == [true; 2];
            let Some(crossing) = found else { break };
            // A place where the common state changes is a crossing. A sheet, or a boundary between two media, is one if
            // both rays cross it.
            if before != after {
                let entering = Some(after);
                // A stretch that begins and ends in one place is a gap between surfaces that meet there, and is left
                // out.
                let ends = |last: &mut Crossing<R>| {
                    let short = crossing.hit.t - last.hit.t <= least;
                    last.entering == Some(before) && (short || !apart(last, &crossing))
                };
                if common.crossings.pop_if(ends).is_some() {
                    continue;
                }
                common.crossings.push(Crossing {
                    entering,
                    ..crossing
                });
            } else if both && (crossing.entering.is_none() || before) {
                common.crossings.push(crossing);
            }
        }
        common
    }
}

impl Tracer {
    /// The crossings of a ray in the region that is drawn: all with t > 0, ascending, as if every surface let the ray
    /// through. The sides of the region are no surfaces. `walker` answers alone: it does not pass doubtful decisions
    /// on.
    pub(super) fn probe_with<R: Precision>(
        &self,
        walker: &mut Walker<R>,
        ray: &Ray<R>,
    ) -> Probe<R> {
        if self.clip.is_none() {
            return self.crossings_with(walker, ray);
        }
        let (start, _) = walker.trace_spans(ray, R::ZERO, R::ZERO);
        let inside_at_origin = start.is_some_and(|s| s.inside);
        let crossings = match self.window(ray, R::INFINITY) {
            Some((from, to)) => probe_between(walker, ray, from, to).crossings,
            None => Vec::new(),
        };
        Probe {
            inside_at_origin,
            crossings,
        }
    }

    /// All crossings on a ray with t > 0, ascending; the region that is drawn does not apply.
    pub(super) fn crossings_with<R: Precision>(
        &self,
        walker: &mut Walker<R>,
        ray: &Ray<R>,
    ) -> Probe<R> {
        probe_between(walker, ray, R::ZERO, R::INFINITY)
    }
}

/// The state at t = `from` and the crossings in (from, to].
fn probe_between<R: Precision>(walker: &mut Walker<R>, ray: &Ray<R>, from: R, to: R) -> Probe<R> {
    let (start, events) = walker.trace_spans(ray, from, to);
    let events: Vec<Event<R>> = events.to_vec();
    let inside_at_origin = start.is_some_and(|s| s.inside);
    let mut before = inside_at_origin;
    let mut crossings = Vec::new();
    for event in events {
        if event.kind != Kind::Silent {
            let Some(crossing) = crossing(walker, ray, &event, before) else {
                // This place is out of the range of numbers, and the ray ends here.
                break;
            };
            crossings.push(crossing);
        }
        before = event.state.inside;
    }
    Probe {
        inside_at_origin,
        crossings,
    }
}

/// The crossing at a visible event; `None` if its place is out of the range of numbers. `before` is whether the ray was
/// in a solid before the event.
fn crossing<R: Precision>(
    walker: &mut Walker<R>,
    ray: &Ray<R>,
    event: &Event<R>,
    before: bool,
) -> Option<Crossing<R>> {
    let (leaf, root) = (event.place.leaf, event.place.root);
    let hit = walker.resolve(ray, leaf, root, event.owner.leaf)?;
    let uv = walker.uv(leaf, root)?;
    let solid = event.kind == Kind::Boundary;
    let turned = solid && walker.is_turned(leaf);
    let entering = if before != event.state.inside {
        event.state.inside
    } else {
        // The ray goes from one medium into another: into the solid that the surface belongs to, or out of it.
        hit.entering != turned
    };
    Some(Crossing {
        hit: Hit {
            inside: [before, event.state.inside],
            ..hit
        },
        normal: if turned { -hit.normal } else { hit.normal },
        uv,
        entering: solid.then_some(entering),
        shape: walker.shape_id(leaf),
        object: walker.object_id(event.owner.leaf),
    })
}
