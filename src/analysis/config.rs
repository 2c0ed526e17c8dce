//! `zpg.toml`: settings for the scenes in its folder and below. The nearest one upwards from a file
//! counts.
//!
//! ```toml
//! [lint]
//! W310 = "off"                    # error, warning, note or off
//! colour-out-of-range = "error"
//! style = "off"                   # warnings, notes, style, or how codes begin: W3
//!
//! [format]
//! width = 100                     # where profiles wrap, how far alignment goes
//! align = true                    # numbers and comments under each other
//! group = true                    # vectors set off by double spaces
//! numbers = "shortest"            # or keep
//! ```

use std::collections::{BTreeMap, HashMap};
use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};

use serde::Deserialize;
use toml::Spanned;

use crate::diagnostics::Complaint;
use crate::format;
use crate::lint::levels::{Level, Levels, Selector, UnknownCode};

/// What the file is called.
const NAME: &str = "zpg.toml";

/// The settings for a scene.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Config {
    pub levels: Levels,
    pub format: format::Options,
}

/// Why a file of settings cannot be used.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ConfigError {
    pub path: PathBuf,
    pub reason: Complaint,
}

impl ConfigError {
    /// What to say about it.
    pub fn complaint(self) -> Complaint {
        Complaint::new("cannot-read")
            .with("path", self.path.as_path())
            .with("reason", self.reason)
    }
}

/// The file as it is written.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Written {
    #[serde(default)]
    lint: BTreeMap<Spanned<String>, Level>,
    #[serde(default)]
    format: format::Options,
}

impl Config {
    /// Reads settings.
    ///
    /// # Errors
    ///
    /// What is wrong with the text, and in which line.
    pub fn parse(text: &str) -> Result<Config, Complaint> {
        let written: Written = toml::from_str(text).map_err(Complaint::quoted)?;
        let mut chosen: Vec<(Selector, Level)> = Vec::new();
        for (name, level) in written.lint {
            let line = text[..name.span().start].matches('\n').count() + 1;
            let in_line = |why: Complaint| {
                Complaint::new("in-line")
                    .with("line", line.to_string())
                    .with("why", why)
            };
            let codes: Selector =
                (name.as_ref().parse()).map_err(|e: UnknownCode| in_line(e.complaint()))?;
            if let Some(code) = codes.fixed_error().filter(|_| level != Level::Error) {
                let why = Complaint::new("always-error").with("code", code.as_str());
                return Err(in_line(why));
            }
            chosen.push((codes, level));
        }
        // The more it selects, the earlier: what is said of one code counts more.
        chosen.sort_by_key(|(codes, _)| std::cmp::Reverse(codes.breadth()));
        let mut levels = Levels::default();
        for (codes, level) in &chosen {
            levels.set(codes, *level);
        }
        Ok(Config {
            levels,
            format: written.format,
        })
    }
}

/// The settings of many files, each `zpg.toml` read once.
#[derive(Debug, Default)]
pub struct Configs(Mutex<HashMap<PathBuf, Found>>);

type Found = Result<Arc<Config>, ConfigError>;

impl Configs {
    /// The settings for a file, which need not exist.
    ///
    /// # Errors
    ///
    /// The nearest `zpg.toml` cannot be read or understood.
    pub fn for_file(&self, file: &Path) -> Found {
        let path = std::path::absolute(file).unwrap_or_else(|_| file.to_owned());
        let Some(folder) = path.parent() else {
            return Ok(Arc::default());
        };
        let mut known = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(found) = known.get(folder) {
            return found.clone();
        }
        let found = nearest(folder);
        known.insert(folder.to_owned(), found.clone());
        found
    }
}

fn nearest(folder: &Path) -> Found {
    for folder in folder.ancestors() {
        let path = folder.join(NAME);
        match std::fs::read_to_string(&path) {
            Ok(text) => {
                return match Config::parse(&text) {
                    Ok(config) => Ok(Arc::new(config)),
                    Err(reason) => Err(ConfigError { path, reason }),
                };
            }
            Err(e) if matches!(e.kind(), ErrorKind::NotFound | ErrorKind::NotADirectory) => {}
            Err(e) => {
                let reason = Complaint::from(&e);
                return Err(ConfigError { path, reason });
            }
        }
    }
    Ok(Arc::default())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnostics::{Code, Diagnostic, Language, Severity, Span};
    use crate::lint::levels::Choice;

    fn severity(config: &Config, code: Code) -> Option<Severity> {
        let mut all = vec![Diagnostic::new(code, Span::default())];
        config.levels.apply(&Choice::default(), &mut all);
        all.pop().map(|d| d.severity)
    }

    #[test]
    fn one_code_counts_more_than_many() {
        let config =
            Config::parse("[lint]\nW302 = \"note\"\nW = \"off\"\nall = \"error\"\n").unwrap();
        assert_eq!(severity(&config, Code::W302), Some(Severity::Note));
        assert_eq!(severity(&config, Code::W303), None);
        assert_eq!(severity(&config, Code::S502), Some(Severity::Error));
    }

    #[test]
    fn mistakes_name_their_line() {
        let says = |text: &str| Config::parse(text).unwrap_err().wording(Language::English);
        assert!(says("\n[lint]\nW399 = \"off\"\n").starts_with("line 3: there is no code"));
        assert_eq!(
            says("[lint]\nE101 = \"off\"\n"),
            "line 2: E101 is always an error"
        );
        assert!(says("[lint]\nW302 = \"loud\"\n").contains("line 2"));
        for level in ["3", "\"loud\"", "true"] {
            let said = says(&format!("[lint]\nW302 = {level}\n"));
            let named = "expected one of `error`, `warning`, `note`, `off`";
            assert!(said.contains(named) && said.contains("line 2"), "{said}");
        }
        assert!(says("[lints]\n").contains("unknown field `lints`"));
        for (line, reason) in [
            ("widht = 80", "unknown field `widht`"),
            ("width = 5", "a width is from 20 to 1000"),
            ("width = \"80\"", "invalid type"),
            ("align = 1", "invalid type"),
            ("numbers = \"long\"", "unknown variant `long`"),
        ] {
            let said = says(&format!("[lint]\n[format]\n{line}\n"));
            assert!(said.contains("line 3") && said.contains(reason), "{said}");
        }
        assert!(says("[lint\n").contains("line 1"));
        assert_eq!(Config::parse("").unwrap(), Config::default());
    }

    #[test]
    fn the_style_of_the_formatter() {
        let text = "[format]\nwidth = 80\nalign = false\ngroup = false\nnumbers = \"keep\"\n";
        let style = format::Options {
            width: 80,
            align: false,
            group: false,
            numbers: format::Numbers::Keep,
        };
        assert_eq!(Config::parse(text).unwrap().format, style);
        let part = Config::parse("[format]\nwidth = 80\n").unwrap().format;
        let rest = format::Options::default();
        assert_eq!(part, format::Options { width: 80, ..rest });
    }

    #[test]
    fn the_nearest_file_counts() {
        let dir = tempfile::tempdir().unwrap();
        let at = |name: &str| dir.path().join(name);
        std::fs::create_dir_all(at("a/b")).unwrap();
        std::fs::write(at(NAME), "[lint]\nW302 = \"off\"\n").unwrap();
        std::fs::write(at("a/zpg.toml"), "[lint]\nW303 = \"off\"\n").unwrap();
        let configs = Configs::default();
        let off = |file: &str, code| {
            let config = configs.for_file(&at(file)).unwrap();
            severity(&config, code).is_none()
        };
        assert!(off("x.zpg", Code::W302) && !off("x.zpg", Code::W303));
        assert!(off("a/b/x.zpg", Code::W303) && !off("a/b/x.zpg", Code::W302));
        std::fs::write(at("a/b/zpg.toml"), "lint = 1\n").unwrap();
        let error = Configs::default().for_file(&at("a/b/x.zpg")).unwrap_err();
        assert_eq!(error.path, at("a/b/zpg.toml"));
    }
}
