//! Walking the graph along one ray: the spaces entered on the way, and where shapes are crossed.

use super::compile::outermost;
use super::graph::{Coat, Graph, Operation, Part, Target};
use super::nearest::{Entry, Search};
use super::ray::{Left, Line, Ray};
use super::shapes::{Primitive, Root, Roots};
use super::spans::Spans;
use super::stats::Intersections;
use super::vec::{UNIT_ROUNDOFF, Vec3};

/// An occurrence of a shape: a part of the object whose space `context` is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Leaf {
    pub part: u32,
    pub context: u32,
}

/// A texture painted in the space of some context.
#[derive(Debug, Clone, Copy)]
pub struct Painted {
    pub texture: u32,
    pub placement: u32,
    pub context: u32,
}

/// An object entered on the way down from the root, with everything above it folded in.
#[derive(Debug, Clone, Copy)]
pub struct Context {
    pub object: u32,
    /// The ray in the object's space.
    pub line: Line,
    /// Where it was entered from; the root is its own parent.
    pub parent: u32,
    /// The part of the parent's object that it is.
    pub part: u32,
    pub depth: u32,
    /// A number for the chain of placements above.
    key: u64,
    texture: Option<Painted>,
    pub(super) optics: Option<u32>,
    index: Option<u32>,
    /// The outermost entity that was given properties; 0: none.
    owner: u32,
}

/// The scratch of one thread, and what it has counted.
pub struct Walker<'g> {
    pub graph: &'g Graph,
    pub contexts: Vec<Context>,
    pub roots: Roots,
    pub(super) entries: Vec<Entry>,
    pub(super) nodes: Vec<u32>,
    pub(super) search: Search,
    pub(super) spans: Spans,
    pub counts: Intersections,
}

/// Mixes a number into a key (the finaliser of splitmix64; Steele, Lea and Flood, 2014).
fn mix(key: u64, value: u64) -> u64 {
    let mut z = (key ^ value).wrapping_add(0x9e37_79b9_7f4a_7c15);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

/// The key below a placement; staying in place changes nothing.
fn placed_key(key: u64, placement: u32) -> u64 {
    if placement == 0 {
        key
    } else {
        mix(key, placement as u64)
    }
}

impl<'g> Walker<'g> {
    pub fn new(graph: &'g Graph) -> Walker<'g> {
        Walker {
            graph,
            contexts: Vec::new(),
            roots: Roots::default(),
            entries: Vec::new(),
            nodes: Vec::new(),
            search: Search::First,
            spans: Spans::default(),
            counts: Intersections::default(),
        }
    }

    /// Forgets the last ray; context 0 is the root's.
    pub fn begin(&mut self, ray: &Ray) {
        self.contexts.clear();
        self.contexts.push(Context {
            object: self.graph.root,
            line: ray.line,
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

    /// The shape of a leaf. Leaves are made of shapes only, when they are crossed.
    pub fn primitive(&self, leaf: Leaf) -> &'g Primitive {
        match self.part(leaf.part).target {
            Target::Shape(p) => &self.graph.primitives[p as usize],
            Target::Object(_) => unreachable!("objects have no surface of their own"),
        }
    }

    fn coat(&self, part: &Part) -> &'g Coat {
        &self.graph.paints[part.paint as usize]
    }

    /// Enters a part that is an object.
    pub fn enter(&mut self, context: u32, part: u32, object: u32) -> u32 {
        let above = &self.contexts[context as usize];
        let p = self.part(part);
        let leaf = Leaf { part, context };
        let next = Context {
            object,
            line: self.placed(&above.line, p),
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
        self.contexts.len() as u32 - 1
    }

    /// A line of an object's space in the space of one of its parts.
    pub fn placed(&self, line: &Line, part: &Part) -> Line {
        match part.placement {
            0 => *line,
            m => line.through(&self.graph.placements[m as usize].back),
        }
    }

    /// The texture of a part: the outermost one given.
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

    /// Number of the part's optics.
    pub fn optics(&self, leaf: Leaf) -> u32 {
        self.own_optics(leaf).unwrap_or(0)
    }

    /// Number of the part's refractive index.
    pub fn index(&self, leaf: Leaf) -> u32 {
        self.own_index(leaf).unwrap_or(0)
    }

    /// ID of the entity whose record made the surface of a leaf.
    pub fn shape_id(&self, leaf: Leaf) -> u32 {
        self.part(leaf.part).shape
    }

    /// ID of the entity whose properties a leaf has: the outermost one that was given any, or else
    /// the shape itself.
    pub fn object_id(&self, leaf: Leaf) -> u32 {
        let part = self.part(leaf.part);
        let above = self.contexts[leaf.context as usize].owner;
        outermost(outermost(above, part.owner), part.shape)
    }

    /// Whether the inside of a leaf's shape is on the outer side of the scene's solid there: its
    /// complement takes part, or it is taken away.
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

    /// A number for the surface of a part that is a shape: equal for equal shapes placed equally.
    pub fn surface(&self, leaf: Leaf) -> u64 {
        let part = self.part(leaf.part);
        let key = placed_key(self.contexts[leaf.context as usize].key, part.placement);
        match part.target {
            // Odd, and placements are not shifted: no mistaking one for the other.
            Target::Shape(p) => mix(key, !(p as u64)),
            Target::Object(o) => mix(key, o as u64),
        }
    }

    /// Finds all crossings with a part that is the shape `primitive`, into `self.roots`, and says
    /// how many of them lie behind the ray's start, which is at `from`.
    pub fn cross(&mut self, ray: &Ray, leaf: Leaf, primitive: u32, from: f64) -> usize {
        let part = self.part(leaf.part);
        let line = self.placed(&self.contexts[leaf.context as usize].line, part);
        let shape = &self.graph.primitives[primitive as usize];
        let mut roots = std::mem::take(&mut self.roots);
        roots.clear();
        shape.intersect().crossings(&line, &mut roots);
        self.counts.shape += 1;
        let passed = roots.list.partition_point(|r| r.t <= from);
        let behind = match ray.left {
            Some(left) if from <= 0.0 && !roots.list.is_empty() => {
                if self.surface(leaf) == left.surface {
                    left_behind(&roots, &left, shape.shape().is_solid()).unwrap_or(passed)
                } else {
                    self.pass_skin(leaf, &line, &roots.list, passed, &left)
                }
            }
            _ => passed,
        };
        self.roots = roots;
        behind
    }

    /// Counts on past the roots that cannot be told from the starting point.
    ///
    /// A surface at distance h from the starting point, measured along its own normal, is met at
    /// t = h / |n·d|; the starting point itself is known up to the skin.
    fn pass_skin(
        &self,
        leaf: Leaf,
        line: &Line,
        roots: &[Root],
        passed: usize,
        left: &Left,
    ) -> usize {
        // Flatter than √u to a surface, half of the digits of n·d are noise and the distance h
        // says nothing; so such roots are believed.
        let farthest = left.skin / UNIT_ROUNDOFF.sqrt();
        let direction = self.contexts[0].line.direction;
        let length = direction.length();
        let mut behind = passed;
        while let Some(root) = roots.get(behind) {
            if root.t * length > farthest {
                break;
            }
            let normal = self.world_normal(leaf, line, *root);
            if root.t * normal.dot(direction).abs() > left.skin {
                break;
            }
            behind += 1;
        }
        behind
    }

    /// The unit normal at a root, outwards, in the scene's space.
    fn world_normal(&self, leaf: Leaf, line: &Line, root: Root) -> Vec3 {
        let mut normal = self.primitive(leaf).intersect().locate(line, root).normal;
        self.climb(leaf, |placement| {
            normal = placement.back.transposed(normal);
        });
        normal.unit()
    }

    /// Calls `step` with every placement from a part up to the scene.
    pub fn climb(&self, leaf: Leaf, mut step: impl FnMut(&'g super::affine::Placement)) {
        let Leaf {
            mut part,
            mut context,
        } = leaf;
        loop {
            let placement = self.part(part).placement;
            if placement != 0 {
                step(&self.graph.placements[placement as usize]);
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

/// How many roots lie behind a ray that starts on the surface itself: those up to the one it starts
/// at, which is the nearest to the origin of those that cross in the right sense.
fn left_behind(roots: &Roots, left: &Left, solid: bool) -> Option<usize> {
    let fits = |i: usize| !solid || (roots.inside == (i % 2 == 1)) == left.entering;
    (0..roots.list.len())
        .filter(|&i| fits(i))
        .min_by(|&i, &j| roots.list[i].t.abs().total_cmp(&roots.list[j].t.abs()))
        .map(|i| i + 1)
}
