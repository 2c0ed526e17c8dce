//! Colours in a scene, as boxes that open a picker.
//!
//! Scenes have linear colours, pickers sRGB. Both conversions use the curve by which pictures are written.

use crate::analysis::Analysis;
use crate::diagnostics::{Edit, Span};
use crate::lint::spelling::linear_part;
use crate::syntax::table::RecordKind;
use crate::syntax::{Item, Record};
use crate::trace::film::srgb8;

use super::token_at_offset;
use super::tokens::{Role, of_param};

/// A colour in the text, and its sRGB values.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Colour {
    /// The numbers of the colour, from the first to the last.
    pub span: Span,
    /// sRGB, each part from 0 to 1.
    pub shown: [f64; 3],
}

/// The colours of a scene, in order.
pub fn colours(analysis: &Analysis) -> Vec<Colour> {
    let mut out = Vec::new();
    for item in &analysis.document.items {
        if let Item::Record(record) = item {
            for numbers in of_record(analysis, record) {
                let span = numbers[0].0.to(numbers[2].0);
                let shown = numbers.map(|(_, x)| shown(x));
                out.push(Colour { span, shown });
            }
        }
    }
    out
}

/// The colours of a record, each number with its place.
fn of_record(analysis: &Analysis, record: &Record) -> Vec<[(Span, f64); 3]> {
    let ty = record.ty();
    let skip = match ty.kind {
        RecordKind::Colour => 0,
        // The colours of a profile stand behind the count and the points.
        _ if ty.repeats.len() == 2 => 1 + 2 * record.count(),
        _ => return Vec::new(),
    };
    let numbers: Vec<(Span, f64)> = (analysis.document.params(record).enumerate().skip(skip))
        .filter(|(i, _)| {
            (ty.param(*i, record.count())).is_some_and(|p| of_param(ty, p) == Role::Colour)
        })
        .map(|(_, t)| (t.span(), t.number(&analysis.source.text).unwrap_or(0.0)))
        .collect();
    numbers.as_chunks::<3>().0.to_vec()
}

/// The sRGB value of a linear one, to 8 bits, from 0 to 1.
fn shown(linear: f64) -> f64 {
    f64::from(srgb8(linear as f32)) / 255.0
}

/// The edit that replaces the colour at `span` by the sRGB colour `picked`. Only numbers whose sRGB value changes, to
/// 8 bits, are written anew. `None` if no colour stands there.
pub fn repaint(analysis: &Analysis, span: Span, picked: [f64; 3]) -> Option<Edit> {
    let items = &analysis.document.items[token_at_offset::items_in(&analysis.document, span)];
    let records = items.iter().filter_map(|item| match item {
        Item::Record(record) => Some(record),
        _ => None,
    });
    let mut all = records.flat_map(|record| of_record(analysis, record));
    let old = all.find(|c| c[0].0.start == span.start && c[2].0.end == span.end)?;
    let text = &analysis.source.text;
    let mut out = String::new();
    let mut at = span.start;
    for ((place, value), picked) in old.into_iter().zip(picked) {
        out.push_str(text.get(at as usize..place.start as usize)?);
        let wanted = (picked.clamp(0.0, 1.0) * 255.0).round() as u8;
        match srgb8(value as f32) == wanted {
            true => out.push_str(text.get(place.range())?),
            false => out.push_str(&linear_part(wanted)),
        }
        at = place.end;
    }
    Some(Edit { span, text: out })
}
