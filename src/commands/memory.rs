//! How much memory and how many threads a command may take. Work that would need more memory is refused before it
//! begins.

use std::fs;
use std::path::Path;
use std::str::FromStr;
use std::sync::LazyLock;
use std::thread::available_parallelism;

use sysinfo::System;

use super::help;
use super::terminal::{LookChoice, warn};
use crate::analysis::file::{STDIN, unreadable};
use crate::diagnostics::Complaint;
use crate::scene::Scene;
use crate::trace::Tracer;

/// The bytes of memory that a scene takes for each byte of its file while it is read and checked. Measured on scenes of
/// short records, with mistakes and without: up to 60.
const PER_BYTE: u64 = 64;

/// The most threads for each processor: more are of no use.
const THREADS_PER_CORE: usize = 4;

#[derive(Debug, Clone, Copy, clap::Args)]
pub struct Memory {
    /// Refuse what would take more memory than this, such as 800M or 12G [default: half of what there is]
    #[arg(help_heading = help::LIMITS)]
    #[arg(long = "memory", value_name = "SIZE", allow_hyphen_values = true)]
    allowed: Option<Bytes>,
}

/// A number of bytes: `512M`, `12G`, `1.5G`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Bytes(u64);

const UNITS: [(char, u64); 4] = [
    ('T', 1 << 40),
    ('G', 1 << 30),
    ('M', 1 << 20),
    ('K', 1 << 10),
];

impl FromStr for Bytes {
    type Err = Complaint;

    fn from_str(text: &str) -> Result<Bytes, Complaint> {
        let wrong = || Complaint::new("expected-memory");
        let upper = text.trim().to_ascii_uppercase();
        let number = upper.strip_suffix('B').unwrap_or(&upper);
        let number = number.strip_suffix('I').unwrap_or(number);
        let unit = UNITS.iter().find(|(name, _)| number.ends_with(*name));
        let number = number.trim_end_matches(|c| unit.is_some_and(|u| u.0 == c));
        let count: f64 = number.trim().parse().map_err(|_| wrong())?;
        let bytes = count * unit.map_or(1, |u| u.1) as f64;
        match (1.0..1e18).contains(&bytes) {
            true => Ok(Bytes(bytes as u64)),
            false => Err(wrong()),
        }
    }
}

/// A number of bytes for people, rounded up to tenths: `12G`, `1.5G`.
fn spelled(bytes: f64) -> String {
    let unit = UNITS.iter().find(|u| bytes >= u.1 as f64);
    let (name, size) = unit.map_or((String::new(), 1.0), |u| (u.0.to_string(), u.1 as f64));
    let tenths = (bytes / size * 10.0).ceil() / 10.0;
    match bytes.is_finite() && bytes < 1e18 {
        true => format!("{tenths}{name}"),
        false => format!("{bytes:.1e}"),
    }
}

/// A count that may be huge, for people: `12`, `2^64`, `1.50e30`.
fn number(x: f64) -> String {
    let exponent = x.log2();
    match () {
        () if x < 1e6 => x.to_string(),
        () if exponent.fract() == 0.0 => format!("2^{exponent}"),
        () => format!("{x:.2e}"),
    }
}

impl Memory {
    /// The memory that is allowed, in bytes.
    fn bytes(self) -> u64 {
        self.allowed.map_or_else(|| *HALF, |b| b.0)
    }

    fn refused(self, what: &'static str, needed: f64) -> Complaint {
        Complaint::new(what)
            .with("needed", spelled(needed))
            .with("memory", spelled(self.bytes() as f64))
    }

    /// Refuses a file that is too long to be read as a scene. `at_a_time` files share the memory.
    pub fn admit(self, file: &Path, at_a_time: usize) -> Result<(), Complaint> {
        if file.as_os_str() == STDIN {
            return Ok(());
        }
        // A file whose length is unknown cannot be read either, and reading it complains.
        let length = fs::metadata(file).map_or(0, |m| m.len());
        let needed = length.saturating_mul(PER_BYTE);
        match needed <= self.bytes() / at_a_time.max(1) as u64 {
            true => Ok(()),
            false => Err(unreadable(
                file,
                self.refused("file-needs-memory", needed as f64),
            )),
        }
    }

    /// Refuses work that needs more than the allowed memory. `needed` is in bytes, `what` the message of the refusal.
    pub fn grant(self, needed: f64, what: &'static str) -> Result<(), Complaint> {
        match needed <= self.bytes() as f64 {
            true => Ok(()),
            false => Err(self.refused(what, needed)),
        }
    }

    /// The memory that triangles may take, in bytes.
    pub fn for_triangles(self) -> Option<u64> {
        Some(self.bytes())
    }

    /// Limits the memory that rays may take to a thread's share of what is left beside `taken` bytes. Refuses to begin
    /// if that is surely too little.
    pub fn confine(self, tracer: &mut Tracer, taken: f64, threads: usize) -> Result<(), Complaint> {
        let left = (self.bytes() as f64 - taken).max(0.0);
        let room = left / threads.max(1) as f64;
        match tracer.confine(room as u64) {
            true => Ok(()),
            false => Err(self.crowded(tracer)),
        }
    }

    /// The complaint that rays need too much memory, because many parts are in one place.
    pub fn crowded(self, tracer: &Tracer) -> Complaint {
        Complaint::new("too-many-parts-in-one-place")
            .with("parts", number(tracer.graph.occurrences()))
            .with("memory", spelled(self.bytes() as f64))
    }

    /// Refuses to answer if some ray has needed more memory than allowed.
    pub fn check(self, tracer: &Tracer) -> Result<(), Complaint> {
        match tracer.graph.room.is_exhausted() {
            true => Err(self.crowded(tracer)),
            false => Ok(()),
        }
    }

    /// Like [`confine`](Self::confine), for a scene that a translation traces on one thread.
    pub fn confine_scene(self, scene: &Scene) -> Result<(), Complaint> {
        match Tracer::new(scene) {
            Ok(mut tracer) => self.confine(&mut tracer, 0.0, 1),
            // A scene that cannot be traced needs no memory for rays.
            Err(_) => Ok(()),
        }
    }
}

/// Half of the memory that this process may use, in bytes.
static HALF: LazyLock<u64> = LazyLock::new(|| {
    let mut system = System::new();
    system.refresh_memory();
    memory_of(&system) / 2
});

/// The memory that this process may use, in bytes: the least of the machine's memory, the limit of the control group
/// and the limit of the address space.
fn memory_of(system: &System) -> u64 {
    // Without /proc the total is 0, and the limits of control groups must not be asked for.
    let all = Some(system.total_memory()).filter(|&bytes| bytes > 0);
    let group = all.and_then(|_| Some(system.cgroup_limits()?.total_memory));
    let known = [all, group, address_space()].into_iter().flatten();
    // If no limit is known: 8 GiB, which most machines have.
    known.filter(|&bytes| bytes > 0).min().unwrap_or(8 << 30)
}

/// The limit that `ulimit -v` sets, in bytes; `None` if there is none, or it is unknown.
fn address_space() -> Option<u64> {
    let limits = fs::read_to_string("/proc/self/limits").ok()?;
    let line = limits
        .lines()
        .find_map(|l| l.strip_prefix("Max address space"))?;
    line.split_whitespace().next()?.parse().ok()
}

/// The number of threads to work with. `wanted` 0 means one for each processor; more than four for each are cut to
/// four, with a warning.
pub fn threads(wanted: usize, look: LookChoice) -> usize {
    let cores = available_parallelism().map_or(1, usize::from);
    let most = THREADS_PER_CORE * cores;
    if wanted > most {
        let complaint = Complaint::new("fewer-threads")
            .with("wanted", wanted.to_string())
            .with("most", most.to_string());
        warn(look, &complaint);
    }
    match wanted {
        0 => cores,
        _ => wanted.min(most),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// In a chroot without /proc, the system is as if it had never been asked.
    #[test]
    fn memory_of_a_system_that_says_nothing() {
        assert!(memory_of(&System::new()) > 0);
    }

    #[test]
    fn sizes() {
        for (text, bytes) in [
            ("1024", 1024),
            ("12G", 12 << 30),
            ("1.5g", 3 << 29),
            ("800 MB", 800 << 20),
            ("2GiB", 2 << 30),
            ("64k", 64 << 10),
            ("1T", 1 << 40),
        ] {
            assert_eq!(text.parse::<Bytes>().ok(), Some(Bytes(bytes)), "{text}");
        }
        for text in ["", "G", "-1G", "0", "1e30", "12Q", "inf", "1GG1"] {
            assert!(text.parse::<Bytes>().is_err(), "{text}");
        }
        assert_eq!(spelled((12u64 << 30) as f64), "12G");
        assert_eq!(spelled(1.51 * (1u64 << 30) as f64), "1.6G");
        assert_eq!(spelled(1e30), "1.0e30");
        assert_eq!(number(64f64.exp2()), "2^64");
        assert_eq!(number(70.0), "70");
    }

    #[test]
    fn half_of_what_there_is() {
        assert!(*HALF >= 1 << 26, "{}", *HALF);
    }
}
