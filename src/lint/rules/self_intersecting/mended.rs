//! Fixes of a profile that crosses itself: a lost decimal point, or pairs of a height and a radius.

use super::crossing::first_crossing;
use crate::diagnostics::{Applicability, Edit, Fix};
use crate::scene::record::Params;
use crate::scene::sizes;
use crate::solids::shapes::revolution::MAX_EXAMINED_POINTS;
use crate::syntax::{quote, tenth};

/// Least number that may have lost a point: a single digit would rather have lost a zero and a point.
const MIN_WRITTEN: f64 = 10.0;
/// Most numbers of a profile that are tried with a decimal point.
const MAX_TRIED: usize = 8;
/// Most guesses of a lost decimal point.
const MAX_POINTS: usize = 2;

pub(super) fn mended(p: &Params) -> Vec<Fix> {
    let n = p.count;
    // The record begins with the number of points.
    if n > MAX_EXAMINED_POINTS || p.len() < 1 + 2 * n {
        return Vec::new();
    }
    let profile: Vec<[f64; 2]> = (0..n)
        .map(|i| [p.number(1 + 2 * i), p.number(2 + 2 * i)])
        .collect();
    let is_right = |profile: &[[f64; 2]]| first_crossing(profile).is_none();
    let is_possible = profile.iter().all(|&[_, y]| y >= 0.0);
    let mut fixes = Vec::new();
    let names_height_first = |text| sizes::names_height_first(text) == Some(true);
    if is_possible && p.own_comments().any(names_height_first) {
        fixes.push(pairs_swapped(p, n));
    }
    let point = |at: usize| {
        let (point, axis) = ((at - 1) / 2, (at - 1) % 2);
        let text = tenth(p.text_of(at))?;
        let mut then = profile.clone();
        then[point][axis] /= 10.0;
        is_right(&then).then(|| {
            let span = p.span_of(at, 1);
            let shown = quote(&text);
            let fix = Fix::replace("fix-point", Applicability::Unsafe, span, text);
            fix.with("number", shown)
                .with("old", p.text_of(at).to_owned())
        })
    };
    let is_tried = |&at: &usize| p.number(at).abs() >= MIN_WRITTEN;
    let tried = (1..=2 * n).filter(is_tried).take(MAX_TRIED);
    fixes.extend(tried.filter_map(point).take(MAX_POINTS));
    if fixes.len() > 1 {
        (fixes.iter_mut()).for_each(|fix| fix.applicability = Applicability::Choice);
    }
    fixes
}

/// The fix that swaps the two numbers of each point.
fn pairs_swapped(p: &Params, n: usize) -> Fix {
    let swapped = |i: usize| {
        let [x, y] = [1 + 2 * i, 2 + 2 * i];
        [(x, y), (y, x)].map(|(to, from)| Edit {
            span: p.span_of(to, 1),
            text: p.text_of(from).to_owned(),
        })
    };
    Fix {
        title: "fix-pairs",
        values: Vec::new(),
        applicability: Applicability::Unsafe,
        edits: (0..n).flat_map(swapped).collect(),
    }
}
