//! The union of many solids. Solids that lie apart are left alone; the others are joined two by two, neighbours
//! first.

use std::ops::ControlFlow;

use super::budget::{Budget, Crowd};
use super::csg::{Operation, combine};
use super::overlap_components::{OverlapComponents, tree};
use super::shape::DROPPED;
use super::triangle_mesh::Mesh;
use crate::geometry::Aabb;
use crate::parallel;

/// Closed meshes that lie apart from each other, with their bounds.
#[derive(Debug, Default)]
pub(super) struct Union {
    pub meshes: Vec<(Aabb, Mesh)>,
    /// The number of overlapping pairs that could not be joined; both meshes are there, then.
    pub failures: u64,
}

impl Union {
    /// Joins closed meshes. The order of the meshes matters only where faces are in one place: the first mesh's faces
    /// are kept.
    ///
    /// # Errors
    /// Too many meshes overlap.
    pub(super) fn of(meshes: Vec<Mesh>, budget: &mut Budget) -> Result<Union, Crowd> {
        let boxes: Vec<Aabb> = meshes.iter().map(Mesh::bounds).collect();
        let components = OverlapComponents::of(&boxes);
        let mut meshes: Vec<Option<Mesh>> = meshes.into_iter().map(Some).collect();
        let mut groups: Vec<Vec<Member>> = Vec::new();
        groups.resize_with(components.count, Vec::new);
        // The tree's order puts neighbours near each other, also within a group.
        for &i in &components.tree.items {
            let Some(mesh) = meshes[i as usize].take().filter(|m| !m.is_empty()) else {
                continue;
            };
            groups[components.numbers[i as usize] as usize].push(Member {
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

    /// The part of the union that may touch a box, as one mesh.
    pub(super) fn near(&self, region: &Aabb) -> Mesh {
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
        let triangles = |group: &[Member]| group.iter().map(Member::triangles).sum::<usize>();
        if group.len() > 1 && crowd.is_hopeless(triangles(&group)) {
            return Err(crowd);
        }
        let mut left = trial(&group);
        while group.len() > 1 {
            let before = triangles(&group);
            let rounds = group.len().next_power_of_two().ilog2();
            if !left.is_empty() && budget.will_not_do(before, &left, rounds) {
                return Err(crowd);
            }
            budget.work(before, crowd)?;
            let (joined, failures) = round(group);
            self.failures += failures;
            left = vec![triangles(&joined) as f64 / before.max(1) as f64];
            group = joined;
        }
        Ok(group.pop().map(|m| (m.bounds, m.mesh)))
    }
}

/// One round of joining: unites the first member with the second, the third with the fourth, and so on. Returns the
/// members that are left and how many pairs could not be joined.
fn round(group: Vec<Member>) -> (Vec<Member>, u64) {
    let mut pairs = Vec::with_capacity(group.len().div_ceil(2));
    let mut rest = group.into_iter();
    while let Some(a) = rest.next() {
        pairs.push((a, rest.next()));
    }
    let made = parallel::map_each(pairs, |(a, b)| match b {
        Some(b) => a.with(b),
        None => (a, true),
    });
    let failures = made.iter().filter(|(_, joined)| !joined).count() as u64;
    (made.into_iter().map(|(m, _)| m).collect(), failures)
}

/// The number of blocks in a sample of a group.
const SAMPLE_BLOCKS: usize = 16;
/// The number of members in a block: neighbours in the group.
const MEMBERS_PER_BLOCK: usize = 16;
/// The least number of members of a group that is sampled before it is joined.
const MIN_MEMBERS_TO_SAMPLE: usize = 4 * SAMPLE_BLOCKS * MEMBERS_PER_BLOCK;

/// Estimates which share of a group's triangles each of the first rounds will leave, from a sample. Empty for a small
/// group, whose first round takes no longer than a sample.
fn trial(group: &[Member]) -> Vec<f64> {
    if group.len() < MIN_MEMBERS_TO_SAMPLE {
        return Vec::new();
    }
    let last = group.len() - MEMBERS_PER_BLOCK;
    let mut blocks: Vec<Vec<Member>> = (0..SAMPLE_BLOCKS)
        .map(|i| group[i * last / (SAMPLE_BLOCKS - 1)..][..MEMBERS_PER_BLOCK].to_vec())
        .collect();
    let triangles = |blocks: &[Vec<Member>]| blocks.iter().flatten().map(Member::triangles).sum();
    let mut before: usize = triangles(&blocks);
    (0..MEMBERS_PER_BLOCK.ilog2())
        .map(|_| {
            blocks = parallel::map_each(std::mem::take(&mut blocks), |block| round(block).0);
            let after: usize = triangles(&blocks);
            let left = after as f64 / before.max(1) as f64;
            before = after;
            left
        })
        .collect()
}

/// A mesh to be joined with others.
#[derive(Clone)]
struct Member {
    /// The smallest index of the meshes that were joined into the member.
    first: u32,
    bounds: Aabb,
    mesh: Mesh,
}

impl Member {
    fn triangles(&self) -> usize {
        self.mesh.triangles.len()
    }

    /// Joins two members. The flag is false if they overlap and could not be joined: then the new member holds both
    /// meshes. Where faces are in one place, those of the member with the smaller `first` are kept.
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

/// Whether each box overlaps another one.
pub(super) fn overlapping(boxes: &[Aabb]) -> Vec<bool> {
    let tree = tree(boxes);
    let overlaps = |(i, b): (usize, &Aabb)| {
        tree.visit(b, |j| {
            match j as usize != i && b.overlaps(&boxes[j as usize]) {
                true => ControlFlow::Break(()),
                false => ControlFlow::Continue(()),
            }
        })
        .is_break()
    };
    boxes.iter().enumerate().map(overlaps).collect()
}

/// The pairs of boxes that overlap and are `wanted`. The second index of a pair is larger; the pairs are sorted by
/// the second index, then by the first. `None` if there are more than `most`.
pub(super) fn pairs(
    boxes: &[Aabb],
    most: usize,
    wanted: impl Fn(usize, usize) -> bool,
) -> Option<Vec<(usize, usize)>> {
    let tree = tree(boxes);
    let mut out = Vec::new();
    for (j, b) in boxes.iter().enumerate() {
        let start = out.len();
        let all = tree.visit(b, |i| {
            let i = i as usize;
            if i < j && b.overlaps(&boxes[i]) && wanted(i, j) {
                out.push((i, j));
            }
            match out.len() > most {
                true => ControlFlow::Break(()),
                false => ControlFlow::Continue(()),
            }
        });
        if all.is_break() {
            return None;
        }
        out[start..].sort_unstable();
    }
    Some(out)
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

    #[test]
    fn a_trial_tells_what_rounds_leave() {
        // Boxes that overlap in a corner, in rows of seven that lie apart.
        let at = |i: usize| {
            let corner = [0, 1, 2].map(|k| 0.3 * ((i % 7) as f64 + f64::from(k)) + (i / 7) as f64);
            let mesh = cuboid(corner, corner.map(|x| x + 0.5));
            Member {
                first: i as u32,
                bounds: mesh.bounds(),
                mesh,
            }
        };
        let mut group: Vec<Member> = (0..2 * MIN_MEMBERS_TO_SAMPLE).map(at).collect();
        assert!(trial(&group[1..MIN_MEMBERS_TO_SAMPLE]).is_empty());
        for told in trial(&group) {
            let triangles = |group: &[Member]| group.iter().map(Member::triangles).sum::<usize>();
            let before = triangles(&group);
            group = round(group).0;
            let left = triangles(&group) as f64 / before as f64;
            assert!((told - left).abs() < 0.05, "{told} {left}");
        }
    }
}
