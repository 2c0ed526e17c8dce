//! The union of many solids: what lies apart is left alone, the rest is joined two by two, neighbours
//! first.

use rayon::prelude::*;

use super::budget::{Budget, Crowd};
use super::csg::{Operation, combine};
use super::sets::Sets;
use super::shape::DROPPED;
use super::soup::Mesh;
use crate::scene::Aabb;
use crate::trace::bounds::Bounds;
use crate::trace::bvh::Bvh;

/// Closed meshes that lie apart from each other, with their bounds.
#[derive(Debug, Default)]
pub struct Union {
    pub meshes: Vec<(Aabb, Mesh)>,
    /// How many times two that overlap could not be joined and are both there.
    pub failures: u64,
}

impl Union {
    /// Joins closed meshes. The order matters only to faces in one place: those of the first are kept.
    ///
    /// # Errors
    /// Too many overlap.
    pub fn of(meshes: Vec<Mesh>, budget: &mut Budget) -> Result<Union, Crowd> {
        let boxes: Vec<Aabb> = meshes.iter().map(Mesh::bounds).collect();
        let tree = Bvh::new(
            boxes
                .iter()
                .enumerate()
                .map(|(i, b)| (i as u32, bounds(b)))
                .collect(),
        );
        let mut sets = Sets::new(meshes.len());
        for (i, b) in boxes.iter().enumerate() {
            visit(&tree, &bounds(b), |j| {
                if b.overlaps(&boxes[j as usize]) {
                    sets.join(i as u32, j);
                }
            });
        }
        let mut meshes: Vec<Option<Mesh>> = meshes.into_iter().map(Some).collect();
        let mut groups: Vec<Vec<Member>> = Vec::new();
        let mut group_of: Vec<Option<usize>> = vec![None; meshes.len()];
        // In the order of the tree, in which neighbours are near each other.
        for &i in &tree.items {
            let Some(mesh) = meshes[i as usize].take().filter(|m| !m.is_empty()) else {
                continue;
            };
            let set = sets.find(i) as usize;
            let group = *group_of[set].get_or_insert_with(|| {
                groups.push(Vec::new());
                groups.len() - 1
            });
            groups[group].push(Member {
                first: i,
                bounds: boxes[i as usize],
                mesh,
            });
        }
        let mut out = Union::default();
        for group in groups {
            let joined = out.join(group, budget)?;
            out.meshes.extend(joined);
        }
        Ok(out)
    }

    /// Everything of it that may touch a box, as one mesh.
    pub fn near(&self, region: &Aabb) -> Mesh {
        let mut out = Mesh::default();
        for (bounds, mesh) in &self.meshes {
            if bounds.overlaps(region) {
                out.append(mesh);
            }
        }
        out
    }

    fn join(
        &mut self,
        mut group: Vec<Member>,
        budget: &mut Budget,
    ) -> Result<Option<(Aabb, Mesh)>, Crowd> {
        let label = |m: &Member| m.mesh.labels.iter().copied().find(|l| *l != DROPPED);
        let crowd = Crowd {
            solids: group.len(),
            label: group.iter().find_map(label).unwrap_or(0),
        };
        if group.len() > 1 && crowd.is_hopeless(group.iter().map(Member::triangles).sum()) {
            return Err(crowd);
        }
        let mut before = None;
        while group.len() > 1 {
            let triangles = group.iter().map(Member::triangles).sum();
            let rounds = group.len().next_power_of_two().ilog2();
            if before.is_some_and(|before| budget.will_not_do(before, triangles, rounds)) {
                return Err(crowd);
            }
            budget.work(triangles, crowd)?;
            before = Some(triangles);
            let mut pairs = Vec::with_capacity(group.len().div_ceil(2));
            let mut rest = group.into_iter();
            while let Some(a) = rest.next() {
                pairs.push((a, rest.next()));
            }
            let made: Vec<(Member, bool)> = (pairs.into_par_iter())
                .map(|(a, b)| match b {
                    Some(b) => a.with(b),
                    None => (a, true),
                })
                .collect();
            self.failures += made.iter().filter(|(_, joined)| !joined).count() as u64;
            group = made.into_iter().map(|(member, _)| member).collect();
        }
        Ok(group.pop().map(|m| (m.bounds, m.mesh)))
    }
}

/// A mesh to be joined with others.
struct Member {
    /// The least number of the meshes in it.
    first: u32,
    bounds: Aabb,
    mesh: Mesh,
}

impl Member {
    fn triangles(&self) -> usize {
        self.mesh.triangles.len()
    }

    /// Both, and whether they could be joined where they overlap. Of faces in one place those of the
    /// first are kept.
    fn with(self, other: Member) -> (Member, bool) {
        let (a, b) = match self.first < other.first {
            true => (self, other),
            false => (other, self),
        };
        let overlap = a.bounds.overlaps(&b.bounds);
        let joined = match overlap {
            true => combine(&a.mesh, &b.mesh, Operation::Union).ok(),
            false => None,
        };
        let success = joined.is_some() || !overlap;
        let bounds = a.bounds.hull(&b.bounds);
        let mesh = joined.unwrap_or_else(|| {
            let mut both = a.mesh;
            both.append(&b.mesh);
            both
        });
        let first = a.first;
        (
            Member {
                first,
                bounds,
                mesh,
            },
            success,
        )
    }
}

/// Which boxes overlap another one.
pub fn overlapping(boxes: &[Aabb]) -> Vec<bool> {
    let numbered = boxes.iter().enumerate();
    let tree = Bvh::new(numbered.map(|(i, b)| (i as u32, bounds(b))).collect());
    let mut out = vec![false; boxes.len()];
    for (i, b) in boxes.iter().enumerate() {
        let mut found = false;
        visit(&tree, &bounds(b), |j| {
            found |= j as usize != i && b.overlaps(&boxes[j as usize]);
        });
        out[i] = found;
    }
    out
}

/// The pairs of boxes that overlap and are wanted, in order: the second number larger, the pairs by
/// the larger and then the smaller; `None` if there are too many.
pub fn pairs(
    boxes: &[Aabb],
    most: usize,
    wanted: impl Fn(usize, usize) -> bool,
) -> Option<Vec<(usize, usize)>> {
    let numbered = boxes.iter().enumerate();
    let tree = Bvh::new(numbered.map(|(i, b)| (i as u32, bounds(b))).collect());
    let mut out = Vec::new();
    for (j, b) in boxes.iter().enumerate() {
        let start = out.len();
        visit(&tree, &bounds(b), |i| {
            let i = i as usize;
            if i < j && out.len() <= most && b.overlaps(&boxes[i]) && wanted(i, j) {
                out.push((i, j));
            }
        });
        if out.len() > most {
            return None;
        }
        out[start..].sort_unstable();
    }
    Some(out)
}

fn bounds(b: &Aabb) -> Bounds {
    Bounds::new(b.min.into(), b.max.into())
}

/// Calls for every box in the tree that overlaps one, and some of their neighbours.
fn visit(tree: &Bvh, b: &Bounds, mut found: impl FnMut(u32)) {
    let mut pending = vec![0u32];
    while let Some(i) = pending.pop() {
        let Some(node) = tree.nodes.get(i as usize) else {
            continue;
        };
        if node.bounds.intersection(b).is_empty() {
            continue;
        }
        if node.count > 0 {
            let start = node.index as usize;
            let items = &tree.items[start..start + node.count as usize];
            items.iter().for_each(|&j| found(j));
        } else {
            pending.extend([node.index, i + 1]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::shape::flat::cuboid;
    use super::*;

    #[test]
    fn a_row_of_boxes_becomes_bars() {
        // Three that overlap, two that overlap, one alone.
        let at = |x: f64| cuboid([x, 0.0, 0.0], [x + 1.0, 1.0, 1.0]);
        let row = [0.0, 10.0, 0.5, 5.0, 1.2, 5.3].map(at).to_vec();
        let union = Union::of(row, &mut Budget::default()).unwrap();
        assert_eq!(union.failures, 0);
        let mut volumes: Vec<f64> = union.meshes.iter().map(|m| m.1.volume()).collect();
        volumes.sort_by(f64::total_cmp);
        for (got, meant) in volumes.iter().zip([1.0, 1.3, 2.2]) {
            assert!((got - meant).abs() < 1e-9, "{volumes:?}");
        }
        assert!(union.meshes.iter().all(|m| m.1.is_closed()));
    }
}
