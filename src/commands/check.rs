//! `zpg check`: reads scenes and says what is wrong with them.

use std::io;
use std::path::{Path, PathBuf};

use rayon::prelude::*;

use super::{LoadError, LookChoice, Status, complain, load, paths, terminal};
use crate::diagnostics::render::human::{self, Look};
use crate::diagnostics::render::{Tally, github, json, sarif, short};

/// Check scenes for mistakes
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Findings go to standard output. The exit status is 0 when there is no error, 1 when there is
one, 2 when a file cannot be read.

Examples:
  zpg check scene.zpg
  zpg check scenes/                    all *.zpg in the folder, .gitignore honoured
  zpg check --format short scenes/     one line for each finding
  zpg check --format json - < scene.zpg
  zpg check --format sarif scenes/ > zpg.sarif

`zpg explain E101` tells more about a finding.")]
pub struct Args {
    /// Scene files or folders; `-` is standard input
    #[arg(required = true, value_name = "PATH")]
    paths: Vec<PathBuf>,

    /// How to print the findings
    #[arg(long, value_enum, default_value_t)]
    format: Format,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, clap::ValueEnum)]
enum Format {
    /// With the lines in question, notes and proposed fixes
    #[default]
    Human,
    /// One line for each finding
    Short,
    /// For programs
    Json,
    /// For code scanning: SARIF 2.1.0
    Sarif,
    /// For GitHub Actions: annotations of pull requests
    Github,
}

/// One file's findings, ready to be put out.
struct Checked {
    output: Output,
    tally: Tally,
}

enum Output {
    Text(Vec<u8>),
    Json(json::File),
    Sarif(sarif::File),
}

pub fn run(args: &Args, look: LookChoice) -> Status {
    let files = paths::expand(&args.paths);
    let look = look.on(&io::stdout());
    let results: Vec<_> = files
        .files
        .par_iter()
        .map(|path| check(path, args.format, look))
        .collect();

    let mut failed = files.failed;
    let mut total = Tally::default();
    let mut outputs = Vec::new();
    for result in results {
        match result {
            Ok(checked) => {
                total.merge(&checked.tally);
                outputs.push(checked.output);
            }
            Err(e) => {
                complain(&e.to_string());
                failed = true;
            }
        }
    }
    let status = if failed {
        Status::Failure
    } else if total.errors > 0 {
        Status::Negative
    } else {
        Status::Clean
    };
    terminal::print(status, |out| {
        let mut reports = Vec::new();
        let mut scans = Vec::new();
        for output in outputs {
            match output {
                Output::Text(text) => out.write_all(&text)?,
                Output::Json(report) => reports.push(report),
                Output::Sarif(scan) => scans.push(scan),
            }
        }
        match args.format {
            // With nothing read there is nothing to sum up.
            Format::Human if total.files > 0 => writeln!(out, "{}", total.sentence(look.language)),
            Format::Human | Format::Short | Format::Github => Ok(()),
            Format::Json => json::write(out, &reports, &total),
            Format::Sarif => sarif::write(out, &scans, look.language, !failed),
        }
    })
}

fn check(path: &Path, format: Format, look: Look) -> Result<Checked, LoadError> {
    let loaded = load(path)?;
    let mut tally = Tally::default();
    tally.add(&loaded.diagnostics);
    let mut text = Vec::new();
    let written = match format {
        Format::Human => human::write(&mut text, &loaded.source, &loaded.diagnostics, look),
        Format::Short => short::write(
            &mut text,
            &loaded.source,
            &loaded.diagnostics,
            look.language,
        ),
        Format::Json => {
            let output = Output::Json(json::File::new(
                &loaded.source,
                loaded.diagnostics,
                look.language,
            ));
            return Ok(Checked { output, tally });
        }
        Format::Sarif => {
            let output = Output::Sarif(sarif::File::new(
                &loaded.source,
                loaded.diagnostics,
                look.language,
            ));
            return Ok(Checked { output, tally });
        }
        Format::Github => github::write(
            &mut text,
            &loaded.source,
            &loaded.diagnostics,
            look.language,
        ),
    };
    debug_assert!(written.is_ok(), "memory takes everything");
    Ok(Checked {
        output: Output::Text(text),
        tally,
    })
}
