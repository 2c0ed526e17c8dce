//! W322: lengths in one object that differ too much for its numbers.

mod sizes;

use crate::diagnostics::{Code, Diagnostic, Span, Value};
use crate::geometry::Matrix;
use crate::lint::spelling::rough;
use crate::lint::{Context, live_nodes};
use crate::scene::{Geometry, Node, Shape};
use sizes::{Length, Sizes};

/// The largest ratio of two lengths. Half of the sixteen digits of a double are then left for the smaller length. Its
/// square, which every curved surface needs, has no digit left.
const RATIO_MAX: f64 = 1e8;

const AXES: [&str; 3] = ["x", "y", "z"];

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let scene = context.scene;
    let mut spoken = vec![false; scene.shapes.len()];
    for (i, (shape, span)) in scene.written_shapes().enumerate() {
        if let Some((small, large)) = extremes(&shape.geometry, &Matrix::IDENTITY) {
            spoken[i] = true;
            out.push(finding(context, (shape, span), small, large));
        }
    }
    // The lengths of a shape may also differ too much only after a transformation.
    if scene.matrices.is_empty() {
        return;
    }
    for (node, _) in scene.nodes.iter().zip(live_nodes(scene)).filter(|n| n.1) {
        if let Node::Transform { child, matrix } = *node
            && let Node::Shape(s) = scene.nodes[child as usize]
            && !spoken[s as usize]
            && let Some((small, large)) = extremes(
                &scene.shapes[s as usize].geometry,
                &scene.matrices[matrix as usize],
            )
        {
            spoken[s as usize] = true;
            let shape = &scene.shapes[s as usize];
            let span = scene.origins[child as usize].span;
            let finding = finding(context, (shape, span), small, large);
            out.push(match (small.axis, large.axis) {
                (Some(s), Some(l)) => finding
                    .case("stretched")
                    .with("small-axis", AXES[s])
                    .with("large-axis", AXES[l]),
                _ => finding.case("moved"),
            });
        }
    }
}

fn finding(
    context: &Context,
    (shape, span): (&Shape, Span),
    small: Length,
    large: Length,
) -> Diagnostic {
    let params = context.params(span);
    let span = params.map_or(span, |p| p.span_of(0, p.len()));
    Diagnostic::new(Code::W322, span)
        .with("type", Value::Term(shape.ty().title))
        .with("id", shape.id.to_string())
        .with("large", Value::Term(large.what))
        .with("large-size", Value::Decimal(rough(large.size)))
        .with("small", Value::Term(small.what))
        .with("small-size", Value::Decimal(rough(small.size)))
}

/// The smallest and the largest length of a shape that is moved by a matrix, if their ratio is above [`RATIO_MAX`].
fn extremes(geometry: &Geometry, m: &Matrix) -> Option<(Length, Length)> {
    if let (Geometry::Sphere { centre, radius }, true) = (geometry, m.is_translation()) {
        // Largest coordinate of a sphere's centre, in radii, up to which no lengths are compared: nearly all spheres
        // end here.
        const MAX_CENTRE_RADII: f64 = RATIO_MAX / 2.0;
        if *radius > 0.0
            && m.point(*centre)
                .iter()
                .all(|x| x.abs() < MAX_CENTRE_RADII * radius)
        {
            return None;
        }
    }
    let mut small: Option<Length> = None;
    let mut large: Option<Length> = None;
    let mut take = |length: Length| {
        // Another rule reports a length of zero.
        if length.size > 0.0 && length.size.is_finite() {
            if small.is_none_or(|s| length.size < s.size) {
                small = Some(length);
            }
            if large.is_none_or(|l| length.size > l.size) {
                large = Some(length);
            }
        }
    };
    geometry.sizes(&mut Sizes::new(m, &mut take));
    let (small, mut large) = (small?, large?);
    // The distance from the origin counts as a length too, but never as the small one.
    if let Some(p) = geometry.place() {
        let [x, y, z] = m.point(p);
        let size = x.hypot(y).hypot(z);
        if size.is_finite() && size > large.size {
            let what = "its distance from the origin";
            large = Length {
                size,
                what,
                axis: None,
            };
        }
    }
    (large.size / small.size > RATIO_MAX).then_some((small, large))
}
