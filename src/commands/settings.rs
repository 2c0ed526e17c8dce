//! The scene files of a run, and the settings that apply to them.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::Status;
use super::help;
use super::paths::{self, Files};
use super::terminal::{self, LookChoice, complain};
use crate::analysis::config::Configs;
use crate::analysis::file;
use crate::diagnostics::Complaint;

/// The arguments that `check` and `fmt` share.
#[derive(Debug, Clone, clap::Args)]
pub struct Chosen {
    /// Scene files or folders [default: .]; `-` is standard input
    #[arg(value_name = "PATH")]
    pub paths: Vec<PathBuf>,

    /// A file of settings that counts in place of every zpg.toml, or one setting that counts more than
    /// any file, such as `lint.W310=off`
    #[arg(help_heading = help::FILES)]
    #[arg(long, value_name = "FILE|KEY=VALUE")]
    config: Vec<String>,

    /// Leave out files and folders that fit this pattern, in place of what the settings exclude
    #[arg(help_heading = help::FILES)]
    #[arg(long, value_name = "PATTERN", value_delimiter = ',')]
    exclude: Vec<String>,

    /// Ignore every zpg.toml
    #[arg(help_heading = help::FILES)]
    #[arg(long)]
    isolated: bool,

    /// Leave out what the settings exclude even where a PATH names it
    #[arg(help_heading = help::FILES)]
    #[arg(long)]
    force_exclude: bool,
}

/// The scenes of a run, and their settings.
pub struct Scenes {
    pub files: Files,
    pub configs: Arc<Configs>,
}

impl Chosen {
    /// Finds the scenes of the run. `stdin` is the name that standard input goes by. `None` if the arguments or the
    /// settings of the command line are wrong; the complaint has been printed.
    pub fn scenes(&self, stdin: Option<&Path>, look: LookChoice) -> Option<Scenes> {
        let others = self.paths.iter().find(|path| !paths::is_stdin(path));
        if let (Some(other), Some(_)) = (others, stdin) {
            complain(
                look,
                &Complaint::new("stdin-and-path").with("path", other.as_path()),
            );
            return None;
        }
        let configs = match Configs::chosen(&self.config, &self.exclude, self.isolated) {
            Ok(configs) => Arc::new(configs),
            Err(complaint) => {
                complain(look, &complaint);
                return None;
            }
        };
        let roots = self.roots(stdin);
        let mut files = match self.paths.is_empty() {
            true => {
                let mut found = paths::expand(&roots, &configs, look);
                // The user has not written the `.`, and the names are shown without it.
                for file in &mut found.files {
                    if let Ok(plain) = file.strip_prefix(".") {
                        *file = plain.to_owned();
                    }
                }
                found
            }
            false => paths::expand(&roots, &configs, look),
        };
        if self.force_exclude {
            // Standard input is excluded if a file of the name that it goes by is.
            files.files.retain(|file| match paths::is_stdin(file) {
                true => stdin.is_none_or(|name| !paths::is_excluded(&configs, name)),
                false => !paths::is_excluded(&configs, file),
            });
        }
        if !self.isolated {
            note_misnamed(&files, look);
        }
        Some(Scenes { files, configs })
    }

    /// The files and folders to look for scenes in: the paths that are given. Without them it is standard input if it
    /// has a name, and else the current folder.
    pub fn roots(&self, stdin: Option<&Path>) -> Vec<PathBuf> {
        match (self.paths.is_empty(), stdin) {
            (true, Some(_)) => vec![PathBuf::from(file::STDIN)],
            (true, None) => vec![PathBuf::from(".")],
            (false, _) => self.paths.clone(),
        }
    }

    /// Whether a scene comes from standard input.
    pub fn reads_stdin(&self, stdin: Option<&Path>) -> bool {
        self.roots(stdin).iter().any(|path| paths::is_stdin(path))
    }
}

/// Notes files beside the scenes that are meant as settings and do not count: `.zpg.toml`, and `pyproject.toml` with a
/// table for zpg.
fn note_misnamed(files: &Files, look: LookChoice) {
    let folders: BTreeSet<&Path> = files
        .files
        .iter()
        .filter_map(|file| file.parent())
        .collect();
    for folder in folders {
        let named = folder.join("zpg.toml");
        if named.exists() {
            continue;
        }
        let hidden = folder.join(".zpg.toml");
        let python = folder.join("pyproject.toml");
        let found = [(hidden.is_file(), hidden), (has_table(&python), python)];
        for (_, path) in found.into_iter().filter(|(is_there, _)| *is_there) {
            let misnamed = Complaint::new("misnamed-settings").with("path", path.as_path());
            terminal::note(look, &misnamed.with("right", named.as_path()));
        }
    }
}

/// Whether a file has a table for zpg, as pyproject.toml has one for ruff: `[tool.zpg.lint]`.
fn has_table(path: &Path) -> bool {
    let text = std::fs::read_to_string(path).unwrap_or_default();
    let mut tables = text
        .lines()
        .filter_map(|line| line.trim().strip_prefix("[tool.zpg"));
    tables.any(|rest| rest.starts_with([']', '.']))
}

/// Copies a scene from standard input, which the settings exclude, to standard output as it is. If `is_printed` is
/// false, nothing is printed.
pub fn pass_through(is_printed: bool, look: LookChoice) -> Status {
    match file::read(Path::new(file::STDIN)) {
        Ok(_) if !is_printed => Status::Clean,
        Ok(bytes) => terminal::print(look, Status::Clean, |out| out.write_all(&bytes)),
        Err(complaint) => {
            complain(look, &complaint);
            Status::Failure
        }
    }
}
