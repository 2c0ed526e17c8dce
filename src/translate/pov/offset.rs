//! Shapes whose surface lies a little outside or inside of where it is.

use super::build::Builder;
use crate::geometry::Matrix;
use crate::scene::{Node, NodeId};
use crate::solids::shapes::facts::Facts;

/// So many nodes are looked at to find out whether a solid can be made smaller.
const PATIENCE: usize = 4096;

impl Builder<'_> {
    /// Whether all shapes that a solid is made of can be moved by so much, outwards or inwards where
    /// it is negative.
    pub(super) fn has_offset(&self, node: NodeId, by: f64) -> bool {
        let mut todo = vec![(node, by)];
        for _ in 0..PATIENCE {
            let Some((node, by)) = todo.pop() else {
                return true;
            };
            match self.scene.nodes[node as usize] {
                Node::Shape(shape) => {
                    let geometry = &self.scene.shapes[shape as usize].geometry;
                    if geometry.is_solid() && geometry.offset(by).is_none() {
                        return false;
                    }
                }
                Node::Transform { child, matrix } => {
                    match stretched(&self.scene.matrices[matrix as usize]) {
                        Some(factor) => todo.push((child, by * factor)),
                        None => return false,
                    }
                }
                Node::Complement(child) => todo.push((child, -by)),
                Node::Difference(a, b) => todo.extend([(a, by), (b, -by)]),
                Node::Union(a, b) | Node::Intersection(a, b) => todo.extend([(a, by), (b, by)]),
                Node::Paint { child, .. } | Node::Copy { child, .. } => todo.push((child, by)),
            }
        }
        false
    }
}

/// A length in the scene as one in the coordinates that a matrix leads away from: where the matrix
/// stretches by several factors their mean, where these are far apart none.
pub fn stretched(m: &Matrix) -> Option<f64> {
    let squares = |m: &Matrix| {
        let rows = m.0.iter().take(3).flat_map(|row| &row[..3]);
        rows.map(|x| x * x).sum::<f64>() / 3.0
    };
    let (there, back) = (squares(m), squares(&m.inverse()?));
    // 1 for one factor in all directions.
    let uneven = there * back;
    (uneven < 16.0).then(|| back.sqrt())
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
