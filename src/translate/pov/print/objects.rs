//! Objects as text, one declaration after the other.

use std::fmt::{Result, Write};

use super::shape::{Primitive, primitive};
use super::text::{Page, transformation, vector};
use crate::scene::Volume;
use crate::translate::number;
use crate::translate::pov::tree::{Body, Modifier, Object, Operation, Tree};

/// The most characters of an object, without its braces, that stand on one line.
const LINE_WIDTH: usize = 100;

/// Prints the declarations of all objects.
pub(super) fn print(out: &mut dyn Write, tree: &Tree) -> Result {
    let mut page = Page::new(out);
    for declared in &tree.objects {
        page.write(&format!("#declare {} = ", declared.name))?;
        let comment = declared.object.comment.as_deref();
        object(&mut page, tree, &declared.object, comment)?;
    }
    Ok(())
}

/// Prints an object and ends its line. A comment goes to the end of the object's first line.
fn object(page: &mut Page, tree: &Tree, all: &Object, comment: Option<&str>) -> Result {
    match one_line(all, tree) {
        Some(line) => {
            page.write(&line)?;
            page.end(comment)
        }
        None => {
            lines(page, tree, all, comment)?;
            page.end(None)
        }
    }
}

/// Prints an object over several lines, up to its last brace.
fn lines(page: &mut Page, tree: &Tree, all: &Object, comment: Option<&str>) -> Result {
    let Primitive { keyword, lines } = plain(&all.body, tree);
    page.write(&format!("{keyword} {{"))?;
    page.end(comment)?;
    page.indented(|page| {
        for line in lines {
            page.line(format_args!("{line}"))?;
        }
        if let Body::Operation(operation, operands) = &all.body {
            for operand in operands {
                page.begin()?;
                object(page, tree, operand, operand.comment.as_deref())?;
            }
            if *operation == Operation::CutawayDifference {
                page.line(format_args!("cutaway_textures"))?;
            }
        }
        for modifier in &all.modifiers {
            match modifier {
                Modifier::Clip(by) if one_line(by, tree).is_none() => {
                    page.begin()?;
                    page.write("clipped_by { ")?;
                    self::lines(page, tree, by, None)?;
                    page.write(" }")?;
                    page.end(None)?;
                }
                modifier => {
                    let modifier = said(modifier, tree).unwrap_or_default();
                    page.line(format_args!("{modifier}"))?;
                }
            }
        }
        Ok(())
    })?;
    page.begin()?;
    page.write("}")
}

/// An object on one line; `None` if it is an operation, or too long.
fn one_line(all: &Object, tree: &Tree) -> Option<String> {
    if matches!(all.body, Body::Operation(..)) {
        return None;
    }
    let Primitive { keyword, mut lines } = plain(&all.body, tree);
    for modifier in &all.modifiers {
        lines.push(said(modifier, tree)?);
    }
    let fits = lines.iter().map(String::len).sum::<usize>() < LINE_WIDTH;
    fits.then(|| format!("{keyword} {{ {} }}", lines.join(" ")))
}

/// The keyword of an object, and the lines between its braces, without operands and modifiers.
fn plain(body: &Body, tree: &Tree) -> Primitive {
    match body {
        Body::Shape(geometry) => primitive(geometry),
        Body::Mesh(triangles) => Primitive {
            keyword: "mesh",
            lines: triangles.iter().map(|t| primitive(t).line()).collect(),
        },
        Body::Declared(number) => Primitive::new("object", tree.objects[*number].name.clone()),
        Body::Everything => Primitive::new("object", "Everywhere".to_owned()),
        Body::Operation(operation, _) => Primitive {
            keyword: match operation {
                Operation::Union => "union",
                Operation::Merge => "merge",
                Operation::Intersection => "intersection",
                Operation::Difference | Operation::CutawayDifference => "difference",
            },
            lines: Vec::new(),
        },
    }
}

/// A modifier on one line; `None` for a clip that has no room there.
fn said(modifier: &Modifier, tree: &Tree) -> Option<String> {
    let texture = |number: &usize| &tree.textures[*number].name;
    Some(match modifier {
        Modifier::Matrix(m) => transformation(m),
        Modifier::Texture(number) => format!("texture {{ {} }}", texture(number)),
        Modifier::InnerTexture(number) => format!("interior_texture {{ {} }}", texture(number)),
        Modifier::Unseen => "texture { Unseen }".to_owned(),
        Modifier::UnseenWithin => "interior_texture { Unseen }".to_owned(),
        Modifier::Index([r, g, b]) if r == g && g == b => {
            format!("interior {{ ior {} }}", number(*r))
        }
        Modifier::Index(index) => {
            let [r, g, b] = index.map(number);
            format!("interior {{ ior (Channel = 0 ? {r} : (Channel = 1 ? {g} : {b})) }}")
        }
        Modifier::Inverse => "inverse".to_owned(),
        Modifier::Clip(by) => format!("clipped_by {{ {} }}", one_line(by, tree)?),
        Modifier::Bound(Volume::Box { min, max }) => {
            format!(
                "bounded_by {{ box {{ {}, {} }} }}",
                vector(min),
                vector(max)
            )
        }
        Modifier::Bound(Volume::Sphere { centre, radius }) => {
            format!(
                "bounded_by {{ sphere {{ {}, {} }} }}",
                vector(centre),
                number(*radius)
            )
        }
    })
}
