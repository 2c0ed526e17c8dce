//! The colour and the optics of surfaces.

use crate::scene::Rgb;

/// Where the colour of a shape comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Colour {
    /// The colour is the same everywhere.
    Plain,
    /// The shape may have colours of its own.
    Own,
    /// `texture` is an index into [`Graph::textures`](crate::trace::graph::Graph::textures); `chain` is the chain of
    /// the space that the texture is painted in: see [`Leaf::chain`](super::leaf::Leaf::chain).
    Texture { texture: u32, chain: u32 },
}

/// A way of light through a surface: the colour channels that are refracted alike.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Way {
    /// The share of light that goes through; 0 for channels that go another way.
    pub kt: [f64; 3],
    /// The refractive index before the surface divided by the index behind it: on the way in, and on the way out.
    pub ratios: [f64; 2],
    /// Whether both indices are equal, so that light goes straight on.
    pub is_straight: bool,
}

impl Way {
    pub const NONE: Way = Way {
        kt: [0.0; 3],
        ratios: [1.0; 2],
        is_straight: true,
    };

    /// The ways through a surface with the refractive index `around` before it and `own` behind it, and the number of
    /// ways. The way of the first channel comes first. Unless channels `may_part`, all go the way of the first channel
    /// that gets through.
    pub fn through(kt: [f64; 3], around: Rgb, own: Rgb, may_part: bool) -> ([Way; 3], u32) {
        let (mut ways, mut count, mut todo) = ([Way::NONE; 3], 0, kt);
        while let Some(first) = (0..3).find(|&c| todo[c] != 0.0) {
            // All channels that go straight on share one way, whatever their index.
            let bend =
                |c: usize| Some([around[c], own[c]]).filter(|[before, behind]| before != behind);
            let is_along = |c: usize| !may_part || bend(c) == bend(first);
            let way = &mut ways[count];
            for c in (first..3).filter(|&c| is_along(c)) {
                way.kt[c] = std::mem::take(&mut todo[c]);
            }
            let (before, behind) = (around[first], own[first]);
            way.ratios = [before / behind, behind / before];
            way.is_straight = before == behind;
            count += 1;
        }
        (ways, count as u32)
    }
}

/// What the surface of a shape looks like. Many leaves share one look.
#[derive(Debug)]
pub struct Look {
    pub colour: Colour,
    pub kd: [f64; 3],
    /// The share of diffuse light in each channel, if the colour is plain: `kd` times the colour.
    pub albedo: [f64; 3],
    pub ks: [f64; 3],
    pub kt: [f64; 3],
    /// The numbers of its optics and of its refractive index: leaves with the same two numbers are of one medium.
    pub medium: [u32; 2],
    /// The refractive index in each channel.
    pub index: Rgb,
    /// The ways on which light goes through, the first `way_count` of them: see [`Way`].
    pub ways: [Way; 3],
    pub way_count: u32,
}
