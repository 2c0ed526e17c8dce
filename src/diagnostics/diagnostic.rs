//! A finding: its code, its places, its fixes.

#![warn(missing_docs)]

use super::code::{Code, Severity};
use super::span::Span;
use super::wording::Value;

/// A second place that matters, with what it has to do with the matter.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Label {
    /// The place.
    pub span: Span,
    /// A phrase; see [`wording`](super::wording).
    pub phrase: &'static str,
}

/// Whether a fix may be applied without asking.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Applicability {
    /// Same meaning, or clearly what was meant.
    Safe,
    /// A good guess; a person should look.
    Unsafe,
    /// A fix among several guesses that are as good: a person has to choose, and it is never applied.
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
    /// A phrase, what the fix does; see [`wording`](super::wording).
    pub title: &'static str,
    /// The values in the places of the title, where they are not those of the finding.
    pub values: Vec<(&'static str, Value)>,
    /// Whether the edits may be made without asking.
    pub applicability: Applicability,
    /// The edits in order of their spans, which do not overlap.
    pub edits: Vec<Edit>,
}

impl Fix {
    /// A guess of several edits.
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

    /// Fills a place of the title.
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
    /// The name of the place in a file that is no text of records: `nodes[3].radius`.
    pub at: Option<String>,
    /// The case of the message, where a code has several: `decimal-comma` for `E003-decimal-comma`. Empty for the
    /// message `E003`.
    pub case: &'static str,
    /// The values in the places of the message.
    pub values: Vec<(&'static str, Value)>,
    /// The place to look at first.
    pub span: Span,
    /// Second places that matter.
    pub labels: Vec<Label>,
    /// Phrases beside the message's own note.
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

    /// Fills a place of the message, its label, notes, help and fixes.
    pub fn with(mut self, place: &'static str, value: impl Into<Value>) -> Self {
        self.values.push((place, value.into()));
        self
    }

    /// Points at a second place.
    pub fn label(mut self, span: Span, phrase: &'static str) -> Self {
        self.labels.push(Label { span, phrase });
        self
    }

    /// Adds a note, by its message.
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
