//! Counts of the findings that are left in a scene: the fewer they are, the likelier the scene is what a person meant.

use super::candidates::{Candidate, Habit};
use crate::analysis::Analysis;
use crate::diagnostics::{Code, Diagnostic, Severity, Span, Value};
use crate::scene::{Node, NodeId, Scene, View, fold_up};
use crate::solids::bounds::NodeBounds;
use crate::solids::proofs::{Literals, Proofs};
use crate::trace::plan::unseen::view::{Parts, out_of_view};

/// Whether it is proved that nothing of the scene is drawn.
pub fn draws_nothing(analysis: &Analysis) -> bool {
    let Some(render) = &analysis.scene.render else {
        return false;
    };
    let root = ("id", Value::from(render.root_id.to_string()));
    let is_empty = |d: &Diagnostic| d.code == Code::W319 && d.values.contains(&root);
    analysis.findings().iter().any(is_empty)
}

/// The numbers of findings that are left in a scene, the weightiest kind first: two of them compare by errors first.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Left {
    pub errors: usize,
    /// Objects that are empty, that nothing needs, that change nothing, or that no camera sees.
    pub in_vain: usize,
    pub warnings: usize,
    pub notes: usize,
}

/// The code for a picture file that cannot be read. No change of the text repairs that.
pub(super) const NO_PICTURE: Code = Code::E210;

/// The number of errors of the text; picture files that cannot be read do not count.
pub(super) fn errors(analysis: &Analysis) -> usize {
    let of_text = |&&(code, _): &&(Code, Span)| code != NO_PICTURE;
    analysis.errors.iter().filter(of_text).count()
}

/// Whether the text has no errors; picture files that cannot be read do not count.
pub(super) fn is_right(analysis: &Analysis) -> bool {
    (analysis.errors.iter()).all(|&(code, _)| code == NO_PICTURE)
}

/// The most shapes, copies counted, of a scene on which the lint rules run. On a scene with copies of copies the rules
/// take a tenth of a second, and many texts are tried.
const MAX_SHAPES_FOR_RULES: u64 = 20_000;

/// Counts the findings of a scene. In a scene of more shapes than [`MAX_SHAPES_FOR_RULES`] the rules do not run, and
/// only errors are counted.
pub(super) fn left(analysis: &Analysis) -> Left {
    let mut left = Left::default();
    if !is_small(&analysis.scene) {
        left.errors = errors(analysis);
        return left;
    }
    for d in analysis.findings() {
        match (d.severity, d.code) {
            (Severity::Error, NO_PICTURE) => {}
            (Severity::Error, _) => left.errors += 1,
            (_, Code::W310 | Code::W319 | Code::W305 | Code::W306 | Code::W327) => {
                left.in_vain += 1;
            }
            (Severity::Warning, _) => left.warnings += 1,
            (Severity::Note, _) => left.notes += 1,
            (Severity::Style, _) => {}
        }
    }
    let bounds = analysis.bounds();
    left.in_vain += useless(&analysis.scene, bounds);
    left.in_vain += usize::from(is_unseen(&analysis.scene, bounds));
    left
}

/// Whether a scene has no more shapes than [`MAX_SHAPES_FOR_RULES`].
pub(super) fn is_small(scene: &Scene) -> bool {
    occurrences(scene) <= MAX_SHAPES_FOR_RULES
}

/// The number of shapes in the node that is made of most shapes. A shape counts as often as it occurs in the node.
fn occurrences(scene: &Scene) -> u64 {
    let counts = fold_up(&scene.nodes, |_, node, counts: &[u64]| {
        let below = node.children().map(|n| counts[n as usize]);
        below.fold(0, u64::saturating_add).max(1)
    });
    counts.into_iter().max().unwrap_or(0)
}

/// The number of operations that are equal to one of their operands: the union with a part that lies within the other
/// operand, the difference with a solid that the first operand does not meet, the intersection with a solid that
/// encloses the other.
fn useless(scene: &Scene, bounds: &[NodeBounds]) -> usize {
    let mut proofs = Proofs::new(scene, bounds);
    let mut count = 0;
    fold_up(&scene.nodes, |id, node, lists: &[Literals]| {
        let list = |n: NodeId| lists[n as usize];
        let mut within = |a: NodeId, b: NodeId| {
            let outside = proofs.complement(b, &list(b));
            a == b || proofs.nothing(&list(a), &outside, None).is_some()
        };
        let in_vain = match node {
            Node::Paint { child, .. } | Node::Copy { child, .. } => return list(child),
            Node::Union(a, b) | Node::Intersection(a, b) => within(a, b) || within(b, a),
            Node::Difference(a, b) => proofs.nothing(&list(a), &list(b), Some((a, b))).is_some(),
            _ => false,
        };
        count += usize::from(in_vain);
        Literals::new((id, false))
    });
    count
}

/// Whether the camera sees nothing of all that is drawn.
fn is_unseen(scene: &Scene, bounds: &[NodeBounds]) -> bool {
    let (Some(render), View::Mono(at)) = (&scene.render, &scene.view) else {
        return false;
    };
    let Some(camera) = scene.cameras.get(*at) else {
        return false;
    };
    let nothing = bounds[render.root as usize].all.is_empty();
    nothing || out_of_view(scene, bounds, render.root, camera, Parts::All).is_some()
}

pub(super) fn has_error_at(scene: &Analysis, line: Span) -> bool {
    errors_at(scene, line) > 0
}

pub(super) fn errors_at(scene: &Analysis, line: Span) -> usize {
    codes_at(scene, line).count()
}

fn codes_at(scene: &Analysis, line: Span) -> impl Iterator<Item = Code> {
    let source = &scene.source;
    let at = source.line_index(source.floor(line.start));
    let on_line = move |span: Span| source.line_index(source.floor(span.start)) == at;
    let errors = scene.errors.iter().filter(|e| e.0 != NO_PICTURE);
    errors.filter_map(move |&(code, span)| on_line(span).then_some(code))
}

/// The number of undefined IDs on a line that show only since a candidate gave an unknown type its minus, or a rotation
/// the number of its axis. They do not speak against the candidate.
pub(super) fn hidden(d: &Diagnostic, candidate: &Candidate, scene: &Analysis, line: Span) -> usize {
    let is_sign = d.code == Code::E007 && candidate.habit == Habit::Sign;
    match is_sign || candidate.habit == Habit::Axis {
        true => codes_at(scene, line)
            .filter(|&code| code == Code::E101)
            .count(),
        false => 0,
    }
}

/// The number of IDs that prove to be defined twice only since a candidate made a record of surplus numbers. They are
/// another mistake and do not speak against the candidate.
pub(super) fn redefined(
    d: &Diagnostic,
    candidate: &Candidate,
    before: &Analysis,
    scene: &Analysis,
) -> usize {
    let again = |analysis: &Analysis| {
        let codes = analysis.errors.iter().map(|&(code, _)| code);
        codes.filter(|&code| code == Code::E102).count()
    };
    match d.code == Code::E009 && candidate.habit == Habit::Apart {
        true => again(scene).saturating_sub(again(before)),
        false => 0,
    }
}

/// Whether every record that begins on the line of a span also ends on that line.
pub(super) fn ends_on_line(scene: &Analysis, line: Span) -> bool {
    let (source, document) = (&scene.source, &scene.document);
    let number = |at: u32| source.line_index(source.floor(at));
    let own = number(line.start);
    let spans = document.items.iter().map(|item| document.item_span(item));
    let mut begun = spans
        .skip_while(|span| number(span.start) < own)
        .take_while(|span| number(span.start) == own);
    begun.all(|span| number(span.end) == own)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fmt::Write;

    /// A scene of a ball that is joined with itself `times` times, and of a ball that nothing needs.
    fn doubled(times: u32) -> Analysis {
        let mut text = String::from("2 11 0 0 0 1\n90 11 0 0 0 1\n");
        for id in 3..3 + times {
            let below = id - 1;
            writeln!(text, "{id} -101 {below} {below}").expect("a text takes all");
        }
        writeln!(text, "1 9999 {} 0", 2 + times).expect("a text takes all");
        Analysis::new("scene.zpg", text.into_bytes())
    }

    #[test]
    fn copies_of_copies_are_counted_and_no_rule_runs_on_too_many() {
        let [few, many] = [3, 60].map(doubled);
        assert_eq!(occurrences(&few.scene), 8);
        assert_eq!(occurrences(&many.scene), 1 << 60);
        assert!(left(&few).in_vain > 0);
        assert_eq!(left(&many), Left::default());
        assert!(many.known_findings().is_none());
    }
}
