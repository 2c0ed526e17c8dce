//! A translation as text. Nothing is decided here: all that is printed stands in the [document](Document).

mod objects;
mod poly;
mod profile;
mod shape;
pub(super) mod text;
mod textures;
mod uv;

use std::fmt::{Result, Write};

use super::tree::{Document, Frame, Lens, Light};
use crate::diagnostics::Language;
use crate::translate::number;
use text::{Page, rgb, vector};

/// The look of faces that are only there for POV-Ray to know where a ray leaves an object.
const UNSEEN: &str = "\
    // Where one medium ends in another: a hair behind the face that is seen.\n\
    #declare Unseen = texture { pigment { rgbf 1 } finish { ambient 0 diffuse 0 } };\n";

/// The declaration of all of space: a half-space whose boundary is farther away than POV-Ray sees.
const EVERYWHERE: &str = "\
    // All of space. What is clipped by it without something else is kept outside of that.\n\
    #declare Everywhere = plane { <0, 1, 0>, 1e9 };\n";

/// Prints a file for a camera, or for two with a switch. `name` is the file's name without its extension. The comments
/// at the head of the file are in the language.
///
/// # Errors
/// The errors of the stream.
pub(super) fn print(
    out: &mut dyn Write,
    document: &Document,
    lenses: &[Lens],
    name: &str,
    language: Language,
) -> Result {
    let say = |message| language.say(message, &[]);
    header(out, document, lenses, name, &say)?;
    settings(out, document, &say)?;
    cameras(out, lenses, &document.frame)?;
    if !document.lights_in_group {
        let mut page = Page::new(out);
        lights(&mut page, document)?;
    }
    out.write_char('\n')?;
    if document.tree.uses.unseen {
        out.write_str(UNSEEN)?;
    }
    textures::print(out, &document.tree)?;
    out.write_char('\n')?;
    if document.tree.uses.everywhere {
        out.write_str(EVERYWHERE)?;
    }
    shape::geodesics(out, &document.tree.uses.splits)?;
    objects::print(out, &document.tree)?;
    if !document.lights_in_group {
        return picture(&mut Page::new(out), document);
    }
    // For lights outside of a group, POV-Ray remembers the object that was last in the way, and tests that object
    // first, without its tolerance. So a light may be hidden by the surface that it lies on.
    out.write_str(
        "\n// A light that lies on a surface is not hidden by that in a light group.\nlight_group {\n",
    )?;
    let mut page = Page::new(out);
    page.indented(|page| {
        lights(page, document)?;
        picture(page, document)
    })?;
    out.write_str("}\n")
}

/// Writes the head of the file: the command that renders it so that its pixels can be compared, and the switches in
/// this command.
fn header(
    out: &mut dyn Write,
    document: &Document,
    lenses: &[Lens],
    name: &str,
    say: &dyn Fn(&'static str) -> String,
) -> Result {
    let (w, h) = document.size;
    let argument = |option: &str, ending: &str| match name.contains(char::is_whitespace) {
        true => format!("\"{option}{name}.{ending}\""),
        false => format!("{option}{name}.{ending}"),
    };
    let (input, output) = (argument("+I", "pov"), argument("+O", "png"));
    if let Some(title) = document.title {
        writeln!(out, "// {title}")?;
    }
    write!(
        out,
        "// {}\n//   povray {input} {output} +W{w} +H{h} -A -D +FN16 File_Gamma=1.0",
        say("pov-head")
    )?;
    if document.tree.uses.dispersion {
        out.write_str(" Declare=Channel=0")?;
    }
    if lenses.len() > 1 {
        out.write_str(" Declare=Eye=0")?;
    }
    if document.light_scale < 1.0 {
        write!(out, " Declare=Light_Scale={}", number(document.light_scale))?;
    }
    out.write_char('\n')?;
    if document.tree.uses.dispersion {
        writeln!(
            out,
            "// {}\n// {}\n#ifndef (Channel) #declare Channel = 0; #end",
            say("pov-channels"),
            say("pov-channels-kept")
        )?;
    }
    if lenses.len() > 1 {
        writeln!(
            out,
            "// {}\n#ifndef (Eye) #declare Eye = 0; #end",
            say("pov-eyes")
        )?;
    }
    Ok(())
}

/// Writes scales, global settings, defaults and the background.
fn settings(
    out: &mut dyn Write,
    document: &Document,
    say: &dyn Fn(&'static str) -> String,
) -> Result {
    writeln!(
        out,
        "#version 3.7;\n\n\
         // {}\n\
         #ifndef (Light_Scale) #declare Light_Scale = 1; #end",
        say("pov-light")
    )?;
    let Frame { centre, unit } = &document.frame;
    if document.frame.is_moved() {
        write!(
            out,
            "// {}\n#declare Centre = {};\n",
            say("pov-centre"),
            vector(centre)
        )?;
    }
    let (ambient, background) = (rgb(document.ambient), rgb(document.background));
    write!(
        out,
        "// {}\n\
         #declare Unit = {};\n\
         \nglobal_settings {{\n  assumed_gamma 1\n  ambient_light {ambient}*Light_Scale\n  \
         max_trace_level {}\n  adc_bailout 0\n}}\n\
         #default {{ texture {{ pigment {{ rgb 1 }} finish {{ ambient 1 diffuse 1 emission 0 }} }} }}\n\
         background {{ {background}*Light_Scale }}\n\n",
        say("pov-unit"),
        number(*unit),
        document.levels
    )
}

/// The modifier that brings cameras, lights and objects from the scene's coordinates to POV-Ray's.
fn place(frame: &Frame) -> &'static str {
    match frame.is_moved() {
        true => "translate -Centre scale Unit",
        false => "scale Unit",
    }
}

/// Writes a camera, or two behind a switch.
fn cameras(out: &mut dyn Write, lenses: &[Lens], frame: &Frame) -> Result {
    for (i, lens) in lenses.iter().enumerate() {
        if lenses.len() > 1 {
            writeln!(out, "#if (Eye = {i})")?;
        }
        writeln!(out, "camera {{ // {}", lens.caption)?;
        if lens.parallel {
            out.write_str("  orthographic\n")?;
        }
        write!(
            out,
            "  location {}\n  direction {}\n  right {}\n  up {}\n",
            vector(&lens.location),
            vector(&lens.direction),
            vector(&lens.right),
            vector(&lens.up),
        )?;
        if lens.parallel {
            let shift = vector(&lens.shift);
            writeln!(
                out,
                "  translate {shift} // by a hair, so that no ray runs exactly along a face or a seam"
            )?;
        }
        writeln!(out, "  {}\n}}", place(frame))?;
        if lenses.len() > 1 {
            out.write_str("#end\n")?;
        }
    }
    Ok(())
}

/// The point lights, one a line.
fn lights(page: &mut Page, document: &Document) -> Result {
    let place = place(&document.frame);
    for Light {
        caption,
        position,
        colour,
        intensity,
    } in &document.lights
    {
        page.line(format_args!(
            "light_source {{ {}, {}*{}*Light_Scale {place} }} // {caption}",
            vector(position),
            rgb(*colour),
            number(*intensity),
        ))?;
    }
    Ok(())
}

/// The object that is drawn.
fn picture(page: &mut Page, document: &Document) -> Result {
    page.blank()?;
    let Some(root) = document.tree.root else {
        return page.line(format_args!("// There is nothing to draw."));
    };
    page.line(format_args!("// the scene: {}", document.caption))?;
    page.line(format_args!("object {{"))?;
    page.indented(|page| {
        page.line(format_args!("{}", document.tree.objects[root].name))?;
        if let Some((min, max)) = &document.clip {
            page.line(format_args!("// only what lies in this box is drawn"))?;
            let (min, max) = (vector(min), vector(max));
            page.line(format_args!("clipped_by {{ box {{ {min}, {max} }} }}"))?;
        }
        page.line(format_args!("{}", place(&document.frame)))
    })?;
    page.line(format_args!("}}"))
}
