//! A scene as the kernel sees it: shapes in blocks, blocks in a tree.

use super::csg::Csg;
use super::cull::Cull;
use super::cuboid::Cuboids;
use super::expand::Leaves;
use super::leaf::{Kind, Leaf};
use super::lone::find_lone;
use super::plane::Planes;
use super::query::NONE;
use super::rectangle::Rectangles;
use super::sphere::Spheres;
use crate::geometry::aabb::Aabb;
use crate::geometry::bvh::Bvh;
use crate::geometry::wide_bvh::{Frame, Tree};
use crate::trace::graph::Graph;
use crate::trace::shapes::outline::Outline;
use rustc_hash::FxHashMap;

/// Shapes that are tested together, in one space.
#[derive(Debug, Clone)]
pub struct Block {
    pub shapes: Shapes,
    /// Of all of them; see [`Leaf::placement`].
    pub placement: u32,
    /// Numbers of the leaves in the lanes.
    pub leaves: [u32; 4],
    /// The greatest extent of its leaves.
    pub extent: f64,
    /// Of all of them, if it is in a tree.
    pub bounds: Aabb,
    /// Tells which rays miss it, if it is one shape without lanes, or a placed one.
    pub cull: Option<Box<Cull>>,
}

#[derive(Debug, Clone)]
pub enum Shapes {
    Spheres(Spheres),
    Cuboids(Cuboids),
    Planes(Planes),
    Rectangles(Rectangles),
    /// One leaf, without lanes.
    Single,
}

/// Blocks that a ray may meet.
#[derive(Debug)]
pub struct Forest {
    /// Numbers of blocks without bounds.
    pub loose: Vec<u32>,
    /// Its items are numbers of the other blocks.
    pub tree: Tree,
    pub frame: Frame,
}

/// A scene as the kernel sees it.
#[derive(Debug)]
pub struct Stage<'g> {
    pub leaves: Vec<Leaf>,
    pub blocks: Vec<Block>,
    /// The scene's union.
    pub all: Forest,
    /// Intersections and differences.
    pub csgs: Vec<Csg>,
    /// Chains of placements: indices into [`Graph::placements`], the outermost first.
    pub chains: Vec<Vec<u32>>,
    pub graph: &'g Graph,
    /// Whether something in it is transparent.
    pub has_glass: bool,
    /// Whether transparent things let the light of lamps through.
    pub lets_light_through: bool,
}

impl Stage<'_> {
    /// `None` where something in the scene is not for the kernel, or where the scene has more than so many shapes.
    pub fn new(graph: &Graph, most: usize) -> Option<Stage<'_>> {
        if graph.parts.len() > most {
            return None;
        }
        let mut leaves = Leaves::new(graph, most)?;
        let has_glass = leaves.all.iter().any(|leaf| leaf.is_clear);
        if has_glass {
            find_lone(graph, &mut leaves);
        }
        let Leaves {
            all: leaves,
            loose,
            boxes,
            chains,
            operands,
            ..
        } = leaves;
        let mut blocks = Vec::new();
        let all = Forest::new(&leaves, &loose, boxes, &mut blocks);
        for block in &mut blocks {
            let leaf = &leaves[block.leaves[0] as usize];
            let is_apart = matches!(block.shapes, Shapes::Single) || block.placement != 0;
            if !is_apart || block.leaves[1] != NONE {
                continue;
            }
            let (bounds, outline) = match leaf.kind {
                Kind::Csg => (operands[leaf.primitive as usize].bounds, Outline::BOUNDS),
                _ => {
                    let shape = graph.primitives[leaf.primitive as usize].shape();
                    (shape.bounds(), shape.outline())
                }
            };
            let chain = &chains[leaf.chain as usize];
            block.cull = Cull::new(graph, chain, &bounds, outline).map(Box::new);
        }
        let csgs = operands
            .into_iter()
            .map(|o| Csg::new(&leaves, o, &mut blocks));
        Some(Stage {
            csgs: csgs.collect(),
            has_glass,
            lets_light_through: !(graph.without.refraction || graph.without.transparent_shadows),
            leaves,
            blocks,
            all,
            chains,
            graph,
        })
    }
}

impl Forest {
    /// Puts leaves into blocks, and those with boxes into a tree.
    pub fn new(
        leaves: &[Leaf],
        loose: &[u32],
        boxes: Vec<(u32, Aabb)>,
        blocks: &mut Vec<Block>,
    ) -> Forest {
        let frame = Frame::around(boxes.iter().map(|(_, bounds)| bounds));
        let first = blocks.len() as u32;
        in_blocks(leaves, loose, blocks);
        let loose = (first..blocks.len() as u32).collect();
        let bounds = clustered(leaves, boxes, blocks);
        Forest {
            loose,
            tree: Tree::new(bounds, &frame),
            frame,
        }
    }
}

/// Puts shapes that are near each other into blocks. Returns the bounds of the blocks.
fn clustered(
    leaves: &[Leaf],
    boxes: Vec<(u32, Aabb)>,
    blocks: &mut Vec<Block>,
) -> Vec<(u32, Aabb)> {
    let all: FxHashMap<u32, Aabb> = boxes.iter().copied().collect();
    let hierarchy = Bvh::with_leaves(boxes, 4);
    let mut bounds = Vec::new();
    let clusters = hierarchy.nodes.iter().filter(|node| node.count > 0);
    for node in clusters {
        let items = &hierarchy.items[node.index as usize..][..node.count as usize];
        let before = blocks.len();
        in_blocks(leaves, items, blocks);
        for (i, block) in blocks.iter_mut().enumerate().skip(before) {
            let own = block.leaves.iter().filter_map(|leaf| all.get(leaf));
            block.bounds = own.fold(Aabb::EMPTY, |all, b| all.hull(b));
            bounds.push((i as u32, block.bounds));
        }
    }
    bounds
}

/// Puts shapes of one kind in one space into a block.
pub fn in_blocks(leaves: &[Leaf], items: &[u32], blocks: &mut Vec<Block>) {
    let mut rest: Vec<u32> = items.to_vec();
    while let Some(&first) = rest.first() {
        let like = |i: &u32| {
            let [a, b] = [first, *i].map(|i| &leaves[i as usize]);
            a.kind == b.kind && a.placement == b.placement
        };
        let lanes = match leaves[first as usize].kind {
            Kind::Other | Kind::Csg => 1,
            _ => 4,
        };
        let own: Vec<u32> = rest.iter().copied().filter(like).take(lanes).collect();
        rest.retain(|i| !own.contains(i));
        blocks.push(block(leaves, &own));
    }
}

/// Of up to four leaves of one kind.
fn block(leaves: &[Leaf], numbers: &[u32]) -> Block {
    let all: Vec<&Leaf> = numbers.iter().map(|&i| &leaves[i as usize]).collect();
    let four = |leaf: &&Leaf| {
        let [a, b, c, d, ..] = leaf.numbers;
        [a, b, c, d]
    };
    let shapes = match all[0].kind {
        Kind::Sphere => Shapes::Spheres(Spheres::new(&all.iter().map(four).collect::<Vec<_>>())),
        Kind::Cuboid => {
            let corners = |leaf: &&Leaf| {
                let [a, b, c, x, y, z, ..] = leaf.numbers;
                [a, b, c, x, y, z]
            };
            Shapes::Cuboids(Cuboids::new(&all.iter().map(corners).collect::<Vec<_>>()))
        }
        Kind::Plane | Kind::HalfSpace => {
            let plane = |leaf: &&Leaf| (four(leaf), leaf.kind == Kind::HalfSpace);
            Shapes::Planes(Planes::new(&all.iter().map(plane).collect::<Vec<_>>()))
        }
        Kind::Rectangle => {
            Shapes::Rectangles(Rectangles::new(&all.iter().map(four).collect::<Vec<_>>()))
        }
        Kind::Other | Kind::Csg => Shapes::Single,
    };
    let mut own = [u32::MAX; 4];
    own[..numbers.len()].copy_from_slice(numbers);
    Block {
        shapes,
        placement: all[0].placement,
        leaves: own,
        extent: all.iter().fold(0.0, |most, leaf| leaf.extent.max(most)),
        bounds: Aabb::ALL,
        cull: None,
    }
}
