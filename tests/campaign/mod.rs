//! The randomised campaign: random lines against random shapes, the kernel's crossings against an
//! evaluation in exact arithmetic that shares nothing with it.
//!
//! [`shapes`] and [`lines`] make the cases, [`kernel`] is what is tested, [`truth`] what is right,
//! [`judge`] compares, and this file adds up. Everything follows from one seed.

pub mod bars;
pub mod exact;
mod facets;
mod judge;
mod kernel;
mod lines;
pub mod rng;
pub mod roots;
mod second;
mod shapes;
pub mod truth;
mod turned;

pub use bars::Bars;
pub use judge::Row;
pub use shapes::{KINDS, Spread};

use rayon::prelude::*;
use std::fmt::Write;

/// Lines that are traced through one shape before the next is made.
const BATCH: usize = 16;

/// The rows of one kind of shape: f32, f64 and dd.
pub struct Kind {
    pub name: String,
    pub rows: [Row; 3],
}

impl Kind {
    /// What is not as it should be in f64 and dd, f32 being shown only.
    pub fn failures(&self) -> Vec<String> {
        let judged = self.rows.iter().filter(|row| row.precision != "f32");
        let failures = judged.flat_map(|row| {
            row.failures.iter().map(|f| {
                let name = &self.name;
                format!("{name}, {}: {f}", row.precision)
            })
        });
        failures.collect()
    }
}

/// Traces `rays` lines, or a few more, through shapes of one kind.
pub fn run(kind: usize, spread: Spread, rays: usize, seed: u64, bars: &Bars) -> Kind {
    let batches = rays.div_ceil(BATCH) as u64;
    let rows = (0..batches)
        .into_par_iter()
        .map(|batch| {
            let mut rng = rng::Rng::new(seed ^ (kind as u64) << 48 ^ batch << 8);
            let target = shapes::Target::new(kind, spread, &mut rng);
            let cases: Vec<_> = (0..BATCH)
                .map(|_| lines::case(&target, spread, &mut rng))
                .collect();
            judge::batch(&target, &cases, bars)
        })
        .reduce(judge::empty, |a, b| {
            let mut b = b.into_iter();
            a.map(|row| row.and(b.next().expect("as many rows")))
        });
    Kind {
        name: spread.name(kind),
        rows,
    }
}

/// The results as a table in Markdown.
pub fn table(kinds: &[Kind]) -> String {
    let mut text = String::from(
        "| shape | numbers | rays | wrong | of these outside the band | uncertain | of plain lines | worst error, ε | ns/ray |\n\
         |---|---|---:|---:|---:|---:|---:|---:|---:|\n",
    );
    for kind in kinds {
        for row in &kind.rows {
            let share = |part: u64, of: u64| {
                let percent = 100.0 * part as f64 / of.max(1) as f64;
                match part {
                    0 => "0".to_owned(),
                    _ if percent < 0.01 => format!("{percent:.0e} %"),
                    _ => format!("{percent:.2} %"),
                }
            };
            let error = match row.worst {
                x if x < 1000.0 => format!("{x:.2}"),
                x => format!("{x:.0e}"),
            };
            writeln!(
                text,
                "| {} | {} | {} | {} | {} | {} | {} | {error} | {:.0} |",
                kind.name,
                row.precision,
                row.rays,
                row.wrong,
                row.outside,
                share(row.uncertain, row.rays),
                share(row.plain_uncertain, row.plain),
                row.nanoseconds(),
            )
            .expect("a string takes everything");
        }
    }
    writeln!(text, "\n{}", coarse(kinds)).expect("a string takes everything");
    text
}

/// How many lines go on to `dd` only because `f64` cannot place a crossing to 4 ε.
fn coarse(kinds: &[Kind]) -> String {
    let doubles = |kind: &Kind| {
        let row = kind.rows.iter().find(|row| row.precision == "f64");
        row.map_or((0, 0), |row| (row.coarse, row.rays))
    };
    let shares = kinds.iter().filter_map(|kind| match doubles(kind) {
        (0, _) => None,
        (part, of) => Some(format!(
            "{} {:.3} %",
            kind.name,
            100.0 * part as f64 / of as f64
        )),
    });
    let shares: Vec<String> = shares.collect();
    match shares.is_empty() {
        true => "In `f64` no crossing is placed worse than to 4 ε.".to_owned(),
        false => format!(
            "Decided in `dd` because `f64` may place a crossing worse than to 4 ε: {}.",
            shares.join(", ")
        ),
    }
}
