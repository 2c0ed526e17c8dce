//! A rotation whose comment names another axis.

use super::{is_beside, words};
use crate::diagnostics::{Applicability, Code, Diagnostic, Fix};
use crate::lint::Context;
use crate::scene::record::Params;
use crate::scene::{Camera, Scene};
use crate::syntax::quote;

const LETTERS: [&str; 3] = ["x", "y", "z"];
/// Words before the axis of a rotation, without accents.
const ABOUT: [&str; 5] = ["about", "around", "round", "kolem", "okolo"];
/// Words for an axis, and what stands beside them.
const AXIS: [&str; 8] = ["axis", "osa", "osy", "ose", "osu", "osou", "the", "ove"];
/// Words before an axis that points up, without accents.
const VERTICAL: [&str; 5] = ["vertical", "svisla", "svisle", "svislou", "vertikalni"];
/// Beginnings of the words for a rotation and its angle, without accents.
const TURNS: [&str; 8] = [
    "rot", "otoc", "otac", "natoc", "pootoc", "turn", "deg", "stup",
];
/// Words between these.
const BETWEEN: [&str; 2] = ["by", "o"];
/// Comments of more words are about something else.
const MAX_COMMENT_WORDS: usize = 10;
/// The place of the axis in the record.
const PLACE: usize = 1;

pub(super) fn check(context: &Context, p: &Params) -> Option<Diagnostic> {
    let letter = |axis: usize| LETTERS.get(axis.wrapping_sub(1)).copied();
    let written = letter(p.integer(PLACE) as usize)?;
    let said = p
        .own_comments()
        .find_map(|text| said(text, context.scene))?;
    if letter(said)? == written {
        return None;
    }
    let (number, span) = (said.to_string(), p.span_of(PLACE, 1));
    let fix = Fix::replace("fix", Applicability::Unsafe, span, number.clone());
    let finding = Diagnostic::new(Code::W344, span)
        .with("axis", written.to_owned())
        .with("said", LETTERS[said - 1].to_owned());
    Some(finding.fix(fix.with("number", quote(&number))))
}

/// The axis of a rotation that a comment names, 1 to 3: it names one alone. A vertical axis is y, if that is up for all
/// cameras.
pub(crate) fn said(comment: &str, scene: &Scene) -> Option<usize> {
    let words = words(comment);
    let is_axis = |word: &str| AXIS.contains(&word);
    let is_vertical = |i: usize| {
        VERTICAL.contains(&words[i].as_str()) && words.get(i + 1).is_some_and(|w| is_axis(w))
    };
    let named = |i: usize| match LETTERS.iter().position(|l| *l == words[i]) {
        None if is_vertical(i) => Some(1),
        letter => letter,
    };
    let at = (0..words.len()).find(|&i| named(i).is_some())?;
    let is_one = !(at + 1..words.len()).any(|i| named(i).is_some());
    if words.len() > MAX_COMMENT_WORDS || !is_one {
        return None;
    }
    let is_up = |c: &Camera| matches!(c.up, [0.0, y, 0.0] if y > 0.0);
    let is_upright = !scene.cameras.is_empty() && scene.cameras.iter().all(is_up);
    if is_vertical(at) && !is_upright {
        return None;
    }
    let mut before = words[..at].iter().rev().skip_while(|w| is_axis(w));
    let is_about = before.next().is_some_and(|w| ABOUT.contains(&w.as_str()));
    // A turn before may have moved the axes of the object itself.
    let is_plain = !words[at..].iter().any(|w| is_beside(w))
        && !words[..at].iter().any(|w| is_beside(w) && w != "of");
    let is_turn = |w: &String| TURNS.iter().any(|b| w.starts_with(b));
    let is_known = |i: usize| {
        let w = &words[i];
        named(i).is_some()
            || is_axis(w)
            || is_turn(w)
            || BETWEEN.contains(&w.as_str())
            || w.parse::<u32>().is_ok()
    };
    let is_all = || {
        let names = |w: &String| is_turn(w) || is_axis(w);
        (0..words.len()).all(is_known) && words.iter().any(names)
    };
    let axis = named(at)? + 1;
    (is_plain && (is_about || is_all())).then_some(axis)
}
