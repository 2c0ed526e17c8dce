//! Scenes as values.

use zpg::internals::diagnostics::Span;
use zpg::internals::geometry::Matrix;
use zpg::internals::scene::{
    AmbientLight, Camera, Entity, Geometry, Node, NodeId, Optics, Origin, Paint, PointLight,
    Render, Rgb, Scene, Shape, Texture, Vec3, View,
};
use zpg::internals::syntax::table::{Kind, ShapeKind};

/// A scene in the making; IDs count up from 2.
#[derive(Default)]
pub struct Make {
    pub scene: Scene,
    next: u32,
}

impl Make {
    /// With a camera on the z axis, an ambient and a point light.
    pub fn lit() -> Make {
        let mut make = Make::default();
        make.camera([1.0, 1.5, 6.0], [-1.0, -1.5, -6.0]);
        make.ambient(0.2, [1.0; 3]);
        make.light([4.0, 6.0, 5.0], 0.7, [1.0; 3]);
        make
    }

    fn id(&mut self) -> u32 {
        self.next += 1;
        self.next + 1
    }

    pub fn camera(&mut self, position: Vec3, direction: Vec3) {
        let id = self.id();
        self.scene.cameras = vec![Camera {
            id,
            position,
            direction,
            up: [0.0, 2.0, 0.0],
            fovy: 40.0,
            projection: None,
        }];
        self.scene.view = View::Mono(0);
    }

    pub fn ambient(&mut self, intensity: f64, colour: Rgb) {
        let id = self.id();
        self.scene.ambient_lights.push(AmbientLight {
            id,
            intensity,
            colour,
        });
    }

    pub fn light(&mut self, position: Vec3, intensity: f64, colour: Rgb) {
        let id = self.id();
        self.scene.point_lights.push(PointLight {
            id,
            position,
            intensity,
            colour,
        });
    }

    fn node(&mut self, node: Node) -> NodeId {
        self.scene.nodes.push(node);
        let (id, span) = (self.next, Span::new(0, 0));
        self.scene.origins.push(Origin { id, span });
        self.scene.nodes.len() as NodeId - 1
    }

    /// A node that is an entity of its own.
    fn entity(&mut self, id: u32, node: NodeId) -> NodeId {
        let mut entity = Entity::new(id, Some(Kind::Object), Span::default());
        entity.set_node(node);
        self.scene.entities.push(entity);
        node
    }

    pub fn shape(&mut self, kind: ShapeKind, geometry: Geometry) -> NodeId {
        let id = self.id();
        self.scene.shapes.push(Shape { id, kind, geometry });
        let shape = self.scene.shapes.len() as u32 - 1;
        let node = self.node(Node::Shape(shape));
        self.entity(id, node)
    }

    pub fn sphere(&mut self, centre: Vec3, radius: f64) -> NodeId {
        self.shape(ShapeKind::Sphere, Geometry::Sphere { centre, radius })
    }

    pub fn cube(&mut self, min: Vec3, max: Vec3) -> NodeId {
        self.shape(ShapeKind::Box, Geometry::Box { min, max })
    }

    pub fn plane(&mut self, abcd: [f64; 4]) -> NodeId {
        self.shape(ShapeKind::Plane, Geometry::Plane(abcd))
    }

    pub fn half_space(&mut self, abcd: [f64; 4]) -> NodeId {
        self.shape(ShapeKind::HalfSpace, Geometry::HalfSpace(abcd))
    }

    pub fn rectangle(&mut self, min: [f64; 2], max: [f64; 2]) -> NodeId {
        self.shape(ShapeKind::Rectangle, Geometry::Rectangle { min, max })
    }

    fn operation(&mut self, node: Node) -> NodeId {
        let id = self.id();
        let node = self.node(node);
        self.entity(id, node)
    }

    pub fn union(&mut self, a: NodeId, b: NodeId) -> NodeId {
        self.operation(Node::Union(a, b))
    }

    pub fn intersection(&mut self, a: NodeId, b: NodeId) -> NodeId {
        self.operation(Node::Intersection(a, b))
    }

    pub fn difference(&mut self, a: NodeId, b: NodeId) -> NodeId {
        self.operation(Node::Difference(a, b))
    }

    pub fn complement(&mut self, a: NodeId) -> NodeId {
        self.operation(Node::Complement(a))
    }

    pub fn moved(&mut self, child: NodeId, m: Matrix) -> NodeId {
        self.scene.matrices.push(m);
        let matrix = self.scene.matrices.len() as u32 - 1;
        let node = self.node(Node::Transform { child, matrix });
        self.renew(child, node)
    }

    /// The entity of a node goes on as another node.
    fn renew(&mut self, from: NodeId, to: NodeId) -> NodeId {
        for e in &mut self.scene.entities {
            if e.node() == Some(from) {
                e.set_node(to);
            }
        }
        to
    }

    pub fn paint(&mut self, child: NodeId, paint: Paint) -> NodeId {
        let owner = self.id();
        self.scene.paints.push(Paint { owner, ..paint });
        let paint = self.scene.paints.len() as u32 - 1;
        let node = self.node(Node::Paint { child, paint });
        self.renew(child, node)
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

    pub fn checkered(&mut self, child: NodeId, n: u32, m: u32) -> NodeId {
        let colours = [[0.9, 0.8, 0.2], [0.1, 0.2, 0.6]];
        self.textured(child, Texture::Checkerboard { n, m, colours })
    }

    /// A checkered floor below, to be seen through and mirrored.
    pub fn on_floor(&mut self, child: NodeId) -> NodeId {
        let floor = self.plane([0.0, 2.0, 0.0, 2.6]);
        let floor = self.checkered(floor, 1, 1);
        self.union(child, floor)
    }

    pub fn render(mut self, root: NodeId, background: Rgb, clip: Option<(Vec3, Vec3)>) -> Scene {
        self.scene.render = Some(Render {
            root,
            root_id: self
                .scene
                .entities
                .iter()
                .find(|e| e.node() == Some(root))
                .map_or(0, |e| e.id),
            background,
            clip,
            span: Span::default(),
        });
        self.scene
    }

    pub fn done(self, root: NodeId) -> Scene {
        self.render(root, [0.1, 0.2, 0.3], None)
    }
}
