//! A summary of each node and all nodes below it, which does not depend on the nodes above.

use super::unseen::LeftOut;
use crate::scene::{Node, NodeId, Optics, Scene, fold_up};

/// The properties of a node together with all nodes below it. The second value of a pair is for the node's complement.
#[derive(Clone, Copy)]
pub(super) struct Below {
    /// Whether the node holds a shape with an inside.
    pub solid: bool,
    /// Whether some part of the node is visible.
    pub shows: [bool; 2],
    /// Whether some visible part is diffuse, if no paint above changes that.
    pub lit: [bool; 2],
}

/// The summary of each node up to `root`, without the operands that are left out.
pub(super) fn below(scene: &Scene, root: NodeId, left_out: &LeftOut) -> Vec<Below> {
    fold_up(scene.up_to(root), |i, node, all: &[Below]| {
        let of = |n: NodeId| all[n as usize];
        match node {
            Node::Shape(shape) => Below {
                solid: scene.shapes[shape as usize].geometry.is_solid(),
                shows: [true; 2],
                lit: [Optics::default().kd != [0.0; 3]; 2],
            },
            Node::Union(a, b) => Below {
                solid: of(a).solid || of(b).solid,
                shows: [0, 1].map(|turned| left_out.kept(i, [a, b]).any(|n| of(n).shows[turned])),
                lit: [0, 1].map(|turned| left_out.kept(i, [a, b]).any(|n| of(n).lit[turned])),
            },
            Node::Intersection(a, b) => Below {
                solid: of(a).solid || of(b).solid,
                shows: [0, 1].map(|turned| of(a).shows[turned] || of(b).shows[turned]),
                lit: [0, 1].map(|turned| of(a).lit[turned] || of(b).lit[turned]),
            },
            // The solid that is taken away is not visible; −(A − B) is −A ∪ B.
            Node::Difference(a, b) => Below {
                solid: of(a).solid || of(b).solid,
                shows: [of(a).shows[0], of(a).shows[1] || of(b).shows[0]],
                lit: [of(a).lit[0], of(a).lit[1] || of(b).lit[0]],
            },
            // The complement of a surface is all of space.
            Node::Complement(child) => Below {
                solid: true,
                shows: [of(child).shows[1], of(child).shows[0]],
                lit: [of(child).lit[1], of(child).lit[0]],
            },
            Node::Transform { child, .. } | Node::Copy { child, .. } => of(child),
            Node::Paint { child, paint } => match scene.paints[paint as usize].optics {
                Some(optics) => Below {
                    lit: of(child).shows.map(|shows| shows && optics.kd != [0.0; 3]),
                    ..of(child)
                },
                None => of(child),
            },
        }
    })
}
