//! From an event on a ray to everything shading needs to know about the place.

use super::nearest::Search;
use super::ray::{Left, Ray};
use super::shapes::Root;
use super::spans::{Event, Kind, State};
use super::vec::Vec3;
use super::walk::{Leaf, Walker};
use crate::scene::{DEFAULT_COLOUR, Optics, Rgb, Texture};

/// A point of a visible surface, in the scene's space.
#[derive(Debug, Clone, Copy)]
pub struct Hit {
    /// In units of the ray's direction.
    pub t: f64,
    pub point: Vec3,
    /// Unit geometric normal, outwards of the shape.
    pub normal: Vec3,
    /// Unit normal that light is reckoned with; the geometric one unless the shape smooths it.
    pub shading: Vec3,
    /// Linear RGB.
    pub colour: Rgb,
    pub optics: Optics,
    /// Refractive index per channel before and behind the surface.
    pub indices: [Rgb; 2],
    /// Whether the ray is in a solid before and behind the surface.
    pub inside: [bool; 2],
    /// Whether the ray goes against the normal.
    pub entering: bool,
    /// Number of the surface; see [`Left`].
    pub surface: u64,
    /// Bound on the point's distance from the true surface.
    pub skin: f64,
}

impl Hit {
    /// A ray from here. `onwards`: to the side the ray that came here was heading for.
    pub fn leave(&self, direction: Vec3, onwards: bool) -> Ray {
        let mut ray = Ray::new(self.point, direction);
        ray.left = Some(Left {
            surface: self.surface,
            entering: self.entering == onwards,
            skin: self.skin,
        });
        ray.outside = !self.inside[onwards as usize];
        ray
    }

    /// The unit normal that light is reckoned with, on the side the ray came from.
    pub fn facing(&self) -> Vec3 {
        if self.entering {
            self.shading
        } else {
            -self.shading
        }
    }
}

impl Walker<'_> {
    /// The first point of the scene's surface in (from, to].
    ///
    /// A ray that is outside of everything sees the nearest crossing, whatever it is. If that turns
    /// out to be transparent, or if the ray starts inside a solid, spans say what is a boundary and
    /// which media meet there. `clipped`: `from` is where the ray enters the region that is drawn,
    /// maybe in the middle of a solid. Without `GLASS` nothing is transparent.
    pub fn first_hit<const GLASS: bool>(
        &mut self,
        ray: &Ray,
        from: f64,
        to: f64,
        clipped: bool,
    ) -> Option<Hit> {
        if clipped {
            return self.first_visible(ray, from, to);
        }
        let first = self.nearest(ray, from, to, Search::First)?;
        let hit = self.resolve(ray, first.leaf, first.root, first.owner);
        if ray.outside && (!GLASS || hit.optics.kt == [0.0; 3]) {
            let inside = self.primitive(first.leaf).shape().is_solid();
            return Some(Hit {
                inside: [false, inside],
                ..hit
            });
        }
        // Far enough to see what else cannot be told from this crossing.
        let reach = hit.skin / hit.normal.dot(ray.line.direction).abs();
        let near = first.root.t + reach;
        if near < to {
            let found = self.first_visible(ray, from, near);
            if found.is_some() {
                return found;
            }
        }
        self.first_visible(ray, from, to)
    }

    /// The first boundary or sheet among the events in (from, to].
    fn first_visible(&mut self, ray: &Ray, from: f64, to: f64) -> Option<Hit> {
        let (start, events) = self.trace_spans(ray, from, to);
        let found = events.iter().position(|e| e.kind != Kind::Silent)?;
        let event = events[found];
        let before = match found {
            0 => start,
            _ => Some(events[found - 1].state),
        };
        let rest: Vec<Event> = events[found + 1..].to_vec();
        let mut hit = self.resolve(ray, event.leaf, event.root, event.owner.leaf);
        let (shown, after) = settle(event, &rest, &hit, ray);
        if shown.leaf != event.leaf {
            hit = self.resolve(ray, shown.leaf, shown.root, shown.owner.leaf);
        }
        let index = |state: Option<State>| match state {
            Some(s) if s.inside => self.graph.indices[s.owner.index as usize],
            _ => self.graph.indices[0],
        };
        Some(Hit {
            indices: [index(before), index(Some(after))],
            inside: [before.is_some_and(|s| s.inside), after.inside],
            ..hit
        })
    }

    /// The place of a crossing of the shape `leaf` with the properties of `owner`; media and sides
    /// are left at their defaults.
    pub fn resolve(&self, ray: &Ray, leaf: Leaf, root: Root, owner: Leaf) -> Hit {
        let part = self.part(leaf.part);
        let line = self.placed(&self.contexts[leaf.context as usize].line, part);
        let primitive = self.primitive(leaf);
        let located = primitive.intersect().locate(&line, root);
        let (mut point, mut error, mut normal) = (located.point, located.error, located.normal);
        let shape = primitive.shape();
        let mut shading = shape.shading_normal(located.point, root.face);
        self.climb(leaf, |placement| {
            error = placement.out.point_error(point, error);
            point = placement.out.point(point);
            normal = placement.back.transposed(normal).unit();
            shading = shading.map(|n| placement.back.transposed(n).unit());
        });
        let normal = normal.unit();
        let optics = self.graph.optics[self.optics(owner) as usize];
        Hit {
            t: root.t,
            point,
            normal,
            shading: shading.map_or(normal, Vec3::unit),
            colour: self.colour(owner, leaf, point, located.point, root.face),
            optics,
            indices: [self.graph.indices[0]; 2],
            inside: [false; 2],
            entering: normal.dot(ray.line.direction) < 0.0,
            surface: self.surface(leaf),
            // The corner of the error box that is farthest along the normal.
            skin: normal.abs().dot(error),
        }
    }

    /// Surface coordinates of a crossing of the shape `leaf`.
    pub fn uv(&self, leaf: Leaf, root: Root) -> [f64; 2] {
        let line = &self.contexts[leaf.context as usize].line;
        let primitive = self.primitive(leaf);
        let located = primitive
            .intersect()
            .locate(&self.placed(line, self.part(leaf.part)), root);
        primitive.shape().uv(located.point, root.face)
    }

    /// The colour of a point, in the scene's space and in that of the shape whose surface it is on.
    /// A face made by a cut shows no colours of the tool.
    fn colour(&self, owner: Leaf, leaf: Leaf, point: Vec3, local: Vec3, face: u32) -> Rgb {
        let shape = self.primitive(leaf).shape();
        let Some(painted) = self.texture(owner) else {
            let own = (owner == leaf).then(|| shape.colour(local, face));
            return own.flatten().unwrap_or(DEFAULT_COLOUR);
        };
        let odd =
            |cells: &[f64]| cells.iter().map(|x| x.floor()).sum::<f64>().rem_euclid(2.0) >= 1.0;
        match &self.graph.textures[painted.texture as usize] {
            Texture::Colour(c) => *c,
            Texture::Checkerboard { n, m, colours } => {
                let uv = shape.uv(local, face);
                colours[odd(&[uv[0] * *n as f64, uv[1] * *m as f64]) as usize]
            }
            Texture::Solid { colours, size } => {
                let mut down = Vec::new();
                let mut context = painted.context;
                while context != 0 {
                    let c = &self.contexts[context as usize];
                    down.push(self.part(c.part).placement);
                    context = c.parent;
                }
                let placements = down.into_iter().rev().chain([painted.placement]);
                let p = placements.fold(point, |p, m| {
                    self.graph.placements[m as usize].back.point(p)
                });
                colours[odd(&(p / *size).0) as usize]
            }
            Texture::Image { .. } => match &self.graph.bitmaps[painted.texture as usize] {
                Some(bitmap) => bitmap.colour(shape.uv(local, face)),
                None => DEFAULT_COLOUR,
            },
        }
    }
}

/// Looks at the boundaries right behind a boundary: a layer thinner than the error of the hit,
/// measured along its normal, is not there. Returns the last of them that light sees, and the
/// state behind them all. Faces that touch are thus one face between the two outer media, even if
/// their positions were rounded apart.
fn settle(event: Event, rest: &[Event], hit: &Hit, ray: &Ray) -> (Event, State) {
    if event.kind == Kind::Sheet {
        return (event, event.state);
    }
    let steep = hit.normal.dot(ray.line.direction).abs();
    let close = |e: &&Event| (e.root.t - event.root.t) * steep <= hit.skin;
    let (mut shown, mut after) = (event, event.state);
    for next in rest.iter().take_while(close) {
        if next.kind == Kind::Sheet {
            break;
        }
        if next.state.inside && next.kind == Kind::Boundary {
            shown = *next;
        }
        after = next.state;
    }
    (shown, after)
}
