//! Faces between transparent media, where parts of a union meet or overlap.
//!
//! POV-Ray counts which objects a ray has entered. If the face of the later part were left out inside the earlier one,
//! a ray beyond it would be in both. So the face is there, a hair within the earlier part: it is the later part's skin.
//! A ray that is in both parts is, to POV-Ray, in the one that it entered last, so it bends at the first of the two
//! faces that it meets. This first face shows the texture, and the second face shows nothing: from outside, the face of
//! the earlier part is seen, and from inside, the skin. Rays then take as many steps as they should.

use std::collections::{BTreeMap, HashMap, HashSet};

use super::settle::{Operands, SolidExtensions};
use crate::geometry::Aabb;
use crate::scene::NodeId;
use crate::translate::fidelity::Fidelity;
use crate::translate::pov::budget::Limit;
use crate::translate::pov::model::Model;
use crate::translate::pov::model::contacts::Orientation;
use crate::translate::pov::model::displacement::Change;
use crate::translate::pov::model::grouping::{self, meet_each_other};
use crate::translate::pov::model::plane::Plane;
use crate::translate::pov::model::state::State;
use crate::translate::pov::model::tables::DEFAULT;
use crate::translate::pov::tree::{Modifier, Object, Operation};

/// Operands of a union that are one medium.
pub(crate) struct Members {
    /// The numbers of the optics and the index; `None` where the only operand is of several media by itself.
    pub medium: Option<(u32, u32)>,
    pub nodes: Operands,
    pub boxes: Vec<Aabb>,
    pub seen_into: bool,
    pub transparent: bool,
    /// Whether a later medium begins where the group ends: POV-Ray has to know the group's index then, even if it is 1.
    pub bounds_media: bool,
}

impl Members {
    /// The operation that joins the members.
    pub(crate) fn kind(&self) -> Operation {
        match self.seen_into && self.nodes.len() > 1 && meet_each_other(&self.boxes) {
            true => Operation::Merge,
            false => Operation::Union,
        }
    }
}

/// The look of the faces between two groups.
#[derive(Debug, Clone, Copy, PartialEq)]
enum InterfaceLook {
    /// No face is seen: the groups are one medium, and another medium stands between them in the order.
    Nothing,
    /// The faces have the look with this number. From inside it is seen on the skin.
    Look(usize),
    /// The faces have a look that the skin cannot have, so the face of the earlier group is seen from inside, too.
    Face,
}

/// Two groups of a union that touch, by position.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Meeting {
    pub earlier: usize,
    later: usize,
    /// Whether the later group ends a hair within the earlier one.
    pub apart: bool,
    seen: InterfaceLook,
}

/// The groups of a union, and where they touch.
pub(crate) struct Meetings {
    pub groups: Vec<Members>,
    extensions: SolidExtensions,
    /// The meetings, ordered by the later group.
    all: Vec<Meeting>,
    /// The meetings whose faces have two sides, by the earlier group.
    sided: HashMap<usize, Vec<Meeting>>,
    /// The pairs of solids that lie against each other, by their two groups, the earlier one first.
    contacts: BTreeMap<(usize, usize), Vec<(NodeId, NodeId)>>,
    /// For each group, the earlier opaque groups that it touches.
    walls: HashMap<usize, Vec<usize>>,
    /// The pairs of touching groups, the earlier one first, whose later group is opaque.
    walled: HashSet<(usize, usize)>,
}

impl Meetings {
    /// The earlier groups within which the group `later` ends: its faces lie a hair behind the faces of these groups.
    fn around(&self, later: usize) -> impl Iterator<Item = usize> {
        let apart = self.of_later(later).iter().filter(|m| m.apart);
        apart.map(|m| m.earlier)
    }

    /// The meetings of a group with the groups that come before it.
    pub(crate) fn of_later(&self, later: usize) -> &[Meeting] {
        let from = self.all.partition_point(|m| m.later < later);
        let to = self.all.partition_point(|m| m.later <= later);
        &self.all[from..to]
    }
}

impl InterfaceLook {
    /// The modifiers of a piece of a face: its look, and clips that keep the part inside of the objects `around` and
    /// outside of the objects `before`.
    fn kept<'a>(self, around: &[Object<'a>], before: &[Object<'a>]) -> Vec<Modifier<'a>> {
        let mut modifiers = match self {
            InterfaceLook::Look(look) => vec![Modifier::Texture(look), Modifier::UnseenWithin],
            InterfaceLook::Nothing | InterfaceLook::Face => vec![Modifier::Unseen],
        };
        let union = |of: &[Object<'a>]| Object::unless_empty(Operation::Union, of.to_vec());
        modifiers.extend(union(around).map(Modifier::inside));
        modifiers.extend(union(before).map(Modifier::outside));
        modifiers
    }
}

impl<'a> Model<'a> {
    /// The groups of a union that touch, and how the faces between them are seen.
    pub(crate) fn meetings(
        &mut self,
        mut groups: Vec<Members>,
        extensions: SolidExtensions,
    ) -> Meetings {
        let mut meetings = Vec::new();
        let mut smaller = vec![None; groups.len()];
        let mut looks = vec![None; groups.len()];
        let boxes: Vec<&[Aabb]> = groups.iter().map(|g| &g.boxes[..]).collect();
        let pairs = grouping::pairs(&boxes);
        for &(earlier, later) in &pairs {
            let [a, b] = [earlier, later].map(|i| &groups[i]);
            if !(a.seen_into || (b.seen_into && extensions.any_of(&a.nodes))) {
                continue;
            }
            let has_offset = || {
                let nodes = a.nodes.iter().map(|(node, _)| *node);
                self.hair > 0.0 && nodes.into_iter().all(|n| self.has_offset(n, -self.hair))
            };
            let apart = a.seen_into
                && self.have_a_hair(a, b, &extensions)
                && *smaller[earlier].get_or_insert_with(has_offset);
            let seen = if !apart {
                InterfaceLook::Face
            } else if a.medium == b.medium {
                InterfaceLook::Nothing
            } else {
                let look = looks[earlier].get_or_insert_with(|| self.common_look(&groups[earlier]));
                look.map_or(InterfaceLook::Face, InterfaceLook::Look)
            };
            groups[earlier].bounds_media |= apart;
            meetings.push(Meeting {
                earlier,
                later,
                apart,
                seen,
            });
        }
        let parts = |m: &Meeting| groups[m.earlier].nodes.len() + groups[m.later].nodes.len();
        let parts = meetings.iter().map(parts).sum();
        if !self.budget.spend(Limit::PartsRewritten, parts) {
            meetings.clear();
        }
        for same in meetings.chunk_by_mut(|a, b| a.later == b.later) {
            let changes = same.windows(2).filter(|w| w[0].seen != w[1].seen);
            if !self.budget.spend(Limit::LooksOfSkin, changes.count()) {
                same.iter_mut().for_each(|m| m.seen = InterfaceLook::Face);
            }
        }
        let owners: HashMap<NodeId, usize> = (groups.iter().enumerate())
            .flat_map(|(i, group)| group.nodes.iter().map(move |(node, _)| (*node, i)))
            .collect();
        let mut contacts: BTreeMap<_, Vec<_>> = BTreeMap::new();
        for &(a, b) in &extensions.contacts {
            if let (Some(&i), Some(&j)) = (owners.get(&a), owners.get(&b)) {
                contacts.entry((i, j)).or_default().push((a, b));
            }
        }
        for pairs in contacts.values_mut() {
            pairs.sort_unstable();
            pairs.dedup();
        }
        let mut walls: HashMap<_, Vec<_>> = HashMap::new();
        let mut walled = HashSet::new();
        for (earlier, later) in pairs {
            if !groups[earlier].transparent {
                walls.entry(later).or_default().push(earlier);
            }
            if !groups[later].transparent {
                walled.insert((earlier, later));
            }
        }
        let mut sided: HashMap<_, Vec<_>> = HashMap::new();
        let is_sided = |m: &&Meeting| m.apart && m.seen != InterfaceLook::Face;
        for meeting in meetings.iter().filter(is_sided) {
            sided.entry(meeting.earlier).or_default().push(*meeting);
        }
        Meetings {
            groups,
            extensions,
            all: meetings,
            sided,
            contacts,
            walls,
            walled,
        }
    }

    /// Whether the later group may end a hair within the earlier one where they meet. The earlier group has to be one
    /// that can be made smaller, too, which the caller checks.
    fn have_a_hair(
        &self,
        earlier: &Members,
        later: &Members,
        extensions: &SolidExtensions,
    ) -> bool {
        let has_media = earlier.medium.is_some() && later.medium.is_some();
        // If nothing bends light, it makes no difference which group a ray is in.
        let bends = self.densest != DEFAULT;
        let are_clear = bends && earlier.transparent && later.transparent;
        // Where opaque groups of one medium meet, nothing is seen.
        let counts = are_clear || (later.seen_into && earlier.medium == later.medium);
        let can_grow = || {
            let mut nodes = later.nodes.iter();
            nodes.all(|(node, _)| self.has_offset(*node, self.hair / 2.0))
        };
        has_media && counts && (!extensions.has(&earlier.nodes, &later.nodes) || can_grow())
    }

    /// The number of the look that the whole group has. `None` if its operands differ, or have looks that cannot be
    /// given from outside.
    fn common_look(&mut self, group: &Members) -> Option<usize> {
        let mut looks =
            group
                .nodes
                .iter()
                .map(|&(node, state)| match self.settle_look(node, state.look) {
                    (_, Some(Modifier::Texture(look))) => Some(look),
                    _ => None,
                });
        let first = looks.next()??;
        looks.all(|look| look == Some(first)).then_some(first)
    }

    /// The skin of a group: its faces within earlier groups, a hair behind their faces. Parts of it within opaque
    /// groups are left out.
    pub(crate) fn skin(&mut self, union: &Meetings, later: usize) -> Vec<Object<'a>> {
        let clear = union.of_later(later).iter().filter(|m| m.apart);
        let clear: Vec<_> = clear.copied().collect();
        if clear.is_empty() {
            return Vec::new();
        }
        let smaller = self.changes.number(Change::Offset(-self.hair));
        let mut taken = Vec::new();
        for meeting in &clear {
            taken.extend(self.bare(&union.groups[meeting.earlier], |_, _, _| Some(smaller)));
            taken.extend(self.joints(union, meeting.earlier));
        }
        let Some(own) = self.grown(union, later) else {
            return Vec::new();
        };
        let mut pieces = Vec::new();
        let mut before: Vec<Object<'a>> = Vec::new();
        for alike in clear.chunk_by(|a, b| a.seen == b.seen) {
            let mut around = Vec::new();
            for meeting in alike {
                around.extend(self.bare(&union.groups[meeting.earlier], |_, _, _| None));
            }
            // A face that nobody sees stands between the face that is seen and an eye inside.
            if alike[0].seen == InterfaceLook::Face {
                let steps =
                    Fidelity::approximate("light that is mirrored there takes two steps more");
                let depth = "depth of rays in parts that others surround";
                self.report.state(depth, steps, "");
            }
            let modifiers = alike[0].seen.kept(&around, &before);
            before.extend(around);
            let all = std::iter::once(own.clone()).chain(taken.clone()).collect();
            pieces.push(Object::of(Operation::Difference, all).with(modifiers));
        }
        pieces
    }

    /// The outer sides of a group's faces within later groups, whose skins are the inner sides there; and the modifier
    /// that keeps the rest of the group's surface.
    pub(crate) fn outer_sides(
        &mut self,
        union: &Meetings,
        earlier: usize,
    ) -> (Vec<Object<'a>>, Option<Modifier<'a>>) {
        let Some(sided) = union.sided.get(&earlier) else {
            return (Vec::new(), None);
        };
        let group = &union.groups[earlier];
        let own = self.bare(group, |_, _, state| state.flush);
        let Some(own) = Object::unless_empty(group.kind(), own) else {
            return (Vec::new(), None);
        };
        let parts: Vec<NodeId> = group.nodes.iter().map(|n| n.0).collect();
        let mut pieces = Vec::new();
        let mut before: Vec<Object<'a>> = Vec::new();
        for alike in sided.chunk_by(|a, b| a.seen == b.seen) {
            let mut around = Vec::new();
            for meeting in alike {
                let Some(later) = self.grown(union, meeting.later) else {
                    continue;
                };
                // Where a third group comes between the two and has no skin, the face stays as it is there.
                let between = union.of_later(meeting.later).iter();
                let mut all = vec![later];
                for third in between.filter(|m| m.earlier > earlier) {
                    let group = &union.groups[third.earlier];
                    let has_skin = sided.iter().any(|m| m.later == third.earlier);
                    if !has_skin && (third.apart || group.transparent) {
                        // The third group is made larger where it has faces in one place with the earlier group, whose
                        // faces it clips.
                        all.extend(self.bare(group, |model, node, _| model.reach(node, &parts)));
                    }
                }
                around.push(Object::of(Operation::Difference, all));
            }
            let modifiers = alike[0].seen.kept(&around, &before);
            before.extend(around);
            pieces.push(own.clone().with(modifiers));
        }
        let rest = Object::unless_empty(Operation::Union, before).map(Modifier::outside);
        (pieces, rest)
    }

    /// The solid of a group without the earlier opaque groups. It is larger by half a hair if it lies against groups
    /// that it ends within, and smaller at faces that end flush with theirs.
    fn grown(&mut self, union: &Meetings, later: usize) -> Option<Object<'a>> {
        let around = || union.around(later).map(|earlier| &union.groups[earlier]);
        let group = &union.groups[later];
        let grows = around().any(|earlier| union.extensions.has(&earlier.nodes, &group.nodes));
        let own = self.bare(group, |model, node, state| {
            model.skin_of(node, around(), grows).or(state.flush)
        });
        let mut all = vec![Object::unless_empty(group.kind(), own)?];
        for meeting in union.of_later(later) {
            let earlier = &union.groups[meeting.earlier];
            if !earlier.transparent && !meeting.apart {
                all.extend(self.longer(union, earlier));
            }
        }
        all.extend(self.owned_by_neighbours(union, later));
        Some(Object::of(Operation::Difference, all))
    }

    /// The change of a solid that ends within other groups: half a hair larger, but well inside at the planes in which
    /// it ends flush with them. `None` if it needs no change, or cannot be made larger.
    fn skin_of<'m>(
        &mut self,
        node: NodeId,
        others: impl Iterator<Item = &'m Members>,
        grows: bool,
    ) -> Option<u32> {
        let others = others.flat_map(|group| &group.nodes);
        let contacts: Vec<_> = others
            .map(|(other, _)| self.contacts(node, *other))
            .collect();
        let ends = |wanted: Orientation| {
            let found = contacts.iter().flat_map(|c| c.iter());
            let found = found.filter(move |c| c.orientation == wanted);
            found.filter_map(|c| c.faces[0].plane())
        };
        let mut within: Vec<(Plane, f64)> = Vec::new();
        for plane in ends(Orientation::Alike) {
            // A face on which the solid stands on one of the others stays where it is.
            if !ends(Orientation::Opposed).any(|p| p == plane)
                && within.iter().all(|w| w.0 != plane)
            {
                within.push((plane, -4.0 * self.hair));
            }
        }
        let changes = grows || !within.is_empty();
        if !changes || !self.has_offset(node, self.hair / 2.0) {
            return None;
        }
        let larger = self.changes.number(Change::Offset(self.hair / 2.0));
        let within = self.changes.of_planes(within);
        Some(self.changes.both(within, larger))
    }

    /// The modifier that keeps the part of an object outside of all operands of a group; `None` if the object need not
    /// be clipped.
    pub(crate) fn outside_of(&mut self, union: &Meetings, group: &Members) -> Option<Modifier<'a>> {
        let by = Object::unless_empty(Operation::Union, self.longer(union, group))?;
        Some(Modifier::outside(by))
    }

    /// The solids of a group in the form that clips later groups: some are a little larger.
    fn longer(&mut self, union: &Meetings, group: &Members) -> Vec<Object<'a>> {
        // Within an opaque solid nothing is seen anyway, so it need not clip, unless it has faces in one place with a
        // later solid.
        let members = (group.nodes.iter())
            .map(|(node, _)| (*node, State::GEOMETRY.flush(union.extensions.of(*node))))
            .filter(|(_, state)| group.seen_into || state.flush.is_some());
        self.refer_all(members)
    }

    /// The solids of a group as geometry only, each with the change that `change` gives it.
    fn bare(
        &mut self,
        group: &Members,
        change: impl Fn(&mut Self, NodeId, State) -> Option<u32>,
    ) -> Vec<Object<'a>> {
        let bare = |&(node, state): &(NodeId, State)| {
            let state = State::GEOMETRY.flush(change(self, node, state));
            self.refer(node, state)
        };
        group.nodes.iter().map(bare).collect()
    }

    /// Reports the inaccuracy of two overlapping media.
    pub(crate) fn overlap(&mut self, earlier: &Members, later: &Members) {
        let index = |g: &Members| g.medium.map(|(_, index)| index);
        // A group that is opaque, or bends no light by itself, is no medium to POV-Ray.
        if index(later) != Some(DEFAULT) && later.transparent {
            self.media_are_approximate();
        }
        if earlier.medium.is_some() && earlier.medium == later.medium {
            self.report.count(
                "parts of one medium that overlap, with another medium between them",
                Fidelity::approximate("what is seen through the overlap may be another picture"),
                "",
            );
        }
    }

    /// The solids that have to be taken from a group's skin since they belong to its neighbours: the opaque groups
    /// there, and the layers where the groups that it ends within lie against each other, or against opaque ones.
    fn owned_by_neighbours(&mut self, union: &Meetings, later: usize) -> Vec<Object<'a>> {
        let around: Vec<usize> = union.around(later).collect();
        let walls = union.walls.get(&later).map_or(&[][..], |w| &w[..]);
        let hull = |group: &Members| group.boxes.iter().fold(Aabb::EMPTY, |h, b| h.hull(b));
        let own = hull(&union.groups[later]);
        let mut pieces = Vec::new();
        // Opaque groups that are seen into were already taken away as a whole, in `grown`.
        let is_taken = |wall: usize| {
            let mut met = union.of_later(later).iter();
            union.groups[wall].seen_into && met.any(|m| m.earlier == wall && !m.apart)
        };
        for &wall in walls.iter().filter(|w| !is_taken(**w)) {
            let touched = around
                .iter()
                .filter(|e| union.walled.contains(&(**e, wall)));
            let place = touched.fold(Aabb::EMPTY, |h, e| h.hull(&hull(&union.groups[*e])));
            let place = place.intersection(&own);
            let group = &union.groups[wall];
            let members = group.nodes.iter().zip(&group.boxes);
            for ((node, _), _) in members.filter(|(_, b)| b.overlaps(&place)) {
                let state = State::GEOMETRY.flush(union.extensions.of(*node));
                pieces.push(self.refer(*node, state));
            }
        }
        for &i in &around {
            for &j in around.iter().chain(walls) {
                let contacts = union.contacts.get(&(i.min(j), i.max(j)));
                for &(a, b) in contacts
                    .filter(|_| i < j || walls.contains(&j))
                    .into_iter()
                    .flatten()
                {
                    if self.box_of(a).touches(&own) && self.box_of(b).touches(&own) {
                        pieces.extend(self.layer_at_contact(a, b));
                    }
                }
            }
        }
        pieces
    }

    /// The layers along the faces where solids of one group lie against each other. Copies of these solids that are a
    /// hair smaller leave the layers out.
    fn joints(&mut self, union: &Meetings, group: usize) -> Vec<Object<'a>> {
        let contacts = union.contacts.get(&(group, group));
        let pairs = contacts.into_iter().flatten();
        pairs
            .filter_map(|(a, b)| self.layer_at_contact(*a, *b))
            .collect()
    }

    /// The layer along the faces that two solids have in one place. It reaches two hairs to both sides, farther than
    /// faces that are a hair behind those of the solids. `None` if a solid cannot be made larger.
    fn layer_at_contact(&mut self, a: NodeId, b: NodeId) -> Option<Object<'a>> {
        let by = 2.0 * self.hair;
        if !(self.has_offset(a, by) && self.has_offset(b, by)) {
            return None;
        }
        let larger = self.changes.number(Change::Offset(by));
        let both = [a, b].map(|node| (node, State::GEOMETRY.flush(Some(larger))));
        Some(Object::of(Operation::Intersection, self.refer_all(both)))
    }
}
