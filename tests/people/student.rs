//! Scenes as students write them for a course: groups under headings, IDs in hundreds or in no order, a comment behind
//! each line, round numbers, all kinds of shapes, unions within unions.

use zpg::internals::analysis::Analysis;

use super::scenes::{Record, text};
use crate::rng::Rng;

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
    Student::new(rng, most).write(most)
}

/// How somebody gives IDs.
#[derive(Debug, Clone, Copy)]
enum Numbering {
    /// A hundred for each group, then by ten.
    Hundreds,
    /// In no order.
    Mixed,
    /// From a large one down.
    Down,
    /// By ten.
    Tens,
}

struct Student<'a> {
    rng: &'a mut Rng,
    records: Vec<Record>,
    numbering: Numbering,
    group: u32,
    next: u32,
    free: Vec<u32>,
    /// What the next record has above it.
    heading: String,
    has_comments: bool,
}

const WORDS: &[&str] = &[
    "koule",
    "stůl",
    "noha stolu",
    "red",
    "lampa vlevo",
    "the big one",
    "hrnek",
    "střecha",
    "x",
    "díra",
    "left window",
    "skleněná",
];

impl Student<'_> {
    fn new(rng: &mut Rng, most: usize) -> Student<'_> {
        let numbering = *rng.pick(&[
            Numbering::Hundreds,
            Numbering::Mixed,
            Numbering::Down,
            Numbering::Tens,
        ]);
        let mut free: Vec<u32> = (2..3 * most as u32 + 10).collect();
        for i in (1..free.len()).rev() {
            free.swap(i, rng.below(i + 1));
        }
        if matches!(numbering, Numbering::Down) {
            free.sort_unstable();
        }
        Student {
            has_comments: rng.chance(0.7),
            rng,
            records: Vec::new(),
            numbering,
            group: 0,
            next: 0,
            free,
            heading: String::new(),
        }
    }

    fn group(&mut self, heading: &str) {
        self.group += 1;
        self.next = 0;
        self.heading = match self.rng.below(3) {
            0 => format!("\n# --- {heading} --- #\n"),
            1 => format!("\n0 # {heading} #\n"),
            _ => "\n".to_owned(),
        };
        // A comment without a `0` is a matter of style.
        if self.heading.starts_with("\n#") {
            self.heading.insert_str(1, "0 ");
        }
    }

    fn id(&mut self) -> u32 {
        self.next += 1;
        match self.numbering {
            Numbering::Hundreds => 100 * self.group + 10 * (self.next - 1),
            Numbering::Tens => 10 * (1 + self.records.len() as u32),
            Numbering::Mixed | Numbering::Down => self.free.pop().expect("there are enough"),
        }
    }

    fn add(&mut self, id: u32, code: i32, params: &[f64]) {
        let behind = match self.has_comments && self.rng.chance(0.6) {
            true => format!(" # {} #", self.rng.pick(WORDS)),
            false => String::new(),
        };
        self.records.push(Record {
            id,
            code,
            params: params.iter().map(f64::to_string).collect(),
            above: std::mem::take(&mut self.heading),
            behind,
        });
    }

    fn define(&mut self, code: i32, params: &[f64]) -> u32 {
        let id = self.id();
        self.add(id, code, params);
        id
    }

    fn size(&mut self) -> f64 {
        *self.rng.pick(&[0.5, 1.0, 1.5, 2.0, 0.8, 5.0, 10.0])
    }

    fn place(&mut self) -> f64 {
        *self
            .rng
            .pick(&[0.0, 0.0, 1.0, -1.0, 2.0, 5.0, -5.0, 10.0, 0.5, 100.0])
    }

    fn colour(&mut self) -> [f64; 3] {
        std::array::from_fn(|_| *self.rng.pick(&[0.0, 1.0, 0.5, 1.0, 0.2, 0.8]))
    }

    fn grey(&mut self) -> [f64; 3] {
        *self.rng.pick(&[
            [1.0, 0.0, 0.0],
            [0.5, 0.5, 0.0],
            [0.0, 1.0, 0.0],
            [0.2, 0.3, 0.5],
            [0.7, 0.3, 0.0],
        ])
    }

    fn solid(&mut self) -> u32 {
        let (a, b) = (self.size(), self.size());
        match self.rng.below(19) {
            0 | 1 => {
                let at = [self.place(), self.place(), self.place()];
                self.define(11, &[at[0], at[1], at[2], a])
            }
            2 => self.define(9, &[a]),
            3 => self.define(10, &[a, b, 1.0]),
            4..=6 => self.define(12, &[-a, 0.0, -b, a, b, b]),
            7 => self.define(14, &[a + b, b]),
            8 => self.define(16, &[a, b]),
            9 => self.define(17, &[a, b]),
            10 => self.define(13, &[a, 2.0]),
            11 => self.define(1, &[4.0, 0.0, 0.0, a, 0.0, a, b, 0.0, b]),
            12 => {
                let profile = [3.0, 0.0, 0.0, a, b, 0.0, 2.0 * b];
                let colours = [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0];
                self.define(2, &[&profile[..], &colours].concat())
            }
            13 => {
                let code = *self.rng.pick(&[18, 19, 20, 21]);
                let open = match code {
                    18 => self.define(18, &[b]),
                    20 => self.define(20, &[1.0, a, b, 1.0]),
                    code => self.define(code, &[a, b]),
                };
                let around = self.define(12, &[-3.0, -3.0, -3.0, 3.0, 3.0, 3.0]);
                self.define(-102, &[open.into(), around.into()])
            }
            14 => {
                let all = self.define(12, &[-1.0, -1.0, -1.0, 1.0, 1.0, 1.0]);
                let hole = self.define(11, &[0.0, 0.0, 1.0, 0.5]);
                let rest = self.define(-104, &[hole.into()]);
                self.define(-102, &[all.into(), rest.into()])
            }
            15 => {
                let ball = self.define(11, &[0.0, 0.0, 0.0, 2.0]);
                let half = self.define(4, &[0.0, 1.0, 0.0, -1.0]);
                self.define(-102, &[ball.into(), half.into()])
            }
            _ => self.difference(),
        }
    }

    /// Something with a hole, a dent or a hollow.
    fn difference(&mut self) -> u32 {
        let large = match self.rng.below(4) {
            0 => self.define(12, &[-3.0, -3.0, -3.0, 3.0, 3.0, 3.0]),
            1 => self.define(10, &[4.0, 3.5, 5.0]),
            _ => self.define(11, &[0.0, 0.0, 0.0, 3.0]),
        };
        let small = match self.rng.below(8) {
            0 => self.define(11, &[1.0, 1.0, 0.0, 1.0]),
            1 => self.define(9, &[2.0]),
            2 => self.define(12, &[-1.0, -1.0, -1.0, 1.0, 1.0, 1.0]),
            3 => self.define(14, &[1.5, 0.5]),
            4 => self.define(16, &[1.5, 1.0]),
            5 => self.define(10, &[1.0, 2.0, 1.5]),
            6 => {
                let a = self.define(11, &[1.0, 0.0, 0.0, 0.5]);
                let b = self.define(11, &[-1.0, 0.0, 0.0, 0.5]);
                self.define(-101, &[a.into(), b.into()])
            }
            _ => self.define(11, &[2.5, 0.0, 0.0, 1.0]),
        };
        if self.rng.chance(0.3) {
            self.add(small, -1, &[0.0, 0.5, 0.5]);
        }
        self.define(-103, &[large.into(), small.into()])
    }

    fn surface(&mut self) -> u32 {
        match self.rng.below(5) {
            0 => self.define(5, &[-10.0, -10.0, 10.0, 10.0]),
            1 => self.define(6, &[0.0, 0.0, 0.0, 5.0, 0.0, 0.0, 0.0, 5.0, 0.0]),
            2 => self.define(
                7,
                &[0.0, 0.0, 0.0, 5.0, 0.0, 0.0, 0.0, 5.0, 1.0, 0.0, 0.0, 1.0],
            ),
            3 => {
                let corners = [0.0, 0.0, 0.0, 5.0, 0.0, 0.0, 0.0, 5.0, 1.0];
                let normals = [0.0, 0.0, 1.0, 0.0, 0.5, 1.0, 0.5, 0.0, 1.0];
                self.define(8, &[corners, normals].concat())
            }
            _ => self.define(3, &[0.0, 1.0, 0.0, 10.0]),
        }
    }

    /// What is done to an object once it is there.
    fn change(&mut self, object: u32, textures: &[u32], optics: &[u32]) {
        if self.rng.chance(0.3) {
            let angle = *self.rng.pick(&[90.0, 45.0, -90.0, 180.0, 30.0]);
            let axis = 1.0 + self.rng.below(3) as f64;
            self.add(object, -2, &[angle, axis]);
        }
        if self.rng.chance(0.2) {
            let s = *self.rng.pick(&[2.0, 0.5, 10.0]);
            self.add(object, -3, &[s, s, s]);
        }
        if self.rng.chance(0.6) {
            let at = [self.place(), self.place(), self.place() + 0.5];
            self.add(object, -1, &at);
        }
        match self.rng.below(6) {
            0 => {
                let colour = self.colour();
                self.add(object, -701, &colour);
            }
            1 => {
                let grey = self.grey();
                self.add(object, -201, &grey);
            }
            2 => {
                self.add(object, -201, &[0.0, 0.1, 0.9]);
                self.add(object, -203, &[1.5, 1.5, 1.5]);
            }
            3 | 4 if !textures.is_empty() => {
                let texture = if self.rng.chance(0.2) {
                    0
                } else {
                    *self.rng.pick(textures)
                };
                let optics = match optics {
                    [] => 0,
                    _ if texture != 0 && self.rng.chance(0.3) => 0,
                    all => *self.rng.pick(all),
                };
                if texture + optics > 0 {
                    self.add(object, -299, &[texture.into(), optics.into()]);
                }
            }
            _ => {}
        }
    }

    fn palette(&mut self) -> (Vec<u32>, Vec<u32>) {
        let (mut textures, mut optics) = (Vec::new(), Vec::new());
        self.group("barvy");
        for _ in 0..1 + self.rng.below(3) {
            let colour = self.colour();
            textures.push(self.define(-701, &colour));
        }
        if self.rng.chance(0.5) {
            let (a, b) = (textures[0], textures[textures.len() - 1]);
            let n = *self.rng.pick(&[8.0, 10.0, 20.0]);
            textures.push(match self.rng.chance(0.5) {
                true => self.define(-399, &[n, n, a.into(), b.into()]),
                false => self.define(-302, &[a.into(), b.into(), 0.5]),
            });
        }
        self.group("materiály");
        for _ in 0..self.rng.below(3) {
            let grey = self.grey();
            optics.push(self.define(-201, &grey));
        }
        if self.rng.chance(0.4) {
            let all = [self.grey(), self.grey(), self.grey()].concat();
            optics.push(self.define(-202, &all));
        }
        (textures, optics)
    }

    fn write(mut self, most: usize) -> Vec<Record> {
        let (textures, optics) = match most > 14 {
            true => self.palette(),
            false => (Vec::new(), Vec::new()),
        };
        let mut parts: Vec<u32> = Vec::new();
        for _ in 0..1 + self.rng.below((most / 7).max(1)) {
            self.group("objekt");
            let object = match self.rng.chance(0.2) {
                true => self.surface(),
                false => self.solid(),
            };
            self.change(object, &textures, &optics);
            parts.push(object);
            if self.rng.chance(0.3) {
                let copy = self.define(-105, &[object.into()]);
                self.add(copy, -1, &[12.0, 0.0, 3.0]);
                parts.push(copy);
            }
        }
        self.group("scéna");
        // Two of them become one, until one is left.
        while parts.len() > 1 {
            let a = parts.remove(self.rng.below(parts.len()));
            let b = parts.remove(self.rng.below(parts.len()));
            let both = self.define(-101, &[a.into(), b.into()]);
            if self.rng.chance(0.2) {
                self.add(both, -2, &[20.0, 2.0]);
            }
            parts.push(both);
        }
        let root = parts[0];
        if self.rng.chance(0.15) {
            self.add(root, -602, &[0.0, 0.0, 0.0, 1000.0]);
        }
        self.group("světla");
        if self.rng.chance(0.5) {
            self.define(-401, &[0.1]);
        }
        for _ in 0..1 + self.rng.below(2) {
            let lamp = self.define(-402, &[1.0]);
            let at = [100.0, 100.0, self.place()];
            self.add(lamp, -1, &at);
            if self.rng.chance(0.3) {
                self.add(lamp, -701, &[1.0, 1.0, 0.8]);
            }
        }
        self.group("kamera");
        let view = [0.0, 10.0, 100.0, 0.0, -10.0, -100.0, 0.0, 1.0, 0.0, 45.0];
        let camera = self.define(-501, &view);
        match self.rng.below(4) {
            0 => {
                self.define(-502, &[camera.into()]);
            }
            1 => {
                let mut other = view;
                other[0] = 5.0;
                let right = self.define(-501, &other);
                self.define(-503, &[camera.into(), right.into()]);
            }
            _ => {}
        }
        let back = match textures.first() {
            Some(&colour) if self.rng.chance(0.5) => colour,
            _ => 0,
        };
        self.heading = "\n".into();
        self.add(1, 9999, &[root.into(), back.into()]);
        self.records
    }
}
