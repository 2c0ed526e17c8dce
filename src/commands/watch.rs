//! Repeats work whenever a scene changes.

use std::collections::HashSet;
use std::io::{self, IsTerminal, Write};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{self, Receiver, RecvTimeoutError};
use std::time::Duration;

use notify::{Event, EventKind, RecursiveMode, Watcher};

use crate::analysis::file::STDIN;
use crate::commands::terminal::{is_unread, tell};
use crate::commands::{LookChoice, Status, complain};
use crate::diagnostics::Complaint;

/// The time without events that must pass before a changed file is read, since an editor writes it in several steps. It
/// is also how often the command checks whether it is to stop.
const QUIET_TIME: Duration = Duration::from_millis(100);

/// Runs `work` now and after every change of a scene, of a picture that scenes name, or of settings, until `stop` is
/// set or nobody reads standard output any more. Changes of files for which `is_made` is true do not count: the work
/// has written these files.
pub(super) fn run(
    paths: &[PathBuf],
    look: LookChoice,
    stop: &AtomicBool,
    is_made: impl Fn(&Path) -> bool,
    work: impl Fn() -> Status,
) -> Status {
    if paths.iter().any(|p| p.as_os_str() == STDIN) {
        complain(look, &Complaint::new("stdin-not-watched"));
        return Status::Failure;
    }
    let (sender, changes) = mpsc::channel();
    let watcher = notify::recommended_watcher(move |event: notify::Result<Event>| {
        // When nobody listens any more, the program is at its end.
        let _ = sender.send(event);
    });
    let watched = watcher.and_then(|mut watcher| {
        for (folder, mode) in folders(paths) {
            watcher.watch(&folder, mode)?;
        }
        Ok(watcher)
    });
    let _watcher = match watched {
        Ok(watcher) => watcher,
        Err(e) => {
            complain(look, &unwatchable(&e));
            return Status::Failure;
        }
    };
    loop {
        if io::stdout().is_terminal() {
            let _ = write!(io::stdout(), "\x1b[2J\x1b[H");
        }
        let status = work();
        if is_unread() || stop.load(Ordering::Relaxed) {
            return status;
        }
        if !look.quiet {
            tell(&look.language().say("watching", &[]));
        }
        match wait(&changes, look, stop, &is_made) {
            Some(true) => {}
            Some(false) => return Status::Interrupted,
            None => return Status::Failure,
        }
    }
}

fn unwatchable(error: &notify::Error) -> Complaint {
    Complaint::new("cannot-watch").with("reason", error.to_string())
}

/// The folders to watch. A folder is watched with all its subfolders. For a file its folder is watched, since editors
/// put a new file in the place of the old one.
fn folders(paths: &[PathBuf]) -> HashSet<(PathBuf, RecursiveMode)> {
    let of = |path: &PathBuf| match path.is_dir() {
        true => (path.clone(), RecursiveMode::Recursive),
        false => match path.parent().filter(|p| !p.as_os_str().is_empty()) {
            Some(folder) => (folder.to_owned(), RecursiveMode::NonRecursive),
            None => (PathBuf::from("."), RecursiveMode::NonRecursive),
        },
    };
    paths.iter().map(of).collect()
}

/// Waits until something has changed and it is quiet again. `Some(true)`: something has changed. `Some(false)`: `stop`
/// is set. `None`: the watcher has ended, and no event will come any more.
fn wait(
    changes: &Receiver<notify::Result<Event>>,
    look: LookChoice,
    stop: &AtomicBool,
    is_made: &dyn Fn(&Path) -> bool,
) -> Option<bool> {
    loop {
        match changes.recv_timeout(QUIET_TIME) {
            _ if stop.load(Ordering::Relaxed) => return Some(false),
            Ok(Ok(event)) if matters(&event, is_made) => break,
            Ok(Err(e)) => complain(look, &unwatchable(&e)),
            Ok(_) | Err(RecvTimeoutError::Timeout) => {}
            Err(RecvTimeoutError::Disconnected) => return None,
        }
    }
    while changes.recv_timeout(QUIET_TIME).is_ok() {}
    Some(true)
}

/// Whether an event may change the result of the work. Reading a file does not, nor does a file that the work has made.
fn matters(event: &Event, is_made: &dyn Fn(&Path) -> bool) -> bool {
    let kind = !matches!(event.kind, EventKind::Access(_));
    let file = |path: &PathBuf| is_read(path) && !is_made(path);
    kind && event.paths.iter().any(file)
}

/// Whether the work may read a file, by its name: a scene, a picture that a scene may name, or settings.
fn is_read(path: &Path) -> bool {
    let extensions = ["zpg", "json", "png", "jpg", "jpeg"];
    let extension = path.extension().and_then(|e| e.to_str()).unwrap_or("");
    let settings = path.file_name().is_some_and(|n| n == "zpg.toml");
    settings || extensions.iter().any(|e| extension.eq_ignore_ascii_case(e))
}
