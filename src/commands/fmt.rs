//! `zpg fmt`: prints scenes anew, in the one layout.

use std::borrow::Cow;
use std::io;
use std::ops::RangeInclusive;
use std::path::{Path, PathBuf};
use std::str::FromStr;

use super::apart::apart;
use super::difference::diff;
use super::help;
use super::load::is_json;
use super::rewrite::{allow, bytes_of, replace};
use super::settings::{Chosen, Scenes, pass_through};
use super::shell::quoted;
use super::terminal::Complaints;
use super::{LookChoice, Status, complain, terminal};
use crate::analysis::config::{ConfigError, Configs};
use crate::analysis::file::{self, STDIN};
use crate::analysis::{Analysis, repair};
use crate::diagnostics::source::Locator;
use crate::diagnostics::{Complaint, Diagnostic, SourceFile, Value};
use crate::format::{format, format_range};
use crate::parallel;
use crate::syntax::{preserved, recognise};

/// Format scenes: one record a line, numbers and comments under each other
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Files are rewritten in place; `-` formats standard input to standard output. Lines with mistakes on
them are left as they are, and so are encoding and line breaks. With --check or --diff nothing is
written, and the exit status is 1 when something would change. A file that is no scene is never
written to; the exit status is 2.

The style can be chosen in zpg.toml, the nearest one upwards from a scene, or with --config. Its
`exclude` leaves out files and folders. These are the defaults of the style:
  [format]
  width = 100                    where profiles wrap, and how far alignment goes
  align = true                   numbers and comments of neighbouring lines under each other
  group = true                   the vectors of a record set off by double spaces
  numbers = \"shortest\"           or \"keep\": as they are written

Examples:
  zpg fmt                        all *.zpg in this folder and below
  zpg fmt scene.zpg
  zpg fmt scenes/                all *.zpg in the folder, .gitignore honoured
  zpg fmt --diff scene.zpg       what would change
  zpg fmt --check scenes/        for a continuous build
  zpg fmt --range 3-9 scene.zpg  lines 3 to 9 alone
  zpg fmt - < in.zpg > out.zpg")]
pub struct Args {
    #[command(flatten)]
    chosen: Chosen,

    /// Write nothing; name the files that would change
    #[arg(long)]
    check: bool,

    /// Write nothing; show what would change
    #[arg(long)]
    diff: bool,

    /// Format files even if their names end as those of other tools' files do (.csv, .md, .obj …)
    #[arg(help_heading = help::FILES)]
    #[arg(long)]
    force: bool,

    /// Change only the records that touch these lines, counted from 1; for one file
    #[arg(long, value_name = "FIRST-LAST")]
    range: Option<Lines>,

    /// What standard input goes by, in messages and for zpg.toml; without a PATH, standard input is read
    #[arg(help_heading = help::FILES)]
    #[arg(long, value_name = "NAME")]
    stdin_filename: Option<PathBuf>,
}

/// Lines of a file: `3-9`, or a single one: `3`.
#[derive(Debug, Clone)]
struct Lines(RangeInclusive<usize>);

impl FromStr for Lines {
    type Err = Complaint;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let (first, last) = text.split_once('-').unwrap_or((text, text));
        match (first.parse(), last.parse()) {
            (Ok(first @ 1..), Ok(last)) if first <= last => Ok(Lines(first..=last)),
            _ => Err(Complaint::new("expected-lines")),
        }
    }
}

/// The outcome for a file.
enum Outcome {
    Unchanged,
    /// Rewritten, or to be rewritten if it were not for `--check` or `--diff`.
    Changed,
    /// The file could not be formatted; the complaint has been printed.
    Failed,
}

/// A file's outcome, and what goes to standard output for it.
struct Formatted {
    outcome: Outcome,
    output: Vec<u8>,
}

pub fn run(args: &Args, look: LookChoice) -> Status {
    let stdin = args.stdin_filename.as_deref();
    let Some(Scenes {
        files: found,
        configs,
    }) = args.chosen.scenes(stdin, look)
    else {
        return Status::Failure;
    };
    if found.files.is_empty() && args.chosen.reads_stdin(stdin) {
        return pass_through(!args.check && !args.diff, look);
    }
    if args.range.is_some() && found.files.len() != 1 {
        complain(look, &Complaint::new("range-of-many"));
        return Status::Failure;
    }
    let results = parallel::map(found.files.len(), |i| {
        let path = &found.files[i];
        apart(path, || format_file(path, args, &configs, look))
    });
    let mut complaints = Complaints::new(look);
    let results = results.into_iter().map(|result| {
        result.unwrap_or_else(|complaint| {
            complaints.say(complaint);
            Formatted {
                outcome: Outcome::Failed,
                output: Vec::new(),
            }
        })
    });
    let formatted: Vec<_> = results.collect();

    let count = |of: fn(&Outcome) -> bool| formatted.iter().filter(|f| of(&f.outcome)).count();
    let changed = count(|o| matches!(o, Outcome::Changed));
    let unchanged = count(|o| matches!(o, Outcome::Unchanged));
    let only_looking = args.check || args.diff;
    let status = if found.failed || changed + unchanged < formatted.len() {
        Status::Failure
    } else if only_looking && changed > 0 {
        Status::Negative
    } else {
        Status::Clean
    };
    // Where standard output carries a scene or a diff, it carries nothing else.
    let carries_data = args.diff || found.files.iter().any(|f| f.as_os_str() == STDIN);
    terminal::print(look, status, |out| {
        for file in &formatted {
            out.write_all(&file.output)?;
        }
        if carries_data || changed + unchanged == 0 || look.quiet {
            return Ok(());
        }
        writeln!(out, "{}", summary(changed, unchanged, only_looking, look))
    })
}

/// The last line of a run, such as `2 files would be reformatted, 1 file left unchanged`.
fn summary(changed: usize, unchanged: usize, only_looking: bool, look: LookChoice) -> String {
    let count = |message, n: usize| Complaint::new(message).with("count", Value::Count(n as u64));
    let changes = match only_looking {
        true => count("would-be-reformatted", changed),
        false => count("reformatted", changed),
    };
    let rest = count("left-unchanged", unchanged);
    let all = match (changed, unchanged) {
        (0, _) => rest,
        (_, 0) => changes,
        _ => Complaint::new("list-comma")
            .with("first", changes)
            .with("last", rest),
    };
    all.wording(look.language())
}

/// The first error of a scene with lines that cannot be read, which are left as they are, and the command that says more.
fn mistake(source: &SourceFile, is_stdin: bool, look: LookChoice) -> Option<Complaint> {
    let all = repair::proposals(&Analysis::of(source.with_text(source.text.clone())));
    let first = all.iter().find(|d: &&Diagnostic| d.is_error())?;
    let place = Locator::new(source).position(first.span.start);
    let place = format!("{}:{}:{}", source.path, place.line, place.column);
    let case = match is_stdin {
        true => "layout-mistake-stdin",
        false => "layout-mistake",
    };
    let message = first.wording(look.language()).message;
    let complaint = (Complaint::new(case).with("place", place))
        .with("code", first.code.as_str())
        .with("message", message);
    Some(complaint.with("command", format!("zpg check {}", quoted(&source.path))))
}

/// Formats one file.
fn format_file(
    path: &Path,
    args: &Args,
    configs: &Configs,
    look: LookChoice,
) -> Result<Formatted, Complaint> {
    let is_stdin = path.as_os_str() == STDIN;
    let name = match &args.stdin_filename {
        Some(name) if is_stdin => name.as_path(),
        _ => path,
    };
    let config = configs.for_file(name).map_err(ConfigError::complaint)?;
    if !is_stdin {
        allow(path, args.force, !args.check && !args.diff)?;
    }
    let bytes = file::read(path)?;
    if is_json(name, &bytes) {
        return Err(Complaint::new("json-not-formatted").with("path", name));
    }
    let (source, document) = match recognise::parse(name.to_string_lossy(), bytes) {
        Ok(read) => read,
        Err(stranger) => {
            terminal::findings(&stranger.source, &[stranger.finding], look);
            return Ok(Formatted {
                outcome: Outcome::Failed,
                output: Vec::new(),
            });
        }
    };
    if document.contents.broken
        && let Some(mistake) = mistake(&source, is_stdin, look)
    {
        terminal::note(look, &mistake);
    }
    let text = match &args.range {
        None => format(&source.text, &document, &config.format),
        Some(Lines(lines)) => {
            let count = source.text.lines().count();
            if *lines.start() > count {
                let behind = Complaint::new("range-behind-end").with("path", name);
                terminal::note(look, &behind.with("lines", Value::Count(count as u64)));
            }
            let mut text = source.text.clone();
            if let Some(edit) = format_range(&source.text, &document, &config.format, lines.clone())
            {
                text.replace_range(edit.span.range(), &edit.text);
            }
            text
        }
    };
    let changed = text != source.text;
    if changed && !preserved::by_layout((&source.text, &document), &text) {
        return Err(Complaint::new("layout-changes-content").with("path", name));
    }
    // A text that cannot be written is refused even if nothing is to be written.
    let bytes = match changed || is_stdin {
        true => bytes_of(&source, &text, document.contents.broken)?,
        false => Cow::default(),
    };
    let mut output = Vec::new();
    let outcome = if changed {
        Outcome::Changed
    } else {
        Outcome::Unchanged
    };
    if args.check || args.diff {
        if changed && args.diff {
            let colour = look.colour(&io::stdout());
            diff(&mut output, &source.path, &source.text, &text, colour);
        } else if changed && !is_stdin {
            let path = [("path", Value::from(source.path.clone()))];
            output = (look.language().say("would-reformat", &path) + "\n").into_bytes();
        }
    } else if is_stdin {
        output = bytes.into_owned();
    } else if changed {
        replace(path, &bytes)?;
    }
    Ok(Formatted { outcome, output })
}
