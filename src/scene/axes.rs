//! The axis of a rotation by a comment, and words of comments with their numbers.

use super::{Camera, Scene};
use crate::syntax::words::plain;

/// The names of the axes, x first.
pub(crate) const LETTERS: [&str; 3] = ["x", "y", "z"];
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
/// Words by which a comment speaks of something beside its record, or of what is not so, without accents.
const BESIDE: [&str; 44] = [
    "in", "on", "under", "behind", "for", "of", "with", "without", "and", "or", "not", "no",
    "than", "then", "instead", "was", "old", "like", "plus", "next", "before", "after", "if", "v",
    "ve", "na", "pod", "za", "u", "pro", "bez", "s", "se", "a", "i", "nebo", "ne", "neni", "misto",
    "byla", "bylo", "pak", "potom", "jako",
];

/// The axis of a rotation that a comment names, 1 to 3: it names one alone. A vertical axis is y, if that is up for all
/// cameras.
pub(crate) fn axis_by_comment(comment: &str, scene: &Scene) -> Option<usize> {
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

/// The words of a comment without accents and in lower case; numbers are words, too.
pub(crate) fn words(comment: &str) -> Vec<String> {
    let words = comment.split(|c: char| !c.is_alphanumeric());
    words.filter(|w| !w.is_empty()).map(plain).collect()
}

/// Whether a word shows that a comment speaks of something beside its record, or of what is not so.
pub(crate) fn is_beside(word: &str) -> bool {
    BESIDE.contains(&word)
}
