//! How much memory a ray may take.

use std::sync::atomic::{AtomicBool, Ordering};

/// Bytes that a ray may need unless another limit is given: 1 GiB.
const DEFAULT_RAY_BYTES: u64 = 1 << 30;

/// The capacity of a list over its length, at most: a full list doubles.
pub(super) const GROWTH_FACTOR: usize = 2;

/// How much memory a walker may use for a ray, and whether one would have needed more.
#[derive(Debug)]
pub struct MemoryLimit {
    pub(super) bytes: usize,
    is_exhausted: AtomicBool,
}

impl Default for MemoryLimit {
    fn default() -> MemoryLimit {
        MemoryLimit::of(DEFAULT_RAY_BYTES)
    }
}

impl MemoryLimit {
    /// The limit for so many bytes for each thread: what doubles cannot decide is asked in double-double, by a walker
    /// of its own.
    pub fn of(bytes: u64) -> MemoryLimit {
        MemoryLimit {
            bytes: usize::try_from(bytes / 2).unwrap_or(usize::MAX),
            is_exhausted: AtomicBool::new(false),
        }
    }

    /// Whether so many bytes may be used; notes a refusal.
    pub fn has(&self, bytes: usize) -> bool {
        let has = bytes <= self.bytes;
        if !has {
            self.is_exhausted.store(true, Ordering::Relaxed);
        }
        has
    }

    /// Whether some ray would have needed more than it may.
    pub fn is_exhausted(&self) -> bool {
        self.is_exhausted.load(Ordering::Relaxed)
    }
}
