//! Factors by which matrices change lengths.

use crate::geometry::Matrix;
use crate::scene::{Node, NodeId, Scene};

/// For each node, the factor from lengths in the scene's coordinates to lengths in those that the node is placed in, as
/// a power of two. If the node is in several places, the largest factor counts.
pub(crate) fn stretches(scene: &Scene, root: NodeId) -> Vec<f64> {
    let mut out = vec![0.0; root as usize + 1];
    out[root as usize] = 1.0;
    for id in (0..=root as usize).rev() {
        let own: f64 = out[id];
        let below = match scene.nodes[id] {
            Node::Transform { matrix, .. } => {
                let factor = stretched(&scene.matrices[matrix as usize]).unwrap_or(1.0);
                Some(own * factor).filter(|f| f.is_finite()).unwrap_or(own)
            }
            _ => own,
        };
        for child in scene.nodes[id].children() {
            out[child as usize] = below.max(out[child as usize]);
        }
    }
    // The factor 1.9 lets a number that is just below a power of two, by rounding, become this power.
    let about = |factor: f64| match factor > 0.0 {
        true => power_of_two_about(1.9 * factor),
        false => 0.0,
    };
    out.into_iter().map(about).collect()
}

/// The factor from lengths in the coordinates that `m` maps to, to lengths in those that it maps from. It is a mean if
/// the matrix stretches by several factors. `None` if these are far apart, or the matrix has no inverse.
pub(crate) fn stretched(m: &Matrix) -> Option<f64> {
    let squares = |m: &Matrix| {
        let rows = m.0.iter().take(3).flat_map(|row| &row[..3]);
        rows.map(|x| x * x).sum::<f64>() / 3.0
    };
    let (there, back) = (squares(m), squares(&m.inverse()?));
    // 1 for one factor in all directions.
    let uneven = there * back;
    (uneven < 16.0).then(|| back.sqrt())
}

/// The largest power of two that is not above `x`; 1 if it is not between 2⁻⁹⁰⁰ and 2⁹⁰⁰.
pub(crate) fn power_of_two_about(x: f64) -> f64 {
    let exponent = x.log2().floor();
    // The bound is far within the exponents of doubles, so that neither products with the power nor its inverse
    // overflow.
    if exponent.abs() <= 900.0 {
        2f64.powi(exponent as i32)
    } else {
        1.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lengths_are_those_of_the_shape() {
        let m = Matrix::scaling(4.0, 4.0, 4.0).after(&Matrix::rotation(30.0, 1));
        let factor = stretched(&m).unwrap();
        assert!((factor - 0.25).abs() < 1e-12);
        assert_eq!(stretched(&Matrix::scaling(1.0, 1.0, 100.0)), None);
    }
}
