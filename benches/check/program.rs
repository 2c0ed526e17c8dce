//! Other programs, and this one as others run it.

use std::ffi::{OsStr, OsString};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

/// A program with its arguments.
pub struct Run {
    program: OsString,
    arguments: Vec<OsString>,
    variables: Vec<(&'static str, &'static str)>,
}

impl Run {
    pub fn new(program: &str) -> Run {
        Run {
            program: program.into(),
            arguments: Vec::new(),
            variables: Vec::new(),
        }
    }

    pub fn zpg() -> Run {
        Run::new(env!("CARGO_BIN_EXE_zpg"))
    }

    pub fn arg(mut self, argument: impl AsRef<OsStr>) -> Run {
        self.arguments.push(argument.as_ref().into());
        self
    }

    pub fn args<const N: usize>(self, arguments: [&str; N]) -> Run {
        arguments.into_iter().fold(self, Run::arg)
    }

    pub fn env(mut self, name: &'static str, value: &'static str) -> Run {
        self.variables.push((name, value));
        self
    }

    fn command(&self) -> Command {
        let mut command = Command::new(&self.program);
        command
            .args(&self.arguments)
            .envs(self.variables.iter().copied())
            .stdin(Stdio::null())
            .stdout(Stdio::null())
            .stderr(Stdio::null());
        command
    }

    /// Wall time; `None` if there is no such program.
    pub fn seconds(&self) -> Option<f64> {
        let start = Instant::now();
        self.command().status().ok()?;
        Some(start.elapsed().as_secs_f64())
    }

    /// As [`seconds`](Self::seconds), of a program that is stopped after so many seconds.
    pub fn at_most(&self, seconds: f64) -> Outcome {
        let start = Instant::now();
        let Ok(mut child) = self.command().spawn() else {
            return Outcome::Absent;
        };
        while child.try_wait().expect("it is a child").is_none() {
            if start.elapsed().as_secs_f64() > seconds {
                child.kill().expect("it runs");
                child.wait().expect("it is a child");
                return Outcome::Stopped;
            }
            std::thread::sleep(Duration::from_millis(1));
        }
        Outcome::Done(start.elapsed().as_secs_f64())
    }

    /// Wall time in seconds, and the most memory that was resident in KiB, looked at every millisecond.
    pub fn measured(&self) -> (f64, f64) {
        let start = Instant::now();
        let mut child = self.command().spawn().expect("zpg runs");
        let status = format!("/proc/{}/status", child.id());
        let mut most = 0.0f64;
        loop {
            let text = std::fs::read_to_string(&status).unwrap_or_default();
            let line = text.lines().find_map(|l| l.strip_prefix("VmHWM:"));
            let peak = line.and_then(|l| l.split_whitespace().next()?.parse().ok());
            most = most.max(peak.unwrap_or(0.0));
            if child.try_wait().expect("it is a child").is_some() {
                return (start.elapsed().as_secs_f64(), most);
            }
            std::thread::sleep(Duration::from_millis(1));
        }
    }
}

/// What became of a program; see [`Run::at_most`].
pub enum Outcome {
    /// Wall time in seconds.
    Done(f64),
    Stopped,
    /// There is no such program.
    Absent,
}

/// The middle one.
pub fn median(mut all: Vec<f64>) -> f64 {
    all.sort_by(f64::total_cmp);
    all.get(all.len() / 2).copied().unwrap_or(f64::NAN)
}
