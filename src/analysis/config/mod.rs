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

/// What the file is called.
const NAME: &str = "zpg.toml";

/// The settings for the scenes of a folder.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Config {
    /// The file that they are from, if they are from one.
    pub path: Option<PathBuf>,
    levels: Levels,
    pub format: format::Options,
    exclude: Vec<Pattern>,
    per_file_ignores: Vec<(Pattern, Vec<Selector>)>,
    /// No pattern is held against folders above this one.
    root: PathBuf,
}

/// Why settings cannot be used.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ConfigError {
    pub path: PathBuf,
    /// All that is wrong.
    mistakes: Vec<Mistake>,
}

/// What is wrong with a file of settings, and in which line and column, both from 1 on.
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
    /// What to say about it.
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
    /// Settings, and others that count more.
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
        // The more it selects, the earlier: what is said of one code counts more.
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

    /// How much findings in a file weigh.
    pub fn levels(&self, file: &Path) -> Levels {
        let file = whole(file);
        let mut levels = self.levels.clone();
        let fitting = (self.per_file_ignores.iter()).filter(|(p, _)| p.matches(&file));
        for codes in fitting.flat_map(|(_, codes)| codes) {
            levels.ignore(codes);
        }
        levels
    }

    /// Whether a file or a folder that is come across is left out.
    pub fn excludes(&self, path: &Path) -> bool {
        let path = whole(path);
        self.exclude.iter().any(|p| p.matches(&path))
    }

    /// Whether a file is left out, itself or with a folder that it is in.
    pub fn excludes_file(&self, file: &Path) -> bool {
        let file = whole(file);
        let below = |path: &&Path| path.starts_with(&self.root);
        let mut paths = file.ancestors().take_while(below);
        !self.exclude.is_empty() && paths.any(|path| self.excludes(path))
    }

    /// The settings for a file as a text that could be its `zpg.toml`, with the weight of each code.
    pub fn show(&self, file: &Path, choice: &Choice) -> String {
        let mut out = String::new();
        let list = |texts: &mut dyn Iterator<Item = String>| texts.collect::<Vec<_>>().join(", ");
        let excluded = list(&mut self.exclude.iter().map(|p| quoted(&p.written)));
        // Writing to a string cannot fail.
        let _ = writeln!(out, "exclude = [{excluded}]\n\n[lint]");
        let levels = self.levels(file);
        for &code in Code::ALL.iter().filter(|c| !c.is_never_allowed()) {
            let severity = match code {
                // As long as nothing is to be drawn.
                Code::E106 => Severity::Warning,
                _ => code.severity(),
            };
            let level = levels.of(choice, code).or(Level::of(severity));
            let (mark, level) = match level {
                Some(level) => ("", level.as_str()),
                // A remark on style is none of the levels that can be chosen.
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

/// A text of TOML.
fn quoted(text: &str) -> String {
    // JSON escapes all that TOML does but one character.
    let json = serde_json::Value::from(text).to_string();
    json.replace('\u{7f}', "\\u007f")
}

/// The settings of many files, each `zpg.toml` read once.
#[derive(Debug, Default)]
pub struct Configs {
    /// What is said on the command line counts more than any file.
    over: Vec<Written>,
    only: Option<Arc<Config>>,
    found: Mutex<HashMap<PathBuf, Found>>,
}

type Found = Result<Arc<Config>, ConfigError>;

impl Configs {
    /// Settings with those of a command line: files of settings and single settings, in any order, and patterns
    /// of what is left out. `isolated`: no `zpg.toml` counts.
    ///
    /// # Errors
    ///
    /// What is wrong with them.
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
        // Patterns in a file that is named are about the folder where the command runs.
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
    pub fn for_file(&self, file: &Path) -> Found {
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

    fn nearest(&self, folder: &Path) -> Found {
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

/// The settings in a file, whose patterns are about a folder.
fn read(path: &Path, root: &Path) -> Result<Written, Vec<Mistake>> {
    let unreadable = |e: std::io::Error| vec![Mistake::from(Complaint::from(&e))];
    let found = std::fs::metadata(path).map_err(unreadable)?;
    if !found.is_file() {
        // From a pipe, for instance, nobody knows whether anything comes.
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

/// One setting of the command line.
fn setting(text: &str, root: &Path) -> Result<Written, Complaint> {
    if !text.contains('=') {
        return Err(Complaint::new("config-neither").with("path", Path::new(text)));
    }
    Written::read(text, root).map_err(|faults| {
        let why = faults.into_iter().next().map(|fault| fault.1);
        let why = Complaint::new("config-setting")
            .with("text", crate::syntax::quote(text))
            .with("why", why.unwrap_or_default());
        // Whoever writes `lint.W310=off` has forgotten the quotation marks, or the shell took them.
        let with_marks = text.split_once('=').map(|(key, value)| {
            let value = quoted(value.trim().trim_matches(['"', '\'']));
            format!("{}={value}", key.trim())
        });
        why.or_meant(with_marks.filter(|text| Written::read(text, root).is_ok()))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnostics::{Diagnostic, Language, Severity, Span};

    fn of(text: &str) -> Result<Config, Complaint> {
        let root = Path::new("/scenes");
        let written = parse(text, root).map_err(|mistakes| {
            let path = NAME.into();
            ConfigError { path, mistakes }.complaint()
        })?;
        Ok(Config::new(None, root.to_owned(), &written, &[]))
    }

    fn severity(config: &Config, code: Code) -> Option<Severity> {
        let mut all = vec![Diagnostic::new(code, Span::default())];
        let levels = config.levels(Path::new("/scenes/a.zpg"));
        levels.apply(&Choice::default(), &mut all);
        all.pop().map(|d| d.severity)
    }

    #[test]
    fn one_code_counts_more_than_many() {
        let config = of("[lint]\nW302 = \"note\"\nW = \"off\"\nall = \"error\"\n").unwrap();
        assert_eq!(severity(&config, Code::W302), Some(Severity::Note));
        assert_eq!(severity(&config, Code::W303), None);
        assert_eq!(severity(&config, Code::S502), Some(Severity::Error));
    }

    #[test]
    fn mistakes_name_their_line() {
        let says = |text: &str| of(text).unwrap_err().wording(Language::English);
        assert_eq!(
            says("\n[lint]\nW399 = \"off\"\n"),
            "zpg.toml:3:1: there is no code `W399`; did you mean `W309`?"
        );
        assert_eq!(
            says("[lint]\nE101 = \"off\"\n"),
            "zpg.toml:2:1: E101 is always an error"
        );
        assert!(says("[lint]\nW302 = \"loud\"\n").contains("zpg.toml:2:"));
        for level in ["3", "\"loud\"", "true"] {
            let said = says(&format!("[lint]\nW302 = {level}\n"));
            let named = "expected one of `error`, `warning`, `note`, `off`";
            assert!(
                said.contains(named) && said.contains("zpg.toml:2:8: "),
                "{said}"
            );
        }
        assert_eq!(
            says("[lints]\n"),
            "zpg.toml:1:2: there is no setting `lints`, only `exclude`, `format`, `lint`, \
             `per-file-ignores`; did you mean `lint`?"
        );
        assert!(says("width = 80\n").ends_with("did you mean `format.width`?"));
        assert!(says("W310 = \"off\"\n").ends_with("did you mean `lint.W310`?"));
        assert!(says("[lint]\nwidth = 80\n").ends_with("did you mean `format.width`?"));
        assert!(says("[lint]\nper-file-ignore = 1\n").ends_with("`per-file-ignores`?"));
        assert!(says("[lint]\nW302 = \"warn\"\n").ends_with("did you mean `warning`?"));
        for (line, reason) in [
            (
                "exclude = \"old\"",
                "a list of patterns of files, such as [\"old\", \"*/draft.zpg\"], found `\"old\"`",
            ),
            (
                "exclude = [1]",
                "a list of patterns of files, such as [\"old\", \"*/draft.zpg\"], found `1`",
            ),
            ("exclude = [\"a[\"]", "`a[` is no pattern of files"),
            ("lint = 1", "`lint`: expected a table, found `1`"),
            ("lint.per-file-ignores = [1]", "expected a table"),
            (
                "lint.per-file-ignores = {\"*\" = \"W3\"}",
                "`lint.per-file-ignores.\"*\"`: expected a list of codes",
            ),
            (
                "lint.per-file-ignores = {\"*\" = [\"W399\"]}",
                "no code `W399`",
            ),
            (
                "lint.per-file-ignores = {\"*\" = [\"E101\"]}",
                "E101 is always an error",
            ),
        ] {
            let said = says(&format!("\n{line}\n"));
            assert!(
                said.starts_with("zpg.toml:2:") && said.contains(reason),
                "{said}"
            );
        }
        for (line, reason) in [
            (
                "widht = 80",
                "no setting `format.widht`, only `align`, `group`, `numbers`, `width`; did you mean `width`?",
            ),
            (
                "width = 5",
                "`format.width`: expected a whole number (a width is from 20 to 1000), found `5`",
            ),
            (
                "width = \"80\"",
                "expected a whole number (a width is from 20 to 1000)",
            ),
            (
                "width = -80",
                "expected a whole number (a width is from 20 to 1000)",
            ),
            (
                "align = 1",
                "`format.align`: expected true or false, found `1`",
            ),
            (
                "numbers = \"long\"",
                "`format.numbers`: expected \"shortest\" or \"keep\", found `\"long\"`",
            ),
        ] {
            let said = says(&format!("[lint]\n[format]\n{line}\n"));
            assert!(
                said.starts_with("zpg.toml:3:") && said.contains(reason),
                "{said}"
            );
        }
        assert!(says("[lint\n").starts_with("zpg.toml:1:"));
        let none = Config {
            root: "/scenes".into(),
            ..Config::default()
        };
        assert_eq!(of("").unwrap(), none);
    }

    #[test]
    fn all_mistakes_are_said_at_once() {
        let text = "[lint]\nstyl = \"off\"\nW999 = \"off\"\nW302 = \"of\"\n\n[format]\n\
                    widht = 100\nalign = 3\n[lint.per-file-ignores]\n\"a\" = [\"W302\", \"notse\", 3]\n";
        let said = of(text).unwrap_err().wording(Language::English);
        let said: Vec<&str> = said.lines().collect();
        let near = [
            ("zpg.toml:2:1: ", "did you mean `style`?"),
            (
                "zpg.toml:3:1: ",
                "there is no code `W999` (`zpg explain` lists all)",
            ),
            ("zpg.toml:4:8: ", "did you mean `off`?"),
            ("zpg.toml:10:16: ", "did you mean `notes`?"),
            ("zpg.toml:10:25: ", "found `3`"),
            ("zpg.toml:7:1: ", "did you mean `width`?"),
            ("zpg.toml:8:9: ", "expected true or false, found `3`"),
        ];
        assert_eq!(said.len(), near.len(), "{said:?}");
        for (place, end) in near {
            let is_it = |line: &&&str| line.starts_with(place) && line.ends_with(end);
            assert_eq!(said.iter().filter(is_it).count(), 1, "{place} {said:?}");
        }
        // Where it is no TOML, too.
        let said = of("a = \n\nb = = 1\n")
            .unwrap_err()
            .wording(Language::English);
        let lines = ["zpg.toml:1:", "zpg.toml:3:"];
        assert!(lines.iter().all(|line| said.contains(line)), "{said}");
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
        assert_eq!(of(text).unwrap().format, style);
        let part = of("[format]\nwidth = 80\n").unwrap().format;
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

    #[test]
    fn what_is_shown_is_read_as_the_same() {
        let text = "exclude = [\"a\\\\b\", \"c/*\"]\n[lint]\nW3 = \"note\"\nW302 = \"off\"\nS501 = \"error\"\n\
                    [lint.per-file-ignores]\n\"!x*\" = [\"W303\", \"style\"]\n\
                    [format]\nwidth = 80\nnumbers = \"keep\"\n";
        let config = of(text).unwrap();
        // The pattern is of all files but those that begin with x.
        let file = Path::new("/scenes/x.zpg");
        let shown = config.show(file, &Choice::default());
        let again = of(&shown).unwrap();
        assert_eq!(again.show(file, &Choice::default()), shown);
        let same = |c: &Config| (c.exclude.clone(), c.format, c.per_file_ignores.len());
        assert_eq!(same(&again), same(&config));
        for &code in Code::ALL {
            assert_eq!(severity(&again, code), severity(&config, code), "{code:?}");
        }
    }

    #[test]
    fn files_have_codes_of_their_own_that_are_ignored() {
        let text = "[lint]\nW302 = \"error\"\n[lint.per-file-ignores]\n\"old/*\" = [\"W3\"]\n\"!a.zpg\" = [\"S\"]\n";
        let config = of(text).unwrap();
        let is_on = |file: &str, code| {
            let select = Choice {
                select: vec!["W".parse().unwrap(), "S".parse().unwrap()],
                deny: vec!["W302".parse().unwrap()],
                ..Choice::default()
            };
            let levels = config.levels(Path::new(file));
            assert_eq!(
                levels.is_on(&select, code),
                levels.is_on(&Choice::default(), code)
            );
            levels.is_on(&select, code)
        };
        assert!(is_on("/scenes/a.zpg", Code::W302) && is_on("/scenes/a.zpg", Code::S501));
        assert!(!is_on("/scenes/old/a.zpg", Code::W302) && is_on("/scenes/old/a.zpg", Code::S501));
        assert!(is_on("/scenes/b.zpg", Code::W302) && !is_on("/scenes/b.zpg", Code::S501));
    }

    #[test]
    fn what_is_left_out() {
        let config = of("exclude = [\"old\", \"a/*.zpg\"]\n").unwrap();
        let out = |file: &str| config.excludes_file(Path::new(file));
        assert!(out("/scenes/b/old/c/x.zpg") && out("/scenes/a/x.zpg") && out("/scenes/old"));
        assert!(!out("/scenes/x.zpg") && !out("/old/x.zpg") && !out("/scenes/older/x.zpg"));
        assert!(config.excludes(Path::new("/scenes/b/old")));
        assert!(!config.excludes(Path::new("/scenes/b/old/x.zpg")));
    }

    #[test]
    fn settings_of_the_command_line() {
        let says = |text: &str| {
            let found = Configs::chosen(&[text.to_owned()], &[], false);
            found.unwrap_err().wording(Language::English)
        };
        assert_eq!(
            says("none.toml"),
            "--config: there is no file none.toml, and a setting is written as in lint.W310=\"off\""
        );
        assert!(says("lint.W310=off").ends_with("did you mean `lint.W310=\"off\"`?"));
        assert!(says("lint.W310=\"of\"").ends_with("did you mean `off`?"));
        assert!(says("format.widht=80").ends_with("did you mean `width`?"));
        assert!(
            says("format.width=8")
                .starts_with("--config `format.width=8`: `format.width`: expected")
        );
        let chosen = [
            "lint.W3=\"off\"",
            "lint.W302=\"error\"",
            "lint.W303=\"note\"",
        ]
        .map(String::from);
        let config = Configs::chosen(&chosen, &[], true).unwrap();
        let config = config.for_file(Path::new("a.zpg")).unwrap();
        assert_eq!(severity(&config, Code::W302), Some(Severity::Error));
        assert_eq!(severity(&config, Code::W303), Some(Severity::Note));
        assert_eq!(severity(&config, Code::W304), None);
    }
}
