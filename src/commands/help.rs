//! `--help` in other languages than English.
//!
//! English stands with the commands, in the comments that clap reads. Other languages have catalogues:
//! `help-render` is the command, `help-render-size` its argument, or `help-any-size` where all commands have
//! the same. `.value` is the name of the value, another attribute one of the possible values, `.after` the text
//! at the end. Words that clap has in English alone are replaced when all is laid out.

use clap::builder::{PossibleValue, PossibleValuesParser};
use clap::{Arg, Command};

use crate::diagnostics::Language;
use crate::diagnostics::layout::{hanging, paragraphs};

/// The words that clap has in English alone, each with the message that translates it. A text that holds another one
/// stands before it.
const WORDS: [(&str, &str); 15] = [
    ("Usage:", "help-word-usage"),
    ("Commands:", "help-word-commands"),
    ("Arguments:", "help-word-arguments"),
    ("Options:", "help-word-options"),
    ("[OPTIONS]", "help-word-any-options"),
    ("[COMMAND]", "help-word-any-command"),
    ("<COMMAND>", "help-word-command"),
    ("[default:", "help-word-default"),
    ("[possible values:", "help-word-values"),
    (
        "Print this message or the help of the given subcommand(s)",
        "help-word-help-command",
    ),
    (
        "Print help for the subcommand(s)",
        "help-word-help-of-commands",
    ),
    ("Print help (see more with '--help')", "help-word-help-more"),
    (
        "Print help (see a summary with '-h')",
        "help-word-help-less",
    ),
    ("Print help", "help-word-help"),
    ("Print version", "help-word-version"),
];

/// The headings of groups of options. Options that most people need are in no group.
pub(super) const FILES: &str = "Files and settings";
pub(super) const CHOICE: &str = "Choice of findings";
pub(super) const PICTURE: &str = "Picture";
pub(super) const FRAMES: &str = "Frames";
pub(super) const ACCURACY: &str = "Accuracy and time";
pub(super) const REPORTS: &str = "Reports";
pub(super) const MACHINES: &str = "Several machines";
pub(super) const LIMITS: &str = "Limits";
pub(super) const QUESTION: &str = "Questions";
pub(super) const GLOBAL: &str = "Global options";

const HEADINGS: [(&str, &str); 10] = [
    (FILES, "help-heading-files"),
    (CHOICE, "help-heading-choice"),
    (PICTURE, "help-heading-picture"),
    (FRAMES, "help-heading-frames"),
    (ACCURACY, "help-heading-accuracy"),
    (REPORTS, "help-heading-reports"),
    (MACHINES, "help-heading-machines"),
    (LIMITS, "help-heading-limits"),
    (QUESTION, "help-heading-questions"),
    (GLOBAL, "help-heading-global"),
];

/// The command line with all texts in a language, laid out for a width.
pub(super) fn in_language(command: Command, language: Language, width: usize) -> Command {
    let command = match language {
        Language::English => command,
        Language::Czech => translated(command, language),
    };
    fitted(command.term_width(width), width)
}

/// Wraps the text at the end of each command's help to a width. The rest is for clap to lay out.
fn fitted(command: Command, width: usize) -> Command {
    let after = command.get_after_help().map(ToString::to_string);
    let command = command.mut_subcommands(|sub| fitted(sub, width));
    match after {
        Some(after) => command.after_help(paragraphs(&after, width)),
        None => command,
    }
}

/// The help that clap has laid out, with clap's own words in a language, and its lines wrapped to `width`.
pub(super) fn shown(text: String, language: Language, width: usize) -> String {
    let text = own_words(text, language);
    let lines = text.split('\n').map(|line| hanging(line, width));
    lines.collect::<Vec<_>>().join("\n")
}

/// The help that clap has laid out, with clap's own words in a language. Lines may become longer.
pub(super) fn own_words(text: String, language: Language) -> String {
    match language {
        Language::English => text,
        Language::Czech => {
            let all = WORDS
                .iter()
                .fold(text, |text, (word, message)| match text.contains(word) {
                    true => text.replace(word, &language.say(message, &[])),
                    false => text,
                });
            // clap indents empty lines of a text like the others; they become empty again.
            let lines = all.split_inclusive('\n').map(|line| match line.trim_end() {
                "" => "\n",
                _ => line,
            });
            lines.collect()
        }
    }
}

/// The command line with the descriptions that shells show, in a language. It can parse no arguments any more: the
/// meanings of values stand with the values, and their parsers are gone.
pub(super) fn described(mut command: Command, language: Language) -> Command {
    command.build();
    match language {
        Language::English => command,
        Language::Czech => descriptions(command, language),
    }
}

/// The command with its options `--help` and `--version` described in a language. It must have been built before.
pub(super) fn described_help(command: Command, language: Language) -> Command {
    command.mut_args(|arg| of_clap(arg, language))
}

/// Describes clap's own options, which clap has built in English, in a language. Other arguments stay as they are.
fn of_clap(arg: Arg, language: Language) -> Arg {
    let message = match arg.get_id().as_str() {
        "help" => "help-word-help",
        "version" => "help-word-version",
        _ => return arg,
    };
    match language.own(message, None) {
        Some(text) => arg.long_help(text.clone()).help(text),
        None => arg,
    }
}

fn descriptions(command: Command, language: Language) -> Command {
    let name = command.get_name().to_owned();
    let about = match name.as_str() {
        "help" => Some(language.say("help-word-help-command", &[])),
        _ => language.own(&format!("help-{name}"), None),
    };
    let command = command
        .mut_args(|arg| description(&name, arg, language))
        .mut_subcommands(|sub| descriptions(sub, language));
    match about {
        Some(about) => command.about(about),
        None => command,
    }
}

fn description(command: &str, arg: Arg, language: Language) -> Arg {
    let arg = of_clap(arg, language);
    let Some(id) = id_of(command, &arg, language) else {
        return arg;
    };
    let values = arg.get_possible_values();
    let arg = arg.help(language.own(&id, None).unwrap_or_default());
    if values.iter().all(|v| v.get_help().is_none()) {
        return arg;
    }
    let values = values.iter().map(|value| {
        let name = value.get_name().to_owned();
        let meaning = language.own(&id, Some(&name));
        // The name is leaked, since clap keeps it until the program ends.
        let own = PossibleValue::new(&*name.leak());
        match meaning {
            Some(meaning) => own.help(meaning),
            None => own,
        }
    });
    let values: Vec<PossibleValue> = values.collect();
    arg.value_parser(PossibleValuesParser::new(values))
}

fn translated(command: Command, language: Language) -> Command {
    let name = command.get_name().to_owned();
    let id = format!("help-{name}");
    let mut command = command
        .mut_args(|arg| of_arg(&name, arg, language))
        .mut_subcommands(|sub| translated(sub, language));
    if let Some(about) = language.own(&id, None) {
        command = command.about(about);
    }
    match language.own(&id, Some("after")) {
        Some(after) => command.after_help(after),
        None => command,
    }
}

/// The ID of the message about an argument: that of the command, or that of all commands. `None` if there is neither.
fn id_of(command: &str, arg: &Arg, language: Language) -> Option<String> {
    let of = |command| format!("help-{command}-{}", arg.get_id());
    let ids = [of(command), of("any")].into_iter();
    ids.into_iter().find(|id| language.own(id, None).is_some())
}

fn of_arg(command: &str, arg: Arg, language: Language) -> Arg {
    let heading = arg.get_help_heading();
    let message = HEADINGS.iter().find(|(name, _)| Some(*name) == heading);
    let arg = match message {
        Some((_, message)) => {
            let heading: &'static str = language.say(message, &[]).leak();
            arg.help_heading(heading)
        }
        None => arg,
    };
    let Some(id) = id_of(command, &arg, language) else {
        return arg;
    };
    let say = |attribute: Option<&str>| language.own(&id, attribute);
    let help = say(None).unwrap_or_default();
    let arg = match say(Some("value")) {
        // The name is leaked, since clap keeps it until the program ends.
        Some(name) => arg.value_name(&*name.leak()),
        None => arg,
    };
    let values = arg.get_possible_values();
    if !arg.get_action().takes_values() {
        return arg.help(help);
    }
    // The default is added here, since clap would add it in English, and a line may end within it.
    let default: Vec<String> = (arg.get_default_values().iter())
        .map(|value| value.to_string_lossy().into_owned())
        .collect();
    let default = match default.is_empty() {
        true => String::new(),
        false => {
            let word = language.say("help-word-default", &[]);
            format!(" {word} {}]", default.join(", "))
        }
    };
    let help = help + &default;
    let arg = arg.hide_default_value(true);
    if values.iter().all(|v| v.get_help().is_none()) {
        if values.is_empty() {
            return arg.help(help);
        }
        let names: Vec<&str> = values.iter().map(|v| v.get_name()).collect();
        let word = language.say("help-word-values", &[]);
        let help = format!("{help} {word} {}]", names.join(", "));
        return arg.hide_possible_values(true).help(help);
    }
    // The list of values is written here, since the meanings of values belong to the parser and cannot be changed.
    let names: Vec<&str> = values.iter().map(|v| v.get_name()).collect();
    let width = names.iter().map(|n| n.len()).max().unwrap_or(0);
    let line = |name: &&str| match say(Some(name)) {
        Some(meaning) => format!(
            "\n- {:width$} {meaning}",
            format!("{name}:"),
            width = width + 1
        ),
        None => format!("\n- {name}"),
    };
    let heading = language.say("help-word-values-below", &[]);
    let meanings: String = names.iter().map(line).collect();
    let short = language.say("help-word-values", &[]);
    let short = format!("{help} {short} {}]", names.join(", "));
    let long = format!("{help}\n\n{heading}{meanings}");
    arg.hide_possible_values(true).help(short).long_help(long)
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use clap::CommandFactory;
    use unicode_width::UnicodeWidthStr as _;

    use super::*;
    use crate::commands::cli::Cli;
    use crate::commands::man::SECTIONS;

    const CZECH: &str = include_str!("help.cs.ftl");

    /// All messages and attributes that a command asks for, and what it has none for.
    fn asked(command: &Command, used: &mut BTreeSet<String>, missing: &mut Vec<String>) {
        let language = Language::Czech;
        let name = command.get_name();
        let id = format!("help-{name}");
        let mut ask = |id: &str, attribute: Option<&str>| {
            let whole = attribute.map_or(id.to_owned(), |a| format!("{id}.{a}"));
            match language.own(id, attribute) {
                Some(_) => {
                    used.insert(whole);
                }
                None => missing.push(whole),
            }
        };
        ask(&id, None);
        if command.get_after_help().is_some() {
            ask(&id, Some("after"));
        }
        for arg in command.get_arguments() {
            let Some(id) = id_of(name, arg, language) else {
                ask(&format!("help-{name}-{}", arg.get_id()), None);
                continue;
            };
            ask(&id, None);
            if arg.get_action().takes_values() {
                ask(&id, Some("value"));
            }
            let values = arg.get_possible_values();
            if values.iter().any(|v| v.get_help().is_some()) {
                values.iter().for_each(|v| ask(&id, Some(v.get_name())));
            }
        }
        for sub in command.get_subcommands() {
            asked(sub, used, missing);
        }
    }

    #[test]
    fn czech_has_all_texts_and_no_others() {
        let (mut used, mut missing) = (BTreeSet::new(), Vec::new());
        asked(&Cli::command(), &mut used, &mut missing);
        assert!(missing.is_empty(), "not in help.cs.ftl: {missing:#?}");
        used.extend(WORDS.map(|(_, message)| message.to_owned()));
        used.insert("help-word-values-below".to_owned());
        used.extend(SECTIONS.map(|(_, message)| message.to_owned()));
        used.extend(HEADINGS.map(|(_, message)| message.to_owned()));
        let mut message = "";
        for line in CZECH.lines() {
            let name = line.split(" =").next().unwrap_or_default();
            let there = match name.strip_prefix("    .") {
                Some(attribute) => format!("{message}.{attribute}"),
                None if line.starts_with("help-") => {
                    message = name;
                    name.to_owned()
                }
                None => continue,
            };
            assert!(used.contains(&there), "nothing asks for {there}");
        }
    }

    /// At any width, in both languages, short and long; and options that are many stand in groups.
    #[test]
    fn every_help_fits() {
        for language in [Language::English, Language::Czech] {
            for width in [80, 120] {
                let mut command = in_language(Cli::command(), language, width);
                command.build();
                let names: Vec<String> = (command.get_subcommands())
                    .map(|c| c.get_name().to_owned())
                    .collect();
                for name in names {
                    let sub = command.find_subcommand_mut(&name).unwrap();
                    for help in [sub.render_help(), sub.render_long_help()] {
                        let help = shown(help.to_string(), language, width);
                        for line in help.lines() {
                            assert!(line.width() <= width, "{name}: {line}");
                        }
                    }
                    let own = |arg: &&Arg| !arg.is_positional() && arg.get_help_heading().is_none();
                    let count = sub.get_arguments().filter(own).count();
                    assert!(count <= 13, "{count} options of {name} in no group");
                }
            }
        }
    }

    /// A heading that nobody knows would stay in English.
    #[test]
    fn every_heading_is_known() {
        fn check(command: &Command) {
            let headings = command.get_arguments().filter_map(|a| a.get_help_heading());
            for heading in headings {
                assert!(
                    HEADINGS.iter().any(|(name, _)| *name == heading),
                    "{heading}"
                );
            }
            command.get_subcommands().for_each(check);
        }
        check(&Cli::command());
    }

    #[test]
    fn every_help_is_czech() {
        let mut command = in_language(Cli::command(), Language::Czech, 100);
        command.build();
        let names: Vec<String> = (command.get_subcommands())
            .map(|c| c.get_name().to_owned())
            .collect();
        for name in names {
            let sub = command.find_subcommand_mut(&name).unwrap();
            for help in [sub.render_help(), sub.render_long_help()] {
                let help = own_words(help.to_string(), Language::Czech);
                for word in [
                    "Usage", "Options", "Print", "default", "possible", "OPTIONS",
                ] {
                    assert!(!help.contains(word), "{word} in {help}");
                }
                assert!(help.contains("Použití: zpg "), "{help}");
            }
        }
    }
}
