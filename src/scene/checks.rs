//! Checks of a record that concern several parameters at once.

use super::misread::{Misread, misread};
use super::record::Params;
use super::sizes::{Readings, readings};
use crate::diagnostics::{Applicability, Code, Diagnostic, Edit, Fix, Value};

/// Reports E203 if the three parameters from `first` on are the zero vector, which has no direction.
pub(super) fn non_zero(
    p: &Params,
    first: usize,
    what: &'static str,
    out: &mut Vec<Diagnostic>,
) -> Option<()> {
    if p.numbers::<3>(first).iter().any(|&x| x != 0.0) {
        return Some(());
    }
    out.push(
        Diagnostic::new(Code::E203, p.span_of(first, 3))
            .with("vector", Value::Term(what))
            .with("type", Value::Term(p.ty.title)),
    );
    None
}

/// Reports E202 if one of the `n` lower bounds from parameter `first` on is greater than its upper bound, which stands
/// `n` parameters further on.
pub(super) fn ordered(p: &Params, first: usize, n: usize, out: &mut Vec<Diagnostic>) -> Option<()> {
    let inverted: Vec<usize> = (first..first + n)
        .filter(|&i| p.number(i) > p.number(i + n))
        .collect();
    if inverted.is_empty() {
        return Some(());
    }
    // For each place, the parameter that belongs there if the inverted pairs are swapped.
    let swapped: Vec<usize> = (first..first + 2 * n)
        .map(|i| match i < first + n {
            true if inverted.contains(&i) => i + n,
            false if inverted.contains(&(i - n)) => i - n,
            _ => i,
        })
        .collect();
    let sorted: Vec<usize> = [0, 1]
        .iter()
        .flat_map(|end| (0..n).map(move |i| first + 2 * i + end))
        .collect();
    // The bounds may be written in turn, xmin xmax ymin ymax zmin zmax, if each such pair is in order and not equal. If
    // swapping the inverted pairs gives the same bounds, there is nothing to choose.
    let in_turn = (0..n).all(|i| p.number(first + 2 * i) < p.number(first + 2 * i + 1))
        && !sorted
            .iter()
            .zip(&swapped)
            .all(|(&a, &b)| p.number(a) == p.number(b));
    // Bounds are often one number with both signs, so the order with more such pairs is likelier.
    let symmetric = |order: &[usize]| {
        let is_one = |&i: &usize| p.number(order[i]) == -p.number(order[i + n]);
        (0..n).filter(is_one).count()
    };
    let is_sorted = in_turn && (inverted.len() > 1 || symmetric(&sorted) > symmetric(&swapped));
    let fix = |title, order: &[usize], applicability| {
        let moved = (first..).zip(order).filter(|(to, from)| to != *from);
        let edits = moved.map(|(to, &from)| Edit {
            span: p.span_of(to, 1),
            text: p.text_of(from).to_owned(),
        });
        Fix {
            title,
            values: Vec::new(),
            applicability,
            edits: edits.collect(),
        }
    };
    // The numbers may be a corner or the centre, and a size, as in other programs.
    let Readings { mut fixes, said } = readings(p, first, n);
    // If the bounds may also be written in turn, only the first reading as a size is kept.
    match (is_sorted, in_turn) {
        _ if said => {}
        (true, _) => fixes.clear(),
        (false, true) => fixes.truncate(1),
        (false, false) => {}
    }
    let sizes = fixes;
    // Bounds that differ along one axis only, or none, hold no area: something else is wrong.
    let along = (first..first + n).filter(|&i| p.number(i) != p.number(i + n));
    if along.count() < 2 {
        out.push(inverted_range(p, &inverted, n));
        return None;
    }
    // If the numbers may be a corner or a centre and a size, no single wrong number is looked for.
    let other = (sizes.is_empty() && !is_sorted).then(|| misread(p, first, n));
    let is_doubted = (other.as_ref()).is_some_and(|m| m.equal.is_some() || !m.points.is_empty());
    let has_signs = other.as_ref().is_some_and(|m| !m.signs.is_empty());
    let proposed = match (in_turn, is_sorted) {
        _ if is_doubted => fix("fix", &swapped, Applicability::Choice),
        _ if said => fix("fix", &swapped, Applicability::Choice),
        (_, true) => fix("fix-order", &sorted, Applicability::Unsafe),
        (true, false) if !sizes.is_empty() => fix("fix", &swapped, Applicability::Choice),
        (true, false) => fix("fix", &swapped, Applicability::Unsafe),
        (false, false) if !sizes.is_empty() => fix("fix", &swapped, Applicability::Choice),
        (false, false) if has_signs => fix("fix", &swapped, Applicability::Unsafe),
        (false, false) => fix("fix", &swapped, Applicability::Safe),
    };
    out.push(inverted_range(p, &inverted, n).fix(proposed));
    let in_order =
        (!said && in_turn && !is_sorted).then(|| fix("fix-order", &sorted, Applicability::Choice));
    let fixes = &mut out.last_mut()?.fixes;
    match in_turn || said {
        // A corner or centre and a size are commoner than swapped bounds here, so those fixes come first.
        true => drop(fixes.splice(0..0, sizes)),
        false => fixes.extend(sizes),
    }
    fixes.extend(in_order);
    if let Some(Misread {
        equal,
        points,
        signs,
    }) = other
    {
        fixes.splice(0..0, equal.into_iter().chain(points));
        fixes.extend(signs);
    }
    None
}

/// E202: the lower bounds at the parameters `inverted` are greater than their upper bounds, `n` parameters further on.
fn inverted_range(p: &Params, inverted: &[usize], n: usize) -> Diagnostic {
    let name = |i: usize| p.param(i).map_or("", |q| q.name);
    let at = inverted[0];
    Diagnostic::new(Code::E202, p.span_of(at, 1))
        .with("lower", name(at))
        .with("upper", name(at + n))
        .with("type", Value::Term(p.ty.title))
        .with("others", Value::Count(inverted.len() as u64 - 1))
        .label(p.span_of(at + n, 1), "other")
}
