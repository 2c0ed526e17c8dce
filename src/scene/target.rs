//! The point that a camera looks at, by a comment on its record.

use super::Vec3;
use super::record::Params;
use super::sizes::numbers;
use crate::syntax::words::{denies, has, of_text};

/// Words for the point to look at, without accents.
const TARGET: [&str; 7] = [
    "target", "lookat", "cil", "cile", "cilem", "cilovy", "cilovym",
];
/// Beginnings of words for looking or aiming, without accents, each with the word behind that leads to the point.
const LOOKS: [(&str, &str); 10] = [
    ("look", "at"),
    ("aim", "at"),
    ("aimed", "at"),
    ("pointing", "at"),
    ("diva", "na"),
    ("hledi", "na"),
    ("kouka", "na"),
    ("miri", "na"),
    ("zamiren", "na"),
    ("namiren", "na"),
];
/// Most words from the one for looking to the one that leads to the point, as in `dívá se na`.
const MAX_STEPS: usize = 2;
/// Beginnings of words for a direction, without accents: the comment leaves open which of the two is written.
const DIRECTION: [&str; 4] = ["direction", "smer", "vector", "vektor"];
/// Beginnings of words by which a comment above a record speaks of a camera, without accents.
const CAMERA: [&str; 5] = ["camera", "kamer", "eye", "poloh", "position"];

/// What a comment calls the point that a camera looks at.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Target {
    /// The comment gives the coordinates.
    Point(Vec3),
    /// The comment has a word for the point, and no coordinates.
    Named,
}

/// The point to look at by the comments on a camera's record, if its direction may be that point: a comment that gives
/// coordinates must give the numbers of the direction.
pub(crate) fn target_by_comment(p: &Params) -> Option<Target> {
    let own = p.own_comments().find_map(target);
    let above = || {
        let of_camera = p.comments().filter(|text| has(text, &CAMERA));
        of_camera.into_iter().find_map(target)
    };
    let found = own.or_else(above)?;
    let direction: Vec3 = p.numbers(3);
    (found == Target::Named || found == Target::Point(direction)).then_some(found)
}

/// The point to look at that a text plainly speaks of.
fn target(text: &str) -> Option<Target> {
    if has(text, &DIRECTION) || denies(text) {
        return None;
    }
    let words = Vec::from_iter(of_text(text));
    let leads = |at: usize| {
        let behind = words.iter().skip(at + 1).take(MAX_STEPS);
        let mut looks = LOOKS.iter().filter(|(b, _)| words[at].starts_with(b));
        looks.any(|(_, to)| behind.clone().any(|w| w == to))
    };
    let at = (0..words.len()).find(|&at| TARGET.contains(&words[at].as_str()) || leads(at))?;
    let said: Vec<f64> = numbers(behind_word(text, at)).take(3).collect();
    Some(match said[..] {
        [x, y, z] => Target::Point([x, y, z]),
        _ => Target::Named,
    })
}

/// The part of a text behind the word with this index.
fn behind_word(text: &str, index: usize) -> &str {
    let mut ends = text.char_indices().filter_map(|(i, c)| {
        let next = text[i + c.len_utf8()..].chars().next();
        let is_end = c.is_alphabetic() && !next.is_some_and(char::is_alphabetic);
        is_end.then_some(i + c.len_utf8())
    });
    ends.nth(index).map_or("", |end| &text[end..])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_in_comments() {
        for text in [
            "kamera: poloha, cíl, nahoru, úhel",
            "camera: position, target, up, angle",
            "look at",
            "look_at",
            "dívá se na kouli 3",
            "míří na míč",
        ] {
            assert_eq!(target(text), Some(Target::Named), "{text}");
        }
        for text in [
            "kamera se dívá na bod 0 1 -1",
            "looks at 0 1 -1",
            "camera at 0 2 9, target (0, 1, -1), up 0 1 0",
            "cíl 0 1 -1",
        ] {
            let point = Target::Point([0.0, 1.0, -1.0]);
            assert_eq!(target(text), Some(point), "{text}");
        }
        for text in [
            "looks to the left",
            "směr pohledu míří na míč",
            "direction to look at 0 1 -1",
            "does not look at the ball",
            "kamera",
        ] {
            assert_eq!(target(text), None, "{text}");
        }
    }
}
