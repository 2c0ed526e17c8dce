//! Groups of a union's operands that may be joined without changing which operand owns a point; and which groups can
//! touch, by their bounding boxes.

use std::collections::HashMap;
use std::hash::Hash;

use crate::geometry::Aabb;
use crate::translate::pov::budget::{Budget, Limit};

/// The largest number of pairs of boxes that are compared. Beyond it two sets are taken to meet.
const MAX_BOX_PAIRS: usize = 1 << 20;

/// Operands of a union with the same key, or a single operand without a key.
pub(crate) struct Group<K, T> {
    pub key: Option<K>,
    pub members: Vec<T>,
    pub boxes: Vec<Aabb>,
    hull: Aabb,
}

/// Groups the operands of a union, with their boxes, by key, in order of first appearance; operands without a key stay
/// alone. Where two operands overlap the first owns the overlap, so an operand joins an older group
/// only if it meets nothing that has come since.
pub(crate) fn in_order<K: Copy + Eq + Hash, T>(
    operands: impl IntoIterator<Item = (Option<K>, T, Aabb)>,
    budget: &Budget,
) -> Vec<Group<K, T>> {
    let mut groups: Vec<Group<K, T>> = Vec::new();
    let mut newest: HashMap<K, usize> = HashMap::new();
    let mut compared = 0;
    for (key, member, this) in operands {
        let mut meets = |group: &Group<K, T>| {
            group.hull.overlaps(&this) && {
                compared += group.boxes.len();
                compared > MAX_BOX_PAIRS || group.boxes.iter().any(|b| b.overlaps(&this))
            }
        };
        let known = key.and_then(|k| newest.get(&k).copied());
        let joined = known.filter(|g| {
            // Beyond the limit the operand joins without a comparison, and the report says so.
            !budget.spend(Limit::GroupsCompared, groups.len() - g)
                || !groups[g + 1..].iter().any(&mut meets)
        });
        let number = joined.unwrap_or(groups.len());
        if number == groups.len() {
            let (members, boxes, hull) = (Vec::new(), Vec::new(), Aabb::EMPTY);
            groups.push(Group {
                key,
                members,
                boxes,
                hull,
            });
        }
        newest.extend(key.map(|k| (k, number)));
        let group = &mut groups[number];
        group.members.push(member);
        group.boxes.push(this);
        group.hull = group.hull.hull(&this);
    }
    groups
}

/// The pairs of sets with boxes that touch, as positions in `sets`: the earlier set first. The pairs are ordered by the
/// later set.
pub(crate) fn pairs(sets: &[&[Aabb]]) -> Vec<(usize, usize)> {
    let mut pairs = Vec::new();
    // Duplicates are removed now and then: many boxes may make few pairs.
    let mut limit = MAX_BOX_PAIRS;
    sweep(sets, usize::MAX, |i, j| {
        pairs.push((i.max(j), i.min(j)));
        if pairs.len() > limit {
            pairs.sort_unstable();
            pairs.dedup();
            limit = MAX_BOX_PAIRS.max(2 * pairs.len());
        }
        false
    });
    pairs.sort_unstable();
    pairs.dedup();
    let turned = pairs.into_iter().map(|(later, earlier)| (earlier, later));
    turned.collect()
}

/// Whether boxes of two different sets touch. `true`, too, if there are too many pairs to compare.
pub(crate) fn meet(sets: &[&[Aabb]]) -> bool {
    sweep(sets, MAX_BOX_PAIRS, |_, _| true)
}

/// Whether two boxes of a set touch.
pub(crate) fn meet_each_other(boxes: &[Aabb]) -> bool {
    let alone: Vec<_> = boxes.chunks(1).collect();
    meet(&alone)
}

/// Sweeps a plane along x over all sets and compares boxes of different sets that the plane cuts at the same time.
/// Calls `is_it` with the sets of boxes that touch. Returns `true` as soon as `is_it` does, or when more than `most`
/// pairs were compared; `false` if the sweep gets to its end.
fn sweep(sets: &[&[Aabb]], most: usize, mut is_it: impl FnMut(usize, usize) -> bool) -> bool {
    let tagged = |(i, set): (usize, &&'_ [Aabb])| set.iter().map(|b| (i, *b)).collect::<Vec<_>>();
    let mut all: Vec<(usize, Aabb)> = sets.iter().enumerate().flat_map(tagged).collect();
    all.retain(|(_, b)| !b.is_empty());
    all.sort_by(|a, b| a.1.min[0].total_cmp(&b.1.min[0]));
    let mut open: Vec<(usize, Aabb)> = Vec::new();
    let mut compared = 0;
    for (i, this) in all {
        open.retain(|(_, o)| o.max[0] >= this.min[0]);
        compared += open.len();
        let mut touching = open.iter().filter(|(j, o)| i != *j && o.overlaps(&this));
        if compared > most || touching.any(|(j, _)| is_it(i, *j)) {
            return true;
        }
        open.push((i, this));
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
        assert!(!meet(&[
            &[cube(0.0, 0.0)],
            &[cube(0.5, 2.0), cube(3.0, 0.0)]
        ]));
        assert!(meet(&[
            &[cube(0.0, 0.0)],
            &[cube(5.0, 0.0), cube(0.5, 0.5)]
        ]));
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
        let grouped = |parts: &[(Option<char>, f64)]| -> Vec<Vec<usize>> {
            let parts = parts.iter().enumerate();
            let operands = parts.map(|(i, (key, x))| (*key, i, cube(*x, 0.0)));
            let groups = in_order(operands, &Budget::default());
            groups.into_iter().map(|g| g.members).collect()
        };
        let (a, b) = (Some('a'), Some('b'));
        // The third operand touches the second. Joined with the first, it would own points that belong to the second.
        assert_eq!(
            grouped(&[(a, 0.0), (b, 3.0), (a, 3.5)]),
            [vec![0], vec![1], vec![2]]
        );
        assert_eq!(
            grouped(&[(a, 0.0), (b, 3.0), (a, 6.0)]),
            [vec![0, 2], vec![1]]
        );
        assert_eq!(grouped(&[(None, 0.0), (None, 0.0)]), [vec![0], vec![1]]);
    }
}
