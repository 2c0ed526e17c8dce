//! Shapes as other programs have them: a plane by a point and its normal, a sphere with three radii, a surface with
//! four corners.

use super::inline::QUAD_TITLE;
use super::{Candidate, Habit, LineContext};
use crate::diagnostics::{Applicability, Code, Diagnostic, Fix};
use crate::geometry::array::{cross, dot, length, sub};
use crate::lint::spelling::decimal;
use crate::scene::Vec3;
use crate::syntax::quote;
use crate::syntax::table::{RecordKind, RecordType, ShapeKind};

/// The numbers of a point in space.
const AXES: usize = 3;
/// The most by which the length of a unit vector that is written with few digits differs from 1.
const LENGTH_OFF_MAX: f64 = 1e-3;
/// Four corners are in one plane if the parallelepiped that they span has no more than this share of the volume of a
/// cube on its longest edge.
const FLAT_REL_MAX: f64 = 1e-6;

impl LineContext<'_> {
    /// Guesses at what is meant by too many numbers of a plane or half-space, of a sphere, or of a triangle, and by a
    /// rectangle with the numbers of a plane.
    pub(super) fn by_points(&self, finding: &Diagnostic, used: &[u32], out: &mut Vec<Candidate>) {
        let Some(RecordKind::Shape(kind)) = self.ty().map(|ty| ty.kind) else {
            return;
        };
        let numbers: Option<Vec<f64>> = self.params().iter().map(|t| t.number(self.text)).collect();
        let Some(numbers) = numbers else { return };
        if let (ShapeKind::Rectangle, &[a, b, c, _], Code::E202) =
            (kind, numbers.as_slice(), finding.code)
            && has_unit_length([a, b, c])
        {
            let planes = [ShapeKind::HalfSpace, ShapeKind::Plane];
            let planes = planes.map(|kind| RecordType::of(RecordKind::Shape(kind)));
            out.extend(planes.map(|ty| self.write_type(Habit::Type, ty)));
        }
        if finding.code != Code::E009 {
            return;
        }
        let points: Vec<Vec3> = (numbers.chunks_exact(AXES))
            .map(|p| [p[0], p[1], p[2]])
            .collect();
        let is_whole = numbers.len() == AXES * points.len();
        match (kind, points.as_slice()) {
            _ if !is_whole => {}
            (ShapeKind::Plane | ShapeKind::HalfSpace, &[a, b]) => self.by_normal([a, b], out),
            (ShapeKind::Sphere, &[_, radii]) if radii.iter().all(|&r| r > 0.0) => {
                out.extend(self.with_radii());
            }
            (ShapeKind::Triangle, &[a, b, c, d]) if is_flat([a, b, c, d]) => {
                let normals = out.iter_mut().filter(|c| c.ty.is_some());
                normals.for_each(|c| c.fix.applicability = Applicability::Choice);
                let at = out.iter().position(|c| c.ty.is_some());
                if let Some(quad) = self.two_triangles(used) {
                    out.insert(at.unwrap_or(out.len()), quad);
                }
            }
            _ => {}
        }
    }

    /// Guesses at a plane by a point and its normal, in either order: the normal is the one whose length is 1. If both
    /// lengths are 1, or neither is, both are choices.
    fn by_normal(&self, two: [Vec3; 2], out: &mut Vec<Candidate>) {
        let mut normals = vec![1, 0];
        normals.retain(|&i| length(two[i]) > 0.0);
        if normals.iter().any(|&i| has_unit_length(two[i])) {
            normals.retain(|&i| has_unit_length(two[i]));
        }
        let applicability = match normals.len() {
            1 => Applicability::Unsafe,
            _ => Applicability::Choice,
        };
        let params = self.params();
        let span = params[0].span().to(params[params.len() - 1].span());
        for normal in normals {
            let own = &params[AXES * normal..AXES * (normal + 1)];
            let texts: Vec<&str> = own.iter().map(|t| t.text(self.text)).collect();
            // The subtraction from 0 makes no -0.
            let d = 0.0 - dot(two[0], two[1]);
            let text = format!("{}  {}", texts.join(" "), decimal(d));
            let fix = Fix::replace("fix-normal", applicability, span, text.clone());
            let fix = fix.with("text", quote(&texts.join(" ")));
            out.push(Candidate::new(
                Habit::Sibling,
                fix.with("number", quote(&text)),
            ));
        }
    }

    /// Guesses that a sphere with three radii is an ellipsoid and its translation.
    fn with_radii(&self) -> Option<Candidate> {
        let id = self.id()?;
        let texts: Vec<&str> = self.params().iter().map(|t| t.text(self.text)).collect();
        let [ellipsoid, translation] = [
            RecordKind::Shape(ShapeKind::Ellipsoid),
            RecordKind::Translation,
        ]
        .map(|kind| RecordType::of(kind).code);
        let (centre, radii) = texts.split_at(AXES);
        let is_zero = |text: &&str| text.parse() == Ok(0.0);
        let shape = format!("{ellipsoid} {}", radii.join(" "));
        let (title, text) = match centre.iter().all(is_zero) {
            true => ("fix-write", shape.clone()),
            false => {
                let moved = format!("{shape}\n{id} {translation} {}", centre.join(" "));
                ("fix-moved", moved)
            }
        };
        let span = self.tokens[1]
            .span()
            .to(self.tokens[self.tokens.len() - 1].span());
        let fix = Fix::replace(title, Applicability::Unsafe, span, text);
        Some(Candidate::new(
            Habit::Sibling,
            fix.with("number", quote(&shape)),
        ))
    }

    /// Guesses that a triangle with four corners is the union of two triangles.
    fn two_triangles(&self, used: &[u32]) -> Option<Candidate> {
        let (id, first) = (self.id()?, self.free_id(used)?);
        let second = first
            .checked_add(1)
            .filter(|&id| i32::try_from(id).is_ok())?;
        let texts: Vec<&str> = self.params().iter().map(|t| t.text(self.text)).collect();
        let corners: Vec<String> = texts.chunks(AXES).map(|c| c.join(" ")).collect();
        let [a, b, c, d] = corners.as_slice() else {
            return None;
        };
        let triangle = self.ty()?.code;
        let union = RecordType::of(RecordKind::Union).code;
        let text = format!(
            "{first} {triangle}  {a}  {b}  {c}\n{second} {triangle}  {a}  {c}  {d}\n{id} {union} {first} {second}"
        );
        let span = self.tokens[0]
            .span()
            .to(self.tokens[self.tokens.len() - 1].span());
        let fix = Fix::replace(QUAD_TITLE, Applicability::Choice, span, text);
        Some(Candidate::new(Habit::Sibling, fix))
    }
}

/// Whether a vector has the length 1.
pub(super) fn has_unit_length(v: Vec3) -> bool {
    (length(v) - 1.0).abs() <= LENGTH_OFF_MAX
}

/// Whether four corners are in one plane.
fn is_flat([a, b, c, d]: [Vec3; 4]) -> bool {
    let [b, c, d] = [b, c, d].map(|p| sub(p, a));
    let size = [b, c, d].map(length).into_iter().fold(0.0, f64::max);
    dot(cross(b, c), d).abs() <= FLAT_REL_MAX * size.powi(3)
}
