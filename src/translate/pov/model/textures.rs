//! The textures that a translation declares: each a texture of the scene with optics, and for one that is laid on
//! shapes, on a shape.

use std::collections::HashMap;

use super::tables::{DEFAULT, PROFILE, Tables, TextureUse};
use crate::scene::{self, Geometry, Scene};
use crate::translate::pov::pictures::Pictures;
use crate::translate::pov::tree::{Image, Pattern, Texture};

#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
struct Key {
    texture: TextureUse,
    optics: u32,
    shape: Option<u32>,
    /// Light comes from the other side.
    behind: bool,
}

/// Textures by number.
#[derive(Debug, Default)]
pub(crate) struct Textures {
    keys: Vec<Key>,
    numbers: HashMap<Key, usize>,
}

impl Textures {
    /// The number of a texture; `None` for the one that everything has by default. The shape comes as its index.
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
        (!is_default).then(|| self.of(key))
    }

    /// The same texture lit from the other side; nothing for one that light goes through.
    pub(crate) fn behind(&mut self, tables: &Tables, number: usize) -> Option<usize> {
        let front = self.keys[number];
        let behind = Key {
            behind: true,
            ..front
        };
        (!tables.is_transparent(front.optics)).then(|| self.of(behind))
    }

    fn of(&mut self, key: Key) -> usize {
        let next = self.keys.len();
        let number = *self.numbers.entry(key).or_insert(next);
        if number == next {
            self.keys.push(key);
        }
        number
    }

    /// Whether light goes through a texture.
    pub(crate) fn is_transparent(&self, tables: &Tables, number: usize) -> bool {
        tables.is_transparent(self.keys[number].optics)
    }

    /// All textures, and the images that they show.
    pub(crate) fn values<'a>(
        self,
        tables: &Tables,
        scene: &'a Scene,
        pictures: &Pictures,
    ) -> (Vec<Texture<'a>>, Vec<Image>) {
        let mut images = Images::default();
        let mut textures = Vec::with_capacity(self.keys.len());
        for key in &self.keys {
            let owner = tables.owner(key.texture.texture, key.optics);
            textures.push(Texture {
                owner: (owner, key.shape.map(|s| scene.shapes[s as usize].id)),
                name: String::new(),
                pattern: pattern(key, tables, scene, pictures, &mut images),
                optics: *tables.optics(key.optics),
                is_behind: key.behind,
            });
        }
        (textures, images.all)
    }
}

#[derive(Default)]
struct Images {
    all: Vec<Image>,
    numbers: HashMap<String, usize>,
}

impl Images {
    fn number(&mut self, file: &str, pictures: &Pictures) -> usize {
        if let Some(number) = self.numbers.get(file) {
            return *number;
        }
        self.all.push(Image {
            file: pictures.named(file),
            caption: file.replace(char::is_control, " "),
        });
        self.numbers.insert(file.to_owned(), self.all.len() - 1);
        self.all.len() - 1
    }
}

fn pattern<'a>(
    key: &Key,
    tables: &Tables,
    scene: &'a Scene,
    pictures: &Pictures,
    images: &mut Images,
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
            Pattern::Image(shape, images.number(file, pictures))
        }
        // Such textures are handed down to shapes.
        (scene::Texture::Checkerboard { colours, .. }, None) => Pattern::Colour(colours[0]),
        (scene::Texture::Image { .. }, None) => Pattern::Colour(scene::DEFAULT_COLOUR),
    }
}
