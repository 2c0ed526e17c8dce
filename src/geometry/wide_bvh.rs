//! A hierarchy of boxes, with up to eight children in a node, that rays walk.
//!
//! A node holds the boxes of up to eight children in single precision, rounded outwards, side by side, so that a ray
//! meets all of them in one go (Wald, Benthin and Boulos, "Getting Rid of Packets", 2008). Coordinates are relative to
//! the middle of all boxes. Their unit is a power of two that makes the largest one less than 1. So boxes are equally
//! tight in scenes of any size and at any place.

use super::aabb::Aabb;
use super::array::each;
use super::bvh::Bvh;
use super::line::Line;
use super::vec::Vec3;
use wide::{f32x4, f32x8};

/// The most children of a node.
pub const WIDTH: usize = 8;

/// A node or an item, in one number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Child(u32);

/// The kinds of children.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Is {
    /// The number of a node.
    Node(u32),
    /// The number that the item was given.
    Item(u32),
}

/// The bit that marks the number of an item.
const ITEM: u32 = 1 << 31;

impl Child {
    /// The first node of a tree.
    pub const ROOT: Child = Child(0);
    /// The mark of a place without a child.
    const NONE: Child = Child(u32::MAX);

    /// The child for an item whose number is below 2³¹ − 1.
    #[inline]
    pub fn item(number: u32) -> Child {
        Child(ITEM | number)
    }

    #[inline]
    pub fn is(self) -> Is {
        match self.0 & ITEM {
            0 => Is::Node(self.0),
            _ => Is::Item(self.0 & !ITEM),
        }
    }
}

/// Up to eight children and their boxes. `sides` has the lower sides of all boxes along each axis, and then the upper
/// sides.
#[derive(Debug, Clone)]
pub struct Node {
    pub(super) sides: [[f32x8; 3]; 2],
    pub children: [Child; WIDTH],
}

impl Node {
    /// A node without children, whose boxes no ray meets.
    const EMPTY: Node = Node {
        sides: [
            [f32x8::new([f32::MAX; WIDTH]); 3],
            [f32x8::new([f32::MIN; WIDTH]); 3],
        ],
        children: [Child::NONE; WIDTH],
    };

    fn put(&mut self, slot: usize, bounds: &Aabb, child: Child) {
        let [lower, upper] = &mut self.sides;
        for i in 0..3 {
            lower[i].as_mut_array()[slot] = below(bounds.min[i]);
            upper[i].as_mut_array()[slot] = above(bounds.max[i]);
        }
        self.children[slot] = child;
    }
}

/// The greatest single that is not above a double.
pub fn below(x: f64) -> f32 {
    let y = x as f32;
    if f64::from(y) > x { y.next_down() } else { y }
}

/// The least single that is not below a double.
pub fn above(x: f64) -> f32 {
    let y = x as f32;
    if f64::from(y) < x { y.next_up() } else { y }
}

/// The least power of two above a number, and its reciprocal; `None` where one of them is no normal number.
#[inline]
pub(super) fn power(above: f64) -> Option<(f64, f64)> {
    const MANTISSA: u32 = f64::MANTISSA_DIGITS - 1;
    let exponent = above.to_bits() >> MANTISSA;
    let of = |exponent: u64| f64::from_bits(exponent << MANTISSA);
    (0 < exponent && exponent < 2044).then(|| (of(exponent + 1), of(2045 - exponent)))
}

/// The origin and the unit of the coordinates of a tree's boxes.
#[derive(Debug, Clone, Copy, Default)]
pub struct Frame {
    /// The largest absolute value of a coordinate of the boxes.
    reach: f64,
    pub(super) centre: Vec3,
    /// The unit, a power of two; `per_unit` is its reciprocal. Both are 0 if there is no such number; a beam then meets
    /// all boxes.
    pub(super) unit: f64,
    pub(super) per_unit: f64,
}

impl Frame {
    /// The frame around finite boxes.
    pub fn around<'a>(boxes: impl Iterator<Item = &'a Aabb>) -> Frame {
        let all = boxes.fold(Aabb::EMPTY, |all, b| all.hull(b));
        if all.is_empty() {
            return Frame::default();
        }
        let half = all.extent().into_iter().fold(0.0, f64::max) / 2.0;
        let (unit, per_unit) = power(half).unwrap_or_default();
        Frame {
            reach: all.reach(),
            centre: Vec3(all.centre()),
            unit,
            per_unit,
        }
    }

    fn scaled(&self, b: &Aabb) -> Aabb {
        let scaled = |p: [f64; 3]| each([0, 1, 2], |i| (p[i] - self.centre[i]) * self.per_unit);
        Aabb::new(scaled(b.min), scaled(b.max))
    }
}

/// A node of the binary tree, or a part of one of its leaves, that becomes a child of a wide node.
#[derive(Clone, Copy)]
enum BvhChild {
    /// An inner node.
    Inner(u32),
    /// A range of the items of a leaf, with the box of all items of the leaf.
    Items { leaf: u32, start: u32, end: u32 },
}

impl BvhChild {
    fn of(bvh: &Bvh, node: u32) -> BvhChild {
        let here = &bvh.nodes[node as usize];
        match here.count {
            0 => BvhChild::Inner(node),
            count => BvhChild::Items {
                leaf: node,
                start: here.index,
                end: here.index + count,
            },
        }
    }

    fn bounds(self, bvh: &Bvh) -> &Aabb {
        let (BvhChild::Inner(node) | BvhChild::Items { leaf: node, .. }) = self;
        &bvh.nodes[node as usize].bounds
    }

    /// The two halves of the child; `None` for a single item.
    fn halves(self, bvh: &Bvh) -> Option<[BvhChild; 2]> {
        match self {
            BvhChild::Inner(node) => {
                let right = bvh.nodes[node as usize].index;
                Some([node + 1, right].map(|child| BvhChild::of(bvh, child)))
            }
            BvhChild::Items { leaf, start, end } => (end - start > 1).then(|| {
                let middle = start.midpoint(end);
                [(start, middle), (middle, end)].map(|(start, end)| BvhChild::Items {
                    leaf,
                    start,
                    end,
                })
            }),
        }
    }
}

/// The number of items below each node of a binary tree.
fn sizes(bvh: &Bvh) -> Vec<u32> {
    let mut sizes = vec![0; bvh.nodes.len()];
    // Children stand behind their parents.
    for (at, node) in bvh.nodes.iter().enumerate().rev() {
        sizes[at] = match node.count {
            0 => sizes[at + 1] + sizes[node.index as usize],
            count => count,
        };
    }
    sizes
}

/// Divides a piece of the binary tree into up to eight pieces.
///
/// The piece with the largest box is halved again and again. Pieces whose items fit into one node are left out: a node
/// takes as much memory with two children as with eight. The slots that are left then go to the single items of such
/// pieces, those of the piece with the largest box first.
fn children(bvh: &Bvh, sizes: &[u32], whole: BvhChild) -> Vec<BvhChild> {
    let size = |piece: &BvhChild| match *piece {
        BvhChild::Inner(node) => sizes[node as usize] as usize,
        BvhChild::Items { start, end, .. } => (end - start) as usize,
    };
    let area = |piece: &BvhChild| piece.bounds(bvh).half_area();
    let largest = |pieces: &[BvhChild], is_meant: &dyn Fn(usize) -> bool| {
        let meant = (0..pieces.len()).filter(|&at| is_meant(size(&pieces[at])));
        meant.max_by(|&a, &b| area(&pieces[a]).total_cmp(&area(&pieces[b])))
    };
    let mut pieces = vec![whole];
    let halve = |pieces: &mut Vec<BvhChild>, at: usize| {
        if let Some([left, right]) = pieces[at].halves(bvh) {
            pieces[at] = left;
            pieces.push(right);
        }
    };
    while pieces.len() < WIDTH
        && let Some(at) = largest(&pieces, &|size| size > WIDTH)
    {
        halve(&mut pieces, at);
    }
    while let Some(at) = largest(&pieces, &|size| {
        (2..=WIDTH + 1 - pieces.len()).contains(&size)
    }) {
        let mut items = vec![pieces.swap_remove(at)];
        while let Some(at) = largest(&items, &|size| size > 1) {
            halve(&mut items, at);
        }
        pieces.append(&mut items);
    }
    pieces
}

/// A tree of wide nodes. The root is node 0; there are no nodes if there are no items.
#[derive(Debug, Default)]
pub struct Tree {
    pub nodes: Vec<Node>,
}

impl Tree {
    /// Builds the tree over items with finite boxes. The items have numbers below 2³¹ − 1, and the frame is around the
    /// boxes.
    pub fn new(boxes: Vec<(u32, Aabb)>, frame: &Frame) -> Tree {
        let scaled = boxes.into_iter().map(|(item, b)| (item, frame.scaled(&b)));
        let bvh = Bvh::with_leaves(scaled.collect(), 1);
        let sizes = sizes(&bvh);
        let mut nodes = Vec::new();
        let mut pending = Vec::new();
        if !bvh.nodes.is_empty() {
            nodes.push(Node::EMPTY);
            pending.push((0, BvhChild::of(&bvh, 0)));
        }
        while let Some((here, whole)) = pending.pop() {
            for (slot, piece) in children(&bvh, &sizes, whole).into_iter().enumerate() {
                let child = match piece {
                    BvhChild::Items { start, end, .. } if end - start == 1 => {
                        Child::item(bvh.items[start as usize])
                    }
                    _ => {
                        let below = nodes.len();
                        nodes.push(Node::EMPTY);
                        pending.push((below, piece));
                        Child(below as u32)
                    }
                };
                nodes[here].put(slot, piece.bounds(&bvh), child);
            }
        }
        nodes.shrink_to_fit();
        Tree { nodes }
    }

    /// All items, in the order of the tree.
    pub fn items(&self) -> impl Iterator<Item = u32> + '_ {
        self.slots().map(|(_, _, item)| item)
    }

    /// All items, each with a box that holds the item's own box, up to a rounding. The frame is the one with which the
    /// tree was built.
    pub fn boxes(&self, frame: &Frame) -> impl Iterator<Item = (u32, Aabb)> + '_ {
        let Frame { centre, unit, .. } = *frame;
        self.slots().map(move |(node, slot, item)| {
            let [min, max] = each([0, 1], |side: usize| {
                let at = |i: usize| f64::from(node.sides[side][i].to_array()[slot]);
                each([0, 1, 2], |i| centre[i] + at(i) * unit)
            });
            (item, Aabb { min, max })
        })
    }

    /// All items, each with its node and its slot there.
    fn slots(&self) -> impl Iterator<Item = (&Node, usize, u32)> + '_ {
        let all = self
            .nodes
            .iter()
            .flat_map(|node| (0..WIDTH).map(move |slot| (node, slot)));
        all.filter_map(|(node, slot)| match node.children[slot] {
            Child::NONE => None,
            child => match child.is() {
                Is::Item(item) => Some((node, slot, item)),
                Is::Node(_) => None,
            },
        })
    }
}

/// A line that is tested against the boxes of a tree, in single precision. Its origin is moved by as much as it may be
/// off: forwards in `enter`, for the sides by which the line enters a box, and backwards in `leave`.
#[derive(Debug, Clone, Copy)]
pub struct Beam {
    enter: [f32; 3],
    leave: [f32; 3],
    inverse: [f32; 3],
    /// For each axis, whether the line comes from above.
    falls: [bool; 3],
    /// Whether single precision cannot hold the numbers: then all boxes are met.
    lost: bool,
    /// The factor from the line's parameter of a point to the beam's: a power of two.
    pace: f64,
    /// The reciprocal of `pace`.
    unpace: f64,
}

/// Twice the relative error of a parameter: the difference, the product, the direction and its reciprocal are rounded
/// once each.
pub(super) const PARAMETER_REL_ERROR: f32 = 8.0 * (f32::EPSILON / 2.0);

/// The least component of a direction, as a share of the largest. Smaller components are replaced by it.
pub(super) const MIN_DIRECTION_COMPONENT: f32 = f32::from_bits((127 - 100) << 23);
/// The uncertainty of the origin along an axis with such a small component: the other components take a line far out of
/// the tree before it has moved this far along that axis.
pub(super) const STILL: f32 = f32::from_bits((127 - 40) << 23);
/// The largest distance of an origin, in units of the tree. Beyond it single precision tells nothing.
pub(super) const MAX_ORIGIN_DISTANCE: f64 = (1u64 << 50) as f64;

impl Beam {
    /// A beam that meets all boxes.
    const LOST: Beam = Beam {
        enter: [0.0; 3],
        leave: [0.0; 3],
        inverse: [1.0; 3],
        falls: [false; 3],
        lost: true,
        pace: 1.0,
        unpace: 1.0,
    };

    /// The beam of a line, for the trees of a frame.
    #[inline(always)]
    pub fn new(line: &Line, frame: &Frame) -> Beam {
        if frame.unit == 0.0 {
            return Beam::LOST;
        }
        let Some((size, per_size)) = power(line.direction.abs().max_component()) else {
            return Beam::LOST;
        };
        // Lengths are in units of the frame and directions in units of their size, so the beam's parameter is t times
        // `pace`.
        let (pace, unpace) = (size * frame.per_unit, frame.unit * per_size);
        let origin = (line.origin - frame.centre) * frame.per_unit;
        let direction = line.direction * per_size;
        let drift = line.drift(frame.reach) * frame.per_unit;
        let near = origin.abs().max_component() + drift < MAX_ORIGIN_DISTANCE && line.is_sound();
        if !(near && pace.is_normal() && unpace.is_normal()) {
            return Beam::LOST;
        }
        let lanes = |v: Vec3| f32x4::new([v[0] as f32, v[1] as f32, v[2] as f32, 0.0]);
        let (o, d) = (lanes(origin), lanes(direction));
        // Twice the half unit in the last place of o and of the sums below, then the drift, then more than is lost
        // where numbers underflow.
        let off = o.abs() * f32x4::splat(2.0 * f32::EPSILON)
            + f32x4::splat(drift as f32 * 1.001)
            + f32x4::splat(MIN_DIRECTION_COMPONENT);
        let still = d.abs().simd_lt(f32x4::splat(MIN_DIRECTION_COMPONENT));
        let off = off + (still & f32x4::splat(STILL));
        let d = still.select(f32x4::splat(MIN_DIRECTION_COMPONENT).copysign(d), d);
        let forth = off.copysign(d);
        let three = |lanes: f32x4| {
            let [x, y, z, _] = lanes.to_array();
            [x, y, z]
        };
        Beam {
            enter: three(o + forth),
            leave: three(o - forth),
            inverse: three(f32x4::ONE / d),
            falls: each(three(d), |d| d < 0.0),
            lost: false,
            pace,
            unpace,
        }
    }

    /// Converts a parameter of the line to one of the beam.
    #[inline]
    pub fn pace(&self, t: f64) -> f32 {
        (t * self.pace) as f32
    }

    /// Converts a parameter of the beam to one of the line.
    #[inline]
    pub fn unpace(&self, t: f32) -> f64 {
        f64::from(t) * self.unpace
    }

    /// The boxes of a node, a bit each, that the line may meet at a parameter of the beam in [from, to]. For each box a
    /// lower bound on the parameter at which the line enters it comes with them.
    ///
    /// A parameter has four rounded operations behind it, and the ends are widened by twice as much, so that no box
    /// that the exact line meets is missed (Ize, "Robust BVH Ray Traversal", JCGT 2(2), 2013).
    #[inline]
    pub fn meets(&self, node: &Node, from: f32, to: f32) -> (u32, [f32; WIDTH]) {
        if self.lost {
            return self.all(node, from);
        }
        let (mut near, mut far) = (f32x8::splat(from), f32x8::splat(to));
        for i in 0..3 {
            let [entered, left] = each([self.falls[i], !self.falls[i]], |upper| {
                &node.sides[usize::from(upper)][i]
            });
            let inverse = f32x8::splat(self.inverse[i]);
            near = near.fast_max((*entered - f32x8::splat(self.enter[i])) * inverse);
            far = far.fast_min((*left - f32x8::splat(self.leave[i])) * inverse);
        }
        near *= f32x8::splat(1.0 - PARAMETER_REL_ERROR);
        far *= f32x8::splat(1.0 + PARAMETER_REL_ERROR);
        (near.simd_le(far).to_bitmask(), near.to_array())
    }

    /// The child that the line enters first, with the bound that [`meets`](Self::meets) gives. The other children that
    /// the line meets go to `others`, in no order. Among equally near children the last one counts as first. `None` if
    /// the line meets no child.
    #[inline(always)]
    pub fn first(
        &self,
        node: &Node,
        [from, to]: [f32; 2],
        mut others: impl FnMut(f32, Child),
    ) -> Option<(f32, Child)> {
        let (mut met, near) = self.meets(node, from, to);
        let mut first = None;
        while met != 0 {
            let slot = met.trailing_zeros() as usize % WIDTH;
            met &= met - 1;
            let here = (near[slot], node.children[slot]);
            first = match first {
                Some(first) if here.0 > first.0 => {
                    others(here.0, here.1);
                    Some(first)
                }
                Some((near, child)) => {
                    others(near, child);
                    Some(here)
                }
                None => Some(here),
            };
        }
        first
    }

    /// Like [`first`](Self::first), but the other children are put on a stack, the farthest first.
    #[inline(always)]
    pub fn nearest(
        &self,
        node: &Node,
        ends: [f32; 2],
        stack: &mut Vec<(f32, Child)>,
    ) -> Option<(f32, Child)> {
        let base = stack.len();
        self.first(node, ends, |near, child| {
            let mut at = stack.len();
            stack.push((near, child));
            while at > base && stack[at - 1].0 < near {
                stack[at] = stack[at - 1];
                at -= 1;
            }
            stack[at] = (near, child);
        })
    }

    #[cold]
    fn all(&self, node: &Node, from: f32) -> (u32, [f32; WIDTH]) {
        let is_there = |k: usize| u32::from(node.children[k] != Child::NONE) << k;
        ((0..WIDTH).map(is_there).sum(), [from; WIDTH])
    }
}

#[cfg(test)]
#[path = "wide_bvh_tests.rs"]
mod tests;
