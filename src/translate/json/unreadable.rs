//! Errors of a text that should be a scene in JSON, in the words of the format.

use std::fmt;

use serde::de::IgnoredAny;
use serde_json::{Map, Value, error::Category};
use serde_path_to_error::Segment;

use super::locate::{Path, PathSegment, Places};
use super::model::Item;
use super::spell::ModelElement;
use crate::diagnostics::{Complaint, Span};

/// The reason why a text is no scene in JSON, and the place.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Unreadable {
    /// The path to the value, as in `cameras[0].fovy`; `None` for the text as a whole.
    pub at: Option<String>,
    /// The span of the value in question, or the place where the text ceases to be JSON.
    pub span: Span,
    pub why: Complaint,
}

impl Unreadable {
    /// The error of an element that refers to a missing element, or has a value that is not allowed.
    pub fn content(text: &str, at: ModelElement, why: Complaint) -> Unreadable {
        Unreadable {
            at: Some(at.to_string()),
            span: Places::new(text).find(text, &at.path()),
            why,
        }
    }

    /// The error of a text that is not JSON. `mark` is the length of the byte order mark before the text, in bytes.
    pub fn syntax(text: &str, mark: usize, error: &serde_json::Error) -> Unreadable {
        let at = mark + offset(text, error.line(), error.column());
        Unreadable {
            at: None,
            span: Span::new(at as u32, at as u32 + 1),
            why: match error.classify() {
                Category::Eof => Complaint::new("json-ends"),
                _ => Complaint::new("json-syntax").with("what", Complaint::quoted(said(error))),
            },
        }
    }

    /// The error of a text that is not JSON, or not of the form that the schema has. `path` leads to the error.
    pub fn form(
        text: &str,
        mark: usize,
        path: &serde_path_to_error::Path,
        error: &serde_json::Error,
    ) -> Unreadable {
        if let Err(e) = serde_json::from_str::<IgnoredAny>(text) {
            return Unreadable::syntax(text, mark, &e);
        }
        let said = said(error);
        if said == "recursion limit exceeded" {
            let unreadable = Unreadable::syntax(text, mark, error);
            let why = Complaint::new("json-deep");
            return Unreadable { why, ..unreadable };
        }
        let mut way = way(path);
        let node = node_at_fault(text, &way);
        if let Some(field) = node.as_ref().and_then(|node| field_at_fault(node, &said)) {
            way = way.name(field.clone());
        }
        let found = Places::new(text).find(text, &way);
        let moved = |at: u32| at + mark as u32;
        Unreadable {
            at: Some(way.to_string()).filter(|at| !at.is_empty()),
            span: Span::new(moved(found.start), moved(found.end)),
            why: why(&said),
        }
    }
}

impl fmt::Display for Unreadable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.at {
            Some(at) => write!(f, "{at}: {}", self.why),
            None => self.why.fmt(f),
        }
    }
}

impl std::error::Error for Unreadable {}

/// The byte offset of the parser's line and column, both counted from 1.
fn offset(text: &str, line: usize, column: usize) -> usize {
    let mut lines = text.split_inclusive('\n');
    let before: usize = lines
        .by_ref()
        .take(line.saturating_sub(1))
        .map(str::len)
        .sum();
    let mut at = (before + column.saturating_sub(1)).min(text.len());
    while !text.is_char_boundary(at) {
        at -= 1;
    }
    at
}

/// The path of an error.
fn way(path: &serde_path_to_error::Path) -> Path {
    path.iter()
        .fold(Path::default(), |way, segment| match segment {
            Segment::Seq { index } => way.item(*index),
            Segment::Map { key } => way.name(key.clone()),
            Segment::Enum { variant } => way.name(variant.clone()),
            Segment::Unknown => way,
        })
}

/// The message of an error without its position.
fn said(error: &serde_json::Error) -> String {
    let text = error.to_string();
    let end = text.rfind(" at line ").unwrap_or(text.len());
    text[..end].to_owned()
}

/// The node that a path leads to; `None` if it leads elsewhere.
fn node_at_fault(text: &str, way: &Path) -> Option<Map<String, Value>> {
    let index = match way.0.as_slice() {
        [PathSegment::Name(list), PathSegment::Index(index)] if list == "nodes" => *index,
        _ => return None,
    };
    let scene: Value = serde_json::from_str(text).ok()?;
    scene["nodes"][index].as_object().cloned()
}

/// The field of a node in which the mistake is. The parser reads a node's type before its fields, and so reports
/// mistakes of the whole node. The field at fault gives the same message when it is read alone, with the type.
fn field_at_fault<'a>(node: &'a Map<String, Value>, said: &str) -> Option<&'a String> {
    // A missing field is none of the node's fields.
    if said.starts_with("missing") {
        return None;
    }
    let alone = |field: &str| {
        let fields = node
            .iter()
            .filter(|(name, _)| *name == "type" || *name == field);
        let fields = fields.map(|(name, value)| (name.clone(), value.clone()));
        Item::try_from(fields.collect::<Map<_, _>>())
    };
    // The type is tried first, since it is read along with every field.
    let (ty, _) = node.get_key_value("type")?;
    let mut fields = std::iter::once(ty).chain(node.keys());
    fields.find(|field| alone(field).is_err_and(|e| e.to_string() == said))
}

/// The complaint for a message of the parser.
fn why(said: &str) -> Complaint {
    let quoted: Vec<&str> = said.split('`').skip(1).step_by(2).collect();
    let first = quoted.first().copied().unwrap_or_default().to_owned();
    let others = quoted.get(1..).unwrap_or_default();
    let known = || {
        others
            .iter()
            .map(|name| format!("`{name}`"))
            .collect::<Vec<_>>()
            .join(", ")
    };
    if said.starts_with("missing field") {
        return Complaint::new("json-missing").with("field", first);
    }
    if said.starts_with("duplicate field") {
        return Complaint::new("json-twice").with("field", first);
    }
    if said.starts_with("unknown field") {
        return Complaint::new("json-no-field")
            .with("field", first)
            .with("known", known());
    }
    if said.starts_with("unknown variant") {
        return Complaint::new("json-no-kind")
            .with("kind", first)
            .with("known", known());
    }
    if said == "number out of range" {
        return Complaint::new("json-out-of-range");
    }
    // The parser says this about a list with too many items.
    if said == "trailing characters" {
        return Complaint::new("json-too-many");
    }
    let parts = said.strip_prefix("invalid ").and_then(|rest| {
        let rest = rest.split_once(": ").map_or(rest, |(_, rest)| rest);
        rest.rsplit_once(", expected ")
    });
    match parts {
        Some((found, wanted)) => Complaint::new("json-expected")
            .with("wanted", self::wanted(wanted))
            .with("found", self::found(found)),
        None => Complaint::quoted(said),
    }
}

fn wanted(wanted: &str) -> Complaint {
    let length = wanted.split(' ').find_map(|word| word.parse::<u64>().ok());
    match (wanted, length) {
        ("f64", _) => Complaint::new("json-number"),
        ("u32", _) => Complaint::new("json-whole-number"),
        ("a string" | "variant identifier", _) => Complaint::new("json-string"),
        ("a sequence", _) => Complaint::new("json-list"),
        (_, Some(length)) if !wanted.starts_with("struct") => {
            Complaint::new("json-list-of").with("length", length.to_string())
        }
        _ if wanted.contains("fewer elements") => Complaint::new("json-shorter-list"),
        _ => Complaint::new("json-object"),
    }
}

fn found(found: &str) -> Complaint {
    let quoted = |text: &str| Complaint::quoted(format!("`{text}`"));
    match found {
        "map" => Complaint::new("json-object"),
        "sequence" => Complaint::new("json-list"),
        "unit variant" => Complaint::new("json-string"),
        _ if found.starts_with("length ") => {
            Complaint::new("json-list-of").with("length", found["length ".len()..].to_owned())
        }
        _ => match (found.strip_prefix("string "), found.split('`').nth(1)) {
            (Some(text), _) => quoted(text),
            (None, Some(value)) => quoted(value),
            (None, None) => quoted(found),
        },
    }
}
