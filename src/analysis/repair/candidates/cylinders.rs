//! Guesses at a cylinder, which is a surface of revolution.

use super::{Candidate, Habit, LineContext};
use crate::diagnostics::{Applicability, Edit, Fix, Span, Value};
use crate::scene::sizes::is_height_first;
use crate::syntax::lexer::Token;
use crate::syntax::quote;
use crate::syntax::table::{RecordKind, RecordType, ShapeKind};

/// Beginnings of words for a cylinder, without accents.
pub(super) const CYLINDERS: [&str; 3] = ["cylind", "valec", "valc"];
/// How many numbers a cylinder has that is given by the centres of its ends and a radius.
const CYLINDER: usize = 7;
/// How many numbers a cone has that is given by the centres and radii of two circles.
pub(super) const CONE: usize = 8;

impl LineContext<'_> {
    /// Guesses that the numbers behind the type of a surface of revolution, cone, geodesic sphere or parabolic cylinder
    /// are those of a cylinder: a radius and a height, or as in POV-Ray.
    pub(super) fn profile(&self, out: &mut Vec<Candidate>) {
        let Some(kind) = self.ty().filter(|ty| !self.fits(ty)).map(|ty| ty.kind) else {
            return;
        };
        let is_cone = kind == RecordKind::Shape(ShapeKind::Cone);
        let is_profile = kind == RecordKind::Shape(ShapeKind::SurfaceOfRevolution);
        let is_parabolic = kind == RecordKind::Shape(ShapeKind::ParabolicCylinder);
        let is_geodesic = kind == RecordKind::Shape(ShapeKind::GeodesicSphere);
        let is_cylinder = match self.params() {
            all if is_geodesic => all.len() == CYLINDER,
            all if is_parabolic => matches!(all.len(), 2 | CYLINDER),
            [a, _] => {
                is_profile
                    && (a.integer(self.text).is_none()
                        || self.is_called(&CYLINDERS)
                        || self.is_height_first().is_some())
            }
            all if is_cone => matches!(all.len(), CYLINDER | CONE),
            all => is_profile && all.len() == CYLINDER,
        };
        let (Some(ty), true) = (self.tokens.get(1), is_cylinder) else {
            return;
        };
        let start = out.len();
        self.cylinder(ty.span(), self.params(), out);
        if is_parabolic {
            // Only the guess with the radius first is kept.
            out.truncate(start + 1);
            if !self.is_called(&CYLINDERS) || self.is_called(&["parabol"]) {
                let new = out[start..].iter_mut();
                new.for_each(|c| c.fix.applicability = Applicability::Choice);
            }
        }
        for candidate in &mut out[start..] {
            candidate.habit = if is_cone || is_geodesic || is_parabolic {
                Habit::Sibling
            } else {
                Habit::Count
            };
        }
    }

    /// Whether the record is a cone with eight parameters, as many as the centres and radii of two circles.
    pub(super) fn is_cone_of_circles(&self) -> bool {
        let is_cone = |ty: &RecordType| ty.kind == RecordKind::Shape(ShapeKind::Cone);
        self.ty().is_some_and(is_cone) && self.params().len() == CONE
    }

    /// Guesses at a cylinder about the y axis, as a surface of revolution: by two numbers, a radius and a height, in the
    /// order that a comment gives first; or by the centres of its ends, if one is above the other, with one radius at the
    /// end or a radius behind each.
    pub(super) fn cylinder(&self, word: Span, params: &[Token], out: &mut Vec<Candidate>) {
        let (Some(first), Some(last), Some(id)) = (params.first(), params.last(), self.id()) else {
            return;
        };
        let values: Option<Vec<f64>> = params.iter().map(|t| t.number(self.text)).collect();
        let texts: Vec<&str> = params.iter().map(|t| t.text(self.text)).collect();
        let is_zero = |text: &str| text.parse() == Ok(0.0);
        let placed = |profile: String, x: &str, z: &str| match is_zero(x) && is_zero(z) {
            true => profile,
            false => format!("{profile}\n{id} -1 {x} 0 {z}"),
        };
        let profiles = match (texts.as_slice(), values.as_deref()) {
            (&[a, b], Some(_)) => {
                let mut both = vec![format!("2 {a} 0 {a} {b}"), format!("2 {b} 0 {b} {a}")];
                if self.is_height_first() == Some(true) {
                    both.reverse();
                }
                both
            }
            (&[x, low, z, _, high, _, r], Some(&[x0, _, z0, x1, _, z1, _]))
                if (x0, z0) == (x1, z1) =>
            {
                vec![placed(format!("2 {r} {low} {r} {high}"), x, z)]
            }
            (&[x, low, z, r, _, high, _, s], Some(&[x0, _, z0, _, x1, _, z1, _]))
                if (x0, z0) == (x1, z1) =>
            {
                vec![placed(format!("2 {r} {low} {s} {high}"), x, z)]
            }
            _ => return,
        };
        let ty = RecordType::of(RecordKind::Shape(ShapeKind::SurfaceOfRevolution));
        out.extend(profiles.into_iter().map(|profile| {
            let shown = profile.lines().next().unwrap_or_default();
            let shown = quote(&format!("{} {shown}", ty.code));
            let edit = |span: Span, text: String| Edit { span, text };
            let fix = Fix {
                title: "fix-cylinder",
                values: vec![("text", shown.into()), ("type", Value::Term(ty.title))],
                applicability: Applicability::Unsafe,
                edits: vec![
                    edit(word, ty.code.to_string()),
                    edit(first.span().to(last.span()), profile),
                ],
            };
            Candidate::new(Habit::Word, fix)
        }));
    }

    /// Whether a comment on the line says that the first of two numbers is a height and the second one a radius, or the
    /// other way round.
    fn is_height_first(&self) -> Option<bool> {
        let values = self.params().iter().map(|t| t.number(self.text));
        let [a, b] = Option::<Vec<f64>>::from_iter(values)?[..] else {
            return None;
        };
        let mut comments = self.all.iter().filter(|t| t.kind().is_comment());
        comments.find_map(|t| is_height_first(t.text(self.text), [a, b]))
    }
}
