//! Joins lists of events into one. Events in one place become one event, judged by the states before and after that
//! place, so identical surfaces in the same place cancel out.

use super::events::{Event, Kind, List, Owner, Scratch, Spans, State};
use crate::trace::precision::Precision;
use std::cmp::Ordering;

impl<R: Precision> Spans<R> {
    /// Sorts the events of the lists from `base` on; operands keep their order at equal t.
    pub(crate) fn sort(&mut self, base: usize) {
        let Spans {
            lists,
            events,
            scratch,
            ..
        } = self;
        let lists = &lists[base..];
        scratch.order.clear();
        scratch.before.clear();
        scratch.out.clear();
        for (i, list) in lists.iter().enumerate() {
            scratch.before.push(list.start);
            let end = lists.get(i + 1).map_or(events.len(), |next| next.begin);
            for (event, j) in events[list.begin..end].iter().zip(list.begin as u32..) {
                scratch.order.push((event.t(), i as u32, j));
            }
        }
        scratch.order.sort_unstable_by(|a, b| {
            // Zeros of both signs compare equal, as one place, and no t is NaN.
            let rank = |i: u32| lists[i as usize].part;
            a.0.partial_cmp(&b.0)
                .unwrap_or(Ordering::Equal)
                .then_with(|| rank(a.1).cmp(&rank(b.1)))
                .then_with(|| a.2.cmp(&b.2))
        });
        scratch.after.clone_from(&scratch.before);
        scratch.tied.clear();
        scratch.tied.resize(scratch.order.len(), false);
    }
}

impl<R: Precision> Scratch<R> {
    /// Returns the index behind the events that lie in one place with the event at `first`. Sets `before` and `after`
    /// to the states on both sides of that place.
    fn next_group(&mut self, events: &[Event<R>], first: usize) -> usize {
        self.before.clone_from(&self.after);
        let mut next = first;
        while let Some(&(t, list, event)) = self.order.get(next) {
            if next > first && !self.tied[next] && self.order[next - 1].0 != t {
                break;
            }
            let event = &events[event as usize];
            if event.kind != Kind::Sheet {
                self.after[list as usize] = event.state;
            }
            next += 1;
        }
        next
    }
}

/// Adds an event to a joined list. The t of events in one place may differ by their errors, in either order. A t below
/// that of the event before is raised to it, so that the list ascends.
fn emit<R: Precision>(out: &mut Vec<Event<R>>, mut event: Event<R>) {
    if let Some(last) = out.last().filter(|last| last.t() > event.t()) {
        event.place.root.t = last.t();
    }
    out.push(event);
}

/// Replaces the lists from `base` on by one, whose events are in the scratch.
fn replace<R: Precision>(spans: &mut Spans<R>, base: usize, part: u32, start: State) {
    let begin = spans.lists[base].begin;
    spans.events.truncate(begin);
    spans.lists.truncate(base);
    if start.inside || !spans.scratch.out.is_empty() {
        spans.events.append(&mut spans.scratch.out);
        spans.lists.push(List { part, start, begin });
    }
}

/// Replaces the lists from `base` on by their union. The lists must have been sorted. The first operand that is inside
/// owns a point.
pub(in crate::trace) fn join_union<R: Precision>(spans: &mut Spans<R>, part: u32, base: usize) {
    match spans.lists.len() - base {
        0 => {}
        1 => spans.lists[base].part = part,
        _ => {
            let start = merge_union(spans, base, Until::End);
            replace(spans, base, part, start);
        }
    }
}

/// The place up to which lists are merged.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::trace) enum Until {
    End,
    /// The place of the first boundary or sheet. `before` and `after` in the scratch then have the states of all lists
    /// on both sides of that place.
    FirstSeen,
}

/// Puts the events of the union of the lists from `base` on into the scratch, and returns the union's state at the
/// start. The lists must have been sorted.
pub(in crate::trace) fn merge_union<R: Precision>(
    spans: &mut Spans<R>,
    base: usize,
    until: Until,
) -> State {
    let Spans {
        lists,
        events,
        scratch,
        ..
    } = spans;
    let rank = |i: usize| lists[base + i].part;
    let holder = |states: &[State]| {
        (0..states.len())
            .filter(|&i| states[i].inside)
            .min_by_key(|&i| rank(i))
    };
    let outside = State {
        inside: false,
        ..lists[base].start
    };
    let state = |states: &[State], holder: Option<usize>| holder.map_or(outside, |i| states[i]);

    let start = state(&scratch.before, holder(&scratch.before));
    let mut now = (holder(&scratch.before), start);
    let mut next = 0;
    while next < scratch.order.len() {
        let (from, emitted) = (next, scratch.out.len());
        next = scratch.next_group(events, from);
        let group = scratch.order[from..next].iter();
        let group = group.map(|&(_, list, event)| (list as usize, &events[event as usize]));
        let then = holder(&scratch.after);
        let after = state(&scratch.after, then);
        let (before_holder, before) = now;
        for (_, &event) in group.clone().filter(|e| e.1.kind == Kind::Sheet) {
            emit(
                &mut scratch.out,
                Event {
                    state: before,
                    ..event
                },
            );
        }
        let of = |list: Option<usize>| {
            let list = list?;
            let mut group = group.clone();
            group.find(|e| e.0 == list && e.1.kind != Kind::Sheet)
        };
        // The boundary belongs to the owner before or behind it whose surface lies here. If the surfaces of both lie
        // here, it belongs to the first operand of the two, which owns the points of its surface.
        let by_rank = match (before_holder, then) {
            (Some(a), Some(b)) if rank(b) < rank(a) => [then, before_holder],
            _ => [before_holder, then],
        };
        if let Some((_, &event)) = by_rank.into_iter().find_map(of) {
            let seen = before.inside != after.inside
                || (before.inside && before.owner.medium != after.owner.medium);
            emit(
                &mut scratch.out,
                Event {
                    kind: if seen { Kind::Boundary } else { Kind::Silent },
                    state: after,
                    ..event
                },
            );
        }
        now = (then, after);
        let is_seen = |e: &Event<R>| e.kind != Kind::Silent;
        if until == Until::FirstSeen && scratch.out[emitted..].iter().any(is_seen) {
            break;
        }
    }
    start
}

/// Replaces the lists from `base` on by the intersection of the first `first` of them, less all others. The lists must
/// have been sorted. The first operand owns the points, or `lead` if all lists are cuts. A face has the properties of
/// its shape; with `inherit`, a face made by a cut has those of the first operand.
pub(in crate::trace) fn join_intersection<R: Precision>(
    spans: &mut Spans<R>,
    part: u32,
    base: usize,
    first: usize,
    inherit: bool,
    lead: Owner,
) {
    if spans.lists.len() - base == 1 && first == 1 {
        spans.lists[base].part = part;
        return;
    }
    let nowhere = spans.lists.len() == base;
    if nowhere {
        // There are no operands but cuts, and the ray meets no cut: the whole ray is inside.
        let start = State {
            inside: true,
            owner: lead,
        };
        let begin = spans.events.len();
        spans.lists.push(List { part, start, begin });
        return;
    }
    let Spans {
        lists,
        events,
        scratch,
        ..
    } = spans;
    let state = |states: &[State]| State {
        inside: states[..first].iter().all(|s| s.inside)
            && !states[first..].iter().any(|s| s.inside),
        owner: if first > 0 { states[0].owner } else { lead },
    };
    let start = state(&scratch.before);
    let mut before = start;
    let mut next = 0;
    while next < scratch.order.len() {
        let from = next;
        next = scratch.next_group(events, from);
        let group = scratch.order[from..next].iter();
        let mut group = group.map(|&(_, list, event)| (list as usize, &events[event as usize]));
        let after = state(&scratch.after);
        for (list, &event) in group.clone().filter(|e| e.1.kind == Kind::Sheet) {
            if list >= first {
                continue;
            }
            // A sheet that lies in a face of an operand counts as inside of that operand.
            let (a, b) = (&scratch.before, &scratch.after);
            let inside = (0..first).all(|i| i == list || a[i].inside || b[i].inside)
                && (first..a.len()).all(|i| !a[i].inside || !b[i].inside);
            if inside {
                emit(
                    &mut scratch.out,
                    Event {
                        state: before,
                        ..event
                    },
                );
            }
        }
        let turned = |&(list, event): &(usize, &Event<R>)| {
            event.kind != Kind::Sheet && scratch.before[list].inside != scratch.after[list].inside
        };
        if before.inside != after.inside {
            // In one place, a face of an operand goes before a face made by a cut, and a face of an earlier operand
            // before one of a later operand, whatever their t were rounded to.
            let rank = |list: usize| (list >= first, lists[base + list].part);
            let face = group.filter(turned);
            if let Some((list, &event)) = face.min_by_key(|e| rank(e.0)) {
                let within = if after.inside { after } else { before };
                let owner = if list >= first && inherit {
                    within.owner
                } else {
                    event.owner
                };
                emit(
                    &mut scratch.out,
                    Event {
                        kind: Kind::Boundary,
                        owner,
                        state: after,
                        ..event
                    },
                );
            }
        } else if after.inside {
            // The owner within the first operand may have changed.
            let change = group.find(|e| e.0 == 0 && e.1.kind != Kind::Sheet);
            if let (true, Some((_, &event))) = (first > 0, change) {
                // Only a change of the medium is visible. A ray that leaves and enters the operand in one place shows
                // nothing.
                let seen = before.owner.medium != after.owner.medium;
                let event = Event {
                    kind: if seen { Kind::Boundary } else { Kind::Silent },
                    state: after,
                    ..event
                };
                emit(&mut scratch.out, event);
            }
        }
        before = after;
    }
    replace(spans, base, part, start);
}

#[cfg(test)]
mod tests {
    use super::super::context::Leaf;
    use super::super::events::RayPoint;
    use super::*;
    use crate::testing::random;
    use crate::trace::search::events::Medium;
    use crate::trace::shapes::Root;

    fn owner(part: u32) -> Owner {
        Owner {
            leaf: Leaf { part, context: 0 },
            medium: Medium {
                optics: part,
                index: 0,
            },
        }
    }

    /// Lists with events at these places, inside from the start or not.
    fn lists(all: &[(bool, Vec<f64>)]) -> Spans {
        let mut spans = Spans::default();
        for ((inside, places), part) in all.iter().zip(0..) {
            let [mut state, start] = [State {
                inside: *inside,
                owner: owner(part),
            }; 2];
            spans.lists.push(List {
                part,
                start,
                begin: spans.events.len(),
            });
            for &t in places {
                state.inside = !state.inside;
                spans.events.push(Event {
                    kind: Kind::Boundary,
                    place: RayPoint {
                        leaf: owner(part).leaf,
                        root: Root { t, face: 0 },
                        error: 0.0,
                    },
                    owner: owner(part),
                    state,
                });
            }
        }
        spans
    }

    type Told = (bool, Vec<(f64, u32, bool, Option<u32>)>);

    /// The one list that is left: how it starts, and of each event the place, whose face it is, and who owns what
    /// is behind.
    fn told(spans: &Spans) -> Option<Told> {
        let start = spans.lists.first()?.start.inside;
        let event = |e: &Event| {
            let behind = e.state.inside.then_some(e.state.owner.leaf.part);
            (e.t(), e.owner.leaf.part, e.state.inside, behind)
        };
        Some((start, spans.of(0).iter().map(event).collect()))
    }

    /// Where each operand is inside on one stretch, all are from the last entry to the first exit.
    #[test]
    fn convex_operands_have_the_stretch_between_in_common() {
        let mut next = random();
        let mut counts = [0; 4];
        for _ in 0..20_000 {
            let count = 2 + next(3) as usize;
            let all: Vec<(bool, Vec<f64>)> = (0..count)
                .map(|_| {
                    let mut places: Vec<f64> = (0..2).map(|_| next(1 << 40) as f64).collect();
                    places.sort_by(f64::total_cmp);
                    match next(4) {
                        0 => (true, vec![]),
                        1 => (true, vec![places[0]]),
                        2 => (false, vec![places[0]]),
                        _ => (false, places),
                    }
                })
                .collect();
            let mut spans = lists(&all);
            spans.sort(0);
            join_intersection(&mut spans, 9, 0, count, false, owner(0));
            let end = |part: usize, inside: bool| {
                let (start, places) = &all[part];
                let place = if *start == inside {
                    None
                } else {
                    places.first()
                };
                let exit = || places.get(1).filter(|_| !inside);
                Some((*place.or_else(exit)?, part as u32))
            };
            let entry = (0..count).filter_map(|part| end(part, true));
            let exit = (0..count).filter_map(|part| end(part, false));
            let entry = entry.max_by(|a, b| a.0.total_cmp(&b.0));
            let exit = exit.min_by(|a, b| a.0.total_cmp(&b.0));
            let is_empty = entry
                .zip(exit)
                .is_some_and(|(entry, exit)| entry.0 > exit.0);
            let ends = [entry.map(|e| (e, true)), exit.map(|e| (e, false))];
            let event =
                |((t, part), inside): ((f64, u32), bool)| (t, part, inside, inside.then_some(0));
            let expected: Vec<_> = ends.into_iter().flatten().map(event).collect();
            let expected = (!is_empty).then_some((entry.is_none(), expected));
            assert_eq!(told(&spans), expected, "{all:?}");
            counts[expected.map_or(3, |told| told.1.len())] += 1;
        }
        assert!(counts.iter().all(|&count| count > 500), "{counts:?}");
    }
}
