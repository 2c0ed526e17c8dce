//! What stands under the pointer, in words.

use std::fmt::Write as _;

use crate::analysis::Analysis;
use crate::diagnostics::{Language, Span};
use crate::geometry::Aabb;
use crate::lint::spelling::{near, rough};
use crate::syntax::Record;
use crate::syntax::table::{Param, RecordType};
use crate::trace::film::srgb8;

use super::place::{Place, Role, place_at};
use super::{entity, pages};

/// A text in Markdown about a stretch of the scene.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Hover {
    pub span: Span,
    pub markdown: String,
    /// The entity that is spoken of, where there is one: a picture may show it.
    pub id: Option<u32>,
}

/// How many numbers of a record are named: those of long profiles fill no screen.
const MAX_VALUES: usize = 24;

/// What there is to say about the token at an offset, and about the findings there.
pub fn hover(analysis: &Analysis, offset: u32, language: Language) -> Option<Hover> {
    let place = place_at(analysis, offset);
    let mut markdown = String::new();
    let mut id = None;
    if let Some(place) = &place {
        id = place.id(&analysis.source.text);
        markdown = match place.role {
            Role::Id => about_entity(analysis, place.record.id),
            Role::Type => about_record(analysis, place.record),
            Role::Param(i, param) => about_param(analysis, place, i, param, id),
        };
    }
    // Rules are not run for this: they may take longer than anybody waits.
    let findings = analysis.known_findings().unwrap_or_default();
    let here = |span: Span| span.start <= offset && offset <= span.end && span.start < span.end;
    let mut span = place.map(|p| p.token.span());
    for d in findings.iter().filter(|d| here(d.span)) {
        span = span.or(Some(d.span));
        let words = d.wording(language);
        let page = pages::code_page(d.code);
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
fn about_record(analysis: &Analysis, record: &Record) -> String {
    let ty = record.ty();
    let mut out = heading(ty);
    let values: Vec<String> = (analysis
        .document
        .params(record)
        .take(MAX_VALUES)
        .enumerate())
    .filter_map(|(i, token)| {
        let param = ty.param(i, record.count as usize)?;
        let unit = param.unit_text();
        let unit = if unit.is_empty() {
            String::new()
        } else {
            format!(" ({unit})")
        };
        let text = token.text(&analysis.source.text);
        Some(format!(
            "- `{}` = {text}: {}{unit}\n",
            param.name, param.doc
        ))
    })
    .collect();
    if !values.is_empty() {
        out.push('\n');
    }
    out.extend(values);
    let more = (record.params as usize).saturating_sub(MAX_VALUES);
    if more > 0 {
        let _ = writeln!(out, "- and {more} more");
    }
    out
}

fn heading(ty: &RecordType) -> String {
    let signature = format!("ID {} {}", ty.code, ty.signature());
    format!(
        "**{}**\n\n```text\n{}\n```\n\n{}\n",
        ty.title,
        signature.trim_end(),
        ty.summary
    )
}

fn about_param(
    analysis: &Analysis,
    place: &Place,
    i: usize,
    param: &Param,
    id: Option<u32>,
) -> String {
    let ty = place.record.ty();
    let value = place.token.text(&analysis.source.text);
    let number = i + 1;
    let mut out = format!(
        "`{}` = {value}: {}\n\n{}, number {number} of {} of {}\n",
        param.name,
        param.doc,
        param.rule_text(),
        place.record.params,
        crate::diagnostics::wording::with_article(ty.title),
    );
    if let Some(id) = id.filter(|&id| analysis.definition(id).is_some()) {
        divide(&mut out);
        out.push_str(&about_entity(analysis, id));
    }
    out
}

/// What an ID stands for.
fn about_entity(analysis: &Analysis, id: u32) -> String {
    let Some(record) = analysis.definition(id) else {
        return format!("{id} is not defined\n");
    };
    let line = analysis
        .source
        .line_index(entity::span(analysis, record).start)
        + 1;
    let mut out = format!("**{id}: {}**", record.ty().title);
    if let Some(comment) = entity::comment(analysis, record) {
        let _ = write!(out, ", {}", escaped(&comment));
    }
    let _ = write!(
        out,
        " (line {line})\n\n```zpg\n{}\n```\n",
        first_line(analysis, record)
    );
    if let Some(rgb) = entity::colour(analysis, id) {
        let [r, g, b] = rgb.map(rough);
        let [x, y, z] = rgb.map(|c| srgb8(c as f32));
        let _ = write!(
            out,
            "\nColour {r} {g} {b}, shown as `#{x:02x}{y:02x}{z:02x}`\n"
        );
    }
    let node = entity::entity(analysis, id).and_then(|e| e.node);
    if let Some(bounds) = node.and_then(|n| analysis.bounds().get(n as usize)) {
        let _ = write!(out, "\n{}\n", bounds_text(&bounds.all));
    }
    let uses = super::uses::occurrences(analysis, id);
    let (changes, references) = super::uses::counts(&uses);
    let _ = write!(
        out,
        "\nUsed {}, changed {}\n",
        times(references),
        times(changes)
    );
    out
}

fn times(n: usize) -> String {
    match n {
        0 => "nowhere".to_owned(),
        1 => "once".to_owned(),
        n => format!("{n} times"),
    }
}

/// Where the object is when the file ends.
fn bounds_text(all: &Aabb) -> String {
    if all.is_empty() {
        return "Bounds: empty".to_owned();
    }
    let size = |i: usize| all.max[i] - all.min[i];
    // Boxes are never too small: what is below a thousandth of the size is rounding.
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
        format!("{name} {} to {}", end(all.min[i]), end(all.max[i]))
    };
    format!(
        "Bounds: {}, {}, {}",
        side(0, "x"),
        side(1, "y"),
        side(2, "z")
    )
}

/// The record as it is written, in one line and not too long.
fn first_line(analysis: &Analysis, record: &Record) -> String {
    const LONGEST: usize = 80;
    let tokens = analysis.document.significant(record.first, record.last);
    let mut out = String::new();
    for token in tokens {
        if out.len() > LONGEST {
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

/// Text of the user's within Markdown.
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
