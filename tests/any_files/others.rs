//! Texts of other tools, full of numbers: none of them is a scene, and none may be taken for one.

use std::collections::BTreeMap;
use std::fmt::Write;

use rayon::prelude::*;
use zpg::internals::format::{Options, format};
use zpg::internals::syntax::recognise;

use crate::rng::Rng;

type Make = fn(&mut Rng) -> String;

/// The kinds, and how a text of each is made.
pub const KINDS: [(&str, Make); 35] = [
    ("list in Markdown", markdown_list),
    ("table in Markdown", markdown_table),
    ("numbered list", numbered_list),
    ("CSV of reals", |rng| table(rng, ",", real)),
    ("CSV of integers", |rng| table(rng, ",", integer)),
    ("CSV with an index", indexed),
    ("semicolons and decimal commas", |rng| {
        table(rng, ";", comma)
    }),
    ("columns of reals", |rng| table(rng, "  ", real)),
    ("columns of integers", |rng| table(rng, " ", integer)),
    ("columns of signed integers", |rng| table(rng, " ", signed)),
    ("columns with tabs", |rng| table(rng, "\t", wide)),
    ("points", points),
    ("OFF", off),
    ("Wavefront", wavefront),
    ("STL", stl),
    ("PCD", pcd),
    ("NFF", nff),
    ("RIB", rib),
    ("Inventor", inventor),
    ("POV-Ray", pov_ray),
    ("G-code", gcode),
    ("SubRip", subrip),
    ("WebVTT", webvtt),
    ("ledger", ledger),
    ("log", log),
    ("log of seconds", log_of_seconds),
    ("source code", source_code),
    ("BASIC", basic),
    ("YAML", yaml),
    ("Matrix Market", matrix_market),
    ("graph", graph),
    ("PGM", pgm),
    ("libsvm", libsvm),
    ("DXF", dxf),
    ("hexadecimal dump", dump),
];

fn real(rng: &mut Rng) -> String {
    let places = 1 + rng.below(6);
    format!("{:.places$}", rng.range(-50.0, 50.0))
}

fn integer(rng: &mut Rng) -> String {
    let most = *rng.pick(&[10, 30, 256, 1000]);
    rng.below(most).to_string()
}

fn signed(rng: &mut Rng) -> String {
    let most = *rng.pick(&[20.0, 200.0, 600.0]);
    (rng.range(-most, most) as i32).to_string()
}

fn wide(rng: &mut Rng) -> String {
    match rng.below(3) {
        0 => integer(rng),
        1 => format!("{:e}", rng.range(-1.0, 1.0)),
        _ => format!("{:.2}", rng.range(0.0, 1e5)),
    }
}

fn comma(rng: &mut Rng) -> String {
    real(rng).replace('.', ",")
}

fn word(rng: &mut Rng) -> &'static str {
    rng.pick::<&'static str>(&[
        "milk", "rent", "train", "Praha", "the", "cube", "vertex", "total", "north", "error",
        "index", "and",
    ])
}

fn words(rng: &mut Rng) -> String {
    let count = 1 + rng.below(5);
    (0..count).map(|_| word(rng)).collect::<Vec<_>>().join(" ")
}

/// Lines that a function makes of their number.
fn lines(rng: &mut Rng, mut line: impl FnMut(&mut Rng, usize) -> String) -> String {
    let count = 3 + rng.below(30);
    (1..=count).map(|i| line(rng, i) + "\n").collect()
}

fn row(rng: &mut Rng, columns: usize, between: &str, number: fn(&mut Rng) -> String) -> String {
    (0..columns)
        .map(|_| number(rng))
        .collect::<Vec<_>>()
        .join(between)
}

fn markdown_list(rng: &mut Rng) -> String {
    format!("# {}\n\n", words(rng)) + &lines(rng, |rng, i| format!("{i}. {}", words(rng)))
}

fn markdown_table(rng: &mut Rng) -> String {
    "| a | b |\n|---|---|\n".to_owned()
        + &lines(rng, |rng, _| format!("| {} | {} |", real(rng), real(rng)))
}

fn numbered_list(rng: &mut Rng) -> String {
    let sign = *rng.pick(&[".", ")", ":", " -", ""]);
    lines(rng, |rng, i| format!("{i}{sign} {}", words(rng)))
}

fn table(rng: &mut Rng, between: &str, number: fn(&mut Rng) -> String) -> String {
    let columns = 2 + rng.below(9);
    let head = match rng.below(3) {
        0 => {
            (0..columns)
                .map(|_| word(rng))
                .collect::<Vec<_>>()
                .join(between)
                + "\n"
        }
        _ => String::new(),
    };
    head + &lines(rng, |rng, _| row(rng, columns, between, number))
}

fn indexed(rng: &mut Rng) -> String {
    let columns = 1 + rng.below(6);
    let number = *rng.pick(&[real as fn(&mut Rng) -> String, wide]);
    lines(rng, |rng, i| {
        format!("{i},{}", row(rng, columns, ",", number))
    })
}

fn points(rng: &mut Rng) -> String {
    let text = lines(rng, |rng, _| row(rng, 3, " ", real));
    format!("{}\n\n{text}", text.lines().count())
}

/// The vertices and the faces of a mesh, the latter from a number on.
fn mesh(rng: &mut Rng, first: usize) -> (Vec<String>, Vec<Vec<usize>>) {
    let (vertices, faces) = (4 + rng.below(20), 4 + rng.below(20));
    let unit = rng.chance(0.3);
    let vertex = |rng: &mut Rng| match unit {
        true => row(rng, 3, " ", |rng| {
            (*rng.pick(&["0", "1", "-1", "0.5"])).to_owned()
        }),
        false => row(rng, 3, " ", real),
    };
    let vertices: Vec<_> = (0..vertices).map(|_| vertex(rng)).collect();
    let face = |rng: &mut Rng| {
        let corners = 3 + rng.below(2);
        (0..corners)
            .map(|_| first + rng.below(vertices.len()))
            .collect()
    };
    let faces = (0..faces).map(|_| face(rng)).collect();
    (vertices, faces)
}

fn joined(numbers: &[usize]) -> String {
    numbers
        .iter()
        .map(usize::to_string)
        .collect::<Vec<_>>()
        .join(" ")
}

fn off(rng: &mut Rng) -> String {
    let (vertices, faces) = mesh(rng, 0);
    let mut text = format!(
        "OFF\n{} {} 0\n{}\n",
        vertices.len(),
        faces.len(),
        vertices.join("\n")
    );
    for face in faces {
        writeln!(text, "{} {}", face.len(), joined(&face)).unwrap();
    }
    text
}

fn wavefront(rng: &mut Rng) -> String {
    let (vertices, faces) = mesh(rng, 1);
    let vertices: String = vertices.iter().map(|v| format!("v {v}\n")).collect();
    let faces: String = faces.iter().map(|f| format!("f {}\n", joined(f))).collect();
    format!("# {}\n{vertices}{faces}", words(rng))
}

fn stl(rng: &mut Rng) -> String {
    let facet = |rng: &mut Rng, _| {
        let corner = |rng: &mut Rng| format!("      vertex {}\n", row(rng, 3, " ", real));
        let corners = corner(rng) + &corner(rng) + &corner(rng);
        format!("  facet normal 0 0 1\n    outer loop\n{corners}    endloop\n  endfacet")
    };
    format!("solid a\n{}endsolid a\n", lines(rng, facet))
}

fn pcd(rng: &mut Rng) -> String {
    let points = lines(rng, |rng, _| row(rng, 3, " ", real));
    let count = points.lines().count();
    format!(
        "VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH {count}\nHEIGHT 1\nDATA ascii\n{points}"
    )
}

fn nff(rng: &mut Rng) -> String {
    let from = row(rng, 3, " ", real);
    let shape = |rng: &mut Rng, _| match rng.below(3) {
        0 => format!("s {}", row(rng, 4, " ", real)),
        1 => format!("p 3\n{0}\n{0}\n{0}", row(rng, 3, " ", real)),
        _ => format!("f {} 0.5 0.5 0 0", row(rng, 3, " ", real)),
    };
    format!(
        "v\nfrom {from}\nat 0 0 0\nup 0 0 1\nangle 45\nhither 1\nresolution 512 512\n{}",
        lines(rng, shape)
    )
}

fn rib(rng: &mut Rng) -> String {
    let shape = |rng: &mut Rng, _| match rng.below(2) {
        0 => format!("Translate {}", row(rng, 3, " ", real)),
        _ => format!(
            "Polygon \"P\" [ {}\n  {} ]",
            row(rng, 6, " ", real),
            row(rng, 3, " ", real)
        ),
    };
    format!(
        "##RenderMan RIB\nversion 3.03\nWorldBegin\n{}WorldEnd\n",
        lines(rng, shape)
    )
}

fn inventor(rng: &mut Rng) -> String {
    let points = lines(rng, |rng, _| format!("      {},", row(rng, 3, " ", real)));
    let faces = lines(rng, |rng, _| {
        format!("      {}, -1,", row(rng, 3, ", ", integer))
    });
    format!(
        "#Inventor V2.1 ascii\nSeparator {{\n  Coordinate3 {{\n    point [\n{points}    ]\n  }}\n  \
         IndexedFaceSet {{\n    coordIndex [\n{faces}    ]\n  }}\n}}\n"
    )
}

fn pov_ray(rng: &mut Rng) -> String {
    let points = lines(rng, |rng, _| format!("  <{}>,", row(rng, 3, ", ", real)));
    format!(
        "mesh2 {{\n vertex_vectors {{\n  {},\n{points} }}\n}}\n",
        points.lines().count()
    )
}

fn gcode(rng: &mut Rng) -> String {
    let numbered = rng.chance(0.3);
    lines(rng, |rng, i| {
        let line = format!("G1 X{} Y{} F1200", real(rng), real(rng));
        if numbered {
            format!("N{i} {line}")
        } else {
            line
        }
    })
}

fn clock(rng: &mut Rng, point: char) -> String {
    format!(
        "00:{:02}:{:02}{point}{:03}",
        rng.below(60),
        rng.below(60),
        rng.below(1000)
    )
}

fn subrip(rng: &mut Rng) -> String {
    lines(rng, |rng, i| {
        let text = if rng.chance(0.3) {
            integer(rng)
        } else {
            words(rng)
        };
        format!("{i}\n{} --> {}\n{text}\n", clock(rng, ','), clock(rng, ','))
    })
}

fn webvtt(rng: &mut Rng) -> String {
    "WEBVTT\n\n".to_owned()
        + &lines(rng, |rng, i| {
            format!(
                "{i}\n{} --> {}\n{}\n",
                clock(rng, '.'),
                clock(rng, '.'),
                words(rng)
            )
        })
}

fn ledger(rng: &mut Rng) -> String {
    let date = *rng.pick(&["2024-01-", "2024/01/", "24.1.", ""]);
    lines(rng, |rng, i| {
        let day = 1 + i % 28;
        let sum = format!("{:.2}", rng.range(-5000.0, 5000.0));
        match rng.below(2) {
            0 => format!("{date}{day:02}  {}  {sum}", words(rng)),
            _ => format!("{date}{day:02};{};{sum};{}", words(rng), integer(rng)),
        }
    })
}

fn log(rng: &mut Rng) -> String {
    let date = *rng.pick(&["2024-05-17T", "2024-05-17 ", ""]);
    lines(rng, |rng, _| {
        format!("{date}{} {} {}", clock(rng, '.'), words(rng), integer(rng))
    })
}

fn log_of_seconds(rng: &mut Rng) -> String {
    let whole = rng.chance(0.3);
    lines(rng, |rng, i| match whole {
        true => format!("{} {} {}", 1_700_000_000 + i, words(rng), integer(rng)),
        false => format!("{i}.{:03} {} {}", rng.below(1000), words(rng), integer(rng)),
    })
}

fn source_code(rng: &mut Rng) -> String {
    let line = |rng: &mut Rng, _| match rng.below(3) {
        0 => format!("    {{ {}f, {}f, {}f }},", real(rng), real(rng), real(rng)),
        1 => format!("    {}, {}, {},", integer(rng), integer(rng), integer(rng)),
        _ => format!("    {},", real(rng)),
    };
    format!("static const float a[] = {{\n{}}};\n", lines(rng, line))
}

fn basic(rng: &mut Rng) -> String {
    lines(rng, |rng, i| match rng.below(3) {
        0 => format!("{} PRINT \"{}\"", 10 * i, words(rng)),
        1 => format!("{} DATA {}", 10 * i, row(rng, 5, ",", integer)),
        _ => format!("{} GOTO {}", 10 * i, 10 * (1 + rng.below(20))),
    })
}

fn yaml(rng: &mut Rng) -> String {
    lines(rng, |rng, _| match rng.below(2) {
        0 => format!("{}: {}", word(rng), real(rng)),
        _ => format!("- {}", real(rng)),
    })
}

fn matrix_market(rng: &mut Rng) -> String {
    let entries = lines(rng, |rng, _| {
        format!("{} {} {}", 1 + rng.below(50), 1 + rng.below(50), real(rng))
    });
    format!(
        "%%MatrixMarket matrix coordinate real general\n50 50 {}\n{entries}",
        entries.lines().count()
    )
}

fn graph(rng: &mut Rng) -> String {
    let text = lines(rng, |rng, _| {
        let columns = 2 + rng.below(5);
        row(rng, columns, " ", |rng| (1 + rng.below(40)).to_string())
    });
    format!(
        "{} {}\n{text}",
        text.lines().count(),
        3 * text.lines().count()
    )
}

fn pgm(rng: &mut Rng) -> String {
    let width = 4 + rng.below(20);
    format!("P2\n{width} 9\n255\n")
        + &lines(rng, |rng, _| {
            row(rng, width, " ", |rng| rng.below(256).to_string())
        })
}

fn libsvm(rng: &mut Rng) -> String {
    lines(rng, |rng, _| {
        let columns = 1 + rng.below(6);
        let pairs = (1..=columns).map(|i| format!(" {i}:{}", real(rng)));
        let pairs: String = pairs.collect();
        format!("{}{pairs}", rng.pick(&["1", "-1", "+1", "0"]))
    })
}

fn dxf(rng: &mut Rng) -> String {
    let line = |rng: &mut Rng, _| {
        let (x, y) = (real(rng), real(rng));
        format!("  0\nVERTEX\n  8\n0\n 10\n{x}\n 20\n{y}\n 30\n0.0")
    };
    format!(
        "  0\nSECTION\n  2\nENTITIES\n{}  0\nENDSEC\n  0\nEOF\n",
        lines(rng, line)
    )
}

fn dump(rng: &mut Rng) -> String {
    lines(rng, |rng, i| {
        let bytes: Vec<_> = (0..16).map(|_| format!("{:02x}", rng.below(256))).collect();
        format!("{:08x}  {}", 16 * i, bytes.join(" "))
    })
}

/// What came of texts of a kind.
#[derive(Default, Clone)]
pub struct Taken {
    pub files: usize,
    /// How many were taken for scenes, and how many of these would be printed in another way.
    pub scenes: usize,
    pub changed: usize,
    /// One that would be.
    pub example: Option<String>,
}

/// Makes so many texts and shows them to the formatter. The same seed gives the same ones.
pub fn run(count: usize, seed: u64) -> BTreeMap<&'static str, Taken> {
    let taken = |i: usize| {
        let mut rng = Rng::new(seed.wrapping_mul(1 << 32).wrapping_add(i as u64));
        let (kind, make) = KINDS[i % KINDS.len()];
        let text = make(&mut rng);
        let mut taken = Taken {
            files: 1,
            ..Taken::default()
        };
        if let Ok((source, document)) = recognise::parse("a.zpg", text.clone().into_bytes()) {
            taken.scenes = 1;
            if format(&source.text, &document, &Options::default()) != source.text {
                taken.changed = 1;
                taken.example = Some(text);
            }
        }
        (kind, taken)
    };
    let mut all: BTreeMap<_, Taken> = BTreeMap::new();
    for (kind, taken) in (0..count).into_par_iter().map(taken).collect::<Vec<_>>() {
        let sum = all.entry(kind).or_default();
        sum.files += taken.files;
        sum.scenes += taken.scenes;
        sum.changed += taken.changed;
        sum.example = sum.example.take().or(taken.example);
    }
    all
}
