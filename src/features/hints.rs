//! Inlay hints between the numbers of a scene: `21 11 sphere x:0 y:10 z:0 r:10`.

use crate::analysis::Analysis;
use crate::diagnostics::{Language, Span, Value};
use crate::lint::spelling::rough;
use crate::syntax::lexer::Token;
use crate::syntax::table::{Param, ParamKind, RecordKind, RecordType, ShapeKind};

use super::token_at_offset::Readable;
use super::{entity, token_at_offset};

/// A few words between two tokens.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Hint {
    pub at: u32,
    pub text: String,
    pub kind: Kind,
    /// The explanation of the hint, to be shown when somebody points at it.
    pub doc: String,
}

/// The subject of a hint. The name of a parameter stands before the parameter; all other hints stand behind their
/// subjects.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// The name of a type, behind its number.
    Type,
    /// The name of a parameter, before it.
    Parameter,
    /// The name of the entity that a reference points at.
    Reference,
    /// The extent of a profile, behind its number of points.
    Profile,
}

/// The kinds of hints that are wanted.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Deserialize)]
#[serde(default, rename_all = "camelCase")]
pub struct Wanted {
    pub types: bool,
    pub parameters: bool,
    pub references: bool,
    pub profiles: bool,
}

impl Default for Wanted {
    fn default() -> Wanted {
        Wanted {
            types: true,
            parameters: true,
            references: true,
            profiles: true,
        }
    }
}

impl Wanted {
    fn wants(self, kind: Kind) -> bool {
        match kind {
            Kind::Type => self.types,
            Kind::Parameter => self.parameters,
            Kind::Reference => self.references,
            Kind::Profile => self.profiles,
        }
    }
}

/// The hints within a stretch of text, in order.
pub fn hints(
    analysis: &Analysis,
    visible: Span,
    wanted: Wanted,
    language: Language,
) -> impl Iterator<Item = Hint> {
    let items = &analysis.document.items[token_at_offset::items_in(&analysis.document, visible)];
    let readable = items
        .iter()
        .filter_map(|item| token_at_offset::readable(analysis, item));
    let all = readable.flat_map(move |record| {
        let mut out = Vec::new();
        of_record(analysis, &record, visible, language, &mut out);
        out
    });
    all.filter(move |hint| wanted.wants(hint.kind))
}

fn of_record(
    analysis: &Analysis,
    record: &Readable,
    visible: Span,
    language: Language,
    out: &mut Vec<Hint>,
) {
    let document = &analysis.document;
    let Readable { ty, count, .. } = *record;
    let tokens = document.significant(record.first, record.last).skip(1);
    // The type is at 0, the parameters follow.
    for (i, token) in tokens.enumerate() {
        if token.start > visible.end {
            break;
        }
        if token.end() < visible.start {
            continue;
        }
        let Some(i) = i.checked_sub(1) else {
            out.push(Hint {
                at: token.end(),
                text: language.name(ty.title),
                kind: Kind::Type,
                doc: ty.summary(language).into_owned(),
            });
            continue;
        };
        let Some(param) = ty.param(i, count) else {
            continue;
        };
        if let Some(name) = label(ty, param, i, count, language) {
            out.push(Hint {
                at: token.start,
                text: name,
                kind: Kind::Parameter,
                doc: format!(
                    "{} ({})",
                    language.name(param.doc),
                    param.rule_text(language)
                ),
            });
        }
        out.extend(reference(analysis, param, token, language));
        if param.kind == ParamKind::Count {
            out.extend(profile(analysis, record, token.end(), language));
        }
    }
}

/// The label before parameter `i`; `None` if it has none. A matrix has a label for each row. In repeated groups,
/// parameters of the first group have their names, each later group has its number.
fn label(
    ty: &RecordType,
    param: &Param,
    i: usize,
    count: usize,
    language: Language,
) -> Option<String> {
    let is_matrix = ty.vectors == [4, 4, 4, 4];
    if is_matrix {
        let row = [("row", (i / 4 + 1).to_string().into())];
        return i.is_multiple_of(4).then(|| language.say("hint-row", &row));
    }
    let mut at = i.checked_sub(ty.params.len());
    for group in ty.repeats {
        let Some(inside) = at else { break };
        let length = group.len() * count;
        if inside < length {
            let (number, place) = (inside / group.len(), inside % group.len());
            return match (number, place) {
                (0, _) => Some(format!("{}:", param.name)),
                (n, 0) => Some(format!("{}:", n + 1)),
                _ => None,
            };
        }
        at = inside.checked_sub(length);
    }
    Some(format!("{}:", param.name))
}

fn reference(
    analysis: &Analysis,
    param: &Param,
    token: &Token,
    language: Language,
) -> Option<Hint> {
    let id = token_at_offset::reference(param, token, &analysis.source.text)?;
    let name = entity::name(analysis, id, language)?;
    let doc = entity::described(analysis, id, language).unwrap_or_default();
    Some(Hint {
        at: token.end(),
        text: shortened(&name),
        kind: Kind::Reference,
        doc: format!("{id}: {doc}"),
    })
}

/// The most characters of a hint: longer ones push the numbers out of sight.
const MAX_HINT_CHARS: usize = 24;

fn shortened(name: &str) -> String {
    match name.char_indices().nth(MAX_HINT_CHARS) {
        None => name.to_owned(),
        Some((end, _)) => format!("{}…", name[..end].trim_end()),
    }
}

/// The hint about the greatest radius of a profile and its range of heights; `None` for other records.
fn profile(analysis: &Analysis, record: &Readable, at: u32, language: Language) -> Option<Hint> {
    let of_profile = matches!(
        record.ty.kind,
        RecordKind::Shape(ShapeKind::SurfaceOfRevolution | ShapeKind::ColouredSurfaceOfRevolution)
    );
    if !of_profile {
        return None;
    }
    // The ID, the type and the count stand before the points.
    let tokens = (analysis.document).significant(record.first, record.last);
    let numbers = (tokens.skip(3))
        .take(2 * record.count)
        .map(|t| t.number(&analysis.source.text).unwrap_or(0.0));
    let (mut radius, mut low, mut high) = (0.0f64, f64::INFINITY, f64::NEG_INFINITY);
    for (i, x) in numbers.enumerate() {
        match i % 2 {
            0 => radius = radius.max(x),
            _ => (low, high) = (low.min(x), high.max(x)),
        }
    }
    if low > high {
        return None;
    }
    let [radius, low, high] = [radius, low, high].map(|x| Value::from(rough(x)));
    let extent = [("radius", radius), ("low", low), ("high", high)];
    Some(Hint {
        at,
        text: language.say("hint-profile", &extent),
        kind: Kind::Profile,
        doc: language.say("hint-profile-doc", &[]),
    })
}
