//! What is on a ray, for those who ask about geometry.

use super::Tracer;
use super::hit::Hit;
use super::ray::Ray;
use super::spans::{Event, Kind};
use super::vec::Vec3;
use super::walk::Walker;

/// A crossing of a boundary or a surface.
#[derive(Debug, Clone, Copy)]
pub struct Crossing {
    pub hit: Hit,
    /// Unit geometric normal: outwards of the solid whose boundary is crossed, also where a cut
    /// made it; for a surface that of its shape.
    pub normal: Vec3,
    /// Surface coordinates of the shape.
    pub uv: [f64; 2],
    /// Whether the ray goes against the normal; `None` for surfaces without inside.
    pub entering: Option<bool>,
    /// ID of the entity whose record made the surface.
    pub shape: u32,
    /// ID of the entity whose properties apply.
    pub object: u32,
}

/// Everything on a ray.
#[derive(Debug, Clone)]
pub struct Probe {
    /// Whether the ray starts in a solid: the state just behind its origin, whatever region is
    /// drawn.
    pub inside_at_origin: bool,
    pub crossings: Vec<Crossing>,
}

impl Tracer {
    /// What a ray meets in the region that is drawn: all crossings with t > 0, ascending, as if
    /// every surface let it through. The region itself is no surface.
    pub fn probe(&self, walker: &mut Walker, ray: &Ray) -> Probe {
        if self.clip.is_none() {
            return probe_between(walker, ray, 0.0, f64::INFINITY);
        }
        let (start, _) = walker.trace_spans(ray, 0.0, 0.0);
        let inside_at_origin = start.is_some_and(|s| s.inside);
        let crossings = match self.window(ray, f64::INFINITY) {
            Some((from, to)) => probe_between(walker, ray, from, to).crossings,
            None => Vec::new(),
        };
        Probe {
            inside_at_origin,
            crossings,
        }
    }

    /// All crossings on a ray with t > 0, ascending; the region that is drawn does not apply.
    pub fn crossings(&self, walker: &mut Walker, ray: &Ray) -> Vec<Crossing> {
        probe_between(walker, ray, 0.0, f64::INFINITY).crossings
    }
}

/// The state at t = `from` and the crossings in (from, to].
fn probe_between(walker: &mut Walker, ray: &Ray, from: f64, to: f64) -> Probe {
    let (start, events) = walker.trace_spans(ray, from, to);
    let events: Vec<Event> = events.to_vec();
    let inside_at_origin = start.is_some_and(|s| s.inside);
    let mut before = inside_at_origin;
    let mut crossings = Vec::new();
    for event in events {
        if event.kind != Kind::Silent {
            crossings.push(crossing(walker, ray, &event, before));
        }
        before = event.state.inside;
    }
    Probe {
        inside_at_origin,
        crossings,
    }
}

/// A visible event; `before`: whether the ray was inside.
fn crossing(walker: &Walker, ray: &Ray, event: &Event, before: bool) -> Crossing {
    let hit = walker.resolve(ray, event.leaf, event.root, event.owner.leaf);
    let solid = event.kind == Kind::Boundary;
    let turned = solid && walker.is_turned(event.leaf);
    let entering = if before != event.state.inside {
        event.state.inside
    } else {
        // From one medium into another: into the one whose surface it is, or out of it.
        hit.entering != turned
    };
    Crossing {
        hit,
        normal: if turned { -hit.normal } else { hit.normal },
        uv: walker.uv(event.leaf, event.root),
        entering: solid.then_some(entering),
        shape: walker.shape_id(event.leaf),
        object: walker.object_id(event.owner.leaf),
    }
}
