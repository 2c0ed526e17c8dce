//! Times of runs, and their noise.

/// The least, the median and the largest of some times, in seconds, and the number of times.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct Spread {
    pub min: f64,
    pub median: f64,
    pub max: f64,
    pub runs: usize,
}

impl Spread {
    /// The spread of times; `None` without times.
    pub fn of(times: &[f64]) -> Option<Spread> {
        let mut sorted = times.to_vec();
        sorted.sort_by(f64::total_cmp);
        Some(Spread {
            min: *sorted.first()?,
            median: sorted[sorted.len() / 2],
            max: *sorted.last()?,
            runs: sorted.len(),
        })
    }
}

/// The share below which differences of times are never ranked, however alike repeated computations came out: five runs
/// of the same computation differ by this much on a busy machine.
pub const LEAST_NOISE: f64 = 0.02;

/// The relative noise of least times: the largest gap between the two of a pair, which are of the same computation, but
/// at least [`LEAST_NOISE`].
pub fn noise(pairs: &[[f64; 2]]) -> f64 {
    let gap = |[a, b]: &[f64; 2]| (a / b).max(b / a) - 1.0;
    pairs
        .iter()
        .map(gap)
        .filter(|g| g.is_finite())
        .fold(LEAST_NOISE, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_least_time_and_the_largest_gap() {
        let spread = Spread::of(&[3.0, 1.0, 2.0, 9.0, 2.5]);
        let expected = Spread {
            min: 1.0,
            median: 2.5,
            max: 9.0,
            runs: 5,
        };
        assert_eq!(spread, Some(expected));
        assert_eq!(Spread::of(&[]), None);
        assert_eq!(noise(&[[1.0, 1.0], [1.0, 1.01]]), LEAST_NOISE);
        assert!((noise(&[[1.0, 1.25], [1.1, 1.0]]) - 0.25).abs() < 1e-12);
    }
}
