//! Textures as pictures over surface coordinates.

use std::collections::BTreeMap;
use std::collections::btree_map::Entry;

use super::colour::srgb;
use super::surface_label::SurfaceLabel;
use crate::scene::Texture;
use crate::trace::film::{Packing, write_rgb8};
use crate::trace::graph::Graph;

/// A picture as PNG, and how a surface shows it.
#[derive(Debug, Clone, PartialEq)]
pub struct Picture {
    pub png: Vec<u8>,
    /// Whether texels are squares of one colour: nothing is interpolated.
    pub cells: bool,
    /// Factors by which surface coordinates are multiplied to become texture coordinates.
    pub scale: [f64; 2],
}

/// The file name of a texture's picture. `stem` is that of the mesh file.
pub fn file_name(stem: &str, number: u32) -> String {
    format!("{stem}_texture_{number}.png")
}

/// Whether a surface shows an image or a checkerboard, which need surface coordinates.
pub fn is_pictured(skin: &SurfaceLabel, graph: &Graph) -> bool {
    let texture = skin.texture.as_ref().filter(|_| skin.primitive.is_some());
    texture.is_some_and(|t| match &graph.textures[t.texture as usize] {
        Texture::Checkerboard { .. } => true,
        Texture::Image { .. } => graph.bitmaps[t.texture as usize].is_some(),
        _ => false,
    })
}

/// The pictures of a scene, each once, by the index of its texture.
#[derive(Debug, Default)]
pub struct Pictures {
    pub all: BTreeMap<u32, Picture>,
}

impl Pictures {
    /// Adds the picture of a skin, and returns its number; `None` if the skin shows no picture.
    pub fn of(&mut self, skin: &SurfaceLabel, graph: &Graph) -> Option<u32> {
        let number = skin
            .texture
            .as_ref()
            .filter(|_| is_pictured(skin, graph))?
            .texture;
        if let Entry::Vacant(place) = self.all.entry(number) {
            place.insert(picture(number, graph)?);
        }
        Some(number)
    }
}

/// The picture of the texture with index `number`; `None` if the texture is no picture.
pub fn picture(number: u32, graph: &Graph) -> Option<Picture> {
    Some(match &graph.textures[number as usize] {
        Texture::Checkerboard { n, m, colours } => {
            let [even, odd] = colours.map(srgb);
            Picture {
                // A cell is even where ⌊uN⌋ + ⌊vM⌋ is even: the lower left one and the upper right one.
                png: png(2, 2, &[odd, even, even, odd].concat())?,
                cells: true,
                scale: [n, m].map(|x| f64::from(*x) / 2.0),
            }
        }
        Texture::Image { .. } => {
            let bitmap = graph.bitmaps[number as usize].as_ref()?;
            Picture {
                png: bitmap.png(),
                cells: false,
                scale: [1.0; 2],
            }
        }
        _ => return None,
    })
}

/// Encodes 8-bit RGB as PNG, row by row from the top.
fn png(width: u32, height: u32, rgb: &[u8]) -> Option<Vec<u8>> {
    let mut out = Vec::new();
    write_rgb8(&mut out, [width, height], rgb, Packing::Small).ok()?;
    Some(out)
}
