//! The options of `zpg render` that a job passes on, as they were written.

use std::path::Path;

use clap::parser::ValueSource;
use clap::{ArgMatches, Args, Command};

use crate::commands::atomic_file;
use crate::commands::frames::FrameArgs;
use crate::commands::render::options::PictureArgs;
use crate::commands::shell::quoted;
use crate::diagnostics::Complaint;

/// The table of frames in the folder of the job.
const TABLE: &str = "table.csv";

/// Options that the scripts of the job give each task, and that are not passed on.
const OF_TASKS: [&str; 2] = ["only", "fps"];

/// The options about pictures in the arguments of this program, as a shell reads them. `command` is the command line of
/// the whole program.
pub(super) fn given(command: Command) -> String {
    // The arguments have been read once without an error, so they can be read again.
    let all = command.get_matches_from(std::env::args_os());
    let Some((_, matches)) = all.subcommand() else {
        return String::new();
    };
    let known = PictureArgs::augment_args(Command::new("render"));
    let written = known.get_arguments().filter_map(|arg| {
        let name = arg.get_long()?;
        let id = arg.get_id().as_str();
        let is_given = matches.value_source(id) == Some(ValueSource::CommandLine);
        (is_given && !OF_TASKS.contains(&name)).then(|| option(name, id, matches))
    });
    written.collect::<Vec<_>>().join(" ")
}

/// An option with all its values.
fn option(name: &str, id: &str, matches: &ArgMatches) -> String {
    let values = matches.get_raw(id).into_iter().flatten();
    let written = values.map(|value| match name {
        "frames-from" => format!("--{name} {TABLE}"),
        _ => format!("--{name}={}", quoted(&value.to_string_lossy())),
    });
    written.collect::<Vec<_>>().join(" ")
}

/// Copies the table of frames, if there is one.
pub(super) fn copy_table(frames: &FrameArgs, job: &Path) -> Result<(), Complaint> {
    let Some(table) = frames.table() else {
        return Ok(());
    };
    let bytes = std::fs::read(table).map_err(|e| {
        Complaint::new("cannot-read")
            .with("path", table)
            .with("reason", Complaint::from(&e))
    })?;
    atomic_file::write(&job.join(TABLE), |out| out.write_all(&bytes))
}
