//! Wavefront OBJ with a library of materials beside it.

use std::fmt::Write as _;

use super::material::Coloured;
use crate::scene::{DEFAULT_COLOUR, Rgb};

/// The text of the mesh, and that of its materials, which is to be found under the name `library`.
pub fn write(coloured: &Coloured, library: &str) -> (String, String) {
    let mesh = &coloured.model.mesh;
    let smooth = coloured.materials.iter().any(|m| m.colour.is_none());
    let mut out = String::with_capacity(48 * (mesh.points.len() + mesh.triangles.len()));
    // Writing to a string does not fail.
    let _ = writeln!(
        out,
        "# made by zpg; lengths as in the scene, y is up\nmtllib {library}"
    );
    for (p, colour) in mesh.points.iter().zip(&coloured.points) {
        let [x, y, z] = p.map(|x| x as f32);
        let _ = write!(out, "v {x} {y} {z}");
        if smooth {
            // As many programs read them: linear, behind the coordinates.
            let [r, g, b] = colour.map(|c| (c * 1e4).round() / 1e4);
            let _ = write!(out, " {r} {g} {b}");
        }
        out.push('\n');
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
        let _ = writeln!(out, "usemtl material_{i}");
        for &t in &material.triangles {
            let [a, b, c] = mesh.triangles[t as usize].map(|i| i + 1);
            let _ = writeln!(out, "f {a} {b} {c}");
        }
    }
    (out, library)
}
