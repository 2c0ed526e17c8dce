//! The long run of the randomised campaign: its table in Markdown on standard output, what breaks a
//! bar on standard error. `benches/README.md` says what the columns mean.
//!
//! `cargo bench --bench campaign -- [RAYS [SEED [SHAPE…]]]`: so many rays in all, 10⁷ unless said
//! otherwise, through the shapes whose names contain one of the words. With `--renew` instead of shapes
//! the bars for errors are written anew, from what was measured.

#[path = "../tests/campaign/mod.rs"]
mod campaign;

use campaign::bars::{self, Bars};
use campaign::{KINDS, Spread};
use std::fmt::Write;
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
    let renew = words == ["--renew"];
    let all = [Spread::Usual, Spread::Stretched]
        .into_iter()
        .flat_map(|spread| (0..KINDS.len()).map(move |kind| (kind, spread)));
    let chosen: Vec<(usize, Spread)> = all
        .filter(|(kind, spread)| {
            let name = spread.name(*kind);
            words.is_empty() || renew || words.iter().any(|w| name.contains(w.as_str()))
        })
        .collect();
    let mut kinds = Vec::new();
    for &(kind, spread) in &chosen {
        let start = Instant::now();
        let name = spread.name(kind);
        let bars = match renew {
            true => Bars::NONE,
            false => Bars::of_kind(&name),
        };
        let rays = rays as usize / chosen.len().max(1);
        kinds.push(campaign::run(kind, spread, rays, seed, &bars));
        eprintln!("{name}: {:.0} s", start.elapsed().as_secs_f64());
    }
    print!("{}", campaign::table(&kinds));
    let failures: Vec<String> = kinds.iter().flat_map(campaign::Kind::failures).collect();
    for failure in &failures {
        eprintln!("{failure}");
    }
    if renew && failures.is_empty() && std::fs::write(bars::PATH, renewed(&kinds)).is_err() {
        eprintln!("cannot write {}", bars::PATH);
        return ExitCode::FAILURE;
    }
    if failures.is_empty() {
        ExitCode::SUCCESS
    } else {
        ExitCode::FAILURE
    }
}

/// By how much a bar exceeds what was measured.
const SLACK: f64 = 1.5;

/// What is promised of shapes whose axes are far apart: 4 ε of doubles, in ε of `f64` and of `dd`.
const STRETCHED: &str = "4\t1125899906842624";

/// The file with the bars that follow from these results.
fn renewed(kinds: &[campaign::Kind]) -> String {
    let mut text = String::from("shape\tf64\tdd\n");
    for kind in kinds {
        let worst = |precision: &str| {
            let rows = kind.rows.iter().filter(|r| r.precision == precision);
            rows.fold(0.0f64, |worst, row| worst.max(row.worst)) * SLACK
        };
        let up = |x: f64| (x * 100.0).ceil() / 100.0;
        let bars = match kind.name.ends_with("stretched") {
            true => STRETCHED.to_owned(),
            false => format!("{:.2}\t{:.2}", up(worst("f64")), up(worst("dd"))),
        };
        writeln!(text, "{}\t{bars}", kind.name).expect("a string takes everything");
    }
    text
}
