//! Settings as they are written, in a file or on the command line.

use std::path::Path;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::patterns::Pattern;
use crate::diagnostics::{Code, Complaint};
use crate::format::{Numbers, Options};
use crate::lint::levels::{Level, Selector, UnknownCode};
use crate::syntax::quote;

/// Some settings; the rest is as it was.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Written {
    pub exclude: Option<Vec<Pattern>>,
    pub per_file_ignores: Option<Vec<(Pattern, Vec<Selector>)>>,
    pub levels: Vec<(Selector, Level)>,
    pub width: Option<usize>,
    pub align: Option<bool>,
    pub group: Option<bool>,
    pub numbers: Option<Numbers>,
}

/// What is wrong, and at which byte of the text.
pub type Fault = (usize, Complaint);

const EXCLUDE: &str = "exclude";
const PER_FILE_IGNORES: &str = "per-file-ignores";
const LINT: &str = "lint";
const FORMAT: &str = "format";

/// The settings of each table by their whole names. In `lint` codes stand beside them.
const TOP: [&str; 4] = [EXCLUDE, FORMAT, LINT, PER_FILE_IGNORES];
const OF_FORMAT: [&str; 4] = ["align", "group", "numbers", "width"];

type Entry<'t, 'i> = (
    &'t Spanned<std::borrow::Cow<'i, str>>,
    &'t Spanned<DeValue<'i>>,
);

impl Written {
    /// Reads settings that are about a folder.
    ///
    /// # Errors
    ///
    /// What is wrong with the text, and where.
    pub fn read(text: &str, root: &Path) -> Result<Written, Fault> {
        let table = DeTable::parse(text).map_err(|e| {
            let why = Complaint::new("setting-toml").with("reason", e.message().to_owned());
            (e.span().map_or(0, |s| s.start), why)
        })?;
        let mut out = Written::default();
        let reader = Reader { text, root };
        for (key, value) in entries(table.get_ref()) {
            match key.get_ref().as_ref() {
                EXCLUDE => out.exclude = Some(reader.patterns(EXCLUDE, value)?),
                PER_FILE_IGNORES => {
                    out.per_file_ignores = Some(reader.per_file_ignores(PER_FILE_IGNORES, value)?);
                }
                LINT => reader.lint(value, &mut out)?,
                FORMAT => reader.format(value, &mut out)?,
                _ => return Err(unknown("", key, &TOP)),
            }
        }
        Ok(out)
    }
}

/// What a table has, in the order of the text.
fn entries<'t, 'i>(table: &'t DeTable<'i>) -> Vec<Entry<'t, 'i>> {
    let mut all: Vec<_> = table.iter().collect();
    all.sort_by_key(|(key, _)| key.span().start);
    all
}

struct Reader<'a> {
    text: &'a str,
    root: &'a Path,
}

impl Reader<'_> {
    fn lint(&self, value: &Spanned<DeValue>, out: &mut Written) -> Result<(), Fault> {
        for (key, value) in entries(self.table(LINT, value)?) {
            let name = key.get_ref().as_ref();
            let full = format!("{LINT}.{name}");
            if name == PER_FILE_IGNORES {
                out.per_file_ignores = Some(self.per_file_ignores(&full, value)?);
                continue;
            }
            let codes = name.parse().map_err(|e: UnknownCode| {
                // What belongs elsewhere is no code that is misspelt.
                match misplaced(name).or_else(|| near(name, &[PER_FILE_IGNORES])) {
                    Some(near) => {
                        let codes = Complaint::new("setting-codes-known");
                        (key.span().start, no_setting(&full, codes, Some(near)))
                    }
                    None => (key.span().start, e.complaint()),
                }
            })?;
            let level = self.level(&full, value)?;
            self.changeable(&codes, level, key.span().start)?;
            out.levels.push((codes, level));
        }
        Ok(())
    }

    /// Errors of the language stay errors.
    fn changeable(&self, codes: &Selector, level: Level, at: usize) -> Result<(), Fault> {
        match codes.fixed_error() {
            Some(code) if level != Level::Error => Err((
                at,
                Complaint::new("always-error").with("code", code.as_str()),
            )),
            _ => Ok(()),
        }
    }

    fn level(&self, key: &str, value: &Spanned<DeValue>) -> Result<Level, Fault> {
        let text = value.get_ref().as_str();
        text.and_then(Level::parse).ok_or_else(|| {
            let (at, why) = self.unfit(key, "setting-level", value);
            let near = text.and_then(|text| near(text, &Level::NAMES));
            (at, with_near(why, near))
        })
    }

    fn format(&self, value: &Spanned<DeValue>, out: &mut Written) -> Result<(), Fault> {
        for (key, value) in entries(self.table(FORMAT, value)?) {
            let name = key.get_ref().as_ref();
            let full = format!("{FORMAT}.{name}");
            let yes = || {
                let yes = value.get_ref().as_bool();
                yes.ok_or_else(|| self.unfit(&full, "setting-bool", value))
            };
            match name {
                "width" => {
                    let width = value.get_ref().as_integer().and_then(|n| {
                        let digits = n.as_str().replace('_', "");
                        usize::from_str_radix(&digits, n.radix()).ok()
                    });
                    let width = width.filter(|w| Options::WIDTHS.contains(w));
                    out.width =
                        Some(width.ok_or_else(|| self.unfit(&full, "setting-width", value))?);
                }
                "align" => out.align = Some(yes()?),
                "group" => out.group = Some(yes()?),
                "numbers" => {
                    out.numbers = Some(match value.get_ref().as_str() {
                        Some("shortest") => Numbers::Shortest,
                        Some("keep") => Numbers::Keep,
                        _ => return Err(self.unfit(&full, "setting-numbers", value)),
                    });
                }
                _ => return Err(unknown(FORMAT, key, &OF_FORMAT)),
            }
        }
        Ok(())
    }

    fn per_file_ignores(
        &self,
        name: &str,
        value: &Spanned<DeValue>,
    ) -> Result<Vec<(Pattern, Vec<Selector>)>, Fault> {
        let mut out = Vec::new();
        for (key, value) in entries(self.table(name, value)?) {
            let at = key.span().start;
            let pattern = Pattern::new_or_not(key.get_ref(), self.root).map_err(|why| (at, why))?;
            let full = format!("{name}.\"{}\"", key.get_ref());
            let mut codes = Vec::new();
            for (at, text) in self.texts(&full, "setting-codes", value)? {
                let selector: Selector =
                    (text.parse()).map_err(|e: UnknownCode| (at, e.complaint()))?;
                self.changeable(&selector, Level::Off, at)?;
                codes.push(selector);
            }
            out.push((pattern, codes));
        }
        Ok(out)
    }

    fn patterns(&self, key: &str, value: &Spanned<DeValue>) -> Result<Vec<Pattern>, Fault> {
        let texts = self.texts(key, "setting-patterns", value)?;
        let patterns = texts
            .into_iter()
            .map(|(at, text)| Pattern::new(text, self.root).map_err(|why| (at, why)));
        patterns.collect()
    }

    /// A list of texts, and where each stands.
    fn texts<'v>(
        &self,
        key: &str,
        wanted: &'static str,
        value: &'v Spanned<DeValue>,
    ) -> Result<Vec<(usize, &'v str)>, Fault> {
        let list = value.get_ref().as_array();
        let list = list.ok_or_else(|| self.unfit(key, wanted, value))?;
        let texts = list.iter().map(|item| match item.get_ref().as_str() {
            Some(text) => Ok((item.span().start, text)),
            None => Err(self.unfit(key, wanted, item)),
        });
        texts.collect()
    }

    fn table<'v, 'i>(
        &self,
        key: &str,
        value: &'v Spanned<DeValue<'i>>,
    ) -> Result<&'v DeTable<'i>, Fault> {
        let table = value.get_ref().as_table();
        table.ok_or_else(|| self.unfit(key, "setting-table", value))
    }

    /// A setting has a value that it cannot have.
    fn unfit(&self, key: &str, wanted: &'static str, value: &Spanned<DeValue>) -> Fault {
        let found = self.text.get(value.span()).unwrap_or_default();
        let why = Complaint::new("setting-value")
            .with("key", key.to_owned())
            .with("wanted", Complaint::new(wanted))
            .with("found", quote(found));
        (value.span().start, why)
    }
}

/// There is no such setting in a table.
fn unknown(table: &str, key: &Spanned<std::borrow::Cow<str>>, known: &[&'static str]) -> Fault {
    let name = key.get_ref().as_ref();
    let full = match table {
        "" => name.to_owned(),
        table => format!("{table}.{name}"),
    };
    let list: Vec<String> = known.iter().map(|k| format!("`{k}`")).collect();
    let list = Complaint::quoted(list.join(", "));
    let near = near(name, known).or_else(|| misplaced(name));
    (key.span().start, no_setting(&full, list, near))
}

fn no_setting(key: &str, known: Complaint, near: Option<String>) -> Complaint {
    let why = Complaint::new("setting-unknown")
        .with("key", quote(key))
        .with("known", known);
    with_near(why, near)
}

fn with_near(why: Complaint, near: Option<String>) -> Complaint {
    match near {
        None => why,
        Some(near) => Complaint::new("with-near")
            .with("what", why)
            .with("near", near),
    }
}

/// The whole name of a setting that belongs into another table.
fn misplaced(name: &str) -> Option<String> {
    let is_code = || Code::parse(name).is_some();
    match name {
        EXCLUDE => Some(EXCLUDE.to_owned()),
        _ if OF_FORMAT.contains(&name) => Some(format!("{FORMAT}.{name}")),
        _ if is_code() => Some(format!("{LINT}.{name}")),
        _ => None,
    }
}

/// The name that is spelt nearly so.
fn near(text: &str, names: &[&'static str]) -> Option<String> {
    let distance = |name: &str| match text.len() > 1 && name.starts_with(text) {
        true => 0,
        false => strsim::osa_distance(text, name),
    };
    let distances = names.iter().map(|n| (distance(n), *n));
    let (_, name) = distances.min().filter(|&(d, n)| d <= 1 + n.len() / 4)?;
    Some(name.to_owned())
}
