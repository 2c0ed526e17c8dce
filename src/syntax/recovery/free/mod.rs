//! Recovery of a text whose line breaks say nothing of where records begin.
//!
//! As in [`layout`](super::layout), all ways to cut the text into records and faults compete, and the cheapest one
//! wins. IDs and parameters speak for a way: [`PartialParses`] knows at each place which IDs are defined on the
//! cheapest way to that place. A fault is a record with one mistake ([`mistakes`]): a number too few or too many, or
//! one that is spoiled.

mod mistakes;

use super::super::signature::Reading;
use super::super::table::{RECORD_TYPES, RecordKind, RecordType};
use super::diagnosis::{Diagnosis, RecordCandidate};
use super::faults;
use super::heads;
use super::partial_parses::{Id, PartialParses, STATES};
use super::prices::{DOUBTS_MAX, HEAD_WITHIN, HOPELESS, LONE_VOID, OTHER_WAY};
use super::stretch::Stretch;
use super::surroundings::Surroundings;

/// The most numbers too many or too few that are a slip.
const MAX_NUMBERS_OFF: usize = 2;
/// The most parameters that a record without a count has.
const MAX_PARAMS: usize = 18;
/// How many tokens ahead are searched for a way that is cheaper by [`HOPELESS`].
const AHEAD: usize = 20;
/// How many parameters are looked at to judge whether a record is plausible.
const PARAMS_MAX: usize = 64;

/// The bit of a state that is set on a way with an odd number of faults. [`LOST`] is the bit for an odd number of lost
/// IDs. The cheapest way to a token in each state is kept, and the text behind the token decides between them.
const FAULTS: usize = 1;
const LOST: usize = 2;

/// Returns the pieces of the cheapest reading.
pub(super) fn cut(stretch: &Stretch, around: &Surroundings) -> Vec<RecordCandidate> {
    let n = stretch.len();
    let mut search = Search {
        stretch,
        ways: PartialParses::new(stretch, around, STATES * (n + 1)),
        types: types_by_arity(),
        heads_before: heads_before(stretch),
        best: vec![None; STATES * (n + 1)],
        here: 0,
    };
    search.best[0] = Some(Offer {
        from: 0,
        price: 0,
        id: Id::None,
        ty: None,
        verdict: Diagnosis::Void,
    });
    for at in 0..n {
        let ahead = |at: usize| STATES * at.min(n + 1);
        for here in STATES * at..STATES * (at + 1) {
            let Some(offer) = search.best[here] else {
                continue;
            };
            search.here = here;
            if at > 0 {
                search.ways.arrive((offer.from, here), offer.id, offer.ty);
            }
            search.records(at);
            let ahead = &search.best[ahead(at + 1)..ahead(at + AHEAD)];
            let cheapest = ahead.iter().flatten().map(|o| o.price).min();
            if cheapest.is_none_or(|cheapest| offer.price < cheapest + HOPELESS) {
                search.faults(at);
            }
        }
    }
    let ends = STATES * n..STATES * (n + 1);
    let price = |&node: &usize| search.best[node].map_or(u64::MAX, |o| o.price);
    let mut node = ends.min_by_key(price).unwrap_or(0);
    let mut pieces = Vec::new();
    while let Some(offer) = search.best[node].filter(|_| node > 0) {
        pieces.push(RecordCandidate {
            start: offer.from / STATES,
            end: node / STATES,
            verdict: offer.verdict,
        });
        node = offer.from;
    }
    pieces.reverse();
    pieces
}

/// How many records that look right begin before each token.
fn heads_before(stretch: &Stretch) -> Vec<u32> {
    let mut n = 0;
    let mut all = vec![0];
    all.extend((0..stretch.len()).map(|at| {
        let head = stretch.read(at).filter(|r| r.end > at + 2);
        n += u32::from(head.is_some_and(|r| !stretch.is_odd(at, r)));
        n
    }));
    all
}

/// The types without a count, by how many parameters they take.
fn types_by_arity() -> Vec<Vec<&'static RecordType>> {
    let mut all = vec![Vec::new(); MAX_PARAMS + 1];
    let fixed =
        (RECORD_TYPES.iter()).filter(|t| !t.is_counted() && t.kind != RecordKind::Undefined);
    for ty in fixed {
        let base = ty.params.len();
        all[base].push(ty);
        if !ty.optional.is_empty() {
            all[base + ty.optional.len()].push(ty);
        }
    }
    all
}

/// A way to a place: its price, and its last piece.
#[derive(Debug, Clone, Copy)]
struct Offer {
    /// The place and the state before the piece.
    from: usize,
    price: u64,
    id: Id,
    ty: Option<&'static RecordType>,
    verdict: Diagnosis,
}

/// The ID and the type of a record.
#[derive(Debug, Clone, Copy)]
struct Head {
    id: Id,
    ty: &'static RecordType,
    /// The value of the count parameter, 0 for a type without one.
    count: u64,
    /// The first of the parameters.
    first: usize,
}

struct Search<'a, 's> {
    stretch: &'a Stretch<'s>,
    ways: PartialParses<'a, 's>,
    types: Vec<Vec<&'static RecordType>>,
    heads_before: Vec<u32>,
    /// For each place and state the cheapest way to it.
    best: Vec<Option<Offer>>,
    /// The place and the state that pieces begin with now.
    here: usize,
}

impl Search<'_, '_> {
    /// Offers the piece from `start` to `end` as the next one, at a price.
    fn offer(
        &mut self,
        (start, end): (usize, usize),
        price: u32,
        (id, ty): (Id, Option<&'static RecordType>),
        verdict: Diagnosis,
    ) {
        let Some(before) = self.best[self.here] else {
            return;
        };
        let mut state = self.here % STATES;
        if !matches!(verdict, Diagnosis::Whole(_) | Diagnosis::Void) {
            state ^= FAULTS;
        }
        if matches!(id, Id::Lost) {
            state ^= LOST;
        }
        let within = self.heads_before[end] - self.heads_before[start + 1];
        let price = before.price + u64::from(price + HEAD_WITHIN * within);
        let best = &mut self.best[STATES * end + state];
        if best.is_none_or(|best| price < best.price) {
            *best = Some(Offer {
                from: self.here,
                price,
                id,
                ty,
                verdict,
            });
        }
    }

    /// The number that may be an ID at a token.
    fn id_at(&self, at: usize) -> Option<u32> {
        let id = self.stretch.sigs.get(at)?.int?;
        u32::try_from(id).ok().filter(|&id| id > 0)
    }

    /// The head of a record of type `ty` whose parameters begin at token `first`; `None` if a count is needed and
    /// cannot be used.
    fn head(&self, id: Id, ty: &'static RecordType, first: usize) -> Option<Head> {
        let count = match ty.is_counted() {
            true => heads::point_count(self.stretch, first).ok()?,
            false => 0,
        };
        Some(Head {
            id,
            ty,
            count,
            first,
        })
    }

    /// The ends of a record with this head, without its optional group and with it.
    fn ends(&self, head: &Head) -> [Option<usize>; 2] {
        let base = (head.first as u64).saturating_add(head.ty.arity(head.count));
        let base = usize::try_from(base)
            .ok()
            .filter(|&end| end <= self.stretch.len() + MAX_NUMBERS_OFF);
        let group = head.ty.optional.len();
        [base, base.map(|end| end + group).filter(|_| group > 0)]
    }

    /// Like [`ends`](Self::ends), but only the ends up to which no parameter is a bad token.
    fn right_ends(&self, head: &Head) -> impl Iterator<Item = usize> + use<> {
        self.ends(head)
            .map(|end| {
                let end = end.filter(|&end| end <= self.stretch.len())?;
                (self.bad(head.ty, head.first, end) == 0).then_some(end)
            })
            .into_iter()
            .flatten()
    }

    /// How many of tokens `first..end` are bad tokens, and so no parameters of a record of type `ty`.
    fn bad(&self, ty: &RecordType, first: usize, end: usize) -> u32 {
        let named = faults::file_name(self.stretch, ty, first, end).is_some();
        self.stretch.bad(first, end) - u32::from(named)
    }

    /// The price of doubts about the ID and the parameters of a record that begins here and ends at `end`.
    fn doubts(&self, head: &Head, end: usize) -> u32 {
        let id = match head.id {
            Id::Is(id) => self.ways.id(id, Some(head.ty), self.here),
            Id::Lost | Id::None => 0,
        };
        id + self.params(head, end)
    }

    /// The price of doubts about the parameters of a record, some of which may be missing or too many.
    fn params(&self, head: &Head, end: usize) -> u32 {
        let got = end - head.first;
        let looked_at = got.min(PARAMS_MAX);
        let doubt = |i: usize, param: usize| {
            let param = head.ty.param(param, head.count as usize);
            param.map_or(0, |param| {
                self.ways.param(head.first + i, head.ty, param, self.here)
            })
        };
        let base = usize::try_from(head.ty.arity(head.count)).unwrap_or(usize::MAX);
        let full = base + head.ty.optional.len();
        let wanted = if got.abs_diff(base) <= got.abs_diff(full) {
            base
        } else {
            full
        };
        // The parameters before the mistake are in their own places; those behind it are shifted.
        let (more, fewer) = (got.saturating_sub(wanted), wanted.saturating_sub(got));
        let (mut before, mut behind) = (0, 0);
        for i in more..looked_at {
            behind += doubt(i, i + fewer - more);
        }
        if more + fewer == 0 {
            return behind;
        }
        let mut least = u32::MAX;
        for i in 0..=looked_at {
            let dropped = match more > 0 && i < looked_at {
                true => self.ways.like_an_id(head.first + i, self.here),
                false => 0,
            };
            least = least.min(before + behind + dropped);
            if i < looked_at {
                before += doubt(i, i);
            }
            if i + more < looked_at {
                behind -= doubt(i + more, i + fewer);
            }
        }
        least
    }

    /// Tries the records that can be read from a token on.
    fn records(&mut self, at: usize) {
        let stretch = self.stretch;
        if stretch.sigs[at].int == Some(0) {
            let price = match stretch.sigs[at].before_comment {
                true => 0,
                false => LONE_VOID,
            };
            self.offer((at, at + 1), price, (Id::None, None), Diagnosis::Void);
        }
        let (Some(&r), Some(id)) = (stretch.read(at), self.id_at(at)) else {
            return;
        };
        let Some(head) = self.head(Id::Is(id), r.ty, at + 2) else {
            return;
        };
        // Both ways to read the optional group are tried, since a mistake further on may have decided about it.
        for end in self.right_ends(&head) {
            let doubts = self.doubts(&head, end).min(DOUBTS_MAX);
            if end != r.end && faults::wrong_kinds(stretch, r.ty, head.first, end) > 0 {
                continue;
            }
            let price = doubts + if end == r.end { 0 } else { OTHER_WAY };
            let verdict = Diagnosis::Whole(Reading { end, ..r });
            self.offer((at, end), price, (head.id, Some(r.ty)), verdict);
        }
    }
}
