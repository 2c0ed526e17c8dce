//! Running other programs.

use std::ffi::OsStr;
use std::io::{self, Read};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output, Stdio};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

use sysinfo::{Pid, ProcessRefreshKind, ProcessesToUpdate, System};

/// Another program, by its path.
#[derive(Debug, Clone)]
pub struct Program {
    pub path: PathBuf,
    /// The time that a run may take; `None` for no limit.
    pub limit: Option<Duration>,
}

impl Program {
    /// Makes a program without a limit of time.
    pub fn new(path: impl Into<PathBuf>) -> Program {
        Program {
            path: path.into(),
            limit: None,
        }
    }
}

/// The reason why another program gives no answer.
#[derive(Debug)]
pub enum ProgramError {
    /// A program that does not exist.
    Missing,
    /// The program cannot be started.
    Start(io::Error),
    /// The program's files cannot be written or read.
    Io(io::Error),
    /// The program has failed. The text has its last lines, or its exit status if it has written nothing.
    Failed(String),
    /// The program was ended, since it has taken longer than this limit.
    Late(Duration),
    /// The program's output is not what was asked for; the text says why.
    Unexpected(&'static str),
}

impl From<io::Error> for ProgramError {
    fn from(e: io::Error) -> ProgramError {
        ProgramError::Io(e)
    }
}

/// The number of a failed program's last lines that [`ProgramError::Failed`] quotes.
const LINES: usize = 12;

/// A lock that is held while a program is started. [`exit`] takes the lock and keeps it until this process ends: no
/// further program starts, and no program that it ends is reported as failed.
static STARTING: Mutex<()> = Mutex::new(());

fn starting() -> MutexGuard<'static, ()> {
    STARTING.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Ends all programs that this process runs, then this process with a status.
pub fn exit(status: u8) -> ! {
    let _last = starting();
    end_those_of(std::process::id());
    std::process::exit(status.into())
}

/// Ends all descendants of a process: the programs that it has started, and those that they have started. The process
/// itself goes on.
pub fn end_those_of(process: u32) {
    let system = processes();
    for (&pid, program) in system.processes() {
        if is_of(&system, pid, process) {
            program.kill();
        }
    }
}

/// Ends a program and all its descendants.
fn end(child: &mut Child) {
    let system = processes();
    // The program itself is killed first, so that it starts no others. The list of its descendants is made already.
    let _ = child.kill();
    for (&pid, program) in system.processes() {
        if is_of(&system, pid, child.id()) {
            program.kill();
        }
    }
}

fn processes() -> System {
    let mut system = System::new();
    // Threads are left out: the library would list them as processes, whose parent is their own process.
    let what = ProcessRefreshKind::nothing().without_tasks();
    system.refresh_processes_specifics(ProcessesToUpdate::All, true, what);
    system
}

/// Whether `pid` is a descendant of `process`: started by it, or by one of its descendants.
fn is_of(system: &System, pid: Pid, process: u32) -> bool {
    let top = Pid::from_u32(process);
    let parent = |pid: Pid| system.process(pid).and_then(|p| p.parent());
    // Numbers of ended processes are used again, so that parents may form a circle. No process has more ancestors than
    // there are processes.
    let ancestors = std::iter::successors(parent(pid), |&pid| parent(pid));
    let mut ancestors = ancestors.take(system.processes().len());
    pid != top && ancestors.any(|pid| pid == top)
}

/// Runs a program in a folder and waits for it.
pub(super) fn run<S: AsRef<OsStr>>(
    program: &Program,
    folder: &Path,
    arguments: &[S],
) -> Result<(), ProgramError> {
    let mut command = Command::new(&program.path);
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
    let output = wait(child, program.limit)?;
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

/// The time between two looks at whether a program has ended.
const LOOK: Duration = Duration::from_millis(10);

/// Waits for the end of a program, or ends the program when its time is over.
fn wait(mut child: Child, limit: Option<Duration>) -> Result<Output, ProgramError> {
    let Some(limit) = limit else {
        return child.wait_with_output().map_err(ProgramError::Start);
    };
    let start = Instant::now();
    let (stdout, stderr) = (child.stdout.take(), child.stderr.take());
    thread::scope(|scope| {
        // Both pipes are read meanwhile, since a program waits while its pipe is full.
        let stdout = scope.spawn(|| all_of(stdout));
        let stderr = scope.spawn(|| all_of(stderr));
        let status = loop {
            match child.try_wait() {
                Ok(Some(status)) => break Ok(status),
                Ok(None) if start.elapsed() < limit => thread::sleep(LOOK),
                Ok(None) => break Err(ProgramError::Late(limit)),
                Err(e) => break Err(ProgramError::Start(e)),
            }
        };
        if status.is_err() {
            end(&mut child);
            let _ = child.wait();
        }
        Ok(Output {
            status: status?,
            stdout: stdout.join().unwrap_or_default(),
            stderr: stderr.join().unwrap_or_default(),
        })
    })
}

/// The bytes of a pipe, as far as they can be read.
fn all_of(pipe: Option<impl Read>) -> Vec<u8> {
    let mut bytes = Vec::new();
    let _ = pipe.map(|mut pipe| pipe.read_to_end(&mut bytes));
    bytes
}
