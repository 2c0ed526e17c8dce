//! The value of the model that each part of a record stands for.

use super::locate::Path;
use super::model::{Node, Scene, Texture, Volume};
use super::spell::{Matter, ModelElement};
use crate::syntax::table::RecordKind;

/// The parts of a record: its ID, its type, its parameters by their number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum RecordField {
    Id,
    Type,
    Parameter(usize),
}

/// The path to the value that a part of a record stands for. A part without a value of its own stands for the value
/// around it.
pub(super) fn value(scene: &Scene, place: ModelElement, matter: Matter, part: RecordField) -> Path {
    let path = place.path();
    let kind = match matter {
        Matter::Type(None) => return path,
        Matter::Type(Some(kind)) => kind,
        Matter::PatternColour(_) | Matter::Background => RecordKind::Colour,
    };
    match part {
        RecordField::Id => match kind {
            RecordKind::BoundingBox | RecordKind::BoundingSphere => path.name("node"),
            _ if defines(scene, place, kind) => path.name("id"),
            _ => path,
        },
        RecordField::Type => match place {
            ModelElement::Node(_) if defines(scene, place, kind) => path.name("type"),
            _ => path,
        },
        RecordField::Parameter(i) => parameter(scene, place, matter, kind, i),
    }
}

/// The path to the smallest value that holds what some parts of a record stand for.
pub(super) fn values(
    scene: &Scene,
    place: ModelElement,
    matter: Matter,
    parts: &[RecordField],
) -> Path {
    let kind = match matter {
        Matter::Type(Some(kind)) => kind,
        Matter::Type(None) => return place.path(),
        Matter::PatternColour(_) | Matter::Background => RecordKind::Colour,
    };
    if parts.len() > 1 && parts.contains(&RecordField::Id) && defines(scene, place, kind) {
        return place.path();
    }
    // A record that changes an object has no ID and no type in the model.
    let is_parameter = |part: &&RecordField| matches!(part, RecordField::Parameter(_));
    let parameters: Vec<RecordField> = parts.iter().filter(is_parameter).copied().collect();
    let parts = match parameters.is_empty() {
        true => parts,
        false => parameters.as_slice(),
    };
    let paths = parts.iter().map(|&part| value(scene, place, matter, part));
    paths
        .reduce(|a, b| a.common(&b))
        .unwrap_or_else(|| place.path())
}

/// Whether a record defines its element of the model, rather than changing the element or adding to it.
fn defines(scene: &Scene, place: ModelElement, kind: RecordKind) -> bool {
    match place {
        ModelElement::Node(i) => {
            let changes = matches!(
                scene.nodes.get(i as usize).map(|item| &item.node),
                None | Some(Node::Transform { .. } | Node::Paint { .. })
            );
            !changes && !matches!(kind, RecordKind::Colour)
        }
        ModelElement::AmbientLight(_) => kind == RecordKind::AmbientLight,
        ModelElement::PointLight(_) => kind == RecordKind::PointLight,
        ModelElement::Camera(_) => kind == RecordKind::Camera,
        _ => false,
    }
}

fn parameter(
    scene: &Scene,
    place: ModelElement,
    matter: Matter,
    kind: RecordKind,
    i: usize,
) -> Path {
    use RecordKind as R;
    let path = place.path();
    let is_node = matches!(place, ModelElement::Node(_));
    let node = match place {
        ModelElement::Node(n) => scene.nodes.get(n as usize).map(|item| &item.node),
        _ => None,
    };
    match kind {
        R::Shape(_) => node.map_or(path.clone(), |node| shape(path, node, i)),
        R::Union | R::Intersection | R::Difference => path.name("operands").item(i),
        R::Complement | R::Copy => path.name("of"),
        R::Translation if is_node => path.name("matrix").item(4 * i + 3),
        R::Translation => path.name("position").item(i),
        R::Scaling => path.name("matrix").item(5 * i),
        R::RotationMatrix => path.name("matrix").item(i),
        R::Colour => match matter {
            Matter::Background => path.name("background").item(i),
            Matter::PatternColour(k) => {
                let path = path.name("texture").name(pattern(node));
                path.name("colours").item(usize::from(k)).item(i)
            }
            Matter::Type(_) if is_node => path.name("texture").name("colour").item(i),
            Matter::Type(_) => path.name("colour").item(i),
        },
        R::ImageTexture => path.name("texture").name("image"),
        R::Checkerboard | R::SolidTexture => {
            let path = path.name("texture").name(pattern(node));
            let fields: &[_] = match kind {
                R::Checkerboard => &[("n", 1), ("m", 1), ("colours", 2)],
                _ => &[("colours", 2), ("size", 1)],
            };
            among(path, fields, i)
        }
        R::Optics => among(path.name("optics"), &[("kd", 1), ("ks", 1), ("kt", 1)], i),
        R::OpticsRgb => {
            let name = ["kd", "ks", "kt"][i % 3];
            path.name("optics").name(name).item(i / 3)
        }
        R::RefractiveIndex => path.name("index").item(i),
        R::AmbientLight | R::PointLight => path.name("intensity"),
        R::Camera => {
            let fields = [("position", 3), ("direction", 3), ("up", 3), ("fovy", 1)];
            among(path, &fields, i)
        }
        R::ProjectionMatrix => path.name("projection").item(i),
        R::MonoCamera => path.name("mono"),
        R::StereoCamera => path.name("stereo").name(["left", "right"][i.min(1)]),
        R::Render => {
            let clip = [("min", 3), ("max", 3)];
            match i {
                0 => path.name("root"),
                1 => path.name("background"),
                _ => among(path.name("clip"), &clip, i - 2),
            }
        }
        R::BoundingBox | R::BoundingSphere => {
            let bound = match place {
                ModelElement::Bound(n) => scene.bounds.get(n as usize),
                _ => None,
            };
            let path = path.name("volume");
            match bound.map(|b| &b.volume) {
                Some(Volume::Box { .. }) => among(path.name("box"), &[("min", 3), ("max", 3)], i),
                _ => among(path.name("sphere"), &[("centre", 3), ("radius", 1)], i),
            }
        }
        _ => path,
    }
}

/// The name of the node's texture, which has two colours.
fn pattern(node: Option<&Node>) -> &'static str {
    match node {
        Some(Node::Paint {
            texture: Some(Texture::Solid { .. }),
            ..
        }) => "solid",
        _ => "checkerboard",
    }
}

/// The path to the value of a shape's parameter with the number `i`, from 0.
fn shape(path: Path, node: &Node, i: usize) -> Path {
    let fields: &[(&'static str, usize)] = match node {
        Node::SurfaceOfRevolution { profile, .. } => {
            // The first parameter is the number of points.
            let Some(i) = i.checked_sub(1) else {
                return path.name("profile");
            };
            return match i.checked_sub(2 * profile.len()) {
                None => path.name("profile").item(i / 2).item(i % 2),
                Some(i) => path.name("colours").item(i / 3).item(i % 3),
            };
        }
        Node::Triangle { .. } => {
            return match i.checked_sub(9) {
                None => path.name("vertices").item(i / 3).item(i % 3),
                Some(i) => path.name("normals").item(i / 3).item(i % 3),
            };
        }
        Node::Sphere { centre, .. } if *centre == [0.0; 3] => &[("radius", 1)],
        Node::Sphere { .. } => &[("centre", 3), ("radius", 1)],
        Node::Plane { .. } | Node::HalfSpace { .. } => &[("a", 1), ("b", 1), ("c", 1), ("d", 1)],
        Node::Rectangle { .. } => &[("min", 2), ("max", 2)],
        Node::Ellipsoid { .. } => &[("semi_axes", 3)],
        Node::Box { .. } => &[("min", 3), ("max", 3)],
        Node::GeodesicSphere { .. } => &[("radius", 1), ("splits", 1)],
        Node::Torus { .. } => &[("major", 1), ("minor", 1)],
        Node::Quadric { .. } => &[("matrix", 16)],
        Node::Cone { .. } | Node::DoubleCone { .. } => &[("height", 1), ("radius", 1)],
        Node::ParabolicCylinder { .. } => &[("a", 1)],
        Node::HyperbolicCylinder { .. } | Node::HyperbolicParaboloid { .. } => {
            &[("a", 1), ("b", 1)]
        }
        Node::Hyperboloid { .. } => &[("a", 1), ("b", 1), ("c", 1), ("sheets", 1)],
        _ => &[],
    };
    among(path, fields, i)
}

/// The path to number `i` of several fields, which are given by their names and lengths. A field of length 1 is no
/// list.
fn among(path: Path, fields: &[(&'static str, usize)], mut i: usize) -> Path {
    for &(name, length) in fields {
        match length {
            1 if i == 0 => return path.name(name),
            _ if i < length => return path.name(name).item(i),
            _ => i -= length,
        }
    }
    path
}
