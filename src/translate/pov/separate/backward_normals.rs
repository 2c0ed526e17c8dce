//! Triangles with shading normals that turn away from the eye somewhere. POV-Ray turns such a normal round, and takes
//! the texture of the inner side there. To have light reckoned with the normal as it was, the normals are put on the
//! eye's side of the triangle, and the texture of the inner side is lit from the other side.

use std::collections::HashMap;

use crate::geometry::Matrix;
use crate::geometry::vec::Vec3 as V;
use crate::scene::{Geometry, Node, Scene, TriangleNormals, Vec3};
use crate::solids::shapes::facts::Facts as _;
use crate::translate::pov::budget::{Budget, Limit};
use crate::translate::pov::model::Model;

/// The triangles with shading normals that turn away from the eye somewhere, by shape, as far as they stand in one
/// place only. The value says whether the normals have to be turned to the eye's side.
pub(crate) fn backward(model: &Model, eye: Vec3) -> HashMap<u32, bool> {
    let (scene, facts) = (model.scene, &model.materials);
    if !(scene.shapes.iter()).any(|s| s.geometry.character().is_smooth) {
        return HashMap::new();
    }
    let eyes = mirrored(scene, V::from(eye), model.budget);
    let mut out = HashMap::new();
    let mut places: Vec<Option<Matrix>> = vec![None; facts.len()];
    if let Some(root) = places.last_mut() {
        *root = Some(Matrix::IDENTITY);
    }
    for id in (0..facts.len()).rev() {
        let Some(place) = places[id] else { continue };
        let node = scene.nodes[id];
        let below = match node {
            Node::Transform { matrix, .. } => place.after(&scene.matrices[matrix as usize]),
            _ => place,
        };
        for child in node.children() {
            if facts[child as usize].uses == 1 {
                places[child as usize] = Some(below);
            }
        }
        if let Node::Shape(shape) = node
            && let Geometry::Triangle { vertices, normals } = &scene.shapes[shape as usize].geometry
            && let Some(turn) = turns(vertices, normals, &place, &eyes)
        {
            out.insert(shape, turn);
        }
    }
    out
}

/// The eye, and its mirror images in all planes of the scene, since each may be a mirror.
fn mirrored(scene: &Scene, eye: V, budget: &Budget) -> Vec<V> {
    let planes = scene.shapes.iter().filter_map(|s| {
        let [a, b, c, d] = s.geometry.plane()?;
        let n = V::new(a, b, c);
        Some(eye - n * (2.0 * (n.dot(eye) + d) / n.dot(n)))
    });
    let mut eyes: Vec<V> = std::iter::once(eye)
        .chain(planes.filter(|p| p.is_finite()))
        .collect();
    if !budget.spend(Limit::Mirrors, eyes.len() - 1) {
        eyes.truncate(Limit::Mirrors.most() + 1);
    }
    eyes
}

/// Whether the normals of a triangle have to be turned to the eye's side. `None` if they do not turn away from the eye,
/// are not all on one side of the triangle, or are those of its plane.
fn turns(
    vertices: &[Vec3; 3],
    normals: &TriangleNormals,
    place: &Matrix,
    eyes: &[V],
) -> Option<bool> {
    let normals = match normals {
        TriangleNormals::Flat => return None,
        TriangleNormals::One(n) => [*n; 3],
        TriangleNormals::PerVertex(n) => **n,
    };
    let back = place.inverse()?;
    let points = vertices.map(|v| V::from(place.point(v)));
    // Normals are transformed by the transpose of the inverse.
    let normals = normals.map(|n| {
        let row = |j: usize| (0..3).map(|i| back.0[i][j] * n[i]).sum();
        V::new(row(0), row(1), row(2))
    });
    let flat = (points[1] - points[0]).cross(points[2] - points[0]);
    let is_before = |eye: V| flat.dot(eye - points[0]) > 0.0;
    let front = is_before(*eyes.first()?);
    let near = if front { flat } else { -flat };
    let sides = normals.map(|n| n.dot(near) > 0.0);
    if sides != [sides[0]; 3] {
        return None;
    }
    let sign = if sides[0] { 1.0 } else { -1.0 };
    // The normals are checked at the corners, the midpoints of the sides, and the centre.
    let weights = [
        [1., 0., 0.],
        [0., 1., 0.],
        [0., 0., 1.],
        [0.5, 0.5, 0.],
        [0., 0.5, 0.5],
        [0.5, 0., 0.5],
        [0.3; 3],
    ];
    let any = weights.iter().any(|w| {
        let total: f64 = w.iter().sum();
        let mix = |all: &[V; 3]| (0..3).fold(V::ZERO, |sum, i| sum + all[i] * (w[i] / total));
        let (point, normal) = (mix(&points), mix(&normals) * sign);
        let mut seen = eyes.iter().filter(|e| is_before(**e) == front);
        seen.any(|e| normal.dot(point - *e) > 0.0)
    });
    any.then_some(!sides[0])
}

/// A triangle with its shading normals turned to the other side; `None` for other shapes.
pub(crate) fn with_normals_turned(geometry: &Geometry) -> Option<Geometry> {
    let Geometry::Triangle { vertices, normals } = geometry else {
        return None;
    };
    let back = |n: Vec3| n.map(|x| -x);
    let normals = match normals {
        TriangleNormals::Flat => TriangleNormals::Flat,
        TriangleNormals::One(n) => TriangleNormals::One(back(*n)),
        TriangleNormals::PerVertex(n) => TriangleNormals::PerVertex(Box::new(n.map(back))),
    };
    Some(Geometry::Triangle {
        vertices: vertices.clone(),
        normals,
    })
}
