//! Numbers for textures, optics and refractive indices, the same for equal values; and the frame that a texture lies
//! in.

use super::numbered::{Numbered, bits};
use crate::geometry::Matrix;
use crate::scene::{DEFAULT_COLOUR, DEFAULT_INDEX, Optics, Rgb, Scene, Texture};

/// The number of a value that nobody gave, in every table.
pub(crate) const DEFAULT: u32 = 0;
/// The texture number that means "the colours of the shape's own profile". A coloured surface of revolution has it if
/// no other texture was given. On other shapes it means the default texture.
pub(crate) const PROFILE: u32 = 1;

/// A texture and the matrix from the coordinates it was given in to those of the node at hand.
/// Only textures in space have a frame; the others have number 0, the identity.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub(crate) struct TextureUse {
    pub texture: u32,
    pub frame: u32,
}

impl TextureUse {
    pub(crate) const DEFAULT: TextureUse = TextureUse {
        texture: DEFAULT,
        frame: DEFAULT,
    };

    /// A texture given to the node at hand.
    pub(crate) fn here(texture: u32) -> TextureUse {
        TextureUse {
            texture,
            frame: DEFAULT,
        }
    }
}

/// The numbers of the texture, the optics and the index that a paint sets; `None` for each that it does not set.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct PaintAspects {
    pub texture: Option<u32>,
    pub optics: Option<u32>,
    pub index: Option<u32>,
}

/// The values of all textures, optics and refractive indices in a scene, by number.
#[derive(Debug)]
pub(crate) struct Tables {
    textures: Numbered<Vec<u64>, Texture>,
    optics: Numbered<Vec<u64>, Optics>,
    indices: Numbered<Vec<u64>, Rgb>,
    frames: Numbered<[u64; 16], Matrix>,
    /// Aspects of each paint of the scene.
    paints: Vec<PaintAspects>,
    /// For each texture the entity that was given it first, 0 for none; `optics_owners` has these entities for optics.
    texture_owners: Vec<u32>,
    optics_owners: Vec<u32>,
}

impl Tables {
    pub(crate) fn of(scene: &Scene) -> Tables {
        let mut out = Tables {
            textures: Numbered::default(),
            optics: Numbered::default(),
            indices: Numbered::default(),
            frames: Numbered::default(),
            paints: Vec::with_capacity(scene.paints.len()),
            texture_owners: vec![0; 2],
            optics_owners: vec![0],
        };
        let (texture, optics) = (Texture::Colour(DEFAULT_COLOUR), Optics::default());
        (out.textures).number(texture_bits(&texture), || texture.clone());
        // The value for `PROFILE`, whose number alone counts.
        out.textures.values.push(texture);
        out.optics.number(optics_bits(&optics), || optics);
        out.indices.number(bits(&DEFAULT_INDEX), || DEFAULT_INDEX);
        out.frames.matrix(&Matrix::IDENTITY);
        for paint in &scene.paints {
            let texture = |t| out.textures.number(texture_bits(t), || t.clone());
            let tables = PaintAspects {
                texture: paint.texture.as_ref().map(texture),
                optics: (paint.optics.as_ref()).map(|o| out.optics.number(optics_bits(o), || *o)),
                index: (paint.index.as_ref()).map(|i| out.indices.number(bits(i), || *i)),
            };
            out.texture_owners
                .resize(out.textures.values.len(), paint.owner);
            out.optics_owners
                .resize(out.optics.values.len(), paint.owner);
            out.paints.push(tables);
        }
        out
    }

    pub(crate) fn paint(&self, paint: u32) -> PaintAspects {
        self.paints[paint as usize]
    }

    pub(crate) fn texture(&self, number: u32) -> &Texture {
        self.textures.get(number)
    }

    pub(crate) fn optics(&self, number: u32) -> &Optics {
        self.optics.get(number)
    }

    pub(crate) fn index(&self, number: u32) -> Rgb {
        *self.indices.get(number)
    }

    /// The number of the index that has, in each channel, the larger value of the indices `a` and `b`.
    pub(crate) fn denser(&mut self, a: u32, b: u32) -> u32 {
        let [a, b] = [a, b].map(|number| self.index(number));
        let most = std::array::from_fn(|i| a[i].max(b[i]));
        self.indices.number(bits(&most), || most)
    }

    pub(crate) fn frame(&self, number: u32) -> &Matrix {
        self.frames.get(number)
    }

    /// The entity that a look is named after; 0 for none.
    pub(crate) fn owner(&self, texture: u32, optics: u32) -> u32 {
        match self.texture_owners[texture as usize] {
            0 => self.optics_owners[optics as usize],
            owner => owner,
        }
    }

    pub(crate) fn is_transparent(&self, optics: u32) -> bool {
        self.optics(optics).kt.iter().any(|k| *k > 0.0)
    }

    /// Whether the texture is laid on each shape by the shape's own coordinates.
    pub(crate) fn is_laid_on_shapes(&self, texture: u32) -> bool {
        texture == PROFILE
            || matches!(
                self.texture(texture),
                Texture::Checkerboard { .. } | Texture::Image { .. }
            )
    }

    /// The use of a texture in the coordinates that `m` maps to.
    pub(crate) fn moved(&mut self, used: TextureUse, m: &Matrix) -> TextureUse {
        if !self.lies_in_space(used) {
            return used;
        }
        let frame = m.after(self.frame(used.frame));
        TextureUse {
            frame: self.frames.matrix(&frame),
            ..used
        }
    }

    /// The use of a texture in the coordinates that `m` maps from.
    pub(crate) fn moved_back(&mut self, used: TextureUse, m: &Matrix) -> TextureUse {
        let inverse = self.lies_in_space(used).then(|| m.inverse()).flatten();
        inverse.map_or(used, |inverse| self.moved(used, &inverse))
    }

    fn lies_in_space(&self, used: TextureUse) -> bool {
        matches!(self.texture(used.texture), Texture::Solid { .. })
    }
}

fn texture_bits(texture: &Texture) -> Vec<u64> {
    match texture {
        Texture::Colour(c) => bits(c),
        Texture::Checkerboard { n, m, colours } => {
            let mut key = bits(colours.iter().flatten());
            key.extend([u64::from(*n), u64::from(*m)]);
            key
        }
        Texture::Solid { colours, size } => {
            bits(colours.iter().flatten().chain(std::iter::once(size)))
        }
        // The nine numbers at the start make the key longer than that of any other kind of texture. The bytes of the
        // name follow.
        Texture::Image { file, .. } => {
            let mut key = vec![u64::MAX; 9];
            key.extend(file.bytes().map(u64::from));
            key
        }
    }
}

fn optics_bits(o: &Optics) -> Vec<u64> {
    bits(o.kd.iter().chain(&o.ks).chain(&o.kt))
}
