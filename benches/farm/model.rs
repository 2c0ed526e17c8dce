//! A film is drawn by many nodes: when it is there, and which share of the nodes' time is wasted.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use super::rng::Rng;

/// Milliseconds on one processor for 48 bands of ten rows, from the top: `scenes/gallery/pawns.zpg` at 640 × 480 with
/// `--samples 4 --precision dd`. Each is the least user time of five runs of `zpg render --tile I/48 --threads 1`.
const BANDS: [u16; 48] = [
    4, 4, 4, 4, 4, 4, 4, 6, 11, 23, 31, 35, 39, 28, 31, 49, 72, 72, 105, 131, 169, 200, 211, 221,
    206, 216, 228, 260, 307, 318, 270, 275, 243, 242, 238, 240, 251, 255, 277, 258, 264, 197, 191,
    162, 139, 149, 144, 151,
];

/// Width, height and samples of what was measured.
const MEASURED: [f64; 3] = [640.0, 480.0, 4.0];
/// Those of a frame of the film.
const DRAWN: [f64; 3] = [3840.0, 2160.0, 64.0];
const FRAMES: usize = 100;

/// Seconds of `zpg join` for a pixel and for a part. They fit both measurements: 48 million pixels in 16 parts take
/// 0.26 s, 8.3 million in 540 parts take 0.10 s.
const JOIN: [f64; 2] = [5.4e-9, 1e-4];

/// Seconds that a task is to take.
pub const TILE_TIMES: [f64; 5] = [5.0, 30.0, 120.0, 600.0, 1800.0];
pub const NODES: [usize; 4] = [1, 10, 100, 1000];
/// The table has the medians of so many runs.
const RUNS: u64 = 21;

/// What is not drawing. Times are in seconds.
#[derive(Clone, Copy)]
pub struct Delays {
    /// Until a node begins with its first task, on average.
    pub queue: f64,
    /// From the end of a task to the start of the next one, on average. On a Slurm with one node it was 0.3 to 1.5 s.
    pub start: f64,
    /// Reading and building, for each task.
    pub build: f64,
    /// The share of tasks that fail, each anywhere on its way.
    pub failures: f64,
    /// Until a failed task is queued again.
    pub again: f64,
}

/// Those of the page.
pub const DELAYS: Delays = Delays {
    queue: 120.0,
    start: 1.0,
    build: 3.0,
    failures: 0.01,
    again: 120.0,
};

/// How a run ended.
pub struct Outcome {
    /// From queueing to the joined pictures, in seconds.
    pub end: f64,
    /// The share of the time of busy nodes in which no pixel came about that is in a picture.
    pub waste: f64,
}

/// Seconds of one processor for the rows above a place from 0 to 1 down the picture.
fn above(place: f64) -> f64 {
    let scale: f64 = DRAWN.iter().zip(MEASURED).map(|(a, b)| a / b).product();
    let bands = place * BANDS.len() as f64;
    let whole = bands as usize;
    let full: u32 = BANDS[..whole].iter().copied().map(u32::from).sum();
    let rest = BANDS
        .get(whole)
        .map_or(0.0, |&band| f64::from(band) * bands.fract());
    scale * (f64::from(full) + rest) / 1000.0
}

/// Seconds of one processor for the whole film.
pub fn work() -> f64 {
    FRAMES as f64 * above(1.0)
}

/// The bands of a picture, in seconds: as many as `zpg farm --tile-time` chooses.
fn bands(tile_time: f64) -> Vec<f64> {
    let rows = DRAWN[1];
    let count = (above(1.0) / tile_time).ceil().clamp(1.0, rows);
    let place = |i: f64| (i * rows / count).floor() / rows;
    (0..count as usize)
        .map(|i| above(place(i as f64 + 1.0)) - above(place(i as f64)))
        .collect()
}

/// A time of the exponential distribution with this mean.
fn wait(mean: f64, rng: &mut Rng) -> f64 {
    -mean * libm::log(1.0 - rng.unit())
}

/// One run. A node takes the next task whenever it is free, and is given back when there is none.
pub fn run(tile_time: f64, nodes: usize, delays: &Delays, rng: &mut Rng) -> Outcome {
    let bands = bands(tile_time);
    let mut tasks = (0..FRAMES).flat_map(|_| bands.iter().copied());
    // Times are not negative, so that their bits have their order.
    let mut free: BinaryHeap<Reverse<u64>> = (0..nodes)
        .map(|_| Reverse(wait(delays.queue, rng).to_bits()))
        .collect();
    let mut failed = BinaryHeap::<Reverse<(u64, u64)>>::new();
    let (mut end, mut busy) = (0.0f64, 0.0);
    while let Some(Reverse(now)) = free.pop() {
        let retry = failed.peek().map(|Reverse(retry)| *retry);
        let next = match retry.filter(|&(ready, _)| ready <= now) {
            Some(_) => None,
            None => tasks.next(),
        };
        let (now, pixels) = match (next, retry) {
            (Some(pixels), _) => (f64::from_bits(now), pixels),
            (None, Some((ready, pixels))) => {
                failed.pop();
                (f64::from_bits(now.max(ready)), f64::from_bits(pixels))
            }
            (None, None) => continue,
        };
        let start = wait(delays.start, rng);
        let mut takes = delays.build + pixels;
        if rng.chance(delays.failures) {
            takes *= rng.unit();
            let ready = now + start + takes + delays.again;
            failed.push(Reverse((ready.to_bits(), pixels.to_bits())));
        }
        busy += start + takes;
        end = end.max(now + start + takes);
        free.push(Reverse((now + start + takes).to_bits()));
    }
    let parts = (FRAMES * bands.len()) as f64;
    let join = JOIN[0] * DRAWN[0] * DRAWN[1] * FRAMES as f64 + JOIN[1] * parts;
    Outcome {
        end: end + wait(delays.queue, rng) + join,
        waste: 1.0 - work() / (busy + join),
    }
}

/// The middle one of an odd number of numbers.
fn median(mut values: Vec<f64>) -> f64 {
    values.sort_unstable_by(f64::total_cmp);
    values[values.len() / 2]
}

/// A time in its two largest units.
pub fn time(seconds: f64) -> String {
    let minutes = (seconds / 60.0).round() as u64;
    match minutes {
        _ if seconds < 60.0 => format!("{} s", seconds.round()),
        ..60 => format!("{minutes} min"),
        60..1440 => format!("{} h {} min", minutes / 60, minutes % 60),
        _ => format!("{} d {} h", minutes / 1440, minutes % 1440 / 60),
    }
}

/// The rows of the page's table: the tile time, the time to the end for each number of nodes, the largest waste.
pub fn table() -> Vec<String> {
    let row = |&tile_time: &f64| {
        let mut row = format!("| {} |", time(tile_time));
        let mut waste = 0.0f64;
        for nodes in NODES {
            let runs: Vec<Outcome> = (0..RUNS)
                .map(|seed| run(tile_time, nodes, &DELAYS, &mut Rng::new(seed)))
                .collect();
            row += &format!(" {} |", time(median(runs.iter().map(|r| r.end).collect())));
            waste = waste.max(median(runs.iter().map(|r| r.waste).collect()));
        }
        row + &format!(" {:.0} % |", 100.0 * waste)
    };
    TILE_TIMES.iter().map(row).collect()
}
