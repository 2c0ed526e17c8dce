//! Visible aspects of a scene: the aspects of each part that no paint above covers.
//!
//! One pass from the root to the leaves. A node is visited once with the set of all ways in which
//! it occurs, so shared subtrees stay shared however often they are used.

use super::below::{Below, below};
use super::unseen::LeftOut;
use super::{MAX_SOURCES, Sources};
use crate::scene::{DEFAULT_INDEX, Geometry, Node, NodeId, Optics, Scene, Texture};
use crate::solids::shapes::facts::Facts;

/// A set of ways in which a node occurs; a bit for each.
///
/// A way consists of what the paints above say about optics (nothing, diffuse, or not diffuse), whether they give a
/// texture, whether they give an index, and whether the node is complemented. One more bit stands for all occurrences
/// as a tool, which a difference takes away: a tool lends its shape and nothing else.
type PathStates = u32;

const TOOL: PathStates = 1 << 24;

/// One way in which a node occurs: what stands above it.
#[derive(Clone, Copy)]
struct PathState {
    /// Whether the optics of the paints above have a diffuse part; `None` if no paint above has optics.
    lit: Option<bool>,
    textured: bool,
    indexed: bool,
    negated: bool,
}

impl PathState {
    fn bit(self) -> PathStates {
        let optics = match self.lit {
            None => 0,
            Some(false) => 1,
            Some(true) => 2,
        };
        let flags = [self.textured, self.indexed, self.negated];
        1 << flags.iter().fold(optics, |n, &f| 2 * n + u32::from(f))
    }

    fn from_index(n: u32) -> PathState {
        PathState {
            lit: [None, Some(false), Some(true)][(n >> 3) as usize],
            textured: n & 4 != 0,
            indexed: n & 2 != 0,
            negated: n & 1 != 0,
        }
    }
}

/// The ways in a set, without the bit for tools.
fn each(ways: PathStates) -> impl Iterator<Item = PathState> {
    let mut rest = ways & !TOOL;
    std::iter::from_fn(move || {
        let n = (rest != 0).then(|| rest.trailing_zeros())?;
        rest &= rest - 1;
        Some(PathState::from_index(n))
    })
}

fn map(ways: PathStates, f: impl Fn(PathState) -> PathState) -> PathStates {
    each(ways).fold(ways & TOOL, |set, way| set | f(way).bit())
}

/// How much of the texture that a paint gives is visible.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Showing {
    /// The painted object is not drawn.
    Absent,
    /// The painted object is only taken away from something else.
    Removed,
    /// Other paints cover the texture everywhere.
    Covered,
    /// No object with the texture is diffuse.
    Dark,
    Shown,
}

/// The aspects that can be seen, and the entities that bring them in.
#[derive(Default)]
pub struct VisibleAspects {
    ways: Vec<PathStates>,
    below: Vec<Below>,
    pub diffuse: Sources,
    pub mirror: Sources,
    pub glass: Sources,
    /// Refractive indices of solids that differ between channels.
    pub uneven: Sources,
    /// Refractive indices of solids that differ from the index of the space outside.
    pub bent: Sources,
    pub image: Sources,
    pub solid_texture: Sources,
    pub checkerboard: Sources,
    pub vertex_colour: Sources,
    pub smooth: Sources,
    pub unbounded: Sources,
    /// Operation nodes other than unions, the first few; their IDs are not known yet.
    pub cuts: Vec<NodeId>,
    /// Complement nodes, the first few.
    pub complements: Vec<NodeId>,
}

fn any(k: [f64; 3]) -> bool {
    k != [0.0; 3]
}

impl VisibleAspects {
    /// Finds the visible aspects of all that is drawn: a walk down from `root`, without the operands that are left out.
    pub fn new(scene: &Scene, root: NodeId, left_out: &LeftOut) -> VisibleAspects {
        let mut reach = VisibleAspects {
            ways: vec![0; root as usize + 1],
            below: below(scene, root, left_out),
            ..VisibleAspects::default()
        };
        let top = PathState {
            lit: None,
            textured: false,
            indexed: false,
            negated: false,
        };
        if !left_out.all() {
            reach.ways[root as usize] = top.bit();
        }
        // Children have smaller numbers than their parents, so all ways to a node are known when it is visited.
        for node in (0..=root).rev() {
            let ways = reach.ways[node as usize];
            if ways != 0 {
                reach.visit(scene, node, ways, left_out);
            }
        }
        reach
    }

    /// Whether a node takes part in the drawn scene, if only as a tool.
    pub fn reaches(&self, node: NodeId) -> bool {
        self.ways.get(node as usize).is_some_and(|&w| w != 0)
    }

    /// Whether any part of a node is visible, if the node is drawn at all.
    pub fn shows(&self, node: NodeId) -> bool {
        self.below[node as usize].shows[0]
    }

    fn add(&mut self, node: NodeId, ways: PathStates) {
        self.ways[node as usize] |= ways;
    }

    /// How much of the texture of `node` is visible. The node is a paint with a texture.
    pub fn showing(&self, scene: &Scene, node: NodeId) -> Showing {
        let Node::Paint { child, paint } = scene.nodes[node as usize] else {
            return Showing::Absent;
        };
        let ways = self.ways.get(node as usize).copied().unwrap_or(0);
        if ways == 0 {
            return Showing::Absent;
        }
        if ways == TOOL {
            return Showing::Removed;
        }
        let mut bare = each(ways).filter(|way| !way.textured).peekable();
        if bare.peek().is_none() {
            return Showing::Covered;
        }
        let own_lit = scene.paints[paint as usize].optics.map(|o| any(o.kd));
        match bare.any(|way| self.is_lit(way, own_lit, child)) {
            true => Showing::Shown,
            false => Showing::Dark,
        }
    }

    /// Whether anything visible below a paint is diffuse, for one way to the paint. `own` is whether the paint's own
    /// optics are diffuse; `None` if it has no optics.
    fn is_lit(&self, way: PathState, own: Option<bool>, child: NodeId) -> bool {
        let below = &self.below[child as usize];
        let turned = usize::from(way.negated);
        below.shows[turned] && way.lit.or(own).unwrap_or(below.lit[turned])
    }

    fn visit(&mut self, scene: &Scene, node: NodeId, ways: PathStates, left_out: &LeftOut) {
        match scene.nodes[node as usize] {
            Node::Shape(shape) => self.shape(scene, shape, ways),
            Node::Union(a, b) => {
                for operand in left_out.kept(node, [a, b]) {
                    self.add(operand, ways);
                }
            }
            Node::Intersection(a, b) => {
                self.cut(node);
                self.add(a, ways);
                self.add(b, ways);
            }
            Node::Difference(a, b) => {
                self.cut(node);
                self.add(a, ways);
                // −(A − B) is −A ∪ B, so B is visible there, and not complemented.
                let seen = each(ways).filter(|w| w.negated).map(|w| {
                    let upright = PathState {
                        negated: false,
                        ..w
                    };
                    upright.bit()
                });
                let seen = seen.fold(0, |set, bit| set | bit);
                let tool = (ways & TOOL != 0) || each(ways).any(|w| !w.negated);
                self.add(b, seen | if tool { TOOL } else { 0 });
            }
            Node::Complement(child) => {
                self.cut(node);
                if self.complements.len() < MAX_SOURCES {
                    self.complements.push(node);
                }
                self.add(
                    child,
                    map(ways, |w| PathState {
                        negated: !w.negated,
                        ..w
                    }),
                );
            }
            Node::Transform { child, .. } | Node::Copy { child, .. } => self.add(child, ways),
            Node::Paint { child, paint } => {
                let below = self.paint(scene, paint, ways, child);
                self.add(child, below);
            }
        }
    }

    fn cut(&mut self, node: NodeId) {
        if self.cuts.len() < MAX_SOURCES {
            self.cuts.push(node);
        }
    }

    fn shape(&mut self, scene: &Scene, shape: u32, ways: PathStates) {
        let shape = &scene.shapes[shape as usize];
        if !bounded(&shape.geometry) {
            self.unbounded.add(shape.id);
        }
        let default_lit = any(Optics::default().kd);
        for way in each(ways) {
            if way.lit.is_none() && default_lit {
                self.diffuse.add(shape.id);
            }
            let coloured = shape.geometry.character().has_colours;
            if coloured && !way.textured && way.lit.unwrap_or(default_lit) {
                self.vertex_colour.add(shape.id);
            }
        }
        let smooth = shape.geometry.character().is_smooth;
        if smooth && ways & !TOOL != 0 {
            self.smooth.add(shape.id);
        }
    }

    /// Notes the aspects of a paint that are visible, and returns the ways in which its child occurs.
    fn paint(&mut self, scene: &Scene, paint: u32, ways: PathStates, child: NodeId) -> PathStates {
        let record = &scene.paints[paint as usize];
        let on_solid = self.below[child as usize].solid;
        let own_lit = record.optics.map(|o| any(o.kd));
        for way in each(ways) {
            if let (None, Some(optics)) = (way.lit, record.optics) {
                self.optics(record.owner, &optics);
            }
            if let (false, true, Some(index)) = (way.indexed, on_solid, record.index) {
                self.index(record.owner, index);
            }
            let lit = self.is_lit(way, own_lit, child);
            if let (false, true, Some(texture)) = (way.textured, lit, &record.texture) {
                match texture {
                    Texture::Colour(_) => {}
                    Texture::Image { .. } => self.image.add(record.owner),
                    Texture::Solid { .. } => self.solid_texture.add(record.owner),
                    Texture::Checkerboard { .. } => self.checkerboard.add(record.owner),
                }
            }
        }
        map(ways, |way| PathState {
            lit: way.lit.or(own_lit),
            textured: way.textured || record.texture.is_some(),
            indexed: way.indexed || record.index.is_some(),
            ..way
        })
    }

    fn optics(&mut self, owner: u32, optics: &Optics) {
        let kinds = [
            (optics.kd, &mut self.diffuse),
            (optics.ks, &mut self.mirror),
            (optics.kt, &mut self.glass),
        ];
        for (k, sources) in kinds {
            if any(k) {
                sources.add(owner);
            }
        }
    }

    fn index(&mut self, owner: u32, index: [f64; 3]) {
        if index[0] != index[1] || index[1] != index[2] {
            self.uneven.add(owner);
        }
        if index != DEFAULT_INDEX {
            self.bent.add(owner);
        }
    }
}

fn bounded(geometry: &Geometry) -> bool {
    use crate::geometry::Matrix;
    geometry.bounds(&Matrix::IDENTITY).is_finite()
}
