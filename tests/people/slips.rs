//! What people get wrong in a record.

use zpg::internals::analysis::Analysis;
use zpg::internals::solids::inside::Inside;

use super::scenes::{Record, text};
use crate::rng::Rng;

/// A kind of slip.
pub struct Slip {
    pub name: &'static str,
    /// Whether it holds in 98 % of all cases; else in most.
    pub bar: f64,
    /// Its line as it is written, and what was meant if that is not the record; `None` where the record
    /// cannot have the slip.
    pub make: fn(&mut Rng, &[Record], usize) -> Option<Written>,
}

pub struct Written {
    pub line: String,
    pub meant: String,
}

const HIGH: f64 = 0.98;

/// This one is a warning.
pub const DIFFERENCE: &str = "operands of a difference swapped";

pub const ALL: &[Slip] = &[
    Slip {
        name: "minus of a type lost",
        bar: HIGH,
        make: minus,
    },
    Slip {
        name: "typographic minus",
        bar: HIGH,
        make: dash,
    },
    Slip {
        name: "letter for a digit",
        bar: HIGH,
        make: letter,
    },
    Slip {
        name: "lamp with a colour",
        bar: HIGH,
        make: lamp,
    },
    Slip {
        name: "numbers of a sibling",
        bar: HIGH,
        make: sibling,
    },
    Slip {
        name: "`… red ball`",
        bar: HIGH,
        make: |_, r, i| words(&r[i], "red ball"),
    },
    Slip {
        name: "`… red ball #`",
        bar: HIGH,
        make: |_, r, i| words(&r[i], "red ball #"),
    },
    Slip {
        name: "`# ball #1 #`",
        bar: HIGH,
        make: |_, r, i| words(&r[i], "# ball #1 #"),
    },
    Slip {
        name: "`// red ball`",
        bar: HIGH,
        make: |_, r, i| words(&r[i], "// red ball 2"),
    },
    Slip {
        name: "`-- red ball`",
        bar: HIGH,
        make: |_, r, i| words(&r[i], "-- červená koule"),
    },
    Slip {
        name: "`/* red ball */`",
        bar: HIGH,
        make: |_, r, i| words(&r[i], "/* red ball */"),
    },
    Slip {
        name: "`; red ball`",
        bar: HIGH,
        make: |_, r, i| words(&r[i], "; red ball"),
    },
    Slip {
        name: "word for a type",
        bar: HIGH,
        make: word,
    },
    Slip {
        name: "per cent sign",
        bar: HIGH,
        make: per_cent,
    },
    Slip {
        name: "degree sign",
        bar: HIGH,
        make: degree,
    },
    Slip {
        name: "fraction",
        bar: HIGH,
        make: fraction,
    },
    Slip {
        name: "texture and optics swapped",
        bar: HIGH,
        make: swapped,
    },
    Slip {
        name: "object and property swapped",
        bar: HIGH,
        make: object,
    },
    Slip {
        name: DIFFERENCE,
        bar: HIGH,
        make: difference,
    },
    Slip {
        name: "references off by one",
        bar: HIGH,
        make: off_by_one,
    },
    Slip {
        name: "group of numbers twice",
        bar: HIGH,
        make: doubled,
    },
];

fn written(record: &Record, line: String) -> Option<Written> {
    let meant = record.line();
    Some(Written { line, meant })
}

fn minus(_: &mut Rng, all: &[Record], i: usize) -> Option<Written> {
    let r = &all[i];
    (r.code < 0).then(|| written(r, r.with(&(-r.code).to_string(), &r.params)))?
}

/// One word of the record behind the ID, changed.
fn change(
    rng: &mut Rng,
    r: &Record,
    new: impl Fn(&mut Rng, &str) -> Option<String>,
) -> Option<Written> {
    let mut words: Vec<String> = vec![r.code.to_string()];
    words.extend(r.params.iter().cloned());
    let can: Vec<usize> = (0..words.len())
        .filter(|&i| new(&mut Rng::new(1), &words[i]).is_some())
        .collect();
    if can.is_empty() {
        return None;
    }
    // Every other time the type, if it can be.
    let at = match can[0] == 0 && rng.chance(0.5) {
        true => 0,
        false => *rng.pick(&can),
    };
    words[at] = new(rng, &words[at])?;
    written(r, format!("{} {}", r.id, words.join(" ")))
}

fn dash(rng: &mut Rng, all: &[Record], i: usize) -> Option<Written> {
    change(rng, &all[i], |rng, word| {
        let rest = word.strip_prefix('-')?;
        Some(format!("{}{rest}", rng.pick(&['−', '–', '—', '‑'])))
    })
}

fn letter(rng: &mut Rng, all: &[Record], i: usize) -> Option<Written> {
    change(rng, &all[i], |rng, word| {
        let at = word.find(['0', '1'])?;
        let letter = match word.as_bytes()[at] {
            b'0' => *rng.pick(&["O", "o"]),
            _ => *rng.pick(&["l", "I"]),
        };
        Some(format!("{}{letter}{}", &word[..at], &word[at + 1..]))
    })
}

fn lamp(rng: &mut Rng, all: &[Record], i: usize) -> Option<Written> {
    let r = &all[i];
    let parts: Vec<String> = (0..3)
        .map(|_| (rng.below(10) as f64 / 10.0 + 0.1).to_string())
        .collect();
    matches!(r.code, -402 | -401).then(|| Written {
        line: r.with(&r.code.to_string(), &parts),
        meant: format!("{} {} 1\n{} -701 {}", r.id, r.code, r.id, parts.join(" ")),
    })
}

fn sibling(rng: &mut Rng, all: &[Record], i: usize) -> Option<Written> {
    let r = &all[i];
    // Of two numbers there are several operations, and of three a sphere may have lost one.
    let others: &[i32] = match r.code {
        11 => &[9],
        9 => &[11, 13],
        10 => &[9],
        13 => &[9],
        5 => &[12],
        12 => &[5],
        6 => &[7, 8],
        7 => &[6, 8],
        8 => &[6, 7],
        1 => &[2],
        2 => &[1],
        -104 => &[-101, -103],
        -201 => &[-202],
        -202 => &[-201],
        -502 => &[-503],
        -503 => &[-502],
        -601 => &[-602],
        -602 => &[-601],
        _ => return None,
    };
    written(r, r.with(&rng.pick(others).to_string(), &r.params))
}

fn words(r: &Record, comment: &str) -> Option<Written> {
    written(r, format!("{} {comment}", r.line()))
}

fn word(rng: &mut Rng, all: &[Record], i: usize) -> Option<Written> {
    let r = &all[i];
    let names: &[&str] = match r.code {
        1 => &["lathe", "rotační těleso", "revolution"],
        4 => &["half-space", "poloprostor", "halfspace"],
        5 => &["rectangle", "obdélník"],
        6 => &["triangle", "trojúhelník"],
        3 => &["plane", "rovina"],
        15 => &["quadric", "kvadrika"],
        17 => &["double cone", "double-cone", "dvojitý kužel"],
        -104 => &["complement", "doplněk"],
        -201 => &["material", "optics", "optika", "vlastnosti"],
        -203 => &["index", "ior", "index lomu"],
        -399 => &["checkerboard", "šachovnice"],
        -401 => &["ambient", "ambient light", "okolní světlo"],
        -601 => &["bounding box"],
        -602 => &["bounding sphere"],
        11 => &["sphere", "koule", "Ball"],
        9 => &["sphere", "koule"],
        12 => &["box", "kvádr", "cube", "krychle"],
        10 => &["ellipsoid", "elipsoid"],
        14 => &["torus", "anuloid"],
        16 => &["cone", "kužel"],
        -1 => &["move", "translate", "posuv", "posun"],
        -2 => &["rotate", "rotace"],
        -3 => &["scale", "měřítko"],
        -101 => &["union", "sjednocení"],
        -102 => &["intersection", "průnik"],
        -103 => &["difference", "rozdíl"],
        -105 => &["copy", "kopie"],
        -299 => &["material", "vlastnosti", "assign", "přiřazení vlastností"],
        -402 => &["light", "světlo", "lamp", "bodové světlo"],
        -501 => &["camera", "kamera"],
        -701 => &["color", "colour", "barva"],
        9999 => &["render", "scene"],
        _ => return None,
    };
    written(r, r.with(names[rng.below(names.len())], &r.params))
}

fn per_cent(_: &mut Rng, all: &[Record], i: usize) -> Option<Written> {
    let r = &all[i];
    let share = |p: &String| format!("{}%", (p.parse::<f64>().unwrap() * 100.0).round());
    let params: Vec<String> = r.params.iter().map(share).collect();
    matches!(r.code, -201 | -202 | -701)
        .then(|| written(r, r.with(&r.code.to_string(), &params)))?
}

fn degree(_: &mut Rng, all: &[Record], i: usize) -> Option<Written> {
    let r = &all[i];
    let at = match r.code {
        -2 => 0,
        -501 => 9,
        _ => return None,
    };
    let mut params = r.params.clone();
    params[at] += "°";
    written(r, r.with(&r.code.to_string(), &params))
}

fn fraction(rng: &mut Rng, all: &[Record], i: usize) -> Option<Written> {
    let r = &all[i];
    let last = match r.code {
        13 => 0,
        9..=12 | 14 | 16..=19 | 21 | -1 | -3 | -302 | -401 | -402 => r.params.len() - 1,
        _ => return None,
    };
    let (above, below) = *rng.pick(&[(1.0, 2.0), (3.0, 4.0), (1.0, 3.0), (2.0, 3.0)]);
    let mut params = r.params.clone();
    params[last] = format!("{}", above / below);
    let meant = r.with(&r.code.to_string(), &params);
    params[last] = format!("{above}/{below}");
    let line = r.with(&r.code.to_string(), &params);
    Some(Written { line, meant })
}

fn swapped(_: &mut Rng, all: &[Record], i: usize) -> Option<Written> {
    let r = &all[i];
    (r.code == -299)
        .then(|| written(r, format!("{} -299 {} {}", r.id, r.params[1], r.params[0])))?
}

/// Only one order makes sense where the smaller operand lies within the larger.
fn difference(_: &mut Rng, all: &[Record], i: usize) -> Option<Written> {
    let r = &all[i];
    if r.code != -103 || !lies_within(all, &r.params[1], &r.params[0]) {
        return None;
    }
    written(r, format!("{} -103 {} {}", r.id, r.params[1], r.params[0]))
}

/// Whether many points of one object, as it is at the end of the records, are all in another.
fn lies_within(all: &[Record], inner: &str, outer: &str) -> bool {
    let ends = |id: &str| format!("{}1 9999 {id} 0\n", text(&all[..all.len() - 1]));
    let [one, two] = [inner, outer].map(|id| super::read(&ends(id)));
    let root = |a: &Analysis| a.scene.render.as_ref().map(|r| r.root);
    let (Some(inner), Some(outer)) = (root(&one), root(&two)) else {
        return false;
    };
    let bounds = one.bounds()[inner as usize].all;
    let mut small = Inside::new(&one.scene, one.bounds());
    let mut large = Inside::new(&two.scene, two.bounds());
    let mut rng = Rng::new(0);
    (0..20_000).all(|_| {
        let p = std::array::from_fn(|k| rng.range(bounds.min[k], bounds.max[k]));
        small.node(inner, p) != Some(true) || large.node(outer, p) == Some(true)
    })
}

fn object(_: &mut Rng, all: &[Record], i: usize) -> Option<Written> {
    let r = &all[i];
    (r.code == -299)
        .then(|| written(r, format!("{} -299 {} {}", r.params[1], r.params[0], r.id)))?
}

fn off_by_one(rng: &mut Rng, all: &[Record], i: usize) -> Option<Written> {
    let r = &all[i];
    let references = match r.code {
        -103..=-101 | -299 | -302 | -503 | 9999 => 0..2,
        -105 | -104 | -502 => 0..1,
        -399 => 2..4,
        _ => return None,
    };
    let by = *rng.pick(&[1, -1]);
    let mut params = r.params.clone();
    // Beside a `0`, something of the other kind is written as texture and optics swapped.
    let shifted = |p: &String| p.parse().map(|id: i64| id + by);
    let is_any = |p: &String, codes: &[i32]| {
        let is_it = |t: &Record| Ok(i64::from(t.id)) == shifted(p) && codes.contains(&t.code);
        all.iter().any(is_it)
    };
    if r.code == -299
        && (params[0] == "0" && is_any(&params[1], &[-701, -399, -302])
            || params[1] == "0" && is_any(&params[0], &[-201, -202]))
    {
        return None;
    }
    for p in &mut params[references] {
        let id: i64 = p.parse().unwrap();
        if id > 0 {
            *p = (id + by).to_string();
        }
    }
    written(r, r.with(&r.code.to_string(), &params))
}

fn doubled(_: &mut Rng, all: &[Record], i: usize) -> Option<Written> {
    let r = &all[i];
    if !matches!(r.code, 3..=8 | 10..=12 | -1 | -3 | -201 | -203 | -602 | -701 | -501) {
        return None;
    }
    let params = [r.params.clone(), r.params.clone()].concat();
    written(r, r.with(&r.code.to_string(), &params))
}
