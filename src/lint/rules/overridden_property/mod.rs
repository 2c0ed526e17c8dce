//! W334: a property that a later record of the same kind, or an assignment, overrides before anything uses it.

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
    if context.has_broken() {
        return;
    }
    // For each ID the last record of each kind since the ID was used.
    let mut unused: FxHashMap<u32, [Option<&Record>; KINDS.len()]> = FxHashMap::default();
    let mut defined: FxHashSet<u32> = FxHashSet::default();
    let mut pairs = Vec::new();
    for record in context.records() {
        let changes = matches!(record.ty().effect, Effect::Changes(_));
        if !changes {
            defined.insert(record.id);
        }
        for id in context.references(record) {
            unused.remove(&id);
        }
        let kind = KINDS.iter().position(|kind| *kind == record.kind);
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
            .case(match first.kind == second.kind {
                true => "",
                false => "assigned",
            })
            .label(span(second), "second");
        if i < MAX_PROPOSED {
            d.fixes = neighbours(context, second);
        }
        out.push(d);
    }
}

/// The second record with the ID of an object that was defined shortly before, has no such record, and is not used
/// before that.
fn neighbours(context: &Context, second: &Record) -> Vec<Fix> {
    let head = context.document.id_token(second).span();
    let given = context.records().filter(|r| r.kind == second.kind);
    let mut taken: FxHashSet<u32> = given.map(|r| r.id).collect();
    let before = context.records().take_while(|r| r.first < second.first);
    taken.extend(before.flat_map(|r| context.references(r)));
    let is_object = |e: &&Entity| e.kind == Some(Kind::Object) && e.span.start < head.start;
    let mut entities = context.scene.entities.iter();
    let own = entities.find(|e| e.id == second.id);
    if own.is_none_or(|e| e.kind != Some(Kind::Object)) {
        return Vec::new();
    }
    let objects = context.scene.entities.iter().rev().filter(is_object);
    let meant = objects.filter(|e| !taken.contains(&e.id)).take(PROPOSALS);
    meant
        .map(|e| {
            let text = e.id.to_string();
            let number = quote(&text);
            let mut fix = Fix::guess("fix", vec![Edit { span: head, text }]);
            fix.applicability = Applicability::Choice;
            fix.with("number", number)
        })
        .collect()
}
