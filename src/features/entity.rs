//! The entity of an ID: its name and its look.

use crate::analysis::Analysis;
use crate::diagnostics::{Language, Span};
use crate::scene::{Entity, Node, NodeId, Rgb, Texture};
use crate::syntax::directive::{inside, is_directive};
use crate::syntax::table::{Kind, RecordKind};
use crate::syntax::{Item, Record};

/// The entity with an ID, as it stands at the end of the file.
pub fn entity(analysis: &Analysis, id: u32) -> Option<&Entity> {
    analysis.scene.entities.iter().find(|e| e.id == id)
}

/// All records that can be read, in file order.
pub fn records(analysis: &Analysis) -> impl DoubleEndedIterator<Item = &Record> {
    analysis
        .document
        .items
        .iter()
        .filter_map(|item| match item {
            Item::Record(record) => Some(record),
            _ => None,
        })
}

/// The first comment with words in a record, or behind it on its last line, joined into one line. Comments for zpg do
/// not count.
pub fn comment(analysis: &Analysis, record: &Record) -> Option<String> {
    let tokens = &analysis.document.tokens;
    let (first, last) = (record.first as usize, record.last as usize);
    let behind = tokens[last + 1..]
        .iter()
        .take_while(|t| t.kind().is_comment());
    let text = &analysis.source.text;
    let mut said = (tokens[first..=last].iter().chain(behind))
        .filter(|t| t.kind().is_comment() && !is_directive(t, text))
        .map(|t| {
            inside(t.text(text))
                .split_whitespace()
                .collect::<Vec<_>>()
                .join(" ")
        });
    said.find(|words| !words.is_empty())
}

/// The name of an entity for people: its comment, or the title of its record.
pub fn name(analysis: &Analysis, id: u32, language: Language) -> Option<String> {
    let record = analysis.definition(id)?;
    Some(comment(analysis, record).unwrap_or_else(|| language.name(record.ty().title)))
}

/// The type of an entity's record and its comment, if there is one, as in "sphere, a ball". If the record cannot be
/// read, the kind of the entity.
pub fn described(analysis: &Analysis, id: u32, language: Language) -> Option<String> {
    let Some(record) = analysis.definition(id) else {
        return Some(language.name(entity(analysis, id)?.kind?.name()));
    };
    let title = language.name(record.ty().title);
    Some(match comment(analysis, record) {
        Some(comment) => format!("{title}, {comment}"),
        None => title,
    })
}

/// The span of a record, from its ID to its last number.
pub fn span(analysis: &Analysis, record: &Record) -> Span {
    analysis.document.span(record.first, record.last)
}

/// The linear colour of an entity; `None` if it has no colour or more than one.
pub fn colour(analysis: &Analysis, id: u32) -> Option<Rgb> {
    let scene = &analysis.scene;
    let entity = entity(analysis, id)?;
    match entity.kind? {
        Kind::Object => match painted(analysis, entity.node()?)? {
            Texture::Colour(rgb) => Some(*rgb),
            _ => None,
        },
        Kind::AmbientLight => Some(scene.ambient_lights.iter().find(|l| l.id == id)?.colour),
        Kind::PointLight => Some(scene.point_lights.iter().find(|l| l.id == id)?.colour),
        Kind::Colour => {
            let mut own = records(analysis).rev().filter(|r| r.id == id);
            let record = own.find(|r| r.kind == RecordKind::Colour)?;
            let numbers: Vec<f64> = (analysis.document.params(record))
                .filter_map(|t| t.number(&analysis.source.text))
                .collect();
            numbers.try_into().ok()
        }
        _ => None,
    }
}

/// The texture that an object itself has been given.
fn painted(analysis: &Analysis, node: NodeId) -> Option<&Texture> {
    let scene = &analysis.scene;
    scene.states(node).find_map(|(_, node)| match node {
        Node::Paint { paint, .. } => scene.paints[paint as usize].texture.as_ref(),
        _ => None,
    })
}

/// The largest ID of the language.
pub const MAX_ID: u32 = i32::MAX as u32;

/// The ID that a new record takes: one above the largest of the file, and at least 2, as 1 is the render record's.
/// `None` if the largest is [`MAX_ID`].
pub fn next_id(analysis: &Analysis) -> Option<u32> {
    let ids = analysis
        .document
        .items
        .iter()
        .filter_map(|item| match item {
            Item::Record(r) => Some(r.id),
            Item::Broken(b) => b.id,
            Item::Void { .. } => None,
        });
    let next = ids.max().unwrap_or(0).max(1) + 1;
    (next <= MAX_ID).then_some(next)
}
