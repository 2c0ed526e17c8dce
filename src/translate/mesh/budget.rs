//! Limits on the number of triangles and on the work of joining them: a tolerance that is too small ends with a
//! message, rather than with full memory or never.

use crate::diagnostics::{Complaint, Value};

/// The most triangles that are made: about two gigabytes of them.
pub(super) const MOST_TRIANGLES: u64 = 1 << 25;

/// The most work on operations, in triangles: each operation counts the triangles that it is given. The limit is some
/// minutes of work.
const MOST_WORK: f64 = (1u64 << 24) as f64;

/// Factor by which the expected work must be over the limit for joining not to begin. The estimate may be too high:
/// where solids lie in heaps, more triangles vanish in later rounds than in the first.
const WORK_OVERRUN: f64 = 1.5;

/// Bytes of memory for each triangle on the way to a file. A geodesic sphere of five million triangles was measured
/// to take 440 for each.
const BYTES: u64 = 512;

/// Counts the triangles and the work on them, and refuses what goes over the limits.
#[derive(Debug)]
pub struct Budget {
    most: u64,
    spent: u64,
    work: f64,
}

/// The error of a mesh with too many triangles.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum TooMany {
    /// The mesh needs at least `needed` triangles; the limit is `most`.
    Made { needed: f64, most: u64 },
    /// Too many overlapping solids to join: how many they are, and the ID of a shape that is one of them.
    Joined { solids: usize, shape: u32 },
}

/// A group of overlapping solids that are to be joined; the error if they are too many.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Crowd {
    pub solids: usize,
    /// A label of one of the solids.
    pub label: u32,
}

impl Crowd {
    /// Whether joining these solids, with `triangles` in all, is certainly beyond the limit. The estimate is low:
    /// each round is taken to work on half of the triangles.
    pub fn is_hopeless(&self, triangles: usize) -> bool {
        let rounds = (self.solids as f64).log2().max(1.0);
        triangles as f64 * rounds / 2.0 > MOST_WORK
    }
}

impl TooMany {
    /// The message for the user, with advice.
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
    /// The budget for `memory` bytes; `None` sets the usual limit.
    pub fn of(memory: Option<u64>) -> Budget {
        Budget {
            most: memory.map_or(MOST_TRIANGLES, |m| (m / BYTES).min(MOST_TRIANGLES)),
            spent: 0,
            work: 0.0,
        }
    }

    /// Checks that `needed` triangles in all are within the limit, before any is made. Does not count them.
    ///
    /// # Errors
    /// More triangles are needed than may be made.
    pub fn foresee(&self, needed: f64) -> Result<(), TooMany> {
        match needed <= self.most as f64 {
            true => Ok(()),
            false => Err(TooMany::Made {
                needed,
                most: self.most,
            }),
        }
    }

    /// Counts `triangles` more, before they are made.
    ///
    /// # Errors
    /// There would be more triangles than may be made.
    pub fn spend(&mut self, triangles: f64) -> Result<(), TooMany> {
        let needed = self.spent as f64 + triangles;
        self.foresee(needed)?;
        self.spent = needed as u64;
        Ok(())
    }

    /// Whether joining solids two by two is expected to go over the limit. `triangles` is the number of their
    /// triangles, `left` the share of the triangles that each round leaves; rounds beyond the list leave as much as
    /// its last.
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

    /// Counts the work of an operation on `triangles`.
    ///
    /// # Errors
    /// The work goes over the limit; the error is `crowd`.
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
