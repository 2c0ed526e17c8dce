//! The report that `--stats` asks for: what a picture has cost.

use std::fs;
use std::io::Write;
use std::path::Path;

use serde::Serialize;

use crate::commands::atomic_file;
use crate::diagnostics::Error;
use crate::trace::stats::{Intersections, Rays, Work};

/// The report that `--stats` asks for: what a picture has cost.
#[derive(Serialize)]
pub struct Stats {
    pub size: [u32; 2],
    pub precision: &'static str,
    pub threads: usize,
    pub samples: Samples,
    pub seconds: Seconds,
    pub rays: Rays,
    pub intersections: Intersections,
    pub work: Work,
    pub uncertain: u64,
    /// Pixels that the quick kernel has drawn.
    pub quick: u64,
    pub effects: Vec<&'static str>,
    pub peak_memory_bytes: u64,
}

#[derive(Serialize)]
pub struct Samples {
    pub min: u32,
    pub max: u32,
    pub mean: f64,
}

#[derive(Serialize, Default)]
pub struct Seconds {
    pub load: f64,
    pub plan: f64,
    pub build: f64,
    pub trace: f64,
    pub encode: f64,
}

pub fn write_stats(path: &Path, stats: &Stats) -> Result<(), Error> {
    let write = |out: &mut dyn Write| {
        serde_json::to_writer_pretty(&mut *out, stats)?;
        writeln!(out)
    };
    Ok(atomic_file::write(path, write)?)
}

/// The most memory the process has held, in bytes; 0 where the system does not tell.
pub fn peak_memory() -> u64 {
    let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|l| l.strip_prefix("VmHWM:"));
    let kibibytes: Option<u64> = line.and_then(|l| l.split_whitespace().next()?.parse().ok());
    kibibytes.unwrap_or(0) * 1024
}
