//! The languages of messages; the texts are in [`wording`](super::wording).

#![warn(missing_docs)]

/// A language of messages.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Language {
    /// English.
    #[default]
    English,
    /// Czech.
    Czech,
}

impl Language {
    /// The tag of the language, as `en`.
    pub fn tag(self) -> &'static str {
        match self {
            Language::English => "en",
            Language::Czech => "cs",
        }
    }

    /// The language with a tag; `None` if there is none.
    pub fn of_tag(tag: &str) -> Option<Language> {
        let all = [Language::English, Language::Czech];
        all.into_iter().find(|language| language.tag() == tag)
    }
}
