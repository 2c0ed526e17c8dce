//! Stanford PLY, binary, with colours of points and of faces.

use super::colour::srgb;
use super::material::Coloured;

/// The bytes of the file. Colours are sRGB; where normals or colours differ there are several points
/// in one place.
pub fn write(coloured: &Coloured, places: &[[f32; 3]]) -> Vec<u8> {
    let header = format!(
        "ply\nformat binary_little_endian 1.0\n\
         comment made by zpg; lengths as in the scene, y is up\n\
         element vertex {}\nproperty float x\nproperty float y\nproperty float z\n\
         property float nx\nproperty float ny\nproperty float nz\n\
         property uchar red\nproperty uchar green\nproperty uchar blue\n\
         element face {}\nproperty list uchar int vertex_indices\n\
         property uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n",
        coloured.vertices.len(),
        coloured.triangles.len()
    );
    let size = header.len() + 27 * coloured.vertices.len() + 16 * coloured.triangles.len();
    let mut out = Vec::with_capacity(size);
    out.extend_from_slice(header.as_bytes());
    for vertex in &coloured.vertices {
        let normal = vertex.normal.map(|x| x as f32);
        for x in places[vertex.point as usize].iter().chain(&normal) {
            out.extend_from_slice(&x.to_le_bytes());
        }
        out.extend_from_slice(&srgb(vertex.colour));
    }
    for (t, colour) in coloured.triangles.iter().zip(&coloured.faces) {
        out.push(3);
        for i in t {
            out.extend_from_slice(&i.to_le_bytes());
        }
        out.extend_from_slice(&srgb(*colour));
    }
    out
}
