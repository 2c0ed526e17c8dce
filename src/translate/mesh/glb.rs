//! glTF 2.0, binary.

use std::collections::BTreeMap;
use std::ops::Range;

use serde_json::{Value, json};

use super::glb_scenery::{LIGHTS, Scenery};
use super::material::{Coloured, Material, Vertex};
use super::picture::Picture;
use crate::scene::{DEFAULT_COLOUR, Vec3};
use crate::translate::names::Names;

const FLOAT: u32 = 5126;
const UNSIGNED_INT: u32 = 5125;
const ELEMENTS: u32 = 34963;
const ATTRIBUTES: u32 = 34962;
const NEAREST: u32 = 9728;
const LINEAR: u32 = 9729;
const REPEAT: u32 = 10497;

/// The bytes of the file. It has a node for each object, named after the scene's object, and one for each camera and
/// light.
pub fn write(coloured: &Coloured, points: &[[f32; 3]], names: &Names, scenery: Scenery) -> Vec<u8> {
    let mesh = &coloured.model.mesh;
    let mut out = json!({ "asset": asset() });
    let mut extensions = Extensions {
        lights: !scenery.lights.is_empty(),
        ..Extensions::default()
    };
    let (mut nodes, mut binary) = (Vec::new(), Vec::new());
    if !mesh.is_empty() {
        (nodes, binary) = meshes(coloured, points, names, &mut extensions, &mut out);
    }
    nodes.extend(scenery.nodes);
    if !nodes.is_empty() {
        let all: Vec<usize> = (0..nodes.len()).collect();
        out["scene"] = json!(0);
        out["scenes"] = json!([{ "nodes": all }]);
        out["nodes"] = json!(nodes);
    }
    // The format does not allow empty lists.
    if !scenery.cameras.is_empty() {
        out["cameras"] = json!(scenery.cameras);
    }
    if !scenery.lights.is_empty() {
        out["extensions"] = json!({ LIGHTS: { "lights": scenery.lights } });
    }
    let used = extensions.names();
    if !used.is_empty() {
        out["extensionsUsed"] = json!(used);
    }
    container(&out, &binary)
}

/// The nodes of the objects, and the binary chunk with the numbers of their meshes. All lists but the nodes go into
/// `out`.
fn meshes(
    coloured: &Coloured,
    points: &[[f32; 3]],
    names: &Names,
    extensions: &mut Extensions,
    out: &mut Value,
) -> (Vec<Value>, Vec<u8>) {
    let mut file = Parts::default();
    let vertices = &coloured.vertices;
    let place = |v: &Vertex| points[v.point as usize];
    let places = file.attribute(vertices.iter().map(|v| place(v).map(f64::from)));
    let normals = file.attribute(vertices.iter().map(|v| rounded_unit(v.normal)));
    let materials = &coloured.materials;
    let colours = materials.iter().any(|m| m.colour.is_none()).then(|| {
        let colours = vertices.iter().map(|v| v.colour.map(|x| x.clamp(0.0, 1.0)));
        file.attribute(colours)
    });
    let pictured = materials.iter().any(|m| m.picture.is_some()).then(|| {
        // In glTF the second texture coordinate runs downwards.
        file.attribute(vertices.iter().map(|v| [v.uv[0], -v.uv[1]]))
    });
    let mut numbers: BTreeMap<u32, usize> = BTreeMap::new();
    for (number, picture) in &coloured.pictures.all {
        numbers.insert(*number, file.picture(picture));
    }
    let mut describe = |material: &Material| {
        let mut look = appearance(material, extensions);
        if let Some(texture) = material.picture.and_then(|p| numbers.get(&p)) {
            look["pbrMetallicRoughness"]["baseColorTexture"] = json!({ "index": texture });
        }
        look
    };
    let described: Vec<Value> = materials.iter().map(&mut describe).collect();
    let view = file.views.len();
    let start = file.binary.len();
    let (mut nodes, mut meshes) = (Vec::new(), Vec::new());
    for object in &coloured.objects {
        let of = &object.vertices;
        let places = file.part(&places, of);
        let (mut low, mut high) = ([f32::INFINITY; 3], [f32::NEG_INFINITY; 3]);
        for v in &vertices[of.start as usize..of.end as usize] {
            for (i, x) in place(v).into_iter().enumerate() {
                (low[i], high[i]) = (low[i].min(x), high[i].max(x));
            }
        }
        file.accessors[places]["min"] = json!(low);
        file.accessors[places]["max"] = json!(high);
        let normals = file.part(&normals, of);
        let uses = |quality: fn(&Material) -> bool| {
            let mut all = object.triangles.keys();
            all.any(|m| quality(&materials[*m]))
        };
        let colours = colours.as_ref().filter(|_| uses(|m| m.colour.is_none()));
        let colours = colours.map(|c| file.part(c, of));
        let pictured = pictured.as_ref().filter(|_| uses(|m| m.picture.is_some()));
        let pictured = pictured.map(|p| file.part(p, of));
        let mut primitives = Vec::new();
        for (number, triangles) in &object.triangles {
            let material = &materials[*number];
            let offset = file.binary.len() - start;
            for &t in triangles {
                for i in coloured.triangles[t as usize] {
                    let i = i - of.start;
                    file.binary.extend_from_slice(&i.to_le_bytes());
                }
            }
            let mut attributes = json!({ "POSITION": places, "NORMAL": normals });
            if let (None, Some(colours)) = (material.colour, colours) {
                attributes["COLOR_0"] = json!(colours);
            }
            if let (Some(_), Some(pictured)) = (material.picture, pictured) {
                attributes["TEXCOORD_0"] = json!(pictured);
            }
            primitives.push(json!({
                "attributes": attributes,
                "indices": file.accessors.len(),
                "material": number,
            }));
            file.accessors.push(json!({
                "bufferView": view, "byteOffset": offset, "componentType": UNSIGNED_INT,
                "count": 3 * triangles.len(), "type": "SCALAR",
            }));
        }
        nodes.push(json!({ "name": object.name(), "mesh": meshes.len() }));
        let mut mesh = json!({ "primitives": primitives });
        if let Some(comment) = names.comment(object.id) {
            mesh["name"] = json!(comment);
        }
        meshes.push(mesh);
    }
    file.views.push(json!({
        "buffer": 0, "byteOffset": start, "byteLength": file.binary.len() - start, "target": ELEMENTS,
    }));
    out["meshes"] = json!(meshes);
    out["materials"] = json!(described);
    out["accessors"] = json!(file.accessors);
    out["bufferViews"] = json!(file.views);
    out["buffers"] = json!([{ "byteLength": file.binary.len() }]);
    if !file.textures.is_empty() {
        out["textures"] = json!(file.textures);
        out["images"] = json!(file.images);
        out["samplers"] = json!([
            { "magFilter": LINEAR, "minFilter": LINEAR, "wrapS": REPEAT, "wrapT": REPEAT },
            { "magFilter": NEAREST, "minFilter": NEAREST, "wrapS": REPEAT, "wrapT": REPEAT },
        ]);
    }
    (nodes, file.binary)
}

/// The binary chunk of a file and the lists that describe it, while they are written.
#[derive(Default)]
struct Parts {
    binary: Vec<u8>,
    views: Vec<Value>,
    accessors: Vec<Value>,
    images: Vec<Value>,
    textures: Vec<Value>,
}

/// An attribute of all vertices: the index of its buffer view, and how many numbers a vertex has.
struct Attribute {
    view: usize,
    width: usize,
}

impl Parts {
    fn attribute<const N: usize>(&mut self, numbers: impl Iterator<Item = [f64; N]>) -> Attribute {
        let start = self.binary.len();
        for x in numbers.flatten() {
            self.binary.extend_from_slice(&(x as f32).to_le_bytes());
        }
        self.views.push(json!({
            "buffer": 0, "byteOffset": start, "byteLength": self.binary.len() - start,
            "byteStride": 4 * N, "target": ATTRIBUTES,
        }));
        Attribute {
            view: self.views.len() - 1,
            width: N,
        }
    }

    /// Adds an accessor for the attribute of some vertices, and returns its index.
    fn part(&mut self, attribute: &Attribute, of: &Range<u32>) -> usize {
        let Attribute { view, width } = attribute;
        self.accessors.push(json!({
            "bufferView": view, "byteOffset": 4 * width * of.start as usize, "componentType": FLOAT,
            "count": of.len(), "type": format!("VEC{width}"),
        }));
        self.accessors.len() - 1
    }

    /// Adds a picture, and returns the index of its texture.
    fn picture(&mut self, picture: &Picture) -> usize {
        let start = self.binary.len();
        self.binary.extend_from_slice(&picture.png);
        self.images
            .push(json!({ "bufferView": self.views.len(), "mimeType": "image/png" }));
        self.views
            .push(json!({ "buffer": 0, "byteOffset": start, "byteLength": picture.png.len() }));
        // The next data has to begin at a multiple of four.
        self.binary.resize(self.binary.len().next_multiple_of(4), 0);
        self.textures.push(
            json!({ "source": self.images.len() - 1, "sampler": usize::from(picture.cells) }),
        );
        self.textures.len() - 1
    }
}

/// The normal, or a vector upwards if the normal has length 0, which the format does not allow.
fn rounded_unit(n: Vec3) -> Vec3 {
    if n == [0.0; 3] { [0.0, 1.0, 0.0] } else { n }
}

fn asset() -> Value {
    json!({ "version": "2.0", "generator": "zpg" })
}

/// The extensions that the file uses.
#[derive(Default)]
struct Extensions {
    transmission: bool,
    lights: bool,
}

impl Extensions {
    fn names(&self) -> Vec<&'static str> {
        let mut names = Vec::new();
        if self.lights {
            names.push(LIGHTS);
        }
        if self.transmission {
            names.extend(["KHR_materials_ior", "KHR_materials_transmission"]);
        }
        names
    }
}

/// A material in glTF: a mirror is a smooth metal, glass is transmission, and a mixture is weighted by its shares.
/// Notes in `extensions` what the material uses.
fn appearance(material: &Material, extensions: &mut Extensions) -> Value {
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
        "doubleSided": material.surface,
    });
    if kt > 0.0 {
        extensions.transmission = true;
        // The format does not allow a refractive index below 1.
        let index = mean(material.index).max(1.0);
        out["extensions"] = json!({
            "KHR_materials_transmission": { "transmissionFactor": share(kt) },
            "KHR_materials_ior": { "ior": index },
        });
    }
    out
}

/// The bytes of the file: a header of twelve bytes, then the text and the binary chunk, each padded to a multiple of
/// four.
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
