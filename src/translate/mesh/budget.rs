//! A limit on how many triangles there may be, so that a small tolerance ends in words and not in
//! full memory.

use std::fmt;

/// The most triangles that are made: about two gigabytes of them.
pub const MOST_TRIANGLES: u64 = 1 << 25;

/// How many triangles there are so far.
#[derive(Debug, Default)]
pub struct Budget {
    spent: u64,
}

/// There would be too many triangles.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TooMany {
    /// At least so many.
    pub needed: f64,
}

impl fmt::Display for TooMany {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "this takes at least {:.3e} triangles, and at most {MOST_TRIANGLES} are made: \
             choose a larger --tolerance or a smaller part of the scene",
            self.needed
        )
    }
}

impl Budget {
    /// Asks for some more triangles before they are made.
    ///
    /// # Errors
    /// There would be too many.
    pub fn spend(&mut self, triangles: f64) -> Result<(), TooMany> {
        let needed = self.spent as f64 + triangles;
        if needed <= MOST_TRIANGLES as f64 {
            self.spent = needed as u64;
            Ok(())
        } else {
            Err(TooMany { needed })
        }
    }
}
