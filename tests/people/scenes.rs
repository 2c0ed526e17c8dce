//! Scenes as students write them, a record a line, with nothing to be said of them.

use zpg::internals::analysis::Analysis;

use crate::rng::Rng;

/// A record: its ID, its type, and its parameters as they are spelled.
#[derive(Debug, Clone, PartialEq)]
pub struct Record {
    pub id: u32,
    pub code: i32,
    pub params: Vec<String>,
    /// The lines above it that are no records.
    pub above: String,
    /// The comment behind it.
    pub behind: String,
}

impl Record {
    pub fn line(&self) -> String {
        format!("{} {} {}", self.id, self.code, self.params.join(" "))
    }

    /// The line with another type and other parameters.
    pub fn with(&self, code: &str, params: &[String]) -> String {
        format!("{} {code} {}", self.id, params.join(" "))
    }
}

pub fn text(records: &[Record]) -> String {
    (records.iter())
        .map(|r| format!("{}{}{}\n", r.above, r.line(), r.behind))
        .collect()
}

#[derive(Default)]
struct Maker {
    records: Vec<Record>,
    next: u32,
    /// IDs count by this.
    step: u32,
    comments: bool,
}

impl Maker {
    fn new_id(&mut self) -> u32 {
        self.next += self.step;
        self.next
    }

    fn add(&mut self, id: u32, code: i32, params: &[f64]) {
        // Some lines have a comment.
        let n = self.records.len();
        let behind = match self.comments && n.is_multiple_of(3) {
            true => format!(" # část {n} #"),
            false => String::new(),
        };
        self.records.push(Record {
            id,
            code,
            params: params.iter().map(f64::to_string).collect(),
            above: String::new(),
            behind,
        });
    }

    fn define(&mut self, code: i32, params: &[f64]) -> u32 {
        let id = self.new_id();
        self.add(id, code, params);
        id
    }

    fn define_from(&mut self, code: i32, ids: [u32; 2]) -> u32 {
        self.define(code, &ids.map(f64::from))
    }
}

/// A number with one decimal between two.
fn tenth(rng: &mut Rng, low: f64, high: f64) -> f64 {
    (rng.range(low, high) * 10.0).round() / 10.0
}

/// Three shares that are no more than 1 together.
fn shares(rng: &mut Rng) -> [f64; 3] {
    *rng.pick(&[
        [0.6, 0.3, 0.0],
        [0.8, 0.1, 0.0],
        [0.7, 0.2, 0.1],
        [0.5, 0.5, 0.0],
        [1.0, 0.0, 0.0],
        [0.9, 0.1, 0.0],
        [0.1, 0.2, 0.7],
    ])
}

fn colour(rng: &mut Rng) -> [f64; 3] {
    std::array::from_fn(|_| tenth(rng, 0.0, 1.0))
}

/// A shape around the origin that is at most 2 wide.
fn shape(rng: &mut Rng, make: &mut Maker) -> u32 {
    let r = tenth(rng, 0.5, 1.0);
    let s = tenth(rng, 0.4, 0.9);
    match rng.below(14) {
        0..=2 => make.define(11, &[0.0, tenth(rng, 0.0, 1.0), 0.0, r]),
        3 => make.define(9, &[r]),
        4 => make.define(10, &[r, s, tenth(rng, 0.4, 0.9)]),
        5..=7 => make.define(12, &[-r, 0.0, -s, r, s, s]),
        8 => make.define(14, &[0.8, 0.2]),
        9 => make.define(16, &[-r, s]),
        10 => make.define(13, &[r, 2.0]),
        11 => make.define(17, &[r, s]),
        12 => {
            let q = [
                1.0, 0.0, 0.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, -r,
            ];
            make.define(15, &q)
        }
        _ => make.define(1, &[3.0, 0.0, 0.0, s, 0.5, 0.0, r]),
    }
}

/// A scene of at most `most` records, the same for the same numbers. It has nothing to be said of.
pub fn scene(rng: &mut Rng, most: usize) -> Vec<Record> {
    loop {
        let records = draft(rng, most);
        let analysis = Analysis::new("scene.zpg", text(&records).into_bytes());
        if (5..=most).contains(&records.len()) && analysis.findings().is_empty() {
            return records;
        }
    }
}

/// The first try at one.
pub fn draft(rng: &mut Rng, most: usize) -> Vec<Record> {
    let mut make = Maker {
        next: 10,
        step: 10,
        ..Maker::default()
    };
    make.comments = rng.chance(0.5);
    // Some count by one, some by ten.
    if rng.chance(0.7) {
        (make.next, make.step) = (1, 1);
    }
    let groups = 1 + rng.below((most / 7).max(1));
    // What several objects use.
    let mut textures: Vec<u32> = Vec::new();
    let mut optics: Vec<u32> = Vec::new();
    if groups > 1 {
        let first = make.define(-701, &colour(rng));
        textures.push(first);
        if rng.chance(0.5) {
            let second = make.define(-701, &colour(rng));
            let board = [4.0, 4.0, f64::from(first), f64::from(second)];
            textures.push(make.define(-399, &board));
            textures.push(second);
        }
        let grey = shares(rng);
        optics.push(make.define(-201, &grey));
        if rng.chance(0.5) {
            let [a, b, c] = [shares(rng), shares(rng), shares(rng)];
            optics.push(make.define(-202, &[a, b, c].concat()));
        }
    }
    let mut all: Option<u32> = None;
    for group in 0..groups {
        let at = 3.0 * group as f64 - 3.0 * (groups / 2) as f64;
        let surface = rng.chance(0.2);
        let mut object = match surface {
            true if rng.chance(0.5) => make.define(5, &[-1.0, 0.0, 1.0, 1.5]),
            true => make.define(6, &[-1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.5, 0.5]),
            false => shape(rng, &mut make),
        };
        match if surface { 5 } else { rng.below(5) } {
            // A ball that is hollow, or a corner cut off.
            0 => {
                let hole = make.define(11, &[0.0, 0.0, 0.0, 0.25]);
                if rng.chance(0.5) {
                    make.add(hole, -1, &[0.3, 0.4, 0.0]);
                }
                object = make.define_from(-103, [object, hole]);
            }
            1 => {
                let half = make.define(4, &[1.0, 1.0, 0.0, -0.3]);
                object = make.define_from(-102, [object, half]);
            }
            2 => {
                let copy = make.define(-105, &[f64::from(object)]);
                make.add(copy, -1, &[0.0, 2.5, 0.0]);
                object = make.define_from(-101, [object, copy]);
            }
            _ => {}
        }
        if rng.chance(0.4) {
            let angle = *rng.pick(&[10.0, 20.0, 30.0, 45.0, 90.0, -30.0]);
            make.add(object, -2, &[angle, 1.0 + rng.below(3) as f64]);
        }
        if rng.chance(0.1) {
            let quarter = [
                0., 0., 1., 0., 0., 1., 0., 0., -1., 0., 0., 0., 0., 0., 0., 1.,
            ];
            make.add(object, -4, &quarter);
        }
        if rng.chance(0.2) {
            make.add(object, -3, &[1.2, 0.8, 1.2]);
        }
        if at != 0.0 {
            make.add(object, -1, &[at, tenth(rng, 0.0, 1.0), 0.0]);
        }
        match rng.below(7) {
            0 => make.add(object, -701, &colour(rng)),
            1 | 5 | 6 if !optics.is_empty() => {
                let t = if rng.chance(0.3) {
                    0
                } else {
                    *rng.pick(&textures)
                };
                let ids = [t, *rng.pick(&optics)];
                make.add(object, -299, &ids.map(f64::from));
            }
            2 => {
                let grey = shares(rng);
                make.add(object, -201, &grey);
            }
            3 => {
                make.add(object, -201, &[0.1, 0.2, 0.7]);
                make.add(object, -203, &[1.5, 1.5, 1.5]);
            }
            _ => {}
        }
        if rng.chance(0.1) {
            make.add(object, -602, &[at, 0.0, 0.0, 30.0]);
        }
        all = Some(match all {
            Some(before) => make.define_from(-101, [before, object]),
            None => object,
        });
    }
    if rng.chance(0.4) {
        make.define(-401, &[0.2]);
    }
    let lamp = make.define(-402, &[tenth(rng, 0.5, 1.0)]);
    make.add(lamp, -1, &[5.0, 8.0, 9.0]);
    if rng.chance(0.4) {
        make.add(lamp, -701, &[1.0, 0.9, 0.8]);
    }
    let camera = make.define(
        -501,
        &[0.0, 3.0, 15.0, 0.0, -3.0, -15.0, 0.0, 1.0, 0.0, 40.0],
    );
    if rng.chance(0.2) {
        make.define(-502, &[f64::from(camera)]);
    }
    let back = match textures.first() {
        Some(&colour) if rng.chance(0.5) => colour,
        _ => 0,
    };
    make.add(1, 9999, &[f64::from(all.unwrap_or(0)), f64::from(back)]);
    make.records
}
