//! `zpg convert`: the scene for other programs.

use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use crate::commands::{ColorChoice, Status, complain, load, report};
use crate::translate::{Report, Translation, Unsupported, pov};

/// Translate a scene for another program
#[derive(Debug, clap::Args)]
pub struct Args {
    /// The scene; `-` is standard input
    file: PathBuf,

    /// What to translate it to
    #[arg(long, value_enum)]
    to: Target,

    /// Where to write; standard output if not given
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,

    /// Size of the picture the camera is for, in pixels
    #[arg(long, default_value = "640x480", value_name = "WxH", value_parser = parse_size)]
    size: (u32, u32),

    /// How often a ray may be mirrored or refracted
    #[arg(long, default_value_t = 10, value_name = "N")]
    depth: u32,

    /// Write the fidelity report as JSON, too
    #[arg(long, value_name = "FILE.json")]
    report: Option<PathBuf>,
}

/// The programs there are translations for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum Target {
    /// POV-Ray 3.7
    Pov,
}

/// Reads the scene, translates it, says how well it went.
pub fn run(args: &Args, color: ColorChoice) -> Status {
    let mut loaded = match load(&args.file) {
        Ok(loaded) => loaded,
        Err(e) => {
            complain(&e.to_string());
            return Status::Failure;
        }
    };
    let render = loaded.require_render();
    report(&loaded, color);
    if render.is_none() || loaded.has_errors() {
        return Status::Negative;
    }
    match translate(args, &loaded.scene) {
        Ok(translation) => deliver(args, &translation),
        Err(unsupported) => {
            let at = unsupported.span.map(|s| loaded.source.position(s.start));
            let place = at.map_or(String::new(), |p| {
                format!("{}:{}:{}: ", loaded.source.path, p.line, p.column)
            });
            complain(&format!("{place}{unsupported}"));
            Status::Negative
        }
    }
}

fn translate(args: &Args, scene: &crate::scene::Scene) -> Result<Translation, Unsupported> {
    match args.to {
        Target::Pov => pov::write(
            scene,
            &pov::Options {
                size: args.size,
                depth: args.depth,
            },
        ),
    }
}

/// Writes the translation and its report.
fn deliver(args: &Args, translation: &Translation) -> Status {
    let written = match &args.output {
        Some(path) => fs::write(path, &translation.text).map_err(|e| (path.clone(), e)),
        None => match io::stdout().lock().write_all(translation.text.as_bytes()) {
            // Nobody reads any more: that is their choice.
            Err(e) if e.kind() != io::ErrorKind::BrokenPipe => {
                Err((PathBuf::from("standard output"), e))
            }
            _ => Ok(()),
        },
    };
    let written = written.and_then(|()| match &args.report {
        Some(path) => write_report(path, &translation.report).map_err(|e| (path.clone(), e)),
        None => Ok(()),
    });
    // Nobody is left to be told when standard error is gone.
    let _ = write!(io::stderr(), "{}", translation.report);
    match written {
        Ok(()) => Status::Clean,
        Err((path, e)) => {
            complain(&format!("cannot write {}: {e}", path.display()));
            Status::Failure
        }
    }
}

fn write_report(path: &Path, report: &Report) -> io::Result<()> {
    let mut text = serde_json::to_string_pretty(&report.to_json())?;
    text.push('\n');
    fs::write(path, text)
}

/// `640x480`.
fn parse_size(text: &str) -> Result<(u32, u32), String> {
    let side = |s: &str| s.parse::<u32>().ok().filter(|n| (1..=65536).contains(n));
    text.split_once(['x', 'X'])
        .and_then(|(w, h)| side(w).zip(side(h)))
        .ok_or_else(|| "expected a width and a height from 1 to 65536, like 640x480".to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes() {
        assert_eq!(parse_size("320x200"), Ok((320, 200)));
        for wrong in ["320", "0x200", "320x-1", "320x200x1", "99999x1"] {
            assert!(parse_size(wrong).is_err(), "{wrong}");
        }
    }
}
