//! Triangles sorted by what they are made of.

use std::collections::HashMap;

use super::Model;
use super::soup::{cross, sub};
use crate::scene::{Optics, Rgb, Texture, Vec3};
use crate::trace::graph::Graph;

/// What some triangles have in common.
#[derive(Debug, Clone, PartialEq)]
pub struct Material {
    pub optics: Optics,
    /// Refractive index per channel.
    pub index: Rgb,
    /// `None` where the colour changes from point to point.
    pub colour: Option<Rgb>,
    /// Indices of triangles of the mesh.
    pub triangles: Vec<u32>,
}

/// A model with its colours.
#[derive(Debug)]
pub struct Coloured<'m> {
    pub model: &'m Model,
    /// Every triangle's, linear.
    pub faces: Vec<Rgb>,
    /// Every point's, the mean of the triangles around it where they differ.
    pub points: Vec<Rgb>,
    pub materials: Vec<Material>,
}

impl<'m> Coloured<'m> {
    pub fn new(model: &'m Model, graph: &Graph) -> Coloured<'m> {
        let mesh = &model.mesh;
        let mut faces = Vec::with_capacity(mesh.triangles.len());
        let mut points = vec![([0.0; 3], 0.0); mesh.points.len()];
        let mut materials: Vec<Material> = Vec::new();
        let mut numbers: HashMap<(u32, u32, Option<[u64; 3]>), usize> = HashMap::new();
        for (t, &label) in mesh.labels.iter().enumerate() {
            let skin = &model.skins[label as usize];
            let [a, b, c] = mesh.corners(t);
            let normal = cross(sub(b, a), sub(c, a));
            let plain = skin.plain_colour(graph);
            let middle: Vec3 = std::array::from_fn(|i| (a[i] + b[i] + c[i]) / 3.0);
            let colour = plain.unwrap_or_else(|| skin.colour(graph, middle, normal));
            faces.push(colour);
            let smooth = plain.is_none() && is_smooth(skin, graph);
            for (corner, at) in mesh.triangles[t].into_iter().zip([a, b, c]) {
                let here = if smooth {
                    skin.colour(graph, at, normal)
                } else {
                    colour
                };
                let (sum, n): &mut (Rgb, f64) = &mut points[corner as usize];
                for (s, x) in sum.iter_mut().zip(here) {
                    *s += x;
                }
                *n += 1.0;
            }
            let key = (
                skin.optics.unwrap_or(0),
                skin.index.unwrap_or(0),
                (!smooth).then(|| colour.map(f64::to_bits)),
            );
            let number = *numbers.entry(key).or_insert_with(|| {
                materials.push(Material {
                    optics: graph.optics[key.0 as usize],
                    index: graph.indices[key.1 as usize],
                    colour: (!smooth).then_some(colour),
                    triangles: Vec::new(),
                });
                materials.len() - 1
            });
            materials[number].triangles.push(t as u32);
        }
        Coloured {
            model,
            faces,
            points: points
                .into_iter()
                .map(|(sum, n)| sum.map(|x| if n > 0.0 { x / n } else { 1.0 }))
                .collect(),
            materials,
        }
    }
}

/// Whether the colour goes over from point to point, rather than jumping.
fn is_smooth(skin: &super::Skin, graph: &Graph) -> bool {
    match &skin.texture {
        Some(t) => matches!(graph.textures[t.texture as usize], Texture::Image { .. }),
        None => true,
    }
}

/// A linear colour as three bytes of sRGB.
pub fn srgb(colour: Rgb) -> [u8; 3] {
    colour.map(|x| {
        let x = x.clamp(0.0, 1.0);
        let encoded = if x <= 0.003_130_8 {
            12.92 * x
        } else {
            1.055 * x.powf(1.0 / 2.4) - 0.055
        };
        (255.0 * encoded).round() as u8
    })
}
