//! Parts that a camera cannot see wherever it looks in its picture, since they lie behind the camera or beside the
//! picture; and the parts that a point is inside of.
//!
//! Both are about the parts of the outermost union, and use boxes that are never too small. So a part is beside the
//! picture if its box is. A part may be beside the picture without being known to be, since its box may be larger.

use super::LeftOut;
use super::members::{Member, members};
use crate::geometry::array::{cross, dot, sub, unit};
use crate::geometry::boxes::Boxes;
use crate::geometry::line::Line;
use crate::geometry::{Aabb, Matrix};
use crate::scene::{Camera, Node, NodeId, Scene, Vec3};
use crate::solids::bounds::NodeBounds;
use crate::solids::inside::Inside;
use crate::solids::shapes::facts::Facts;
use crate::solids::staging::Basis;
use crate::solids::within::{CLEARANCE_REL, far};
use crate::solids::{Named, named_core};
use crate::trace::camera::View;
use crate::trace::shapes::{Primitive, Roots};

/// The usual size of a picture, width and height in pixels: the default where the user gives none.
pub const USUAL: [u32; 2] = [640, 480];

/// Distance from the picture's border, as a share of the picture, at which a thing is beside the picture: far more than
/// rounding moves a ray.
const PICTURE_MARGIN: f64 = 0.01;

/// The least scalar product of two unit vectors that are meant to be at right angles: rounding may make it less than 0.
const UPRIGHT: f64 = -1e-15;

/// The most boxes that are asked about. Scenes with very many occurrences of shared parts have more, and get no answer.
const BOXES: usize = 1 << 14;

/// The side on which a part lies that a camera does not see.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum OutOfView {
    Behind,
    Left,
    Right,
    Above,
    Below,
    /// A part that lies on several of these sides, or across their borders.
    Beside,
}

/// The sides that can be told apart, in the order of preference.
const SIDES: [OutOfView; 5] = [
    OutOfView::Behind,
    OutOfView::Left,
    OutOfView::Right,
    OutOfView::Above,
    OutOfView::Below,
];

/// The field of a camera in a picture of the usual size: every ray starts between four places and goes between four
/// directions.
pub(super) struct Field {
    starts: [Vec3; 4],
    directions: [Vec3; 4],
    /// Directions that may lead into the field: forwards, inwards from its four sides, and along the axes.
    inwards: Vec<Vec3>,
}

impl Field {
    /// The field of view of a camera, a margin wider; `None` if the camera takes no pictures.
    pub(super) fn of(camera: &Camera) -> Option<Field> {
        let [width, height] = USUAL.map(f64::from);
        let view = View::new(camera, USUAL[0], USUAL[1])?;
        let (low, high) = (-PICTURE_MARGIN, 1.0 + PICTURE_MARGIN);
        let corners = [(low, low), (high, low), (high, high), (low, high)];
        let mut starts = [[0.0; 3]; 4];
        let mut directions = [[0.0; 3]; 4];
        for (i, (x, y)) in corners.into_iter().enumerate() {
            let ray = view.ray(x * width, y * height)?;
            (starts[i], directions[i]) = (ray.line.origin.0, ray.line.direction.0);
        }
        // The normal of the field's side through two neighbouring corners, towards the corners across.
        let side = |a: usize, b: usize| {
            let along = match starts[a] == starts[b] {
                true => directions[b],
                false => sub(starts[b], starts[a]),
            };
            let n = unit(cross(directions[a], along))?;
            let c = (b + 1) % 4;
            let across = match starts[a] == starts[c] {
                true => directions[c],
                false => sub(starts[c], starts[a]),
            };
            Some(if dot(n, across) < 0.0 {
                n.map(|x| -x)
            } else {
                n
            })
        };
        // Left, right, above, below, as in SIDES.
        let mut inwards = vec![
            Basis::of(camera)?.forward,
            side(3, 0)?,
            side(1, 2)?,
            side(0, 1)?,
            side(2, 3)?,
        ];
        for i in 0..3 {
            for sign in [-1.0, 1.0] {
                let mut axis = [0.0; 3];
                axis[i] = sign;
                inwards.push(axis);
            }
        }
        Some(Field {
            starts,
            directions,
            inwards,
        })
    }

    /// The side of the field on which all of a box lies, if it lies beside the field.
    pub(super) fn side(&self, b: &Aabb) -> Option<OutOfView> {
        let at = self.beyond(b).position(|is_beyond| is_beyond)?;
        Some(SIDES.get(at).copied().unwrap_or(OutOfView::Beside))
    }

    /// For each of the directions `inwards`, whether all of a box lies beyond the border of the field, against the
    /// direction.
    fn beyond(&self, b: &Aabb) -> impl Iterator<Item = bool> {
        self.inwards.iter().map(|n| {
            if !self.directions.iter().all(|d| dot(*n, *d) >= UPRIGHT) {
                return false;
            }
            let least = (self.starts.iter()).fold(f64::INFINITY, |m, s| m.min(dot(*n, *s)));
            let most: f64 = (0..3)
                .filter(|&i| n[i] != 0.0)
                .map(|i| (n[i] * b.min[i]).max(n[i] * b.max[i]))
                .sum();
            let size = self.starts.iter().map(far).fold(b.far(), f64::max);
            most + CLEARANCE_REL * size < least
        })
    }
}

/// The parts of the drawn scene that a camera is tested for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Parts {
    All,
    /// Parts that have an end: no planes, no half-spaces.
    Bounded,
}

/// The side of a camera's field on which all these parts of the drawn scene lie, if the camera sees nothing of them in
/// a picture of the usual size. `None` if it may see something, or if there are no parts.
pub fn out_of_view(
    scene: &Scene,
    bounds: &[NodeBounds],
    root: NodeId,
    camera: &Camera,
    of: Parts,
) -> Option<OutOfView> {
    let field = Field::of(camera)?;
    let clip = scene.render.and_then(|r| r.clip);
    let clip = clip.map_or(Aabb::ALL, |(min, max)| Aabb::new(min, max));
    // For each side, whether all parts that have been asked about lie there.
    let mut all = [true; SIDES.len()];
    let mut parts = 0;
    let is_beyond = |b: &Aabb| {
        let b = b.intersection(&clip);
        if b.is_empty() || of == Parts::Bounded && !b.is_bounded() {
            return true;
        }
        let beyond: Vec<bool> = field.beyond(&b).collect();
        if !beyond.contains(&true) {
            return false;
        }
        parts += 1;
        for (all, beyond) in all.iter_mut().zip(beyond) {
            *all &= beyond;
        }
        true
    };
    if !all_below(scene, bounds, root, is_beyond) || parts == 0 {
        return None;
    }
    let side = all.iter().position(|all| *all);
    Some(side.map_or(OutOfView::Beside, |i| SIDES[i]))
}

/// `left_out`, and also the parts of the outermost union that lie beside the view of every camera of the scene, in a
/// picture of the usual size. Mirrors and glass may show these parts all the same. `None` if no part lies beside the
/// views, if all do, or if no camera is written.
pub fn beside_all_views(
    scene: &Scene,
    bounds: &[NodeBounds],
    root: NodeId,
    left_out: &LeftOut,
) -> Option<LeftOut> {
    let fields: Option<Vec<Field>> = scene.cameras.iter().map(Field::of).collect();
    let fields = fields.filter(|f| !f.is_empty())?;
    let is_beside = |m: &&Member| fields.iter().all(|f| f.beyond(&m.bounds).any(|b| b));
    let parts = members(scene, bounds, root);
    let beside: Vec<&Member> = parts.iter().filter(is_beside).collect();
    if beside.is_empty() || beside.len() == parts.len() {
        return None;
    }
    let mut all = left_out.clone();
    beside.iter().for_each(|m| all.add(m.slot));
    Some(all)
}

/// Whether `is_true` holds for the boxes of all parts of the outermost union. If it holds for a box, it must hold for
/// all boxes inside; so the box around several parts is asked about first. `false` if there are too many boxes.
fn all_below(
    scene: &Scene,
    bounds: &[NodeBounds],
    root: NodeId,
    mut is_true: impl FnMut(&Aabb) -> bool,
) -> bool {
    let mut left = BOXES;
    let mut todo = vec![(root, Matrix::IDENTITY)];
    while let Some((node, matrix)) = todo.pop() {
        if left == 0 {
            return false;
        }
        left -= 1;
        match scene.nodes[node as usize] {
            Node::Transform { child, matrix: m } => {
                todo.push((child, matrix.after(&scene.matrices[m as usize])));
            }
            Node::Paint { child, .. } | Node::Copy { child, .. } => todo.push((child, matrix)),
            Node::Shape(s) if is_true(&scene.shapes[s as usize].geometry.bounds(&matrix)) => {}
            Node::Shape(_) => return false,
            // A union without bounds is asked about part by part.
            Node::Union(a, b) if !bounds[node as usize].all.is_bounded() => {
                todo.extend([(a, matrix), (b, matrix)]);
            }
            _ if is_true(&bounds[node as usize].all.transformed(&matrix)) => {}
            Node::Union(a, b) => todo.extend([(a, matrix), (b, matrix)]),
            _ => return false,
        }
    }
    true
}

/// An opaque solid that holds a point.
#[derive(Debug, Clone, Copy)]
pub struct Held {
    pub solid: Named,
    /// Whether the point is on the surface, as far as rounding can tell.
    pub on_surface: bool,
}

/// The opaque solid that each point is in: the first part of the outermost union that holds the point with room around
/// it, or else the first one, solid or plane, that has it on its surface. `None` if there is none, or if a part that
/// lets light through comes before it in the union and may hold the point. If several parts together hold all that is
/// around a point, it is inside of the first of them. A part that the drawn region may cut open holds nothing.
pub fn held(
    scene: &Scene,
    bounds: &[NodeBounds],
    root: NodeId,
    points: &[Vec3],
) -> Vec<Option<Held>> {
    let clip = scene.render.and_then(|r| r.clip);
    let clip = clip.map_or(Aabb::ALL, |(min, max)| Aabb::new(min, max));
    let counts = |m: &Member| m.clear || clip.holds(&m.bounds);
    let holder = |asked: &mut Asked, point: &Vec3, near: &mut dyn Iterator<Item = &Member>| {
        let (mut first, mut all) = (None, [false; PLACES]);
        for part in near {
            // The first operand of a union owns the points that it holds.
            if part.clear && asked.may_hold(point, part) {
                break;
            }
            if part.clear {
                continue;
            }
            let Some(met) = asked.met(point, part) else {
                continue;
            };
            let is_inside = met.holds == [true; PLACES];
            if is_inside || first.is_none() {
                first = Some(met.solid);
            }
            (all.iter_mut().zip(met.holds)).for_each(|(all, holds)| *all |= holds);
            if is_inside {
                break;
            }
        }
        let on_surface = all != [true; PLACES];
        first.map(|solid| Held { solid, on_surface })
    };
    near_parts(scene, bounds, root, points, counts, holder)
}

/// Whether each point lies on the surface of a part of the outermost union, as far as rounding can tell. A point on a
/// piece of a surface that an operation has cut off may count, too.
pub fn on_surfaces(
    scene: &Scene,
    bounds: &[NodeBounds],
    root: NodeId,
    points: &[Vec3],
) -> Vec<bool> {
    let is_on = |asked: &mut Asked, point: &Vec3, mut near: &mut dyn Iterator<Item = &Member>| {
        (&mut near).any(|part| match asked.met(point, part) {
            Some(met) => met.holds != [true; PLACES],
            None => asked.is_on_sheet_within(point, part),
        })
    };
    near_parts(scene, bounds, root, points, |_| true, is_on)
}

/// Calls `ask` for each point with the parts of the outermost union that are near it and for which `counts` is true, in
/// their order. Returns the answers.
fn near_parts<T: Clone + Default>(
    scene: &Scene,
    bounds: &[NodeBounds],
    root: NodeId,
    points: &[Vec3],
    counts: impl Fn(&Member) -> bool,
    ask: impl Fn(&mut Asked, &Vec3, &mut dyn Iterator<Item = &Member>) -> T,
) -> Vec<T> {
    let mut out = vec![T::default(); points.len()];
    let around = |point: &Vec3| {
        let by = CLEARANCE_REL * far(point).max(1.0);
        Aabb::new(point.map(|x| x - by), point.map(|x| x + by))
    };
    // Often all points are outside of everything, and the parts need not be listed.
    let all = bounds[root as usize].all;
    if points
        .iter()
        .all(|p| all.intersection(&around(p)).is_empty())
    {
        return out;
    }
    let parts = members(scene, bounds, root);
    let numbered = parts.iter().enumerate().filter(|(_, m)| counts(m));
    let boxes = Boxes::new(numbered.map(|(i, m)| (i as u32, m.bounds)));
    let mut asked = Asked {
        scene,
        inside: Inside::new(scene, bounds),
        left: PAIRS,
    };
    for (out, point) in out.iter_mut().zip(points) {
        let mut near = Vec::new();
        boxes.near(&around(point), &mut near);
        near.sort_unstable();
        let mut near = near.iter().map(|&i| &parts[i as usize]);
        *out = ask(&mut asked, point, &mut near);
    }
    out
}

/// The most questions whether a part of the scene holds a point. Later ones are answered with "not known".
const PAIRS: usize = 1 << 18;

struct Asked<'a> {
    scene: &'a Scene,
    inside: Inside<'a>,
    left: usize,
}

impl Asked<'_> {
    /// Whether a point may be in a part; `true` if that is not known.
    fn may_hold(&mut self, point: &Vec3, part: &Member) -> bool {
        let back = part.matrix().inverse();
        let (Some(left), Some(back)) = (self.left.checked_sub(1), back) else {
            return true;
        };
        self.left = left;
        let (node, _) = self.scene.core(part.node, Matrix::IDENTITY);
        !part.sheet && self.inside.node(node, back.point(*point)) != Some(false)
    }

    /// How much a part holds of a point and the places around it. `None` if it holds none of these and has no surface
    /// there, or if that is not known.
    fn met(&mut self, point: &Vec3, part: &Member) -> Option<Met> {
        self.left = self.left.checked_sub(1)?;
        let scene = self.scene;
        let (solid, _) = named_core(scene, part.node)?;
        let back = part.matrix().inverse()?;
        let around = around(point, part);
        let mut holds = [false; PLACES];
        if part.sheet {
            let shape = Primitive::new(part.geometry(scene)?);
            return is_on_sheet(&shape, &back, *point, around).then_some(Met { solid, holds });
        }
        let (node, _) = scene.core(part.node, Matrix::IDENTITY);
        for (holds, place) in holds.iter_mut().zip(places_around(*point, around)) {
            *holds = self.inside.node(node, back.point(place))?;
        }
        holds.contains(&true).then_some(Met { solid, holds })
    }

    /// Whether a point is on a shape without inside that occurs anywhere in a part.
    fn is_on_sheet_within(&mut self, point: &Vec3, part: &Member) -> bool {
        let (core, _) = self.scene.core(part.node, Matrix::IDENTITY);
        let mut todo = vec![(core, *part.matrix())];
        while let Some((node, matrix)) = todo.pop() {
            let Some(left) = self.left.checked_sub(1) else {
                return false;
            };
            self.left = left;
            let node = self.scene.nodes[node as usize];
            let inner = match node {
                Node::Transform { matrix: m, .. } => matrix.after(&self.scene.matrices[m as usize]),
                _ => matrix,
            };
            if let Node::Shape(s) = node {
                let geometry = &self.scene.shapes[s as usize].geometry;
                let is_on = |back| {
                    let shape = Primitive::new(geometry);
                    is_on_sheet(&shape, &back, *point, around(point, part))
                };
                if !geometry.is_solid() && matrix.inverse().is_some_and(is_on) {
                    return true;
                }
            }
            todo.extend(node.children().map(|child| (child, inner)));
        }
        false
    }
}

/// The distance that rounding may have put between a point and a part's surface on which it is meant to lie.
fn around(point: &Vec3, part: &Member) -> f64 {
    // A part without bounds may be placed by numbers of any size. In most scenes they are about 1.
    let size = match part.bounds.is_bounded() {
        true => part.bounds.radius(),
        false => 1.0,
    };
    CLEARANCE_REL * far(point).max(size)
}

/// A part that holds a point or a place around it, or has the point on its surface.
struct Met {
    solid: Named,
    /// Whether each of the [places around](places_around) the point is in the part; none is in a surface without
    /// inside.
    holds: [bool; PLACES],
}

/// Whether `point` is on a shape that encloses nothing, give or take `around` along one of the axes. `back` maps from
/// the scene's coordinates to the shape's.
fn is_on_sheet(shape: &Primitive, back: &Matrix, point: Vec3, around: f64) -> bool {
    // The crossing of a ray that starts this far away is exact enough.
    let away = around / CLEARANCE_REL;
    (0..3).any(|i| {
        let (mut from, mut way) = (point, [0.0; 3]);
        from[i] -= away;
        way[i] = 1.0;
        let line = Line::new(back.point(from).into(), back.vector(way).into());
        let mut roots = Roots::<f64>::default();
        shape.intersect().crossings(&line, &mut roots);
        roots.list.iter().any(|r| (r.t - away).abs() <= around)
    })
}

/// How many places are asked about around a point.
const PLACES: usize = 15;

/// A point, the six places at the distance `by` from it along the axes, and the corners of the cube around these.
fn places_around(p: Vec3, by: f64) -> impl Iterator<Item = Vec3> {
    let aside = (0..6).map(move |i| {
        let mut q = p;
        q[i / 2] += if i % 2 == 0 { by } else { -by };
        q
    });
    let corners = Aabb::new(p.map(|x| x - by), p.map(|x| x + by)).corners();
    std::iter::once(p).chain(aside).chain(corners)
}

/// The largest width or height, in pixels of a picture of the usual size, of all that is drawn; `None` if that is not
/// known: the scene has no end, or not all of it is in front of the camera, or the camera has a projection matrix.
pub fn pixels(scene: &Scene, bounds: &[NodeBounds], root: NodeId, camera: &Camera) -> Option<f64> {
    let all = bounds[root as usize].all;
    if camera.projection.is_some() || !all.is_bounded() {
        return None;
    }
    let clip = scene.render.and_then(|r| r.clip);
    let all = clip.map_or(all, |(min, max)| all.intersection(&Aabb::new(min, max)));
    if all.is_empty() {
        return None;
    }
    let basis = Basis::of(camera)?;
    // The height of a picture at distance 1.
    let height = 2.0 * libm::tan(camera.fovy.to_radians() / 2.0);
    let scale = f64::from(USUAL[1]) / height;
    let mut picture = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
    for corner in 0..8 {
        let p: Vec3 = std::array::from_fn(|i| match corner >> i & 1 {
            0 => all.min[i],
            _ => all.max[i],
        });
        let v = sub(p, camera.position);
        let depth = dot(v, basis.forward);
        if depth <= CLEARANCE_REL * far(&p).max(far(&camera.position)) {
            return None;
        }
        for (range, axis) in picture.iter_mut().zip([basis.right, basis.up]) {
            let x = scale * dot(v, axis) / depth;
            *range = [range[0].min(x), range[1].max(x)];
        }
    }
    let size = picture.map(|[low, high]| high - low);
    Some(size[0].max(size[1])).filter(|x| x.is_finite())
}
