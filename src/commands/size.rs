//! The size of a picture on the command line: `640x480`, or `640 × 480` as messages have it.

use std::str::FromStr;

use crate::diagnostics::Complaint;

/// Width and height in pixels, at least 1.
#[derive(Debug, Clone, Copy)]
pub struct Size {
    pub width: u32,
    pub height: u32,
}

impl FromStr for Size {
    type Err = Complaint;

    fn from_str(s: &str) -> Result<Size, Complaint> {
        let (w, h) = s
            .split_once(['x', 'X', '×'])
            .ok_or_else(|| Complaint::new("expected-size"))?;
        let side = |s: &str| match s.trim().parse() {
            Ok(n @ 1..) => Ok(n),
            _ => Err(Complaint::new("not-pixels").with("text", s.to_owned())),
        };
        let (width, height) = (side(w)?, side(h)?);
        Ok(Size { width, height })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes() {
        for size in ["320x200", "320X200", "320×200", "320 × 200"] {
            let size = size.parse::<Size>().map(|s| (s.width, s.height));
            assert_eq!(size, Ok((320, 200)));
        }
        for wrong in ["320", "0x200", "320x-1", "320x200x1", "x", "×"] {
            assert!(wrong.parse::<Size>().is_err(), "{wrong}");
        }
    }
}
