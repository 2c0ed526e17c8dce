//! The parameters of a record while it is typed.

use crate::analysis::Analysis;
use crate::diagnostics::Language;
use crate::syntax::table::{Param, RecordType};

use super::token_at_offset::typing;

/// A record's parameters in a line, and which of them is being typed.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Signature {
    pub label: String,
    pub doc: String,
    pub params: Vec<Parameter>,
    /// Index into `params`; `None` behind the last one, or before the first.
    pub active: Option<usize>,
}

/// A parameter's stretch of the label, and its explanation.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Parameter {
    /// The range of bytes of the label, half-open.
    pub at: (usize, usize),
    pub doc: String,
}

/// The signature of the record that is typed at an offset, once its type is known.
pub fn signature(analysis: &Analysis, offset: u32, language: Language) -> Option<Signature> {
    let typing = typing(analysis, offset)?;
    let ty = typing.ty?;
    if typing.complete {
        return None;
    }
    let (mut label, params) = label(ty, language);
    let position = typing.index.checked_sub(2);
    let active = position.and_then(|i| listed(ty, i, typing.count));
    if let Some(point) = position.and_then(|i| point(ty, i, typing.count, language)) {
        label = format!("{label}   {point}");
    }
    Some(Signature {
        label,
        doc: ty.summary(language).into_owned(),
        params,
        active,
    })
}

/// The label as [`RecordType::signature`] has it, with each parameter's place in it.
fn label(ty: &'static RecordType, language: Language) -> (String, Vec<Parameter>) {
    let mut label = format!("ID {}", ty.code);
    let mut params = Vec::new();
    let mut add = |label: &mut String, group: &'static [Param], open: &str, close: &str| {
        label.push(' ');
        label.push_str(open);
        for (i, param) in group.iter().enumerate() {
            if i > 0 {
                label.push(' ');
            }
            let start = label.len();
            label.push_str(param.name);
            params.push(Parameter {
                at: (start, label.len()),
                doc: format!(
                    "{} ({})",
                    language.name(param.doc),
                    param.rule_text(language)
                ),
            });
        }
        label.push_str(close);
    };
    if !ty.params.is_empty() {
        add(&mut label, ty.params, "", "");
    }
    for group in ty.repeats {
        add(&mut label, group, "(", ")×N");
    }
    if !ty.optional.is_empty() {
        add(&mut label, ty.optional, "[", "]");
    }
    (label, params)
}

/// The words for the point or colour of a profile that the parameter at `position` belongs to, as "point 2/5: y". A
/// `count` of 0 is not known yet: then the number of points is left out. `None` for other parameters.
fn point(ty: &RecordType, position: usize, count: usize, language: Language) -> Option<String> {
    let mut inside = position.checked_sub(ty.params.len())?;
    for group in ty.repeats {
        let length = group.len().saturating_mul(count);
        if inside >= length && count > 0 {
            inside -= length;
            continue;
        }
        let number = inside / group.len() + 1;
        let place = match count {
            0 => number.to_string(),
            _ => format!("{number}/{count}"),
        };
        let message = match group.len() {
            2 => "lsp-profile-point",
            _ => "lsp-profile-colour",
        };
        let name = group[inside % group.len()].name;
        return Some(language.say(message, &[("place", place.into()), ("name", name.into())]));
    }
    None
}

/// The index in the label of the parameter at `position` of the record; the label has each parameter of a repeated
/// group once. While the count is not known, and so 0, the first repeated group has no end.
fn listed(ty: &RecordType, position: usize, count: usize) -> Option<usize> {
    if position < ty.params.len() {
        return Some(position);
    }
    let mut inside = position - ty.params.len();
    let mut before = ty.params.len();
    for group in ty.repeats {
        let length = group.len().saturating_mul(count);
        if inside < length || count == 0 {
            return Some(before + inside % group.len());
        }
        inside -= length;
        before += group.len();
    }
    (inside < ty.optional.len()).then_some(before + inside)
}
