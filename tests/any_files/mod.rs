//! Files of all kinds: what comes of them is foreseen here, by other means than the program's own,
//! and compared with what `zpg fmt` and `zpg check --fix` leave on disk.

mod judge;
mod make;
pub mod others;

use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};

use rayon::prelude::*;

use crate::rng::Rng;
pub use make::Pool;

/// So many files lie in one folder.
const BATCH: usize = 1000;

/// What came of some files.
#[derive(Default)]
pub struct Tally {
    pub files: usize,
    /// What was found in folders.
    pub found: usize,
    pub scenes: usize,
    /// Scenes with mistakes, and how many of them were taken for none.
    pub spoiled: usize,
    pub lost: Vec<String>,
    pub formatted: usize,
    pub fixed: usize,
    /// What should not have come, with the file.
    pub wrong: Vec<String>,
}

impl Tally {
    fn add(mut self, other: Tally) -> Tally {
        self.files += other.files;
        self.found += other.found;
        self.scenes += other.scenes;
        self.spoiled += other.spoiled;
        self.lost.extend(other.lost);
        self.formatted += other.formatted;
        self.fixed += other.fixed;
        self.wrong.extend(other.wrong);
        self
    }
}

/// Judges so many files. The same seed and the same pool give the same ones.
pub fn run(count: usize, seed: u64, pool: &Pool) -> Tally {
    let batches = (0..count.div_ceil(BATCH)).into_par_iter();
    let batch = |i: usize| {
        let size = BATCH.min(count - i * BATCH);
        batch(
            size,
            seed.wrapping_mul(1 << 32).wrapping_add(i as u64),
            pool,
        )
    };
    batches.map(batch).reduce(Tally::default, Tally::add)
}

fn batch(size: usize, seed: u64, pool: &Pool) -> Tally {
    let mut rng = Rng::new(seed);
    let files: Vec<_> = (0..size).map(|_| make::file(&mut rng, pool)).collect();
    let verdicts: Vec<_> = (files.iter())
        .map(|file| judge::foresee(&file.bytes, file.is_scene))
        .collect();
    let mut tally = Tally {
        files: size,
        found: files.iter().filter(|f| f.kind == make::FOUND).count(),
        ..Tally::default()
    };
    for (i, verdict) in verdicts.iter().enumerate() {
        tally.scenes += usize::from(verdict.is_scene);
        let is_spoiled = files[i].kind == make::SPOILED;
        tally.spoiled += usize::from(is_spoiled);
        let lost = is_spoiled && !verdict.is_scene;
        let told = || describe(seed, i, "taken for no scene", &files[i]);
        tally.lost.extend(lost.then(told));
        tally.formatted += usize::from(verdict.formatted != files[i].bytes);
        tally.fixed += usize::from(verdict.fixed != files[i].bytes);
        let told = |what: &String| describe(seed, i, what, &files[i]);
        tally.wrong.extend(verdict.wrong.iter().map(told));
    }
    // What is on disk in the end.
    for (arguments, result) in [
        (&["fmt"][..], judge::FORMATTED),
        (&["check", "--fix", "--statistics"], judge::FIXED),
    ] {
        let folder = tempfile::tempdir().expect("a folder");
        let path = |i: usize| folder.path().join(format!("{i}.zpg"));
        for (i, file) in files.iter().enumerate() {
            fs::write(path(i), &file.bytes).expect("room on the disk");
        }
        let code = zpg(arguments, folder.path());
        let expected = match verdicts.iter().all(|v| v.is_scene && v.is_written) {
            true => 0..=1,
            false => 2..=2,
        };
        if !code.is_some_and(|code| expected.contains(&code)) {
            let line = format!("{arguments:?} of batch {seed}: exit status {code:?}");
            tally.wrong.push(line);
        }
        for (i, verdict) in verdicts.iter().enumerate() {
            if fs::read(path(i)).ok().as_ref() != Some(result(verdict)) {
                let what = format!("{arguments:?} leaves something else");
                tally.wrong.push(describe(seed, i, &what, &files[i]));
            }
        }
        let left = fs::read_dir(folder.path()).expect("a folder").count();
        if left != size {
            let line = format!("{arguments:?} of batch {seed}: {left} files are left");
            tally.wrong.push(line);
        }
    }
    tally
}

fn zpg(arguments: &[&str], folder: &Path) -> Option<i32> {
    Command::new(env!("CARGO_BIN_EXE_zpg"))
        .env("LC_ALL", "C")
        .args(arguments)
        .arg(folder)
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .status()
        .ok()?
        .code()
}

fn describe(seed: u64, i: usize, what: &str, file: &make::File) -> String {
    let start = &file.bytes[..file.bytes.len().min(600)];
    format!(
        "{what}: file {i} of batch {seed}, {}: {:?}",
        file.kind,
        start.escape_ascii().to_string()
    )
}
