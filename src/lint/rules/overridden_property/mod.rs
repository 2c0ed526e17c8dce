//! W334: a property that a later record of the same kind, an assignment or a texture overrides before anything uses it;
//! and a property of a whole object that overrides those of several parts.

mod taken_back;
mod whole;

use rustc_hash::{FxHashMap, FxHashSet};

use crate::diagnostics::{Applicability, Code, Diagnostic, Edit, Fix, Value};
use crate::lint::Context;
use crate::scene::Entity;
use crate::syntax::Record;
use crate::syntax::quote;
use crate::syntax::table::{Effect, Kind, RecordKind};

/// The kinds of records that give all that an earlier record of the same kind gives. W331 reports textures.
const KINDS: [RecordKind; 5] = [
    RecordKind::Assignment,
    RecordKind::Colour,
    RecordKind::Optics,
    RecordKind::OpticsRgb,
    RecordKind::RefractiveIndex,
];

/// Most objects that one finding proposes.
const PROPOSALS: usize = 2;

/// Most findings with proposals: each one searches the whole scene.
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

/// The case of an assignment whose texture T is 0, behind a record that gave a texture or a colour.
const TAKEN_BACK: &str = "taken-back";

fn is_colour(record: &Record) -> bool {
    record.kind == RecordKind::Colour
}

/// Whether T of an assignment is 0.
fn takes_back(context: &Context, assignment: &Record) -> bool {
    context.record_params(assignment).integer(0) == 0
}

/// For each record that overrides another one, by its start in the text: whether it is an assignment that takes a
/// texture or a colour back.
pub(super) fn overriding(context: &Context) -> FxHashMap<u32, bool> {
    let mut overriding = FxHashMap::default();
    for pair in pairs(context) {
        let start = context.document.tokens[pair.second.first as usize].start;
        *overriding.entry(start).or_default() |= pair.case == TAKEN_BACK;
    }
    overriding
}

/// The IDs of the objects whose optics are given twice: one of the two records may be meant for another object.
pub(super) fn with_two_optics(context: &Context) -> FxHashSet<u32> {
    let pairs = pairs(context).into_iter();
    let of_optics = pairs.filter(|pair| pair.first.ty().gives_optics());
    of_optics.map(|pair| pair.first.id).collect()
}

/// Whether a record gives the parts of the light that are scattered, reflected and let through.
fn gives_parts(record: &Record) -> bool {
    matches!(record.kind, RecordKind::Optics | RecordKind::OpticsRgb)
}

/// The ID of the only optics with an index and no parts of the light, if exactly one pair gives other optics these
/// parts twice: the second record is rather meant for that ID. `None` otherwise.
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

/// The ID of the optics whose parts of the light another ID has by a slip. W334 reports the slip, and so no other rule
/// needs to report the index.
pub(super) fn with_lost_parts(context: &Context) -> Option<u32> {
    without_parts(context, &pairs(context))
}

/// The records about an ID since its last use: the last one of each kind.
#[derive(Default)]
struct Unused<'a> {
    of_kind: [Option<&'a Record>; KINDS.len()],
    texture: Option<&'a Record>,
}

impl<'a> Unused<'a> {
    /// Adds a record, whose kind has the index `kind` in [`KINDS`]. Returns the pair with the record that it overrides.
    fn add(&mut self, record: &'a Record, kind: usize) -> Option<Pair<'a>> {
        let first = self.of_kind[kind].replace(record)?;
        let (second, case) = (record, "");
        Some(Pair {
            first,
            second,
            case,
        })
    }

    /// Adds a texture. Returns the pair with the colour that it covers.
    fn add_texture(&mut self, second: &'a Record) -> Option<Pair<'a>> {
        self.texture = Some(second);
        let (first, case) = (self.take_colour()?, "textured");
        Some(Pair {
            first,
            second,
            case,
        })
    }

    /// Adds the pairs of an assignment with the colour, texture and optics that it overrides. A texture counts only
    /// where the assignment takes it back: W331 reports one that another texture covers.
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
        // An assignment gives the optics as well, even where it names 0.
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

    /// Whether no unused record gives a texture or a colour, so that an object can have them from an assignment only.
    fn is_plain(&self) -> bool {
        self.texture.is_none() && !self.of_kind.iter().flatten().any(|r| is_colour(r))
    }

    /// Takes out the colour record that nothing has overridden yet.
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
        // Another finding reports a record that stands above the definition of its ID.
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

/// Fixes that give the second record the ID of another object: one that is defined above, has no record of this kind,
/// and is not used before. The objects defined last come first. If the line above is about one of them, that one alone
/// is proposed: the line was copied, and its ID was not changed. A record about optics, a texture or a colour is
/// proposed only for an object right above it.
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
