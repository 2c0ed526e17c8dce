//! The textures that a translation declares. Each is a texture of the scene with optics; a texture that is laid on
//! shapes is declared for each shape.

use super::numbered::Numbered;
use super::tables::{DEFAULT, PROFILE, Tables, TextureUse};
use crate::scene::{self, Geometry, Scene};
use crate::translate::pov::pictures::Pictures;
use crate::translate::pov::tree::{Image, Pattern, Texture};

#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
struct Key {
    texture: TextureUse,
    optics: u32,
    shape: Option<u32>,
    /// Whether the surface is lit by light that falls on its other side.
    behind: bool,
}

/// Textures by number.
#[derive(Debug, Default)]
pub(crate) struct Textures {
    keys: Numbered<Key>,
}

impl Textures {
    /// The number of a texture; `None` for the one that everything has by default. `shape` is the index of the shape
    /// that the texture is laid on.
    pub(crate) fn number(
        &mut self,
        texture: TextureUse,
        optics: u32,
        shape: Option<u32>,
    ) -> Option<usize> {
        let is_default = texture == TextureUse::DEFAULT && optics == DEFAULT;
        let key = Key {
            texture,
            optics,
            shape,
            behind: false,
        };
        (!is_default).then(|| self.keys.number(key, || key) as usize)
    }

    /// The number of the texture that is lit from the other side; `None` if light goes through the texture.
    pub(crate) fn behind(&mut self, tables: &Tables, number: usize) -> Option<usize> {
        let front = self.keys.values[number];
        let behind = Key {
            behind: true,
            ..front
        };
        let is_opaque = !tables.is_transparent(front.optics);
        is_opaque.then(|| self.keys.number(behind, || behind) as usize)
    }

    /// Whether light goes through a texture.
    pub(crate) fn is_transparent(&self, tables: &Tables, number: usize) -> bool {
        tables.is_transparent(self.keys.values[number].optics)
    }

    /// All textures, and the images that they show.
    pub(crate) fn values<'a>(
        self,
        tables: &Tables,
        scene: &'a Scene,
        pictures: &Pictures,
    ) -> (Vec<Texture<'a>>, Vec<Image>) {
        let mut images = Numbered::default();
        let mut textures = Vec::new();
        for key in &self.keys.values {
            let owner = tables.owner(key.texture.texture, key.optics);
            textures.push(Texture {
                owner: (owner, key.shape.map(|s| scene.shapes[s as usize].id)),
                name: String::new(),
                pattern: pattern(key, tables, scene, pictures, &mut images),
                optics: *tables.optics(key.optics),
                is_behind: key.behind,
            });
        }
        (textures, images.values)
    }
}

fn pattern<'a>(
    key: &Key,
    tables: &Tables,
    scene: &'a Scene,
    pictures: &Pictures,
    images: &mut Numbered<String, Image>,
) -> Pattern<'a> {
    let shape = key.shape.map(|s| &scene.shapes[s as usize].geometry);
    if key.texture.texture == PROFILE
        && let Some(Geometry::Revolution { profile, colours }) = shape
    {
        return Pattern::Profile(profile, colours);
    }
    match (tables.texture(key.texture.texture), shape) {
        (scene::Texture::Colour(colour), _) => Pattern::Colour(*colour),
        (scene::Texture::Solid { colours, size }, _) => {
            Pattern::Cubes(*tables.frame(key.texture.frame), *colours, *size)
        }
        (scene::Texture::Checkerboard { n, m, colours }, Some(shape)) => {
            Pattern::Checkerboard(shape, [*n, *m], *colours)
        }
        (scene::Texture::Image { file, .. }, Some(shape)) => {
            let image = || Image {
                file: pictures.named(file),
                caption: file.replace(char::is_control, " "),
            };
            Pattern::Image(shape, images.number(file.clone(), image) as usize)
        }
        // Textures that are laid on shapes are handed down to them, so these two cases are not expected.
        (scene::Texture::Checkerboard { colours, .. }, None) => Pattern::Colour(colours[0]),
        (scene::Texture::Image { .. }, None) => Pattern::Colour(scene::DEFAULT_COLOUR),
    }
}
