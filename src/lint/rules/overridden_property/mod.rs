//! W334: a property that a later record of the same kind, an assignment, or a texture overrides before anything uses it;
//! and one of a whole object that overrides several of its parts.

mod taken_back;
mod whole;

use rustc_hash::{FxHashMap, FxHashSet};

use crate::diagnostics::{Applicability, Code, Diagnostic, Edit, Fix, Value};
use crate::lint::Context;
use crate::scene::Entity;
use crate::syntax::Record;
use crate::syntax::quote;
use crate::syntax::table::{Effect, Kind, RecordKind};

/// Each gives all that another one of its kind gives. Of textures W331 speaks.
const KINDS: [RecordKind; 5] = [
    RecordKind::Assignment,
    RecordKind::Colour,
    RecordKind::Optics,
    RecordKind::OpticsRgb,
    RecordKind::RefractiveIndex,
];

/// The most objects that are proposed.
const PROPOSALS: usize = 2;

/// Findings that get proposals: each looks through the whole scene for them.
pub(super) const MAX_PROPOSED: usize = 16;

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    whole::check(context, out);
    let pairs = pairs(context);
    let titles = match pairs.is_empty() {
        true => return,
        false => context.titles(),
    };
    let lacking = without_parts(context, &pairs);
    for (i, pair) in pairs.into_iter().enumerate() {
        let Pair {
            first,
            second,
            case,
        } = pair;
        let span = |r: &Record| context.document.span(r.first, r.last);
        let title = titles.get(&second.id).copied().unwrap_or("object");
        let mut d = Diagnostic::new(Code::W334, span(first))
            .with("change", Value::Term(first.ty().title))
            .with("type", Value::Term(title))
            .with("id", first.id.to_string())
            .case(case)
            .label(span(second), "second");
        if let Some(id) = lacking.filter(|_| case.is_empty() && gives_parts(second)) {
            let text = id.to_string();
            let number = quote(&text);
            let head = context.document.id_token(second).span();
            let fix = Fix::guess("fix", vec![Edit { span: head, text }]).with("number", number);
            d = d.case("index").with("other-id", id.to_string()).fix(fix);
        } else if i < MAX_PROPOSED {
            d.fixes = neighbours(context, second);
            if case == TAKEN_BACK {
                taken_back::propose(context, first, second, &mut d.fixes);
            }
        }
        out.push(d);
    }
}

/// A record without effect, and the one that overrides it.
struct Pair<'a> {
    first: &'a Record,
    second: &'a Record,
    case: &'static str,
}

/// The case of an assignment whose T is 0, behind what gave a texture or a colour.
const TAKEN_BACK: &str = "taken-back";

fn is_colour(record: &Record) -> bool {
    record.kind == RecordKind::Colour
}

/// Whether T of an assignment is 0.
fn takes_back(context: &Context, assignment: &Record) -> bool {
    context.record_params(assignment).integer(0) == 0
}

/// The places of the records that override another one, each with whether it is an assignment that takes a texture or a
/// colour back.
pub(super) fn overriding(context: &Context) -> FxHashMap<u32, bool> {
    let mut overriding = FxHashMap::default();
    for pair in pairs(context) {
        let start = context.document.tokens[pair.second.first as usize].start;
        *overriding.entry(start).or_default() |= pair.case == TAKEN_BACK;
    }
    overriding
}

/// The objects whose optics are given twice: a record about one of them may be meant for another.
pub(super) fn with_two_optics(context: &Context) -> FxHashSet<u32> {
    let pairs = pairs(context).into_iter();
    let of_optics = pairs.filter(|pair| pair.first.ty().gives_optics());
    of_optics.map(|pair| pair.first.id).collect()
}

/// Whether a record says what part of the light is reflected, and what goes through.
fn gives_parts(record: &Record) -> bool {
    matches!(record.kind, RecordKind::Optics | RecordKind::OpticsRgb)
}

/// The only optics that have an index and no parts, where exactly one pair gives other optics parts twice: the second are
/// rather theirs.
fn without_parts(context: &Context, pairs: &[Pair]) -> Option<u32> {
    let is_twice = |pair: &&Pair| pair.case.is_empty() && gives_parts(pair.second);
    let mut twice = pairs.iter().filter(is_twice);
    let (one, None) = (twice.next()?, twice.next()) else {
        return None;
    };
    let with_parts = |r: &&Record| gives_parts(r);
    let given: FxHashSet<u32> = context.records().filter(with_parts).map(|r| r.id).collect();
    let is_optics = |e: &&Entity| e.kind == Some(Kind::Optics);
    let entities = || context.scene.entities.iter().filter(is_optics);
    entities().find(|e| e.id == one.second.id)?;
    let mut meant = entities().filter(|e| !given.contains(&e.id));
    let (only, None) = (meant.next()?, meant.next()) else {
        return None;
    };
    Some(only.id)
}

/// The optics whose parts are given to others by a slip of an ID: what their index lacks is said there.
pub(super) fn with_lost_parts(context: &Context) -> Option<u32> {
    without_parts(context, &pairs(context))
}

/// The records about an ID since the ID was used, the last one of each kind.
#[derive(Default)]
struct Unused<'a> {
    of_kind: [Option<&'a Record>; KINDS.len()],
    texture: Option<&'a Record>,
}

impl<'a> Unused<'a> {
    /// Adds a record of one of the kinds, and gives the one that it overrides.
    fn add(&mut self, record: &'a Record, kind: usize) -> Option<Pair<'a>> {
        let first = self.of_kind[kind].replace(record)?;
        let (second, case) = (record, "");
        Some(Pair {
            first,
            second,
            case,
        })
    }

    /// Adds a texture, and gives the colour that it covers.
    fn add_texture(&mut self, second: &'a Record) -> Option<Pair<'a>> {
        self.texture = Some(second);
        let (first, case) = (self.take_colour()?, "textured");
        Some(Pair {
            first,
            second,
            case,
        })
    }

    /// Adds what an assignment overrides beside another one. A texture that another covers is not among it.
    fn assign(&mut self, context: &Context, second: &'a Record, pairs: &mut Vec<Pair<'a>>) {
        let colour = self.take_colour();
        let (texture, case) = match (self.texture.take(), takes_back(context, second)) {
            (texture, true) => (texture, TAKEN_BACK),
            (_, false) => (None, "given"),
        };
        pairs.extend(colour.or(texture).map(|first| Pair {
            first,
            second,
            case,
        }));
        // It gives the optics as well, as 0 does.
        let gives = |last: &&mut Option<&Record>| last.is_some_and(|r| r.ty().gives_optics());
        let of_optics = self.of_kind.iter_mut().filter(gives);
        let of_optics = of_optics.filter_map(Option::take);
        let case = "assigned";
        pairs.extend(of_optics.map(|first| Pair {
            first,
            second,
            case,
        }));
    }

    /// Whether an object has its texture or colour from an assignment, for all that is unused.
    fn is_plain(&self) -> bool {
        self.texture.is_none() && !self.of_kind.iter().flatten().any(|r| is_colour(r))
    }

    /// The colour that nothing has overridden, which then is so.
    fn take_colour(&mut self) -> Option<&'a Record> {
        let mut colours = self.of_kind.iter_mut();
        colours.find_map(|last| last.take_if(|r| is_colour(r)))
    }
}

/// The records without effect, each with the one that overrides it.
fn pairs<'a>(context: &Context<'a>) -> Vec<Pair<'a>> {
    let mut pairs = Vec::new();
    if context.has_broken() {
        return pairs;
    }
    let mut unused: FxHashMap<u32, Unused> = FxHashMap::default();
    let mut defined: FxHashSet<u32> = FxHashSet::default();
    for record in context.records() {
        let changes = matches!(record.ty().effect, Effect::Changes(_));
        if !changes {
            defined.insert(record.id);
        }
        for id in context.references(record) {
            unused.remove(&id);
        }
        // Of what stands above its definition another finding speaks.
        if !defined.contains(&record.id) {
            continue;
        }
        let kind = KINDS.iter().position(|kind| *kind == record.kind);
        if super::TEXTURES.contains(&record.kind) {
            let last = unused.entry(record.id).or_default();
            pairs.extend(last.add_texture(record));
        } else if let Some(kind) = kind {
            let last = unused.entry(record.id).or_default();
            let is_plain = last.is_plain();
            let pair = last.add(record, kind);
            let is_assignment = record.kind == RecordKind::Assignment;
            let is_taken_back = |first: &Record| {
                is_assignment
                    && is_plain
                    && takes_back(context, record)
                    && !takes_back(context, first)
            };
            pairs.extend(pair.map(|pair| match is_taken_back(pair.first) {
                true => Pair {
                    case: TAKEN_BACK,
                    ..pair
                },
                false => pair,
            }));
            if is_assignment {
                last.assign(context, record, &mut pairs);
            }
        }
    }
    pairs
}

/// The second record with the ID of what was defined shortly before, has no such record, and is not used before that.
/// Right under the records of such a one that one alone is meant: the line above was copied, and its ID was not changed.
/// A record of a property is meant for an object right above it only.
pub(super) fn neighbours(context: &Context, second: &Record) -> Vec<Fix> {
    let head = context.document.id_token(second).span();
    let is_light = |kind: Option<Kind>| matches!(kind, Some(Kind::PointLight | Kind::AmbientLight));
    let is_assignment = |r: &Record| r.kind == RecordKind::Assignment;
    let gives = |r: &Record| {
        [
            super::TEXTURES_AND_COLOURS.contains(&r.kind) || is_assignment(r),
            matches!(r.kind, RecordKind::Optics | RecordKind::OpticsRgb) || is_assignment(r),
            r.kind == RecordKind::RefractiveIndex,
        ]
    };
    // An assignment takes back an index that stands before it, and none that follows.
    let own = gives(second).map(|gives| gives || is_assignment(second));
    let is_other = |r: &Record| {
        let of = gives(r);
        r.kind == second.kind || (0..own.len()).any(|i| own[i] && of[i])
    };
    let given = context.records().filter(|r| is_other(r));
    let mut taken: FxHashSet<u32> = given.map(|r| r.id).collect();
    let before = context.records().take_while(|r| r.first < second.first);
    let mut above = None;
    for record in before {
        taken.extend(context.references(record));
        above = Some(record.id);
    }
    let mut entities = context.scene.entities.iter();
    let own = entities.find(|e| e.id == second.id).and_then(|e| e.kind);
    let is_property = matches!(own, Some(Kind::Optics | Kind::Texture | Kind::Colour));
    if own != Some(Kind::Object) && !is_light(own) && !is_property {
        return Vec::new();
    }
    let wanted = own.filter(|_| !is_property).unwrap_or(Kind::Object);
    let is_such = |e: &&Entity| {
        let is_of_kind = e.kind == Some(wanted) || is_light(e.kind) && is_light(own);
        is_of_kind && e.span.start < head.start && !taken.contains(&e.id)
    };
    let meant = context.scene.entities.iter().rev().filter(is_such);
    let mut meant: Vec<u32> = meant.map(|e| e.id).collect();
    if let Some(id) = above.filter(|id| meant.contains(id)) {
        meant = vec![id];
    } else if is_property {
        return Vec::new();
    }
    meant.truncate(PROPOSALS);
    meant
        .into_iter()
        .map(|id| {
            let text = id.to_string();
            let number = quote(&text);
            let mut fix = Fix::guess("fix", vec![Edit { span: head, text }]);
            fix.applicability = Applicability::Choice;
            fix.with("number", number)
        })
        .collect()
}
