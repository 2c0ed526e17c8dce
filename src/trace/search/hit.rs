//! Hits: from an event on a ray to all that shading needs to know about the place.

use super::context::{Leaf, Painted};
use super::events::{Kind, State};
use super::query::Search;
use super::spans::{FirstBoundary, first_of_kind};
use super::walk::Walker;
use crate::geometry::array::each;
use crate::geometry::line::Line;
use crate::geometry::vec::Vec3;
use crate::scene::{DEFAULT_COLOUR, Rgb};
use crate::trace::precision::{Doubt, Precision};
use crate::trace::ray::{Left, Ray};
use crate::trace::shapes::Root;
use crate::trace::shapes::support::Passage;
use crate::trace::stats::Work;
use crate::trace::texture::SurfacePoint;

/// A point of a visible surface, in the scene's space.
#[derive(Debug, Clone, Copy)]
pub struct Hit<R = f64> {
    /// Distance from the ray's origin, in units of the ray's direction.
    pub t: R,
    pub point: Vec3<R>,
    /// Unit geometric normal, outwards of the shape.
    pub normal: Vec3<R>,
    /// Unit normal that light is reckoned with; the geometric one unless the shape smooths it.
    pub shading: Vec3<R>,
    /// Linear RGB; the default colour if the surface is not diffuse, since it is not looked up then.
    pub colour: Rgb,
    /// Index into [`Graph::optics`](crate::trace::graph::Graph::optics).
    pub optics: u32,
    /// The refractive indices before and after the surface: indices into
    /// [`Graph::indices`](crate::trace::graph::Graph::indices).
    pub indices: [u32; 2],
    /// Whether the ray is in a solid before and after the surface.
    pub inside: [bool; 2],
    /// Whether the ray goes against the normal.
    pub entering: bool,
    /// Whether the hit is on a sheet that lies in a face of a solid. The face comes next on the ray, in the same place.
    pub in_face: bool,
    /// The number of the surface; see [`Left`].
    pub surface: u64,
    /// The index of the surface's shape; see [`Left`].
    pub primitive: u32,
    /// Bound on the point's distance from the true surface.
    pub skin: R,
    /// How the ray passes the surface that the face is a part of.
    pub passage: Option<Passage>,
}

impl<R: Precision> Hit<R> {
    /// A ray that starts at the hit. `onwards` is whether it goes to the far side of the surface, to which the ray that
    /// has found the hit was heading.
    #[inline]
    pub fn leave(&self, direction: Vec3<R>, onwards: bool) -> Ray<R> {
        let mut ray = Ray::new(self.point, direction);
        let entering = self.entering == onwards;
        ray.left = Some(Left {
            surface: self.surface,
            primitive: self.primitive,
            entering,
            skin: self.skin,
            passage: self.passage.map(|p| p.turned(!onwards)),
        });
        ray.is_outside = !self.inside[usize::from(onwards)];
        ray
    }

    /// The unit normal that light is reckoned with, turned to the side that the ray came from.
    #[inline]
    pub fn facing(&self) -> Vec3<R> {
        if self.entering {
            self.shading
        } else {
            -self.shading
        }
    }

    /// The hit in another kind of number. The skin grows by the distance that rounding may move the point.
    pub fn cast<S: Precision>(&self) -> Hit<S> {
        let (point, normal): (Vec3<S>, Vec3<S>) = (self.point.cast(), self.normal.cast());
        let skin = S::of_parts(self.skin.parts());
        Hit {
            t: S::of_parts(self.t.parts()),
            point,
            normal,
            shading: self.shading.cast(),
            colour: self.colour,
            optics: self.optics,
            indices: self.indices,
            inside: self.inside,
            entering: self.entering,
            in_face: self.in_face,
            surface: self.surface,
            primitive: self.primitive,
            skin: skin + normal.abs().dot(point.abs() * S::gamma(2)),
            passage: self.passage,
        }
    }
}

/// Makes a shading normal in the scene's space a unit vector on the side of the geometric normal. Returns the geometric
/// normal if the shading normal lies in the surface, and so on neither side, or is out of the range of numbers.
///
/// A map that stretches may take the two normals to different sides, so the side is decided in the scene's space.
pub fn beside<R: Precision>(shading: Vec3<R>, normal: Vec3<R>) -> Vec3<R> {
    /// The largest cosine of a normal that lies in the surface and is off because it was transformed.
    const ROUNDED: f64 = 16.0 * f64::EPSILON;
    let shading = shading.unit();
    let cosine = shading.dot(normal);
    if !shading.is_finite() || !shading.any() || cosine.abs() <= R::of(ROUNDED) {
        normal
    } else if cosine > R::ZERO {
        shading
    } else {
        -shading
    }
}

/// The index into the graph's refractive indices in a state; 0 outside of solids.
fn index_in(state: State) -> u32 {
    match state.inside {
        true => state.owner.medium.index,
        false => 0,
    }
}

/// The sizes of the terms of a line's point at t: |oᵢ| + |t dᵢ|.
fn terms<R: Precision>(line: &Line<R>, t: R) -> Vec3<R> {
    line.origin.abs() + (line.direction * t).abs()
}

/// The point of a line at t, if `point`, which was found on the surface, is farther from it than rounding moves the
/// line's point; else `None`.
///
/// A shape moves the point onto its surface in its own space, which removes the rounding error across the surface. A
/// map that stretches may make the remaining error along one axis larger than the rounding error of the line's point.
#[inline]
pub fn strayed<R: Precision>(point: Vec3<R>, line: &Line<R>, t: R) -> Option<Vec3<R>> {
    /// Distance from the line above which a point has strayed, in units of the last place.
    const MAX_STRAY_ULPS: f64 = 4.0;
    // A t near the lower end of the range of numbers is rounded to a multiple of this.
    const SMALLEST_STEP: f64 = f64::from_bits(1);
    let on_line = line.at(t);
    let most = terms(line, t) * (R::of(2.0 * MAX_STRAY_ULPS) * R::ROUNDOFF)
        + line.direction.abs() * R::of(SMALLEST_STEP);
    let off = (point - on_line).abs();
    let strays = (0..3).any(|i| off[i] > most[i]);
    (strays && on_line.is_finite()).then_some(on_line)
}

impl<R: Precision> Walker<'_, R> {
    /// The first point of the scene's surface in (from, to].
    ///
    /// A ray that starts outside of every solid sees the nearest crossing. If that is transparent, or if the ray starts
    /// inside a solid, it matters which media meet there, and spans tell what is a boundary. `clipped` is whether
    /// `from` is where the ray enters the region that is drawn, maybe in the middle of a solid. Without `GLASS` nothing
    /// is transparent.
    pub fn first_hit<const GLASS: bool>(
        &mut self,
        ray: &Ray<R>,
        (from, to): (R, R),
        clipped: bool,
    ) -> Option<Hit<R>> {
        if clipped {
            return self.first_visible(ray, from, to);
        }
        let first = self.nearest(ray, (from, to), Search::First)?;
        let (leaf, root) = (first.place.leaf, first.place.root);
        let optics = &self.graph.optics[self.optics(first.owner) as usize];
        if ray.is_outside && (!GLASS || !Vec3(optics.kt).any()) {
            // A hit is large, so it is changed in place and not copied.
            let mut found = self.resolve(ray, leaf, root, first.owner);
            if let Some(hit) = &mut found {
                hit.inside = [false, self.primitive(leaf).is_solid()];
                return found;
            }
        }
        // The search goes far enough to meet every crossing that cannot be told from this one.
        let near = root.t + first.place.error * R::of(4.0);
        if near < to {
            let found = self.first_visible(ray, from, near);
            if found.is_some() {
                return found;
            }
        }
        self.first_visible(ray, from, to)
    }

    /// The first boundary or sheet among the events in (from, to].
    fn first_visible(&mut self, ray: &Ray<R>, from: R, to: R) -> Option<Hit<R>> {
        let FirstBoundary {
            event,
            states,
            in_face,
        } = self.trace_first(ray, from, to)?;
        let (leaf, root) = (event.place.leaf, event.place.root);
        let mut found = self.resolve(ray, leaf, root, event.owner.leaf);
        if let Some(hit) = &mut found {
            hit.indices = each(states, index_in);
            hit.inside = each(states, |state| state.inside);
            hit.in_face = in_face;
        }
        found
    }

    /// The first boundary in (from, to]; sheets before it are passed over. If the ray first sees a sheet in a face of a
    /// solid, the boundary is that face.
    pub(super) fn first_boundary(&mut self, ray: &Ray<R>, from: R, to: R) -> Option<Hit<R>> {
        let (start, events) = self.trace_spans(ray, from, to);
        let (_, event, states) = first_of_kind(start?, events, |kind| kind == Kind::Boundary)?;
        let mut hit = self.resolve(ray, event.place.leaf, event.place.root, event.owner.leaf)?;
        hit.indices = each(states, index_in);
        hit.inside = each(states, |state| state.inside);
        Some(hit)
    }

    /// The hit at a crossing with the shape `leaf`, with the properties of `owner`; media and sides are left at their
    /// defaults.
    ///
    /// `None` if the place is out of the range of numbers: the ray ends there.
    pub fn resolve(
        &mut self,
        ray: &Ray<R>,
        leaf: Leaf,
        root: Root<R>,
        owner: Leaf,
    ) -> Option<Hit<R>> {
        let line = self.line(leaf);
        let number = self.primitive_number(leaf);
        let primitive = &self.graph.primitives[number as usize];
        let located = primitive.intersect().locate(&line, root);
        let (mut point, mut error, mut normal) = (located.point, located.error, located.normal);
        let shape = primitive.shape();
        let local: Vec3 = located.point.cast();
        let smooth = match self.graph.without.smooth_normals {
            false => shape.shading_normal(local, root.face),
            true => None,
        };
        let mut shading = smooth.map(Vec3::cast);
        self.work.smooth_normal += u64::from(shading.is_some());
        self.climb(leaf, |_, placement| {
            let out = R::out(self.graph, placement);
            let back = R::back(&self.maps, self.graph, placement);
            error = out.point_error(point, error);
            if R::DOUBT == Doubt::Merges {
                // Another solid in the same place may have other maps, and all maps are rounded to doubles.
                let maps = &self.graph.placements[placement as usize];
                error = error + maps.out.point_error(point.cast(), Vec3::ZERO).cast();
            }
            point = out.point(point);
            normal = back.unit_normal(normal);
            shading = shading.map(|n| back.unit_normal(n));
        });
        let normal = normal.unit();
        // The corner of the error box that is farthest along the normal.
        let mut skin = normal.abs().dot(error);
        if let Some(on_line) = strayed(point, &ray.line, root.t) {
            point = on_line;
            skin = self.skin_on_line(ray, leaf, &line, root, normal);
        }
        if !(point.is_finite() && skin.is_finite() && normal.is_finite() && normal.any()) {
            return None;
        }
        let shading = shading.map_or(normal, |n| beside(n, normal));
        let optics = self.optics(owner);
        let colour = match self.graph.optics[optics as usize].kd {
            [0.0, 0.0, 0.0] => DEFAULT_COLOUR,
            _ => self.colour(owner, leaf, point.cast(), local, root.face),
        };
        debug_assert!(root.t.is_finite() && shading.is_finite());
        debug_assert!(colour.iter().all(|x| x.is_finite()));
        Some(Hit {
            t: root.t,
            point,
            normal,
            shading,
            colour,
            optics,
            indices: [0; 2],
            inside: [false; 2],
            entering: normal.dot(ray.line.direction) < R::ZERO,
            in_face: false,
            surface: self.surface(leaf),
            primitive: number,
            skin,
            passage: self.passage(leaf, &line, (root.face, located.point)),
        })
    }

    /// A bound on the distance of the ray's point at a crossing from the true surface: the rounding error of the point,
    /// and the error of its t. `normal` is the surface's unit normal there.
    #[cold]
    fn skin_on_line(
        &self,
        ray: &Ray<R>,
        leaf: Leaf,
        line: &Line<R>,
        root: Root<R>,
        normal: Vec3<R>,
    ) -> R {
        let rounded = terms(&ray.line, root.t) * R::gamma(3);
        let mut off = self.error(leaf, line, root);
        if R::DOUBT == Doubt::Merges {
            off += self.misplaced(leaf, root);
        }
        normal.abs().dot(rounded) + off * normal.dot(ray.line.direction).abs()
    }

    /// Surface coordinates of a crossing of the shape `leaf`; `None` if they are not finite.
    pub fn uv(&self, leaf: Leaf, root: Root<R>) -> Option<[f64; 2]> {
        let primitive = self.primitive(leaf);
        let located = primitive.intersect().locate(&self.line(leaf), root);
        let uv = primitive.shape().uv(located.point.cast(), root.face);
        uv.iter().all(|x| x.is_finite()).then_some(uv)
    }

    /// The colour of a point on a surface, linear RGB. `point` is the point in the scene's space, `local` the point in
    /// the space of the shape `leaf`. A face made by a cut shows no colours of the shape that cuts.
    fn colour(&mut self, owner: Leaf, leaf: Leaf, point: Vec3, local: Vec3, face: u32) -> Rgb {
        let painted = self.texture(owner);
        let place = SurfacePoint {
            shape: self.primitive(leaf).shape(),
            point: local,
            face,
        };
        let mut work = Work::default();
        let colour = match painted {
            Some(painted) => {
                let in_space = || self.in_space(point, painted);
                (self.graph).painted(painted.texture, &place, in_space, &mut work)
            }
            None if owner == leaf => self.graph.unpainted(&place, &mut work),
            None => DEFAULT_COLOUR,
        };
        self.work += work;
        colour
    }

    /// A point of the scene in the space that a texture is painted in.
    fn in_space(&self, point: Vec3, painted: Painted) -> Vec3 {
        let mut down = Vec::new();
        let mut context = painted.context;
        while context != 0 {
            let c = &self.contexts[context as usize];
            down.push(self.part(c.part).placement);
            context = c.parent;
        }
        let placements = down.into_iter().rev().chain([painted.placement]);
        placements.fold(point, |p, m| {
            self.graph.placements[m as usize].back.point(p)
        })
    }
}

#[cfg(test)]
mod tests;
