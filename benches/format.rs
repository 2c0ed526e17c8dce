//! Scenes of 20 MB through the formatter on one thread: seconds to parse, and to parse, format and prove
//! that the result says the same.

use std::fmt::Write;
use std::time::Instant;

use zpg::internals::format::{Options, format};
use zpg::internals::syntax::parse;

/// The size of each scene in bytes, about.
const SIZE: usize = 20_000_000;

/// Repeats what `line` writes for 0, 1, 2, … until the text is long enough.
fn scene(line: impl Fn(&mut String, usize) -> std::fmt::Result) -> String {
    let mut text = String::with_capacity(SIZE + 100_000);
    for i in 0.. {
        if text.len() >= SIZE {
            break;
        }
        line(&mut text, i).expect("a string takes everything");
    }
    text
}

/// A number with up to three decimals that follows no simple order.
fn real(i: usize) -> f64 {
    (i.wrapping_mul(2_654_435_761) % 200_001) as f64 / 1000.0 - 100.0
}

fn sphere(i: usize) -> String {
    let [x, y, z, r] = [1, 2, 3, 4].map(|k| real(7 * i + k));
    format!("{} 11 {x} {y} {z} {}", i + 2, r.abs() + 0.001)
}

fn profile(text: &mut String, i: usize, points: usize) -> std::fmt::Result {
    write!(text, "{} 1 {points}", i + 2)?;
    for k in 0..points {
        let separator = if k % 8 == 0 { "\n" } else { " " };
        write!(text, "{separator}{} {}", real(i + k).abs(), k)?;
    }
    writeln!(text)
}

fn main() {
    let scenes: [(&str, String); 10] = [
        ("spheres", scene(|t, i| writeln!(t, "{}", sphere(i)))),
        (
            "spheres with comments and colours",
            scene(|t, i| {
                let id = i + 2;
                writeln!(t, "{} # ball {id} #\n{id} -201 0.5 0.25 0", sphere(i))
            }),
        ),
        (
            "operations",
            scene(|t, i| writeln!(t, "{} -101 {} {}", 2 * i + 9, 2 * i + 2, 2 * i + 3)),
        ),
        ("profiles of 2000 points", scene(|t, i| profile(t, i, 2000))),
        (
            "matrices",
            scene(|t, i| {
                let [a, b, c] = [1, 2, 3].map(|k| real(i + k));
                writeln!(t, "{} -4\n1 0 0 {a}\n0 1 0 {b}\n0 0 1 {c}\n0 0 0 1", i + 2)
            }),
        ),
        (
            "nothing but comments",
            scene(|t, i| writeln!(t, "0 # line {i} of a long story #")),
        ),
        (
            "spheres on one line",
            scene(|t, i| write!(t, "{} ", sphere(i))),
        ),
        (
            "spheres in free form",
            scene(|t, i| {
                let words = sphere(i);
                for (k, word) in words.split(' ').enumerate() {
                    match (i + k) % 5 {
                        0 => writeln!(t, "{word}")?,
                        1 => write!(t, "{word} # {k} # ")?,
                        _ => write!(t, "{word}  ")?,
                    }
                }
                Ok(())
            }),
        ),
        (
            "a mistake on every 20th line",
            scene(|t, i| match i % 20 {
                0 => writeln!(t, "{} 11 0 0 x 1", i + 2),
                _ => writeln!(t, "{}", sphere(i)),
            }),
        ),
        (
            "a number missing on every line",
            scene(|t, i| writeln!(t, "{} 11 {} 0 1", i + 2, real(i))),
        ),
    ];
    println!("{:<36} {:>8} {:>8}", "20 MB", "parse", "format");
    for (name, text) in scenes {
        let start = Instant::now();
        let (document, _) = parse(&text);
        let parsed = start.elapsed().as_secs_f64();
        let result = format(&text, &document, &Options::default());
        let total = start.elapsed().as_secs_f64();
        assert!(!result.is_empty());
        println!("{name:<36} {parsed:>6.2} s {total:>6.2} s");
    }
}
