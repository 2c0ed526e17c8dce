//! The model of a scene in JSON. Elements are referred to by their index in their list, from 0; a node refers only to
//! nodes before it. Matrices are sixteen numbers, row by row.

use serde::{Deserialize, Serialize};

use crate::scene::{Geometry, TriangleNormals};

pub type Vec3 = [f64; 3];
/// Linear red, green, blue.
pub type Rgb = [f64; 3];

/// The version of the format.
pub const VERSION: u32 = 1;

#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Scene {
    pub version: u32,
    pub nodes: Vec<Item>,
    #[serde(default)]
    pub ambient_lights: Vec<AmbientLight>,
    #[serde(default)]
    pub point_lights: Vec<PointLight>,
    #[serde(default)]
    pub cameras: Vec<Camera>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub view: Option<View>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub render: Option<Render>,
    #[serde(default)]
    pub bounds: Vec<Bound>,
}

/// A node with the ID of the object that it defines in the language. Transformations and paints have no ID: they
/// change the object of the node below them.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "serde_json::Map<String, serde_json::Value>")]
pub struct Item {
    #[serde(skip_serializing_if = "Option::is_none")]
    pub id: Option<u32>,
    #[serde(flatten)]
    pub node: Node,
}

/// Reads an item by hand: with `flatten` an unknown field would pass.
impl TryFrom<serde_json::Map<String, serde_json::Value>> for Item {
    type Error = serde_json::Error;

    fn try_from(
        mut fields: serde_json::Map<String, serde_json::Value>,
    ) -> Result<Item, Self::Error> {
        let id = fields
            .remove("id")
            .map(serde_json::from_value)
            .transpose()?;
        let node = serde_json::from_value(fields.into())?;
        Ok(Item { id, node })
    }
}

/// An object; lengths and meanings as in the record of the same name.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(tag = "type", rename_all = "kebab-case", deny_unknown_fields)]
pub enum Node {
    SurfaceOfRevolution {
        /// (x, y)
        profile: Vec<[f64; 2]>,
        /// None, or one for each point.
        #[serde(default, skip_serializing_if = "Vec::is_empty")]
        colours: Vec<Rgb>,
    },
    Plane {
        a: f64,
        b: f64,
        c: f64,
        d: f64,
    },
    HalfSpace {
        a: f64,
        b: f64,
        c: f64,
        d: f64,
    },
    Rectangle {
        min: [f64; 2],
        max: [f64; 2],
    },
    Triangle {
        vertices: [Vec3; 3],
        /// None, one for all of it, or one for each vertex.
        #[serde(default, skip_serializing_if = "Vec::is_empty")]
        normals: Vec<Vec3>,
    },
    Sphere {
        #[serde(default)]
        centre: Vec3,
        radius: f64,
    },
    Ellipsoid {
        semi_axes: Vec3,
    },
    Box {
        min: Vec3,
        max: Vec3,
    },
    GeodesicSphere {
        radius: f64,
        splits: u32,
    },
    Torus {
        major: f64,
        minor: f64,
    },
    Quadric {
        matrix: [f64; 16],
    },
    Cone {
        height: f64,
        radius: f64,
    },
    DoubleCone {
        height: f64,
        radius: f64,
    },
    ParabolicCylinder {
        a: f64,
    },
    HyperbolicCylinder {
        a: f64,
        b: f64,
    },
    Hyperboloid {
        a: f64,
        b: f64,
        c: f64,
        sheets: u32,
    },
    HyperbolicParaboloid {
        a: f64,
        b: f64,
    },
    Union {
        operands: [u32; 2],
    },
    Intersection {
        operands: [u32; 2],
    },
    Difference {
        operands: [u32; 2],
    },
    Complement {
        of: u32,
    },
    Copy {
        of: u32,
    },
    Transform {
        of: u32,
        matrix: [f64; 16],
    },
    Paint {
        of: u32,
        #[serde(default, skip_serializing_if = "Option::is_none")]
        texture: Option<Texture>,
        #[serde(default, skip_serializing_if = "Option::is_none")]
        optics: Option<Optics>,
        /// The refractive index of each channel.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        index: Option<Rgb>,
    },
}

impl Node {
    /// The node for a shape.
    pub fn of(geometry: &Geometry) -> Node {
        match geometry {
            Geometry::Revolution { profile, colours } => Node::SurfaceOfRevolution {
                profile: profile.clone(),
                colours: colours.clone(),
            },
            &Geometry::Plane([a, b, c, d]) => Node::Plane { a, b, c, d },
            &Geometry::HalfSpace([a, b, c, d]) => Node::HalfSpace { a, b, c, d },
            &Geometry::Rectangle { min, max } => Node::Rectangle { min, max },
            Geometry::Triangle { vertices, normals } => Node::Triangle {
                vertices: **vertices,
                normals: match normals {
                    TriangleNormals::Flat => Vec::new(),
                    TriangleNormals::One(n) => vec![*n],
                    TriangleNormals::PerVertex(all) => all.to_vec(),
                },
            },
            &Geometry::Sphere { centre, radius } => Node::Sphere { centre, radius },
            &Geometry::Ellipsoid { semi_axes } => Node::Ellipsoid { semi_axes },
            &Geometry::Box { min, max } => Node::Box { min, max },
            &Geometry::GeodesicSphere { radius, splits } => Node::GeodesicSphere { radius, splits },
            &Geometry::Torus { major, minor } => Node::Torus { major, minor },
            Geometry::Quadric(matrix) => Node::Quadric { matrix: **matrix },
            &Geometry::Cone { height, radius } => Node::Cone { height, radius },
            &Geometry::DoubleCone { height, radius } => Node::DoubleCone { height, radius },
            &Geometry::ParabolicCylinder { a } => Node::ParabolicCylinder { a },
            &Geometry::HyperbolicCylinder { a, b } => Node::HyperbolicCylinder { a, b },
            &Geometry::Hyperboloid { a, b, c, sheets } => Node::Hyperboloid { a, b, c, sheets },
            &Geometry::HyperbolicParaboloid { a, b } => Node::HyperbolicParaboloid { a, b },
        }
    }

    /// The shape of the node; `None` for a node made of others.
    pub fn geometry(&self) -> Option<Geometry> {
        Some(match self {
            Node::SurfaceOfRevolution { profile, colours } => Geometry::Revolution {
                profile: profile.clone(),
                colours: colours.clone(),
            },
            &Node::Plane { a, b, c, d } => Geometry::Plane([a, b, c, d]),
            &Node::HalfSpace { a, b, c, d } => Geometry::HalfSpace([a, b, c, d]),
            &Node::Rectangle { min, max } => Geometry::Rectangle { min, max },
            Node::Triangle { vertices, normals } => Geometry::Triangle {
                vertices: Box::new(*vertices),
                normals: match normals[..] {
                    [a, b, c] => TriangleNormals::PerVertex(Box::new([a, b, c])),
                    [n] => TriangleNormals::One(n),
                    _ => TriangleNormals::Flat,
                },
            },
            &Node::Sphere { centre, radius } => Geometry::Sphere { centre, radius },
            &Node::Ellipsoid { semi_axes } => Geometry::Ellipsoid { semi_axes },
            &Node::Box { min, max } => Geometry::Box { min, max },
            &Node::GeodesicSphere { radius, splits } => Geometry::GeodesicSphere { radius, splits },
            &Node::Torus { major, minor } => Geometry::Torus { major, minor },
            &Node::Quadric { matrix } => Geometry::Quadric(Box::new(matrix)),
            &Node::Cone { height, radius } => Geometry::Cone { height, radius },
            &Node::DoubleCone { height, radius } => Geometry::DoubleCone { height, radius },
            &Node::ParabolicCylinder { a } => Geometry::ParabolicCylinder { a },
            &Node::HyperbolicCylinder { a, b } => Geometry::HyperbolicCylinder { a, b },
            &Node::Hyperboloid { a, b, c, sheets } => Geometry::Hyperboloid { a, b, c, sheets },
            &Node::HyperbolicParaboloid { a, b } => Geometry::HyperbolicParaboloid { a, b },
            Node::Union { .. }
            | Node::Intersection { .. }
            | Node::Difference { .. }
            | Node::Complement { .. }
            | Node::Copy { .. }
            | Node::Transform { .. }
            | Node::Paint { .. } => return None,
        })
    }

    /// The indices of the nodes that the node is made of.
    pub fn children(&self) -> [Option<u32>; 2] {
        match *self {
            Node::Union { operands: [a, b] }
            | Node::Intersection { operands: [a, b] }
            | Node::Difference { operands: [a, b] } => [Some(a), Some(b)],
            Node::Complement { of }
            | Node::Copy { of }
            | Node::Transform { of, .. }
            | Node::Paint { of, .. } => [Some(of), None],
            // Shapes are made of no other nodes.
            _ => [None; 2],
        }
    }
}

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub enum Texture {
    Colour(Rgb),
    Checkerboard {
        n: u32,
        m: u32,
        colours: [Rgb; 2],
    },
    Solid {
        colours: [Rgb; 2],
        size: f64,
    },
    /// The name of a file beside the scene.
    Image(String),
}

/// Diffuse, mirrored and transmitted parts, each per channel.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Optics {
    pub kd: Rgb,
    pub ks: Rgb,
    pub kt: Rgb,
}

#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct AmbientLight {
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub id: Option<u32>,
    pub intensity: f64,
    #[serde(default = "white")]
    pub colour: Rgb,
}

#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct PointLight {
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub id: Option<u32>,
    pub position: Vec3,
    pub intensity: f64,
    #[serde(default = "white")]
    pub colour: Rgb,
}

fn white() -> Rgb {
    [1.0; 3]
}

#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Camera {
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub id: Option<u32>,
    pub position: Vec3,
    pub direction: Vec3,
    pub up: Vec3,
    /// Degrees.
    pub fovy: f64,
    /// In place of `fovy`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub projection: Option<[f64; 16]>,
}

/// Which cameras take the picture.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub enum View {
    Mono(u32),
    Stereo { left: u32, right: u32 },
}

#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Render {
    pub root: u32,
    #[serde(default)]
    pub background: Rgb,
    /// The region that is drawn.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub clip: Option<Region>,
}

#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Region {
    pub min: Vec3,
    pub max: Vec3,
}

/// The promise that a node lies within a volume.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Bound {
    pub node: u32,
    pub volume: Volume,
}

#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub enum Volume {
    Box { min: Vec3, max: Vec3 },
    Sphere { centre: Vec3, radius: f64 },
}
