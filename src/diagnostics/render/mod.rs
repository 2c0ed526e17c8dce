//! Findings as text: one file per output format.

mod excerpt;
pub mod github;
pub mod gitlab;
pub mod human;
pub mod json;
pub mod junit;
mod labels;
pub mod sarif;
pub mod short;

use std::borrow::Cow;

use super::{Diagnostic, Language, Severity, Value, Wording};

/// The numbers of findings by severity, over any number of files.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize)]
pub struct Tally {
    /// Number of files looked at, with or without findings.
    pub files: usize,
    pub errors: usize,
    pub warnings: usize,
    pub notes: usize,
    pub style: usize,
    /// Number of files with findings.
    #[serde(skip)]
    pub files_with_findings: usize,
    /// Number of findings with a safe fix.
    #[serde(skip)]
    pub fixable: usize,
    #[serde(skip)]
    /// Number of findings without a safe fix, but with an unsafe one that may be applied.
    pub fixable_unsafe: usize,
}

impl Tally {
    /// Adds the findings of one file to the counts.
    pub fn add(&mut self, diagnostics: &[Diagnostic]) {
        self.files += 1;
        self.files_with_findings += usize::from(!diagnostics.is_empty());
        for diagnostic in diagnostics {
            match diagnostic.severity {
                Severity::Error => self.errors += 1,
                Severity::Warning => self.warnings += 1,
                Severity::Note => self.notes += 1,
                Severity::Style => self.style += 1,
            }
            let safe = diagnostic.applicable_fix(false).is_some();
            self.fixable += usize::from(safe);
            let guess = diagnostic.applicable_fix(true).is_some();
            self.fixable_unsafe += usize::from(!safe && guess);
        }
    }

    /// Adds the counts of another tally.
    pub fn merge(&mut self, other: &Tally) {
        self.files += other.files;
        self.errors += other.errors;
        self.warnings += other.warnings;
        self.notes += other.notes;
        self.style += other.style;
        self.files_with_findings += other.files_with_findings;
        self.fixable += other.fixable;
        self.fixable_unsafe += other.fixable_unsafe;
    }

    /// Whether nothing at all was found.
    pub fn is_clean(&self) -> bool {
        self.files_with_findings == 0
    }
}

impl Tally {
    /// The sentence with the counts: `Found 3 errors and 1 warning in 2 files; 2 can be fixed with …`
    pub fn sentence(&self, language: Language) -> String {
        let count = |n: usize| Value::Count(n as u64);
        if self.is_clean() {
            return language.say("tally-clean", &[]);
        }
        let parts: Vec<String> = [
            (self.errors, "tally-errors"),
            (self.warnings, "tally-warnings"),
            (self.notes, "tally-notes"),
            (self.style, "tally-style"),
        ]
        .into_iter()
        .filter(|&(n, _)| n > 0)
        .map(|(n, what)| language.say(what, &[("count", count(n))]))
        .collect();
        let findings = match parts.as_slice() {
            [rest @ .., last] if !rest.is_empty() => {
                let (first, last) = (rest.join(", ").into(), last.clone().into());
                language.say("list-and", &[("first", first), ("last", last)])
            }
            parts => parts.concat(),
        };
        let values = [
            ("findings", findings.into()),
            ("files", count(self.files_with_findings)),
            ("fixable", count(self.fixable)),
            ("unsafe", count(self.fixable_unsafe)),
        ];
        language.say("tally-found", &values)
    }
}

/// All texts of a finding except those of its second places, each on a line.
fn one_text(words: &Wording, language: Language) -> String {
    let mut lines = vec![words.message.as_str()];
    // The label "here" says nothing without an arrow.
    if words.label != language.say("here", &[]) {
        lines.push(&words.label);
    }
    lines.extend(words.notes.iter().chain(&words.help).map(String::as_str));
    lines.join("\n")
}

/// A path in the form in which programs compare paths: with slashes, and without parts that lead nowhere (`./a` is
/// `a`).
fn plain_path(path: &str, windows: bool) -> String {
    let separators: &[char] = if windows { &['/', '\\'] } else { &['/'] };
    let parts: Vec<&str> = path.split(separators).filter(|&p| p != ".").collect();
    parts.join("/")
}

/// Whether a character would move the cursor, reorder text or end a line on a terminal.
fn is_disruptive(c: char) -> bool {
    c.is_control()
        || matches!(c, '\u{200e}' | '\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{2069}' | '\u{feff}')
}

/// A text on one line that is safe to print on a terminal: scenes and file names are foreign text
/// and messages quote them. Every character stays one character.
fn visible(text: &str) -> Cow<'_, str> {
    if text.chars().any(is_disruptive) {
        Cow::Owned(text.chars().map(visible_char).collect())
    } else {
        Cow::Borrowed(text)
    }
}

fn visible_char(c: char) -> char {
    match c {
        '\t' | '\n' | '\r' => ' ',
        c if is_disruptive(c) => '\u{fffd}',
        c => c,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnostics::{Code, Span};

    #[test]
    fn the_tally_reads_as_a_sentence() {
        let mut tally = Tally::default();
        let says = |tally: &Tally| [Language::English, Language::Czech].map(|l| tally.sentence(l));
        assert_eq!(says(&tally), ["All checks passed!", "Vše je v pořádku!"]);
        let found = |code| Diagnostic::new(code, Span::default());
        tally.add(&[found(Code::E106)]);
        tally.add(&[]);
        assert_eq!(
            says(&tally),
            ["Found 1 error in 1 file.", "Nalezeno: 1 chyba (1 soubor)."]
        );
        tally.add(&[found(Code::E106), found(Code::W306), found(Code::N602)]);
        assert_eq!(
            says(&tally),
            [
                "Found 2 errors, 1 warning and 1 note in 2 files.",
                "Nalezeno: 2 chyby, 1 varování a 1 poznámka (2 soubory)."
            ]
        );
        assert_eq!(tally.files, 3);
    }

    #[test]
    fn foreign_text_cannot_drive_the_terminal() {
        assert_eq!(visible("a\u{1b}[31m\tb\n"), "a\u{fffd}[31m b ");
        assert_eq!(visible("koule"), "koule");
    }
}
