//! A finding: its code, its places, its fixes.

#![warn(missing_docs)]

use super::code::{Code, Severity};
use super::span::Span;
use super::wording::Value;

/// A second place of a finding, and what it has to do with the finding.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Label {
    /// The place.
    pub span: Span,
    /// The name of the phrase about the place; see [`wording`](super::wording).
    pub phrase: &'static str,
}

/// Whether a fix may be applied without asking.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Applicability {
    /// The fix keeps the meaning, or clearly gives what was meant.
    Safe,
    /// The fix is a good guess; a person should look at it.
    Unsafe,
    /// The fix is one of several guesses that are equally good: a person has to choose, and it is never applied.
    Choice,
}

/// A replacement of text.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Edit {
    /// The text that is replaced.
    pub span: Span,
    /// The text that takes its place.
    pub text: String,
}

/// A set of edits that belong together.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Fix {
    /// The name of the phrase that says what the fix does; see [`wording`](super::wording).
    pub title: &'static str,
    /// The values of the title's placeholders, where they differ from those of the finding.
    pub values: Vec<(&'static str, Value)>,
    /// Whether the edits may be made without asking.
    pub applicability: Applicability,
    /// The edits in order of their spans, which do not overlap.
    pub edits: Vec<Edit>,
}

impl Fix {
    /// An unsafe fix of several edits.
    pub fn guess(title: &'static str, edits: Vec<Edit>) -> Fix {
        Fix {
            title,
            values: Vec::new(),
            applicability: Applicability::Unsafe,
            edits,
        }
    }

    /// A fix of one edit.
    pub fn replace(
        title: &'static str,
        applicability: Applicability,
        span: Span,
        text: impl Into<String>,
    ) -> Fix {
        Fix {
            title,
            values: Vec::new(),
            applicability,
            edits: vec![Edit {
                span,
                text: text.into(),
            }],
        }
    }

    /// Fills a placeholder of the title.
    pub fn with(mut self, place: &'static str, value: impl Into<Value>) -> Self {
        self.values.push((place, value.into()));
        self
    }
}

/// A finding, in no language yet: [`wording`](super::wording) says it in words.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Diagnostic {
    /// The code.
    pub code: Code,
    /// The severity.
    pub severity: Severity,
    /// The name of the place in a file that is no text of records, as `nodes[3].radius`; otherwise `None`.
    pub at: Option<String>,
    /// The case of the message, where a code has several: `decimal-comma` for `E003-decimal-comma`. Empty for the
    /// message `E003`.
    pub case: &'static str,
    /// The values of the message's placeholders.
    pub values: Vec<(&'static str, Value)>,
    /// The place to look at first.
    pub span: Span,
    /// The second places of the finding.
    pub labels: Vec<Label>,
    /// The names of phrases that are notes, beside the message's own note.
    pub notes: Vec<&'static str>,
    /// Proposed fixes.
    pub fixes: Vec<Fix>,
}

impl Diagnostic {
    /// A finding with the code's own severity and message.
    pub fn new(code: Code, span: Span) -> Diagnostic {
        Diagnostic {
            code,
            severity: code.severity(),
            at: None,
            case: "",
            values: Vec::new(),
            span,
            labels: Vec::new(),
            notes: Vec::new(),
            fixes: Vec::new(),
        }
    }

    /// Chooses one of the code's messages.
    pub fn case(mut self, case: &'static str) -> Self {
        self.case = case;
        self
    }

    /// Fills a placeholder of the message, its label, notes, help and fixes.
    pub fn with(mut self, place: &'static str, value: impl Into<Value>) -> Self {
        self.values.push((place, value.into()));
        self
    }

    /// Points at a second place.
    pub fn label(mut self, span: Span, phrase: &'static str) -> Self {
        self.labels.push(Label { span, phrase });
        self
    }

    /// Adds a note, by the name of its phrase.
    pub fn note(mut self, phrase: &'static str) -> Self {
        self.notes.push(phrase);
        self
    }

    /// Adds a fix.
    pub fn fix(mut self, fix: Fix) -> Self {
        self.fixes.push(fix);
        self
    }

    /// Gives the finding another severity than its code has.
    pub fn severity(mut self, severity: Severity) -> Self {
        self.severity = severity;
        self
    }

    /// Whether the finding is an error.
    pub fn is_error(&self) -> bool {
        self.severity == Severity::Error
    }
}

/// Sorts findings for output: by place, then by code.
pub fn sort(diagnostics: &mut [Diagnostic]) {
    diagnostics.sort_by(|a, b| {
        (a.span.start, a.span.end, a.code.as_str()).cmp(&(
            b.span.start,
            b.span.end,
            b.code.as_str(),
        ))
    });
}
