//! Answers to wrong arguments, in the chosen language.

use std::error::Error;
use std::io::{self, Write};
use std::path::Path;
use std::str::FromStr;

use clap::Command;
use clap::builder::StyledStr;
use clap::error::{ContextKind, ContextValue, ErrorKind};

use super::habits;
use super::help::{own_words, shown};
use super::terminal::{complain, tell, width};
use super::{LookChoice, Status};
use crate::diagnostics::Complaint;
use crate::diagnostics::layout::paragraphs;
use crate::lint::levels::UnknownCode;

/// Reads a number of the command line that must satisfy a condition.
///
/// # Errors
/// The text is no such number: the complaint is the message `otherwise`. For a number with a decimal comma, the
/// complaint says how to write it.
pub fn number<T: FromStr + Copy>(
    text: &str,
    otherwise: &'static str,
    is_right: impl Fn(T) -> bool,
) -> Result<T, Complaint> {
    let read = |text: &str| text.parse().ok().filter(|x| is_right(*x));
    read(text).ok_or_else(|| {
        let point = text.replace(',', ".");
        let is_comma = text.matches(',').count() == 1 && read(&point).is_some();
        match is_comma {
            true => Complaint::new("decimal-comma").with("number", point),
            false => Complaint::new(otherwise),
        }
    })
}

/// Reads a whole number from 0 on.
pub fn whole<T: FromStr + Copy>(text: &str) -> Result<T, Complaint> {
    number(text, "expected-whole-number", |_| true)
}

/// Answers arguments that clap does not take: with a complaint, with the help that they ask for, or, if there are none,
/// with the commands that a newcomer needs. Returns the exit status.
pub fn refuse(error: &clap::Error, command: &mut Command, look: LookChoice) -> Status {
    let language = look.language();
    let is_bare = matches!(
        error.kind(),
        ErrorKind::MissingSubcommand | ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand
    );
    if is_bare {
        let start = paragraphs(&language.say("start", &[]), width());
        // Nobody is left to be told when the stream is gone.
        let _ = writeln!(io::stderr(), "{start}");
        return Status::Failure;
    }
    // clap takes `--help` for the name of a command here; the answer is that of `zpg --help`.
    let word = error.get(ContextKind::InvalidSubcommand).and_then(listed);
    if word.is_some_and(|word| ["--help", "-h"].contains(&&*word)) {
        let help = laid_out(&command.render_long_help(), look.colour(&io::stdout()));
        let _ = write!(io::stdout(), "{}", shown(help, language, width()));
        return Status::Clean;
    }
    let Some(what) = complaint(error, command) else {
        let help = error.render();
        // Nobody is left to be told when the stream is gone.
        return match error.use_stderr() {
            true => {
                let help = laid_out(&help, look.colour(&io::stderr()));
                let _ = write!(io::stderr(), "{}", shown(help, language, width()));
                Status::Failure
            }
            false => {
                let help = laid_out(&help, look.colour(&io::stdout()));
                let _ = write!(io::stdout(), "{}", shown(help, language, width()));
                Status::Clean
            }
        };
    };
    let say = |line: Complaint| tell(&format!("\n{}", line.wording(language)));
    complain(look, &what);
    let usage = error.get(ContextKind::Usage).map(ToString::to_string);
    // For an unknown argument, clap's usage is that of the argument which clap believes was meant.
    let unknown = error.get(ContextKind::InvalidArg).and_then(listed);
    let is_meant = |near: &String| {
        unknown
            .as_deref()
            .is_none_or(|written| is_near(written, near))
    };
    // A word of another program or in Czech has an answer of its own, which says what to write instead.
    let has_answer = unknown.as_deref().is_some_and(|word| {
        let message = habits::message(word, command_of(usage.as_deref()));
        message.is_some()
            || habits::czech(word)
                .or_else(|| habits::explain(word))
                .is_some()
    });
    let usage = usage.filter(|_| !has_answer && suggested(error).iter().all(is_meant));
    // For a conflict, clap's usage has all arguments that were given, though these do not go together: the general
    // usage is shown.
    let usage = match error.kind() {
        ErrorKind::ArgumentConflict => usage.map(|usage| general(&usage, command)),
        _ => usage,
    };
    if let Some(usage) = usage.as_deref().and_then(|u| u.strip_prefix("Usage: ")) {
        say(Complaint::new("usage").with("usage", own_words(usage.to_owned(), language)));
    }
    say(Complaint::new("usage-more"));
    Status::Failure
}

/// The name of the subcommand in a usage such as `Usage: zpg render [OPTIONS]`; empty if there is none.
fn command_of(usage: Option<&str>) -> &str {
    let name = usage.and_then(|u| u.split_whitespace().nth(2));
    name.unwrap_or_default()
}

/// The general usage of the subcommand that a usage is about, as its help begins.
fn general(usage: &str, command: &mut Command) -> String {
    let mut name = usage.split_whitespace().skip(2);
    let of = name
        .next()
        .and_then(|name| command.find_subcommand_mut(name));
    match of {
        Some(of) => of.render_usage().to_string(),
        None => usage.to_owned(),
    }
}

fn laid_out(help: &StyledStr, colour: bool) -> String {
    match colour {
        true => help.ansi().to_string(),
        false => help.to_string(),
    }
}

/// The complaint about the arguments. `None` for help and the version, which clap prints itself.
fn complaint(error: &clap::Error, command: &Command) -> Option<Complaint> {
    let commands: Vec<String> = (command.get_subcommands())
        .map(|c| c.get_name().to_owned())
        .collect();
    let usage = error.get(ContextKind::Usage).map(ToString::to_string);
    let of = command.find_subcommand(command_of(usage.as_deref()));
    let get = |kind| error.get(kind).and_then(listed);
    let arg = |message| Some(Complaint::new(message).with("arg", get(ContextKind::InvalidArg)?));
    let what = match error.kind() {
        ErrorKind::UnknownArgument => arg("usage-unknown")?,
        ErrorKind::InvalidSubcommand => {
            let command = get(ContextKind::InvalidSubcommand)?;
            Complaint::new("usage-no-command").with("arg", command)
        }
        ErrorKind::MissingRequiredArgument => {
            let missing = match error.get(ContextKind::InvalidArg)? {
                ContextValue::Strings(all) => all.iter().map(|arg| with_values(arg, of)).collect(),
                other => vec![listed(other)?],
            };
            Complaint::new("usage-missing").with("arg", missing.join(", "))
        }
        ErrorKind::ArgumentConflict => match get(ContextKind::PriorArg)? {
            other if Some(&other) == get(ContextKind::InvalidArg).as_ref() => arg("usage-twice")?,
            other => arg("usage-conflict")?.with("other", other),
        },
        ErrorKind::TooManyValues => {
            arg("usage-flag")?.with("text", get(ContextKind::InvalidValue)?)
        }
        ErrorKind::InvalidValue | ErrorKind::ValueValidation => {
            let what = match get(ContextKind::InvalidValue).filter(|text| !text.is_empty()) {
                None => arg("usage-no-value")?,
                Some(text) => arg("usage-value")?.with("text", text),
            };
            let [argument, value] = [ContextKind::InvalidArg, ContextKind::InvalidValue]
                .map(|kind| get(kind).unwrap_or_default());
            let reason = habits::camera(&argument, &value).or_else(|| reason(error));
            match reason {
                Some(reason) => Complaint::new("with-reason")
                    .with("what", what)
                    .with("reason", reason),
                None => what,
            }
        }
        ErrorKind::InvalidUtf8 => Complaint::new("usage-not-text"),
        // Help and the version. No argument takes several values or needs an equals sign.
        _ => return None,
    };
    let unknown = matches!(
        error.kind(),
        ErrorKind::UnknownArgument | ErrorKind::InvalidSubcommand
    );
    let foreign = [ContextKind::InvalidArg, ContextKind::InvalidSubcommand];
    let foreign = foreign.into_iter().find_map(get).filter(|_| unknown);
    let command = command_of(usage.as_deref());
    let instead = foreign.as_deref().and_then(|word| {
        let habit = habits::message(word, command);
        let habit = habit.map(|message| habits::with_numbers(message).with("text", opposite(word)));
        let template = || habits::template(word, command);
        habit
            .or_else(|| habits::czech(word))
            .or_else(|| habits::explain(word))
            .or_else(template)
            .or_else(|| habits::output(Path::new(word)))
    });
    if let Some(instead) = instead {
        return Some(
            Complaint::new("with-reason")
                .with("what", what)
                .with("reason", instead),
        );
    }
    let written = [
        ContextKind::InvalidValue,
        ContextKind::InvalidSubcommand,
        ContextKind::InvalidArg,
    ];
    let written = written.into_iter().find_map(get);
    let mut near = suggested(error);
    near.retain(|near| written.as_deref().is_none_or(|w| is_near(w, near)));
    if let Some(written) = written.as_deref().filter(|_| near.is_empty()) {
        near = meant(error, written, &commands);
    }
    Some(what.or_meant(near))
}

/// A missing argument such as `--for <ENGINE>`, followed by the values that the subcommand `of` knows for it.
fn with_values(arg: &str, of: Option<&Command>) -> String {
    let option = arg
        .split(' ')
        .next()
        .and_then(|name| name.strip_prefix("--"));
    let found = of.and_then(|of| {
        of.get_arguments()
            .find(|a| option.is_some() && a.get_long() == option)
    });
    let values = found.map_or(Vec::new(), clap::Arg::get_possible_values);
    let names: Vec<&str> = values.iter().map(|value| value.get_name()).collect();
    // A placeholder such as `<povray|mitsuba>` names the values already.
    match names.is_empty() || arg.contains('|') {
        true => arg.to_owned(),
        false => format!("{arg} ({})", names.join(", ")),
    }
}

/// Guesses what a word means for which clap has no suggestion. Returns the commands or the values that may be meant.
fn meant(error: &clap::Error, written: &str, commands: &[String]) -> Vec<String> {
    match error.kind() {
        ErrorKind::InvalidSubcommand if is_scene(Path::new(written)) => {
            vec![
                format!("zpg check {written}"),
                format!("zpg render {written}"),
            ]
        }
        ErrorKind::InvalidSubcommand => {
            let near = commands.iter().filter(|name| is_near(written, name));
            near.cloned().collect()
        }
        ErrorKind::InvalidValue => {
            let all = error.get(ContextKind::ValidValue);
            let is_one = |value: &&str| match all {
                Some(ContextValue::Strings(all)) => all.iter().any(|v| v == value),
                _ => false,
            };
            let value = habits::value(written).filter(is_one);
            value.map(str::to_owned).into_iter().collect()
        }
        _ => Vec::new(),
    }
}

/// Whether a word in the place of a command is the path of a scene, or of anything that exists.
fn is_scene(path: &Path) -> bool {
    let endings = ["zpg", "json"];
    let ending = path.extension().unwrap_or_default();
    endings.iter().any(|e| ending.eq_ignore_ascii_case(e)) || path.exists()
}

/// The names that clap suggests in place of an unknown one.
fn suggested(error: &clap::Error) -> Vec<String> {
    let kinds = [
        ContextKind::SuggestedArg,
        ContextKind::SuggestedSubcommand,
        ContextKind::SuggestedValue,
    ];
    let found = kinds.into_iter().find_map(|kind| error.get(kind));
    match found {
        Some(ContextValue::String(one)) => vec![one.clone()],
        Some(ContextValue::Strings(all)) => all.clone(),
        _ => Vec::new(),
    }
}

/// The option that another one turns off: `--fix` for `--no-fix`.
fn opposite(word: &str) -> String {
    let name = word.split('=').next().unwrap_or(word);
    name.replacen("--no-", "--", 1)
}

/// Whether someone who has written `written` may have meant `name`: one is a part of the other, or few letters differ.
pub fn is_near(written: &str, name: &str) -> bool {
    // Nobody who writes `--no-fix` means `--fix`.
    if written.starts_with("--no-") && !name.starts_with("--no-") {
        return false;
    }
    let [written, name] = [written, name].map(|w| w.trim_start_matches('-'));
    let part = written.len() > 2 && (name.contains(written) || written.contains(name));
    part || strsim::osa_distance(written, name) <= 1 + written.len() / 4
}

/// Why a value is wrong: the values that are possible, or the complaint of the parser.
fn reason(error: &clap::Error) -> Option<Complaint> {
    if let Some(values) = error.get(ContextKind::ValidValue).and_then(listed) {
        return Some(Complaint::new("usage-values").with("values", values));
    }
    let source = error.source()?;
    let unknown = source.downcast_ref().map(UnknownCode::complaint);
    let ours = unknown.or_else(|| source.downcast_ref::<Complaint>().cloned());
    Some(ours.unwrap_or_else(|| Complaint::quoted(source)))
}

/// The text of a value in an error of clap's; several texts are joined by commas.
fn listed(value: &ContextValue) -> Option<String> {
    match value {
        ContextValue::String(s) => Some(s.clone()),
        ContextValue::Strings(all) if !all.is_empty() => Some(all.join(", ")),
        _ => None,
    }
}
