//! Textures with optics as POV-Ray's layered textures.
//!
//! POV-Ray scales the diffuse and ambient terms by a layer's opacity. A transparent texture is therefore two layers:
//! the lower one lets 2·kt through and nothing else; the upper one is half transparent, which makes that kt, and has
//! its ambient and diffuse terms doubled.

use std::fmt::{Result, Write};

use super::profile::Profile;
use super::shape::coordinates;
use super::text::{matrix, number, rgb};
use super::uv::Along;
use crate::geometry::Matrix;
use crate::scene::{CELL_NUDGE, Geometry, Rgb};
use crate::translate::pov::tree::{Pattern, Texture, Tree};

/// Prints the declarations of all images and textures.
pub(super) fn print(out: &mut dyn Write, tree: &Tree) -> Result {
    for (i, image) in tree.images.iter().enumerate() {
        writeln!(
            out,
            "#declare {} = function {{ pigment {{ image_map {{ {} gamma srgb interpolate 2 }} }} }} // {}",
            image_name(i),
            image.file,
            image.caption
        )?;
    }
    for texture in &tree.textures {
        functions(out, texture)?;
        write!(out, "#declare {} =", texture.name)?;
        layers(out, texture)?;
        out.write_str(";\n")?;
    }
    Ok(())
}

/// The function that looks up an image.
fn image_name(number: usize) -> String {
    format!("Image_{}", number + 1)
}

/// The declarations of the surface coordinates that a pattern on a shape needs.
fn functions(out: &mut dyn Write, texture: &Texture) -> Result {
    let (Pattern::Checkerboard(shape, ..) | Pattern::Image(shape, _)) = &texture.pattern else {
        return Ok(());
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

fn layers(out: &mut dyn Write, texture: &Texture) -> Result {
    let optics = &texture.optics;
    let transparent = optics.kt.iter().any(|k| *k > 0.0);
    let opacity = if transparent { 0.5 } else { 1.0 };
    // The diffuse coefficient is one number there; one of each channel goes into the pigment.
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
    pigment(out, texture, tint, 1.0 - opacity)?;
    // The second number is for light from the other side.
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
fn pigment(out: &mut dyn Write, texture: &Texture, tint: Rgb, transmit: f64) -> Result {
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
    let mapped = |shape: &Geometry| match shape {
        Geometry::Revolution { .. } => "uv_mapping ",
        _ => "",
    };
    // Even sums of cells give 1/4, odd ones 3/4: well away from where the map changes.
    let cells = |out: &mut dyn Write, mapped: &str, sum: &str, colours: &[Rgb; 2]| {
        write!(
            out,
            "pigment {{\n      {mapped}function {{ 0.25 + 0.5*abs(mod({sum}, 2)) }}\n      \
             color_map {{ [0.5 {}] [0.5 {}] }}",
            colour(&colours[0]),
            colour(&colours[1])
        )
    };
    let floor = |what: &str| format!("floor({what} + {CELL_NUDGE:e})");
    let name = &texture.name;
    match &texture.pattern {
        Pattern::Colour(c) => return write!(out, "pigment {{ {} }}", colour(c)),
        Pattern::Profile(profile, colours) => {
            let pattern = Profile::of(profile).colour_pattern(colours, colour);
            write!(out, "pigment {{\n      uv_mapping {pattern}")?;
        }
        Pattern::Cubes(frame, colours, size) => {
            let size = number(*size);
            let sum = ["x", "y", "z"].map(|axis| floor(&format!("{axis}/{size}")));
            cells(out, "", &sum.join(" + "), colours)?;
            if *frame != Matrix::IDENTITY {
                write!(out, "\n      {}", matrix(frame))?;
            }
        }
        Pattern::Checkerboard(shape, [n, m], colours) => {
            let u = floor(&format!("{n}*{name}_u(x, y, z)"));
            let v = floor(&format!("{m}*{name}_v(x, y, z)"));
            cells(out, mapped(shape), &format!("{u} + {v}"), colours)?;
        }
        Pattern::Image(shape, image) => {
            let place = format!(
                "{}({name}_u(x, y, z), {name}_v(x, y, z), 0)",
                image_name(*image)
            );
            write!(
                out,
                "pigment {{\n      {}average pigment_map {{",
                mapped(shape)
            )?;
            // The mean of the three channels, three times as bright.
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
