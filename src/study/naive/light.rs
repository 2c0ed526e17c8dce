//! Camera rays and light, as the language defines them.

use super::form;
use super::number::{Number, Ray, V, add, cross, dot, scale, sub, unit, vector};
use super::trail::{Event, List, Trail};
use crate::geometry::Matrix;
use crate::geometry::array::each;
use crate::scene::{Camera, DEFAULT_COLOUR, DEFAULT_INDEX, Optics, Rgb, Scene, Texture};
use crate::trace::bitmap::Bitmap;
use std::sync::Arc;

/// A camera that sends rays through the points of its picture.
pub struct Lens<T> {
    size: [T; 2],
    pub position: V<T>,
    forward: V<T>,
    right: V<T>,
    up: V<T>,
    /// The map from clip coordinates to the scene.
    back: Option<[[T; 4]; 4]>,
}

impl<T: Number> Lens<T> {
    /// The camera of a picture of this size; `None` if its projection has no inverse.
    pub fn new(camera: &Camera, width: u32, height: u32) -> Option<Lens<T>> {
        let position = vector(camera.position);
        let forward = unit(vector::<T>(camera.direction));
        let right = unit(cross(forward, unit(vector(camera.up))));
        let up = cross(right, forward);
        let (w, h) = (f64::from(width), f64::from(height));
        let half = libm::tan(camera.fovy.to_radians() / 2.0);
        let back = match &camera.projection {
            None => None,
            Some(projection) => {
                let row = |v: V<T>| {
                    let w = -dot(v, position);
                    [v[0], v[1], v[2], w]
                };
                let o = T::of(0.0);
                let backward = forward.map(|x| -x);
                let view = [row(right), row(up), row(backward), [o, o, o, T::of(1.0)]];
                let p = projection.0.map(|row| row.map(T::of));
                let product = p.map(|row| {
                    each([0, 1, 2, 3], |j| {
                        (0..4).fold(o, |sum, k| sum + row[k] * view[k][j])
                    })
                });
                Some(inverse(product)?)
            }
        };
        Some(Lens {
            size: [T::of(w), T::of(h)],
            position,
            forward,
            right: scale(right, T::of(half) * T::of(w) / T::of(h)),
            up: scale(up, T::of(half)),
            back,
        })
    }

    /// The ray through a point of the picture, in pixels.
    pub fn ray(&self, x: f64, y: f64) -> Ray<T> {
        let (one, two) = (T::of(1.0), T::of(2.0));
        let ndc = [
            two * T::of(x) / self.size[0] - one,
            one - two * T::of(y) / self.size[1],
        ];
        let Some(back) = &self.back else {
            let across = add(scale(self.right, ndc[0]), scale(self.up, ndc[1]));
            return Ray {
                origin: self.position,
                direction: unit(add(self.forward, across)),
            };
        };
        let unproject = |z: f64| {
            let [x, y, z, w] = each(*back, |r: [T; 4]| {
                r[0] * ndc[0] + r[1] * ndc[1] + r[2] * T::of(z) + r[3]
            });
            [x / w, y / w, z / w]
        };
        let (near, far) = (unproject(-1.0), unproject(1.0));
        Ray {
            origin: near,
            direction: unit(sub(far, near)),
        }
    }
}

/// The inverse by Gauss and Jordan's elimination, with the largest pivot of each column; `None` where a pivot is zero.
fn inverse<T: Number>(m: [[T; 4]; 4]) -> Option<[[T; 4]; 4]> {
    let (o, l) = (T::of(0.0), T::of(1.0));
    let mut left = m;
    let mut right: [[T; 4]; 4] =
        std::array::from_fn(|i| std::array::from_fn(|j| if i == j { l } else { o }));
    for c in 0..4 {
        let mut pivot = c;
        for r in c..4 {
            if left[r][c].abs() > left[pivot][c].abs() {
                pivot = r;
            }
        }
        if left[pivot][c] == o {
            return None;
        }
        left.swap(c, pivot);
        right.swap(c, pivot);
        let by = left[c][c];
        left[c] = left[c].map(|x| x / by);
        right[c] = right[c].map(|x| x / by);
        for r in (0..4).filter(|&r| r != c) {
            let by = left[r][c];
            for j in 0..4 {
                left[r][j] = left[r][j] - by * left[c][j];
                right[r][j] = right[r][j] - by * right[c][j];
            }
        }
    }
    Some(right)
}

/// The first three rows of a map's inverse, computed in numbers of the kind `T`. `None` if the map has no inverse.
pub fn back<T: Number>(matrix: &Matrix) -> Option<[[T; 4]; 3]> {
    let [a, b, c, _] = inverse(matrix.0.map(|row| row.map(T::of)))?;
    Some([a, b, c])
}

/// The solids of a scene, as rays ask about them.
pub trait World<T: Number> {
    /// The first boundary or sheet in (from, to] of a ray that starts outside of all solids; `Some(None)` if it meets
    /// nothing. `None` if the world has no quick answer: then [`World::events`] has to be asked.
    fn first_from_outside(&mut self, ray: &Ray<T>, from: T, to: T) -> Option<Option<Event<T>>>;

    /// Whether a ray that starts outside of all solids meets something opaque in (from, to]. `None` if the world has no
    /// quick answer, or the ray meets something that lets light through.
    fn is_blocked(&mut self, _ray: &Ray<T>, _from: T, _to: T) -> Option<bool> {
        None
    }

    /// All events of a ray that may matter in (from, to]. If `to` is infinite, at least those up to the first visible
    /// one.
    fn events(&mut self, ray: &Ray<T>, from: T, to: T) -> List<T>;

    /// The trail of the last ray asked about.
    fn trail(&self) -> &Trail<T>;

    /// The outward normal of a shape that was crossed, in its space, of any length.
    fn normal(&self, shape: u32, point: V<T>, face: u32) -> V<T>;
}

/// The parts of a scene that a picture depends on besides its solids.
pub struct Scenery<'s, T> {
    pub scene: &'s Scene,
    pub textures: Vec<(&'s Texture, Option<Arc<Bitmap>>)>,
    /// For each shape of the world, the number of its record in the scene.
    pub records: Vec<u32>,
    pub ambient: V<T>,
    /// Position and power of each point light.
    pub lights: Vec<(V<T>, V<T>)>,
    pub background: V<T>,
    pub clip: Option<[V<T>; 2]>,
    pub depth: u32,
    pub cutoff: f64,
}

impl<'s, T: Number> Scenery<'s, T> {
    pub fn new(scene: &'s Scene, depth: u32, cutoff: f64) -> Scenery<'s, T> {
        let lights: Vec<_> = (scene.point_lights.iter())
            .map(|l| {
                let power = scale(vector(l.colour), T::of(l.intensity));
                (vector(l.position), power)
            })
            .collect();
        let ambient = (scene.ambient_lights.iter()).fold(vector([0.0; 3]), |sum, l| {
            add(sum, scale(vector(l.colour), T::of(l.intensity)))
        });
        let render = scene.render;
        Scenery {
            scene,
            textures: Vec::new(),
            records: Vec::new(),
            ambient,
            lights,
            background: vector(render.map_or([0.0; 3], |r| r.background)),
            clip: render
                .and_then(|r| r.clip)
                .map(|(a, b)| [vector(a), vector(b)]),
            depth,
            cutoff,
        }
    }

    /// The part of (from, to] in which the ray is in the render box; `None` if there is no such part.
    pub fn window(&self, ray: &Ray<T>, mut from: T, mut to: T) -> Option<(T, T)> {
        let Some([min, max]) = &self.clip else {
            return Some((from, to));
        };
        for i in 0..3 {
            let (o, d) = (ray.origin[i], ray.direction[i]);
            if d == T::of(0.0) {
                if o < min[i] || o > max[i] {
                    return None;
                }
                continue;
            }
            let (mut a, mut b) = ((min[i] - o) / d, (max[i] - o) / d);
            if a > b {
                (a, b) = (b, a);
            }
            if a > from {
                from = a;
            }
            if b < to {
                to = b;
            }
        }
        (from <= to).then_some((from, to))
    }
}

/// A ray whose light is still to be followed.
struct Branch<T> {
    ray: Ray<T>,
    from: T,
    outside: bool,
    weight: V<T>,
    depth: u32,
}

/// A visible point.
struct SurfacePoint<T> {
    point: V<T>,
    /// The unit normal towards the side that the ray came from.
    facing: V<T>,
    optics: Optics,
    colour: Rgb,
    /// The refractive indices before and behind the surface, for each channel.
    indices: [Rgb; 2],
    /// Whether there is a solid before and behind the surface.
    inside: [bool; 2],
}

/// Counts of the rays that were sent.
#[derive(Debug, Clone, Copy, Default)]
pub struct RayCounts {
    /// The numbers of camera, shadow, reflection and refraction rays, in this order.
    pub sent: [u64; 4],
    /// The number of total reflections. Channels with the same refractive indices count as one.
    pub totally_reflected: u64,
}

/// The light that arrives along a camera ray, in linear RGB. `outside`: the ray starts outside of all solids.
pub fn radiance<T: Number, W: World<T>>(
    scenery: &Scenery<T>,
    world: &mut W,
    ray: Ray<T>,
    outside: bool,
    rays: &mut RayCounts,
) -> Rgb {
    let zero = T::of(0.0);
    let mut sum = [zero; 3];
    rays.sent[0] += 1;
    let mut branches = vec![Branch {
        ray,
        from: zero,
        outside,
        weight: vector([1.0; 3]),
        depth: 0,
    }];
    while let Some(branch) = branches.pop() {
        let Some(found) = first(scenery, world, &branch) else {
            sum = each([0, 1, 2], |c| {
                sum[c] + scenery.background[c] * branch.weight[c]
            });
            continue;
        };
        follow(scenery, &branch, &found, &mut branches, rays);
        let light = direct(scenery, world, &found, rays);
        sum = each([0, 1, 2], |c| sum[c] + light[c] * branch.weight[c]);
    }
    each(sum, T::wide)
}

fn first<T: Number, W: World<T>>(
    scenery: &Scenery<T>,
    world: &mut W,
    branch: &Branch<T>,
) -> Option<SurfacePoint<T>> {
    let ray = &branch.ray;
    let (from, to) = scenery.window(ray, branch.from, T::of(f64::INFINITY))?;
    if branch.outside
        && scenery.clip.is_none()
        && let Some(event) = world.first_from_outside(ray, from, to)
    {
        let event = event?;
        let trail = world.trail();
        if trail.media.optics(trail.look(event.owner)).kt == [0.0; 3] {
            let inside = [false, !event.sheet];
            return Some(located(scenery, world, ray, &event, None, inside));
        }
    }
    let list = world.events(ray, from, to);
    let mut before = list.start;
    let mut seen = None;
    for event in &list.events {
        if event.t > to {
            break;
        }
        if event.t > from && event.seen {
            seen = Some(event);
            break;
        }
        before = event.after;
    }
    let event = seen?;
    let inside = [before.is_some(), event.after.is_some()];
    Some(located(scenery, world, ray, event, before, inside))
}

fn located<T: Number, W: World<T>>(
    scenery: &Scenery<T>,
    world: &W,
    ray: &Ray<T>,
    event: &Event<T>,
    before: Option<u32>,
    inside: [bool; 2],
) -> SurfacePoint<T> {
    let trail = world.trail();
    let leaf = trail.leaves[event.leaf as usize];
    let owner = trail.leaves[event.owner as usize];
    let local = trail.frames[leaf.frame as usize].ray.at(event.t);
    let geometry = &scenery.scene.shapes[scenery.records[leaf.shape as usize] as usize].geometry;
    let normal = world.normal(leaf.shape, local, event.face);
    let normal = unit(trail.normal(leaf.frame, normal));
    let coarse = each(local, T::wide);
    let mut shading = normal;
    if let Some(own) = form::shading_normal(geometry, coarse) {
        let own = unit(trail.normal(leaf.frame, vector(own)));
        let cosine = dot(own, normal);
        if cosine.abs() > T::of(16.0 * f64::EPSILON) {
            shading = if cosine > T::of(0.0) {
                own
            } else {
                each(own, |x| -x)
            };
        }
    }
    let entering = dot(normal, ray.direction) < T::of(0.0);
    let facing = if entering {
        shading
    } else {
        each(shading, |x| -x)
    };
    let optics = *trail.media.optics(&owner.look);
    let colour = match owner.look.texture {
        _ if optics.kd == [0.0; 3] => DEFAULT_COLOUR,
        None if event.leaf == event.owner => {
            form::own_colour(geometry, coarse, event.face).unwrap_or(DEFAULT_COLOUR)
        }
        None => DEFAULT_COLOUR,
        Some((texture, frame)) => {
            let uv = || form::uv(geometry, coarse, event.face);
            match &scenery.textures[texture as usize] {
                (Texture::Colour(colour), _) => *colour,
                (Texture::Checkerboard { n, m, colours }, _) => {
                    let [u, v] = uv();
                    Texture::cell_colour(colours, &[u * f64::from(*n), v * f64::from(*m)])
                }
                (Texture::Solid { colours, size }, _) => {
                    let place = trail.frames[frame as usize].ray.at(event.t);
                    Texture::cell_colour(colours, &each(place, |x| x.wide() / *size))
                }
                (Texture::Image { .. }, Some(bitmap)) => bitmap.colour(uv()),
                (Texture::Image { .. }, None) => DEFAULT_COLOUR,
            }
        }
    };
    let index = |medium: Option<u32>| {
        medium.map_or(DEFAULT_INDEX, |leaf| trail.media.index(trail.look(leaf)))
    };
    SurfacePoint {
        point: ray.at(event.t),
        facing,
        optics,
        colour,
        indices: [index(before), index(event.after)],
        inside,
    }
}

fn direct<T: Number, W: World<T>>(
    scenery: &Scenery<T>,
    world: &mut W,
    found: &SurfacePoint<T>,
    rays: &mut RayCounts,
) -> V<T> {
    let zero = T::of(0.0);
    let albedo: V<T> = each([0, 1, 2], |c| {
        T::of(found.optics.kd[c]) * T::of(found.colour[c])
    });
    if albedo.iter().all(|&x| x == zero) {
        return [zero; 3];
    }
    let mut light = scenery.ambient;
    for &(position, power) in &scenery.lights {
        let way = sub(position, found.point);
        let cosine = dot(found.facing, unit(way));
        if cosine > zero && power.iter().any(|&x| x != zero) {
            let ray = Ray {
                origin: found.point,
                direction: way,
            };
            rays.sent[1] += 1;
            let seen = visibility(scenery, world, &ray, !found.inside[0]);
            light = each([0, 1, 2], |c| light[c] + power[c] * seen[c] * cosine);
        }
    }
    each([0, 1, 2], |c| albedo[c] * light[c])
}

/// The share of a light's power that reaches a point, for each channel: the product of kt over all surfaces on the way.
/// The light is at t = 1. A surface that the light lies on does not count.
fn visibility<T: Number, W: World<T>>(
    scenery: &Scenery<T>,
    world: &mut W,
    ray: &Ray<T>,
    outside: bool,
) -> V<T> {
    let one = vector([1.0; 3]);
    // A textbook's offset is a distance, and is turned into t here.
    let offset = match T::OFFSET_IS_RELATIVE {
        true => ray.offset(),
        false => T::OFFSET / dot(ray.direction, ray.direction).sqrt(),
    };
    let Some((from, to)) = scenery.window(ray, offset, T::of(1.0) - T::LAMP) else {
        return one;
    };
    if outside
        && scenery.clip.is_none()
        && let Some(blocked) = world.is_blocked(ray, from, to)
    {
        return vector([if blocked { 0.0 } else { 1.0 }; 3]);
    }
    let list = world.events(ray, from, to);
    let mut seen = one;
    for event in list
        .events
        .iter()
        .filter(|e| e.seen && e.t > from && e.t <= to)
    {
        let trail = world.trail();
        let kt = trail.media.optics(trail.look(event.owner)).kt;
        seen = each([0, 1, 2], |c| seen[c] * T::of(kt[c]));
    }
    seen
}

fn follow<T: Number>(
    scenery: &Scenery<T>,
    branch: &Branch<T>,
    found: &SurfacePoint<T>,
    branches: &mut Vec<Branch<T>>,
    rays: &mut RayCounts,
) {
    let (zero, one) = (T::of(0.0), T::of(1.0));
    let d = branch.ray.direction;
    let mut send = |direction: V<T>, share: V<T>, onwards: bool, depth: u32, kind: usize| {
        let weight: V<T> = each([0, 1, 2], |c| branch.weight[c] * share[c]);
        let largest = weight
            .into_iter()
            .fold(zero, |m, x| if x > m { x } else { m });
        if largest > zero && largest >= T::of(scenery.cutoff) && depth <= scenery.depth {
            let ray = Ray {
                origin: found.point,
                direction,
            };
            rays.sent[kind] += 1;
            branches.push(Branch {
                from: ray.offset(),
                ray,
                outside: !found.inside[usize::from(onwards)],
                weight,
                depth,
            });
        }
    };
    let n = found.facing;
    let mut mirrored: V<T> = vector(found.optics.ks);
    let mut todo = found.optics.kt;
    while let Some(c) = (0..3).find(|&c| todo[c] != 0.0) {
        let ratio = |c: usize| (found.indices[0][c], found.indices[1][c]);
        let mut through = [zero; 3];
        for other in (c..3).filter(|&o| ratio(o) == ratio(c)) {
            through[other] = T::of(std::mem::take(&mut todo[other]));
        }
        let (before, behind) = ratio(c);
        if before == behind {
            send(d, through, true, branch.depth, 3);
            continue;
        }
        let ratio = T::of(before) / T::of(behind);
        let cosine = -dot(d, n);
        let sine = one - cosine * cosine;
        let square = one - ratio * ratio * if sine > zero { sine } else { zero };
        if square > zero {
            let bent = add(scale(d, ratio), scale(n, ratio * cosine - square.sqrt()));
            send(unit(bent), through, true, branch.depth + 1, 3);
        } else {
            rays.totally_reflected += 1;
            mirrored = add(mirrored, through);
        }
    }
    if mirrored.iter().any(|&x| x > zero) {
        let reflected = sub(d, scale(n, T::of(2.0) * dot(n, d)));
        send(unit(reflected), mirrored, false, branch.depth + 1, 2);
    }
}
