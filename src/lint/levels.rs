//! The levels of findings: how the command line and `zpg.toml` change the severities of the codes.

use std::fmt;
use std::str::FromStr;

use crate::diagnostics::{Code, Complaint, Diagnostic, Language, Severity};

/// The way a finding is reported, or not.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Level {
    Error,
    Warning,
    Note,
    Off,
}

impl Level {
    /// The names of the levels.
    pub const NAMES: [&str; 4] = ["error", "warning", "note", "off"];

    pub fn parse(text: &str) -> Option<Level> {
        Some(match text {
            "error" => Level::Error,
            "warning" => Level::Warning,
            "note" => Level::Note,
            "off" => Level::Off,
            _ => return None,
        })
    }

    pub fn as_str(self) -> &'static str {
        Level::NAMES[self as usize]
    }

    /// The level of findings of this severity; `None` for a remark on style, which is none of the levels.
    pub fn of(severity: Severity) -> Option<Level> {
        match severity {
            Severity::Error => Some(Level::Error),
            Severity::Warning => Some(Level::Warning),
            Severity::Note => Some(Level::Note),
            Severity::Style => None,
        }
    }
}

/// One code or several: `W307`, `overlapping-union`, `W3` for all codes that begin so, `warnings`, `notes`, `style`,
/// `all`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Selector(Vec<Code>);

/// The names of groups of codes.
pub const GROUPS: [&str; 4] = ["all", "notes", "style", "warnings"];

/// The error of a text that selects no rule.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct UnknownCode(String);

impl UnknownCode {
    /// The message, with the code or name that may have been meant.
    pub fn complaint(&self) -> Complaint {
        // A code may be wrong in one character, a name in more.
        let codes = Code::ALL.iter().map(|c| (c.as_str(), 1));
        let most = 1 + self.0.len() / 4;
        let names = Code::ALL.iter().map(|c| c.name()).chain(GROUPS);
        let known = codes.chain(names.map(|name| (name, most)));
        let meant = known
            .map(|(name, most)| (strsim::osa_distance(&self.0, name), name, most))
            .filter(|&(distance, _, most)| distance <= most)
            .min();
        let text = crate::syntax::quote(&self.0);
        match meant {
            Some((_, name, _)) => {
                (Complaint::new("no-code-of").with("text", text)).or_meant([name.to_owned()])
            }
            None => Complaint::new("no-code").with("text", text),
        }
    }
}

/// Writes the error in English, for callers that know of no other language.
impl fmt::Display for UnknownCode {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.complaint().wording(Language::English))
    }
}

impl std::error::Error for UnknownCode {}

impl FromStr for Selector {
    type Err = UnknownCode;

    fn from_str(text: &str) -> Result<Selector, UnknownCode> {
        if let Some(code) = Code::parse(text) {
            return Ok(Selector(vec![code]));
        }
        let upper = text.to_ascii_uppercase();
        let chosen = |code: &&Code| match upper.as_str() {
            "ALL" => true,
            "WARNINGS" => code.severity() == Severity::Warning || **code == Code::E106,
            "NOTES" => code.severity() == Severity::Note,
            "STYLE" => code.severity() == Severity::Style,
            "" => false,
            prefix => code.as_str().starts_with(prefix),
        };
        let codes: Vec<Code> = Code::ALL.iter().filter(chosen).copied().collect();
        match codes.is_empty() {
            true => Err(UnknownCode(text.to_owned())),
            false => Ok(Selector(codes)),
        }
    }
}

impl Selector {
    /// The code, if the selector selects just one and that code is an error of the language, which no setting changes.
    pub fn fixed_error(&self) -> Option<Code> {
        match self.0.as_slice() {
            [code] if code.is_never_allowed() => Some(*code),
            _ => None,
        }
    }

    /// The number of codes that the selector selects.
    pub fn breadth(&self) -> usize {
        self.0.len()
    }

    /// Whether the selector selects this code alone.
    pub fn is(&self, code: Code) -> bool {
        self.0 == [code]
    }

    /// Whether the selector selects nothing but errors of the language.
    pub fn only_errors(&self) -> bool {
        self.0.iter().all(|c| c.is_never_allowed())
    }

    /// The codes that the selector selects.
    pub fn codes(&self) -> &[Code] {
        &self.0
    }

    pub fn holds(&self, code: Code) -> bool {
        self.0.contains(&code)
    }
}

/// The codes that a run is to report. If several selectors hold a code, the one that selects the fewest codes counts;
/// among equal ones the one that turns reports off.
#[derive(Debug, Clone, Default)]
pub struct Choice {
    /// The only rules that run, unless the list is empty.
    pub select: Vec<Selector>,
    /// Selectors of codes that are reported even if the settings turn them off.
    pub extend: Vec<Selector>,
    pub ignore: Vec<Selector>,
    /// Selectors of codes that are errors.
    pub deny: Vec<Selector>,
}

/// The levels that settings give to codes in place of the codes' own severities.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Levels {
    own: Vec<(Code, Level)>,
    /// The codes that are not reported, whatever is asked for.
    ignored: Vec<Code>,
}

impl Levels {
    /// Gives codes a level, in place of any earlier one.
    pub fn set(&mut self, codes: &Selector, level: Level) {
        self.own.retain(|(code, _)| !codes.holds(*code));
        self.own.extend(codes.0.iter().map(|&code| (code, level)));
    }

    /// Turns codes off for good: no choice brings them back.
    pub fn ignore(&mut self, codes: &Selector) {
        self.ignored.extend(&codes.0);
    }

    /// Removes findings whose code is off, and gives the others the severity of their level. Errors of the language
    /// stay as they are.
    pub fn apply(&self, choice: &Choice, diagnostics: &mut Vec<Diagnostic>) {
        diagnostics.retain_mut(|d| {
            if d.is_error() {
                return true;
            }
            match self.of(choice, d.code) {
                Some(Level::Off) => return false,
                Some(Level::Error) => d.severity = Severity::Error,
                Some(Level::Warning) => d.severity = Severity::Warning,
                Some(Level::Note) => d.severity = Severity::Note,
                None => {}
            }
            true
        });
    }

    /// Whether findings of a code are reported at all, errors of the language aside.
    pub fn is_on(&self, choice: &Choice, code: Code) -> bool {
        self.of(choice, code) != Some(Level::Off)
    }

    /// The level of a code; `None` if the code keeps its own severity.
    pub fn of(&self, choice: &Choice, code: Code) -> Option<Level> {
        if self.ignored.contains(&code) {
            return Some(Level::Off);
        }
        let narrowest = |list: &[Selector]| -> Option<usize> {
            let holding = list.iter().filter(|s| s.holds(code));
            holding.map(Selector::breadth).min()
        };
        let selected = [&choice.select, &choice.extend];
        let selected = selected
            .into_iter()
            .filter_map(|list| narrowest(list))
            .min();
        let denied = narrowest(&choice.deny);
        let own = self.own.iter().find(|(c, _)| *c == code);
        let mut level = own.map(|(_, level)| *level);
        if selected.is_some() {
            // A code that is selected is on, even if the settings turn it off.
            level = level.filter(|&l| l != Level::Off);
        } else if !choice.select.is_empty() {
            level = Some(Level::Off);
        }
        if denied.is_some() {
            level = Some(Level::Error);
        }
        let wanted = selected.into_iter().chain(denied).min();
        if let Some(ignored) = narrowest(&choice.ignore)
            && wanted.is_none_or(|wanted| ignored <= wanted)
        {
            level = Some(Level::Off);
        }
        level
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnostics::Span;

    fn some() -> Vec<Diagnostic> {
        [Code::E101, Code::W302, Code::W303, Code::N602, Code::S502]
            .map(|c| Diagnostic::new(c, Span::default()))
            .into()
    }

    fn after(levels: &Levels, choice: &Choice) -> Vec<String> {
        let mut all = some();
        levels.apply(choice, &mut all);
        let line = |d: &Diagnostic| format!("{} {}", d.code.as_str(), d.severity.as_str());
        all.iter().map(line).collect()
    }

    fn these(text: &str) -> Vec<Selector> {
        text.split(' ').map(|t| t.parse().unwrap()).collect()
    }

    #[test]
    fn levels_and_choices() {
        let mut levels = Levels::default();
        let none = Choice::default();
        let own = [
            "E101 error",
            "W302 warning",
            "W303 warning",
            "N602 note",
            "S502 style",
        ];
        assert_eq!(after(&levels, &none), own);
        levels.set(&"W3".parse().unwrap(), Level::Note);
        levels.set(&"energy-gain".parse().unwrap(), Level::Off);
        levels.set(&"s502".parse().unwrap(), Level::Warning);
        let set = ["E101 error", "W303 note", "N602 note", "S502 warning"];
        assert_eq!(after(&levels, &none), set);
        let select = Choice {
            select: these("W302 W303"),
            ..none.clone()
        };
        assert_eq!(
            after(&levels, &select),
            ["E101 error", "W302 warning", "W303 note"]
        );
        let deny = Choice {
            deny: these("warnings"),
            ignore: these("W303"),
            ..none
        };
        assert_eq!(
            after(&levels, &deny),
            ["E101 error", "W302 error", "N602 note", "S502 warning"]
        );
    }

    #[test]
    fn the_narrower_choice_counts() {
        let levels = Levels::default();
        let choose = |select: &[&str], ignore: &[&str], deny: &[&str]| {
            let all = |list: &[&str]| list.iter().flat_map(|t| these(t)).collect();
            let choice = Choice {
                select: all(select),
                ignore: all(ignore),
                deny: all(deny),
                extend: Vec::new(),
            };
            after(&levels, &choice)
        };
        let rest = ["E101 error", "W302 error", "N602 note", "S502 style"];
        assert_eq!(choose(&[], &["warnings"], &["W302"]), rest);
        assert_eq!(
            choose(&["W302"], &["W3"], &[]),
            ["E101 error", "W302 warning"]
        );
        assert_eq!(
            choose(&["W3"], &["W303"], &[]),
            ["E101 error", "W302 warning"]
        );
        // Of equal ones what is not to be reported.
        assert_eq!(choose(&["W302"], &["W302"], &[]), ["E101 error"]);
        assert_eq!(
            choose(&[], &["W3"], &["W3"]),
            ["E101 error", "N602 note", "S502 style"]
        );
    }

    #[test]
    fn what_selects_nothing_is_told_what_would() {
        let says = |t: &str| t.parse::<Selector>().unwrap_err().to_string();
        assert_eq!(
            says("enery-gain"),
            "there is no code `enery-gain`; did you mean `energy-gain`?"
        );
        assert_eq!(
            says("Q9"),
            "there is no code `Q9` (`zpg explain` lists all)"
        );
        assert_eq!(
            "e101".parse::<Selector>().unwrap().fixed_error(),
            Some(Code::E101)
        );
        assert_eq!("E".parse::<Selector>().unwrap().fixed_error(), None);
    }
}
