//! The text about the token under the pointer.

use std::fmt::Write as _;

use crate::analysis::Analysis;
use crate::diagnostics::{Language, Span, Value};
use crate::geometry::Aabb;
use crate::lint::spelling::{near, rough};
use crate::syntax::Record;
use crate::syntax::table::{Param, RecordType};
use crate::trace::film::srgb8;

use super::token_at_offset::{Role, TokenAtOffset, place_at};
use super::{entity, pages};

/// A text in Markdown about a stretch of the scene.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Hover {
    pub span: Span,
    pub markdown: String,
    /// The ID of the entity that the text is about, if there is one: a picture may show the entity.
    pub id: Option<u32>,
}

/// The most numbers of a record that are listed, so that a long profile does not fill the screen.
const MAX_VALUES: usize = 24;

/// The text about the token at an offset, and about the findings there.
pub fn hover(analysis: &Analysis, offset: u32, language: Language) -> Option<Hover> {
    let place = place_at(analysis, offset);
    let mut markdown = String::new();
    let mut id = None;
    if let Some(place) = &place {
        id = place.id(&analysis.source.text);
        markdown = match place.role {
            Role::Id => about_entity(analysis, place.record.id, language),
            Role::Type => about_record(analysis, place.record, language),
            Role::Param(i, param) => about_param(analysis, place, (i, param), id, language),
        };
    }
    // Only findings that are known already are shown: to run the rules may take longer than anybody waits.
    let findings = analysis.known_findings().unwrap_or_default();
    let here = |span: Span| span.start <= offset && offset <= span.end && span.start < span.end;
    let mut span = place.map(|p| p.token.span());
    for d in findings.iter().filter(|d| here(d.span)) {
        span = span.or(Some(d.span));
        let words = d.wording(language);
        let page = pages::code_page(d.code, language);
        let page = page.split_once('\n').map_or("", |(_, rest)| rest).trim();
        divide(&mut markdown);
        let (code, name) = (d.code.as_str(), d.code.name());
        let _ = write!(markdown, "**{code} {name}**: {}\n\n{page}\n", words.message);
    }
    Some(Hover {
        span: span.filter(|_| !markdown.is_empty())?,
        markdown,
        id,
    })
}

fn divide(markdown: &mut String) {
    if !markdown.is_empty() {
        markdown.push_str("\n---\n\n");
    }
}

/// A record's type, with the values that stand in it.
fn about_record(analysis: &Analysis, record: &Record, language: Language) -> String {
    let ty = record.ty();
    let mut out = heading(ty, language);
    let values: Vec<String> = (analysis
        .document
        .params(record)
        .take(MAX_VALUES)
        .enumerate())
    .filter_map(|(i, token)| {
        let param = ty.param(i, record.count())?;
        let unit = param.unit_text(language);
        let unit = if unit.is_empty() {
            String::new()
        } else {
            format!(" ({unit})")
        };
        let text = token.text(&analysis.source.text);
        Some(format!(
            "- `{}` = {text}: {}{unit}\n",
            param.name,
            language.name(param.doc)
        ))
    })
    .collect();
    if !values.is_empty() {
        out.push('\n');
    }
    out.extend(values);
    let more = (record.params as usize).saturating_sub(MAX_VALUES);
    if more > 0 {
        let more = [("more", more.to_string().into())];
        let _ = writeln!(out, "- {}", language.say("hover-values-more", &more));
    }
    out
}

fn heading(ty: &RecordType, language: Language) -> String {
    let signature = format!("ID {} {}", ty.code, ty.signature());
    format!(
        "**{}**\n\n```text\n{}\n```\n\n{}\n",
        language.name(ty.title),
        signature.trim_end(),
        ty.summary(language)
    )
}

fn about_param(
    analysis: &Analysis,
    place: &TokenAtOffset,
    (i, param): (usize, &Param),
    id: Option<u32>,
    language: Language,
) -> String {
    let ty = place.record.ty();
    let value = place.token.text(&analysis.source.text);
    let values = [
        ("rule", Value::from(param.rule_text(language))),
        ("number", (i + 1).to_string().into()),
        ("count", place.record.params.to_string().into()),
        ("type", Value::Term(ty.title)),
    ];
    let mut out = format!(
        "`{}` = {value}: {}\n\n{}\n",
        param.name,
        language.name(param.doc),
        language.say("hover-parameter", &values),
    );
    if let Some(id) = id.filter(|&id| analysis.definition(id).is_some()) {
        divide(&mut out);
        out.push_str(&about_entity(analysis, id, language));
    }
    out
}

/// The text about the entity of an ID.
fn about_entity(analysis: &Analysis, id: u32, language: Language) -> String {
    let Some(record) = analysis.definition(id) else {
        let id = [("id", id.to_string().into())];
        return language.say("hover-undefined", &id) + "\n";
    };
    let line = analysis
        .source
        .line_index(entity::span(analysis, record).start)
        + 1;
    let mut out = format!("**{id}: {}**", language.name(record.ty().title));
    if let Some(comment) = entity::comment(analysis, record) {
        let _ = write!(out, ", {}", escaped(&comment));
    }
    let _ = write!(
        out,
        " {}\n\n```zpg\n{}\n```\n",
        language.say("hover-line", &[("line", line.to_string().into())]),
        first_line(analysis, record)
    );
    if let Some(rgb) = entity::colour(analysis, id) {
        let [r, g, b] = rgb.map(rough);
        let [x, y, z] = rgb.map(|c| srgb8(c as f32));
        let values = [
            ("colour", format!("{r} {g} {b}").into()),
            ("shown", format!("#{x:02x}{y:02x}{z:02x}").into()),
        ];
        let _ = write!(out, "\n{}\n", language.say("hover-colour", &values));
    }
    let node = entity::entity(analysis, id).and_then(|e| e.node());
    if let Some(bounds) = node.and_then(|n| analysis.bounds().get(n as usize)) {
        let _ = write!(out, "\n{}\n", bounds_text(&bounds.all, language));
    }
    let uses = super::uses::occurrences(analysis, id);
    let (changes, references) = super::uses::counts(&uses);
    let values = [
        ("uses", Value::Count(references as u64)),
        ("changes", Value::Count(changes as u64)),
    ];
    let _ = write!(out, "\n{}\n", language.say("hover-uses", &values));
    out
}

/// The text about the bounding box of an object at the end of the file.
fn bounds_text(all: &Aabb, language: Language) -> String {
    if all.is_empty() {
        return language.say("hover-bounds-empty", &[]);
    }
    let size = |i: usize| all.max[i] - all.min[i];
    // Bounding boxes are never too small, and digits below a thousandth of their size are rounding.
    let size = (0..3)
        .map(size)
        .filter(|x| x.is_finite())
        .fold(0.0, f64::max);
    let side = |i: usize, name| {
        let end = |x: f64| match x {
            x if x == f64::INFINITY => "∞".to_owned(),
            x if x == f64::NEG_INFINITY => "−∞".to_owned(),
            x => near(x, size),
        };
        let values = [
            ("axis", Value::from(name)),
            ("low", end(all.min[i]).into()),
            ("high", end(all.max[i]).into()),
        ];
        Value::from(language.say("hover-side", &values))
    };
    let sides = [
        ("x", side(0, "x")),
        ("y", side(1, "y")),
        ("z", side(2, "z")),
    ];
    language.say("hover-bounds", &sides)
}

/// The record as it is written, in one line and not too long.
fn first_line(analysis: &Analysis, record: &Record) -> String {
    const MAX_RECORD_BYTES: usize = 80;
    let tokens = analysis.document.significant(record.first, record.last);
    let mut out = String::new();
    for token in tokens {
        if out.len() > MAX_RECORD_BYTES {
            out.push_str(" …");
            break;
        }
        if !out.is_empty() {
            out.push(' ');
        }
        out.push_str(token.text(&analysis.source.text));
    }
    out
}

/// The user's text, with its punctuation escaped for Markdown.
fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        if c.is_ascii_punctuation() && !",.-:;/()".contains(c) {
            out.push('\\');
        }
        out.push(c);
    }
    out
}
