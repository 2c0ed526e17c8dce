//! Boxes and rectangles whose numbers are meant as a corner or the centre, and a size, as in other programs.

use std::ops::Range;

use super::record::Params;
use crate::diagnostics::{Applicability, Edit, Fix};
use crate::syntax::{quote, words};

/// Beginnings of words for a centre, without accents.
pub(crate) const CENTRE: [&str; 5] = ["centr", "center", "middle", "stred", "prostred"];
/// Beginnings of words for a size, without accents. None of them begins `hranol`, a prism.
const SIZE: [&str; 8] = [
    "size", "edge", "hrana", "hrany", "hrane", "hranou", "velikost", "rozmer",
];
/// Beginnings of words for a corner, without accents.
pub(crate) const CORNER: [&str; 3] = ["corner", "roh", "vrchol"];
/// Beginnings of words for half of a size, without accents.
const HALF: [&str; 3] = ["half", "pul", "polovi"];

/// The meaning that a comment gives to the lower bounds of a record: a corner or the centre, with a size behind.
#[derive(Clone, Copy, PartialEq)]
enum Meant {
    Corner,
    Centre,
    /// The centre and half of the size.
    Half,
}

/// The fixes for bounds of which the upper ones may be a size, and the lower ones a corner or the centre.
pub(crate) struct Readings {
    pub fixes: Vec<Fix>,
    /// Whether a comment speaks of a size or a centre. The first fix is then the one that the comment describes.
    pub said: bool,
}

/// The readings of the `n` lower bounds from parameter `first` on and the `n` upper bounds behind them. There are none
/// if an upper bound is not positive, since no size is.
pub(crate) fn readings(p: &Params, first: usize, n: usize) -> Readings {
    let size = first + n..first + 2 * n;
    let meant = meant(p);
    let mut fixes = Vec::new();
    if size.clone().all(|i| p.number(i) > 0.0) {
        let kinds = match meant {
            None | Some(Meant::Corner) => vec![Meant::Corner, Meant::Centre],
            Some(Meant::Centre) => vec![Meant::Centre, Meant::Corner],
            Some(Meant::Half) => vec![Meant::Half, Meant::Centre],
        };
        fixes.extend(kinds.into_iter().map(|kind| reading(p, first, n, kind)));
    }
    let said = meant.is_some() && !fixes.is_empty();
    if said && p.is_called(&SIZE) && (p.is_called(&CENTRE) || p.is_called(&CORNER)) {
        fixes[0].applicability = Applicability::Unsafe;
    }
    Readings { fixes, said }
}

/// The meaning that a comment on the record gives to the bounds. `None` if none speaks of a centre or a size.
fn meant(p: &Params) -> Option<Meant> {
    let [centre, size, corner, half] = [&CENTRE[..], &SIZE, &CORNER, &HALF].map(|b| p.is_called(b));
    match (centre, size) {
        (true, _) if half => Some(Meant::Half),
        (true, _) => Some(Meant::Centre),
        (false, true) if corner => Some(Meant::Corner),
        (false, true) => Some(Meant::Centre),
        (false, false) => None,
    }
}

fn reading(p: &Params, first: usize, n: usize, kind: Meant) -> Fix {
    let (lower, size) = (first..first + n, first + n..first + 2 * n);
    let written = |places: Range<usize>| {
        let texts: Vec<&str> = places.map(|i| p.text_of(i)).collect();
        quote(&texts.join(" "))
    };
    let from = |by: f64| {
        lower
            .clone()
            .map(move |i| sum(p.number(i), by * p.number(i + n)))
    };
    let both = |by: f64| from(-by).chain(from(by)).collect();
    let (title, places, new): (_, _, Vec<String>) = match kind {
        Meant::Corner => ("fix-size", size.clone(), from(1.0).collect()),
        Meant::Centre => ("fix-centre", first..first + 2 * n, both(0.5)),
        Meant::Half => ("fix-half", first..first + 2 * n, both(1.0)),
    };
    let shown = quote(&new.join(" "));
    let edits = places.zip(new).filter(|(i, text)| p.text_of(*i) != text);
    let edits = edits.map(|(i, text)| Edit {
        span: p.span_of(i, 1),
        text,
    });
    let fix = Fix {
        title,
        values: vec![("text", written(size).into()), ("number", shown.into())],
        applicability: Applicability::Choice,
        edits: edits.collect(),
    };
    match kind {
        Meant::Corner => fix,
        Meant::Centre | Meant::Half => fix.with("centre", written(lower)),
    }
}

/// The sum of two numbers as text, rounded to the nine decimals that people may write.
pub(crate) fn sum(a: f64, b: f64) -> String {
    /// Sums are rounded to multiples of its inverse.
    const ROUNDED: f64 = 1e9;
    let rounded = ((a + b) * ROUNDED).round() / ROUNDED;
    // Adding zero turns -0 into 0.
    let text = if rounded.is_finite() {
        rounded + 0.0
    } else {
        a + b
    };
    text.to_string()
}

/// The number of words above which a comment without any number is about something else.
const MAX_LABEL_WORDS: usize = 6;

/// Beginnings of words for a cube or a square, without accents.
pub(super) const EQUAL: [&str; 5] = ["cube", "krychl", "kostk", "square", "ctver"];

/// The fixes for bounds that are in order but that a comment describes as a size.
pub(crate) fn by_comment(p: &Params, n: usize) -> Vec<Fix> {
    match by_name(p, n) {
        Some(fix) => vec![fix],
        None => by_size(p, n),
    }
}

/// The fixes for bounds whose distances are not the edges that a comment gives. The upper bounds must be those edges:
/// written as `2 x 2 x 2`, as `size 2 2 2` or by their names, or all equal where the comment speaks of a cube.
fn by_size(p: &Params, n: usize) -> Vec<Fix> {
    let edge = |i: usize| p.number(i + n) - p.number(i);
    let said = p.comments().find_map(|text| {
        let named = || named_edges(text, n).or_else(|| listed_edges(text, n));
        edges(text, n).or_else(named)
    });
    let is_cube = n == 3 && p.is_called(&EQUAL);
    let all_equal = |x: &dyn Fn(usize) -> f64| (1..n).all(|i| are_equal(x(i), x(0)));
    let upper = |i: usize| p.number(i + n);
    // One distance may be symmetric by chance; a comment that gives the edge leaves no doubt.
    let symmetric = (0..n).filter(|&i| p.number(i) == -p.number(i + n)).count();
    let is_edge = || {
        p.comments()
            .flat_map(numbers)
            .any(|x| are_equal(x, upper(0)))
    };
    let is_meant = match said {
        Some(said) => {
            let are_edges = |of: &dyn Fn(usize) -> f64| (0..n).all(|i| are_equal(said[i], of(i)));
            are_edges(&upper) && !are_edges(&edge)
        }
        // The comment speaks of a cube, but the edges differ.
        None => {
            let is_cube = is_cube && all_equal(&upper) && !all_equal(&edge);
            is_cube && (symmetric <= 1 || is_edge())
        }
    };
    let mut fixes = match is_meant {
        true => readings(p, 0, n).fixes,
        false => Vec::new(),
    };
    if p.is_called(&CORNER) {
        fixes.truncate(1);
    }
    fixes
        .iter_mut()
        .for_each(|fix| fix.applicability = Applicability::Choice);
    fixes
}

/// The greatest gap between two sizes that are equal but for rounding, as a share of the greater.
const SIZE_REL_GAP: f64 = 1e-9;

/// Whether two sizes are equal but for rounding.
pub(super) fn are_equal(a: f64, b: f64) -> bool {
    (a - b).abs() <= SIZE_REL_GAP * a.abs().max(b.abs())
}

/// The `n` edges in a text, written as `2 x 2 x 2`. `None` if it has none.
fn edges(text: &str, n: usize) -> Option<Vec<f64>> {
    let is_part = |c: char| c.is_ascii_digit() || c == '.' || c == ',';
    let text = text.to_lowercase().replace(['×', '*', '·', 'х'], "x");
    let words: Vec<&str> = text.split_whitespace().collect();
    let joined = words
        .join(" ")
        .replace(" x ", "x")
        .replace(" x", "x")
        .replace("x ", "x");
    let all = joined.split_whitespace().map(|word| {
        let parts = word.trim_matches(|c: char| !is_part(c)).split('x');
        let numbers = parts.map(|part| part.trim_end_matches(',').replace(',', ".").parse().ok());
        numbers.collect::<Option<Vec<f64>>>()
    });
    all.flatten().find(|numbers| numbers.len() == n && n > 1)
}

/// The three edges in a text that names them width, height and depth, along x, y and z.
fn named_edges(text: &str, n: usize) -> Option<Vec<f64>> {
    let names = [&WIDTH[..], &HEIGHT, &DEPTH];
    let edges = names.into_iter().map(|any| number_of(text, any));
    edges
        .collect::<Option<Vec<f64>>>()
        .filter(|_| n == names.len())
}

/// The `n` edges in a text that lists them behind a word for a size.
fn listed_edges(text: &str, n: usize) -> Option<Vec<f64>> {
    let words: Vec<&str> = text.split_whitespace().collect();
    let at = words.iter().position(|word| words::has(word, &SIZE))?;
    let listed = words.get(at + 1..=at + n)?.iter().map(|word| {
        let mut all = numbers(word);
        all.next().filter(|_| all.next().is_none())
    });
    listed.collect()
}

/// The fix where a comment speaks of a size, and of a centre or a corner. The numbers in the comment must be those of
/// the record, and not the place and the size that the bounds have.
fn by_name(p: &Params, n: usize) -> Option<Fix> {
    let kind = meant(p).filter(|_| p.is_called(&SIZE))?;
    if kind == Meant::Centre && !p.is_called(&CENTRE) {
        return None;
    }
    let fixes = readings(p, 0, n).fixes.into_iter();
    let mut fix = fixes.take(1).find(|fix| !fix.edits.is_empty())?;
    let said: Vec<f64> = p.comments().flat_map(numbers).collect();
    if said.is_empty() {
        let words = |text: &str| text.split_whitespace().filter(|w| *w != "#").count();
        let is_symmetric = |i: usize| p.number(i) == -p.number(i + n);
        fix.applicability = Applicability::Choice;
        let is_label = p.comments().all(|text| words(text) <= MAX_LABEL_WORDS);
        return (is_label && !(0..n).all(is_symmetric)).then_some(fix);
    }
    // A comment seldom gives zeros, since a centre at the origin goes without saying.
    let is_said = |x: f64| x == 0.0 || said.contains(&x);
    let size = |i: usize| p.number(i + n) - p.number(i);
    let as_bounds = |i: usize| match kind {
        Meant::Corner => is_said(p.number(i)) && is_said(size(i)),
        Meant::Centre | Meant::Half => {
            let centre = (p.number(i) + p.number(i + n)) / 2.0;
            is_said(centre) && (is_said(size(i)) || is_said(size(i) / 2.0))
        }
    };
    ((0..2 * n).all(|i| is_said(p.number(i))) && !(0..n).all(as_bounds)).then_some(fix)
}

/// The numbers in a text.
pub(super) fn numbers(text: &str) -> impl Iterator<Item = f64> {
    let is_part = |c: char| c.is_ascii_digit() || ".,-".contains(c);
    let words = text.split(move |c: char| !is_part(c));
    let words = words.map(|word| word.trim_end_matches(['.', ',', '-']).replace(',', "."));
    words.filter_map(|word| word.parse().ok())
}

/// Beginnings of words for a radius, without accents; [`DIAMETER`] has those for a diameter.
const RADIUS: [&str; 3] = ["radius", "radii", "polomer"];
const DIAMETER: [&str; 3] = ["diameter", "prumer", "across"];
/// The same for a height.
const HEIGHT: [&str; 3] = ["height", "vysk", "vysc"];
/// The same for a width and a depth.
const WIDTH: [&str; 2] = ["width", "sirk"];
const DEPTH: [&str; 2] = ["depth", "hloubk"];

/// For a sphere whose comment contradicts its numbers, the case of the finding's message and the fix. Case `radius`:
/// the radius that the comment tells is written first and not last. Case `diameter`: the number written as radius is
/// the diameter that the comment tells. `None` in all other cases.
pub(crate) fn sphere_by_comment(p: &Params) -> Option<(&'static str, Fix)> {
    let last = p.len().checked_sub(1)?;
    let said = |any: &[&str]| p.comments().find_map(|text| number_of(text, any));
    if p.is_called(&RADIUS) {
        let radius = said(&RADIUS)?;
        let is_first = last == 3 && radius == p.number(0) && radius != p.number(last);
        let order = [1, 2, 3, 0].map(|i| p.text_of(i).to_owned());
        let number = quote(&order.join(" "));
        let edits = order
            .into_iter()
            .enumerate()
            .filter(|(i, text)| p.text_of(*i) != text);
        let edits = edits.map(|(i, text)| Edit {
            span: p.span_of(i, 1),
            text,
        });
        let fix = Fix::guess("fix-radius", edits.collect()).with("number", number);
        return is_first.then_some(("radius", fix));
    }
    if !p.is_called(&DIAMETER) {
        return None;
    }
    let diameter = said(&DIAMETER)?;
    (diameter > 0.0 && diameter == p.number(last)).then(|| {
        let text = sum(diameter / 2.0, 0.0);
        let number = quote(&text);
        let edits = vec![Edit {
            span: p.span_of(last, 1),
            text,
        }];
        (
            "diameter",
            Fix::guess("fix-diameter", edits).with("number", number),
        )
    })
}

/// Whether a text names a height before a radius. `None` unless it has both words.
pub(crate) fn names_height_first(text: &str) -> Option<bool> {
    let place = |any: &[&str]| {
        let mut words = text.split_whitespace();
        words.position(|word| words::has(word, any))
    };
    Some(place(&HEIGHT)? < place(&RADIUS)?)
}

/// Whether a comment says of two numbers that the first is a height and the second a radius (`true`), or the other way
/// round: by the numbers that it gives, or by the order of the two words. `None` unless it has both words.
pub(crate) fn is_height_first(text: &str, numbers: [f64; 2]) -> Option<bool> {
    let by_words = names_height_first(text)?;
    let said = [&HEIGHT[..], &RADIUS].map(|any| number_of(text, any));
    let is_said = |order: [f64; 2]| said.iter().zip(order).any(|(x, y)| *x == Some(y));
    let [one, two] = numbers;
    Some(match (is_said([one, two]), is_said([two, one])) {
        (true, false) => true,
        (false, true) => false,
        _ => by_words,
    })
}

/// The guess for a cone whose comment gives its height and its radius, in each other's place.
pub(crate) fn cone_by_comment(p: &Params) -> Option<Fix> {
    let said = |any: &[&str]| p.own_comments().find_map(|text| number_of(text, any));
    let [height, radius] = p.numbers(0);
    let is_meant = said(&HEIGHT)? == radius && said(&RADIUS)? == height;
    let texts = [1, 0].map(|i| p.text_of(i));
    (is_meant && height != radius && height > 0.0).then(|| {
        let edits = texts.iter().enumerate().map(|(i, text)| Edit {
            span: p.span_of(i, 1),
            text: (*text).to_owned(),
        });
        Fix::guess("fix-order", edits.collect()).with("number", quote(&texts.join(" ")))
    })
}

/// The number that a text gives for a word: the first one behind it, or else the last one before it.
fn number_of(text: &str, beginnings: &[&str]) -> Option<f64> {
    let words: Vec<&str> = text.split_whitespace().collect();
    let at = words.iter().position(|word| words::has(word, beginnings))?;
    let mut behind = words[at..].iter().flat_map(|word| numbers(word));
    behind.next().or_else(|| {
        let before = words[..at].iter().rev();
        before.flat_map(|word| numbers(word)).next()
    })
}
