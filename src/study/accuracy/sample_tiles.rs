//! Small tiles of the full picture, spread evenly. They are measured in place of a smaller picture, whose edges would
//! be others.

/// The side of a tile in pixels.
pub const TILE: u32 = 8;
/// The side in pixels of the block of the picture that a tile stands for.
const BLOCK: u32 = 32;

/// A picture with no more pixels than this is measured as a whole.
pub const WHOLE: u64 = 20_000;

/// A square part of a picture; narrower or lower at the right and lower edges.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Tile {
    pub x: u32,
    pub y: u32,
    pub width: u32,
    pub height: u32,
}

impl Tile {
    /// The pixels of the tile, row by row.
    pub fn pixels(self) -> impl Iterator<Item = [u32; 2]> {
        let columns = self.x..self.x + self.width;
        (self.y..self.y + self.height).flat_map(move |y| columns.clone().map(move |x| [x, y]))
    }

    pub fn count(self) -> usize {
        self.width as usize * self.height as usize
    }
}

/// Chooses the tiles of a picture that are measured. However many of the first tiles are used, they are spread evenly.
///
/// A block of 32 × 32 pixels has 16 tiles; `share` of them are chosen. A small picture is measured as a whole.
pub fn chosen([width, height]: [u32; 2], share: usize) -> Vec<Tile> {
    let whole = u64::from(width) * u64::from(height) <= WHOLE;
    let per_block = (BLOCK / TILE).pow(2) as usize;
    let share = if whole {
        per_block
    } else {
        share.clamp(1, per_block)
    };
    let mut tiles = Vec::new();
    let blocks = |side: u32| side.div_ceil(BLOCK);
    for by in 0..blocks(height) {
        for bx in 0..blocks(width) {
            let mut within: Vec<Tile> = (0..per_block as u32)
                .map(|i| [bx * BLOCK + i % 4 * TILE, by * BLOCK + i / 4 * TILE])
                .filter(|[x, y]| *x < width && *y < height)
                .map(|[x, y]| Tile {
                    x,
                    y,
                    width: TILE.min(width - x),
                    height: TILE.min(height - y),
                })
                .collect();
            shuffle(&mut within, u64::from(by) << 32 | u64::from(bx));
            tiles.extend(within.into_iter().take(share).enumerate());
        }
    }
    // Every block gives one tile before any gives a second. Blocks follow each other in steps of the golden ratio, so
    // that every stretch of them is spread evenly.
    let blocks = tiles.iter().filter(|(i, _)| *i == 0).count();
    let mut block = 0;
    let mut keyed: Vec<(usize, f64, Tile)> = (tiles.iter().enumerate())
        .map(|(n, &(i, tile))| {
            block += usize::from(i == 0 && n > 0);
            const GOLDEN: f64 = 0.618_033_988_749_894_9;
            // The place of the block in this order, from 0 to 1.
            (i, (block as f64 * GOLDEN).fract(), tile)
        })
        .collect();
    debug_assert!(block < blocks.max(1));
    keyed.sort_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
    keyed.into_iter().map(|k| k.2).collect()
}

/// A random order (Fisher and Yates), the same for the same seed.
pub fn shuffle<T>(items: &mut [T], seed: u64) {
    let mut random = Random::new(seed);
    for i in (1..items.len()).rev() {
        items.swap(i, random.below(i + 1));
    }
}

/// Random numbers (splitmix64; Steele, Lea and Flood, 2014).
pub struct Random(u64);

impl Random {
    pub fn new(seed: u64) -> Random {
        Random(seed)
    }

    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        crate::trace::sampling::hash(self.0)
    }

    /// A random number less than `n`, which has to be above 0.
    pub fn below(&mut self, n: usize) -> usize {
        ((u128::from(self.next()) * n as u128) >> 64) as usize
    }

    /// A random number in [0, 1).
    pub fn unit(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1u64 << 53) as f64
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashSet;

    #[test]
    fn a_small_picture_is_covered_once() {
        let tiles = chosen([50, 21], 1);
        let pixels: Vec<[u32; 2]> = tiles.iter().flat_map(|t| t.pixels()).collect();
        assert_eq!(pixels.len(), 50 * 21);
        assert_eq!(pixels.iter().collect::<HashSet<_>>().len(), 50 * 21);
        assert!(pixels.iter().all(|[x, y]| *x < 50 && *y < 21));
    }

    #[test]
    fn of_a_large_one_a_sixteenth_and_every_beginning_is_spread() {
        let tiles = chosen([640, 480], 1);
        assert_eq!(tiles.len(), 300);
        assert_eq!(
            tiles.iter().map(|t| t.count()).sum::<usize>(),
            640 * 480 / 16
        );
        // Of the first 60 tiles each quarter of the picture has its share.
        for quarter in 0..4 {
            let inside = |t: &&Tile| t.x / 320 + 2 * (t.y / 240) == quarter;
            let count = tiles[..60].iter().filter(inside).count();
            assert!((10..=20).contains(&count), "{count}");
        }
    }
}
