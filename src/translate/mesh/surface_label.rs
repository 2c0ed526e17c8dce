//! Labels of triangles: the object that their surface belongs to, and its properties.

use crate::geometry::Matrix;
use crate::geometry::array::{dot, length};
use crate::geometry::line::Line;
use crate::scene::{DEFAULT_COLOUR, Rgb, Texture, Vec3};
use crate::trace::graph::{Coat, Graph, Part};
use crate::trace::shapes::{Located, Primitive, Roots};

/// The least cosines of the angle between a triangle and the face of the true surface that it stands for: the first
/// is for most triangles; the second, tried if no face meets the first, is for triangles that are as large as they
/// may be.
const SAME_FACING_COSINES: [f64; 2] = [0.9, 0.5];

/// The most faces near a point that are looked at.
const MAX_FACES_EXAMINED: usize = 8;

/// The texture of a surface. `matrix` maps from the coordinates in which the texture is defined to those in which the
/// mesh stands now.
#[derive(Debug, Clone, PartialEq)]
pub struct Texturing {
    pub texture: u32,
    pub matrix: Matrix,
}

/// The properties of the triangles of one label.
#[derive(Debug, Clone, PartialEq)]
pub struct SurfaceLabel {
    /// Index into [`Graph::primitives`]; `None` for a cap, where the region ends.
    pub primitive: Option<u32>,
    /// The map from the shape's coordinates to the label's present coordinates.
    pub matrix: Box<Matrix>,
    pub texture: Option<Box<Texturing>>,
    /// Index into [`Graph::optics`], if the surface was given optics.
    pub optics: Option<u32>,
    /// Index into [`Graph::indices`], if the surface was given a refractive index.
    pub index: Option<u32>,
    /// The ID of the entity whose record made the surface; 0 where none did.
    pub shape: u32,
    /// The ID of the outermost entity that was given properties; 0 where there is none.
    pub owner: u32,
    /// Whether a tool made the face: it does not show the tool's own colours.
    pub cut: bool,
}

impl SurfaceLabel {
    /// The label for the surface of a part that is a shape, placed by `m`.
    pub fn new(part: &Part, primitive: u32, m: &Matrix, graph: &Graph) -> SurfaceLabel {
        let coat = &graph.paints[part.paint as usize];
        SurfaceLabel {
            primitive: Some(primitive),
            matrix: Box::new(*m),
            texture: texturing(coat, graph),
            optics: coat.optics,
            index: coat.index,
            shape: part.shape,
            owner: part.owner,
            cut: false,
        }
    }

    /// The label for the faces where the region cuts a solid: they look like its inside.
    pub fn cap(inside: Option<&SurfaceLabel>) -> SurfaceLabel {
        let like = inside.cloned().unwrap_or(SurfaceLabel {
            primitive: None,
            matrix: Box::new(Matrix::IDENTITY),
            texture: None,
            optics: None,
            index: None,
            shape: 0,
            owner: 0,
            cut: true,
        });
        SurfaceLabel {
            primitive: None,
            shape: 0,
            cut: true,
            ..like
        }
    }

    /// The label in the object above, where a part places it by `m` and `over` is painted over the surface.
    pub fn placed(mut self, m: &Matrix, over: &Coat, graph: &Graph, owner: u32) -> SurfaceLabel {
        *self.matrix = m.after(&self.matrix);
        self.texture = texturing(over, graph).or_else(|| {
            let mut texture = self.texture.take()?;
            texture.matrix = m.after(&texture.matrix);
            Some(texture)
        });
        self.optics = over.optics.or(self.optics);
        self.index = over.index.or(self.index);
        if owner != 0 {
            self.owner = owner;
        }
        self
    }

    /// The label of a tool's face on a solid that it cuts: the face has the properties of `inside`.
    pub fn cut_into(&self, inside: &SurfaceLabel) -> SurfaceLabel {
        SurfaceLabel {
            primitive: self.primitive,
            matrix: self.matrix.clone(),
            shape: self.shape,
            cut: true,
            owner: inside.object(),
            ..inside.clone()
        }
    }

    /// The bits of the matrix, equal for surfaces of one shape in one place.
    pub fn place(&self) -> [u64; 16] {
        let mut place = [0; 16];
        for (bits, x) in place.iter_mut().zip(self.matrix.0.iter().flatten()) {
            // Adding zero turns −0 into 0.
            *bits = (x + 0.0).to_bits();
        }
        place
    }

    /// The ID of the entity whose properties apply.
    pub fn object(&self) -> u32 {
        if self.owner != 0 {
            self.owner
        } else {
            self.shape
        }
    }

    /// The colour if it is the same everywhere; `None` if it varies.
    pub fn plain_colour(&self, graph: &Graph) -> Option<Rgb> {
        match &self.texture {
            Some(t) => match &graph.textures[t.texture as usize] {
                Texture::Colour(c) => Some(*c),
                Texture::Checkerboard { .. } | Texture::Image { .. }
                    if self.primitive.is_none() =>
                {
                    Some(DEFAULT_COLOUR)
                }
                _ => None,
            },
            None => match self.primitive {
                Some(p) if !self.cut && has_colours(graph, p) => None,
                _ => Some(DEFAULT_COLOUR),
            },
        }
    }

    /// The colour of the true surface at or near `point`, looked for along `normal`.
    pub fn colour(&self, graph: &Graph, point: Vec3, normal: Vec3) -> Rgb {
        if let Some(colour) = self.plain_colour(graph) {
            return colour;
        }
        let texture = self.texture.as_ref();
        let of = texture.map(|t| &graph.textures[t.texture as usize]);
        if let (Some(t), Some(Texture::Solid { colours, size })) = (texture, of) {
            let back = t.matrix.inverse().unwrap_or(Matrix::IDENTITY);
            let p = back.point(point).map(|x| x / size);
            return Texture::cell_colour(colours, &p);
        }
        let Some((primitive, located, face)) = self.locate(graph, point, normal) else {
            return DEFAULT_COLOUR;
        };
        let shape = graph.primitives[primitive as usize].shape();
        let p = located.point;
        match of {
            Some(Texture::Checkerboard { n, m, colours }) => {
                let [u, v] = shape.uv(p, face);
                Texture::cell_colour(colours, &[u * f64::from(*n), v * f64::from(*m)])
            }
            Some(Texture::Image { .. }) => {
                let bitmap = texture.and_then(|t| graph.bitmaps[t.texture as usize].as_ref());
                bitmap.map_or(DEFAULT_COLOUR, |b| b.colour(shape.uv(p, face)))
            }
            _ => shape.colour(p, face).unwrap_or(DEFAULT_COLOUR),
        }
    }

    /// The surface coordinates of the true surface at or near `point`, looked for along `normal`; `None` if it is not
    /// met.
    pub fn uv(&self, graph: &Graph, point: Vec3, normal: Vec3) -> Option<[f64; 2]> {
        let (primitive, located, face) = self.locate(graph, point, normal)?;
        let shape = graph.primitives[primitive as usize].shape();
        Some(shape.uv(located.point, face)).filter(|uv| uv.iter().all(|x| x.is_finite()))
    }

    /// For each of the two surface coordinates, whether it goes round the surface and jumps from 1 to 0.
    pub fn turns(&self, graph: &Graph) -> [bool; 2] {
        match self.primitive.map(|p| &graph.primitives[p as usize]) {
            Some(Primitive::Torus(_)) => [true, true],
            Some(
                Primitive::Revolution(_)
                | Primitive::Sphere(_)
                | Primitive::Ellipsoid(_)
                | Primitive::GeodesicSphere(_)
                | Primitive::Quadric(_)
                | Primitive::Cone(_),
            ) => [true, false],
            _ => [false, false],
        }
    }

    /// The unit normal for shading at or near `point`, on the side of `normal`. The true surface is looked for along
    /// `normal`; `None` if it is not met.
    pub fn shading_normal(&self, graph: &Graph, point: Vec3, normal: Vec3) -> Option<Vec3> {
        let back = self.matrix.inverse()?;
        let (primitive, located, face) = self.locate(graph, point, normal)?;
        let shape = graph.primitives[primitive as usize].shape();
        let shading = shape.shading_normal(located.point, face);
        let local = shading.unwrap_or(located.normal).0;
        // Normals are mapped by the transpose of the inverse.
        let n: Vec3 = std::array::from_fn(|i| (0..3).map(|k| back.0[k][i] * local[k]).sum());
        let length = length(n);
        let length = if dot(n, normal) < 0.0 {
            -length
        } else {
            length
        };
        let n = n.map(|x| x / length);
        n.iter().all(|x| x.is_finite()).then_some(n)
    }

    /// The point of the true surface nearest to `point` on the line along `normal`, in the shape's coordinates, with
    /// its primitive and its face. A face that faces as `normal` does is preferred, since near an edge another face
    /// may be nearer.
    fn locate(&self, graph: &Graph, point: Vec3, normal: Vec3) -> Option<(u32, Located<f64>, u32)> {
        let primitive = self.primitive?;
        let m = &self.matrix.0;
        let back = self.matrix.inverse()?;
        let line = Line::new(back.point(point).into(), back.vector(normal).into());
        let facing: Vec3 = std::array::from_fn(|i| (0..3).map(|k| m[k][i] * normal[k]).sum());
        let mut roots = Roots::default();
        let shape = graph.primitives[primitive as usize].intersect();
        shape.crossings(&line, &mut roots);
        let mut all = roots.list;
        all.sort_by(|a, b| a.t.abs().total_cmp(&b.t.abs()));
        all.truncate(MAX_FACES_EXAMINED);
        let faces = |located: &Located<f64>| {
            let n = located.normal.0;
            (dot(n, facing) / length(n) / length(facing)).abs()
        };
        let found = all
            .iter()
            .map(|root| (shape.locate(&line, *root), root.face));
        let found: Vec<_> = found.collect();
        let alike = SAME_FACING_COSINES
            .iter()
            .find_map(|cosine| found.iter().find(|f| faces(&f.0) > *cosine));
        let (located, face) = *alike.or(found.first())?;
        Some((primitive, located, face))
    }
}

fn has_colours(graph: &Graph, primitive: u32) -> bool {
    match &graph.primitives[primitive as usize] {
        Primitive::Revolution(shape) => shape.has_colours(),
        _ => false,
    }
}

fn texturing(coat: &Coat, graph: &Graph) -> Option<Box<Texturing>> {
    let (texture, placement) = coat.texture?;
    Some(Box::new(Texturing {
        texture,
        matrix: graph.matrices[placement as usize],
    }))
}
