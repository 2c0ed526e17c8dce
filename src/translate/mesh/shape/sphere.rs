//! Spheres: an icosahedron with its facets divided.

use std::collections::HashMap;

use super::super::budget::{Budget, TooMany};
use super::super::triangle_mesh::Mesh;
use crate::geometry::array::length;
use crate::geometry::icosahedron;
use crate::scene::Vec3;

/// The circumradius of an icosahedron's facet, divided by the facet's distance from the centre.
const FACET: f64 = 0.763_932_022_500_210_3;

/// The unit sphere as triangles whose corners lie on it; the sphere is nowhere farther than `tolerance` from them.
pub(super) fn sphere(tolerance: f64, budget: &mut Budget) -> Result<Mesh, TooMany> {
    // A triangle whose corners are at an angle ρ from its middle, as seen from the centre, is 1 − cos ρ below the
    // sphere there. The largest triangles are at the middle of an icosahedron's facet, where the facet is nearest to
    // the centre.
    let widest = (1.0 - tolerance.min(0.5)).acos().tan();
    let divisions = (FACET / widest).ceil().max(1.0);
    budget.spend(20.0 * divisions * divisions)?;
    Ok(divided(divisions as u32))
}

/// The unit sphere as an icosahedron with each edge divided into `n` parts.
fn divided(n: u32) -> Mesh {
    let mut mesh = Mesh {
        points: icosahedron::vertices().into(),
        ..Mesh::default()
    };
    let mut edges: HashMap<(u32, u32), u32> = HashMap::new();
    for face in icosahedron::FACES {
        let face = face.map(|i| i as u32);
        let at = face.map(|i| mesh.points[i as usize]);
        // The index of the point that is i parts from the first corner, and from there j parts towards the third.
        let mut rows: Vec<Vec<u32>> = Vec::with_capacity(n as usize + 1);
        for i in 0..=n {
            let mut row = Vec::with_capacity(i as usize + 1);
            for j in 0..=i {
                let weights = [n - i, i - j, j];
                row.push(match weights {
                    [_, 0, 0] => face[0],
                    [0, _, 0] => face[1],
                    [0, 0, _] => face[2],
                    [a, b, 0] => on_edge(&mut mesh, &mut edges, [face[0], face[1]], [a, b]),
                    [a, 0, c] => on_edge(&mut mesh, &mut edges, [face[0], face[2]], [a, c]),
                    [0, b, c] => on_edge(&mut mesh, &mut edges, [face[1], face[2]], [b, c]),
                    _ => mesh.point(pushed_out(&at, &weights)),
                });
            }
            rows.push(row);
        }
        for i in 0..n as usize {
            for j in 0..=i {
                mesh.triangle([rows[i][j], rows[i + 1][j], rows[i + 1][j + 1]]);
                if j < i {
                    mesh.triangle([rows[i][j], rows[i + 1][j + 1], rows[i][j + 1]]);
                }
            }
        }
    }
    mesh
}

/// The index of a point on an edge of the icosahedron, with the weights of the edge's ends. Two facets need the
/// points of an edge: the first that asks makes them all.
fn on_edge(
    mesh: &mut Mesh,
    edges: &mut HashMap<(u32, u32), u32>,
    [a, b]: [u32; 2],
    [of_a, of_b]: [u32; 2],
) -> u32 {
    let n = of_a + of_b;
    let (low, high, steps) = if a < b { (a, b, of_b) } else { (b, a, of_a) };
    let start = *edges.entry((low, high)).or_insert_with(|| {
        let ends = [low, high].map(|i| mesh.points[i as usize]);
        let start = mesh.points.len() as u32;
        mesh.points
            .extend((1..n).map(|k| pushed_out(&ends, &[n - k, k])));
        start
    });
    start + steps - 1
}

fn pushed_out(points: &[Vec3], weights: &[u32]) -> Vec3 {
    let mut sum = [0.0; 3];
    for (p, w) in points.iter().zip(weights) {
        for (s, x) in sum.iter_mut().zip(p) {
            *s += x * f64::from(*w);
        }
    }
    unit(sum)
}

fn unit(v: Vec3) -> Vec3 {
    let length = length(v);
    v.map(|x| x / length)
}

/// The geodesic sphere of radius 1, whose facets are exact: each facet is divided into four, `splits` times.
pub(super) fn geodesic(splits: u32, budget: &mut Budget) -> Result<Mesh, TooMany> {
    budget.spend(20.0 * 4f64.powi(splits as i32))?;
    let mut mesh = divided(1);
    for _ in 0..splits {
        let mut finer = Mesh {
            points: std::mem::take(&mut mesh.points),
            ..Mesh::default()
        };
        let mut middles: HashMap<(u32, u32), u32> = HashMap::new();
        for &[a, b, c] in &mesh.triangles {
            let mut middle = |i: u32, j: u32| {
                *middles.entry((i.min(j), i.max(j))).or_insert_with(|| {
                    let ends = [i.min(j), i.max(j)].map(|k| finer.points[k as usize]);
                    finer.point(pushed_out(&ends, &[1, 1]))
                })
            };
            let [ab, bc, ca] = [middle(a, b), middle(b, c), middle(c, a)];
            for t in [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]] {
                finer.triangle(t);
            }
        }
        mesh = finer;
    }
    Ok(mesh)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_division_is_closed_and_near() {
        for n in 1..7 {
            let mesh = divided(n);
            assert!(mesh.is_closed());
            assert_eq!(mesh.triangles.len(), 20 * (n * n) as usize);
            assert_eq!(mesh.points.len(), 10 * (n * n) as usize + 2);
        }
        for tolerance in [0.1, 0.01, 0.001] {
            let mesh = sphere(tolerance, &mut Budget::default()).unwrap();
            for t in 0..mesh.triangles.len() {
                let [a, b, c] = mesh.corners(t);
                let m: Vec3 = std::array::from_fn(|i| (a[i] + b[i] + c[i]) / 3.0);
                let sunk = 1.0 - length(m);
                assert!((0.0..=tolerance).contains(&sunk), "{sunk} {tolerance}");
            }
        }
    }

    #[test]
    fn the_geodesic_sphere_has_the_facets_of_the_language() {
        let mesh = geodesic(2, &mut Budget::default()).unwrap();
        assert!(mesh.is_closed());
        assert_eq!(mesh.triangles.len(), 320);
        // Not the same as dividing the edges in four and pushing out at once.
        assert!((mesh.volume() - divided(4).volume()).abs() > 1e-6);
        assert!(mesh.volume() > 3.9 && mesh.volume() < 4.19);
    }
}
