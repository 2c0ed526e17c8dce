//! Scenes built without a parser, and random numbers for tests.

use zpg::internals::diagnostics::Span;
use zpg::internals::geometry::Matrix;
use zpg::internals::geometry::vec::Vec3;
use zpg::internals::scene::*;
use zpg::internals::solids::staging::{Viewpoint, staged};
use zpg::internals::syntax::table::ShapeKind;
use zpg::internals::trace::{Picture, Ray, Settings, Tracer, selected_camera};

#[derive(Default)]
pub struct Builder {
    pub scene: Scene,
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
    fn push(&mut self, node: Node) -> NodeId {
        let id = match node {
            Node::Shape(shape) => self.scene.shapes[shape as usize].id,
            _ => 0,
        };
        let span = Span::new(id, id + 1);
        self.scene.origins.push(Origin { id, span });
        self.scene.nodes.push(node);
        self.scene.nodes.len() as u32 - 1
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
        let id = self.scene.shapes.len() as u32 + 2;
        self.scene.shapes.push(Shape { id, kind, geometry });
        self.push(Node::Shape(id - 2))
    }

    pub fn sphere(&mut self, x: f64, y: f64, z: f64, radius: f64) -> NodeId {
        self.shape(Geometry::Sphere {
            centre: [x, y, z],
            radius,
        })
    }

    pub fn cuboid(&mut self, min: [f64; 3], max: [f64; 3]) -> NodeId {
        self.shape(Geometry::Box { min, max })
    }

    pub fn half_space(&mut self, a: f64, b: f64, c: f64, d: f64) -> NodeId {
        self.shape(Geometry::HalfSpace([a, b, c, d]))
    }

    pub fn union(&mut self, a: NodeId, b: NodeId) -> NodeId {
        self.push(Node::Union(a, b))
    }

    pub fn all(&mut self, parts: &[NodeId]) -> NodeId {
        let mut parts = parts.iter();
        let first = *parts.next().unwrap();
        parts.fold(first, |a, &b| self.union(a, b))
    }

    pub fn intersection(&mut self, a: NodeId, b: NodeId) -> NodeId {
        self.push(Node::Intersection(a, b))
    }

    pub fn difference(&mut self, a: NodeId, b: NodeId) -> NodeId {
        self.push(Node::Difference(a, b))
    }

    pub fn complement(&mut self, a: NodeId) -> NodeId {
        self.push(Node::Complement(a))
    }

    pub fn moved(&mut self, child: NodeId, m: Matrix) -> NodeId {
        self.scene.matrices.push(m);
        let matrix = self.scene.matrices.len() as u32 - 1;
        self.push(Node::Transform { child, matrix })
    }

    pub fn paint(&mut self, child: NodeId, paint: Paint) -> NodeId {
        self.scene.paints.push(paint);
        let paint = self.scene.paints.len() as u32 - 1;
        self.push(Node::Paint { child, paint })
    }

    pub fn coloured(&mut self, child: NodeId, colour: Rgb) -> NodeId {
        self.paint(
            child,
            Paint {
                texture: Some(Texture::Colour(colour)),
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

    pub fn ambient(&mut self, intensity: f64) {
        self.scene.ambient_lights.push(AmbientLight {
            id: 0,
            intensity,
            colour: [1.0; 3],
        });
    }

    pub fn light(&mut self, position: [f64; 3], intensity: f64) {
        self.scene.point_lights.push(PointLight {
            id: 0,
            position,
            intensity,
            colour: [1.0; 3],
        });
    }

    pub fn camera(&mut self, position: [f64; 3], direction: [f64; 3], up: [f64; 3], fovy: f64) {
        self.scene.cameras.push(Camera {
            id: 0,
            position,
            direction,
            up,
            fovy,
            projection: None,
        });
        self.scene.view = View::Mono(self.scene.cameras.len() - 1);
    }

    pub fn render(mut self, root: NodeId, background: Rgb) -> Scene {
        self.scene.render = Some(Render {
            root,
            root_id: 2,
            background,
            clip: None,
            span: Span::default(),
        });
        self.scene
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
