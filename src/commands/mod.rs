//! One file per subcommand of the command line. Each has `Args`, derived for clap, and `run`, which
//! returns the exit [`Status`].
//!
//! What they share: [`belongings`] of files stay theirs, [`camera`] says who takes the picture, [`canvas`] has text on
//! pictures, [`load`] loads a scene and says why a command refuses, [`paths`] expands folders, [`difference`] shows how
//! a file would change, [`atomic_file`] writes files that appear when they are complete, [`endings`] refuses names that say
//! something else than what is written, [`frames`] says which pictures a scene with varying numbers has, [`help`] gives
//! `--help` in other languages, [`language`] chooses one, [`memory`] says how much memory and how many threads may be
//! taken, [`rewrite`] changes files, [`settings`] finds the scenes and settings of a run, [`size`] reads `640x480`,
//! [`shell`] quotes words, [`refuse_overwrite`] keeps files that are read from being written over, [`terminal`] knows about colour and about output that nobody
//! reads any more, [`time`] reads `90s`, [`topics`] are pages of `explain`, [`usage`] says what is wrong with
//! arguments, [`watch`] does something again when a scene changes.

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
