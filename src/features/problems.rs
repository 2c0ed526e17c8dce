//! Findings as an editor shows them.

use crate::analysis::{Analysis, repair};
use crate::diagnostics::{Code, Diagnostic, Language, Severity, Span};

/// How many findings of one file are shown: an editor with more of them is slow, and nobody reads them.
pub const MAX_SHOWN: usize = 1000;

/// A finding in words.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Problem {
    pub span: Span,
    pub severity: Severity,
    /// The code of the finding; `None` for the remark on how many are left out.
    pub code: Option<Code>,
    /// The message, its notes and its help, a line each.
    pub message: String,
    /// Related places, and why they matter.
    pub related: Vec<(Span, String)>,
    /// Whether the problem is about something that is not needed.
    pub unnecessary: bool,
}

/// The findings of a scene, as `zpg check` words them. If there are more than [`MAX_SHOWN`], the gravest ones, and a
/// remark on how many are left out.
pub fn problems(analysis: &Analysis, language: Language) -> Vec<Problem> {
    let all = repair::proposals(analysis);
    let mut shown: Vec<&Diagnostic> = all.iter().collect();
    if all.len() <= MAX_SHOWN {
        return shown.iter().map(|d| problem(d, language)).collect();
    }
    // The sort is stable, so that findings of one severity stay in the order of places.
    shown.sort_by_key(|d| rank(d.severity));
    shown.truncate(MAX_SHOWN);
    let mut out: Vec<Problem> = shown.iter().map(|d| problem(d, language)).collect();
    let count = (all.len() - MAX_SHOWN) as u64;
    let values = [("count", crate::diagnostics::Value::Count(count))];
    out.push(Problem {
        span: Span::default(),
        severity: shown.first().map_or(Severity::Note, |d| d.severity),
        code: None,
        message: language.say("lsp-left-out", &values),
        related: Vec::new(),
        unnecessary: false,
    });
    out
}

fn rank(severity: Severity) -> u8 {
    match severity {
        Severity::Error => 0,
        Severity::Warning => 1,
        Severity::Note => 2,
        Severity::Style => 3,
    }
}

fn problem(d: &Diagnostic, language: Language) -> Problem {
    let words = d.wording(language);
    let mut message = words.message;
    for line in words.notes.iter().chain(&words.help) {
        message.push('\n');
        message.push_str(line);
    }
    Problem {
        span: d.span,
        severity: d.severity,
        code: Some(d.code),
        message,
        related: (d.labels.iter().map(|l| l.span).zip(words.labels)).collect(),
        unnecessary: matches!(d.code, Code::W310 | Code::S504),
    }
}
