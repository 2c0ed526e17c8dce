//! A pure colour whose comment names another one.

use crate::diagnostics::{Applicability, Code, Diagnostic, Fix};
use crate::lint::spelling::linear_part;
use crate::scene::axes::words;
use crate::scene::record::Params;
use crate::syntax::words::{FLOOR, shapes};
use crate::syntax::{colour_names, quote};
use crate::trace::film::srgb8;

/// The colours that a comment may name, by their names in CSS: nobody means a neighbour by them.
const PLAIN: [&str; 12] = [
    "red", "orange", "yellow", "lime", "green", "aqua", "blue", "purple", "magenta", "white",
    "black", "gray",
];
/// Words beside a colour that leave it what it is, without accents.
const ASIDE: [&str; 22] = [
    "a", "the", "colour", "color", "barva", "barvy", "rgb", "pure", "cista", "wall", "stena",
    "lamp", "lampa", "svetlo", "from", "left", "right", "top", "zleva", "zprava", "shora", "mat",
];
/// Parts of a pure colour: the dark ones at most, the light ones at least.
const MAX_DARK: f64 = 0.2;
const MIN_LIGHT: f64 = 0.6;
/// Hues that are nearer, in degrees, may go by each other's names.
const MIN_HUE_GAP: f64 = 60.0;

pub(super) fn check(p: &Params) -> Option<Diagnostic> {
    let parts: [f64; 3] = p.numbers(0);
    let is_in = |x: &f64| (0.0..=MAX_DARK).contains(x) || (MIN_LIGHT..=1.0).contains(x);
    let lights = parts.iter().filter(|x| **x >= MIN_LIGHT).count();
    if p.len() != 3 || !parts.iter().all(is_in) || !(1..=2).contains(&lights) {
        return None;
    }
    let (word, said) = p.own_comments().find_map(said)?;
    let hue_of_numbers = hue(parts.map(|x| srgb8(x as f32)))?;
    // White, black and grey have no hue.
    let is_other = hue(said).is_none_or(|hue| {
        let apart = (hue - hue_of_numbers).abs();
        apart.min(360.0 - apart) >= MIN_HUE_GAP
    });
    is_other.then(|| {
        let span = p.span_of(0, 3);
        let numbers = said.map(linear_part).join(" ");
        let fix = Fix::replace("fix", Applicability::Unsafe, span, numbers.clone());
        Diagnostic::new(Code::W344, span)
            .case("colour")
            .with("id", p.id.to_string())
            .with("said", quote(&word))
            .fix(fix.with("number", quote(&numbers)))
    })
}

/// The colour that a comment names, if it names one alone and no shade of it.
fn said(comment: &str) -> Option<(String, [u8; 3])> {
    let all = comment.split(|c: char| !c.is_alphanumeric());
    let mut colour = None;
    for (written, word) in all.filter(|w| !w.is_empty()).zip(words(comment)) {
        let named = colour_names::exact(written);
        // A `light` before the colour is a shade, and behind it a lamp.
        let is_light = word == "light" && colour.is_some();
        let is_aside = is_light
            || ASIDE.contains(&word.as_str())
            || FLOOR.iter().any(|b| word.starts_with(b))
            || !shapes(&word).is_empty();
        match named {
            Some(_) if colour.is_some() => return None,
            // Many call the sky and the sea so.
            Some(_) if word.starts_with("azur") => return None,
            Some(named) => colour = Some((written.to_owned(), named)),
            None if !is_aside => return None,
            None => {}
        }
    }
    let is_plain = |(_, named): &(String, [u8; 3])| {
        let mut plain = PLAIN.iter().map(|name| colour_names::exact(name));
        plain.any(|c| c == Some(*named))
    };
    colour.filter(is_plain)
}

/// The hue of an sRGB colour in degrees, if it has one.
fn hue(shown: [u8; 3]) -> Option<f64> {
    let [r, g, b] = shown.map(f64::from);
    let (most, least) = (r.max(g).max(b), r.min(g).min(b));
    let by = most - least;
    let sixths = match () {
        () if by == 0.0 => return None,
        () if most == r => (g - b) / by,
        () if most == g => 2.0 + (b - r) / by,
        () => 4.0 + (r - g) / by,
    };
    Some((60.0 * sixths).rem_euclid(360.0))
}
