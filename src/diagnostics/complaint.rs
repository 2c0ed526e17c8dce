//! What a command has to say that is about no place in a scene: a file that cannot be read, a wish
//! that cannot be met.

use std::error::Error;
use std::fmt;
use std::io;

use super::wording::{Language, Value};

/// A message of the catalogues with what fills its places, still in no language.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Complaint {
    message: &'static str,
    values: Vec<(&'static str, Value)>,
}

impl Complaint {
    /// `message` is a name in the catalogues.
    pub fn new(message: &'static str) -> Complaint {
        Complaint {
            message,
            values: Vec::new(),
        }
    }

    /// Words of others, which are given as they are.
    pub fn quoted(text: impl ToString) -> Complaint {
        Complaint::new("quoted").with("text", text.to_string())
    }

    #[must_use]
    pub fn with(mut self, place: &'static str, value: impl Into<Value>) -> Complaint {
        self.values.push((place, value.into()));
        self
    }

    /// In words.
    pub fn wording(&self, language: Language) -> String {
        language.say(self.message, &self.values)
    }
}

/// In English, for those who do not ask for a language.
impl fmt::Display for Complaint {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.wording(Language::English))
    }
}

impl Error for Complaint {}

impl From<Complaint> for Value {
    fn from(inner: Complaint) -> Value {
        Value::Said(Box::new(inner))
    }
}

/// An error of the operating system, without its number. The common ones are known in every language.
impl From<&io::Error> for Complaint {
    fn from(error: &io::Error) -> Complaint {
        let known = error.raw_os_error().and(match error.kind() {
            io::ErrorKind::NotFound => Some("io-not-found"),
            io::ErrorKind::PermissionDenied => Some("io-denied"),
            io::ErrorKind::IsADirectory => Some("io-is-a-directory"),
            io::ErrorKind::NotADirectory => Some("io-not-a-directory"),
            io::ErrorKind::StorageFull => Some("io-full"),
            io::ErrorKind::ReadOnlyFilesystem => Some("io-read-only"),
            _ => None,
        });
        known.map_or_else(
            || {
                let text = error.to_string();
                let words = text.find(" (os error ").map_or(&*text, |at| &text[..at]);
                Complaint::quoted(words)
            },
            Complaint::new,
        )
    }
}
