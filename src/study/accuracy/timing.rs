//! Times of runs, and what they tell.

/// The least, the median and the largest of some times, in seconds.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct Spread {
    pub min: f64,
    pub median: f64,
    pub max: f64,
    pub runs: usize,
}

impl Spread {
    /// `None` of no times.
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

/// Differences below this share of a time are not ranked, however alike repeated computations came out:
/// what five runs of one thing differ by on a busy machine.
pub const LEAST_NOISE: f64 = 0.02;

/// The relative noise of minima: the largest gap between two that are of one computation.
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
