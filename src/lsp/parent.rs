//! Ends the server after the program that started it has ended.

use std::thread;
use std::time::Duration;

use sysinfo::{Pid, ProcessRefreshKind, ProcessesToUpdate, System};

/// Time between two looks at the parent process.
const STEP: Duration = Duration::from_secs(1);

/// Ends this program soon after the process with this number has ended, unless it ends by itself. `stop` is called
/// first.
pub(super) fn end_with(process: u32, stop: impl FnOnce() + Send + 'static) {
    thread::spawn(move || {
        let pid = Pid::from_u32(process);
        let mut system = System::new();
        let mut is_alive = || {
            let which = ProcessesToUpdate::Some(&[pid]);
            system.refresh_processes_specifics(which, true, ProcessRefreshKind::nothing());
            system
                .process(pid)
                .is_some_and(|p| p.status() != sysinfo::ProcessStatus::Zombie)
        };
        // A process that cannot be seen from here, as from within a container, is not watched.
        if !is_alive() {
            return;
        }
        while is_alive() {
            thread::sleep(STEP);
        }
        stop();
        std::process::exit(1);
    });
}
