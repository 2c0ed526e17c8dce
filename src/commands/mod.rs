//! One file per subcommand of the command line. Each has `Args`, derived for clap, and `run`, which
//! returns the exit [`Status`].
//!
//! Modules that the commands share: [`atomic_file`] writes files that appear when they are complete, [`belongings`]
//! copies a file's owner, permissions and attributes, [`camera`] chooses the camera, [`canvas`] writes text on
//! pictures, [`difference`] shows how a file would change, [`endings`] refuses a file name whose ending stands for
//! another format, [`frames`] makes the scene of each frame, [`help`] gives `--help` in other languages, [`language`]
//! chooses the language of messages, [`load`] loads a scene and says why a command refuses it, [`memory`] limits memory
//! and threads, [`paths`] expands folders, [`refuse_overwrite`] keeps files that are read from being written over,
//! [`rewrite`] changes files, [`settings`] finds the scenes and settings of a run, [`shell`] quotes words, [`size`]
//! reads `640x480`, [`terminal`] knows about colour and about a closed standard output, [`time`] reads `90s`,
//! [`topics`] are pages of `explain`, [`usage`] says what is wrong with arguments, [`watch`] repeats the work when a
//! scene changes.

pub mod accuracy;
mod apart;
pub mod atomic_file;
mod belongings;
mod camera;
mod canvas;
pub mod check;
pub mod cli;
pub mod completions;
pub mod convert;
pub mod crosscheck;
mod difference;
mod endings;
pub mod explain;
pub mod farm;
pub mod fmt;
pub mod frames;
mod habits;
mod help;
pub mod join;
mod language;
pub mod load;
pub mod lsp;
pub mod man;
pub mod memory;
pub mod new;
mod numbers;
mod page;
pub mod paths;
pub mod plan;
pub mod probe;
mod refuse_overwrite;
pub mod render;
mod rewrite;
pub mod settings;
pub mod sheet;
mod shell;
pub mod size;
pub mod terminal;
mod time;
mod topics;
pub mod usage;
mod watch;

pub use load::{Needs, load_for, load_valid, refuse};
pub use terminal::{LookChoice, complain, report};

/// How a command ended; its number is the exit status.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Status {
    /// Done and clean.
    Clean = 0,
    /// The scene has errors, or the answer is "no".
    Negative = 1,
    /// Wrong usage, unreadable or unwritable file.
    Failure = 2,
    /// Stopped by Ctrl-C: 128 and the number of the signal, as shells have it.
    Interrupted = 130,
}

impl From<Status> for std::process::ExitCode {
    fn from(status: Status) -> Self {
        std::process::ExitCode::from(status as u8)
    }
}
