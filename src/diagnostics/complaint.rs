//! Messages of a command that are about no place in a scene: a file cannot be read, a request cannot be met.

#![warn(missing_docs)]

use std::error::Error;
use std::fmt;
use std::io;

use serde::{Serialize, Serializer};

use super::language::Language;
use super::wording::Value;

/// A message of the catalogues with the values of its placeholders, in no language yet.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Complaint {
    message: &'static str,
    values: Vec<(&'static str, Value)>,
    /// Further complaints, a line each.
    others: Vec<Complaint>,
}

impl Complaint {
    /// A complaint of one message, by its name in the catalogues.
    pub fn new(message: &'static str) -> Complaint {
        Complaint {
            message,
            values: Vec::new(),
            others: Vec::new(),
        }
    }

    /// Joins complaints into one, a line each; `None` if there are none.
    pub fn several(all: impl IntoIterator<Item = Complaint>) -> Option<Complaint> {
        let mut all = all.into_iter();
        let mut first = all.next()?;
        first.others.extend(all);
        Some(first)
    }

    /// Adds the names that may have been meant, if there are any.
    #[must_use]
    pub fn or_meant(self, names: impl IntoIterator<Item = String>) -> Complaint {
        match either(names) {
            Some(near) => (Complaint::new("with-near").with("what", self)).with("near", near),
            None => self,
        }
    }

    /// Words of the user, a library or another program, which are shown unchanged.
    pub fn quoted(text: impl ToString) -> Complaint {
        Complaint::new("quoted").with("text", text.to_string())
    }

    /// Words that are English in the source. The catalogues of other languages translate them.
    pub fn term(words: &'static str) -> Complaint {
        Complaint::new("quoted").with("text", Value::Term(words))
    }

    /// Fills a placeholder of the message.
    #[must_use]
    pub fn with(mut self, place: &'static str, value: impl Into<Value>) -> Complaint {
        self.values.push((place, value.into()));
        self
    }

    /// The message in words; several complaints are several lines.
    pub fn wording(&self, language: Language) -> String {
        let own = language.say(self.message, &self.values);
        let others = self.others.iter().map(|other| other.wording(language));
        std::iter::once(own)
            .chain(others)
            .collect::<Vec<_>>()
            .join("\n")
    }

    /// The first complaint alone, then each of those that were joined to it.
    pub fn each(&self) -> impl Iterator<Item = Complaint> + '_ {
        let alone = Complaint {
            others: Vec::new(),
            ..self.clone()
        };
        std::iter::once(alone).chain(self.others.iter().cloned())
    }
}

/// Names in quotes, joined by "or"; `None` without names.
pub fn either(names: impl IntoIterator<Item = String>) -> Option<Value> {
    let quoted = names
        .into_iter()
        .map(|name| Value::from(format!("`{name}`")));
    quoted.reduce(|first, last| {
        let both = Complaint::new("list-or").with("first", first);
        both.with("last", last).into()
    })
}

/// Makes a complaint of words of the source; see [`Complaint::term`].
impl From<&'static str> for Complaint {
    fn from(words: &'static str) -> Complaint {
        Complaint::term(words)
    }
}

/// Writes the message in English, for those who do not ask for a language.
impl fmt::Display for Complaint {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.wording(Language::English))
    }
}

impl Error for Complaint {}

/// Writes the message in English, since programs read it.
impl Serialize for Complaint {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

/// The empty complaint.
impl Default for Complaint {
    fn default() -> Complaint {
        Complaint::quoted("")
    }
}

impl From<Complaint> for Value {
    fn from(inner: Complaint) -> Value {
        Value::Said(Box::new(inner))
    }
}

/// An error of the operating system, without its number. Common errors have a message in every language.
impl From<&io::Error> for Complaint {
    fn from(error: &io::Error) -> Complaint {
        let text = error.to_string();
        let words = text.find(" (os error ");
        // A library may add words to a system error, but keeps its number in the text.
        let is_system = error.raw_os_error().is_some() || words.is_some();
        let known = match error.kind() {
            io::ErrorKind::NotFound => Some("io-not-found"),
            io::ErrorKind::PermissionDenied => Some("io-denied"),
            io::ErrorKind::IsADirectory => Some("io-is-a-directory"),
            io::ErrorKind::NotADirectory => Some("io-not-a-directory"),
            io::ErrorKind::StorageFull => Some("io-full"),
            io::ErrorKind::ReadOnlyFilesystem => Some("io-read-only"),
            _ => None,
        };
        known.filter(|_| is_system).map_or_else(
            || {
                let words = words.map_or(&*text, |at| &text[..at]);
                Complaint::quoted(words)
            },
            Complaint::new,
        )
    }
}
