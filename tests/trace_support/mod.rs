//! Scenes built without a parser, and random numbers for tests.

use std::collections::HashMap;
use zpg::internals::diagnostics::Span;
use zpg::internals::geometry::Matrix;
use zpg::internals::geometry::vec::Vec3;
use zpg::internals::scene::*;
use zpg::internals::solids::staging::{Viewpoint, staged};
use zpg::internals::syntax::table::{Kind, ShapeKind};
use zpg::internals::trace::{Picture, Ray, Settings, Tracer, selected_camera};

/// A scene in the making. IDs count up from 2.
#[derive(Default)]
pub struct Builder {
    pub scene: Scene,
    next: u32,
    /// The entity that each node is the last state of, by its number.
    owners: HashMap<NodeId, usize>,
}

pub const CLEAR: Optics = Optics {
    kd: [0.0; 3],
    ks: [0.0; 3],
    kt: [1.0; 3],
};

pub fn optics(kd: f64, ks: f64, kt: f64) -> Optics {
    Optics {
        kd: [kd; 3],
        ks: [ks; 3],
        kt: [kt; 3],
    }
}

impl Builder {
    /// A scene with a camera near the z axis, an ambient and a point light.
    pub fn lit() -> Builder {
        let mut b = Builder::default();
        b.camera([1.0, 1.5, 6.0], [-1.0, -1.5, -6.0], [0.0, 2.0, 0.0], 40.0);
        b.ambient(0.2);
        b.light([4.0, 6.0, 5.0], 0.7);
        b
    }

    fn id(&mut self) -> u32 {
        self.next += 1;
        self.next + 1
    }

    fn node(&mut self, id: u32, node: Node) -> NodeId {
        let span = Span::new(id, id + 1);
        self.scene.origins.push(Origin { id, span });
        self.scene.nodes.push(node);
        self.scene.nodes.len() as NodeId - 1
    }

    /// A node that is an entity of its own.
    fn entity(&mut self, node: Node) -> NodeId {
        let id = self.id();
        let node = self.node(id, node);
        let mut entity = Entity::new(id, Some(Kind::Object), Span::default());
        entity.set_node(node);
        self.owners.insert(node, self.scene.entities.len());
        self.scene.entities.push(entity);
        node
    }

    /// A node that is a later state of the entity of another one.
    fn state(&mut self, id: u32, of: NodeId, node: Node) -> NodeId {
        let node = self.node(id, node);
        if let Some(entity) = self.owners.remove(&of) {
            self.scene.entities[entity].set_node(node);
            self.owners.insert(node, entity);
        }
        node
    }

    pub fn shape(&mut self, geometry: Geometry) -> NodeId {
        let kind = match geometry {
            Geometry::Sphere { .. } => ShapeKind::Sphere,
            Geometry::Box { .. } => ShapeKind::Box,
            Geometry::HalfSpace(_) => ShapeKind::HalfSpace,
            Geometry::Plane(_) => ShapeKind::Plane,
            Geometry::Rectangle { .. } => ShapeKind::Rectangle,
            _ => ShapeKind::Torus,
        };
        let id = self.next + 2;
        self.scene.shapes.push(Shape { id, kind, geometry });
        self.entity(Node::Shape(self.scene.shapes.len() as u32 - 1))
    }

    pub fn sphere(&mut self, centre: [f64; 3], radius: f64) -> NodeId {
        self.shape(Geometry::Sphere { centre, radius })
    }

    pub fn cuboid(&mut self, min: [f64; 3], max: [f64; 3]) -> NodeId {
        self.shape(Geometry::Box { min, max })
    }

    pub fn plane(&mut self, abcd: [f64; 4]) -> NodeId {
        self.shape(Geometry::Plane(abcd))
    }

    pub fn half_space(&mut self, abcd: [f64; 4]) -> NodeId {
        self.shape(Geometry::HalfSpace(abcd))
    }

    pub fn rectangle(&mut self, min: [f64; 2], max: [f64; 2]) -> NodeId {
        self.shape(Geometry::Rectangle { min, max })
    }

    pub fn union(&mut self, a: NodeId, b: NodeId) -> NodeId {
        self.entity(Node::Union(a, b))
    }

    pub fn all(&mut self, parts: &[NodeId]) -> NodeId {
        let mut parts = parts.iter();
        let first = *parts.next().unwrap();
        parts.fold(first, |a, &b| self.union(a, b))
    }

    pub fn intersection(&mut self, a: NodeId, b: NodeId) -> NodeId {
        self.entity(Node::Intersection(a, b))
    }

    pub fn difference(&mut self, a: NodeId, b: NodeId) -> NodeId {
        self.entity(Node::Difference(a, b))
    }

    pub fn complement(&mut self, a: NodeId) -> NodeId {
        self.entity(Node::Complement(a))
    }

    pub fn moved(&mut self, child: NodeId, m: Matrix) -> NodeId {
        self.scene.matrices.push(m);
        let matrix = self.scene.matrices.len() as u32 - 1;
        self.state(0, child, Node::Transform { child, matrix })
    }

    pub fn paint(&mut self, child: NodeId, paint: Paint) -> NodeId {
        let owner = self.id();
        self.scene.paints.push(Paint { owner, ..paint });
        let paint = self.scene.paints.len() as u32 - 1;
        self.state(owner, child, Node::Paint { child, paint })
    }

    pub fn textured(&mut self, child: NodeId, texture: Texture) -> NodeId {
        self.paint(
            child,
            Paint {
                texture: Some(texture),
                ..Paint::default()
            },
        )
    }

    pub fn coloured(&mut self, child: NodeId, colour: Rgb) -> NodeId {
        self.textured(child, Texture::Colour(colour))
    }

    pub fn checkered(&mut self, child: NodeId, n: u32, m: u32) -> NodeId {
        let colours = [[0.9, 0.8, 0.2], [0.1, 0.2, 0.6]];
        self.textured(child, Texture::Checkerboard { n, m, colours })
    }

    pub fn optics(&mut self, child: NodeId, kd: Rgb, ks: Rgb, kt: Rgb) -> NodeId {
        self.paint(
            child,
            Paint {
                optics: Some(Optics { kd, ks, kt }),
                ..Paint::default()
            },
        )
    }

    pub fn mono(&mut self, child: NodeId, kd: f64, ks: f64, kt: f64) -> NodeId {
        self.optics(child, [kd; 3], [ks; 3], [kt; 3])
    }

    pub fn index(&mut self, child: NodeId, eta: Rgb) -> NodeId {
        self.paint(
            child,
            Paint {
                index: Some(eta),
                ..Paint::default()
            },
        )
    }

    pub fn made_of(&mut self, child: NodeId, optics: Optics, index: f64) -> NodeId {
        self.paint(
            child,
            Paint {
                optics: Some(optics),
                index: Some([index; 3]),
                ..Paint::default()
            },
        )
    }

    /// A checkered floor below, to be seen through and mirrored.
    pub fn on_floor(&mut self, child: NodeId) -> NodeId {
        let floor = self.plane([0.0, 2.0, 0.0, 2.6]);
        let floor = self.checkered(floor, 1, 1);
        self.union(child, floor)
    }

    pub fn ambient(&mut self, intensity: f64) {
        self.coloured_ambient(intensity, [1.0; 3]);
    }

    pub fn coloured_ambient(&mut self, intensity: f64, colour: Rgb) {
        let id = self.id();
        self.scene.ambient_lights.push(AmbientLight {
            id,
            intensity,
            colour,
        });
    }

    pub fn light(&mut self, position: [f64; 3], intensity: f64) {
        self.coloured_light(position, intensity, [1.0; 3]);
    }

    pub fn coloured_light(&mut self, position: [f64; 3], intensity: f64, colour: Rgb) {
        let id = self.id();
        self.scene.point_lights.push(PointLight {
            id,
            position,
            intensity,
            colour,
        });
    }

    pub fn camera(&mut self, position: [f64; 3], direction: [f64; 3], up: [f64; 3], fovy: f64) {
        let id = self.id();
        self.scene.cameras.push(Camera {
            id,
            position,
            direction,
            up,
            fovy,
            projection: None,
        });
        self.scene.view = View::Mono(self.scene.cameras.len() - 1);
    }

    pub fn render(mut self, root: NodeId, background: Rgb) -> Scene {
        let entity = self.owners.get(&root);
        self.scene.render = Some(Render {
            root,
            root_id: entity.map_or(0, |&i| self.scene.entities[i].id),
            background,
            clip: None,
            span: Span::default(),
        });
        self.scene
    }

    pub fn done(self, root: NodeId) -> Scene {
        self.render(root, [0.1, 0.2, 0.3])
    }

    pub fn tracer(self, root: NodeId) -> Tracer {
        Tracer::new(&self.render(root, [0.0; 3])).unwrap()
    }

    /// A tracer of what there is so far, or of a part of it.
    pub fn tracer_of(&self, root: NodeId) -> Tracer {
        let copy = Builder {
            scene: Scene {
                nodes: self.scene.nodes.clone(),
                shapes: self.scene.shapes.clone(),
                matrices: self.scene.matrices.clone(),
                paints: self.scene.paints.clone(),
                ..Scene::default()
            },
            ..Builder::default()
        };
        copy.tracer(root)
    }
}

pub fn picture(scene: &Scene, settings: &Settings) -> Picture {
    let aspect = settings.width as f64 / settings.height as f64;
    let scene = &*staged(scene, Viewpoint::Scene, aspect);
    let tracer = Tracer::new(scene).unwrap();
    let camera = selected_camera(scene, aspect);
    tracer.render(&camera, settings, || ()).unwrap()
}

/// Small pictures for tests that look at pixels.
pub fn small(width: u32, height: u32) -> Settings {
    Settings {
        width,
        height,
        ..Settings::default()
    }
}

/// Numbers that look random and are the same every time.
pub struct Random(pub u64);

impl Random {
    pub fn bits(&mut self) -> u64 {
        self.0 += 1;
        zpg::internals::trace::sampling::hash(self.0)
    }

    /// In [0, 1).
    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1u64 << 53) as f64
    }

    pub fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    pub fn below(&mut self, n: u64) -> u64 {
        self.bits() % n
    }

    pub fn point(&mut self, size: f64) -> Vec3 {
        Vec3([0; 3].map(|_| self.within(-size, size)))
    }

    pub fn ray(&mut self, size: f64) -> Ray {
        let origin = self.point(size);
        let aim = self.point(size);
        Ray::new(origin, aim - origin)
    }
}
