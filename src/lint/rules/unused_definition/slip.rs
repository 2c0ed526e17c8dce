//! Guesses at the purpose of a definition that nothing needs: a refractive index for another object, by a slip of its
//! ID; a place of a lamp.

use rustc_hash::FxHashSet;

use crate::diagnostics::{Applicability, Edit, Fix, Span, Value};
use crate::lint::Context;
use crate::scene::{Entity, Node};
use crate::syntax::table::{Effect, Kind, RecordKind, RecordType};
use crate::syntax::{Record, quote};

/// The fixes that give an index to a transparent object without one, if the two IDs differ in one digit or in the order
/// of two digits. Swapped digits come first.
pub(super) fn of_a_transparent_one(context: &Context, property: &Entity) -> Vec<Fix> {
    if !is_mere_index(context, property) {
        return Vec::new();
    }
    let gives = |kind| matches!(kind, RecordKind::RefractiveIndex | RecordKind::Assignment);
    let given = context.records().filter(|r| gives(r.kind)).map(|r| r.id);
    let given: FxHashSet<u32> = given.collect();
    let written = property.id.to_string();
    let mut meant: Vec<(bool, u32)> = (context.scene.entities.iter())
        .filter(|e| e.kind == Some(Kind::Object) && e.span.start < property.span.start)
        .filter(|e| !given.contains(&e.id) && is_transparent(context, e))
        .filter(|e| strsim::osa_distance(&written, &e.id.to_string()) == 1)
        .map(|e| (strsim::levenshtein(&written, &e.id.to_string()) == 1, e.id))
        .collect();
    meant.sort_unstable();
    let start = property.span.start;
    let head = Span::new(start, start + written.len() as u32);
    let is_one = meant.len() == 1;
    let fix = |(_, id): (bool, u32)| {
        let text = id.to_string();
        let number = quote(&text);
        let mut fix = Fix::guess("fix-write", vec![Edit { span: head, text }]);
        if !is_one {
            fix.applicability = Applicability::Choice;
        }
        fix.with("number", number)
    };
    meant.into_iter().map(fix).collect()
}

/// The fix that gives a property the ID of the object whose record stands right above, if that object is drawn and has
/// no such property. The fix is a choice, unless the two IDs differ in one digit or in the order of two digits.
pub(super) fn of_the_object_above(
    context: &Context,
    property: &Entity,
    is_drawn: impl Fn(u32) -> bool,
) -> Option<Fix> {
    let kind = property.kind?;
    let document = context.document;
    let start = |r: &Record| document.id_token(r).start;
    let goes_with = super::assign::goes_with(context, property);
    let gives = |r: &Record| match r.ty().effect {
        Effect::DefinesOrChanges(Kind::Texture | Kind::Colour, _) => kind != Kind::Optics,
        Effect::DefinesOrChanges(Kind::Optics, _) => kind == Kind::Optics && !goes_with(r),
        _ => r.kind == RecordKind::Assignment,
    };
    let (mut above, mut given) = (None, FxHashSet::default());
    for record in context.records() {
        if start(record) < property.span.start {
            above = Some(record.id);
        }
        given.extend(gives(record).then_some(record.id));
    }
    let id = above.filter(|&id| !given.contains(&id) && is_drawn(id))?;
    let mut entities = context.scene.entities.iter();
    entities.find(|e| e.id == id && e.kind == Some(Kind::Object))?;
    let (written, text) = (property.id.to_string(), id.to_string());
    let is_alike = strsim::osa_distance(&written, &text) == 1 && written.len() == text.len();
    let head = Span::new(
        property.span.start,
        property.span.start + written.len() as u32,
    );
    let number = quote(&text);
    let mut fix = Fix::guess("fix-write", vec![Edit { span: head, text }]);
    // IDs of a single digit always differ in one digit, which proves nothing.
    if !is_alike || written.len() == 1 {
        fix.applicability = Applicability::Choice;
    }
    Some(fix.with("number", number))
}

/// Whether a property is a refractive index and nothing else.
pub(super) fn is_mere_index(context: &Context, property: &Entity) -> bool {
    let mut own = context
        .records()
        .filter(|r| r.id == property.id && r.ty().gives_optics());
    own.all(|r| r.kind == RecordKind::RefractiveIndex) && property.kind == Some(Kind::Optics)
}

/// Whether the optics of an object let light through.
fn is_transparent(context: &Context, object: &Entity) -> bool {
    let scene = context.scene;
    let mut states = object
        .node()
        .into_iter()
        .flat_map(|node| scene.states(node));
    let optics = states.find_map(|(_, node)| match node {
        Node::Paint { paint, .. } => scene.paints[paint as usize].optics,
        _ => None,
    });
    optics.is_some_and(|o| o.kt.iter().any(|&k| k > 0.0))
}

/// The fix that makes a shape behind a lamp, on the lamp's line, a translation of the lamp.
pub(super) fn of_a_lamp(context: &Context, lamp: &Record, place: &Record) -> Fix {
    let document = context.document;
    let own = document.span(place.first, place.last);
    let end = document.span(lamp.first, lamp.last).end;
    let ty = RecordType::of(RecordKind::Translation);
    let text = format!("\n{} {} ", lamp.id, ty.code);
    let span = Span::new(end, own.start);
    let numbers = &context.text[own.start as usize..own.end as usize];
    let mut fix = Fix::guess("fix-apart", vec![Edit { span, text }]);
    fix.values = vec![
        ("type", Value::Term(ty.title)),
        ("text", quote(numbers).into()),
    ];
    fix
}
