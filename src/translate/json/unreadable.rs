//! What is wrong with a text that should be a scene in JSON, in the words of the format.

use std::fmt;

use serde::de::IgnoredAny;
use serde_json::{Map, Value, error::Category};

use super::model::Item;
use super::spell::Place;
use crate::diagnostics::Complaint;

/// Why a text is no scene in JSON, and where.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Unreadable {
    /// Names and indices, as in `cameras[0].fovy`; `None` for the text as a whole.
    at: Option<String>,
    /// Line and column, where they are known. For a node they are those of its end.
    position: Option<(usize, usize)>,
    why: Complaint,
}

impl Unreadable {
    /// Something refers to what is not there, or cannot be what it is.
    pub fn content(at: Place, why: Complaint) -> Unreadable {
        Unreadable {
            at: Some(at.to_string()),
            position: None,
            why,
        }
    }

    /// The text is not JSON, or not of the form that the schema has; the error is at a path, `.` for all of
    /// the text.
    pub fn form(text: &str, path: &str, error: &serde_json::Error) -> Unreadable {
        if let Err(e) = serde_json::from_str::<IgnoredAny>(text) {
            return Unreadable {
                at: None,
                position: Some((e.line(), e.column())),
                why: match e.classify() {
                    Category::Eof => Complaint::new("json-ends"),
                    _ => Complaint::new("json-syntax").with("what", Complaint::quoted(said(&e))),
                },
            };
        }
        let said = said(error);
        let node = node_at_fault(text, path);
        let field = node.as_ref().and_then(|node| field_at_fault(node, &said));
        Unreadable {
            at: match (path, field) {
                (".", _) => None,
                (path, Some(field)) => Some(format!("{path}.{field}")),
                (path, None) => Some(path.to_owned()),
            },
            position: Some((error.line(), error.column())),
            why: why(&said),
        }
    }

    /// In words that can be put into any language.
    pub fn complaint(&self) -> Complaint {
        let positioned = |message, (line, column): (usize, usize)| {
            Complaint::new(message)
                .with("line", line.to_string())
                .with("column", column.to_string())
        };
        let complaint = match (&self.at, self.position) {
            (Some(_), Some(position)) => positioned("json-at-place", position),
            (None, Some(position)) => positioned("json-at", position),
            (_, None) => Complaint::new("json-place"),
        };
        complaint
            .with("place", self.at.clone().unwrap_or_default())
            .with("why", self.why.clone())
    }
}

impl fmt::Display for Unreadable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.complaint().fmt(f)
    }
}

impl std::error::Error for Unreadable {}

/// An error without its position.
fn said(error: &serde_json::Error) -> String {
    let text = error.to_string();
    let end = text.rfind(" at line ").unwrap_or(text.len());
    text[..end].to_owned()
}

/// The node that a path leads to.
fn node_at_fault(text: &str, path: &str) -> Option<Map<String, Value>> {
    let index: usize = path
        .strip_prefix("nodes[")?
        .strip_suffix(']')?
        .parse()
        .ok()?;
    let scene: Value = serde_json::from_str(text).ok()?;
    scene["nodes"][index].as_object().cloned()
}

/// Nodes are told apart by their types before their fields are read: the field that a mistake is in makes
/// the same mistake alone.
fn field_at_fault<'a>(node: &'a Map<String, Value>, said: &str) -> Option<&'a String> {
    // What is missing is no field.
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
    // The type is in all of them.
    let (ty, _) = node.get_key_value("type")?;
    let mut fields = std::iter::once(ty).chain(node.keys());
    fields.find(|field| alone(field).is_err_and(|e| e.to_string() == said))
}

/// What a message of the parser means.
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
    // More than a list may have.
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
