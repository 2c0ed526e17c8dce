//! W334: a property that a later record of the same kind, an assignment, or a texture overrides before anything uses it.

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
const MAX_PROPOSED: usize = 16;

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let pairs = pairs(context);
    let titles = match pairs.is_empty() {
        true => return,
        false => context.titles(),
    };
    for (i, (first, second)) in pairs.into_iter().enumerate() {
        let span = |r: &Record| context.document.span(r.first, r.last);
        let title = titles.get(&second.id).copied().unwrap_or("object");
        let mut d = Diagnostic::new(Code::W334, span(first))
            .with("change", Value::Term(first.ty().title))
            .with("type", Value::Term(title))
            .with("id", first.id.to_string())
            .case(match second.kind {
                kind if kind == first.kind => "",
                RecordKind::Assignment => "assigned",
                _ => "textured",
            })
            .label(span(second), "second");
        if i < MAX_PROPOSED {
            d.fixes = neighbours(context, second);
        }
        out.push(d);
    }
}

fn is_colour(record: &Record) -> bool {
    record.kind == RecordKind::Colour
}

/// The objects whose optics are given twice: a record about one of them may be meant for another.
pub(super) fn with_two_optics(context: &Context) -> FxHashSet<u32> {
    let pairs = pairs(context).into_iter();
    let of_optics = pairs.filter(|(first, _)| first.ty().gives_optics());
    of_optics.map(|(first, _)| first.id).collect()
}

/// The records without effect, each with the one that overrides it.
fn pairs<'a>(context: &Context<'a>) -> Vec<(&'a Record, &'a Record)> {
    let mut pairs = Vec::new();
    if context.has_broken() {
        return pairs;
    }
    // For each ID the last record of each kind since the ID was used.
    let mut unused: FxHashMap<u32, [Option<&Record>; KINDS.len()]> = FxHashMap::default();
    let mut defined: FxHashSet<u32> = FxHashSet::default();
    for record in context.records() {
        let changes = matches!(record.ty().effect, Effect::Changes(_));
        if !changes {
            defined.insert(record.id);
        }
        for id in context.references(record) {
            unused.remove(&id);
        }
        let kind = KINDS.iter().position(|kind| *kind == record.kind);
        if super::TEXTURES.contains(&record.kind)
            && let Some(last) = unused.get_mut(&record.id)
        {
            let mut colours = (last.iter_mut()).filter(|r| r.is_some_and(is_colour));
            pairs.extend(colours.find_map(|last| Some((last.take()?, record))));
        }
        // Of what stands above its definition another finding speaks.
        if let Some(kind) = kind.filter(|_| defined.contains(&record.id)) {
            let last = unused.entry(record.id).or_default();
            let first = last[kind].replace(record);
            pairs.extend(first.map(|first| (first, record)));
            if record.kind == RecordKind::Assignment {
                // It gives the optics as well, as 0 does.
                let gives = |last: &Option<&Record>| last.is_some_and(|r| r.ty().gives_optics());
                let of_optics = last.iter_mut().filter(|last| gives(last));
                pairs.extend(of_optics.filter_map(|last| Some((last.take()?, record))));
            }
        }
    }
    pairs
}

/// The second record with the ID of what was defined shortly before, has no such record, and is not used before that.
/// Right under the records of such a one that one alone is meant: the line above was copied, and its ID was not changed.
fn neighbours(context: &Context, second: &Record) -> Vec<Fix> {
    let head = context.document.id_token(second).span();
    let is_light = |kind: Option<Kind>| matches!(kind, Some(Kind::PointLight | Kind::AmbientLight));
    let given = context.records().filter(|r| r.kind == second.kind);
    let mut taken: FxHashSet<u32> = given.map(|r| r.id).collect();
    let before = context.records().take_while(|r| r.first < second.first);
    let mut above = None;
    for record in before {
        taken.extend(context.references(record));
        above = Some(record.id);
    }
    let mut entities = context.scene.entities.iter();
    let own = entities.find(|e| e.id == second.id).and_then(|e| e.kind);
    if own != Some(Kind::Object) && !is_light(own) {
        return Vec::new();
    }
    let is_such = |e: &&Entity| {
        let is_of_kind = e.kind == own || is_light(e.kind) && is_light(own);
        is_of_kind && e.span.start < head.start && !taken.contains(&e.id)
    };
    let meant = context.scene.entities.iter().rev().filter(is_such);
    let mut meant: Vec<u32> = meant.map(|e| e.id).collect();
    if let Some(id) = above.filter(|id| meant.contains(id)) {
        meant = vec![id];
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
