//! A ray tracer as textbooks have it, to see what becomes of hard scenes: the quadratic formula with
//! b² − 4ac, a quartic in closed form, coefficients from the ray's origin wherever that is, and one
//! constant distance within which a ray does not see the surface it leaves. Everything is computed
//! in one kind of number, single or double precision.
//!
//! It draws the light, the cameras and the solids of the language but no triangles, geodesic
//! spheres, images, solid textures, vertex colours, clipping boxes or dispersion, and shares nothing
//! with the program but the resolved scene.

mod number;
mod polynomial;
mod shapes;
mod solid;

use number::{Ray, V, add, cross, dot, scale, sub, unit, vector};
use rayon::prelude::*;
use solid::{Hit, Solids};
use zpg::geometry::Matrix;
use zpg::scene::{Camera, DEFAULT_COLOUR, DEFAULT_INDEX, Optics, Scene, Texture};

pub use number::Number;

/// How often a ray may be reflected or refracted.
const DEPTH: u32 = 10;

/// A scene made ready for drawing.
pub struct Naive<'s, T> {
    scene: &'s Scene,
    solids: Solids<'s, T>,
    root: u32,
    background: V<T>,
}

/// Position and power.
type Lights<T> = Vec<(V<T>, V<T>)>;

/// The rays of a camera's picture.
struct Lens<T> {
    size: [T; 2],
    position: V<T>,
    forward: V<T>,
    right: V<T>,
    up: V<T>,
    /// From clip coordinates to the scene.
    back: Option<[[T; 4]; 4]>,
}

impl<T: Number> Lens<T> {
    fn new(camera: &Camera, width: u32, height: u32) -> Option<Lens<T>> {
        let position = vector(camera.position);
        let forward = unit(vector::<T>(camera.direction));
        let right = unit(cross(forward, unit(vector(camera.up))));
        let up = cross(right, forward);
        let (w, h) = (f64::from(width), f64::from(height));
        let half = (camera.fovy.to_radians() / 2.0).tan();
        let back = match &camera.projection {
            None => None,
            Some(projection) => {
                let row = |v: V<T>| {
                    let w = -dot(v, position);
                    [v[0], v[1], v[2], w].map(T::wide)
                };
                let backward = forward.map(|x| -x);
                let view = [row(right), row(up), row(backward), [0.0, 0.0, 0.0, 1.0]];
                let inverse = projection.after(&Matrix(view)).inverse()?;
                Some(inverse.0.map(|row| row.map(T::of)))
            }
        };
        Some(Lens {
            size: [T::of(w), T::of(h)],
            position,
            forward,
            right: scale(right, T::of(half * w / h)),
            up: scale(up, T::of(half)),
            back,
        })
    }

    /// The ray through the centre of a pixel.
    fn ray(&self, x: u32, y: u32) -> Ray<T> {
        let centre = |i: u32| T::of(f64::from(i) + 0.5);
        let (one, two) = (T::of(1.0), T::of(2.0));
        let ndc = [
            two * centre(x) / self.size[0] - one,
            one - two * centre(y) / self.size[1],
        ];
        let Some(back) = &self.back else {
            let across = add(scale(self.right, ndc[0]), scale(self.up, ndc[1]));
            return Ray {
                origin: self.position,
                direction: unit(add(self.forward, across)),
            };
        };
        let unproject = |z: f64| {
            let [x, y, z, w] = back.map(|r| r[0] * ndc[0] + r[1] * ndc[1] + r[2] * T::of(z) + r[3]);
            [x / w, y / w, z / w]
        };
        let (near, far) = (unproject(-1.0), unproject(1.0));
        Ray {
            origin: near,
            direction: unit(sub(far, near)),
        }
    }
}

impl<'s, T: Number> Naive<'s, T> {
    /// # Errors
    ///
    /// Says what it is about the scene that this ray tracer does not know.
    pub fn new(scene: &'s Scene) -> Result<Naive<'s, T>, String> {
        let render = scene.render.ok_or("there is no render record")?;
        if render.clip.is_some() {
            return Err("the scene has a clipping box".into());
        }
        Ok(Naive {
            scene,
            solids: Solids::new(scene)?,
            root: render.root,
            background: vector(render.background),
        })
    }

    /// Linear RGB, row by row from the top, through the centres of the pixels.
    ///
    /// # Errors
    ///
    /// A projection matrix without inverse.
    pub fn render(&self, camera: &Camera, size: [u32; 2]) -> Result<Vec<[f32; 3]>, String> {
        let [width, height] = size;
        let lens = Lens::new(camera, width, height).ok_or("a singular projection")?;
        let scene = self.scene;
        let mut lights: Lights<T> = (scene.point_lights.iter())
            .map(|l| {
                let power = scale(vector(l.colour), T::of(l.intensity));
                (vector(l.position), power)
            })
            .collect();
        if lights.is_empty() && scene.ambient_lights.is_empty() {
            lights.push((lens.position, vector([1.0; 3])));
        }
        Ok((0..width * height)
            .into_par_iter()
            .map(|i| {
                let ray = lens.ray(i % width, i / width);
                let light = self.radiance(&ray, &lights, 0);
                light.map(|x| x.wide().max(0.0) as f32)
            })
            .collect())
    }

    fn radiance(&self, ray: &Ray<T>, lights: &Lights<T>, depth: u32) -> V<T> {
        let zero = T::of(0.0);
        if depth > DEPTH {
            return [zero; 3];
        }
        let hits = self.solids.crossings(self.root, ray);
        let Some(hit) = hits.list.iter().find(|hit| hit.t > T::OFFSET) else {
            return self.background;
        };
        let point = ray.at(hit.t);
        let outward = unit(hit.normal);
        let entering = dot(outward, ray.direction) < zero;
        let normal = if entering {
            outward
        } else {
            outward.map(|x| -x)
        };
        let optics = hit.look.optics.unwrap_or_default();
        let mut light = self.direct(hit, &optics, point, normal, lights);
        let mut mirrored: V<T> = vector(optics.ks);
        let through: V<T> = vector(optics.kt);
        let is_any = |v: V<T>| v.iter().any(|&x| x > zero);
        let mut gather = |direction: V<T>, share: V<T>, depth: u32| {
            let origin = point;
            let seen = self.radiance(&Ray { origin, direction }, lights, depth);
            light = [0, 1, 2].map(|c| light[c] + share[c] * seen[c]);
        };
        if is_any(through) {
            let index = T::of(hit.look.index.unwrap_or(DEFAULT_INDEX)[0]);
            let one = T::of(1.0);
            let ratio = if entering { one / index } else { index };
            let cosine = -dot(normal, ray.direction);
            let square = one - ratio * ratio * (one - cosine * cosine);
            if hit.sheet || index == one {
                gather(ray.direction, through, depth);
            } else if square > zero {
                let across = scale(normal, ratio * cosine - square.sqrt());
                let refracted = unit(add(scale(ray.direction, ratio), across));
                gather(refracted, through, depth + 1);
            } else {
                mirrored = add(mirrored, through);
            }
        }
        if is_any(mirrored) {
            let twice = T::of(2.0) * dot(normal, ray.direction);
            let reflected = unit(sub(ray.direction, scale(normal, twice)));
            gather(reflected, mirrored, depth + 1);
        }
        light
    }

    fn direct(
        &self,
        hit: &Hit<T>,
        optics: &Optics,
        point: V<T>,
        normal: V<T>,
        lights: &Lights<T>,
    ) -> V<T> {
        let zero = T::of(0.0);
        let mut light = [zero; 3];
        for ambient in &self.scene.ambient_lights {
            light = add(
                light,
                scale(vector(ambient.colour), T::of(ambient.intensity)),
            );
        }
        for &(position, power) in lights {
            let way = sub(position, point);
            let distance = dot(way, way).sqrt();
            let direction = unit(way);
            let cosine = dot(normal, direction);
            if cosine > zero {
                let seen = self.visibility(point, direction, distance);
                light = [0, 1, 2].map(|c| light[c] + power[c] * seen[c] * cosine);
            }
        }
        let colour: V<T> = vector(colour(hit));
        [0, 1, 2].map(|c| T::of(optics.kd[c]) * colour[c] * light[c])
    }

    /// The product of kt over everything on the way to a light.
    fn visibility(&self, origin: V<T>, direction: V<T>, distance: T) -> V<T> {
        let hits = self.solids.crossings(self.root, &Ray { origin, direction });
        let between = |hit: &&Hit<T>| hit.t > T::OFFSET && hit.t < distance;
        let mut seen = vector([1.0; 3]);
        for hit in hits.list.iter().filter(between) {
            let kt: V<T> = vector(hit.look.optics.unwrap_or_default().kt);
            seen = [0, 1, 2].map(|c| seen[c] * kt[c]);
        }
        seen
    }
}

fn colour<T: Number>(hit: &Hit<T>) -> [f64; 3] {
    match hit.look.texture {
        Some(Texture::Colour(colour)) => *colour,
        Some(Texture::Checkerboard { n, m, colours }) => {
            let cell = |x: T, count: u32| (x * T::of(f64::from(count))).floor();
            let sum = cell(hit.uv[0], *n) + cell(hit.uv[1], *m);
            let odd = sum - T::of(2.0) * (sum / T::of(2.0)).floor();
            colours[usize::from(odd > T::of(0.5))]
        }
        _ => DEFAULT_COLOUR,
    }
}
