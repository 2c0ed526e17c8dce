//! A scene as the kernel sees it: shapes in blocks, blocks in a tree.

use super::block::{Block, Shapes, in_blocks, in_loose_blocks};
use super::chain::Chains;
use super::csg::Csg;
use super::cull::Cull;
use super::expand::Leaves;
use super::lanes::LANES;
use super::leaf::{Kind, Leaf};
use super::lone::find_lone;
use super::probe::Probe;
use super::quadric::Quadrics;
use crate::geometry::aabb::Aabb;
use crate::geometry::affine::Placement;
use crate::geometry::bvh::Bvh;
use crate::geometry::wide_bvh::{Frame, Tree};
use crate::trace::graph::Graph;
use crate::trace::shapes::outline::Outline;

/// Blocks that a ray may meet: some in a tree, some without bounds.
#[derive(Debug)]
pub struct Forest {
    /// Numbers of blocks without bounds.
    pub loose: Vec<u32>,
    /// The tree of the other blocks; its items are their numbers.
    pub tree: Tree,
    pub frame: Frame,
}

/// A scene as the kernel sees it.
#[derive(Debug)]
pub struct Stage<'g> {
    pub leaves: Vec<Leaf>,
    pub blocks: Vec<Block>,
    /// The blocks of the scene's union.
    pub all: Forest,
    /// Intersections and differences.
    pub csgs: Vec<Csg>,
    /// Chains of placements: indices into [`Graph::placements`], the outermost first.
    pub chains: Vec<Vec<u32>>,
    pub graph: &'g Graph,
    /// Whether transparent things let the light of lamps through.
    pub lets_light_through: bool,
}

impl Stage<'_> {
    /// Sets up a scene for the kernel. `None` where the kernel cannot draw some part of the scene, or where the scene
    /// has more than `most` shapes.
    pub fn new(graph: &Graph, most: usize) -> Option<Stage<'_>> {
        if graph.parts.len() > most {
            return None;
        }
        let mut leaves = Leaves::new(graph, most)?;
        if leaves.all.iter().any(|leaf| leaf.is_clear) {
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
        let cull = |number: u32| {
            let leaf = &leaves[number as usize];
            let (bounds, outline) = match leaf.kind {
                Kind::Csg => (operands[leaf.primitive as usize].bounds, Outline::BOUNDS),
                _ => {
                    let shape = graph.primitives[leaf.primitive as usize].shape();
                    (shape.bounds(), shape.outline())
                }
            };
            Cull::new(graph, &chains[leaf.chain as usize], &bounds, outline)
        };
        for block in &mut blocks {
            if let Shapes::Single = block.shapes {
                block.cull = cull(block.leaves[0]).map(Box::new);
            }
            let own = block.each_leaf().map(|(_, leaf)| &leaves[leaf as usize]);
            let quadrics = own.filter_map(Leaf::quadric);
            block.apart = quadrics.map(|own| Quadrics::new(&[own; LANES])).collect();
        }
        let csgs = operands
            .into_iter()
            .map(|o| Csg::new(&leaves, o, &mut blocks));
        Some(Stage {
            csgs: csgs.collect(),
            lets_light_through: !(graph.without.refraction || graph.without.transparent_shadows),
            leaves,
            blocks,
            all,
            chains,
            graph,
        })
    }

    /// The leaves, and the placements that they are in.
    #[inline(always)]
    pub fn space(&self) -> (&[Leaf], &[Placement]) {
        (&self.leaves, &self.graph.placements)
    }

    /// The ray in the space of a placement. Unless that is the scene's space, the ray is kept in `moved`.
    #[inline(always)]
    pub fn placed<'p>(&self, probe: &'p Probe, placement: u32, moved: &'p mut Probe) -> &'p Probe {
        if placement == 0 {
            return probe;
        }
        *moved = probe.through(&self.graph.placements[placement as usize].back);
        moved
    }

    /// The chains of placements above four leaves.
    pub fn chains_of(&self, leaves: [&Leaf; LANES]) -> Chains<'_> {
        Chains::of(leaves, &self.chains, &self.graph.placements)
    }
}

impl Forest {
    /// Puts leaves into new blocks, and the blocks of leaves with boxes into a tree.
    pub fn new(
        leaves: &[Leaf],
        loose: &[u32],
        boxes: Vec<(u32, Aabb)>,
        blocks: &mut Vec<Block>,
    ) -> Forest {
        let frame = Frame::around(boxes.iter().map(|(_, bounds)| bounds));
        let first = blocks.len() as u32;
        in_loose_blocks(leaves, loose, blocks);
        let loose = (first..blocks.len() as u32).collect();
        let bounds = clustered(leaves, &boxes, blocks);
        Forest {
            loose,
            tree: Tree::new(bounds, &frame),
            frame,
        }
    }
}

/// Puts shapes that are near each other into blocks. Returns the number of each block with its bounds.
fn clustered(leaves: &[Leaf], boxes: &[(u32, Aabb)], blocks: &mut Vec<Block>) -> Vec<(u32, Aabb)> {
    let places = (0..)
        .zip(boxes)
        .map(|(place, &(_, bounds))| (place, bounds));
    let hierarchy = Bvh::with_leaves(places.collect(), LANES);
    let first = blocks.len();
    for node in hierarchy.nodes.iter().filter(|node| node.count > 0) {
        let places = &hierarchy.items[node.index as usize..][..node.count as usize];
        let items = places.iter().map(|&place| boxes[place as usize]);
        in_blocks(leaves, items.collect(), blocks);
    }
    (first as u32..)
        .zip(&blocks[first..])
        .map(|(number, block)| (number, block.bounds))
        .collect()
}
