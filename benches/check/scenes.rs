//! Scenes of a size.

use std::fmt::Write;

pub struct Scene {
    pub name: &'static str,
    pub text: String,
}

type Lines = fn(&mut String, usize) -> std::fmt::Result;

/// Repeats what `line` writes for 0, 1, 2, … until the text is long enough.
fn scene(name: &'static str, size: usize, line: Lines) -> Scene {
    let mut text = String::with_capacity(size + 100_000);
    for i in 0.. {
        if text.len() >= size {
            break;
        }
        line(&mut text, i).expect("a string takes everything");
    }
    Scene { name, text }
}

/// A number with up to three decimals that follows no simple order.
fn real(i: usize) -> f64 {
    (i.wrapping_mul(2_654_435_761) % 200_001) as f64 / 1000.0 - 100.0
}

fn sphere(id: usize, i: usize) -> String {
    let [x, y, z, r] = [1, 2, 3, 4].map(|k| real(7 * i + k));
    format!("{id} 11 {x} {y} {z} {}", r.abs() + 0.001)
}

/// A sphere, a comment, and the union with what is there already.
fn link(text: &mut String, i: usize) -> std::fmt::Result {
    let id = 2 * i + 2;
    writeln!(text, "{} # ball {i} #", sphere(id, i))?;
    match i {
        0 => writeln!(text, "{} -105 {id}", id + 1),
        _ => writeln!(text, "{} -101 {} {id}", id + 1, id - 1),
    }
}

/// Spheres, unions and comments.
pub fn mixed(size: usize) -> Scene {
    let mut scene = scene("spheres, unions and comments", size, link);
    render(&mut scene.text);
    scene
}

/// Draws what is defined last.
fn render(text: &mut String) {
    let last = text.trim_end().rsplit('\n').next().unwrap_or_default();
    let id = last.split(' ').next().unwrap_or("2").to_owned();
    *text += &format!("1 9999 {id} 0\n");
}

/// The spheres of a scene, one union, in POV-Ray's language; the comments too.
pub fn pov_ray(text: &str) -> String {
    let mut out = "camera { location <0, 0, -9> look_at 0 }\nunion {\n".to_owned();
    for line in text.lines() {
        let words: Vec<&str> = line.split(' ').collect();
        if let [_, "11", x, y, z, r, comment @ ..] = words.as_slice() {
            let comment = comment.join(" ").replace('#', "");
            out += &format!("  sphere {{ <{x}, {y}, {z}>, {r} }} // {comment}\n");
        }
    }
    out + "}\n"
}

/// Eight kinds without mistakes.
pub fn kinds(size: usize) -> Vec<Scene> {
    vec![
        scene("spheres", size, |t, i| writeln!(t, "{}", sphere(i + 2, i))),
        scene("spheres with comments and colours", size, |t, i| {
            let id = i + 2;
            writeln!(t, "{} # ball {id} #\n{id} -201 0.5 0.25 0", sphere(id, i))
        }),
        scene("operations", size, |t, i| match i {
            0 => writeln!(t, "2 9 1\n3 9 2"),
            _ => writeln!(t, "{} -101 {} {}", i + 3, i + 1, i + 2),
        }),
        scene("profiles of 2000 points", size, |t, i| {
            write!(t, "{} 1 2000", i + 2)?;
            for k in 0..2000 {
                let separator = if k % 8 == 0 { "\n" } else { " " };
                write!(t, "{separator}{} {k}", real(i + k).abs())?;
            }
            writeln!(t)
        }),
        scene("matrices", size, |t, i| {
            let [a, b, c] = [1, 2, 3].map(|k| real(i + k));
            writeln!(
                t,
                "{0} 9 1\n{0} -4\n1 0 0 {a}\n0 1 0 {b}\n0 0 1 {c}\n0 0 0 1",
                i + 2
            )
        }),
        scene("nothing but comments", size, |t, i| {
            writeln!(t, "0 # line {i} of a long story #")
        }),
        scene("spheres on one line", size, |t, i| {
            write!(t, "{} ", sphere(i + 2, i))
        }),
        scene("spheres in free form", size, |t, i| {
            for (k, word) in sphere(i + 2, i).split(' ').enumerate() {
                match (i + k) % 5 {
                    0 => writeln!(t, "{word}")?,
                    1 => write!(t, "{word} # {k} # ")?,
                    _ => write!(t, "{word}  ")?,
                }
            }
            Ok(())
        }),
    ]
}

pub fn mistake_on_every_20th_line(size: usize) -> Scene {
    scene("a mistake on every 20th line", size, |t, i| match i % 20 {
        0 => writeln!(t, "{} 11 0 0 x 1", i + 2),
        _ => writeln!(t, "{}", sphere(i + 2, i)),
    })
}

pub fn number_missing_on_every_line(size: usize) -> Scene {
    scene("a number missing on every line", size, |t, i| {
        writeln!(t, "{} 11 {} 0 1", i + 2, real(i))
    })
}

/// So many lines of spheres, comments and unions; in some of them a number is missing.
pub fn lines(count: usize, mistakes: usize) -> String {
    let mut text = String::new();
    for i in 0..count / 2 {
        link(&mut text, i).expect("a string takes everything");
    }
    render(&mut text);
    for k in 0..mistakes {
        // The radius of a sphere.
        let line = text
            .match_indices(" # ball ")
            .nth((k + 1) * count / 2 / (mistakes + 1));
        let Some((at, _)) = line else { continue };
        let radius = text[..at].rfind(' ').unwrap_or(at);
        text.replace_range(radius..at, "");
    }
    text
}

/// So many records, in groups of four: a sphere, moved, coloured, added to the others. So many of the groups have one
/// of the slips that people make, in turn.
pub fn slips(records: usize, mistakes: usize) -> String {
    let groups = records / 4;
    let mut text = String::new();
    for i in 0..groups {
        let id = 2 * i + 2;
        let lines = [
            format!("{id} 11 0 {i} 0 1"),
            format!("{id} -1 {i} 0 0"),
            format!("{id} -701 1 0.5 0"),
            match i {
                0 => format!("{} -105 {id}", id + 1),
                _ => format!("{} -101 {} {id}", id + 1, id - 1),
            },
        ];
        let is_wrong = i > 0 && i * mistakes / groups > (i - 1) * mistakes / groups;
        let lines = lines.join("\n");
        let kind = match is_wrong {
            true => i * mistakes / groups % 5,
            false => 5,
        };
        text += &match kind {
            0 => lines.replacen(" -701", " 701", 1),
            1 => lines.replacen(" 0 1\n", " O 1\n", 1),
            2 => lines.replacen(" 0 1\n", " 0 1 red ball\n", 1),
            3 => lines + &format!("\n{id} -299 {id} 0"),
            4 => lines.replacen(" 0.5 0\n", " 0.5\n", 1),
            _ => lines,
        };
        text.push('\n');
    }
    render(&mut text);
    text
}

/// Spheres, each added to the union of those before.
pub fn chain(spheres: usize) -> String {
    let mut text = String::new();
    for i in 0..spheres {
        link(&mut text, i).expect("a string takes everything");
    }
    render(&mut text);
    text
}

/// A kind of scenes, and what writes so many records of it.
pub type Kind = (&'static str, fn(usize) -> String);

/// Six kinds of records.
pub const RECORDS: [Kind; 6] = [
    ("spheres", |n| {
        all(n, |t, i| writeln!(t, "{}", sphere(i + 2, i)))
    }),
    ("union chain", |n| chain(n / 2)),
    ("moved boxes", |n| {
        all(n / 2, |t, i| {
            writeln!(t, "{0} 12 0 0 0 1 1 1\n{0} -1 {1} 0 0", i + 2, 2 * i)
        })
    }),
    ("colours assigned", |n| {
        all(n / 2, |t, i| {
            writeln!(
                t,
                "{0} -701 0.5 0.5 1\n{1} 9 1\n{1} -299 {0} 0",
                2 * i + 2,
                2 * i + 3
            )
        })
    }),
    ("profiles", |n| {
        all(n, |t, i| writeln!(t, "{} 1 4 0 0 1 0 1 1 0 1", i + 2))
    }),
    ("comments", |n| all(n, |t, i| writeln!(t, "0 # line {i} #"))),
];

fn all(count: usize, line: Lines) -> String {
    let mut text = String::new();
    for i in 0..count {
        line(&mut text, i).expect("a string takes everything");
    }
    text
}
