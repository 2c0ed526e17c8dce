//! Wavefront OBJ with a library of materials beside it.

use std::collections::HashMap;
use std::fmt::Write as _;

use super::material::Coloured;
use crate::scene::{DEFAULT_COLOUR, Rgb};
use crate::translate::names::Names;

/// The text of the mesh file, and that of the material file. `library` is the name of the material file; `picture`
/// gives the file name of each picture. Objects are named after the scene's. All faces around a point share it, so
/// that closed meshes stay closed.
pub fn write(
    coloured: &Coloured,
    places: &[[String; 3]],
    names: &Names,
    library: &str,
    picture: impl Fn(u32) -> String,
) -> (String, String) {
    let mesh = &coloured.model.mesh;
    let smooth = coloured.materials.iter().any(|m| m.colour.is_none());
    let mut out = String::with_capacity(48 * (mesh.points.len() + mesh.triangles.len()));
    // Writing to a string does not fail.
    let _ = writeln!(
        out,
        "# made by zpg; lengths as in the scene, y is up\nmtllib {library}"
    );
    let mut colours = vec![DEFAULT_COLOUR; mesh.points.len()];
    for vertex in &coloured.vertices {
        colours[vertex.point as usize] = vertex.colour;
    }
    for ([x, y, z], colour) in places.iter().zip(&colours) {
        let _ = write!(out, "v {x} {y} {z}");
        if smooth {
            // Colours stand behind the coordinates and are linear, as many programs read them. Four digits are finer
            // than 8 bits.
            let [r, g, b] = colour.map(|c| (c * 1e4).round() / 1e4);
            let _ = write!(out, " {r} {g} {b}");
        }
        out.push('\n');
    }
    let mut normals = Numbered::default();
    let mut texels = Numbered::default();
    let numbers: Vec<[usize; 2]> = (coloured.vertices.iter())
        .map(|v| {
            // Normals are written to a hundredth of a degree, surface coordinates to a hundredth of a pixel of the
            // largest pictures.
            let [x, y, z] = v.normal.map(|x| (x * 1e4).round() / 1e4 + 0.0);
            let [s, t] = v.uv.map(|x| (x * 1e6).round() / 1e6 + 0.0);
            [
                normals.number(format!("vn {x} {y} {z}\n")),
                texels.number(format!("vt {s} {t}\n")),
            ]
        })
        .collect();
    out.push_str(&normals.text);
    let pictured = coloured.materials.iter().any(|m| m.picture.is_some());
    if pictured {
        out.push_str(&texels.text);
    }
    let mut library = String::from("# made by zpg\n");
    for (i, material) in coloured.materials.iter().enumerate() {
        let colour = material.colour.unwrap_or(DEFAULT_COLOUR);
        let o = &material.optics;
        let through = o.kt.iter().sum::<f64>() / 3.0;
        let index = material.index.iter().sum::<f64>() / 3.0;
        let by = |k: Rgb, c: Rgb| {
            let [r, g, b] = [0, 1, 2].map(|i| k[i] * c[i]);
            format!("{r} {g} {b}")
        };
        let model = match (through > 0.0, o.ks != [0.0; 3]) {
            (true, _) => 7,
            (false, true) => 3,
            (false, false) => 1,
        };
        let _ = write!(
            library,
            "\nnewmtl material_{i}\nKa {0}\nKd {0}\nKs {1}\nTf {2}\nd {3}\nNi {index}\nillum {model}\n",
            by(o.kd, colour),
            by(o.ks, DEFAULT_COLOUR),
            by(o.kt, DEFAULT_COLOUR),
            1.0 - through.clamp(0.0, 1.0) * 0.9,
        );
        if let Some(number) = material.picture {
            let _ = writeln!(library, "map_Kd {}", picture(number));
        }
    }
    for object in &coloured.objects {
        if let Some(comment) = names.comment(object.id) {
            let _ = writeln!(out, "# {comment}");
        }
        let _ = writeln!(out, "o {}", object.name());
        for (i, triangles) in &object.triangles {
            let pictured = coloured.materials[*i].picture.is_some();
            let _ = writeln!(out, "usemtl material_{i}");
            for &t in triangles {
                out.push('f');
                for v in coloured.triangles[t as usize] {
                    let point = coloured.vertices[v as usize].point + 1;
                    let [normal, place] = numbers[v as usize];
                    let _ = match pictured {
                        true => write!(out, " {point}/{place}/{normal}"),
                        false => write!(out, " {point}//{normal}"),
                    };
                }
                out.push('\n');
            }
        }
    }
    (out, library)
}

/// Lines of which each is written once, with their numbers, counted from 1.
#[derive(Default)]
struct Numbered {
    text: String,
    known: HashMap<String, usize>,
}

impl Numbered {
    fn number(&mut self, line: String) -> usize {
        let next = self.known.len() + 1;
        *self.known.entry(line).or_insert_with_key(|line| {
            self.text.push_str(line);
            next
        })
    }
}
