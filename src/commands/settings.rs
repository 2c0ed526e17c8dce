//! Which files of settings count, and which files of scenes.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::Status;
use super::help;
use super::paths::{self, Files};
use super::terminal::{self, LookChoice, complain};
use crate::analysis::config::Configs;
use crate::analysis::file;

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
    /// Finds the scenes. What is wrong with the settings of the command line is said, and then there are none.
    pub fn scenes(&self, stdin: Option<&Path>, look: LookChoice) -> Option<Scenes> {
        let configs = match Configs::chosen(&self.config, &self.exclude, self.isolated) {
            Ok(configs) => Arc::new(configs),
            Err(complaint) => {
                complain(look, &complaint);
                return None;
            }
        };
        let mut files = match self.paths.is_empty() {
            true => {
                let mut found = paths::expand(&self.roots(), &configs, look);
                // Nobody has written the dot.
                for file in &mut found.files {
                    if let Ok(plain) = file.strip_prefix(".") {
                        *file = plain.to_owned();
                    }
                }
                found
            }
            false => paths::expand(&self.paths, &configs, look),
        };
        if self.force_exclude {
            // What standard input goes by is excluded as a file of this name is.
            files.files.retain(|file| match paths::is_stdin(file) {
                true => stdin.is_none_or(|name| !paths::is_excluded(&configs, name)),
                false => !paths::is_excluded(&configs, file),
            });
        }
        Some(Scenes { files, configs })
    }

    /// The files and folders that the run is about.
    pub fn roots(&self) -> Vec<PathBuf> {
        match self.paths.is_empty() {
            true => vec![PathBuf::from(".")],
            false => self.paths.clone(),
        }
    }

    /// Whether a scene comes from standard input.
    pub fn reads_stdin(&self) -> bool {
        self.paths.iter().any(|p| paths::is_stdin(p))
    }
}

/// A scene from standard input that the settings exclude goes on as it is, where it is printed at all.
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
