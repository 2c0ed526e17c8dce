//! Running other programs.

use std::ffi::OsStr;
use std::io;
use std::path::Path;
use std::process::{Command, Stdio};

/// Why another program gives no answer.
#[derive(Debug)]
pub enum ProgramError {
    /// There is no such program.
    Missing,
    /// It cannot be started.
    Start(io::Error),
    /// Its files cannot be written or read.
    Io(io::Error),
    /// It has failed; the end of what it says.
    Failed(String),
    /// What it has written is not what it was asked for.
    Unexpected(&'static str),
}

impl From<io::Error> for ProgramError {
    fn from(e: io::Error) -> ProgramError {
        ProgramError::Io(e)
    }
}

/// How many of a program's last lines are told.
const LINES: usize = 12;

/// Runs a program in a folder and waits for it.
pub(super) fn run<S: AsRef<OsStr>>(
    program: &Path,
    folder: &Path,
    arguments: &[S],
) -> Result<(), ProgramError> {
    let output = Command::new(program)
        .args(arguments)
        .current_dir(folder)
        .stdin(Stdio::null())
        .output()
        .map_err(|e| match e.kind() {
            io::ErrorKind::NotFound => ProgramError::Missing,
            _ => ProgramError::Start(e),
        })?;
    if output.status.success() {
        return Ok(());
    }
    let said = [output.stdout, output.stderr].concat();
    let said = String::from_utf8_lossy(&said);
    let lines: Vec<&str> = said.lines().filter(|l| !l.trim().is_empty()).collect();
    if lines.is_empty() {
        return Err(ProgramError::Failed(output.status.to_string()));
    }
    let last = lines.len().saturating_sub(LINES);
    Err(ProgramError::Failed(lines[last..].join("\n")))
}
