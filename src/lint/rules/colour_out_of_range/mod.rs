//! W301: a colour with a part outside of 0 to 1.

use crate::diagnostics::{Applicability, Code, Diagnostic, Edit, Fix};
use crate::lint::Context;
use crate::lint::spelling::rough;
use crate::scene::record::Params;
use crate::syntax::table::{RecordKind, ShapeKind};

/// Whole numbers up to 255 are bytes as image programs show them. Up to 100 they may as well be
/// per cent, and nothing is proposed.
const BYTE_MAX: f64 = 255.0;
const PER_CENT_MAX: f64 = 100.0;

pub fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    for record in context.records() {
        let first = match record.ty.kind {
            RecordKind::Colour => 0,
            // The colours follow the points of the profile.
            RecordKind::Shape(ShapeKind::ColouredSurfaceOfRevolution) => {
                1 + 2 * record.count as usize
            }
            _ => continue,
        };
        let p = context.record_params(record);
        if (first..p.len()).any(|i| is_outside(&p, i)) {
            out.push(finding(&p, first));
        }
    }
}

fn is_outside(p: &Params, i: usize) -> bool {
    !(0.0..=1.0).contains(&p.number(i))
}

/// `first` is the parameter where the colours begin.
fn finding(p: &Params, first: usize) -> Diagnostic {
    let colours = || (first..p.len()).step_by(3);
    let mut outside = colours().filter(|&i| (i..i + 3).any(|i| is_outside(p, i)));
    let at = outside.next().unwrap_or(first);
    let bad: Vec<usize> = (at..at + 3).filter(|&i| is_outside(p, i)).collect();
    let parts: Vec<String> = bad
        .iter()
        .map(|&i| {
            let name = p.param(i).map_or("", |q| q.name);
            format!("{name} = {}", p.text_of(i))
        })
        .collect();
    let (from, to) = (bad[0], bad[bad.len() - 1]);
    let d = Diagnostic::new(Code::W301, p.span_of(from, to - from + 1))
        .case(if first == 0 { "" } else { "point" })
        .with("parts", parts.join(", "))
        .with("point", ((at - first) / 3 + 1).to_string())
        .with(
            "others",
            crate::diagnostics::Value::Count(outside.count() as u64),
        );
    let all = || (first..p.len()).map(|i| p.number(i));
    let largest = all().fold(0.0, f64::max);
    let bytes = all().all(|x| x.fract() == 0.0 && (0.0..=BYTE_MAX).contains(&x));
    if bytes && largest > PER_CENT_MAX {
        let edits = (first..p.len()).filter(|&i| p.number(i) != 0.0);
        d.note("bytes").fix(Fix {
            title: "divide",
            applicability: Applicability::Unsafe,
            edits: edits
                .map(|i| edit(p, i, rough(p.number(i) / BYTE_MAX)))
                .collect(),
        })
    } else {
        let edits = (first..p.len()).filter(|&i| is_outside(p, i));
        d.fix(Fix {
            title: "fix",
            applicability: Applicability::Unsafe,
            edits: edits
                .map(|i| edit(p, i, rough(p.number(i).clamp(0.0, 1.0))))
                .collect(),
        })
    }
}

fn edit(p: &Params, i: usize, text: String) -> Edit {
    Edit {
        span: p.span_of(i, 1),
        text,
    }
}

#[cfg(test)]
mod tests {
    use crate::lint::testing::{fixed, found, messages};

    #[test]
    fn parts_outside() {
        assert_eq!(found("7 -701 0 1 1.01"), ["W301 1:12"]);
        assert_eq!(found("7 -701 -0.1 0.5 2"), ["W301 1:8"]);
        // The ends belong to it.
        assert!(found("7 -701 0 1 1.0").is_empty());
        assert_eq!(
            messages("7 -701 -0.1 0.5 2"),
            ["the parts of a colour lie between 0 and 1; here r = -0.1, b = 2"]
        );
    }

    #[test]
    fn objects_and_lights_too() {
        assert_eq!(found("2 9 1\n2 -701 2 0 0"), ["W301 2:8"]);
        assert_eq!(found("2 -402 1\n2 -701 0 0 2"), ["W301 2:12"]);
        // What is no colour may be of any size.
        assert!(found("2 9 1\n2 -1 2 0 -7").is_empty());
    }

    #[test]
    fn colours_of_a_profile() {
        let scene = "2 2 3  1 0 5 1 1 2  0 0 0  0 2 0  0 3 -1";
        assert_eq!(found(scene), ["W301 1:30"]);
        assert_eq!(
            messages(scene),
            [
                "the parts of a colour lie between 0 and 1; at profile point 2, g = 2, and 1 more colour is out of range"
            ]
        );
        assert!(found("2 2 3  1 0 5 1 1 2  0 0 0  0 1 0  0 1 0.5").is_empty());
    }

    #[test]
    fn bytes_are_divided_and_others_limited() {
        assert_eq!(fixed("7 -701 255 0 51 # red #"), "7 -701 1 0 0.2 # red #");
        assert_eq!(fixed("7 -701 100 0 50"), "7 -701 1 0 1");
        assert_eq!(fixed("7 -701 256 0 51"), "7 -701 1 0 1");
        assert_eq!(fixed("7 -701 101.5 -2 0.5"), "7 -701 1 0 0.5");
        assert!(found(&fixed("7 -701 101 1 0")).is_empty());
    }
}
