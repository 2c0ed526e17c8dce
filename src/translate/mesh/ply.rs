//! Stanford PLY, binary, with colours of points and of faces.

use super::material::{Coloured, srgb};

/// The bytes of the file. Colours are sRGB; points shared by faces of several colours have the mean.
pub fn write(coloured: &Coloured) -> Vec<u8> {
    let mesh = &coloured.model.mesh;
    let header = format!(
        "ply\nformat binary_little_endian 1.0\n\
         comment made by zpg; lengths as in the scene, y is up\n\
         element vertex {}\nproperty float x\nproperty float y\nproperty float z\n\
         property uchar red\nproperty uchar green\nproperty uchar blue\n\
         element face {}\nproperty list uchar int vertex_indices\n\
         property uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n",
        mesh.points.len(),
        mesh.triangles.len()
    );
    let size = header.len() + 15 * mesh.points.len() + 16 * mesh.triangles.len();
    let mut out = Vec::with_capacity(size);
    out.extend_from_slice(header.as_bytes());
    for (p, colour) in mesh.points.iter().zip(&coloured.points) {
        for x in p {
            out.extend_from_slice(&(*x as f32).to_le_bytes());
        }
        out.extend_from_slice(&srgb(*colour));
    }
    for (t, colour) in mesh.triangles.iter().zip(&coloured.faces) {
        out.push(3);
        for i in t {
            out.extend_from_slice(&i.to_le_bytes());
        }
        out.extend_from_slice(&srgb(*colour));
    }
    out
}
