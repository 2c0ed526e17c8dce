//! The CPU time that is done in a second: on a busy machine less than the number of threads.

/// CPU time and wall time of what has been done so far.
#[derive(Debug, Clone, Copy)]
pub(super) struct Pace {
    /// CPU and wall seconds of the work on one thread.
    one: [f64; 2],
    /// CPU and wall seconds of the work on all threads together.
    all: [f64; 2],
}

/// Seconds of work on an idle machine that a pace starts with, before anything is measured.
const PRIOR: f64 = 0.05;

impl Pace {
    pub(super) fn new(threads: f64) -> Pace {
        Pace {
            one: [PRIOR, PRIOR],
            all: [PRIOR * threads, PRIOR],
        }
    }

    /// Counts in work on one thread.
    pub(super) fn one(&mut self, cpu: f64, wall: f64) {
        self.one = [self.one[0] + cpu, self.one[1] + wall];
    }

    /// Counts in work on all threads.
    pub(super) fn all(&mut self, cpu: f64, wall: f64) {
        self.all = [self.all[0] + cpu, self.all[1] + wall];
    }

    /// CPU seconds that one thread gets in a second.
    pub(super) fn of_one(self) -> f64 {
        (self.one[0] / self.one[1]).clamp(0.05, 1.0)
    }

    /// CPU seconds that all threads together get in a second.
    pub(super) fn of_all(self) -> f64 {
        (self.all[0] / self.all[1]).max(self.of_one())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_busy_machine_does_less_in_a_second() {
        let mut pace = Pace::new(4.0);
        assert_eq!((pace.of_one(), pace.of_all()), (1.0, 4.0));
        pace.one(10.0, 20.0);
        pace.all(30.0, 20.0);
        assert!((pace.of_one() - 0.5).abs() < 0.01, "{pace:?}");
        assert!((pace.of_all() - 1.5).abs() < 0.01, "{pace:?}");
    }
}
