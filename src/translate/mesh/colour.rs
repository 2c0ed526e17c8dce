//! Colours as files have them.

use crate::scene::Rgb;

/// A linear colour as three bytes of sRGB.
pub(super) fn srgb(colour: Rgb) -> [u8; 3] {
    colour.map(|x| {
        let x = x.clamp(0.0, 1.0);
        let encoded = if x <= 0.003_130_8 {
            12.92 * x
        } else {
            1.055 * x.powf(1.0 / 2.4) - 0.055
        };
        (255.0 * encoded).round() as u8
    })
}
