//! A ray tracer that is too simple to be wrong: at every ray all shapes are crossed, every crossing
//! is asked whether it lies on the boundary of the whole, by testing membership; every channel is
//! traced by itself. It shares nothing with the program but the resolved scene.

use super::naive_shapes::{self as shapes, add, cross, dot, unit};
use zpg::geometry::Matrix;
use zpg::scene::{
    AmbientLight, Camera, Node, NodeId, Optics, PointLight, Rgb, Scene, Texture, Vec3,
};

/// What a path from the root sets over a node: optics and index.
type Over = (Option<Optics>, Option<Rgb>);

/// A point of the boundary.
#[derive(Clone)]
struct Hit {
    t: f64,
    normal: Vec3,
    uv: [f64; 2],
    surface: bool,
    colour: Rgb,
    optics: Optics,
}

pub struct Naive<'a> {
    scene: &'a Scene,
    camera: Camera,
    lights: Vec<PointLight>,
    depth: u32,
    step: f64,
}

/// The colour of a pixel, and whether light was totally reflected on the way.
pub struct Seen {
    pub rgb: Rgb,
    pub total_reflection: bool,
}

/// Rays start this far from the surface they leave, as a part of the largest distance of a light or
/// the camera from the origin; media are looked up this far from a boundary.
const STEP: f64 = 1e-7;

impl<'a> Naive<'a> {
    pub fn new(scene: &'a Scene, camera: Camera, depth: u32) -> Naive<'a> {
        let mut lights = scene.point_lights.clone();
        if lights.is_empty() && scene.ambient_lights.is_empty() {
            lights.push(PointLight {
                id: 0,
                position: camera.position,
                intensity: 1.0,
                colour: [1.0; 3],
            });
        }
        let far = |p: Vec3| dot(p, p).sqrt();
        let size = lights
            .iter()
            .map(|l| far(l.position))
            .fold(far(camera.position), f64::max);
        Naive {
            scene,
            camera,
            lights,
            depth,
            step: STEP * size,
        }
    }

    /// The value at a place in the picture, in pixels from its upper left corner.
    pub fn at(&self, x: f64, y: f64, size: (u32, u32)) -> Seen {
        let (w, h) = (f64::from(size.0), f64::from(size.1));
        let forward = unit(self.camera.direction);
        let right = unit(cross(forward, self.camera.up));
        let up = cross(right, forward);
        let tan = (self.camera.fovy.to_radians() / 2.0).tan();
        let d = add(forward, right, (2.0 * x / w - 1.0) * tan * w / h);
        let d = add(d, up, (1.0 - 2.0 * y / h) * tan);
        let mut total_reflection = false;
        let rgb = std::array::from_fn(|c| {
            self.light_along(self.camera.position, d, c, 0, &mut total_reflection)
        });
        Seen {
            rgb,
            total_reflection,
        }
    }

    fn light_along(&self, o: Vec3, d: Vec3, c: usize, depth: u32, total: &mut bool) -> f64 {
        if depth > self.depth {
            return 0.0;
        }
        let render = self.scene.render.expect("a render record");
        let d = unit(d);
        let Some(hit) = self.hits(o, d).into_iter().next() else {
            return render.background[c];
        };
        let p = add(o, d, hit.t);
        let n = if dot(hit.normal, d) > 0.0 {
            hit.normal.map(|x| -x)
        } else {
            hit.normal
        };
        let (kd, ks, kt) = (hit.optics.kd[c], hit.optics.ks[c], hit.optics.kt[c]);
        let ambient = |a: &AmbientLight| a.intensity * a.colour[c];
        let mut light: f64 = self.scene.ambient_lights.iter().map(ambient).sum();
        for lamp in &self.lights {
            light += lamp.intensity * lamp.colour[c] * self.arrives(p, n, lamp.position, c);
        }
        let mut out = kd * hit.colour[c] * light;
        let mirror = add(d, n, -2.0 * dot(d, n));
        if ks > 0.0 {
            out += ks * self.light_along(add(p, n, self.step), mirror, c, depth + 1, total);
        }
        if kt > 0.0 {
            let (from, to) = if hit.surface {
                (1.0, 1.0)
            } else {
                (
                    self.index(add(p, d, -self.step))[c],
                    self.index(add(p, d, self.step))[c],
                )
            };
            if from == to {
                // A straight step does not count.
                out += kt * self.light_along(add(p, d, self.step), d, c, depth, total);
            } else {
                let cos = -dot(d, n);
                let k = from / to;
                let rest = 1.0 - k * k * (1.0 - cos * cos);
                if rest < 0.0 {
                    *total = true;
                    out += kt * self.light_along(add(p, n, self.step), mirror, c, depth + 1, total);
                } else {
                    let bent = add(d.map(|x| k * x), n, k * cos - rest.sqrt());
                    out += kt * self.light_along(add(p, n, -self.step), bent, c, depth + 1, total);
                }
            }
        }
        out
    }

    /// max(0, n·l)·V.
    fn arrives(&self, p: Vec3, n: Vec3, lamp: Vec3, c: usize) -> f64 {
        let way = add(lamp, p, -1.0);
        let distance = dot(way, way).sqrt();
        let l = unit(way);
        let cos = dot(n, l);
        if cos <= 0.0 {
            return 0.0;
        }
        let hits = self.hits(add(p, n, self.step), l);
        let between = hits.iter().filter(|h| h.t < distance);
        cos * between.map(|h| h.optics.kt[c]).product::<f64>()
    }

    /// All there is along a ray, in order.
    fn hits(&self, o: Vec3, d: Vec3) -> Vec<Hit> {
        let render = self.scene.render.expect("a render record");
        let mut hits = self.boundary(render.root, o, d, (None, None));
        hits.retain(|h| {
            let p = add(o, d, h.t);
            h.t > self.step
                && render
                    .clip
                    .is_none_or(|(min, max)| (0..3).all(|i| min[i] <= p[i] && p[i] <= max[i]))
        });
        hits.sort_by(|a, b| a.t.total_cmp(&b.t));
        hits
    }

    fn index(&self, p: Vec3) -> Rgb {
        let root = self.scene.render.expect("a render record").root;
        if self.holds(root, p) {
            self.medium(root, p, (None, None)).1
        } else {
            [1.0; 3]
        }
    }

    fn matrix(&self, matrix: u32) -> (&Matrix, Matrix) {
        let m = &self.scene.matrices[matrix as usize];
        (m, m.inverse().expect("an invertible matrix"))
    }

    /// Whether a point lies in the node's solids.
    fn holds(&self, node: NodeId, p: Vec3) -> bool {
        match self.scene.nodes[node as usize] {
            Node::Shape(s) => shapes::inside(&self.scene.shapes[s as usize].geometry, p),
            Node::Union(a, b) => self.holds(a, p) || self.holds(b, p),
            Node::Intersection(a, b) => self.holds(a, p) && self.holds(b, p),
            Node::Difference(a, b) => self.holds(a, p) && !self.holds(b, p),
            Node::Complement(a) => !self.holds(a, p),
            Node::Transform { child, matrix } => self.holds(child, self.matrix(matrix).1.point(p)),
            Node::Paint { child, .. } | Node::Copy { child, .. } => self.holds(child, p),
        }
    }

    /// The operand that a point belongs to.
    fn owner(&self, node: NodeId, p: Vec3) -> NodeId {
        match self.scene.nodes[node as usize] {
            Node::Union(a, b) if !self.holds(a, p) && self.holds(b, p) => b,
            Node::Union(a, _) | Node::Intersection(a, _) | Node::Difference(a, _) => a,
            Node::Complement(a) => a,
            _ => node,
        }
    }

    fn over(&self, over: Over, paint: u32) -> Over {
        let paint = &self.scene.paints[paint as usize];
        (over.0.or(paint.optics), over.1.or(paint.index))
    }

    /// Optics and index at a point of a node.
    fn medium(&self, node: NodeId, p: Vec3, over: Over) -> (Optics, Rgb) {
        match self.scene.nodes[node as usize] {
            Node::Shape(_) => (over.0.unwrap_or_default(), over.1.unwrap_or([1.0; 3])),
            Node::Transform { child, matrix } => {
                self.medium(child, self.matrix(matrix).1.point(p), over)
            }
            Node::Paint { child, paint } => self.medium(child, p, self.over(over, paint)),
            Node::Copy { child, .. } => self.medium(child, p, over),
            _ => self.medium(self.owner(node, p), p, over),
        }
    }

    /// The colour that a point of a node has, on a face with these surface coordinates.
    fn colour(&self, node: NodeId, p: Vec3, uv: [f64; 2]) -> Rgb {
        match self.scene.nodes[node as usize] {
            Node::Shape(_) => [1.0; 3],
            Node::Transform { child, matrix } => {
                self.colour(child, self.matrix(matrix).1.point(p), uv)
            }
            Node::Copy { child, .. } => self.colour(child, p, uv),
            Node::Paint { child, paint } => match &self.scene.paints[paint as usize].texture {
                Some(t) => texture(t, p, uv),
                None => self.colour(child, p, uv),
            },
            _ => self.colour(self.owner(node, p), p, uv),
        }
    }

    /// Where a line crosses the boundary of a node, in any order.
    fn boundary(&self, node: NodeId, o: Vec3, d: Vec3, over: Over) -> Vec<Hit> {
        let at = |h: &Hit| add(o, d, h.t);
        match self.scene.nodes[node as usize] {
            Node::Shape(s) => {
                let geometry = &self.scene.shapes[s as usize].geometry;
                let hit = |c: shapes::Crossing| Hit {
                    t: c.t,
                    normal: c.normal,
                    uv: c.uv,
                    surface: !geometry.is_solid(),
                    colour: [1.0; 3],
                    optics: over.0.unwrap_or_default(),
                };
                shapes::crossings(geometry, o, d)
                    .into_iter()
                    .map(hit)
                    .collect()
            }
            Node::Union(a, b) => {
                let mut hits = self.boundary(a, o, d, over);
                hits.retain(|h| {
                    let p = at(h);
                    h.surface || !self.holds(b, p) || {
                        let inner = add(p, h.normal, -self.step);
                        self.medium(a, inner, over) != self.medium(b, p, over)
                    }
                });
                let others = self.boundary(b, o, d, over).into_iter();
                hits.extend(others.filter(|h| h.surface || !self.holds(a, at(h))));
                hits
            }
            Node::Intersection(a, b) => {
                let mut hits = self.boundary(a, o, d, over);
                hits.retain(|h| self.holds(b, at(h)));
                let others = self.boundary(b, o, d, over).into_iter();
                hits.extend(others.filter(|h| self.holds(a, at(h))));
                hits
            }
            Node::Difference(a, b) => {
                let mut hits = self.boundary(a, o, d, over);
                hits.retain(|h| !self.holds(b, at(h)));
                let cuts = self.boundary(b, o, d, (None, None)).into_iter();
                hits.extend(
                    cuts.filter(|h| !h.surface && self.holds(a, at(h)))
                        .map(|h| Hit {
                            normal: h.normal.map(|x| -x),
                            colour: self.colour(a, at(&h), h.uv),
                            optics: self.medium(a, at(&h), over).0,
                            ..h
                        }),
                );
                hits
            }
            Node::Complement(a) => {
                let mut hits = self.boundary(a, o, d, over);
                hits.retain(|h| !h.surface);
                hits.iter_mut()
                    .for_each(|h| h.normal = h.normal.map(|x| -x));
                hits
            }
            Node::Copy { child, .. } => self.boundary(child, o, d, over),
            Node::Transform { child, matrix } => {
                let back = self.matrix(matrix).1;
                let mut hits = self.boundary(child, back.point(o), back.vector(d), over);
                for h in &mut hits {
                    // The transposed inverse.
                    h.normal = unit(std::array::from_fn(|i| {
                        (0..3).map(|j| back.0[j][i] * h.normal[j]).sum()
                    }));
                }
                hits
            }
            Node::Paint { child, paint } => {
                let mut hits = self.boundary(child, o, d, self.over(over, paint));
                if let Some(t) = &self.scene.paints[paint as usize].texture {
                    for h in &mut hits {
                        h.colour = texture(t, add(o, d, h.t), h.uv);
                    }
                }
                hits
            }
        }
    }
}

fn texture(texture: &Texture, p: Vec3, uv: [f64; 2]) -> Rgb {
    let pick = |sum: f64, colours: &[Rgb; 2]| colours[sum.rem_euclid(2.0) as usize];
    match texture {
        Texture::Colour(c) => *c,
        Texture::Checkerboard { n, m, colours } => pick(
            (uv[0] * f64::from(*n)).floor() + (uv[1] * f64::from(*m)).floor(),
            colours,
        ),
        Texture::Solid { colours, size } => {
            pick(p.iter().map(|x| (x / size).floor()).sum(), colours)
        }
        Texture::Image { .. } => panic!("the naive evaluator does not know images"),
    }
}
