//! Walking the graph along one ray: the spaces entered on the way, and where shapes are crossed.

use super::context::{Context, Leaf, Painted};
use super::events::Spans;
use super::query::{Along, PendingNode, QueryStatus, Search};
use super::query::{Scale, Start};
use crate::geometry::line::Line;
use crate::geometry::vec::Vec3;
use crate::geometry::wide_bvh::Beam;
use crate::trace::graph::outermost;
use crate::trace::graph::{Coat, Graph, Operation, Part, Target};
use crate::trace::memory_limit::GROWTH_FACTOR;
use crate::trace::precision::{Doubt, Precision};
use crate::trace::ray::Ray;
use crate::trace::shapes::quick_reject::Pass;
use crate::trace::shapes::{Primitive, Roots};
use crate::trace::stats::{Intersections, Work};

/// Walks the graph along rays: the buffers of one thread, and the counts of its work.
pub struct Walker<'g, R: Precision = f64> {
    pub graph: &'g Graph,
    pub contexts: Vec<Context<R>>,
    pub roots: Roots<R>,
    /// The sizes of the numbers of the last shape that was met.
    pub(in crate::trace) scale: Scale<R>,
    /// The ray in the space of the last shape that was met.
    pub(in crate::trace) line: Line<R>,
    /// The last shape that was met, if the present ray has met it.
    met: Option<Leaf>,
    pub(in crate::trace) entries: Vec<PendingNode>,
    pub(in crate::trace) nodes: Vec<u32>,
    pub(in crate::trace) search: Search,
    pub(in crate::trace) spans: Spans<R>,
    pub counts: Intersections,
    /// The work between a ray and its hit.
    pub(in crate::trace) work: Work,
    pub(in crate::trace) maps: R::Maps,
    /// The roots that another solver has found.
    solved: Roots,
    pub(in crate::trace) status: QueryStatus<R>,
    /// The start of the ray on the surface that it has left, if that is known more exactly than the origin of the ray.
    pub(in crate::trace) start: Option<Start<R>>,
}

/// The range of t of a whole line.
const EVERYWHERE: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];

/// Mixes a number into a key (the finaliser of splitmix64; Steele, Lea and Flood, 2014).
fn mix(key: u64, value: u64) -> u64 {
    let mut z = (key ^ value).wrapping_add(0x9e37_79b9_7f4a_7c15);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

/// The key of the space below a placement, from the key of the space above. Placement 0, which moves nothing, changes
/// nothing. The key of the scene's space is 0.
pub fn placed_key(key: u64, placement: u32) -> u64 {
    if placement == 0 {
        key
    } else {
        mix(key, placement as u64)
    }
}

/// A number for the surface of a shape in the space that has a key.
pub fn surface_key(key: u64, primitive: u32) -> u64 {
    // The bits of the number are inverted, so that a shape is never mixed in like a placement.
    mix(key, !(primitive as u64))
}

/// Whether a line is inside of a shape in whose space it is out of the range of numbers, so that it crosses nothing. A
/// line whose direction has become 0 stays where it starts. A line whose own numbers are not finite counts as outside.
#[cold]
fn lost_inside<R: Precision>(shape: &Primitive, line: &Line<R>) -> bool {
    if line.direction.any() || !line.direction.is_finite() || !line.origin.is_finite() {
        return false;
    }
    shape.shape().holds(line.origin.cast())
}

impl<'g, R: Precision> Walker<'g, R> {
    pub fn new(graph: &'g Graph) -> Walker<'g, R> {
        Walker {
            graph,
            contexts: Vec::new(),
            roots: Roots::default(),
            scale: Scale::default(),
            line: Line::new(Vec3::ZERO, Vec3::ONE),
            met: None,
            entries: Vec::new(),
            nodes: Vec::new(),
            search: Search::First,
            spans: Spans::default(),
            counts: Intersections::default(),
            work: Work::default(),
            maps: R::Maps::default(),
            solved: Roots::default(),
            status: QueryStatus::default(),
            start: None,
        }
    }

    /// Forgets the last ray and begins with a new one. Context 0 is the context of the root.
    pub fn begin(&mut self, ray: &Ray<R>) {
        self.met = None;
        self.contexts.clear();
        self.contexts.push(Context {
            object: self.graph.root,
            line: ray.line,
            beam: Beam::new(&R::coarse(&ray.line), &self.graph.root().frame),
            parent: 0,
            part: 0,
            depth: 0,
            key: 0,
            texture: None,
            optics: None,
            index: None,
            owner: 0,
        });
    }

    pub fn part(&self, part: u32) -> &'g Part {
        &self.graph.parts[part as usize]
    }

    /// The shape of a leaf. The leaf must be a shape, as all leaves are that are crossed.
    pub fn primitive(&self, leaf: Leaf) -> &'g Primitive {
        &self.graph.primitives[self.primitive_number(leaf) as usize]
    }

    pub fn primitive_number(&self, leaf: Leaf) -> u32 {
        match self.part(leaf.part).target {
            Target::Shape(p) => p,
            Target::Object(_) => unreachable!("objects have no surface of their own"),
        }
    }

    fn coat(&self, part: &Part) -> &'g Coat {
        &self.graph.paints[part.paint as usize]
    }

    /// Enters a part that is an object, and returns the number of its context. `None` if the memory is used up; the
    /// graph notes that, since the answers of rays are worth nothing then.
    pub fn enter(&mut self, context: u32, part: u32, object: u32) -> Option<u32> {
        let contexts = self.contexts.len() * size_of::<Context<R>>();
        if !(self.graph.room).has(GROWTH_FACTOR * (contexts + self.spans.bytes())) {
            return None;
        }
        let above = &self.contexts[context as usize];
        let p = self.part(part);
        let leaf = Leaf { part, context };
        let line = self.placed(&above.line, p);
        let next = Context {
            object,
            line,
            beam: Beam::new(
                &R::coarse(&line),
                &self.graph.objects[object as usize].frame,
            ),
            parent: context,
            part,
            depth: above.depth + 1,
            key: placed_key(above.key, p.placement),
            texture: self.texture(leaf),
            optics: self.own_optics(leaf),
            index: self.own_index(leaf),
            owner: outermost(above.owner, p.owner),
        };
        self.contexts.push(next);
        Some(self.contexts.len() as u32 - 1)
    }

    /// Takes a line from an object's space into the space of one of its parts.
    #[inline]
    pub fn placed(&self, line: &Line<R>, part: &Part) -> Line<R> {
        match part.placement {
            0 => *line,
            m => line.through(&R::back(&self.maps, self.graph, m)),
        }
    }

    /// The ray in the space of a leaf's shape.
    #[inline]
    pub fn line(&self, leaf: Leaf) -> Line<R> {
        if self.met == Some(leaf) {
            return self.line;
        }
        self.placed(
            &self.contexts[leaf.context as usize].line,
            self.part(leaf.part),
        )
    }

    /// The texture of a part: the outermost one that a paint gives it or an object above it.
    pub fn texture(&self, leaf: Leaf) -> Option<Painted> {
        let Leaf { part, context } = leaf;
        self.contexts[context as usize].texture.or_else(|| {
            let (texture, placement) = self.coat(self.part(part)).texture?;
            Some(Painted {
                texture,
                placement,
                context,
            })
        })
    }

    fn own_optics(&self, leaf: Leaf) -> Option<u32> {
        let above = self.contexts[leaf.context as usize].optics;
        above.or(self.coat(self.part(leaf.part)).optics)
    }

    fn own_index(&self, leaf: Leaf) -> Option<u32> {
        let above = self.contexts[leaf.context as usize].index;
        above.or(self.coat(self.part(leaf.part)).index)
    }

    /// The index into the graph's optics for a part.
    pub fn optics(&self, leaf: Leaf) -> u32 {
        self.own_optics(leaf).unwrap_or(0)
    }

    /// The index into the graph's refractive indices for a part.
    pub fn index(&self, leaf: Leaf) -> u32 {
        self.own_index(leaf).unwrap_or(0)
    }

    /// ID of the entity whose record made the surface of a leaf.
    pub fn shape_id(&self, leaf: Leaf) -> u32 {
        self.part(leaf.part).shape
    }

    /// ID of the entity whose properties a leaf has: the outermost entity that was given properties, or else the shape
    /// itself.
    pub fn object_id(&self, leaf: Leaf) -> u32 {
        let part = self.part(leaf.part);
        let above = self.contexts[leaf.context as usize].owner;
        outermost(outermost(above, part.owner), part.shape)
    }

    /// Whether the inside of a leaf's shape is on the outer side of the scene's solid: the shape's complement takes
    /// part, or the shape is taken away.
    pub fn is_turned(&self, leaf: Leaf) -> bool {
        let Leaf {
            mut part,
            mut context,
        } = leaf;
        let mut turned = self.part(part).inverted;
        loop {
            let c = &self.contexts[context as usize];
            if let Operation::Intersection { first, .. } =
                &self.graph.objects[c.object as usize].operation
            {
                turned ^= !first.contains(&part);
            }
            if context == 0 {
                return turned;
            }
            (part, context) = (c.part, c.parent);
        }
    }

    /// A number for the chain of maps that places a part: equal for equal chains.
    pub(in crate::trace) fn chain(&self, leaf: Leaf) -> u64 {
        let part = self.part(leaf.part);
        placed_key(self.contexts[leaf.context as usize].key, part.placement)
    }

    /// A number for the surface of a part that is a shape: equal for equal shapes placed equally.
    #[inline]
    pub fn surface(&self, leaf: Leaf) -> u64 {
        let (part, key) = (self.part(leaf.part), self.chain(leaf));
        match part.target {
            Target::Shape(p) => surface_key(key, p),
            Target::Object(o) => mix(key, o as u64),
        }
    }

    /// Finds the crossings with a part that is the shape `primitive`, and puts them into `self.roots`. Returns how many
    /// of them lie before the ray's start, which is at `from`. If the ray starts on this surface, goes out of its solid
    /// and cannot meet it again, no crossings are found, not even those before the start. With `ahead`, a stretch of t,
    /// crossings outside of the stretch may be missing. Returns `None` only if `ahead` is given, any crossing will do,
    /// and the ray surely goes through the solid.
    pub fn cross(
        &mut self,
        ray: &Ray<R>,
        leaf: Leaf,
        primitive: u32,
        from: R,
        ahead: Option<[f64; 2]>,
    ) -> Option<usize> {
        self.counts.shape += 1;
        self.roots.clear();
        let shape = &self.graph.primitives[primitive as usize];
        // Only doubles skip the surface. Double-double needs the crossing with it, as the exact start of the ray.
        let goes_out = R::DOUBT == Doubt::GoesOn
            && ray.left.as_ref().is_some_and(|left| {
                left.primitive == primitive
                    && !(left.entering && shape.is_solid())
                    && left.surface == self.surface(leaf)
            });
        if goes_out && shape.shape().is_convex() {
            return Some(0);
        }
        // The context of the scene has a copy of the ray. The copy was just written, and to read it takes longer than
        // to read the ray.
        let line = match leaf.context {
            0 if self.met != Some(leaf) => self.placed(&ray.line, self.part(leaf.part)),
            _ => self.line(leaf),
        };
        if !line.is_sound() {
            self.roots.inside = lost_inside(shape, &line);
            self.status.uncertain = true;
            return Some(0);
        }
        let pass = match R::DOUBT {
            // A test in doubles may disagree with crossings in single precision, which rounds the line differently.
            Doubt::Stands => Pass::Perhaps,
            _ if !goes_out => (shape.shape()).pass(&R::coarse(&line), ahead.unwrap_or(EVERYWHERE)),
            _ if shape.shape().is_met_again(&R::coarse(&line)) => Pass::Perhaps,
            _ => Pass::Beside,
        };
        match pass {
            Pass::Beside => return Some(0),
            Pass::Through if ahead.is_some() && self.is_blocked_by(ray, leaf) => return None,
            Pass::Through | Pass::Perhaps => {}
        }
        let mut roots = std::mem::take(&mut self.roots);
        if !self.is_solved_otherwise(primitive, &line, &mut roots) {
            match ahead {
                Some([start, _]) => {
                    let near = from + (from - R::of(start));
                    (shape.intersect()).first_crossings(&line, near, &mut roots);
                }
                None => shape.intersect().crossings(&line, &mut roots),
            }
            roots.doubt_blurred(&line);
        }
        debug_assert!(
            roots.list.iter().all(|r| r.t.is_finite())
                && roots.list.windows(2).all(|w| w[0].t <= w[1].t),
            "{shape:?} {line:?} {roots:?}"
        );
        self.status.uncertain |= roots.uncertain;
        if let Some(normal) = roots.along {
            self.lies_along(leaf, &line, primitive, normal);
        }
        let behind = match &roots.list[..] {
            [] => 0,
            _ => {
                self.scale = self.scale(&line, primitive);
                (self.line, self.met) = (line, Some(leaf));
                self.behind(ray, leaf, &line, &roots, from)
            }
        };
        self.roots = roots;
        Some(behind)
    }

    /// Whether passing through a solid is enough to block a ray: the ray starts outside of the solid, and the place of
    /// the crossing does not matter.
    fn is_blocked_by(&self, ray: &Ray<R>, leaf: Leaf) -> bool {
        let is_asked = R::DOUBT == Doubt::GoesOn && self.search == Search::Any;
        is_asked && ray.is_outside && !self.part(leaf.part).inverted
    }

    /// Has the graph's solver find the crossings. Returns `false` if there is no solver, or if it leaves this shape to
    /// the shape's own code.
    #[inline]
    fn is_solved_otherwise(
        &mut self,
        primitive: u32,
        line: &Line<R>,
        roots: &mut Roots<R>,
    ) -> bool {
        match &self.graph.solver {
            Some(solver) if R::DOUBT == Doubt::GoesOn => {
                self.solved.clear();
                let solved = solver.crossings(primitive, &line.cast(), &mut self.solved);
                if solved {
                    roots.copy_from(&self.solved);
                }
                solved
            }
            _ => false,
        }
    }

    /// Notes that the ray lies in a flat face of a leaf's shape, unless one is noted already.
    #[cold]
    fn lies_along(&mut self, leaf: Leaf, line: &Line<R>, primitive: u32, mut normal: Vec3) {
        self.climb(leaf, |_, placement| {
            let back = &self.graph.placements[placement as usize].back;
            normal = back.unit_normal(normal);
        });
        let origin = self.contexts[0].line.origin.abs().max_component();
        let local =
            line.origin.abs().max_component() + R::of(self.graph.extents[primitive as usize]);
        let reach = origin.max(local).to_f64();
        self.status.along.get_or_insert(Along {
            normal: normal.unit(),
            reach,
        });
    }

    /// Notes a decision that is closer than its rounding errors. Returns whether crossings that cannot be told apart
    /// count as one place.
    pub(in crate::trace) fn doubt(&mut self) -> bool {
        self.status.uncertain = true;
        R::DOUBT == Doubt::Merges
    }

    /// Calls `step` with every placement from a part up to the scene, and with the part that it places.
    pub fn climb(&self, leaf: Leaf, mut step: impl FnMut(Leaf, u32)) {
        let Leaf {
            mut part,
            mut context,
        } = leaf;
        loop {
            let placement = self.part(part).placement;
            if placement != 0 {
                step(Leaf { part, context }, placement);
            }
            if context == 0 {
                break;
            }
            let c = &self.contexts[context as usize];
            (part, context) = (c.part, c.parent);
        }
    }

    /// Whether occurrence `a` is an earlier operand than `b`.
    pub fn precedes(&self, mut a: Leaf, mut b: Leaf) -> bool {
        let up = |leaf: Leaf| {
            let c = &self.contexts[leaf.context as usize];
            Leaf {
                part: c.part,
                context: c.parent,
            }
        };
        let depth = |leaf: Leaf| self.contexts[leaf.context as usize].depth;
        while depth(a) > depth(b) {
            a = up(a);
        }
        while depth(b) > depth(a) {
            b = up(b);
        }
        while a.context != b.context {
            (a, b) = (up(a), up(b));
        }
        a.part < b.part
    }
}
