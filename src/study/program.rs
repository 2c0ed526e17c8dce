//! Running other programs.

use std::ffi::OsStr;
use std::io;
use std::path::Path;
use std::process::{Command, Stdio};
use std::sync::{Mutex, MutexGuard, PoisonError};

use sysinfo::{Pid, ProcessRefreshKind, ProcessesToUpdate, System};

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

/// Held while a program is started. Whoever ends this process keeps it, so that none is started any more, and that of
/// those which have been ended nothing is said.
static STARTING: Mutex<()> = Mutex::new(());

fn starting() -> MutexGuard<'static, ()> {
    STARTING.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Ends this process with a status, and all programs that it runs.
pub fn exit(status: u8) -> ! {
    let _last = starting();
    end_those_of(std::process::id());
    std::process::exit(status.into())
}

/// Ends the programs that a process has started, and those that they have; not the process itself.
pub fn end_those_of(process: u32) {
    let mut system = System::new();
    // Threads would be processes to the library, whose parent is their own.
    let what = ProcessRefreshKind::nothing().without_tasks();
    system.refresh_processes_specifics(ProcessesToUpdate::All, true, what);
    let top = Pid::from_u32(process);
    let parent = |pid: Pid| system.process(pid).and_then(|p| p.parent());
    let is_one = |pid: Pid| {
        // A process cannot have more ancestors than there are processes: numbers are used again.
        let ancestors = std::iter::successors(parent(pid), |&pid| parent(pid));
        let mut ancestors = ancestors.take(system.processes().len());
        pid != top && ancestors.any(|pid| pid == top)
    };
    for (&pid, program) in system.processes() {
        if is_one(pid) {
            program.kill();
        }
    }
}

/// Runs a program in a folder and waits for it.
pub(super) fn run<S: AsRef<OsStr>>(
    program: &Path,
    folder: &Path,
    arguments: &[S],
) -> Result<(), ProgramError> {
    let mut command = Command::new(program);
    let command = (command.args(arguments).current_dir(folder))
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped());
    let child = {
        let _one = starting();
        command.spawn().map_err(|e| match e.kind() {
            io::ErrorKind::NotFound => ProgramError::Missing,
            _ => ProgramError::Start(e),
        })?
    };
    let output = child.wait_with_output().map_err(ProgramError::Start)?;
    drop(starting());
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
