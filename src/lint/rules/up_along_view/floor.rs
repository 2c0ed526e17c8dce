//! The floor that a scene stands on: an endless plane, or a flat object below all others.

use rustc_hash::FxHashSet;

use crate::geometry::Aabb;
use crate::geometry::array::{length, sub};
use crate::lint::Context;
use crate::scene::{Geometry, Node, NodeId, Vec3};

/// Largest distance of a floor from the lowest point of the objects on it, as a share of the size of the objects.
const FLOOR_REL_GAP: f64 = 0.1;
/// Largest thickness of a bounded floor, as a share of its width and of its depth.
const MAX_REL_HEIGHT: f64 = 0.2;

/// A way along a coordinate axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Way {
    pub axis: usize,
    is_negative: bool,
}

impl Way {
    const Y: Way = Way {
        axis: 1,
        is_negative: false,
    };

    /// The way of a vector that lies along an axis; `None` for any other vector.
    pub(super) fn along(vector: Vec3) -> Option<Way> {
        let axis = vector.iter().position(|x| *x != 0.0)?;
        let is_alone = vector[axis + 1..].iter().all(|x| *x == 0.0);
        is_alone.then_some(Way {
            axis,
            is_negative: vector[axis] < 0.0,
        })
    }

    pub(super) fn name(self) -> String {
        let sign = if self.is_negative { "−" } else { "" };
        format!("{sign}{}", ["x", "y", "z"][self.axis])
    }

    /// The coordinates along this way at which a box begins and ends.
    fn ends(self, b: &Aabb) -> [f64; 2] {
        match self.is_negative {
            true => [-b.max[self.axis], -b.min[self.axis]],
            false => [b.min[self.axis], b.max[self.axis]],
        }
    }
}

/// The height of the floor across the y axis. `None` if there is none, or if a floor also lies across the way `taken`,
/// which a camera takes for up.
pub(super) fn floor(context: &Context, root: NodeId, taken: Way) -> Option<f64> {
    let bounds = &context.bounds()[root as usize];
    if !bounds.all.is_bounded() {
        let floor = plane(context, root)?;
        let objects = bounds.bounded();
        return stands_on(&objects, Way::Y, floor).then_some(floor);
    }
    let parts = parts(context, root);
    match flat(&parts, taken) {
        Some(_) => None,
        None => flat(&parts, Way::Y),
    }
}

fn stands_on(objects: &Aabb, way: Way, floor: f64) -> bool {
    let size = length(sub(objects.max, objects.min));
    let [lowest, _] = way.ends(objects);
    !objects.is_empty() && (lowest - floor).abs() <= FLOOR_REL_GAP * size
}

/// The height of the only endless plane or half-space in a union, if nothing moves it and it lies across the y axis.
/// `None` otherwise.
fn plane(context: &Context, root: NodeId) -> Option<f64> {
    let scene = context.scene;
    let mut floor = None;
    for node in operands(context, root) {
        match scene.nodes[node as usize] {
            Node::Shape(s) => match scene.shapes[s as usize].geometry {
                Geometry::Plane([a, b, c, d]) | Geometry::HalfSpace([a, b, c, d]) => {
                    if floor.is_some() || a != 0.0 || c != 0.0 {
                        return None;
                    }
                    floor = Some(-d / b);
                }
                _ => {}
            },
            // An endless object that is moved or cut may be a floor, too.
            _ if !context.bounds()[node as usize].all.is_finite() => return None,
            _ => {}
        }
    }
    floor
}

/// The boxes of a union's operands.
fn parts(context: &Context, root: NodeId) -> Vec<Aabb> {
    let boxes = operands(context, root)
        .into_iter()
        .map(|node| context.bounds()[node as usize].all);
    boxes.filter(|b| !b.is_empty()).collect()
}

/// The top, along `way`, of a flat object on which all others stand; `None` if there is none.
fn flat(parts: &[Aabb], way: Way) -> Option<f64> {
    let top = |b: &Aabb| way.ends(b)[1];
    let lowest = (0..parts.len()).min_by(|i, j| top(&parts[*i]).total_cmp(&top(&parts[*j])))?;
    let floor = &parts[lowest];
    let [below, above] = way.ends(floor);
    let others = (parts.iter().enumerate()).filter(|(i, _)| *i != lowest);
    let objects = others.fold(Aabb::EMPTY, |hull, (_, b)| hull.hull(b));
    let gap = FLOOR_REL_GAP * length(sub(objects.max, objects.min));
    let is_under = (0..3).filter(|i| *i != way.axis).all(|i| {
        let width = floor.max[i] - floor.min[i];
        let reaches = floor.min[i] - gap <= objects.min[i] && objects.max[i] <= floor.max[i] + gap;
        reaches && above - below <= MAX_REL_HEIGHT * width
    });
    (is_under && stands_on(&objects, way, above)).then_some(above)
}

/// The operands of a union of unions, without their paints.
fn operands(context: &Context, root: NodeId) -> Vec<NodeId> {
    let mut left = vec![root];
    let mut operands = Vec::new();
    // Each node counts once: unions of copies may have many ways to it.
    let mut seen = FxHashSet::default();
    while let Some(node) = left.pop() {
        if !seen.insert(node) {
            continue;
        }
        match context.scene.nodes[node as usize] {
            Node::Union(a, b) => left.extend([a, b]),
            Node::Paint { child, .. } => left.push(child),
            _ => operands.push(node),
        }
    }
    operands
}
