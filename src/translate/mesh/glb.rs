//! glTF 2.0, binary.

use serde_json::{Value, json};

use super::material::{Coloured, Material};
use crate::scene::DEFAULT_COLOUR;

const FLOAT: u32 = 5126;
const UNSIGNED_INT: u32 = 5125;
/// The same points serve all materials: a mesh that is closed stays so.
const POINTS: usize = 0;
const COLOURS: usize = 1;

/// The bytes of the file.
pub fn write(coloured: &Coloured) -> Vec<u8> {
    let mesh = &coloured.model.mesh;
    if mesh.is_empty() {
        return container(&json!({ "asset": asset() }), &[]);
    }
    let mut binary: Vec<u8> = Vec::new();
    let (mut low, mut high) = ([f32::INFINITY; 3], [f32::NEG_INFINITY; 3]);
    for p in &mesh.points {
        for (i, x) in p.iter().enumerate() {
            let x = *x as f32;
            (low[i], high[i]) = (low[i].min(x), high[i].max(x));
            binary.extend_from_slice(&x.to_le_bytes());
        }
    }
    let n = mesh.points.len();
    let mut views = vec![json!({
        "buffer": 0, "byteOffset": 0, "byteLength": 12 * n, "target": 34962,
    })];
    let mut accessors = vec![json!({
        "bufferView": 0, "componentType": FLOAT, "count": n, "type": "VEC3",
        "min": low, "max": high,
    })];
    let smooth = coloured.materials.iter().any(|m| m.colour.is_none());
    if smooth {
        let start = binary.len();
        for colour in &coloured.points {
            for x in colour {
                binary.extend_from_slice(&(x.clamp(0.0, 1.0) as f32).to_le_bytes());
            }
        }
        views.push(json!({
            "buffer": 0, "byteOffset": start, "byteLength": 12 * n, "target": 34962,
        }));
        accessors.push(json!({
            "bufferView": 1, "componentType": FLOAT, "count": n, "type": "VEC3",
        }));
    }
    let start = binary.len();
    let view = views.len();
    let (mut primitives, mut materials) = (Vec::new(), Vec::new());
    let mut extensions = Extensions::default();
    for material in &coloured.materials {
        let offset = binary.len() - start;
        for &t in &material.triangles {
            for i in mesh.triangles[t as usize] {
                binary.extend_from_slice(&i.to_le_bytes());
            }
        }
        let mut attributes = json!({ "POSITION": POINTS });
        if material.colour.is_none() {
            attributes["COLOR_0"] = json!(COLOURS);
        }
        primitives.push(json!({
            "attributes": attributes,
            "indices": accessors.len(),
            "material": materials.len(),
        }));
        accessors.push(json!({
            "bufferView": view, "byteOffset": offset, "componentType": UNSIGNED_INT,
            "count": 3 * material.triangles.len(), "type": "SCALAR",
        }));
        let of_surface =
            material.triangles.first().map(|&t| t as usize) >= Some(coloured.model.solid);
        materials.push(appearance(material, of_surface, &mut extensions));
    }
    views.push(json!({
        "buffer": 0, "byteOffset": start, "byteLength": binary.len() - start, "target": 34963,
    }));
    let mut file = json!({
        "asset": asset(),
        "scene": 0,
        "scenes": [{ "nodes": [0] }],
        "nodes": [{ "mesh": 0 }],
        "meshes": [{ "primitives": primitives }],
        "materials": materials,
        "accessors": accessors,
        "bufferViews": views,
        "buffers": [{ "byteLength": binary.len() }],
    });
    let used = extensions.names();
    if !used.is_empty() {
        file["extensionsUsed"] = json!(used);
    }
    container(&file, &binary)
}

fn asset() -> Value {
    json!({ "version": "2.0", "generator": "zpg" })
}

/// Which extensions of materials are used.
#[derive(Default)]
struct Extensions {
    transmission: bool,
}

impl Extensions {
    fn names(&self) -> Vec<&'static str> {
        if self.transmission {
            vec!["KHR_materials_ior", "KHR_materials_transmission"]
        } else {
            Vec::new()
        }
    }
}

/// A mirror is a smooth metal, glass is transmission; what is between is mixed by their shares.
fn appearance(material: &Material, of_surface: bool, extensions: &mut Extensions) -> Value {
    let o = &material.optics;
    let mean = |k: [f64; 3]| k.iter().sum::<f64>() / 3.0;
    let (kd, ks, kt) = (mean(o.kd), mean(o.ks), mean(o.kt));
    let all = kd + ks + kt;
    let share = |k: f64| if all > 0.0 { k / all } else { 0.0 };
    let colour = material.colour.unwrap_or(DEFAULT_COLOUR);
    let base: [f64; 3] = std::array::from_fn(|i| {
        let seen = colour[i] * o.kd[i] + o.ks[i] + o.kt[i];
        seen.clamp(0.0, 1.0)
    });
    let mut out = json!({
        "pbrMetallicRoughness": {
            "baseColorFactor": [base[0], base[1], base[2], 1.0],
            "metallicFactor": share(ks),
            "roughnessFactor": 1.0 - share(ks + kt),
        },
        "doubleSided": of_surface,
    });
    if kt > 0.0 {
        extensions.transmission = true;
        // The format knows no index below 1.
        let index = mean(material.index).max(1.0);
        out["extensions"] = json!({
            "KHR_materials_transmission": { "transmissionFactor": share(kt) },
            "KHR_materials_ior": { "ior": index },
        });
    }
    out
}

/// A header of twelve bytes, then the two chunks, each padded to four.
fn container(file: &Value, binary: &[u8]) -> Vec<u8> {
    let mut text = file.to_string().into_bytes();
    text.resize(text.len().next_multiple_of(4), b' ');
    let padded = binary.len().next_multiple_of(4);
    let mut length = 12 + 8 + text.len();
    if !binary.is_empty() {
        length += 8 + padded;
    }
    let mut out = Vec::with_capacity(length);
    let word = |out: &mut Vec<u8>, x: usize| out.extend_from_slice(&(x as u32).to_le_bytes());
    out.extend_from_slice(b"glTF");
    word(&mut out, 2);
    word(&mut out, length);
    word(&mut out, text.len());
    out.extend_from_slice(b"JSON");
    out.extend_from_slice(&text);
    if !binary.is_empty() {
        word(&mut out, padded);
        out.extend_from_slice(b"BIN\0");
        out.extend_from_slice(binary);
        out.resize(length, 0);
    }
    out
}
