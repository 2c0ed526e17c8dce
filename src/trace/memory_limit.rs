//! How much memory a ray may take.

use std::sync::atomic::{AtomicBool, Ordering};

/// Bytes that a ray may need unless another limit is given: 1 GiB.
const DEFAULT_RAY_BYTES: u64 = 1 << 30;

/// The most that the capacity of a list may be over its length: a full list doubles its capacity.
pub(super) const GROWTH_FACTOR: usize = 2;

/// The memory that a walker may use for a ray, and whether some walker would have needed more.
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
    /// The limit for `bytes` bytes on each thread. A thread may have two walkers, one for doubtful decisions in
    /// double-double, so each gets half.
    pub fn of(bytes: u64) -> MemoryLimit {
        MemoryLimit {
            bytes: usize::try_from(bytes / 2).unwrap_or(usize::MAX),
            is_exhausted: AtomicBool::new(false),
        }
    }

    /// Whether a walker may use `bytes` bytes; if not, notes that the memory is used up.
    pub fn has(&self, bytes: usize) -> bool {
        let has = bytes <= self.bytes;
        if !has {
            self.is_exhausted.store(true, Ordering::Relaxed);
        }
        has
    }

    /// Whether some ray would have needed more memory than the limit.
    pub fn is_exhausted(&self) -> bool {
        self.is_exhausted.load(Ordering::Relaxed)
    }
}
