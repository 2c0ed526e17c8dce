//! `zpg.toml`: settings for the scenes in its folder and below. The nearest one upwards from a file
//! counts.
//!
//! ```toml
//! exclude = ["old", "exercises/*/draft.zpg"]   # files and folders that are left out
//!
//! [lint]
//! W310 = "off"                    # error, warning, note or off
//! colour-out-of-range = "error"
//! style = "off"                   # warnings, notes, style, or how codes begin: W3
//!
//! [lint.per-file-ignores]
//! "exercises/*" = ["W310", "style"]
//!
//! [format]
//! width = 100                     # where profiles wrap, how far alignment goes
//! align = true                    # numbers and comments under each other
//! group = true                    # vectors set off by double spaces
//! numbers = "shortest"            # or keep
//! ```

mod patterns;
#[cfg(test)]
mod tests;
mod written;

use std::collections::HashMap;
use std::fmt::Write;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};

use crate::diagnostics::{Code, Complaint, Severity};
use crate::format;
use crate::lint::levels::{Choice, Level, Levels, Selector};
use patterns::Pattern;
pub use patterns::whole;
use written::Written;

/// The name of the file with settings.
const NAME: &str = "zpg.toml";

/// The settings for the scenes of a folder.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Config {
    /// The file that the settings are from, if they are from one.
    pub path: Option<PathBuf>,
    levels: Levels,
    pub format: format::Options,
    exclude: Vec<Pattern>,
    per_file_ignores: Vec<(Pattern, Vec<Selector>)>,
    /// The highest folder that is matched with patterns.
    root: PathBuf,
}

/// An error in a file of settings, or in settings of the command line.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ConfigError {
    pub path: PathBuf,
    /// All mistakes of the file.
    mistakes: Vec<Mistake>,
}

/// A fault of a file of settings, and its line and column, both from 1 on. There is no place if the file cannot be
/// read.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Mistake {
    place: Option<(usize, usize)>,
    why: Complaint,
}

impl From<Complaint> for Mistake {
    fn from(why: Complaint) -> Mistake {
        Mistake { place: None, why }
    }
}

impl ConfigError {
    /// The message about the error.
    pub fn complaint(self) -> Complaint {
        let here = whole(Path::new("."));
        let path = self.path.strip_prefix(here).unwrap_or(&self.path);
        let each = self.mistakes.into_iter().map(|mistake| {
            let Some((line, column)) = mistake.place else {
                let unread = Complaint::new("cannot-read").with("path", path);
                return unread.with("reason", mistake.why);
            };
            Complaint::new("in-file")
                .with("path", path)
                .with("line", line.to_string())
                .with("column", column.to_string())
                .with("why", mistake.why)
        });
        Complaint::several(each).unwrap_or_default()
    }
}

impl Config {
    /// The settings of a file, overridden by those of `over`.
    fn new(path: Option<PathBuf>, root: PathBuf, file: &Written, over: &[Written]) -> Config {
        let mut config = Config {
            path,
            root,
            ..Config::default()
        };
        for written in std::iter::once(file).chain(over) {
            config.take(written);
        }
        config
    }

    fn take(&mut self, written: &Written) {
        let mut chosen = written.levels.clone();
        // Settings for many codes are applied before settings for few, so that what is said of a single code counts
        // more.
        chosen.sort_by_key(|(codes, _)| std::cmp::Reverse(codes.breadth()));
        for (codes, level) in &chosen {
            self.levels.set(codes, *level);
        }
        if let Some(exclude) = &written.exclude {
            self.exclude.clone_from(exclude);
        }
        if let Some(ignores) = &written.per_file_ignores {
            self.per_file_ignores.clone_from(ignores);
        }
        let format = &mut self.format;
        format.width = written.width.unwrap_or(format.width);
        format.align = written.align.unwrap_or(format.align);
        format.group = written.group.unwrap_or(format.group);
        format.numbers = written.numbers.unwrap_or(format.numbers);
    }

    /// The levels of findings in a file.
    pub fn levels(&self, file: &Path) -> Levels {
        let file = whole(file);
        let mut levels = self.levels.clone();
        let fitting = (self.per_file_ignores.iter()).filter(|(p, _)| p.matches(&file));
        for codes in fitting.flat_map(|(_, codes)| codes) {
            levels.ignore(codes);
        }
        levels
    }

    /// Whether a file or folder that is found in a folder is left out.
    pub fn excludes(&self, path: &Path) -> bool {
        let path = whole(path);
        self.exclude.iter().any(|p| p.matches(&path))
    }

    /// Whether a file, or a folder that contains it, is left out.
    pub fn excludes_file(&self, file: &Path) -> bool {
        let file = whole(file);
        let below = |path: &&Path| path.starts_with(&self.root);
        let mut paths = file.ancestors().take_while(below);
        !self.exclude.is_empty() && paths.any(|path| self.excludes(path))
    }

    /// The settings for a file as the text of a `zpg.toml`, with the level of each code.
    pub fn show(&self, file: &Path, choice: &Choice) -> String {
        let mut out = String::new();
        let list = |texts: &mut dyn Iterator<Item = String>| texts.collect::<Vec<_>>().join(", ");
        let excluded = list(&mut self.exclude.iter().map(|p| quoted(&p.written)));
        // Writing to a string cannot fail.
        let _ = writeln!(out, "exclude = [{excluded}]\n\n[lint]");
        let levels = self.levels(file);
        for &code in Code::ALL.iter().filter(|c| !c.is_never_allowed()) {
            let severity = match code {
                // The finding is a warning as long as nothing is to be drawn.
                Code::E106 => Severity::Warning,
                _ => code.severity(),
            };
            let level = levels.of(choice, code).or(Level::of(severity));
            let (mark, level) = match level {
                Some(level) => ("", level.as_str()),
                // `style` is not one of the levels that can be set, so the line is a comment.
                None => ("# ", code.severity().as_str()),
            };
            let (code, name) = (code.as_str(), code.name());
            let _ = writeln!(out, "{mark}{code} = \"{level}\"  # {name}");
        }
        out.push_str("\n[lint.per-file-ignores]\n");
        for (pattern, codes) in &self.per_file_ignores {
            let codes = codes.iter().flat_map(Selector::codes);
            let codes = list(&mut codes.map(|c| quoted(c.as_str())));
            let _ = writeln!(out, "{} = [{codes}]", quoted(&pattern.written));
        }
        let format::Options {
            width,
            align,
            group,
            numbers,
        } = self.format;
        let numbers = match numbers {
            format::Numbers::Shortest => "shortest",
            format::Numbers::Keep => "keep",
        };
        let _ = writeln!(
            out,
            "\n[format]\nwidth = {width}\nalign = {align}\ngroup = {group}\nnumbers = \"{numbers}\""
        );
        out
    }
}

/// Writes a text as a TOML string.
fn quoted(text: &str) -> String {
    // JSON escapes all characters that TOML escapes but one.
    let json = serde_json::Value::from(text).to_string();
    json.replace('\u{7f}', "\\u007f")
}

/// The settings of many files, each `zpg.toml` read once.
#[derive(Debug, Default)]
pub struct Configs {
    /// The settings of the command line, which override those of files.
    over: Vec<Written>,
    only: Option<Arc<Config>>,
    found: Mutex<HashMap<PathBuf, ConfigResult>>,
}

type ConfigResult = Result<Arc<Config>, ConfigError>;

impl Configs {
    /// The settings of a command line: `arguments` are files of settings and single settings, in any order; `exclude`
    /// are patterns of files that are left out. If `isolated`, no `zpg.toml` counts.
    ///
    /// # Errors
    ///
    /// A setting or a pattern is wrong, or two files of settings are given.
    pub fn chosen(
        arguments: &[String],
        exclude: &[String],
        isolated: bool,
    ) -> Result<Configs, Complaint> {
        let here = whole(Path::new("."));
        let (mut file, mut over) = (None, Vec::new());
        for argument in arguments {
            let path = Path::new(argument);
            if !path.is_file() {
                over.push(setting(argument, &here)?);
            } else if isolated {
                return Err(Complaint::new("config-isolated").with("path", path));
            } else if let Some(first) = file.replace(path) {
                return Err(Complaint::new("config-two-files")
                    .with("first", first)
                    .with("second", path));
            }
        }
        if !exclude.is_empty() {
            let patterns = exclude.iter().map(|text| Pattern::new(text, &here));
            over.push(Written {
                exclude: Some(patterns.collect::<Result<_, _>>()?),
                ..Written::default()
            });
        }
        // Patterns in a file of settings that the command line names are about the folder where the command runs.
        let only = match file {
            Some(path) => {
                let written = read(path, &here).map_err(|mistakes| {
                    let path = path.to_owned();
                    ConfigError { path, mistakes }.complaint()
                })?;
                let path = Some(whole(path));
                Some(Config::new(path, here, &written, &over))
            }
            None if isolated => Some(Config::new(None, here, &Written::default(), &over)),
            None => None,
        };
        Ok(Configs {
            over,
            only: only.map(Arc::new),
            found: Mutex::default(),
        })
    }

    /// The settings for a file, which need not exist.
    ///
    /// # Errors
    ///
    /// The nearest `zpg.toml` cannot be read or understood.
    pub fn for_file(&self, file: &Path) -> ConfigResult {
        if let Some(only) = &self.only {
            return Ok(only.clone());
        }
        let path = whole(file);
        let Some(folder) = path.parent() else {
            return Ok(Arc::default());
        };
        let mut known = self.found.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(found) = known.get(folder) {
            return found.clone();
        }
        let found = self.nearest(folder);
        known.insert(folder.to_owned(), found.clone());
        found
    }

    fn nearest(&self, folder: &Path) -> ConfigResult {
        let config = |path, root, written: &Written| {
            let config = Config::new(path, root, written, &self.over);
            Ok(Arc::new(config))
        };
        for folder in folder.ancestors() {
            let path = folder.join(NAME);
            if path.symlink_metadata().is_err_and(|e| is_absence(&e)) {
                continue;
            }
            return match read(&path, folder) {
                Ok(written) => config(Some(path), folder.to_owned(), &written),
                Err(mistakes) => Err(ConfigError { path, mistakes }),
            };
        }
        config(None, whole(Path::new(".")), &Written::default())
    }
}

fn is_absence(error: &std::io::Error) -> bool {
    matches!(error.kind(), ErrorKind::NotFound | ErrorKind::NotADirectory)
}

/// Reads the settings in a file. Its patterns are about the folder `root`.
fn read(path: &Path, root: &Path) -> Result<Written, Vec<Mistake>> {
    let unreadable = |e: std::io::Error| vec![Mistake::from(Complaint::from(&e))];
    let found = std::fs::metadata(path).map_err(unreadable)?;
    if !found.is_file() {
        // Reading a pipe, for instance, may never end.
        return Err(vec![Complaint::new("not-a-file").into()]);
    }
    let text = std::fs::read_to_string(path).map_err(unreadable)?;
    parse(&text, root)
}

fn parse(text: &str, root: &Path) -> Result<Written, Vec<Mistake>> {
    Written::read(text, root).map_err(|faults| {
        let mistakes = faults.into_iter().map(|(at, why)| {
            let before = text.get(..at).unwrap_or(text);
            let line = before.rsplit('\n').next().unwrap_or_default();
            let place = (before.matches('\n').count() + 1, line.chars().count() + 1);
            let place = Some(place);
            Mistake { place, why }
        });
        mistakes.collect()
    })
}

/// Parses one setting of the command line.
fn setting(text: &str, root: &Path) -> Result<Written, Complaint> {
    if !text.contains('=') {
        return Err(Complaint::new("config-neither").with("path", Path::new(text)));
    }
    // The shell removes quotation marks, so a text may lack them: `lint.W310=off`.
    let with_marks = written::bare(text).map(|(key, word)| format!("{key}={}", quoted(word)));
    let read = Written::read(with_marks.as_deref().unwrap_or(text), root);
    read.map_err(|faults| {
        let why = faults.into_iter().next().map(|fault| fault.1);
        Complaint::new("config-setting")
            .with("text", crate::syntax::quote(text))
            .with("why", why.unwrap_or_default())
    })
}
