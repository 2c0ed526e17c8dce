//! Operands that may be joined without changing who owns what; and which of them can touch.

use std::collections::HashMap;
use std::hash::Hash;

use crate::geometry::Aabb;
use crate::translate::pov::budget::{Budget, Limit};

/// Most pairs of boxes that are looked at before two sets are taken to meet.
const MAX_BOX_PAIRS: usize = 1 << 20;

/// Groups the operands of a union by key, in order of first appearance; operands without a key stay
/// alone. Where two operands overlap the first owns the overlap, so an operand joins an older group
/// only if it meets nothing that has come since. Gives each group's operands by position.
pub(crate) fn in_order<K: Eq + Hash>(
    operands: &[(Option<K>, Aabb)],
    budget: &Budget,
) -> Vec<Vec<usize>> {
    struct Grouped {
        members: Vec<usize>,
        hull: Aabb,
    }
    let mut groups: Vec<Grouped> = Vec::new();
    let mut newest: HashMap<&K, usize> = HashMap::new();
    let mut compared = 0;
    for (at, (key, this)) in operands.iter().enumerate() {
        let mut meets = |group: &Grouped| {
            group.hull.overlaps(this) && {
                compared += group.members.len();
                compared > MAX_BOX_PAIRS
                    || group.members.iter().any(|m| operands[*m].1.overlaps(this))
            }
        };
        let known = key.as_ref().and_then(|k| newest.get(k).copied());
        let joined = known.filter(|g| {
            // Past a certain number of groups the answer is not worth its price.
            !budget.spend(Limit::GroupsCompared, groups.len() - g)
                || !groups[g + 1..].iter().any(&mut meets)
        });
        let group = joined.unwrap_or_else(|| {
            groups.push(Grouped {
                members: Vec::new(),
                hull: Aabb::EMPTY,
            });
            groups.len() - 1
        });
        if let Some(key) = key {
            newest.insert(key, group);
        }
        groups[group].members.push(at);
        groups[group].hull = groups[group].hull.hull(this);
    }
    groups.into_iter().map(|g| g.members).collect()
}

/// The pairs of sets of which a box of the one touches one of the other, by position: the earlier and the
/// later one, ordered by the later.
pub(crate) fn pairs(sets: &[&[Aabb]]) -> Vec<(usize, usize)> {
    let tagged = |(i, set): (usize, &&[Aabb])| -> Vec<(usize, Aabb)> {
        set.iter().map(|b| (i, *b)).collect()
    };
    let mut all: Vec<(usize, Aabb)> = sets.iter().enumerate().flat_map(tagged).collect();
    all.retain(|(_, b)| !b.is_empty());
    all.sort_by(|a, b| a.1.min[0].total_cmp(&b.1.min[0]));
    let mut open: Vec<(usize, Aabb)> = Vec::new();
    let mut pairs = Vec::new();
    // Sorted out now and then: many boxes may make few pairs.
    let mut limit = MAX_BOX_PAIRS;
    for (i, this) in all {
        open.retain(|(_, o)| o.max[0] >= this.min[0]);
        let touching = open.iter().filter(|(j, o)| i != *j && o.overlaps(&this));
        pairs.extend(touching.map(|&(j, _)| (i.max(j), i.min(j))));
        open.push((i, this));
        if pairs.len() > limit {
            pairs.sort_unstable();
            pairs.dedup();
            limit = MAX_BOX_PAIRS.max(2 * pairs.len());
        }
    }
    pairs.sort_unstable();
    pairs.dedup();
    pairs
        .into_iter()
        .map(|(later, earlier)| (earlier, later))
        .collect()
}

/// Whether a box of one set touches one of the other.
pub(crate) fn meet(a: &[Aabb], b: &[Aabb]) -> bool {
    !a.is_empty() && !b.is_empty() && sweep(a, b)
}

/// Whether two boxes of a set touch.
pub(crate) fn meet_each_other(boxes: &[Aabb]) -> bool {
    sweep(boxes, &[])
}

/// Sweeps a plane along x over both sets and compares boxes that it cuts at the same time: each of
/// one set with each of the other, or, where the other set is empty, all with all.
fn sweep(a: &[Aabb], b: &[Aabb]) -> bool {
    let tagged = |set: &[Aabb], tag: bool| -> Vec<(Aabb, bool)> {
        let full = set.iter().filter(|s| !s.is_empty());
        full.map(|s| (*s, tag)).collect()
    };
    let mut all = tagged(a, false);
    all.extend(tagged(b, true));
    all.sort_by(|x, y| x.0.min[0].total_cmp(&y.0.min[0]));
    let within = b.is_empty();
    let mut open: Vec<(Aabb, bool)> = Vec::new();
    let mut compared = 0;
    for (this, tag) in all {
        open.retain(|(o, _)| o.max[0] >= this.min[0]);
        compared += open.len();
        let hit = |(o, t): &(Aabb, bool)| (within || *t != tag) && o.overlaps(&this);
        if compared > MAX_BOX_PAIRS || open.iter().any(hit) {
            return true;
        }
        open.push((this, tag));
    }
    false
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cube(x: f64, y: f64) -> Aabb {
        Aabb::new([x, y, 0.0], [x + 1.0, y + 1.0, 1.0])
    }

    #[test]
    fn boxes_meet() {
        assert!(!meet(&[cube(0.0, 0.0)], &[cube(0.5, 2.0), cube(3.0, 0.0)]));
        assert!(meet(&[cube(0.0, 0.0)], &[cube(5.0, 0.0), cube(0.5, 0.5)]));
        assert!(!meet_each_other(&[cube(0.0, 0.0), cube(0.0, 3.0)]));
        assert!(meet_each_other(&[
            cube(0.0, 0.0),
            cube(0.0, 3.0),
            Aabb::ALL
        ]));
    }

    #[test]
    fn pairs_of_what_touches() {
        let sets = [
            vec![cube(4.0, 0.0)],
            vec![cube(0.0, 0.0), cube(9.0, 0.0)],
            vec![],
            vec![cube(4.5, 0.5)],
            vec![cube(0.0, 3.0)],
        ];
        let sets: Vec<&[Aabb]> = sets.iter().map(|s| &s[..]).collect();
        assert_eq!(pairs(&sets), [(0, 3)]);
    }

    #[test]
    fn groups_keep_the_order_where_it_matters() {
        let budget = Budget::default();
        let part = |key, x| (Some(key), cube(x, 0.0));
        // The third touches the second, which would then own what is the second's.
        let touching = [part('a', 0.0), part('b', 3.0), part('a', 3.5)];
        assert_eq!(in_order(&touching, &budget), [vec![0], vec![1], vec![2]]);
        let apart = [part('a', 0.0), part('b', 3.0), part('a', 6.0)];
        assert_eq!(in_order(&apart, &budget), [vec![0, 2], vec![1]]);
        let alone = [(None, cube(0.0, 0.0)), (None, cube(0.0, 0.0))];
        assert_eq!(in_order::<char>(&alone, &budget), [vec![0], vec![1]]);
    }
}
