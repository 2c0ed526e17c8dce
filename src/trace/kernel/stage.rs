//! A scene as the kernel sees it: shapes in blocks, blocks in a tree.

use super::cuboid::Cuboids;
use super::sphere::Spheres;
use crate::geometry::aabb::Aabb;
use crate::geometry::bvh::Bvh;
use crate::geometry::vec::Vec3;
use crate::geometry::wide_bvh::{Frame, Tree};
use crate::scene::{DEFAULT_COLOUR, Texture};
use crate::trace::graph::{Graph, Operation, Part, Target};
use crate::trace::shapes::Primitive;
use std::ops::ControlFlow;

/// Kinds of shapes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    Sphere,
    Cuboid,
}

/// A shape of the scene, and what it is made of.
#[derive(Debug, Clone)]
pub struct Leaf {
    pub kind: Kind,
    /// A sphere's centre, and its radius in the fourth place; the lower corner of a box.
    pub low: [f64; 3],
    /// The upper corner of a box.
    pub high: [f64; 3],
    pub radius: f64,
    /// See [`Graph::extents`].
    pub extent: f64,
    /// The share of diffuse light in the shape's colour.
    pub albedo: [f64; 3],
    pub ks: [f64; 3],
    pub kt: [f64; 3],
    /// The refractive index before the surface over the one behind it, on the way in and on the way out.
    pub ratios: [f64; 2],
    /// Whether the two are one number.
    pub is_straight: bool,
    /// Whether something goes through it.
    pub is_clear: bool,
    /// Whether no other shape is near, so that the way out of it is what comes next inside.
    pub is_lone: bool,
}

/// Shapes that are tested together.
#[derive(Debug, Clone)]
pub struct Block {
    pub shapes: Shapes,
    /// Numbers of the leaves in the lanes.
    pub leaves: [u32; 4],
    /// The greatest extent of its leaves.
    pub extent: f64,
}

#[derive(Debug, Clone)]
pub enum Shapes {
    Spheres(Spheres),
    Cuboids(Cuboids),
}

/// A scene as the kernel sees it.
#[derive(Debug)]
pub struct Stage {
    pub leaves: Vec<Leaf>,
    pub blocks: Vec<Block>,
    /// Its items are numbers of blocks.
    pub tree: Tree,
    pub frame: Frame,
}

/// Numbers of a scene that the kernel takes on are between this and its reciprocal, or zero.
const LEAST: f64 = 1e-30;
/// Up to so many of the transparent shapes may be near others: rays that meet these are in doubt.
const CROWDED: f64 = 0.25;

impl Stage {
    /// `None` where something in the scene is not for the kernel.
    pub fn new(graph: &Graph) -> Option<Stage> {
        let Operation::Union(group) = &graph.root().operation else {
            return None;
        };
        if !group.loose.is_empty() {
            return None;
        }
        let parts: Vec<u32> = group.tree.items().collect();
        let mut leaves = Vec::with_capacity(parts.len());
        let mut boxes = Vec::with_capacity(parts.len());
        for (i, &part) in (0..).zip(&parts) {
            let (leaf, bounds) = leaf(graph, &graph.parts[part as usize])?;
            leaves.push(leaf);
            boxes.push((i, bounds));
        }
        let has_glass = leaves.iter().any(|leaf| leaf.is_clear);
        if has_glass && !are_mostly_lone(&mut leaves, &boxes) {
            return None;
        }
        let frame = Frame::around(boxes.iter().map(|(_, bounds)| bounds));
        let mut blocks = Vec::new();
        let bounds = in_blocks(&leaves, boxes, &mut blocks);
        Some(Stage {
            leaves,
            blocks,
            tree: Tree::new(bounds, &frame),
            frame,
        })
    }
}

/// What a part is, if it is for the kernel.
fn leaf(graph: &Graph, part: &Part) -> Option<(Leaf, Aabb)> {
    let Target::Shape(number) = part.target else {
        return None;
    };
    if part.inverted || part.placement != 0 {
        return None;
    }
    let primitive = &graph.primitives[number as usize];
    let (kind, low, high, radius) = match primitive {
        Primitive::Sphere(sphere) => {
            let (centre, radius) = sphere.numbers();
            (Kind::Sphere, centre.0, [0.0; 3], radius)
        }
        Primitive::Cuboid(cuboid) => {
            let (min, max) = cuboid.corners();
            let is_flat = (0..3).any(|i| min[i] >= max[i]);
            (Kind::Cuboid, min.0, max.0, if is_flat { 0.0 } else { 1.0 })
        }
        _ => return None,
    };
    let usual = |x: f64| (LEAST..LEAST.recip()).contains(&x);
    let mut sizes = low.iter().chain(&high);
    if !usual(radius) || !sizes.all(|&x| x == 0.0 || usual(x.abs())) {
        return None;
    }
    let coat = &graph.paints[part.paint as usize];
    let optics = &graph.optics[coat.optics.unwrap_or(0) as usize];
    let colour = match coat.texture {
        None => DEFAULT_COLOUR,
        Some((texture, _)) => match &graph.textures[texture as usize] {
            Texture::Colour(colour) => *colour,
            _ => return None,
        },
    };
    let albedo = match optics.kd {
        [0.0, 0.0, 0.0] => [0.0; 3],
        kd => Vec3(kd).times(Vec3(colour)).0,
    };
    // Channels that are refracted in different ways are not for the kernel.
    let even = |index: [f64; 3]| (index[0] == index[1] && index[1] == index[2]).then_some(index[0]);
    let is_clear = optics.kt != [0.0; 3];
    let (around, own) = match is_clear {
        true => (
            even(graph.indices[0])?,
            even(graph.indices[coat.index.unwrap_or(0) as usize])?,
        ),
        false => (1.0, 1.0),
    };
    let leaf = Leaf {
        kind,
        low,
        high,
        radius,
        extent: graph.extents[number as usize],
        albedo,
        ks: optics.ks,
        kt: optics.kt,
        ratios: [around / own, own / around],
        is_straight: around == own,
        is_clear,
        is_lone: false,
    };
    Some((leaf, primitive.shape().bounds()))
}

/// Finds out which shapes are lone; whether most of the transparent ones are.
fn are_mostly_lone(leaves: &mut [Leaf], boxes: &[(u32, Aabb)]) -> bool {
    let hierarchy = Bvh::new(boxes.to_vec());
    let (mut clear, mut lone) = (0, 0);
    for &(i, bounds) in boxes {
        let leaf = &mut leaves[i as usize];
        if !leaf.is_clear {
            continue;
        }
        // Rays leave it by far more than what makes them doubt.
        let room = Vec3::ONE * (1e-4 * leaf.extent);
        let around = Aabb::new(Vec3(bounds.min) - room, Vec3(bounds.max) + room);
        let is_alone = |j: u32| match j != i && boxes[j as usize].1.overlaps(&around) {
            true => ControlFlow::Break(()),
            false => ControlFlow::Continue(()),
        };
        leaf.is_lone = hierarchy.visit(&around, is_alone).is_continue();
        clear += 1;
        lone += u32::from(leaf.is_lone);
    }
    f64::from(clear - lone) <= CROWDED * f64::from(clear)
}

/// Puts shapes that are near each other into blocks of one kind. Returns the bounds of the blocks.
fn in_blocks(
    leaves: &[Leaf],
    boxes: Vec<(u32, Aabb)>,
    blocks: &mut Vec<Block>,
) -> Vec<(u32, Aabb)> {
    let all: Vec<Aabb> = boxes.iter().map(|b| b.1).collect();
    let hierarchy = Bvh::with_leaves(boxes, 4);
    let mut bounds = Vec::new();
    let clusters = hierarchy.nodes.iter().filter(|node| node.count > 0);
    for node in clusters {
        let items = &hierarchy.items[node.index as usize..][..node.count as usize];
        for kind in [Kind::Sphere, Kind::Cuboid] {
            let own = items.iter().copied();
            let own: Vec<u32> = own.filter(|&i| leaves[i as usize].kind == kind).collect();
            for some in own.chunks(4) {
                bounds.push((
                    blocks.len() as u32,
                    hull(some.iter().map(|&i| &all[i as usize])),
                ));
                blocks.push(block(leaves, kind, some));
            }
        }
    }
    bounds
}

fn hull<'a>(boxes: impl Iterator<Item = &'a Aabb>) -> Aabb {
    boxes.fold(Aabb::EMPTY, |all, b| all.hull(b))
}

fn block(leaves: &[Leaf], kind: Kind, numbers: &[u32]) -> Block {
    let all = || numbers.iter().map(|&i| &leaves[i as usize]);
    let shapes = match kind {
        Kind::Sphere => {
            let sphere = |leaf: &Leaf| {
                let [x, y, z] = leaf.low;
                [x, y, z, leaf.radius]
            };
            Shapes::Spheres(Spheres::new(&all().map(sphere).collect::<Vec<_>>()))
        }
        Kind::Cuboid => {
            let cuboid = |leaf: &Leaf| corners(leaf);
            Shapes::Cuboids(Cuboids::new(&all().map(cuboid).collect::<Vec<_>>()))
        }
    };
    let mut own = [u32::MAX; 4];
    own[..numbers.len()].copy_from_slice(numbers);
    Block {
        shapes,
        leaves: own,
        extent: all().fold(0.0, |most, leaf| leaf.extent.max(most)),
    }
}

/// The lower and the upper corner of a box.
pub fn corners(leaf: &Leaf) -> [f64; 6] {
    let ([a, b, c], [x, y, z]) = (leaf.low, leaf.high);
    [a, b, c, x, y, z]
}
