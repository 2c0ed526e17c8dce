//! A scene as the kernel sees it: shapes in blocks, blocks in a tree.

use super::cuboid::Cuboids;
use super::leaf::{Kind, Leaf};
use super::plane::Planes;
use super::rectangle::Rectangles;
use super::sphere::Spheres;
use crate::geometry::aabb::Aabb;
use crate::geometry::affine::{Affine, Placement};
use crate::geometry::bvh::Bvh;
use crate::geometry::exponent::{exponent, shifted};
use crate::geometry::vec::Vec3;
use crate::geometry::wide_bvh::{Frame, Tree};
use crate::scene::{DEFAULT_COLOUR, Texture};
use crate::trace::graph::{Graph, Operation, Part, Target};
use crate::trace::shapes::Primitive;
use std::ops::ControlFlow;

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
}

#[derive(Debug, Clone)]
pub enum Shapes {
    Spheres(Spheres),
    Cuboids(Cuboids),
    Planes(Planes),
    Rectangles(Rectangles),
}

/// A scene as the kernel sees it.
#[derive(Debug)]
pub struct Stage<'g> {
    pub leaves: Vec<Leaf>,
    pub blocks: Vec<Block>,
    /// Numbers of blocks without bounds.
    pub loose: Vec<u32>,
    /// Its items are numbers of the other blocks.
    pub tree: Tree,
    pub frame: Frame,
    pub placements: &'g [Placement],
    /// Whether something in it is transparent.
    pub has_glass: bool,
}

/// Numbers of a scene that the kernel takes on are between this and its reciprocal, or zero.
const LEAST: f64 = 1e-30;
/// Maps that stretch by more than this along one axis, compared with another, are not for the kernel.
const STRETCH: f64 = 100.0;
/// Up to so many of the transparent shapes may be near others: rays that meet these are in doubt.
const CROWDED: f64 = 0.25;

impl Stage<'_> {
    /// `None` where something in the scene is not for the kernel, or where the scene has more than so many shapes.
    pub fn new(graph: &Graph, most: usize) -> Option<Stage<'_>> {
        let root = graph.root();
        let Operation::Union(group) = &root.operation else {
            return None;
        };
        let mut leaves = Vec::new();
        let mut boxes = Vec::new();
        for &part in &group.loose {
            leaves.push(leaf(graph, &graph.parts[part as usize])?);
        }
        let loose = leaves.len() as u32;
        for (part, bounds) in group.tree.boxes(&root.frame) {
            if leaves.len() > most {
                return None;
            }
            boxes.push((leaves.len() as u32, bounds));
            leaves.push(leaf(graph, &graph.parts[part as usize])?);
        }
        let has_glass = leaves.iter().any(|leaf| leaf.is_clear);
        if has_glass && !are_mostly_lone(graph, &mut leaves, &boxes) {
            return None;
        }
        let frame = Frame::around(boxes.iter().map(|(_, bounds)| bounds));
        let mut blocks = Vec::new();
        let all: Vec<u32> = (0..loose).collect();
        in_blocks(&leaves, &all, &mut blocks);
        let loose = (0..blocks.len() as u32).collect();
        let bounds = clustered(&leaves, boxes, &mut blocks);
        Some(Stage {
            has_glass,
            leaves,
            blocks,
            loose,
            tree: Tree::new(bounds, &frame),
            frame,
            placements: &graph.placements,
        })
    }
}

/// What a part is, if it is for the kernel.
fn leaf(graph: &Graph, part: &Part) -> Option<Leaf> {
    let Target::Shape(number) = part.target else {
        return None;
    };
    if part.inverted || !is_usual(&graph.placements[part.placement as usize]) {
        return None;
    }
    let (kind, numbers) = shape(&graph.primitives[number as usize])?;
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
    // Channels that are refracted in different ways are not for the kernel, nor is what has no inside or no end.
    let even = |index: [f64; 3]| (index[0] == index[1] && index[1] == index[2]).then_some(index[0]);
    let is_clear = optics.kt != [0.0; 3];
    let (around, own) = match is_clear {
        true if matches!(kind, Kind::Sphere | Kind::Cuboid) => (
            even(graph.indices[0])?,
            even(graph.indices[coat.index.unwrap_or(0) as usize])?,
        ),
        true => return None,
        false => (1.0, 1.0),
    };
    Some(Leaf {
        kind,
        numbers,
        placement: part.placement,
        extent: graph.extents[number as usize],
        albedo,
        ks: optics.ks,
        kt: optics.kt,
        ratios: [around / own, own / around],
        is_straight: around == own,
        is_clear,
        is_lone: false,
    })
}

/// The kind and the numbers of a shape.
fn shape(primitive: &Primitive) -> Option<(Kind, [f64; 8])> {
    let (kind, numbers, sizes) = match primitive {
        Primitive::Sphere(sphere) => {
            let ([x, y, z], r) = sphere.numbers();
            (Kind::Sphere, [x, y, z, r, 0.0, 0.0, 0.0, 0.0], vec![r])
        }
        Primitive::Cuboid(cuboid) => {
            let [min, max] = cuboid.corners();
            let sizes = (0..3).map(|i| max[i] - min[i]).collect();
            let ([a, b, c], [x, y, z]) = (min, max);
            (Kind::Cuboid, [a, b, c, x, y, z, 0.0, 0.0], sizes)
        }
        Primitive::Rectangle(rectangle) => {
            let [[a, b], [x, y]] = rectangle.corners();
            let numbers = [a, b, x, y, 0.0, 0.0, 0.0, 0.0];
            (Kind::Rectangle, numbers, vec![x - a, y - b])
        }
        Primitive::Plane(plane) => (Kind::Plane, of_plane(plane.abcd()), Vec::new()),
        Primitive::HalfSpace(solid) => (Kind::HalfSpace, of_plane(solid.abcd()), Vec::new()),
        _ => return None,
    };
    let usual = |x: &f64| (LEAST..LEAST.recip()).contains(x);
    let are_usual = numbers.iter().all(|&x| x == 0.0 || usual(&x.abs()));
    (are_usual && sizes.iter().all(usual)).then_some((kind, numbers))
}

/// a, b, c and d as written, and in units of the normal.
fn of_plane([a, b, c, d]: [f64; 4]) -> [f64; 8] {
    let steep = exponent(a.abs().max(b.abs()).max(c.abs()));
    let [x, y, z, w] = [a, b, c, d].map(|number| shifted(number, -steep));
    [a, b, c, d, x, y, z, w]
}

/// Whether a map neither stretches much along one axis, nor takes numbers far.
fn is_usual(placement: &Placement) -> bool {
    let spread = |map: &Affine| {
        let rows = map.rows.map(|row| row.abs().dot(Vec3::ONE));
        rows[0].max(rows[1]).max(rows[2])
    };
    let [out, back] = [&placement.out, &placement.back].map(spread);
    let sizes = [out, back].into_iter().chain(placement.out.offset.abs().0);
    out * back <= STRETCH && sizes.into_iter().all(|x| x <= LEAST.recip().sqrt())
}

/// Finds out which transparent shapes are lone; whether most of them are.
fn are_mostly_lone(graph: &Graph, leaves: &mut [Leaf], boxes: &[(u32, Aabb)]) -> bool {
    let hierarchy = Bvh::new(boxes.to_vec());
    let first = boxes.first().map_or(0, |b| b.0);
    let planes: Vec<Flat> = leaves[..first as usize]
        .iter()
        .map(|leaf| Flat::new(graph, leaf))
        .collect();
    let balls: Vec<Option<Ball>> = (boxes.iter())
        .map(|(i, bounds)| Ball::new(graph, &leaves[*i as usize], bounds))
        .collect();
    let (mut clear, mut lone) = (0, 0);
    for &(i, bounds) in boxes {
        if !leaves[i as usize].is_clear {
            continue;
        }
        // Rays leave it by far more than what makes them doubt.
        let room = 1e-4 * bounds.reach();
        let all = Vec3::ONE * room;
        let around = Aabb::new(Vec3(bounds.min) - all, Vec3(bounds.max) + all);
        let is_alone = |j: u32| {
            let [own, other] = [i, j].map(|i| (i - first) as usize);
            let is_apart = match (&balls[own], &balls[other]) {
                (Some(a), Some(b)) => (a.centre - b.centre).length() > a.radius + b.radius + room,
                _ => !boxes[other].1.overlaps(&around),
            };
            match j != i && !is_apart {
                true => ControlFlow::Break(()),
                false => ControlFlow::Continue(()),
            }
        };
        let is_lone = hierarchy.visit(&around, is_alone).is_continue()
            && planes.iter().all(|plane| plane.is_apart(&around));
        leaves[i as usize].is_lone = is_lone;
        clear += 1;
        lone += u32::from(is_lone);
    }
    f64::from(clear - lone) <= CROWDED * f64::from(clear)
}

/// A sphere in the scene's space, roughly.
struct Ball {
    centre: Vec3,
    radius: f64,
}

impl Ball {
    /// `None` for what is no sphere, or is turned or stretched.
    fn new(graph: &Graph, leaf: &Leaf, bounds: &Aabb) -> Option<Ball> {
        let rows = &graph.placements[leaf.placement as usize].out.rows;
        let is_moved = (0..3).all(|i| (0..3).all(|j| rows[i].0[j] == f64::from(u8::from(i == j))));
        (leaf.kind == Kind::Sphere && is_moved).then(|| Ball {
            centre: Vec3(bounds.centre()),
            radius: bounds.extent()[0] / 2.0,
        })
    }
}

/// A plane in the scene's space, roughly.
struct Flat {
    normal: Vec3,
    d: f64,
    is_solid: bool,
}

impl Flat {
    fn new(graph: &Graph, leaf: &Leaf) -> Flat {
        let back = &graph.placements[leaf.placement as usize].back;
        let normal = Vec3(*leaf.first());
        Flat {
            normal: back.transposed(normal),
            d: normal.dot(back.offset) + leaf.numbers[3],
            is_solid: leaf.kind == Kind::HalfSpace,
        }
    }

    /// Whether all of a box is on one side, and outside.
    fn is_apart(&self, bounds: &Aabb) -> bool {
        let value = self.normal.dot(Vec3(bounds.centre())) + self.d;
        let reach = self.normal.abs().dot(Vec3(bounds.extent())) / 2.0;
        value > reach || (value < -reach && !self.is_solid)
    }
}

/// Puts shapes that are near each other into blocks. Returns the bounds of the blocks.
fn clustered(
    leaves: &[Leaf],
    boxes: Vec<(u32, Aabb)>,
    blocks: &mut Vec<Block>,
) -> Vec<(u32, Aabb)> {
    let first = boxes.first().map_or(0, |b| b.0);
    let all: Vec<Aabb> = boxes.iter().map(|b| b.1).collect();
    let hierarchy = Bvh::with_leaves(boxes, 4);
    let mut bounds = Vec::new();
    let clusters = hierarchy.nodes.iter().filter(|node| node.count > 0);
    for node in clusters {
        let items = &hierarchy.items[node.index as usize..][..node.count as usize];
        let before = blocks.len();
        in_blocks(leaves, items, blocks);
        for (i, block) in blocks.iter().enumerate().skip(before) {
            let own = block.leaves.iter().filter(|&&leaf| leaf != u32::MAX);
            let own = own.map(|&leaf| &all[(leaf - first) as usize]);
            bounds.push((i as u32, own.fold(Aabb::EMPTY, |all, b| all.hull(b))));
        }
    }
    bounds
}

/// Puts shapes of one kind in one space into a block.
fn in_blocks(leaves: &[Leaf], items: &[u32], blocks: &mut Vec<Block>) {
    let mut left: Vec<u32> = items.to_vec();
    while let Some(&first) = left.first() {
        let like = |i: &u32| {
            let [a, b] = [first, *i].map(|i| &leaves[i as usize]);
            a.kind == b.kind && a.placement == b.placement
        };
        let own: Vec<u32> = left.iter().copied().filter(like).take(4).collect();
        left.retain(|i| !own.contains(i));
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
    };
    let mut own = [u32::MAX; 4];
    own[..numbers.len()].copy_from_slice(numbers);
    Block {
        shapes,
        placement: all[0].placement,
        leaves: own,
        extent: all.iter().fold(0.0, |most, leaf| leaf.extent.max(most)),
    }
}
