//! Textures with optics as POV-Ray's layered textures.
//!
//! POV-Ray scales the diffuse and ambient terms by a layer's opacity. A transparent look is
//! therefore two layers: the lower one lets 2·kt through and nothing else; the upper one is half
//! transparent, which makes that kt, and has its ambient and diffuse terms doubled.

use std::collections::HashMap;

use super::aspects::{Aspects, DEFAULT, PROFILE, TextureUse};
use super::pictures::Pictures;
use super::profile::Profile;
use super::shape::coordinates;
use super::text::{matrix, number, rgb};
use super::uv::Along;
use crate::geometry::Matrix;
use crate::scene::{CELL_NUDGE, Geometry, Optics, Rgb, Scene, Texture};

/// A texture with optics; for a texture that is laid on shapes, on a shape.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
struct Look {
    texture: TextureUse,
    optics: u32,
    shape: Option<u32>,
    /// Light comes from the other side.
    behind: bool,
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
            behind: false,
        };
        let next = self.looks.len() as u32;
        let number = *self.numbers.entry(look).or_insert(next);
        if number == next {
            let owner = aspects.owner(texture.texture, optics);
            let mut name = match (owner, shape) {
                (0, Some((_, id))) => format!("Look_{id}"),
                (owner, Some((_, id))) => format!("Look_{owner}_on_{id}"),
                (owner, None) => format!("Look_{owner}"),
            };
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

    /// The same look lit from the other side; nothing for one that light goes through.
    pub fn behind(&mut self, aspects: &Aspects, look: u32) -> Option<u32> {
        let front = self.looks[look as usize];
        if aspects.is_transparent(front.optics) {
            return None;
        }
        let behind = Look {
            behind: true,
            ..front
        };
        let next = self.looks.len() as u32;
        let number = *self.numbers.entry(behind).or_insert(next);
        if number == next {
            let name = format!("{}_Behind", self.names[look as usize]);
            self.looks.push(behind);
            self.names.push(name);
        }
        Some(number)
    }

    /// Whether light goes through a look.
    pub fn is_transparent(&self, aspects: &Aspects, look: u32) -> bool {
        aspects.is_transparent(self.looks[look as usize].optics)
    }

    /// What a look is called: after the entity that was given it.
    pub fn name(&self, number: u32) -> &str {
        &self.names[number as usize]
    }

    /// The optics of all looks.
    pub fn optics(&self) -> impl Iterator<Item = u32> {
        self.looks.iter().map(|l| l.optics)
    }

    /// The picture files that looks show, as the scene names them.
    pub fn pictures<'a>(&'a self, aspects: &'a Aspects) -> impl Iterator<Item = &'a str> {
        (self.looks.iter()).filter_map(|look| match aspects.texture(look.texture.texture) {
            Texture::Image { file, .. } => Some(file.as_str()),
            _ => None,
        })
    }

    /// The declarations of all looks.
    pub fn write(&self, out: &mut String, aspects: &Aspects, scene: &Scene, pictures: &Pictures) {
        let mut images = Images::default();
        for (look, name) in self.looks.iter().zip(&self.names) {
            let pigments = Pigments {
                pattern: Pattern::of(look, aspects, scene),
                frame: aspects.frame(look.texture.frame),
                shape: look.shape.map(|s| &scene.shapes[s as usize].geometry),
                name,
            };
            if let Pattern::Image(file) = pigments.pattern {
                images.declare(out, file, pictures);
            }
            out.push_str(&pigments.functions());
            out.push_str(&format!("#declare {name} ="));
            let optics = aspects.optics(look.optics);
            out.push_str(&layers(&pigments, optics, look.behind, &images));
            out.push_str(";\n");
        }
    }
}

/// What is drawn on a surface.
enum Pattern<'a> {
    Colour(Rgb),
    /// The colours of a profile's points, along it.
    Profile(&'a [[f64; 2]], &'a [Rgb]),
    Solid(&'a [Rgb; 2], f64),
    Checkerboard([u32; 2], &'a [Rgb; 2]),
    Image(&'a str),
}

impl<'a> Pattern<'a> {
    fn of(look: &Look, aspects: &'a Aspects, scene: &'a Scene) -> Pattern<'a> {
        if look.texture.texture == PROFILE
            && let Some(shape) = look.shape
            && let Geometry::Revolution { profile, colours } =
                &scene.shapes[shape as usize].geometry
        {
            return Pattern::Profile(profile, colours);
        }
        match aspects.texture(look.texture.texture) {
            Texture::Colour(c) => Pattern::Colour(*c),
            Texture::Solid { colours, size } => Pattern::Solid(colours, *size),
            Texture::Checkerboard { n, m, colours } => Pattern::Checkerboard([*n, *m], colours),
            Texture::Image { file, .. } => Pattern::Image(file),
        }
    }

    fn lies_on_shape(&self) -> bool {
        matches!(self, Pattern::Checkerboard(..) | Pattern::Image(_))
    }
}

/// The functions that look up pictures, one a file.
#[derive(Default)]
struct Images<'a>(HashMap<&'a str, String>);

impl<'a> Images<'a> {
    fn declare(&mut self, out: &mut String, file: &'a str, pictures: &Pictures) {
        let next = self.0.len() + 1;
        if self.0.contains_key(file) {
            return;
        }
        let name = format!("Image_{next}");
        let named = pictures.named(file);
        let said = file.replace(char::is_control, " ");
        out.push_str(&format!(
            "#declare {name} = function {{ pigment {{ image_map {{ {named} gamma srgb interpolate 2 }} }} }} // {said}\n"
        ));
        self.0.insert(file, name);
    }
}

fn layers(pigments: &Pigments, optics: &Optics, behind: bool, images: &Images) -> String {
    let transparent = optics.kt.iter().any(|k| *k > 0.0);
    let opacity = if transparent { 0.5 } else { 1.0 };
    // The diffuse coefficient is one number there; one of each channel goes into the pigment.
    let (kd, tint) = match optics.kd {
        [r, g, b] if r == g && g == b => (r, [1.0; 3]),
        tint => (1.0, tint),
    };
    let pigment = pigments.write(tint, 1.0 - opacity, images);
    let strength = number(kd / opacity);
    // The second number is for light from the other side.
    let diffuse = match behind {
        true => format!("0, {strength}"),
        false => strength.clone(),
    };
    let mirror = if optics.ks.iter().any(|k| *k > 0.0) {
        format!(" reflection {{ {} }}", rgb(optics.ks))
    } else {
        String::new()
    };
    let upper = format!(
        "\n  texture {{\n    {pigment}\n    finish {{ ambient {strength} diffuse {diffuse}{mirror} }}\n  }}"
    );
    if !transparent {
        return upper;
    }
    let [r, g, b] = optics.kt.map(|k| number(2.0 * k));
    format!(
        "\n  texture {{ pigment {{ rgbf <{r}, {g}, {b}, 1> }} finish {{ ambient 0 diffuse 0 }} }}{upper}"
    )
}

struct Pigments<'a> {
    pattern: Pattern<'a>,
    frame: &'a Matrix,
    shape: Option<&'a Geometry>,
    name: &'a str,
}

impl Pigments<'_> {
    /// The declarations of the surface coordinates that a pattern on a shape needs.
    fn functions(&self) -> String {
        let Some(shape) = self.shape.filter(|_| self.pattern.lies_on_shape()) else {
            return String::new();
        };
        let name = self.name;
        let coordinates = coordinates(shape);
        let v = match coordinates.v {
            Along::Expression(v) => format!("#declare {name}_v = function {{ {v} }}\n"),
            Along::Pattern(v) => format!(
                "#declare {name}_along = function {{ pigment {{ {v} }} }}\n\
                 #declare {name}_v = function {{ {name}_along(x, y, z).red }}\n"
            ),
        };
        format!("#declare {name}_u = function {{ {} }}\n{v}", coordinates.u)
    }

    /// `pigment { … }` with all colours multiplied by `tint`.
    fn write(&self, tint: Rgb, transmit: f64, images: &Images) -> String {
        let colour = |c: &Rgb| {
            let c = [c[0] * tint[0], c[1] * tint[1], c[2] * tint[2]];
            if transmit > 0.0 {
                let [r, g, b] = c.map(number);
                format!("rgbt <{r}, {g}, {b}, {}>", number(transmit))
            } else {
                rgb(c)
            }
        };
        // A lathe's measure of itself; all others have functions of the point.
        let lathe = matches!(self.shape, Some(Geometry::Revolution { .. }));
        let mapped = match &self.pattern {
            Pattern::Profile(..) => "uv_mapping ",
            p if p.lies_on_shape() && lathe => "uv_mapping ",
            _ => "",
        };
        // Even sums of cells give 1/4, odd ones 3/4: well away from where the map changes.
        let cells = |sum: &str, colours: &[Rgb; 2], rest: &str| {
            format!(
                "pigment {{\n      {mapped}function {{ 0.25 + 0.5*abs(mod({sum}, 2)) }}\n      color_map {{ [0.5 {}] [0.5 {}] }}{rest}\n    }}",
                colour(&colours[0]),
                colour(&colours[1])
            )
        };
        let floor = |what: &str| format!("floor({what} + {CELL_NUDGE:e})");
        let name = self.name;
        match &self.pattern {
            Pattern::Colour(c) => format!("pigment {{ {} }}", colour(c)),
            Pattern::Profile(profile, colours) => {
                let pattern = Profile::of(profile).colour_pattern(colours, colour);
                format!("pigment {{\n      {mapped}{pattern}\n    }}")
            }
            Pattern::Solid(colours, size) => {
                let size = number(*size);
                let sum = ["x", "y", "z"]
                    .map(|axis| floor(&format!("{axis}/{size}")))
                    .join(" + ");
                let frame = if *self.frame == Matrix::IDENTITY {
                    String::new()
                } else {
                    format!("\n      {}", matrix(self.frame))
                };
                cells(&sum, colours, &frame)
            }
            Pattern::Checkerboard([n, m], colours) => {
                let sum = format!(
                    "{} + {}",
                    floor(&format!("{n}*{name}_u(x, y, z)")),
                    floor(&format!("{m}*{name}_v(x, y, z)"))
                );
                cells(&sum, colours, "")
            }
            Pattern::Image(file) => {
                let image = images.0.get(file).map_or("", String::as_str);
                let place = format!("{image}({name}_u(x, y, z), {name}_v(x, y, z), 0)");
                // The mean of the three channels, three times as bright.
                let channel = |c: usize, part: &str| {
                    let mut full = [0.0; 3];
                    full[c] = 3.0;
                    format!(
                        "\n      [1 function {{ 0.25 + 0.5*{place}.{part} }} color_map {{ [0.25 {}] [0.75 {}] }}]",
                        colour(&[0.0; 3]),
                        colour(&full)
                    )
                };
                format!(
                    "pigment {{\n      {mapped}average pigment_map {{{}{}{}\n      }}\n    }}",
                    channel(0, "red"),
                    channel(1, "green"),
                    channel(2, "blue")
                )
            }
        }
    }
}
