//! Triangles sorted by the objects that they belong to, and by what they are made of.

use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::ops::Range;

use super::corners::corners;
use super::model::Model;
use super::picture::Pictures;
use super::surface_label::SurfaceLabel;
use crate::geometry::array::{cross, sub};
use crate::scene::{DEFAULT_COLOUR, Optics, Rgb, Texture, Vec3};
use crate::trace::graph::Graph;

/// The properties that some triangles have in common.
#[derive(Debug, Clone, PartialEq)]
pub struct Material {
    pub optics: Optics,
    /// Refractive index per channel.
    pub index: Rgb,
    /// `None` where the colour changes from point to point.
    pub colour: Option<Rgb>,
    /// The number of the picture on the surface, if there is one; then `colour` is white.
    pub picture: Option<u32>,
    /// Whether the material is on a surface without an inside, which is seen from both sides.
    pub surface: bool,
}

/// Triangles that have their properties from one entity.
#[derive(Debug, Clone, PartialEq)]
pub struct Object {
    /// The ID of the entity; 0 if there is none, or if the scene has too many objects.
    pub id: u32,
    /// The indices of the object's vertices, which no other object uses.
    pub vertices: Range<u32>,
    /// Indices of triangles of the mesh, by the number of their material.
    pub triangles: BTreeMap<usize, Vec<u32>>,
}

impl Object {
    /// The name of the object in a file.
    pub fn name(&self) -> String {
        match self.id {
            0 => "Scene".to_owned(),
            id => format!("Object_{id}"),
        }
    }
}

/// The most objects that are kept apart. In a scene with more, all triangles are one object, since programs take long
/// to read very many.
const MOST_OBJECTS: usize = 1000;

/// A vertex as files have it. Where normals, colours or surface coordinates differ, several vertices are in one
/// place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Vertex {
    /// Index of the mesh's point.
    pub point: u32,
    pub normal: Vec3,
    /// The linear colour.
    pub colour: Rgb,
    /// Texture coordinates, scaled as the picture needs them.
    pub uv: [f64; 2],
}

/// A model with its colours.
#[derive(Debug)]
pub struct Coloured<'m> {
    pub model: &'m Model,
    pub vertices: Vec<Vertex>,
    /// Indices into `vertices`, beside the mesh's triangles.
    pub triangles: Vec<[u32; 3]>,
    /// Every triangle's colour, linear.
    pub faces: Vec<Rgb>,
    pub materials: Vec<Material>,
    /// The objects in the order of their IDs.
    pub objects: Vec<Object>,
    pub pictures: Pictures,
}

impl<'m> Coloured<'m> {
    /// Gives a model's triangles vertices, colours and materials. With `pictured`, textures become pictures where
    /// that is possible.
    pub fn new(model: &'m Model, graph: &Graph, pictured: bool) -> Coloured<'m> {
        let mesh = &model.mesh;
        let mut pictures = Pictures::default();
        let of_skins: Vec<Option<u32>> = (model.skins.iter())
            .map(|skin| pictured.then(|| pictures.of(skin, graph)).flatten())
            .collect();
        let corners = corners(mesh, &model.skins, graph, |label| {
            of_skins[label as usize].is_some()
        });
        let mut out = Coloured {
            model,
            vertices: Vec::with_capacity(mesh.points.len()),
            triangles: vec![[0; 3]; mesh.triangles.len()],
            faces: vec![DEFAULT_COLOUR; mesh.triangles.len()],
            materials: Vec::new(),
            objects: Vec::new(),
            pictures,
        };
        let mut numbers: HashMap<MaterialKey, usize> = HashMap::new();
        let mut known: HashMap<VertexKey, u32> = HashMap::new();
        for (t, id) in by_object(model) {
            if out.objects.last().is_none_or(|o| o.id != id) {
                known.clear();
                let start = out.vertices.len() as u32;
                out.objects.push(Object {
                    id,
                    vertices: start..start,
                    triangles: BTreeMap::new(),
                });
            }
            let label = mesh.labels[t];
            let skin = &model.skins[label as usize];
            let [a, b, c] = mesh.corners(t);
            let normal = cross(sub(b, a), sub(c, a));
            let picture = of_skins[label as usize];
            let plain = match picture {
                Some(_) => Some([1.0; 3]),
                None => skin.plain_colour(graph),
            };
            let middle: Vec3 = std::array::from_fn(|i| (a[i] + b[i] + c[i]) / 3.0);
            let colour = plain.unwrap_or_else(|| skin.colour(graph, middle, normal));
            out.faces[t] = colour;
            let smooth = plain.is_none() && is_smooth(skin, graph);
            let scale = picture.map_or([1.0; 2], |p| out.pictures.all[&p].scale);
            let mut triangle = [0; 3];
            for k in 0..3 {
                let corner = corners[t][k];
                let vertex = Vertex {
                    point: mesh.triangles[t][k],
                    normal: corner.normal,
                    colour: match smooth {
                        true => skin.colour(graph, [a, b, c][k], normal),
                        false => colour,
                    },
                    uv: [corner.uv[0] * scale[0], corner.uv[1] * scale[1]],
                };
                triangle[k] = *known.entry(vertex.key()).or_insert_with(|| {
                    out.vertices.push(vertex);
                    out.vertices.len() as u32 - 1
                });
            }
            out.triangles[t] = triangle;
            let surface = t >= model.solid;
            let key = (
                skin.optics.unwrap_or(0),
                skin.index.unwrap_or(0),
                (!smooth).then(|| colour.map(f64::to_bits)),
                picture,
                surface,
            );
            let number = *numbers.entry(key).or_insert_with(|| {
                out.materials.push(Material {
                    optics: graph.optics[key.0 as usize],
                    index: graph.indices[key.1 as usize],
                    colour: (!smooth).then_some(colour),
                    picture,
                    surface,
                });
                out.materials.len() - 1
            });
            if let Some(object) = out.objects.last_mut() {
                object.vertices.end = out.vertices.len() as u32;
                object.triangles.entry(number).or_default().push(t as u32);
            }
        }
        out
    }
}

/// The indices of the mesh's triangles with the IDs of their objects, sorted by ID.
fn by_object(model: &Model) -> Vec<(usize, u32)> {
    let object = |label: &u32| model.skins[*label as usize].object();
    let labels = &model.mesh.labels;
    let different: BTreeSet<u32> = labels.iter().map(object).collect();
    let of = |label| match different.len() {
        0..=MOST_OBJECTS => object(label),
        _ => 0,
    };
    let mut out: Vec<(usize, u32)> = labels.iter().map(of).enumerate().collect();
    out.sort_by_key(|(_, id)| *id);
    out
}

/// The properties that tell materials apart: optics, refractive index, colour, picture, and whether it is a surface.
type MaterialKey = (u32, u32, Option<[u64; 3]>, Option<u32>, bool);
type VertexKey = (u32, [i64; 3], [u64; 3], [i64; 2]);

impl Vertex {
    /// The key of a vertex, which is the same for vertices that differ by rounding.
    fn key(&self) -> VertexKey {
        let rounded = |x: f64, steps: f64| (x * steps).round() as i64;
        (
            self.point,
            self.normal.map(|x| rounded(x, 128.0)),
            self.colour.map(f64::to_bits),
            self.uv.map(|x| rounded(x, 4096.0)),
        )
    }
}

/// Whether the colour changes gradually from point to point, rather than in jumps.
fn is_smooth(skin: &SurfaceLabel, graph: &Graph) -> bool {
    match &skin.texture {
        Some(t) => matches!(graph.textures[t.texture as usize], Texture::Image { .. }),
        None => true,
    }
}
