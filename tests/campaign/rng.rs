//! A generator of random numbers that gives the same ones everywhere, and what is drawn from it.

/// SplitMix64 (Steele, Lea and Flood, "Fast Splittable Pseudorandom Number Generators", 2014).
#[derive(Clone)]
pub struct Rng(u64);

impl Rng {
    pub fn new(seed: u64) -> Rng {
        Rng(seed)
    }

    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// From 0 to below 1.
    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1u64 << 53) as f64
    }

    pub fn range(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// From 0 to below `n`.
    pub fn below(&mut self, n: usize) -> usize {
        (self.bits() % n as u64) as usize
    }

    /// Whether something happens that happens `share` of the times.
    pub fn chance(&mut self, share: f64) -> bool {
        self.unit() < share
    }

    /// 10 to a power between the two.
    pub fn decade(&mut self, low: f64, high: f64) -> f64 {
        10f64.powf(self.range(low, high))
    }

    pub fn sign(&mut self) -> f64 {
        if self.bits() & 1 == 0 { 1.0 } else { -1.0 }
    }

    pub fn pick<'a, T>(&mut self, list: &'a [T]) -> &'a T {
        &list[self.below(list.len())]
    }

    /// A point of the cube from −1 to 1.
    pub fn cube(&mut self) -> [f64; 3] {
        std::array::from_fn(|_| self.range(-1.0, 1.0))
    }

    /// A direction, evenly over the sphere, of length 1 but for rounding.
    pub fn direction(&mut self) -> [f64; 3] {
        loop {
            let v = self.cube();
            let square: f64 = v.iter().map(|x| x * x).sum();
            if square > 0.01 && square <= 1.0 {
                return v.map(|x| x / square.sqrt());
            }
        }
    }
}
