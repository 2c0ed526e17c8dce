//! The language of messages: the one that `--lang` asks for, or that of the environment.

use std::ffi::{OsStr, OsString};

use crate::diagnostics::Language;

/// The values of `--lang`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum LanguageChoice {
    /// English
    En,
    /// Czech
    Cs,
}

impl From<LanguageChoice> for Language {
    fn from(choice: LanguageChoice) -> Language {
        match choice {
            LanguageChoice::En => Language::English,
            LanguageChoice::Cs => Language::Czech,
        }
    }
}

/// The environment variables that name the language of messages; the first one that is not empty counts.
const VARIABLES: [&str; 3] = ["LC_ALL", "LC_MESSAGES", "LANG"];

/// The language of the environment.
pub(super) fn of_environment() -> Language {
    chosen(|name| std::env::var_os(name))
}

fn chosen(variable: impl Fn(&str) -> Option<OsString>) -> Language {
    let says = |name: &&str| variable(name).filter(|value| !value.is_empty());
    match VARIABLES.iter().find_map(says) {
        Some(locale) if is_czech(&locale) => Language::Czech,
        _ => Language::English,
    }
}

/// Whether a locale is Czech: `cs`, `cs_CZ.UTF-8`, `cs@latin`, or the old name `czech`.
fn is_czech(locale: &OsStr) -> bool {
    let locale = locale.to_string_lossy().to_ascii_lowercase();
    let language = locale.split(['_', '-', '.', '@']).next();
    matches!(language, Some("cs" | "czech"))
}

/// Finds the value of `--lang` among arguments that clap could not parse. The last one counts; `None` if there is none,
/// or if it is no known language.
pub(super) fn among(args: impl Iterator<Item = OsString>) -> Option<LanguageChoice> {
    let args: Vec<_> = args.map(|a| a.to_string_lossy().into_owned()).collect();
    let options = args.iter().take_while(|a| *a != "--").enumerate();
    let values = options.filter_map(|(i, arg)| match arg.strip_prefix("--lang")? {
        "" => args.get(i + 1).map(String::as_str),
        value => value.strip_prefix('='),
    });
    match values.last()? {
        "cs" => Some(LanguageChoice::Cs),
        "en" => Some(LanguageChoice::En),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_variable_that_says_something_counts() {
        let of = |all: &[(&str, &str)]| {
            chosen(|name| {
                let found = all.iter().find(|(n, _)| *n == name);
                found.map(|(_, value)| OsString::from(value))
            })
        };
        assert_eq!(of(&[]), Language::English);
        assert_eq!(of(&[("LANG", "cs_CZ.UTF-8")]), Language::Czech);
        assert_eq!(of(&[("LC_ALL", ""), ("LANG", "cs")]), Language::Czech);
        let both = [("LC_MESSAGES", "en_US.UTF-8"), ("LANG", "cs_CZ.UTF-8")];
        assert_eq!(of(&both), Language::English);
        let both = [("LC_ALL", "C"), ("LC_MESSAGES", "cs_CZ")];
        assert_eq!(of(&both), Language::English);
    }

    #[test]
    fn names_of_czech() {
        for name in [
            "cs",
            "cs_CZ",
            "cs_CZ.UTF-8",
            "cs.ISO8859-2",
            "cs@x",
            "czech",
            "CS-cz",
        ] {
            assert!(is_czech(OsStr::new(name)), "{name}");
        }
        for name in ["C", "POSIX", "en_US", "csb_PL", "sk_SK", "de"] {
            assert!(!is_czech(OsStr::new(name)), "{name}");
        }
    }

    #[test]
    fn among_arguments_that_cannot_be_read() {
        let of = |line: &str| among(line.split(' ').map(OsString::from));
        assert_eq!(of("zpg --lang cs chek"), Some(LanguageChoice::Cs));
        assert_eq!(of("zpg chek --lang=en"), Some(LanguageChoice::En));
        assert_eq!(of("zpg chek --lang de"), None);
        assert_eq!(of("zpg chek --lang"), None);
        assert_eq!(of("zpg chek -- --lang cs"), None);
        assert_eq!(of("zpg chek"), None);
    }
}
