//! Textures with optics as POV-Ray's layered textures.
//!
//! POV-Ray scales the diffuse and ambient terms by a layer's opacity. A transparent texture is therefore two layers:
//! the lower one lets 2·kt through and nothing else; the upper one is half transparent, which makes that kt, and has
//! its ambient and diffuse terms doubled.

use std::fmt::{Result, Write};

use super::profile::Profile;
use super::shape::coordinates;
use super::text::{matrix, rgb};
use super::uv::Along;
use crate::geometry::Matrix;
use crate::scene::{CELL_NUDGE, Geometry, Rgb};
use crate::translate::number;
use crate::translate::pov::tree::{Image, Pattern, Texture, Tree};

/// Prints the declarations of all images and textures.
pub(super) fn print(out: &mut dyn Write, tree: &Tree) -> Result {
    for (i, image) in tree.images.iter().enumerate() {
        let is_looked_up = |texture: &Texture| {
            matches!(texture.pattern, Pattern::Image(_, number) if number == i)
                && image_map(texture).is_none()
        };
        if tree.textures.iter().any(is_looked_up) {
            writeln!(
                out,
                "#declare {} = function {{ pigment {{ {} }} }} // {}",
                image_name(i),
                lookup(image),
                image.caption
            )?;
        }
    }
    for texture in &tree.textures {
        functions(out, texture)?;
        write!(out, "#declare {} =", texture.name)?;
        layers(out, texture, &tree.images)?;
        out.write_str(";\n")?;
    }
    Ok(())
}

/// The text of an image that fills the unit square.
fn lookup(image: &Image) -> String {
    format!("image_map {{ {} gamma srgb interpolate 2 }}", image.file)
}

/// The name of the function that looks up an image.
fn image_name(number: usize) -> String {
    format!("Image_{}", number + 1)
}

/// Prints the declarations of the surface coordinates that a pattern on a shape needs.
fn functions(out: &mut dyn Write, texture: &Texture) -> Result {
    let shape = match &texture.pattern {
        Pattern::Checkerboard(shape, cells, _) if laid(shape, *cells).is_none() => shape,
        Pattern::Image(shape, _) if image_map(texture).is_none() => shape,
        _ => return Ok(()),
    };
    let name = &texture.name;
    let coordinates = coordinates(shape);
    writeln!(out, "#declare {name}_u = function {{ {} }}", coordinates.u)?;
    match coordinates.v {
        Along::Expression(v) => writeln!(out, "#declare {name}_v = function {{ {v} }}"),
        Along::Pattern(v) => writeln!(
            out,
            "#declare {name}_along = function {{ pigment {{ {v} }} }}\n\
             #declare {name}_v = function {{ {name}_along(x, y, z).red }}"
        ),
    }
}

/// The text before and the text behind a pattern of unit squares that lay it on a shape, with `n` and `m` cells along
/// the surface coordinates. `None` for shapes on which POV-Ray has no such coordinates.
fn laid(shape: &Geometry, [n, m]: [u32; 2]) -> Option<(&'static str, String)> {
    let [n, m] = [n, m].map(f64::from);
    match shape {
        Geometry::Rectangle { min, max } => {
            let [width, height] = [0, 1].map(|i: usize| max[i] - min[i]);
            let size = [width / n, height / m, 1.0].map(number).join(", ");
            let from = [min[0], min[1], 0.0].map(number).join(", ");
            Some(("", format!("scale <{size}> translate <{from}>")))
        }
        // POV-Ray's first coordinate runs round a sphere the other way.
        Geometry::Sphere { .. } => {
            let size = [-1.0 / n, 1.0 / m, 1.0].map(number).join(", ");
            Some(("uv_mapping ", format!("scale <{size}> translate x")))
        }
        _ => None,
    }
}

/// The text before and the text behind an image that lay it on a shape. `None` if the image has to be looked up channel
/// by channel: the shape has no such coordinates, or the image is tinted or lets light through, neither of which
/// POV-Ray's images can do.
fn image_map(texture: &Texture) -> Option<(&'static str, String)> {
    let optics = &texture.optics;
    let is_grey = optics.kd.iter().all(|k| *k == optics.kd[0]);
    match texture.pattern {
        Pattern::Image(shape, _) if is_grey && optics.kt == [0.0; 3] => laid(shape, [1, 1]),
        _ => None,
    }
}

fn layers(out: &mut dyn Write, texture: &Texture, images: &[Image]) -> Result {
    let optics = &texture.optics;
    let transparent = optics.kt.iter().any(|k| *k > 0.0);
    let opacity = if transparent { 0.5 } else { 1.0 };
    // POV-Ray's diffuse coefficient is one number, so coefficients that differ by channel go into the pigment.
    let (kd, tint) = match optics.kd {
        [r, g, b] if r == g && g == b => (r, [1.0; 3]),
        tint => (1.0, tint),
    };
    if transparent {
        let [r, g, b] = optics.kt.map(|k| number(2.0 * k));
        write!(
            out,
            "\n  texture {{ pigment {{ rgbf <{r}, {g}, {b}, 1> }} finish {{ ambient 0 diffuse 0 }} }}"
        )?;
    }
    let strength = number(kd / opacity);
    out.write_str("\n  texture {\n    ")?;
    pigment(out, (texture, images), tint, 1.0 - opacity)?;
    // The second number of `diffuse` is for light from the other side.
    let other_side = if texture.is_behind { "0, " } else { "" };
    write!(
        out,
        "\n    finish {{ ambient {strength} diffuse {other_side}{strength}"
    )?;
    if optics.ks.iter().any(|k| *k > 0.0) {
        write!(out, " reflection {{ {} }}", rgb(optics.ks))?;
    }
    out.write_str(" }\n  }")
}

/// `pigment { … }` with all colours multiplied by `tint`.
fn pigment(
    out: &mut dyn Write,
    (texture, images): (&Texture, &[Image]),
    tint: Rgb,
    transmit: f64,
) -> Result {
    let colour = |c: &Rgb| {
        let c = [c[0] * tint[0], c[1] * tint[1], c[2] * tint[2]];
        if transmit > 0.0 {
            let [r, g, b] = c.map(number);
            format!("rgbt <{r}, {g}, {b}, {}>", number(transmit))
        } else {
            rgb(c)
        }
    };
    // Patterns on a lathe use the lathe's own coordinates; those on other shapes are functions of the point.
    let mapped = |shape: &Geometry| match shape {
        Geometry::Revolution { .. } => "uv_mapping ",
        _ => "",
    };
    let name = &texture.name;
    match &texture.pattern {
        Pattern::Colour(c) => return write!(out, "pigment {{ {} }}", colour(c)),
        Pattern::Profile(profile, colours) => {
            let pattern = Profile::of(profile).pattern(colours.iter().map(colour));
            write!(out, "pigment {{\n      uv_mapping {pattern}")?;
        }
        Pattern::Cubes(frame, colours, size) => {
            let [a, b] = colours.each_ref().map(colour);
            write!(
                out,
                "pigment {{\n      checker {a}, {b} scale {}",
                number(*size)
            )?;
            if *frame != Matrix::IDENTITY {
                write!(out, "\n      {}", matrix(frame))?;
            }
        }
        Pattern::Checkerboard(shape, cells, colours) => match laid(shape, *cells) {
            Some((before, behind)) => {
                let [a, b] = colours.each_ref().map(colour);
                write!(out, "pigment {{\n      {before}checker {a}, {b} {behind}")?;
            }
            None => {
                let floor = |count: u32, what: &str| {
                    format!("floor({count}*{name}_{what}(x, y, z) + {CELL_NUDGE:e})")
                };
                // Even sums of cells give 1/4, odd ones 3/4: well away from where the map changes.
                write!(
                    out,
                    "pigment {{\n      {}function {{ 0.25 + 0.5*abs(mod({} + {}, 2)) }}\n      \
                     color_map {{ [0.5 {}] [0.5 {}] }}",
                    mapped(shape),
                    floor(cells[0], "u"),
                    floor(cells[1], "v"),
                    colour(&colours[0]),
                    colour(&colours[1])
                )?;
            }
        },
        Pattern::Image(shape, image) => {
            if let Some((before, behind)) = image_map(texture) {
                let image = &images[*image];
                return write!(
                    out,
                    "pigment {{\n      {before}{} {behind} // {}\n    }}",
                    lookup(image),
                    image.caption
                );
            }
            let place = format!(
                "{}({name}_u(x, y, z), {name}_v(x, y, z), 0)",
                image_name(*image)
            );
            write!(
                out,
                "pigment {{\n      {}average pigment_map {{",
                mapped(shape)
            )?;
            // The pigment is the mean of one pigment for each channel, each three times as bright.
            for (c, part) in ["red", "green", "blue"].into_iter().enumerate() {
                let mut full = [0.0; 3];
                full[c] = 3.0;
                write!(
                    out,
                    "\n      [1 function {{ 0.25 + 0.5*{place}.{part} }} color_map {{ [0.25 {}] [0.75 {}] }}]",
                    colour(&[0.0; 3]),
                    colour(&full)
                )?;
            }
            out.write_str("\n      }")?;
        }
    }
    out.write_str("\n    }")
}
