//! `zpg new`: a scene to start with.

use std::path::{Path, PathBuf};

use super::paths::is_stdout;
use super::shell::quoted;
use super::terminal::{self, LookChoice, complain};
use super::{Status, atomic_file, endings};
use crate::diagnostics::{Complaint, Language};

/// Write a scene to start with
#[derive(Debug, clap::Args)]
#[command(after_help = "\
The scene has at most twenty lines, with comments in the language of messages. It passes `zpg check` and
`zpg fmt --check`, and `zpg render` draws it. A file that is there already is left as it is.

Examples:
  zpg new scene.zpg
  zpg new window.zpg --from glass
  zpg new - --from bracket | zpg render - -o bracket.png")]
pub struct Args {
    /// The scene's file, which ends in .zpg; `-` is standard output
    #[arg(value_name = "FILE")]
    file: PathBuf,

    /// What the scene shows; a mirror, a ring and a ball if not given
    #[arg(long, value_enum)]
    from: Option<Template>,

    /// Write over a file that is there already
    #[arg(long)]
    force: bool,
}

/// A scene to start with.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub(super) enum Template {
    /// Glass and amber on a chessboard, with light that goes through
    Glass,
    /// A machine part: solids joined and cut
    Bracket,
    /// Two pawns, bodies of revolution, on a polished board
    Chessboard,
    /// Two rings and a mirror for a pair of cameras
    Stereo,
}

/// The scene of this name with comments in each language: the records are the same.
macro_rules! scene {
    ($name:literal) => {
        [
            include_str!(concat!($name, ".zpg")),
            include_str!(concat!($name, ".cs.zpg")),
        ]
    };
}

/// The scene of a template, or the usual one, with comments in a language.
fn scene(template: Option<Template>, language: Language) -> &'static str {
    let [english, czech] = match template {
        None => scene!("scene"),
        Some(Template::Glass) => scene!("glass"),
        Some(Template::Bracket) => scene!("bracket"),
        Some(Template::Chessboard) => scene!("chessboard"),
        Some(Template::Stereo) => scene!("stereo"),
    };
    match language {
        Language::English => english,
        Language::Czech => czech,
    }
}

/// Writes the scene, and says how it is drawn.
pub fn run(args: &Args, look: LookChoice) -> Status {
    let language = look.language();
    let text = scene(args.from, language);
    let written = may_write(args)
        .and_then(|()| atomic_file::write(&args.file, |out| out.write_all(text.as_bytes())));
    if let Err(complaint) = written {
        complain(look, &complaint);
        return Status::Failure;
    }
    if look.quiet || is_stdout(&args.file) || is_device(&args.file) {
        return Status::Clean;
    }
    let said = Complaint::new("wrote-scene")
        .with("path", args.file.as_path())
        .with("file", quoted(&args.file.to_string_lossy()));
    let line = said.wording(language);
    terminal::print(look, Status::Clean, |out| writeln!(out, "{line}"))
}

/// Whether a path leads to something that exists and is no regular file.
fn is_device(path: &Path) -> bool {
    path.metadata().is_ok_and(|found| !found.is_file())
}

/// Refuses a file name that does not end in .zpg, and a file that exists unless `--force` is given.
fn may_write(args: &Args) -> Result<(), Complaint> {
    let path = args.file.as_path();
    if is_stdout(path) || is_device(path) {
        return Ok(());
    }
    let ending = path.extension().unwrap_or_default();
    if !ending.eq_ignore_ascii_case("zpg") {
        // Text behind a dot may be part of the name, unless it is the ending of another format.
        endings::fits(path, &["zpg"])?;
        let mut right = match ending.eq_ignore_ascii_case("txt") {
            true => path.with_extension("").into_os_string(),
            false => path.as_os_str().to_owned(),
        };
        right.push(".zpg");
        return Err(Complaint::new("scene-name")
            .with("path", path)
            .with("right", Path::new(&right)));
    }
    match path.symlink_metadata() {
        Ok(_) if !args.force => Err(Complaint::new("file-is-there").with("path", path)),
        _ => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use clap::ValueEnum as _;

    use super::*;
    use crate::analysis::Analysis;

    /// Every scene is short, right and laid out, and the same in both languages but for its comments.
    #[test]
    fn scenes_are_right() {
        let templates = Template::value_variants().iter().copied().map(Some);
        for template in templates.chain([None]) {
            let mut records = Vec::new();
            for language in [Language::English, Language::Czech] {
                let text = scene(template, language);
                assert!(text.lines().count() <= 20, "{template:?}");
                let analysis = Analysis::new("a.zpg", text.into());
                assert_eq!(analysis.findings(), [], "{template:?}");
                let numbers = |line: &str| line.split('#').next().unwrap_or("").trim().to_owned();
                let commented = text.lines().filter(|line| line.contains('#')).count();
                assert!(commented >= 15, "{template:?}");
                records.push(text.lines().map(numbers).collect::<Vec<_>>());
            }
            assert_eq!(records[0], records[1], "{template:?}");
        }
    }
}
