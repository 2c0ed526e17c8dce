//! Meshes for Mitsuba: one file for all triangles of one surface and one material, with the normals
//! of the true surface.

use std::collections::{BTreeMap, HashMap};

use super::bsdf::Colours;
use super::output::ShapeInfo;
use crate::geometry::array::{cross, length, sub};
use crate::scene::{Rgb, Texture, Vec3};
use crate::trace::graph::Graph;
use crate::translate::mesh::corners::{Corner, corners};
use crate::translate::mesh::picture::is_pictured;
use crate::translate::mesh::shape::DROPPED;
use crate::translate::mesh::{Mesh, MeshPart, Precision, SurfaceLabel};

/// The properties that triangles must have in common to be in one file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Key {
    shape: u32,
    object: u32,
    optics: u32,
    index: u32,
    around: Option<u32>,
    colours: Colours,
    colour: [u64; 3],
}

/// The triangles of each file.
#[derive(Default)]
pub(super) struct Collector {
    meshes: BTreeMap<Key, Mesh>,
}

/// A finished file.
pub(super) struct File {
    pub info: ShapeInfo,
    /// A skin that has the material of all triangles of the file.
    pub skin: u32,
    pub colours: Colours,
    /// The medium around the surface, as in [`MeshPart`].
    pub around: Option<u32>,
    pub bytes: Vec<u8>,
}

impl Collector {
    /// Adds the triangles of a piece that are seen. No edge is longer than both `grain` and its distance from the eye:
    /// single precision mistakes places on large triangles. Where the mesh has the colours of a texture, no edge is
    /// longer than `grain`. Where the render box cuts the piece, it is open.
    pub(super) fn add(
        &mut self,
        piece: &MeshPart,
        skins: &[SurfaceLabel],
        graph: &Graph,
        grain: f64,
        eye: Vec3,
    ) {
        let far = |p: Vec3| length(sub(p, eye)).max(grain);
        let mut mesh = piece.mesh.clone();
        mesh.drop_needles(Precision::Single, f64::INFINITY);
        let mut labels: Vec<u32> = mesh.labels.clone();
        labels.sort_unstable();
        labels.dedup();
        for label in labels {
            let Some(skin) = skins.get(label as usize).filter(|_| label != DROPPED) else {
                continue;
            };
            if skin.primitive.is_none() {
                continue;
            }
            let mut part = mesh.only(|l| l == label);
            part.refine(|_| true, far);
            if skin.plain_colour(graph).is_none() && !is_pictured(skin, graph) {
                part.refine(|_| true, |_| grain);
            }
            part.drop_needles(Precision::Single, f64::INFINITY);
            self.meshes
                .entry(key(skin, piece.around, graph))
                .or_default()
                .append(&part);
        }
    }

    pub(super) fn finish(self, skins: &[SurfaceLabel], graph: &Graph) -> Vec<File> {
        let file = |(key, mesh): (Key, Mesh)| File {
            info: ShapeInfo {
                shape: key.shape,
                object: key.object,
                exact: false,
            },
            skin: mesh.labels.first().copied().unwrap_or(0),
            colours: key.colours,
            around: key.around,
            bytes: bytes(&mesh, key.colours, skins, graph),
        };
        self.meshes.into_iter().map(file).collect()
    }
}

fn key(skin: &SurfaceLabel, around: Option<u32>, graph: &Graph) -> Key {
    let plain = skin.plain_colour(graph);
    let colours = match (&plain, &skin.texture) {
        (Some(_), _) => Colours::Plain,
        (None, Some(t)) if is_pictured(skin, graph) => Colours::Pictured(t.texture),
        (None, Some(t)) if !matches!(graph.textures[t.texture as usize], Texture::Image { .. }) => {
            Colours::OfFaces
        }
        _ => Colours::OfPoints,
    };
    Key {
        shape: skin.shape,
        object: skin.object(),
        optics: skin.optics.unwrap_or(0),
        index: skin.index.unwrap_or(0),
        around,
        colours,
        colour: plain.map_or([0; 3], |c| c.map(f64::to_bits)),
    }
}

/// A point of a file.
struct Point {
    place: Vec3,
    corner: Corner,
    colour: Rgb,
}

fn bytes(mesh: &Mesh, colours: Colours, skins: &[SurfaceLabel], graph: &Graph) -> Vec<u8> {
    let pictured = matches!(colours, Colours::Pictured(_));
    let corners = corners(mesh, skins, graph, |_| pictured);
    // A point has one normal: where faces meet at an edge there are several points.
    let mut numbers: HashMap<(u32, [i64; 5]), u32> = HashMap::new();
    let mut points: Vec<Point> = Vec::new();
    let mut triangles: Vec<([u32; 3], Rgb)> = Vec::with_capacity(mesh.triangles.len());
    for (t, of_points) in mesh.triangles.iter().enumerate() {
        let skin = &skins[mesh.labels[t] as usize];
        let [a, b, c] = mesh.corners(t);
        let n = cross(sub(b, a), sub(c, a));
        let mut numbered = [0; 3];
        for (k, place) in [a, b, c].into_iter().enumerate() {
            let corner = corners[t][k];
            let [x, y, z] = corner.normal.map(|x| (x * 128.0).round() as i64);
            let [u, v] = corner.uv.map(|x| (x * 4096.0).round() as i64);
            let key = (of_points[k], [x, y, z, u, v]);
            numbered[k] = *numbers.entry(key).or_insert_with(|| {
                let colour = match colours {
                    Colours::OfPoints => skin.colour(graph, place, n),
                    _ => [0.0; 3],
                };
                points.push(Point {
                    place,
                    corner,
                    colour,
                });
                points.len() as u32 - 1
            });
        }
        let middle: Vec3 = std::array::from_fn(|i| (a[i] + b[i] + c[i]) / 3.0);
        let colour = match colours {
            Colours::OfFaces => skin.colour(graph, middle, n),
            _ => [0.0; 3],
        };
        triangles.push((numbered, colour));
    }
    write(&points, &triangles, colours)
}

fn write(points: &[Point], triangles: &[([u32; 3], Rgb)], colours: Colours) -> Vec<u8> {
    let three = |prefix: &str, names: [&str; 3]| {
        names
            .map(|n| format!("property float {prefix}{n}\n"))
            .concat()
    };
    let mut header = format!(
        "ply\nformat binary_little_endian 1.0\nelement vertex {}\n{}{}",
        points.len(),
        three("", ["x", "y", "z"]),
        three("n", ["x", "y", "z"]),
    );
    match colours {
        Colours::OfPoints => header += &three("", ["r", "g", "b"]),
        Colours::Pictured(_) => header += "property float u\nproperty float v\n",
        _ => {}
    }
    header += &format!(
        "element face {}\nproperty list uchar int vertex_indices\n",
        triangles.len()
    );
    if colours == Colours::OfFaces {
        header += &three("", ["r", "g", "b"]);
    }
    header += "end_header\n";
    let mut out = header.into_bytes();
    let put = |out: &mut Vec<u8>, v: &[f64]| {
        for x in v {
            out.extend_from_slice(&(*x as f32).to_le_bytes());
        }
    };
    for p in points {
        put(&mut out, &p.place);
        put(&mut out, &p.corner.normal);
        match colours {
            Colours::OfPoints => put(&mut out, &p.colour),
            Colours::Pictured(_) => put(&mut out, &p.corner.uv),
            _ => {}
        }
    }
    for (t, c) in triangles {
        out.push(3);
        for i in t {
            out.extend_from_slice(&i.to_le_bytes());
        }
        if colours == Colours::OfFaces {
            put(&mut out, c);
        }
    }
    out
}
