//! N610: a property or a transformation of an object that stands among the records of another object, which has none of
//! its kind.

use rustc_hash::{FxHashMap, FxHashSet};

use super::{OPTICS, TEXTURES_AND_COLOURS, optics_by_comment};
use crate::diagnostics::{Applicability, Code, Diagnostic, Fix, Value};
use crate::lint::Context;
use crate::syntax::table::{Effect, Kind, RecordKind, ShapeKind};
use crate::syntax::words;
use crate::syntax::{Record, quote};

/// The fewest letters of a word by which a comment names an object.
const LEAST_LETTERS: usize = 4;

/// Kinds of changes, a bit each. An assignment gives a look and optics.
type Changes = u8;
const LOOK: Changes = 1;
const PARTS: Changes = 2;
const TURN: Changes = 4;
const SCALE: Changes = 8;
const MOVE: Changes = 16;

/// The changes that a record makes.
fn changes(kind: RecordKind) -> Changes {
    match kind {
        RecordKind::Assignment => LOOK | PARTS,
        RecordKind::Rotation | RecordKind::RotationMatrix => TURN,
        RecordKind::Scaling => SCALE,
        RecordKind::Translation => MOVE,
        kind if TEXTURES_AND_COLOURS.contains(&kind) => LOOK,
        kind if OPTICS.contains(&kind) => PARTS,
        _ => 0,
    }
}

/// A change of an object among the records of another one.
struct Stray<'a> {
    record: &'a Record,
    /// The definition of the object whose records are above.
    other: &'a Record,
    /// Whether the file shows that the records of one object stand together here.
    is_told: bool,
}

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    if context.has_broken() {
        return;
    }
    // For each ID the changes that it has, and those that it has more than once.
    let mut given: FxHashMap<u32, [Changes; 2]> = FxHashMap::default();
    for record in context.records() {
        let changes = changes(record.kind);
        let [once, again] = given.entry(record.id).or_default();
        *again |= *once & changes;
        *once |= changes;
    }
    let mut objects: FxHashMap<u32, &Record> = FxHashMap::default();
    let mut used: FxHashSet<u32> = FxHashSet::default();
    // Objects with changes right below their definition.
    let mut grouped: FxHashSet<u32> = FxHashSet::default();
    let mut other: Option<&Record> = None;
    let mut strays: Vec<Stray> = Vec::new();
    let mut records = context.records().peekable();
    while let Some(record) = records.next() {
        used.extend(context.references(record));
        if matches!(record.ty().effect, Effect::Defines(Kind::Object)) {
            objects.insert(record.id, record);
            other = Some(record);
            continue;
        }
        let Some(above) = other else { continue };
        if above.id == record.id {
            grouped.insert(record.id);
            continue;
        }
        let changes = changes(record.kind);
        let is_between = records.peek().is_some_and(|next| next.id == above.id);
        let is_stray = changes != 0
            // Objects are often moved after all are defined.
            && (changes != MOVE || is_between)
            && objects.contains_key(&record.id)
            && !used.contains(&record.id)
            && given[&above.id][0] & changes == 0
            // Other rules speak of what is given twice.
            && given[&record.id][1] & changes == 0;
        if !is_stray {
            other = None;
            continue;
        }
        // Between two records of the other object, or a turn of a ball, which is hardly meant.
        let is_within = is_between
            && (changes == MOVE
                || grouped.contains(&above.id)
                || changes == TURN && is_ball(objects[&record.id]));
        strays.push(Stray {
            record,
            other: above,
            is_told: is_within || grouped.contains(&record.id),
        });
    }
    // Several show that records of one object do not stand together here.
    let [stray] = &strays[..] else { return };
    if stray.is_told && !is_meant(context, stray, objects[&stray.record.id]) {
        out.push(finding(context, stray));
    }
}

fn is_ball(record: &Record) -> bool {
    let (ball, at_origin) = (ShapeKind::Sphere, ShapeKind::SphereAtOrigin);
    [ball, at_origin]
        .map(RecordKind::Shape)
        .contains(&record.kind)
}

/// Whether the record rather belongs to the object that it names: something separates it from the records above, a comment
/// says so, or it would do nothing to the other object. Of a mirror without optics W342 speaks.
fn is_meant(context: &Context, stray: &Stray, own: &Record) -> bool {
    let changes = changes(stray.record.kind);
    let p = context.record_params(stray.record);
    let has_heading = (context.document.comments_before(stray.record))
        .next()
        .is_some();
    let above = &context.text[..p.span().start as usize];
    let space = &above[above.trim_end().len()..];
    has_heading
        || space.matches('\n').count() > 1
        || is_ball(stray.other) && changes == TURN
        || changes == PARTS && optics_by_comment::calls(context, stray.other)
        || p.own_comments()
            .any(|said| names(context, said, own, stray.other))
}

/// Whether a comment names one object and not another one: by its shape, or by a word of a comment on it.
fn names(context: &Context, said: &str, own: &Record, other: &Record) -> bool {
    let split = |text: &str| -> Vec<String> {
        let words = words::of_text(text);
        words
            .filter(|w| w.chars().count() >= LEAST_LETTERS)
            .collect()
    };
    let called = |record: &Record| -> FxHashSet<String> {
        let p = context.record_params(record);
        p.own_comments().flat_map(split).collect()
    };
    let (of_own, of_other) = (called(own), called(other));
    let is = |record: &Record, called: &FxHashSet<String>, word: &String| {
        let shapes = words::shapes(word);
        called.contains(word) || shapes.iter().any(|ty| ty.code == record.ty().code)
    };
    split(said)
        .iter()
        .any(|word| is(own, &of_own, word) && !is(other, &of_other, word))
}

fn finding(context: &Context, stray: &Stray) -> Diagnostic {
    let p = context.record_params(stray.record);
    let id = stray.other.id.to_string();
    let fix = Fix::replace("fix-write", Applicability::Choice, p.id_span(), id.clone());
    Diagnostic::new(Code::N610, p.span())
        .with("change", Value::Term(p.ty.title))
        .with("type", Value::Term(stray.other.ty().title))
        .with("id", p.id.to_string())
        .with("other", id.clone())
        .label(context.record_params(stray.other).span(), "first")
        .fix(fix.with("number", quote(&id)))
}
