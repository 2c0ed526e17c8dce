//! The long run of `tests/strangers.rs`: files of all kinds through `zpg fmt` and `zpg check --fix`.
//!
//! `cargo bench --bench files -- [FILES [SEED [FOLDER…]]]`: so many files, 10⁶ unless said otherwise;
//! some of them are what lies in these folders.

#[path = "../tests/any_files/mod.rs"]
mod any_files;
#[expect(dead_code, reason = "the campaign of lines uses the rest")]
#[path = "../tests/campaign/rng.rs"]
mod rng;

use std::path::PathBuf;
use std::process::ExitCode;
use std::time::Instant;

fn main() -> ExitCode {
    // Cargo adds --bench.
    let arguments: Vec<String> = std::env::args()
        .skip(1)
        .filter(|a| a != "--bench")
        .collect();
    let number = |i: usize, otherwise: u64| match arguments.get(i) {
        Some(text) => text.parse::<f64>().map(|x| x as u64),
        None => Ok(otherwise),
    };
    let (Ok(files), Ok(seed)) = (number(0, 1_000_000), number(1, 1)) else {
        eprintln!("files [FILES [SEED [FOLDER…]]]");
        return ExitCode::FAILURE;
    };
    let folders: Vec<PathBuf> = arguments.iter().skip(2).map(PathBuf::from).collect();
    let pool = any_files::Pool::new(&folders);
    let start = Instant::now();
    let tally = any_files::run(files as usize, seed, &pool);
    println!(
        "{} files ({} out of {} in folders): {} scenes, {} changed by fmt, {} by check --fix, {} wrong, {:.0} s; \
         of {} scenes with mistakes {} were taken for none",
        tally.files,
        tally.found,
        pool.texts(),
        tally.scenes,
        tally.formatted,
        tally.fixed,
        tally.wrong.len(),
        start.elapsed().as_secs_f64(),
        tally.spoiled,
        tally.lost.len()
    );
    println!("Texts of other tools:");
    for (kind, taken) in any_files::others::run(files as usize, seed) {
        println!(
            "{kind}: of {} files {} are taken for scenes, {} would be rewritten",
            taken.files, taken.scenes, taken.changed
        );
    }
    for line in tally.wrong.iter().take(50) {
        println!("{line}");
    }
    match tally.wrong.is_empty() {
        true => ExitCode::SUCCESS,
        false => ExitCode::FAILURE,
    }
}
