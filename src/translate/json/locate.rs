//! Places of the values of a JSON text.
//!
//! The text has been read before, so it is valid JSON. No function is recursive, however deeply the text is nested.

use std::borrow::Cow;
use std::fmt;
use std::sync::atomic::{AtomicUsize, Ordering};

use rustc_hash::FxHashMap;

use crate::diagnostics::Span;

/// A step from a value to a value in it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum PathSegment {
    Name(Cow<'static, str>),
    Index(usize),
}

/// The path from the whole text to a value, as in `cameras[0].fovy`.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Path(pub Vec<PathSegment>);

impl Path {
    /// The path to a named value in this path's value.
    #[must_use]
    pub fn name(mut self, name: impl Into<Cow<'static, str>>) -> Path {
        self.0.push(PathSegment::Name(name.into()));
        self
    }

    /// The path to an item of this path's value, a list.
    #[must_use]
    pub fn item(mut self, index: usize) -> Path {
        self.0.push(PathSegment::Index(index));
        self
    }

    /// The common beginning of both paths.
    #[must_use]
    pub fn common(mut self, other: &Path) -> Path {
        let same = self.0.iter().zip(&other.0).take_while(|(a, b)| a == b);
        let length = same.count();
        self.0.truncate(length);
        self
    }
}

impl fmt::Display for Path {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, step) in self.0.iter().enumerate() {
            match step {
                PathSegment::Name(name) if i > 0 => write!(f, ".{name}")?,
                PathSegment::Name(name) => f.write_str(name)?,
                PathSegment::Index(index) => write!(f, "[{index}]")?,
            }
        }
        Ok(())
    }
}

/// The most bytes that are searched for values inside of elements. After that, a search ends at the element.
const BYTES: usize = 1 << 26;

/// The spans of the values of a JSON text.
#[derive(Debug)]
pub(super) struct Places {
    /// The spans of the outermost object's values, by name.
    top: FxHashMap<String, Span>,
    /// The spans of the items of those values that are lists, by the name of the list.
    items: FxHashMap<String, Vec<Span>>,
    left: AtomicUsize,
}

impl Places {
    pub(super) fn new(text: &str) -> Places {
        let mut places = Places {
            top: FxHashMap::default(),
            items: FxHashMap::default(),
            left: AtomicUsize::new(BYTES),
        };
        let mut entries = Entries::new(text, whole(text));
        while let Some((Some(name), value)) = entries.next() {
            let mut items = Entries::new(text, value);
            if items.is_list() {
                let mut spans = Vec::new();
                while let Some((_, item)) = items.next() {
                    spans.push(item);
                }
                places.items.insert(name.clone(), spans);
            }
            places.top.insert(name, value);
        }
        places
    }

    /// The span of the value that a path leads to; if there is none, the span of the last value on the way.
    pub(super) fn find(&self, text: &str, path: &Path) -> Span {
        let Some(PathSegment::Name(first)) = path.0.first() else {
            return whole(text);
        };
        let Some(&list) = self.top.get(first.as_ref()) else {
            return whole(text);
        };
        let Some(PathSegment::Index(index)) = path.0.get(1) else {
            return self.within(text, list, &path.0[1..]);
        };
        match self
            .items
            .get(first.as_ref())
            .and_then(|items| items.get(*index))
        {
            Some(&item) => self.within(text, item, &path.0[2..]),
            None => list,
        }
    }

    fn within(&self, text: &str, mut value: Span, steps: &[PathSegment]) -> Span {
        for step in steps {
            let length = value.range().len();
            let spend = |left: usize| left.checked_sub(length);
            let spent = (self.left).fetch_update(Ordering::Relaxed, Ordering::Relaxed, spend);
            if spent.is_err() {
                return value;
            }
            match inside(text, value, step) {
                Some(next) => value = next,
                None => return value,
            }
        }
        value
    }
}

/// The span of the text without the blanks around it.
fn whole(text: &str) -> Span {
    let start = text.len() - text.trim_start_matches(is_blank).len();
    let end = text.trim_end_matches(is_blank).len().max(start);
    Span::new(start as u32, end as u32)
}

fn is_blank(c: char) -> bool {
    matches!(c, ' ' | '\t' | '\n' | '\r' | '\u{feff}')
}

/// The span of the value that a step leads to. If a name is there twice, the last value counts.
fn inside(text: &str, value: Span, step: &PathSegment) -> Option<Span> {
    let mut entries = Entries::new(text, value);
    let mut found = None;
    let mut index = 0;
    while let Some((name, value)) = entries.next() {
        match (step, name) {
            (PathSegment::Name(wanted), Some(name)) if name == *wanted => found = Some(value),
            (PathSegment::Index(wanted), None) if index == *wanted => return Some(value),
            _ => {}
        }
        index += 1;
    }
    found
}

/// Goes through the values of a list or an object.
struct Entries<'a> {
    text: &'a str,
    at: usize,
    end: usize,
    open: u8,
}

impl<'a> Entries<'a> {
    fn new(text: &'a str, value: Span) -> Entries<'a> {
        let range = value.range();
        let open = text.as_bytes().get(range.start).copied();
        let open = open.filter(|b| matches!(b, b'[' | b'{') && range.len() > 1);
        Entries {
            text,
            at: range.start + 1,
            end: match open {
                Some(_) => range.end - 1,
                None => range.start,
            },
            open: open.unwrap_or_default(),
        }
    }

    fn is_list(&self) -> bool {
        self.open == b'['
    }

    /// The next value, with its name in an object.
    fn next(&mut self) -> Option<(Option<String>, Span)> {
        let name = match self.open {
            b'{' => {
                let name = self.value()?;
                Some(serde_json::from_str(&self.text[name.range()]).unwrap_or_default())
            }
            _ => None,
        };
        Some((name, self.value()?))
    }

    /// The next value, after the signs between values.
    fn value(&mut self) -> Option<Span> {
        let bytes = &self.text.as_bytes()[..self.end];
        let is_between = |b: &&u8| matches!(b, b' ' | b'\t' | b'\n' | b'\r' | b',' | b':');
        let start = self.at + bytes.get(self.at..)?.iter().take_while(is_between).count();
        if start >= self.end {
            return None;
        }
        self.at = end_of(bytes, start);
        Some(Span::new(start as u32, self.at as u32))
    }
}

/// The offset of the end of the value that begins at `start`.
fn end_of(bytes: &[u8], start: usize) -> usize {
    let mut depth = 0usize;
    let mut at = start;
    while let Some(&byte) = bytes.get(at) {
        at += 1;
        match byte {
            b'"' => {
                while let Some(&byte) = bytes.get(at) {
                    at += 1;
                    match byte {
                        b'\\' => at += 1,
                        b'"' => break,
                        _ => {}
                    }
                }
            }
            b'[' | b'{' => depth += 1,
            b']' | b'}' => depth = depth.saturating_sub(1),
            _ if depth == 0 => {
                // A number or a word.
                let goes_on = |b: &&u8| b.is_ascii_alphanumeric() || b"+-.".contains(b);
                at += bytes[at..].iter().take_while(goes_on).count();
            }
            _ => {}
        }
        if depth == 0 {
            break;
        }
    }
    at.min(bytes.len())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_are_found() {
        let text = "\u{feff} {\"a\": 1, \"nodes\" : [ {\"t\":\"x\\\"]\",\"of\":[1.5, -2e3,[]] } ,{\"\\u0061\":true}],\"v\":{}}\n";
        let places = Places::new(text);
        let nodes = || Path::default().name("nodes");
        let at = |path: Path| &text[places.find(text, &path).range()];
        assert_eq!(at(Path::default().name("a")), "1");
        assert_eq!(at(nodes().item(1)), "{\"\\u0061\":true}");
        assert_eq!(at(nodes().item(1).name("a")), "true");
        assert_eq!(at(nodes().item(0).name("t")), "\"x\\\"]\"");
        assert_eq!(at(nodes().item(0).name("of")), "[1.5, -2e3,[]]");
        assert_eq!(at(nodes().item(0).name("of").item(1)), "-2e3");
        assert_eq!(at(nodes().item(0).name("of").item(2)), "[]");
        // As far as it goes.
        assert_eq!(at(nodes().item(0).name("of").item(7)), "[1.5, -2e3,[]]");
        assert_eq!(
            at(nodes().item(0).name("none").item(7)),
            at(nodes().item(0))
        );
        assert_eq!(at(nodes().item(2)), at(nodes()));
        assert_eq!(at(Path::default().name("v").name("mono")), "{}");
        assert_eq!(
            at(Path::default().name("none")),
            text.trim_matches(is_blank)
        );
        assert_eq!(
            nodes().item(0).name("of").item(1).to_string(),
            "nodes[0].of[1]"
        );
    }

    #[test]
    fn however_deep() {
        let text = format!(
            "{{\"nodes\": {}1{}}}",
            "[".repeat(100_000),
            "]".repeat(100_000)
        );
        let places = Places::new(&text);
        let first = places.find(&text, &Path::default().name("nodes").item(0));
        assert_eq!(first.range().len(), 199_999);
    }
}
