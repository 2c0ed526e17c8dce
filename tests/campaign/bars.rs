//! How far crossings may be from the surface, kind by kind of shape: a ratchet. What the kernel has
//! reached in a long campaign it must not lose by more than half. Where axes are far apart, both
//! have a bar of 4 ε of doubles for every kind. `cargo bench --bench campaign -- 1e7 1 --renew` writes the file.

/// The largest distances of a kind of shape, in ε times the larger of the origin's distance and the
/// shape's size.
#[derive(Debug, Clone, Copy)]
pub struct Bars {
    f64: f64,
    dd: f64,
}

const FILE: &str = include_str!("bars.tsv");

/// Where [`FILE`] is.
pub const PATH: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/campaign/bars.tsv");

impl Bars {
    /// Nothing is too far.
    pub const NONE: Bars = Bars {
        f64: f64::INFINITY,
        dd: f64::INFINITY,
    };

    /// Those of the file.
    pub fn of_kind(name: &str) -> Bars {
        let line = FILE
            .lines()
            .find_map(|line| line.strip_prefix(name)?.strip_prefix('\t'));
        let numbers = line.unwrap_or_else(|| panic!("no bars for the {name} in {PATH}"));
        let mut numbers = numbers.split('\t').map(|x| x.parse().expect("a number"));
        let mut next = || numbers.next().expect("a number for f64 and one for dd");
        Bars {
            f64: next(),
            dd: next(),
        }
    }

    /// Single precision is shown only.
    pub fn of(&self, precision: &str) -> f64 {
        match precision {
            "f64" => self.f64,
            "dd" => self.dd,
            _ => f64::INFINITY,
        }
    }
}
