//! `zpg fmt`: prints scenes anew, one record a line.

use std::io::{self, Write};
use std::path::{Path, PathBuf};

use rayon::prelude::*;

use super::loaded::{self, STDIN};
use super::rewrite::{diff, replace};
use super::{LookChoice, Status, complain, paths, terminal};
use crate::diagnostics::{Complaint, SourceFile};
use crate::{format, syntax};

/// Format scenes, one record a line
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Files are rewritten in place; `-` formats standard input to standard output. Lines with mistakes on
them are left as they are. With --check or --diff nothing is written, and the exit status is 1 when
something would change.

Examples:
  zpg fmt scene.zpg
  zpg fmt scenes/                all *.zpg in the folder, .gitignore honoured
  zpg fmt --diff scene.zpg       what would change
  zpg fmt --check scenes/        for a continuous build
  zpg fmt - < in.zpg > out.zpg")]
pub struct Args {
    /// Scene files or folders; `-` is standard input
    #[arg(required = true, value_name = "PATH")]
    paths: Vec<PathBuf>,

    /// Write nothing; name the files that would change
    #[arg(long)]
    check: bool,

    /// Write nothing; show what would change
    #[arg(long)]
    diff: bool,
}

/// What became of a file.
enum Outcome {
    Unchanged,
    /// Rewritten, or to be rewritten if it were not for `--check` or `--diff`.
    Changed,
    /// It has been said why.
    Failed,
}

/// A file's outcome, and what goes to standard output for it.
struct Formatted {
    outcome: Outcome,
    output: Vec<u8>,
}

pub fn run(args: &Args, look: LookChoice) -> Status {
    let found = paths::expand(&args.paths, look);
    let colour = look.colour(&io::stdout());
    let formatted: Vec<Formatted> = found
        .files
        .par_iter()
        .map(|path| match format_file(path, args, colour) {
            Ok(formatted) => formatted,
            Err(complaint) => {
                complain(look, &complaint);
                Formatted {
                    outcome: Outcome::Failed,
                    output: Vec::new(),
                }
            }
        })
        .collect();

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
        if carries_data {
            return Ok(());
        }
        summary(out, changed, unchanged, only_looking)
    })
}

/// `2 files would be reformatted, 1 file is formatted already.`
fn summary(
    out: &mut dyn Write,
    changed: usize,
    unchanged: usize,
    only_looking: bool,
) -> io::Result<()> {
    let files = |n: usize| format!("{n} file{}", if n == 1 { "" } else { "s" });
    let verb = if only_looking {
        "would be reformatted"
    } else {
        "reformatted"
    };
    match (changed, unchanged) {
        (0, 0) => Ok(()),
        (0, same) => writeln!(out, "{} left unchanged", files(same)),
        (new, 0) => writeln!(out, "{} {verb}", files(new)),
        (new, same) => writeln!(out, "{} {verb}, {} left unchanged", files(new), files(same)),
    }
}

/// Formats one file.
fn format_file(path: &Path, args: &Args, colour: bool) -> Result<Formatted, Complaint> {
    let bytes = loaded::read(path)?;
    let is_stdin = path.as_os_str() == STDIN;
    let source = SourceFile::new(path.to_string_lossy(), bytes);
    let text = format_text(&source)?;
    let changed = text != source.text;
    let mut output = Vec::new();
    let outcome = if changed {
        Outcome::Changed
    } else {
        Outcome::Unchanged
    };
    if args.check || args.diff {
        if changed && args.diff {
            diff(&mut output, &source.path, &source.text, &text, colour);
        } else if changed && !is_stdin {
            output = format!("would reformat: {}\n", source.path).into_bytes();
        }
    } else if is_stdin {
        output = source.encode(&text);
    } else if changed {
        replace(path, &source.encode(&text))?;
    }
    Ok(Formatted { outcome, output })
}

/// The formatted text. A formatter must not change what a scene says: that is not left to trust.
fn format_text(source: &SourceFile) -> Result<String, Complaint> {
    let (document, _) = syntax::parse(&source.text);
    let text = format::format(&source.text, &document);
    if text != source.text {
        let (again, _) = syntax::parse(&text);
        if !format::same_content((&source.text, &document), (&text, &again)) {
            return Err(Complaint::new("not-formatted").with("path", source.path.clone()));
        }
    }
    Ok(text)
}
