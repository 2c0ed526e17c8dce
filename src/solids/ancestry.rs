//! The lowest common ancestor of two places in a tree, however deep the tree is.

/// The mark for no place in a tree.
pub const NONE: u32 = u32::MAX;

/// The heavy path on which a place is. Heavy paths go from each parent to its largest child.
#[derive(Debug, Clone, Copy)]
struct HeavyPath {
    /// The highest place of the path.
    head: u32,
    /// The parent of the head, or [`NONE`].
    above: u32,
}

/// The heavy path of each place of some trees. From any place up to the root there are at most as many
/// heads of paths as the logarithm of the tree's size (heavy path decomposition; Sleator and Tarjan, "A data
/// structure for dynamic trees", 1983).
#[derive(Debug, Default)]
pub struct Ancestry(Vec<HeavyPath>);

impl Ancestry {
    /// Finds the heavy paths. `parents` has the parent of each place, or [`NONE`]. Parents stand before their children,
    /// and all descendants of a child before the next child.
    pub fn new(parents: &[u32]) -> Ancestry {
        let mut weights = vec![1u32; parents.len()];
        let mut larger = vec![NONE; parents.len()];
        for (i, &parent) in parents.iter().enumerate().rev() {
            if let Some(other) = larger.get_mut(parent as usize) {
                if *other == NONE || weights[*other as usize] <= weights[i] {
                    *other = i as u32;
                }
                weights[parent as usize] += weights[i];
            }
        }
        let mut paths: Vec<HeavyPath> = Vec::with_capacity(parents.len());
        for (i, &parent) in (0u32..).zip(parents) {
            paths.push(match larger.get(parent as usize) {
                Some(&child) if child == i => paths[parent as usize],
                _ => HeavyPath {
                    head: i,
                    above: parent,
                },
            });
        }
        Ancestry(paths)
    }

    /// The lowest common ancestor of two places, which may be one of them. `None` if they are in different trees.
    pub fn join(&self, mut a: u32, mut b: u32) -> Option<u32> {
        let path = |i: u32| self.0[i as usize];
        while path(a).head != path(b).head {
            // The common ancestor is above the head that stands later.
            let later = match path(a).head > path(b).head {
                true => &mut a,
                false => &mut b,
            };
            *later = Some(path(*later).above).filter(|&i| i != NONE)?;
        }
        Some(a.min(b))
    }

    /// The root of the tree that holds a place.
    pub fn root(&self, mut place: u32) -> u32 {
        loop {
            let HeavyPath { head, above } = self.0[place as usize];
            match above {
                NONE => return head,
                _ => place = above,
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::random;

    /// Random forests, against one step at a time.
    #[test]
    fn paths_meet_where_single_steps_do() {
        let mut random = random();
        for round in 0..200 {
            // The last place, or one that it is part of, gets the next child.
            let mut parents: Vec<u32> = vec![NONE];
            for i in 1..40 {
                let mut parent = i - 1;
                while parent != NONE && random(2 + round % 3) == 0 {
                    parent = parents[parent as usize];
                }
                parents.push(parent);
            }
            let above = |mut i: u32| {
                let mut all = vec![i];
                while parents[i as usize] != NONE {
                    i = parents[i as usize];
                    all.push(i);
                }
                all
            };
            let ancestry = Ancestry::new(&parents);
            for a in 0..40 {
                assert_eq!(ancestry.root(a), *above(a).last().unwrap());
                for b in 0..40 {
                    let others = above(b);
                    let expected = above(a).into_iter().find(|i| others.contains(i));
                    assert_eq!(ancestry.join(a, b), expected, "{parents:?} {a} {b}");
                }
            }
        }
    }
}
