//! What rules about geometry share: the scene with every shape in its place, and tests of points.

pub mod field;
pub mod inside;
pub mod leaf;
pub mod meeting;
pub mod points;
pub mod proofs;
pub mod reach;
pub mod tips;
pub mod tree;
pub mod ways;

use crate::scene::{NodeId, Scene};
pub use crate::solids::{Named, distance, named, operation_of};

/// What is drawn; without a render record all objects that are part of no other.
pub fn roots(scene: &Scene, live: &[bool]) -> Vec<NodeId> {
    if let Some(render) = &scene.render {
        return vec![render.root];
    }
    let mut part = vec![false; scene.nodes.len()];
    for (node, _) in scene.nodes.iter().zip(live).filter(|n| *n.1) {
        for child in node.children().into_iter().flatten() {
            part[child as usize] = true;
        }
    }
    let tops = (0..scene.nodes.len()).filter(|&i| live[i] && !part[i]);
    tops.map(|i| i as NodeId).collect()
}

/// A coordinate of a place on something of a size: to a thousandth of that, so that the place named
/// is still there.
pub fn near(x: f64, size: f64) -> String {
    let digits = if size.is_finite() && size > 0.0 {
        3 - size.log10().floor() as i32
    } else {
        3
    };
    if !(0..=12).contains(&digits) {
        let rounded = format!("{x:.9e}").parse().unwrap_or(x);
        return format!("{rounded}");
    }
    let text = format!("{x:.precision$}", precision = digits as usize);
    let text = match text.split_once('.') {
        Some(_) => text.trim_end_matches('0').trim_end_matches('.'),
        None => &text,
    };
    if text == "-0" {
        "0".into()
    } else {
        text.into()
    }
}
