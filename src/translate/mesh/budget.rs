//! Limits on how many triangles there may be, and how much work is put into joining them, so that a
//! small tolerance ends in words and not in full memory or never.

use crate::diagnostics::{Complaint, Value};

/// The most triangles that are made: about two gigabytes of them.
pub(super) const MOST_TRIANGLES: u64 = 1 << 25;

/// The most triangles that operations are given, each as often as it is given to one: some minutes.
const MOST_WORK: f64 = (1u64 << 24) as f64;

/// Factor over the limit at which work that is expected is not begun: where solids lie in heaps, more goes in later
/// rounds than in the first.
const WORK_OVERRUN: f64 = 1.5;

/// Bytes taken for each triangle on the way to a file: measured on a geodesic sphere of five million, which takes 440
/// for each.
const BYTES: u64 = 512;

/// How many triangles there are so far, and how many there may be.
#[derive(Debug)]
pub struct Budget {
    most: u64,
    spent: u64,
    work: f64,
}

/// The error of a mesh with too many triangles.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum TooMany {
    /// A mesh that needs at least `needed` triangles, of which `most` may be made.
    Made { needed: f64, most: u64 },
    /// Solids that overlap and are to be joined: their number, and one of them.
    Joined { solids: usize, shape: u32 },
}

/// Solids that overlap and are too many to be joined.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Crowd {
    pub solids: usize,
    /// A label of one of the solids.
    pub label: u32,
}

impl Crowd {
    /// Whether joining so many triangles in all is beyond the limit for certain. Half of what is joined is taken to be
    /// left of each pair at the end.
    pub fn is_hopeless(&self, triangles: usize) -> bool {
        let rounds = (self.solids as f64).log2().max(1.0);
        triangles as f64 * rounds / 2.0 > MOST_WORK
    }
}

impl TooMany {
    /// The message in words, with what to do about it.
    pub fn complaint(&self) -> Complaint {
        match self {
            TooMany::Made { needed, most } if !needed.is_finite() => {
                Complaint::new("too-many-to-count").with("most", most.to_string())
            }
            TooMany::Made { needed, most } => Complaint::new("too-many-triangles")
                .with("needed", format!("{needed:.3e}"))
                .with("most", most.to_string()),
            TooMany::Joined { solids, shape } => Complaint::new("too-many-joined")
                .with("solids", Value::Count(*solids as u64))
                .with("shape", shape.to_string()),
        }
    }
}

impl Default for Budget {
    fn default() -> Budget {
        Budget::of(None)
    }
}

impl Budget {
    /// The budget of so much memory, in bytes.
    pub fn of(memory: Option<u64>) -> Budget {
        Budget {
            most: memory.map_or(MOST_TRIANGLES, |m| (m / BYTES).min(MOST_TRIANGLES)),
            spent: 0,
            work: 0.0,
        }
    }

    /// Asks for as many triangles as are to come at least, before any is made.
    ///
    /// # Errors
    /// There would be too many.
    pub fn foresee(&self, needed: f64) -> Result<(), TooMany> {
        match needed <= self.most as f64 {
            true => Ok(()),
            false => Err(TooMany::Made {
                needed,
                most: self.most,
            }),
        }
    }

    /// Asks for some more triangles before they are made.
    ///
    /// # Errors
    /// There would be too many.
    pub fn spend(&mut self, triangles: f64) -> Result<(), TooMany> {
        let needed = self.spent as f64 + triangles;
        self.foresee(needed)?;
        self.spent = needed as u64;
        Ok(())
    }

    /// Whether joining solids of so many triangles two by two, in so many rounds, will be beyond the
    /// limit. `left`: what share of the triangles each round leaves; it is taken to go on like the last.
    pub fn will_not_do(&self, triangles: usize, left: &[f64], rounds: u32) -> bool {
        let last = left.last().copied().unwrap_or(1.0);
        let left = left.iter().copied().chain(std::iter::repeat(last));
        let (mut work, mut there) = (self.work, triangles as f64);
        for left in left.take(rounds as usize) {
            work += there;
            there *= left;
        }
        work > WORK_OVERRUN * MOST_WORK
    }

    /// Asks for operations on so many triangles.
    ///
    /// # Errors
    /// There would be too many.
    pub fn work(&mut self, triangles: usize, crowd: Crowd) -> Result<(), Crowd> {
        self.work += triangles as f64;
        if self.work <= MOST_WORK {
            Ok(())
        } else {
            Err(crowd)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_stays_is_work_in_each_round() {
        let budget = Budget::default();
        let most = MOST_WORK as usize;
        // Nothing goes: 1 + 1; half of it goes: less than 1 + 1.
        assert!(!budget.will_not_do(most, &[1.0], 1) && budget.will_not_do(most, &[1.0], 2));
        assert!(!budget.will_not_do(most / 2, &[0.5], 30));
        // Nine tenths stay: ten times as much in the end.
        assert!(!budget.will_not_do(most / 10, &[0.9], 30));
        assert!(budget.will_not_do(most * 9 / 50, &[0.9], 30));
        // All but a little goes in the first round, nothing later.
        assert!(!budget.will_not_do(most, &[0.01, 1.0], 30));
        assert!(budget.will_not_do(most, &[0.1, 1.0], 30));
    }
}
