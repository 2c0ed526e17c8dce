//! W305: a shape without volume, or a surface without area.

mod in_line;

use crate::diagnostics::{Applicability, Code, Diagnostic, Fix, Value};
use crate::lint::Context;
use crate::scene::record::Params;
use crate::scene::sizes::{Readings, readings};
use crate::scene::{Geometry, Shape};
use crate::solids::definite::{QuadricSet, judge};
use crate::solids::shapes::quadric::Quadric;
use crate::solids::shapes::{AnyShape, profile};
use crate::syntax::quote;
use in_line::{InLine, in_line};

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    for (shape, span) in context.scene.written_shapes() {
        if let Some(why) = shape.geometry.degenerate()
            && let Some(p) = context.params(span)
        {
            out.push(finding(shape, &p, &why));
        }
    }
}

fn finding(shape: &Shape, p: &Params, why: &Degenerate) -> Diagnostic {
    let (first, count) = why.params;
    let finding = Diagnostic::new(Code::W305, p.span_of(first, count))
        .case(why.case)
        .with("type", Value::Term(shape.ty().title))
        .with("id", shape.id.to_string());
    if why.case == TURNED {
        return finding.fix(p.points_exchanged());
    }
    if why.equal.is_empty() {
        return finding;
    }
    let name = |i: usize| p.param(i).map_or("", |q| q.name);
    let half = p.len() / 2;
    let pairs: Vec<String> = (why.equal.iter())
        .map(|&i| format!("{} = {}", name(i), name(i + half)))
        .collect();
    let finding = finding
        .with("pairs", pairs.join(", "))
        .with("lower", name(first))
        .with("upper", name(first + half))
        .label(p.span_of(first + half, 1), "other");
    // The numbers may be a corner or the centre and a size, as in other programs.
    let Readings {
        fixes: mut sizes,
        said,
    } = readings(p, 0, half);
    let minus = lost_minus(p, why, half);
    if said {
        sizes.extend(minus);
        return sizes.into_iter().fold(finding, Diagnostic::fix);
    }
    // The reading as centre and size comes first: a corner and a size are rarely equal.
    sizes.reverse();
    minus
        .into_iter()
        .chain(sizes)
        .fold(finding, Diagnostic::fix)
}

/// The case of a profile whose x and y are exchanged.
const TURNED: &str = "profile-turned";

/// The fix for one pair of equal bounds. If both are positive, the lower one has lost its minus; if both are negative,
/// the upper one has a minus too many. `None` for zeros and for several pairs.
fn lost_minus(p: &Params, why: &Degenerate, half: usize) -> Option<Fix> {
    let &[low] = why.equal.as_slice() else {
        return None;
    };
    let at = match p.numbers::<1>(low) {
        [x] if x > 0.0 => low,
        [x] if x < 0.0 => low + half,
        _ => return None,
    };
    let text = p.text_of(at);
    let new = match text.strip_prefix('-') {
        Some(rest) => rest.to_owned(),
        None => format!("-{}", text.trim_start_matches('+')),
    };
    let fix = Fix::replace(
        "fix-write",
        Applicability::Choice,
        p.span_of(at, 1),
        new.clone(),
    );
    Some(fix.with("number", quote(&new)))
}

/// The way in which a shape is degenerate, with the case of its message.
#[derive(Debug, Clone, PartialEq)]
struct Degenerate {
    case: &'static str,
    /// The index of the first parameter that makes the shape degenerate, and the number of these parameters.
    params: (usize, usize),
    /// Indices of lower bounds that equal their upper bounds, half a record further on, if these make the shape
    /// degenerate.
    equal: Vec<usize>,
}

impl Geometry {
    /// The way in which a solid has no inside, or a surface no area; `None` for a shape that is not degenerate.
    fn degenerate(&self) -> Option<Degenerate> {
        match AnyShape::of(self) {
            AnyShape::Cone(s) => (s.height == 0.0 && !s.double).then(|| Degenerate {
                case: "cone",
                params: (0, 1),
                equal: Vec::new(),
            }),
            AnyShape::Cuboid(s) => {
                let equal: Vec<usize> = (0..3).filter(|&i| s.min[i] == s.max[i]).collect();
                Some(Degenerate {
                    case: "box",
                    params: (*equal.first()?, 1),
                    equal,
                })
            }
            AnyShape::Quadric(s) => {
                let Quadric::General(q) = s else {
                    return None;
                };
                let QuadricSet::Flat(dimensions) = judge(q) else {
                    return None;
                };
                Some(Degenerate {
                    case: match dimensions {
                        0 => "point",
                        1 => "line",
                        _ => "plane",
                    },
                    params: (0, 16),
                    equal: Vec::new(),
                })
            }
            AnyShape::Rectangle(s) => {
                let equal: Vec<usize> = (0..2).filter(|&i| s.min[i] == s.max[i]).collect();
                Some(Degenerate {
                    case: "rectangle",
                    params: (*equal.first()?, 1),
                    equal,
                })
            }
            AnyShape::Revolution(s) => {
                let line = in_line(&profile::closed(s.profile))?;
                let on_axis = s.profile.iter().all(|q| q[0] == 0.0);
                let turned: Vec<[f64; 2]> = s.profile.iter().map(|&[x, y]| [y, x]).collect();
                let is_turned = turned.iter().all(|q| q[0] >= 0.0)
                    && in_line(&profile::closed(&turned)).is_none();
                Some(Degenerate {
                    case: match line {
                        _ if on_axis => "axis",
                        _ if is_turned => TURNED,
                        InLine::Exactly => "profile",
                        InLine::Rounded => "profile-nearly",
                    },
                    params: (1, 2 * s.profile.len()),
                    equal: Vec::new(),
                })
            }
            AnyShape::Triangle(s) => {
                let case = match in_line(&s.vertices)? {
                    InLine::Exactly => "triangle",
                    InLine::Rounded => "triangle-nearly",
                };
                Some(Degenerate {
                    case,
                    params: (0, 9),
                    equal: Vec::new(),
                })
            }
            AnyShape::Ellipsoid(_)
            | AnyShape::GeodesicSphere(_)
            | AnyShape::HalfSpace(_)
            | AnyShape::Sphere(_)
            | AnyShape::Torus(_) => None,
        }
    }
}
