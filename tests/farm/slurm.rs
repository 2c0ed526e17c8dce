//! A Slurm of one node on this machine, without systemd and cgroups, in a folder and on ports of its own.

use std::fs;
use std::net::TcpListener;
use std::os::unix::fs::PermissionsExt as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::time::{Duration, Instant};

/// Runs while it is kept.
pub struct Slurm {
    folder: tempfile::TempDir,
}

/// The programs that run in the background, by their files with the number of the process, in the order of their end.
const DAEMONS: [&str; 3] = ["slurmd.pid", "slurmctld.pid", "munged.pid"];

/// More processors than there may be: tasks begin at once. Requeued tasks wait for `cred_expire` and two minutes more
/// unless it is short.
const CONFIG: &str = "\
ClusterName=zpg
SlurmctldHost=HOST(127.0.0.1)
SlurmUser=USER
SlurmdUser=USER
AuthInfo=cred_expire=5,socket=FOLDER/munge.socket
CredType=cred/munge
SlurmctldPort=PORT1
SlurmdPort=PORT2
SlurmctldPidFile=FOLDER/slurmctld.pid
SlurmdPidFile=FOLDER/slurmd.pid
SlurmdSpoolDir=FOLDER/spool
StateSaveLocation=FOLDER/state
SlurmctldLogFile=FOLDER/slurmctld.log
SlurmdLogFile=FOLDER/slurmd.log
MpiDefault=none
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
ReturnToService=2
SlurmdParameters=config_overrides
SchedulerType=sched/backfill
SchedulerParameters=sched_min_interval=100000,sched_interval=1,bf_interval=1
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU_Memory
NodeName=HOST NodeAddr=127.0.0.1 CPUs=CORES RealMemory=8000 State=UNKNOWN
PartitionName=all Nodes=HOST Default=YES MaxTime=INFINITE State=UP
";

impl Slurm {
    /// Starts it, with so many processors, and waits for its node.
    pub fn start(cores: u32) -> Slurm {
        let folder = tempfile::tempdir().expect("there is room for temporary files");
        let slurm = Slurm { folder };
        // Others may ask munged, and only it reads its key.
        slurm.set_mode("", 0o755);
        let key: Vec<u8> = (0..1024).map(|i| (i * i % 251) as u8).collect();
        fs::write(slurm.path("munge.key"), key).expect("the folder is new");
        slurm.set_mode("munge.key", 0o400);
        for name in ["spool", "state"] {
            fs::create_dir(slurm.path(name)).expect("the folder is new");
        }
        let config = CONFIG
            .replace("HOST", said(Command::new("hostname").arg("-s")).trim())
            .replace("USER", said(Command::new("id").arg("-un")).trim())
            .replace(
                "FOLDER",
                slurm.folder.path().to_str().expect("a plain path"),
            )
            .replace("CORES", &cores.to_string())
            .replace("PORT1", &free_port())
            .replace("PORT2", &free_port());
        fs::write(slurm.path("slurm.conf"), config).expect("the folder is new");
        let mut munged = slurm.command("munged");
        for (option, name) in [
            ("--key-file", "munge.key"),
            ("--socket", "munge.socket"),
            ("--pid-file", "munged.pid"),
            ("--log-file", "munged.log"),
            ("--seed-file", "munged.seed"),
        ] {
            munged.arg(option).arg(slurm.path(name));
        }
        said(&mut munged);
        said(slurm.command("slurmctld").arg("-c"));
        said(&mut slurm.command("slurmd"));
        slurm.wait_for(Duration::from_secs(60), "an idle node", || {
            let states = slurm.command("sinfo").args(["-h", "-o", "%T"]).output();
            states.is_ok_and(|run| run.stdout.starts_with(b"idle"))
        });
        slurm
    }

    /// A program of Slurm, or one that runs them.
    pub fn command(&self, program: &str) -> Command {
        let mut command = Command::new(program);
        let path = std::env::var("PATH").unwrap_or_default();
        command
            .env("SLURM_CONF", self.path("slurm.conf"))
            // Debian keeps the daemons where only root looks.
            .env("PATH", format!("{path}:/usr/sbin:/sbin"));
        command
    }

    /// What a program of Slurm says, which succeeds.
    pub fn says(&self, program: &str, arguments: &[&str]) -> String {
        said(self.command(program).args(arguments))
    }

    /// Waits until no job is queued or runs.
    pub fn wait_for_all(&self, longest: Duration) {
        self.wait_for(longest, "the end of all jobs", || {
            self.says("squeue", &["-h"]).trim().is_empty()
        });
    }

    /// Waits until something is so.
    pub fn wait_for(&self, longest: Duration, what: &str, is_so: impl Fn() -> bool) {
        let start = Instant::now();
        while !is_so() {
            let log = || fs::read_to_string(self.path("slurmctld.log")).unwrap_or_default();
            assert!(
                start.elapsed() < longest,
                "no {what} in {longest:?}: {}",
                log()
            );
            std::thread::sleep(Duration::from_millis(100));
        }
    }

    fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    fn set_mode(&self, name: &str, mode: u32) {
        fs::set_permissions(self.path(name), fs::Permissions::from_mode(mode)).expect("it is ours");
    }
}

impl Drop for Slurm {
    fn drop(&mut self) {
        for name in DAEMONS {
            end(&self.path(name));
        }
    }
}

/// Ends the process of this file, and waits for that.
fn end(file: &Path) {
    let Ok(number) = fs::read_to_string(file) else {
        return;
    };
    let number = number.trim();
    let _ = Command::new("kill").arg(number).status();
    let start = Instant::now();
    while Path::new("/proc").join(number).exists() && start.elapsed() < Duration::from_secs(10) {
        std::thread::sleep(Duration::from_millis(20));
    }
}

fn free_port() -> String {
    let listener = TcpListener::bind("127.0.0.1:0").expect("there is a free port");
    listener
        .local_addr()
        .expect("it is bound")
        .port()
        .to_string()
}

/// What a program says, which succeeds.
fn said(command: &mut Command) -> String {
    let run = command.output();
    let run: Output = run.unwrap_or_else(|e| {
        panic!("{command:?}: {e}: slurm-wlm and munge are missing; tests/run installs them")
    });
    let text = String::from_utf8_lossy(&run.stdout).into_owned();
    let error = String::from_utf8_lossy(&run.stderr);
    assert!(run.status.success(), "{command:?}: {text}{error}");
    text
}
