//! The long run of the randomised campaign: its table in Markdown on standard output, what breaks a
//! bar on standard error. `benches/README.md` says what the columns mean.
//!
//! `cargo bench --bench campaign -- [RAYS [SEED [SHAPE…]]]`: so many rays in all, 10⁷ unless said
//! otherwise, through the shapes whose names contain one of the words.

#[path = "../tests/campaign/mod.rs"]
mod campaign;

use campaign::KINDS;
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
    let (Ok(rays), Ok(seed)) = (number(0, 10_000_000), number(1, 1)) else {
        eprintln!("campaign [RAYS [SEED [SHAPE…]]]");
        return ExitCode::FAILURE;
    };
    let words = arguments.get(2..).unwrap_or_default();
    let chosen: Vec<usize> = (0..KINDS.len())
        .filter(|&k| words.is_empty() || words.iter().any(|w| KINDS[k].contains(w.as_str())))
        .collect();
    let mut kinds = Vec::new();
    for &kind in &chosen {
        let start = Instant::now();
        kinds.push(campaign::run(
            kind,
            rays as usize / chosen.len().max(1),
            seed,
        ));
        eprintln!("{}: {:.0} s", KINDS[kind], start.elapsed().as_secs_f64());
    }
    print!("{}", campaign::table(&kinds));
    let failures: Vec<String> = kinds.iter().flat_map(campaign::Kind::failures).collect();
    for failure in &failures {
        eprintln!("{failure}");
    }
    if failures.is_empty() {
        ExitCode::SUCCESS
    } else {
        ExitCode::FAILURE
    }
}
