//! Bounds that are out of order, perhaps because one number has lost its sign or its decimal point.

use super::record::Params;
use super::sizes::{EQUAL, are_equal};
use crate::diagnostics::{Applicability, Fix};
use crate::syntax::{opposite, quote, with_point};

/// The fixes that bring bounds into order by a change of one number each.
pub(super) struct Misread {
    /// The fix that makes all edges equal, if a comment says that they are equal; or the change of a sign that makes
    /// two edges equal, which a swap of the bounds does not.
    pub equal: Option<Fix>,
    /// Fixes that put a decimal point into a number that begins with a zero.
    pub points: Vec<Fix>,
    /// Fixes that change the sign of a number.
    pub signs: Vec<Fix>,
}

/// Finds the fixes for the `n` lower bounds from parameter `first` on and the `n` upper bounds behind them.
pub(super) fn misread(p: &Params, first: usize, n: usize) -> Misread {
    let says_equal = p.is_called(&EQUAL);
    let mut all = Misread {
        equal: None,
        points: Vec::new(),
        signs: Vec::new(),
    };
    for i in first..first + 2 * n {
        let points = with_points(p.text_of(i)).into_iter().map(|t| (t, true));
        for (text, is_point) in points.chain([(opposite(p.text_of(i)), false)]) {
            let Some(edges) = edges(p, (first, n), (i, &text)) else {
                continue;
            };
            let fix = Fix::replace(
                "fix-number",
                Applicability::Choice,
                p.span_of(i, 1),
                text.clone(),
            );
            let fix = (fix.with("text", quote(p.text_of(i)))).with("number", quote(&text));
            let is_equal = edges.iter().all(|&e| are_equal(e, edges[0]));
            let along = (i - first) % n;
            let others = || (0..n).filter(|&j| j != along).map(|j| edges[j]);
            let swapped = (p.number(first + along) - p.number(first + along + n)).abs();
            let is_square = others().any(|e| are_equal(e, edges[along]))
                && !others().any(|e| are_equal(e, swapped));
            match is_point {
                _ if says_equal && is_equal && all.equal.is_none() => all.equal = Some(fix),
                false if is_square && all.equal.is_none() => all.equal = Some(fix),
                true => all.points.push(fix),
                false => all.signs.push(fix),
            }
        }
    }
    all
}

/// The lengths of the edges if parameter `at` were `text`. `None` if bounds are still out of order then.
fn edges(p: &Params, (first, n): (usize, usize), (at, text): (usize, &str)) -> Option<Vec<f64>> {
    let written: f64 = text.parse().ok()?;
    let number = |i: usize| if i == at { written } else { p.number(i) };
    let edges = (first..first + n).map(|i| number(i + n) - number(i));
    edges.map(|e| (e > 0.0).then_some(e)).collect()
}

/// The numbers that may be meant by one that begins with a zero and has no point: `015` may be `0.15` or `1.5`. Empty
/// for other numbers.
fn with_points(text: &str) -> Vec<String> {
    let unsigned = text.strip_prefix(['+', '-']).unwrap_or(text);
    let sign = if text.starts_with('-') { "-" } else { "" };
    let Some(point) = with_point(unsigned) else {
        return Vec::new();
    };
    let digits = unsigned.trim_start_matches('0');
    let later = (digits.len() > 1).then(|| format!("{sign}{}.{}", &digits[..1], &digits[1..]));
    std::iter::once(format!("{sign}{point}"))
        .chain(later)
        .collect()
}
