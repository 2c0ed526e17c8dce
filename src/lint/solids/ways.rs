//! Ways up a tree, however deep: where two places of it meet.

/// No place in a tree.
pub const NONE: u32 = u32::MAX;

/// The way up from a place: first among larger children, then in one step.
#[derive(Debug, Clone, Copy)]
struct Way {
    /// The highest place reached as the larger child each time.
    head: u32,
    /// The parent of that, or [`NONE`].
    above: u32,
}

/// Of each place of some trees its way up: at most as many heads as the tree's logarithm (heavy path
/// decomposition; Sleator and Tarjan, "A data structure for dynamic trees", 1983).
#[derive(Debug, Default)]
pub struct Ways(Vec<Way>);

impl Ways {
    /// `parents` has the parent of each place, or [`NONE`]. Parents stand before their children, and
    /// all that a child is made of before the next child.
    pub fn new(parents: &[u32]) -> Ways {
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
        let mut ways: Vec<Way> = Vec::with_capacity(parents.len());
        for (i, &parent) in (0u32..).zip(parents) {
            ways.push(match larger.get(parent as usize) {
                Some(&child) if child == i => ways[parent as usize],
                _ => Way {
                    head: i,
                    above: parent,
                },
            });
        }
        Ways(ways)
    }

    /// The lowest place that two places are part of; `None` where they are of different trees.
    pub fn join(&self, mut a: u32, mut b: u32) -> Option<u32> {
        let way = |i: u32| self.0[i as usize];
        while way(a).head != way(b).head {
            // What the head that stands later is part of does not begin with it.
            let later = match way(a).head > way(b).head {
                true => &mut a,
                false => &mut b,
            };
            *later = Some(way(*later).above).filter(|&i| i != NONE)?;
        }
        Some(a.min(b))
    }

    /// The topmost place that a place is part of.
    pub fn root(&self, mut place: u32) -> u32 {
        loop {
            let Way { head, above } = self.0[place as usize];
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
    use crate::lint::testing::random;

    /// Random forests, against one step at a time.
    #[test]
    fn ways_meet_where_single_steps_do() {
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
            let ways = Ways::new(&parents);
            for a in 0..40 {
                assert_eq!(ways.root(a), *above(a).last().unwrap());
                for b in 0..40 {
                    let others = above(b);
                    let expected = above(a).into_iter().find(|i| others.contains(i));
                    assert_eq!(ways.join(a, b), expected, "{parents:?} {a} {b}");
                }
            }
        }
    }
}
