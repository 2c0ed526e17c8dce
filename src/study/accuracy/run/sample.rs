//! The tiles that a setting is timed on, and the estimate of the whole time from a few tiles.

use crate::study::accuracy::runner::Timed;
use crate::study::accuracy::sample_tiles::Tile;

/// Tiles that stand for a picture.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct Sample {
    /// The number of each tile, ascending, and the weight of its time.
    tiles: Vec<(usize, f64)>,
}

impl Sample {
    /// The first tiles, which are spread evenly.
    pub(super) fn first(count: usize) -> Sample {
        Sample {
            tiles: (0..count).map(|i| (i, 1.0)).collect(),
        }
    }

    /// Chooses about `count` tiles with a probability in proportion to `times`, the default's time for each: a tile of
    /// twice the time is chosen twice as often and counts for half (Hansen and Hurwitz, "On the theory of sampling from
    /// finite populations", 1943). The tiles, the quickest first, are divided into stretches of equal time, and one is
    /// chosen in each.
    pub(super) fn by_time(times: &[f64], count: usize) -> Sample {
        let total: f64 = times.iter().sum();
        let stretch = total / count.max(1) as f64;
        let mut tiles = Vec::new();
        let (mut behind, mut chosen) = (0.0, 0);
        let mut order: Vec<usize> = (0..times.len()).collect();
        order.sort_by(|&a, &b| times[a].total_cmp(&times[b]));
        for i in order {
            let time = times[i];
            behind += time;
            let mut hits = 0.0;
            while chosen < count && (chosen as f64 + 0.5) * stretch < behind {
                chosen += 1;
                hits += 1.0;
            }
            if hits > 0.0 {
                tiles.push((i, hits / time));
            }
        }
        tiles.sort_by_key(|tile| tile.0);
        Sample { tiles }
    }

    /// The mean time of a tile chosen by its time, as a multiple of the mean time of all tiles.
    pub(super) fn skew(times: &[f64]) -> f64 {
        let sum: f64 = times.iter().sum();
        let squares: f64 = times.iter().map(|t| t * t).sum();
        let skew = squares * times.len() as f64 / (sum * sum);
        if skew.is_finite() { skew } else { 1.0 }
    }

    /// The default's mean time on the sample's tiles, as a multiple of its mean time on all tiles whose `times` are
    /// known. 1 if no time is known.
    pub(super) fn share_of(&self, times: &[f64]) -> f64 {
        let known: Vec<f64> = (self.tiles.iter())
            .filter_map(|(i, _)| times.get(*i).copied())
            .collect();
        let mean = |times: &[f64]| times.iter().sum::<f64>() / times.len() as f64;
        let share = mean(&known) / mean(times);
        if share.is_finite() { share } else { 1.0 }
    }

    pub(super) fn of(&self, tiles: &[Tile]) -> Vec<Tile> {
        self.tiles.iter().map(|(i, _)| tiles[*i]).collect()
    }

    pub(super) fn pixels(&self, tiles: &[Tile]) -> usize {
        self.tiles.iter().map(|(i, _)| tiles[*i].count()).sum()
    }

    /// The time of this sample as a multiple of another sample's, from the least time of each tile. Only tiles in both
    /// samples count. `None` if there are none.
    pub(super) fn ratio(&self, times: &[Timed], other: &Sample, others: &[Timed]) -> Option<f64> {
        let (own, other_times) = (least(times)?, least(others)?);
        let (mut sum, mut sum_of_other) = (0.0, 0.0);
        for ((tile, weight), time) in self.tiles.iter().zip(own) {
            if let Ok(at) = other.tiles.binary_search_by_key(tile, |t| t.0) {
                sum += weight * time;
                sum_of_other += weight * other_times.get(at)?;
            }
        }
        (sum_of_other > 0.0).then(|| sum / sum_of_other)
    }
}

/// The least time of each tile in several runs: a disturbance of a run hits few of its tiles. `None` without runs.
pub(super) fn least(times: &[Timed]) -> Option<Vec<f64>> {
    let mut least = times.first()?.tiles.clone();
    for run in &times[1..] {
        for (least, time) in least.iter_mut().zip(&run.tiles) {
            *least = least.min(*time);
        }
    }
    Some(least)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn timed(tiles: &[f64]) -> Timed {
        Timed {
            tiles: tiles.to_vec(),
            ..Timed::default()
        }
    }

    /// A hundred tiles, of which the background's take 1; one in ten takes 20, and with the other setting 13 times as
    /// long.
    #[test]
    fn a_few_tiles_say_what_all_would() {
        let is_dear = |i: usize| i % 10 == 7;
        let default: Vec<f64> = (0..100)
            .map(|i| if is_dear(i) { 20.0 } else { 1.0 })
            .collect();
        let dear: Vec<f64> = (0..100)
            .map(|i| if is_dear(i) { 260.0 } else { 1.0 })
            .collect();
        let truth = dear.iter().sum::<f64>() / default.iter().sum::<f64>();
        let frame = Sample::first(100);
        let sample = Sample::by_time(&default, 12);
        assert!(sample.tiles.len() <= 12);
        let own: Vec<f64> = sample.tiles.iter().map(|(i, _)| dear[*i]).collect();
        let ratio = sample
            .ratio(&[timed(&own)], &frame, &[timed(&default)])
            .unwrap();
        assert!((ratio / truth - 1.0).abs() < 0.15, "{ratio} for {truth}");
        // The first eight tiles would say twice that much, or next to nothing.
        let first = Sample::first(7);
        let ratio = first.ratio(&[timed(&dear[..7])], &frame, &[timed(&default)]);
        assert_eq!(ratio, Some(1.0));
    }

    /// A run that is disturbed in the middle spoils one tile, once.
    #[test]
    fn what_disturbs_a_run_does_not_count() {
        let frame = Sample::first(3);
        let runs = [timed(&[1.0, 50.0, 1.0]), timed(&[1.0, 1.0, 30.0])];
        let dear = [timed(&[2.0, 2.0, 90.0]), timed(&[80.0, 2.0, 2.0])];
        assert_eq!(frame.ratio(&dear, &frame, &runs), Some(2.0));
        assert_eq!(frame.ratio(&[], &frame, &runs), None);
    }
}
