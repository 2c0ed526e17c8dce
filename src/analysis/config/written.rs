//! Settings as they are written, in a file or on the command line.

use std::path::Path;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::patterns::Pattern;
use crate::diagnostics::{Code, Complaint};
use crate::format::{Numbers, Options};
use crate::lint::levels::{GROUPS, Level, Selector, UnknownCode};
use crate::syntax::quote;

/// The settings that are stated in one place; all others are `None` or empty.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(super) struct Written {
    pub exclude: Option<Vec<Pattern>>,
    pub per_file_ignores: Option<Vec<(Pattern, Vec<Selector>)>>,
    pub levels: Vec<(Selector, Level)>,
    pub width: Option<usize>,
    pub align: Option<bool>,
    pub group: Option<bool>,
    pub numbers: Option<Numbers>,
}

/// The byte offset of a fault in the text, and the fault.
pub(super) type Fault = (usize, Complaint);

const EXCLUDE: &str = "exclude";
const PER_FILE_IGNORES: &str = "per-file-ignores";
const LINT: &str = "lint";
const FORMAT: &str = "format";

/// The names at the top level: single settings and tables. The table `lint` also has codes as names.
const TOP: [&str; 4] = [EXCLUDE, FORMAT, LINT, PER_FILE_IGNORES];
/// The settings that are true or false.
const BOOLEANS: [&str; 2] = ["align", "group"];
const OF_FORMAT: [&str; 4] = ["align", "group", "numbers", "width"];

type KeyValue<'t, 'i> = (
    &'t Spanned<std::borrow::Cow<'i, str>>,
    &'t Spanned<DeValue<'i>>,
);

impl Written {
    /// Reads settings from a text of TOML. Their patterns are about the folder `root`.
    ///
    /// # Errors
    ///
    /// All faults of the text with their offsets, in the order of the text.
    pub(super) fn read(text: &str, root: &Path) -> Result<Written, Vec<Fault>> {
        let (table, errors) = DeTable::parse_recoverable(text);
        let faults = errors.iter().map(|e| {
            let at = e.span().map_or(0, |s| s.start);
            let other = || Complaint::new("setting-toml").with("reason", e.message().to_owned());
            (at, text_is_meant(text, at).unwrap_or_else(other))
        });
        let mut reader = Reader {
            text,
            root,
            faults: faults.collect(),
        };
        let mut out = Written::default();
        // If the text is no TOML, the part that can be read says little.
        if reader.faults.is_empty() {
            reader.top(table.get_ref(), &mut out);
        }
        reader.faults.sort_by_key(|fault| fault.0);
        match reader.faults.is_empty() {
            true => Ok(out),
            false => Err(reader.faults),
        }
    }
}

/// The complaint that proposes a right value, `true` or `false` or a text in quotes, if a bare word such as `no` or
/// `off` is the value on the line of `at`.
fn text_is_meant(text: &str, at: usize) -> Option<Complaint> {
    let start = text.get(..at)?.rfind('\n').map_or(0, |end| end + 1);
    let line = text[start..].lines().next()?;
    if let Some((_, word)) = bare(line) {
        let right = quote(&format!("\"{word}\""));
        let why = Complaint::new("setting-quotes").with("right", right);
        return Some(why.with("text", quote(word)));
    }
    let word = word(line)?.1;
    Some(Complaint::new("setting-truth").with("text", quote(word)))
}

/// The key and the value of a setting on a line, if the value is a bare word that lacks its quotes.
pub(super) fn bare(line: &str) -> Option<(&str, &str)> {
    let (key, word) = word(line)?;
    let name = key.rsplit('.').next()?;
    (!BOOLEANS.contains(&name)).then_some((key, word))
}

/// The key and the value of a setting on a line, if the value is a bare word that means nothing in TOML.
fn word(line: &str) -> Option<(&str, &str)> {
    let (key, value) = line.split_once('=')?;
    let word = value.split('#').next()?.trim();
    let is_part = |c: char| c.is_alphanumeric() || matches!(c, '-' | '_');
    if !word.starts_with(char::is_alphabetic)
        || !word.chars().all(is_part)
        || matches!(word, "true" | "false" | "inf" | "nan")
    {
        return None;
    }
    Some((key.trim(), word))
}

/// The entries of a table, in the order of the text.
fn entries<'t, 'i>(table: &'t DeTable<'i>) -> Vec<KeyValue<'t, 'i>> {
    let mut all: Vec<_> = table.iter().collect();
    all.sort_by_key(|(key, _)| key.span().start);
    all
}

struct Reader<'a> {
    text: &'a str,
    root: &'a Path,
    faults: Vec<Fault>,
}

impl Reader<'_> {
    /// The value of a result, or `None` for a fault, which is kept.
    fn keep<T>(&mut self, result: Result<T, Fault>) -> Option<T> {
        result.map_err(|fault| self.faults.push(fault)).ok()
    }

    fn top(&mut self, table: &DeTable, out: &mut Written) {
        for (key, value) in entries(table) {
            match key.get_ref().as_ref() {
                EXCLUDE => out.exclude = Some(self.patterns(EXCLUDE, value)),
                PER_FILE_IGNORES => {
                    out.per_file_ignores = Some(self.per_file_ignores(PER_FILE_IGNORES, value));
                }
                LINT => self.lint(value, out),
                FORMAT => self.format(value, out),
                _ => self.faults.push(unknown("", key, &TOP)),
            }
        }
    }

    fn lint(&mut self, value: &Spanned<DeValue>, out: &mut Written) {
        for (key, value) in self.entries_of(LINT, value) {
            let name = key.get_ref().as_ref();
            let full = format!("{LINT}.{name}");
            if name == PER_FILE_IGNORES {
                out.per_file_ignores = Some(self.per_file_ignores(&full, value));
                continue;
            }
            let codes = name.parse().map_err(|e: UnknownCode| {
                // The name of a setting of another table is not taken for a misspelt code.
                match misplaced(name).or_else(|| near(name, &[PER_FILE_IGNORES])) {
                    near if near.is_some() || OF_RUFF.contains(&name) => {
                        let codes = Complaint::new("setting-codes-known");
                        (key.span().start, no_setting(&full, codes, near))
                    }
                    _ => (key.span().start, e.complaint()),
                }
            });
            let Some(codes) = self.keep(codes) else {
                continue;
            };
            let level = self.level(&full, value);
            if let Some(level) = self.keep(level) {
                let changeable = changeable(&codes, level, key.span().start);
                self.keep(changeable);
                out.levels.push((codes, level));
            }
        }
    }

    fn level(&self, key: &str, value: &Spanned<DeValue>) -> Result<Level, Fault> {
        let text = value.get_ref().as_str();
        text.and_then(Level::parse).ok_or_else(|| {
            let (at, why) = self.unfit(key, "setting-level", value);
            (
                at,
                why.or_meant(text.and_then(|text| near(text, &Level::NAMES))),
            )
        })
    }

    fn format(&mut self, value: &Spanned<DeValue>, out: &mut Written) {
        for (key, value) in self.entries_of(FORMAT, value) {
            let name = key.get_ref().as_ref();
            let full = format!("{FORMAT}.{name}");
            let is = value.get_ref();
            let wanted = match name {
                "width" => {
                    let width = is.as_integer().and_then(|n| {
                        let digits = n.as_str().replace('_', "");
                        usize::from_str_radix(&digits, n.radix()).ok()
                    });
                    out.width = width.filter(|w| Options::WIDTHS.contains(w));
                    out.width.is_none().then_some("setting-width")
                }
                "align" => {
                    out.align = is.as_bool();
                    out.align.is_none().then_some("setting-bool")
                }
                "group" => {
                    out.group = is.as_bool();
                    out.group.is_none().then_some("setting-bool")
                }
                "numbers" => {
                    out.numbers = match is.as_str() {
                        Some("shortest") => Some(Numbers::Shortest),
                        Some("keep") => Some(Numbers::Keep),
                        _ => None,
                    };
                    out.numbers.is_none().then_some("setting-numbers")
                }
                _ => {
                    self.faults.push(unknown(FORMAT, key, &OF_FORMAT));
                    None
                }
            };
            self.faults
                .extend(wanted.map(|wanted| self.unfit(&full, wanted, value)));
        }
    }

    fn per_file_ignores(
        &mut self,
        name: &str,
        value: &Spanned<DeValue>,
    ) -> Vec<(Pattern, Vec<Selector>)> {
        let mut out = Vec::new();
        for (key, value) in self.entries_of(name, value) {
            let pattern = Pattern::new_or_not(key.get_ref(), self.root);
            let pattern = self.keep(pattern.map_err(|why| (key.span().start, why)));
            let full = format!("{name}.\"{}\"", key.get_ref());
            let mut codes = Vec::new();
            for (at, text) in self.texts(&full, "setting-codes", value) {
                let selector = text.parse().map_err(|e: UnknownCode| (at, e.complaint()));
                if let Some(selector) = self.keep(selector) {
                    self.keep(changeable(&selector, Level::Off, at));
                    codes.push(selector);
                }
            }
            out.extend(pattern.map(|pattern| (pattern, codes)));
        }
        out
    }

    fn patterns(&mut self, key: &str, value: &Spanned<DeValue>) -> Vec<Pattern> {
        let texts = self.texts(key, "setting-patterns", value);
        let patterns = texts.into_iter().filter_map(|(at, text)| {
            let pattern = Pattern::new(text, self.root);
            self.keep(pattern.map_err(|why| (at, why)))
        });
        patterns.collect()
    }

    /// The texts of a list, each with its offset; empty for a value that is no list.
    fn texts<'v>(
        &mut self,
        key: &str,
        wanted: &'static str,
        value: &'v Spanned<DeValue>,
    ) -> Vec<(usize, &'v str)> {
        let Some(list) = value.get_ref().as_array() else {
            self.faults.push(self.unfit(key, wanted, value));
            return Vec::new();
        };
        let texts = list.iter().filter_map(|item| {
            let text = item.get_ref().as_str();
            let text = text.ok_or_else(|| self.unfit(key, wanted, item));
            Some((item.span().start, self.keep(text)?))
        });
        texts.collect()
    }

    /// The entries of a table; none for a value that is no table.
    fn entries_of<'v, 'i>(
        &mut self,
        key: &str,
        value: &'v Spanned<DeValue<'i>>,
    ) -> Vec<KeyValue<'v, 'i>> {
        match value.get_ref().as_table() {
            Some(table) => entries(table),
            None => {
                self.faults.push(self.unfit(key, "setting-table", value));
                Vec::new()
            }
        }
    }

    /// The fault of a setting with a value that it cannot have.
    fn unfit(&self, key: &str, wanted: &'static str, value: &Spanned<DeValue>) -> Fault {
        let found = self.text.get(value.span()).unwrap_or_default();
        let why = Complaint::new("setting-value")
            .with("key", key.to_owned())
            .with("wanted", Complaint::new(wanted))
            .with("found", quote(found));
        (value.span().start, why)
    }
}

/// Checks that errors of the language stay errors.
fn changeable(codes: &Selector, level: Level, at: usize) -> Result<(), Fault> {
    match codes.fixed_error() {
        Some(code) if level != Level::Error => Err((
            at,
            Complaint::new("always-error").with("code", code.as_str()),
        )),
        _ => Ok(()),
    }
}

/// The fault of a table that has a setting of an unknown name.
fn unknown(table: &str, key: &Spanned<std::borrow::Cow<str>>, known: &[&'static str]) -> Fault {
    let name = key.get_ref().as_ref();
    let full = match table {
        "" => name.to_owned(),
        table => format!("{table}.{name}"),
    };
    let list: Vec<String> = known.iter().map(|k| format!("`{k}`")).collect();
    let list = Complaint::quoted(list.join(", "));
    let within =
        |table: &str, names: &[&'static str]| Some(format!("{table}.{}", near(name, names)?));
    let nested = || within(LINT, &GROUPS).or_else(|| within(FORMAT, &OF_FORMAT));
    let near = (near(name, known).or_else(|| misplaced(name)))
        .or_else(|| nested().filter(|_| table.is_empty()));
    (key.span().start, no_setting(&full, list, near))
}

fn no_setting(key: &str, known: Complaint, near: Option<String>) -> Complaint {
    let why = Complaint::new("setting-unknown")
        .with("key", quote(key))
        .with("known", known);
    why.or_meant(near)
}

/// Names of lists of codes in ruff's settings, which zpg does not have: in zpg each code has a level.
const OF_RUFF: [&str; 4] = ["ignore", "select", "extend-ignore", "extend-select"];

/// The full name of a setting that belongs in another table. `None` if no table has a setting with this name.
fn misplaced(name: &str) -> Option<String> {
    let is_code = || Code::parse(name).is_some();
    match name {
        EXCLUDE => Some(EXCLUDE.to_owned()),
        // Ruff has this name for the width.
        "line-length" => Some(format!("{FORMAT}.width")),
        _ if OF_FORMAT.contains(&name) => Some(format!("{FORMAT}.{name}")),
        _ if is_code() => Some(format!("{LINT}.{name}")),
        _ => None,
    }
}

/// The name in a list that is spelt most similarly to a text, if it is similar enough.
fn near(text: &str, names: &[&'static str]) -> Option<String> {
    let distance = |name: &str| match text.len() > 1 && name.starts_with(text) {
        true => 0,
        false => strsim::osa_distance(text, name),
    };
    let distances = names.iter().map(|n| (distance(n), *n));
    let (_, name) = distances.min().filter(|&(d, n)| d <= 1 + n.len() / 4)?;
    Some(name.to_owned())
}
