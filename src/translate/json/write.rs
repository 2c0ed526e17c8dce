//! A resolved scene as a model of JSON.

use super::model::{self, Item, Node};
use crate::geometry::Matrix;
use crate::scene::{self, NodeId, Promise, Scene, Texture, Volume};

/// The model of a resolved scene, with all objects as they are at the end of the file. Earlier states of objects are
/// left out unless something refers to them.
pub fn write(scene: &Scene) -> model::Scene {
    let numbers = numbers(scene);
    let node = |n: NodeId| numbers[n as usize].unwrap_or_default();
    // Promises are sorted by their nodes, the order in which they are written as records.
    let mut promises: Vec<&Promise> = scene.promises.iter().collect();
    promises.sort_by_key(|p| p.node);
    let items = (0..scene.nodes.len()).filter(|&i| numbers[i].is_some());
    model::Scene {
        version: model::VERSION,
        nodes: items.map(|i| item(scene, i, node)).collect(),
        ambient_lights: (scene.ambient_lights.iter())
            .map(|l| model::AmbientLight {
                id: Some(l.id),
                intensity: l.intensity,
                colour: l.colour,
            })
            .collect(),
        point_lights: (scene.point_lights.iter())
            .map(|l| model::PointLight {
                id: Some(l.id),
                position: l.position,
                intensity: l.intensity,
                colour: l.colour,
            })
            .collect(),
        cameras: (scene.cameras.iter())
            .map(|c| model::Camera {
                id: Some(c.id),
                position: c.position,
                direction: c.direction,
                up: c.up,
                fovy: c.fovy,
                projection: c.projection.as_ref().map(rows),
            })
            .collect(),
        view: match scene.view {
            scene::View::Automatic => None,
            scene::View::Mono(i) => Some(model::View::Mono(i as u32)),
            scene::View::Stereo { left, right } => Some(model::View::Stereo {
                left: left as u32,
                right: right as u32,
            }),
        },
        render: scene.render.map(|r| model::Render {
            root: node(r.root),
            background: r.background,
            clip: r.clip.map(|(min, max)| model::Region { min, max }),
        }),
        bounds: (promises.into_iter())
            .map(|p| model::Bound {
                node: node(p.node),
                volume: match p.volume {
                    Volume::Box { min, max } => model::Volume::Box { min, max },
                    Volume::Sphere { centre, radius } => model::Volume::Sphere { centre, radius },
                },
            })
            .collect(),
    }
}

/// For each node its index in the model; `None` for a node that is left out.
fn numbers(scene: &Scene) -> Vec<Option<u32>> {
    let mut used = vec![false; scene.nodes.len()];
    let ends = scene.entities.iter().filter_map(|e| e.node());
    let promised = scene.promises.iter().map(|p| p.node);
    for n in ends.chain(promised).chain(scene.render.map(|r| r.root)) {
        used[n as usize] = true;
    }
    // Children stand before their parents.
    for i in (0..used.len()).rev() {
        if used[i] {
            let from = scene.steps.get(&(i as NodeId)).map(|s| s.from);
            let children = scene.nodes[i].children().filter(|_| from.is_none());
            for child in from.into_iter().chain(children) {
                used[child as usize] = true;
            }
        }
    }
    let mut next = 0;
    let number = |used: bool| {
        used.then(|| {
            next += 1;
            next - 1
        })
    };
    used.into_iter().map(number).collect()
}

fn item(scene: &Scene, i: usize, node: impl Fn(NodeId) -> u32) -> Item {
    use scene::Node as N;
    let pair = |a, b| [node(a), node(b)];
    // A change of a state that others need, too, refers to that state, as its record does.
    let step = scene.steps.get(&(i as NodeId));
    let of = |child| node(step.map_or(child, |s| s.from));
    let made = match scene.nodes[i] {
        N::Shape(s) => Node::of(&scene.shapes[s as usize].geometry),
        N::Union(a, b) => Node::Union {
            operands: pair(a, b),
        },
        N::Intersection(a, b) => Node::Intersection {
            operands: pair(a, b),
        },
        N::Difference(a, b) => Node::Difference {
            operands: pair(a, b),
        },
        N::Complement(child) => Node::Complement { of: node(child) },
        N::Copy { child, .. } => Node::Copy { of: node(child) },
        N::Transform { child, matrix } => Node::Transform {
            of: of(child),
            matrix: rows(&scene.matrices[step.and_then(|s| s.matrix).unwrap_or(matrix) as usize]),
        },
        N::Paint { child, paint } => {
            let paint = &scene.paints[paint as usize];
            Node::Paint {
                of: of(child),
                texture: paint.texture.as_ref().map(texture),
                optics: (paint.optics).map(|o| model::Optics {
                    kd: o.kd,
                    ks: o.ks,
                    kt: o.kt,
                }),
                index: paint.index,
            }
        }
    };
    let changes = matches!(made, Node::Transform { .. } | Node::Paint { .. });
    Item {
        id: (!changes).then_some(scene.origins[i].id),
        node: made,
    }
}

fn rows(m: &Matrix) -> [f64; 16] {
    std::array::from_fn(|i| m.0[i / 4][i % 4])
}

fn texture(texture: &Texture) -> model::Texture {
    match texture {
        Texture::Colour(rgb) => model::Texture::Colour(*rgb),
        Texture::Checkerboard { n, m, colours } => model::Texture::Checkerboard {
            n: *n,
            m: *m,
            colours: *colours,
        },
        Texture::Solid { colours, size } => model::Texture::Solid {
            colours: *colours,
            size: *size,
        },
        Texture::Image { file, .. } => model::Texture::Image(file.clone()),
    }
}
