//! A program that never ends by itself, and starts another one that does not.

use std::fs;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use sysinfo::{Pid, ProcessRefreshKind, ProcessStatus, ProcessesToUpdate, System};

/// How long it may take to start or to end.
const TIMEOUT: Duration = Duration::from_secs(30);

pub struct Endless {
    pub path: PathBuf,
    /// Where the numbers of both processes are, once they run.
    numbers: PathBuf,
}

impl Endless {
    pub fn new(folder: &Path, name: &str) -> Endless {
        let path = folder.join(name);
        let numbers = folder.join(format!("{name}.numbers"));
        let to = numbers.to_str().expect("a path in UTF-8");
        let script =
            format!("#!/bin/sh\nsleep 1000 &\necho $$ $! > {to}.new\nmv {to}.new {to}\nwait\n");
        fs::write(&path, script).expect("a script");
        #[cfg(unix)]
        fs::set_permissions(&path, std::os::unix::fs::PermissionsExt::from_mode(0o755))
            .expect("a program");
        Endless { path, numbers }
    }

    pub fn wait_for_start(&self) {
        wait("it does not start", || self.numbers.exists());
    }

    pub fn wait_for_end(&self) {
        let text = fs::read_to_string(&self.numbers).expect("it has started");
        let numbers = text
            .split_whitespace()
            .map(|n| n.parse().expect("a number"));
        let pids: Vec<Pid> = numbers.map(Pid::from_u32).collect();
        assert_eq!(pids.len(), 2, "{text}");
        wait("it does not end", || {
            !pids.iter().any(|&pid| is_running(pid))
        });
    }
}

fn is_running(pid: Pid) -> bool {
    let mut system = System::new();
    let what = ProcessRefreshKind::nothing();
    system.refresh_processes_specifics(ProcessesToUpdate::Some(&[pid]), true, what);
    (system.process(pid)).is_some_and(|p| p.status() != ProcessStatus::Zombie)
}

fn wait(why: &str, is_over: impl Fn() -> bool) {
    let start = Instant::now();
    while !is_over() {
        assert!(start.elapsed() < TIMEOUT, "{why}");
        std::thread::sleep(Duration::from_millis(20));
    }
}
