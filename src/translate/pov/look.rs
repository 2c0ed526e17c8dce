//! Textures with optics as POV-Ray's layered textures.
//!
//! POV-Ray scales the diffuse and ambient terms by a layer's opacity. A transparent look is
//! therefore two layers: the lower one lets 2·kt through and nothing else; the upper one is half
//! transparent, which makes that kt, and has its ambient and diffuse terms doubled.

use std::collections::HashMap;

use super::aspects::{Aspects, DEFAULT, TextureUse};
use super::text::{matrix, number, rgb};
use super::uv;
use crate::scene::{Matrix, Optics, Rgb, Scene, Texture};
use crate::translate::Unsupported;

/// A texture with optics; for a texture that is laid on shapes, on a shape.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
struct Look {
    texture: TextureUse,
    optics: u32,
    shape: Option<u32>,
}

/// The looks that a translation declares.
#[derive(Debug, Default)]
pub struct Looks {
    looks: Vec<Look>,
    names: Vec<String>,
    numbers: HashMap<Look, u32>,
    /// How many looks have the same name, but for a number at the end.
    times: HashMap<String, u32>,
}

impl Looks {
    /// The number of a look; `None` for the one that everything has by default. The shape comes as
    /// its index and its ID.
    pub fn number(
        &mut self,
        aspects: &Aspects,
        texture: TextureUse,
        optics: u32,
        shape: Option<(u32, u32)>,
    ) -> Option<u32> {
        if texture == TextureUse::DEFAULT && optics == DEFAULT {
            return None;
        }
        let look = Look {
            texture,
            optics,
            shape: shape.map(|(index, _)| index),
        };
        let next = self.looks.len() as u32;
        let number = *self.numbers.entry(look).or_insert(next);
        if number == next {
            let mut name = format!("Look_{}", aspects.owner(texture.texture, optics));
            if let Some((_, id)) = shape {
                name += &format!("_on_{id}");
            }
            let times = self.times.entry(name.clone()).or_insert(0);
            *times += 1;
            if *times > 1 {
                name += &format!("_{times}");
            }
            self.looks.push(look);
            self.names.push(name);
        }
        Some(number)
    }

    /// What a look is called: after the entity that was given it.
    pub fn name(&self, number: u32) -> &str {
        &self.names[number as usize]
    }

    /// The optics of all looks.
    pub fn optics(&self) -> impl Iterator<Item = u32> {
        self.looks.iter().map(|l| l.optics)
    }

    /// The declarations of all looks.
    ///
    /// # Errors
    /// A texture that POV-Ray cannot be told about.
    pub fn write(
        &self,
        out: &mut String,
        aspects: &Aspects,
        scene: &Scene,
    ) -> Result<(), Unsupported> {
        for (look, name) in self.looks.iter().zip(&self.names) {
            let pigments = Pigments {
                texture: aspects.texture(look.texture.texture),
                frame: aspects.frame(look.texture.frame),
                shape: look.shape.map(|s| &scene.shapes[s as usize]),
                name,
                owner: aspects.owner(look.texture.texture, look.optics),
            };
            out.push_str(&pigments.functions()?);
            out.push_str(&format!("#declare {name} ="));
            out.push_str(&layers(&pigments, aspects.optics(look.optics))?);
            out.push_str(";\n");
        }
        Ok(())
    }
}

fn layers(pigments: &Pigments, optics: &Optics) -> Result<String, Unsupported> {
    let transparent = optics.kt.iter().any(|k| *k > 0.0);
    let opacity = if transparent { 0.5 } else { 1.0 };
    // The diffuse coefficient is one number there; one of each channel goes into the pigment.
    let (kd, tint) = match optics.kd {
        [r, g, b] if r == g && g == b => (r, [1.0; 3]),
        tint => (1.0, tint),
    };
    let pigment = pigments.write(tint, 1.0 - opacity)?;
    let strength = number(kd / opacity);
    let mirror = if optics.ks.iter().any(|k| *k > 0.0) {
        format!(" reflection {{ {} }}", rgb(optics.ks))
    } else {
        String::new()
    };
    let upper = format!(
        "\n  texture {{\n    {pigment}\n    finish {{ ambient {strength} diffuse {strength}{mirror} }}\n  }}"
    );
    if !transparent {
        return Ok(upper);
    }
    let [r, g, b] = optics.kt.map(|k| number(2.0 * k));
    Ok(format!(
        "\n  texture {{ pigment {{ rgbf <{r}, {g}, {b}, 1> }} finish {{ ambient 0 diffuse 0 }} }}{upper}"
    ))
}

struct Pigments<'a> {
    texture: &'a Texture,
    frame: &'a Matrix,
    shape: Option<&'a crate::scene::Shape>,
    name: &'a str,
    owner: u32,
}

/// Moves the edges between cells by so little that it cannot be seen, so that a face lying in such
/// an edge is not speckled by rounding.
const NUDGE: &str = "1e-9";

impl Pigments<'_> {
    /// The declarations of the surface coordinates that a checkerboard needs.
    fn functions(&self) -> Result<String, Unsupported> {
        if !matches!(self.texture, Texture::Checkerboard { .. }) {
            return Ok(String::new());
        }
        let uv = self.shape.and_then(|s| uv::expressions(&s.geometry));
        let Some([u, v]) = uv else {
            return Err(Unsupported {
                id: self.owner,
                span: self.shape.map(|s| s.span),
                message: format!(
                    "the checkerboard of {} cannot be laid on this shape in POV-Ray yet",
                    self.owner
                ),
            });
        };
        let name = self.name;
        Ok(format!(
            "#declare {name}_u = function {{ {u} }}\n#declare {name}_v = function {{ {v} }}\n"
        ))
    }

    /// `pigment { … }` with all colours multiplied by `tint`.
    fn write(&self, tint: Rgb, transmit: f64) -> Result<String, Unsupported> {
        let colour = |c: &Rgb| {
            let c = [c[0] * tint[0], c[1] * tint[1], c[2] * tint[2]];
            if transmit > 0.0 {
                let [r, g, b] = c.map(number);
                format!("rgbt <{r}, {g}, {b}, {}>", number(transmit))
            } else {
                rgb(c)
            }
        };
        // Even sums of cells give 1/4, odd ones 3/4: well away from where the map changes.
        let cells = |sum: &str, colours: &[Rgb; 2], rest: &str| {
            format!(
                "pigment {{\n      function {{ 0.25 + 0.5*abs(mod({sum}, 2)) }}\n      color_map {{ [0.5 {}] [0.5 {}] }}{rest}\n    }}",
                colour(&colours[0]),
                colour(&colours[1])
            )
        };
        let floor = |what: &str| format!("floor({what} + {NUDGE})");
        match self.texture {
            Texture::Colour(c) => Ok(format!("pigment {{ {} }}", colour(c))),
            Texture::Solid { colours, size } => {
                let size = number(*size);
                let sum = ["x", "y", "z"]
                    .map(|axis| floor(&format!("{axis}/{size}")))
                    .join(" + ");
                let frame = if *self.frame == Matrix::IDENTITY {
                    String::new()
                } else {
                    format!("\n      {}", matrix(self.frame))
                };
                Ok(cells(&sum, colours, &frame))
            }
            Texture::Checkerboard { n, m, colours } => {
                let sum = format!(
                    "{} + {}",
                    floor(&format!("{n}*{}_u(x, y, z)", self.name)),
                    floor(&format!("{m}*{}_v(x, y, z)", self.name))
                );
                Ok(cells(&sum, colours, ""))
            }
            Texture::Image { file, span } => Err(Unsupported {
                id: self.owner,
                span: Some(*span),
                message: format!("the image {file} cannot be translated to POV-Ray yet"),
            }),
        }
    }
}
