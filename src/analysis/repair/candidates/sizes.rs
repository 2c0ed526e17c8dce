//! Shapes by their sizes, as other programs have them: a cone with two radii, a box without its place.

use super::{Candidate, Habit, LineContext};
use crate::diagnostics::{Applicability, Code, Diagnostic, Fix};
use crate::lint::spelling::decimal;
use crate::scene::sizes::{CENTRE, CORNER};
use crate::syntax::quote;
use crate::syntax::table::{RecordKind, RecordType, ShapeKind};
use crate::syntax::words;

/// Beginnings of words for a box, without accents.
pub(super) const BOX: [&str; 6] = ["box", "cube", "cuboid", "krychl", "kvadr", "kost"];
/// Beginnings of words for a ball, without accents.
const BALL: [&str; 4] = ["ball", "sphere", "koul", "kulic"];

impl LineContext<'_> {
    /// Guesses at shapes of three sizes: a height and two radii are a cone if one radius is zero, else a surface of
    /// revolution; three edges are a box with its centre or a corner at the origin.
    pub(super) fn by_sizes(&self, finding: &Diagnostic, out: &mut Vec<Candidate>) {
        let code = RecordType::of(RecordKind::Shape(ShapeKind::SurfaceOfRevolution)).code;
        let written: Option<Vec<f64>> = (self.params().iter())
            .map(|t| t.number(self.text))
            .collect();
        let (Some(&[a, b, c]), Some(ty)) = (written.as_deref(), self.ty()) else {
            return;
        };
        let texts = self.params().iter().map(|t| t.text(self.text));
        let [h, one, two] = Vec::from_iter(texts)[..] else {
            return;
        };
        let is_solid = a > 0.0 && b >= 0.0 && c >= 0.0;
        match (ty.kind, finding.code) {
            (RecordKind::Shape(ShapeKind::Cone), Code::E009) if is_solid => {
                let new = match (b > 0.0, c > 0.0) {
                    (true, true) => format!("{code} 2 {one} 0 {two} {h}"),
                    (true, false) => format!("{} {h} {one}", ty.code),
                    (false, true) => format!("{} {h} {two}", ty.code),
                    (false, false) => return,
                };
                out.push(self.anew(&new, Applicability::Unsafe));
            }
            (RecordKind::Shape(ShapeKind::Box), Code::E008) if is_solid && b * c > 0.0 => {
                let [x, y, z] = [a, b, c].map(|edge| edge / 2.0);
                let about = format!("{} -{x} -{y} -{z} {x} {y} {z}", ty.code);
                let beside = format!("{} 0 0 0 {h} {one} {two}", ty.code);
                let choice = |new: &String| self.anew(new, Applicability::Choice);
                out.extend([about, beside].iter().map(choice));
            }
            _ => {}
        }
    }

    /// Guesses at shapes of four numbers: a box by its centre or its least corner and its edge, a sphere at the origin
    /// by its radius and a centre. The numbers may also be those of a sphere; a comment may tell.
    pub(super) fn by_centre(&self, finding: &Diagnostic, out: &mut Vec<Candidate>) {
        let written: Option<Vec<f64>> = (self.params().iter())
            .map(|t| t.number(self.text))
            .collect();
        let (Some(&[a, b, c, d]), Some(ty)) = (written.as_deref(), self.ty()) else {
            return;
        };
        let sphere = RecordType::of(RecordKind::Shape(ShapeKind::Sphere));
        let is_sphere = |c: &Candidate| c.ty.is_some_and(|ty| ty.kind == sphere.kind);
        match (ty.kind, finding.code) {
            (RecordKind::Shape(ShapeKind::Box), Code::E008) if d > 0.0 => {
                let corner = |by: f64| [a, b, c].map(|x| decimal(x + by)).join(" ");
                let new = |from: f64, to: f64| {
                    let (from, to) = (corner(from), corner(to));
                    format!("{} {from} {to}", ty.code)
                };
                let centred = new(-d / 2.0, d / 2.0);
                let beside = new(0.0, d);
                let [is_box, is_ball, is_centre, is_corner] =
                    [&BOX[..], &BALL, &CENTRE, &CORNER].map(|words| self.is_called(words));
                let (all, applicability) = match (is_centre, is_corner) {
                    _ if is_ball && !is_box => return,
                    (true, false) if is_box => (vec![centred], Applicability::Unsafe),
                    (false, true) => (vec![beside], Applicability::Unsafe),
                    _ if is_box => (vec![centred, beside], Applicability::Choice),
                    _ => (vec![centred], Applicability::Choice),
                };
                if is_box || is_corner {
                    out.retain(|c| !is_sphere(c));
                }
                let spheres = out.iter_mut().filter(|c| is_sphere(c));
                spheres.for_each(|c| c.fix.applicability = Applicability::Choice);
                out.extend(all.iter().map(|new| self.anew(new, applicability)));
            }
            (RecordKind::Shape(ShapeKind::SphereAtOrigin), Code::E009) if a > 0.0 => {
                let [r, x, y, z] = [0, 1, 2, 3].map(|i| self.params()[i].text(self.text));
                let new = format!("{} {x} {y} {z} {r}", sphere.code);
                let spheres = out.iter_mut().filter(|c| is_sphere(c));
                spheres.for_each(|c| c.fix.applicability = Applicability::Choice);
                out.push(self.anew(&new, Applicability::Choice));
            }
            _ => {}
        }
    }

    /// Whether a comment on the line has a word with one of these beginnings, accents left out.
    pub(super) fn is_called(&self, beginnings: &[&str]) -> bool {
        let mut comments = self.all.iter().filter(|t| t.kind().is_comment());
        comments.any(|t| words::has(t.text(self.text), beginnings))
    }

    /// The candidate that writes everything behind the ID of the record anew.
    fn anew(&self, new: &str, applicability: Applicability) -> Candidate {
        let [first, last] = [self.tokens[1], self.tokens[self.tokens.len() - 1]];
        let span = first.span().to(last.span());
        let shown = format!("{} {new}", self.tokens[0].text(self.text));
        let fix = Fix::replace("fix-write", applicability, span, new);
        Candidate::new(Habit::Sibling, fix.with("number", quote(&shown)))
    }
}
