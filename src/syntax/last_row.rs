//! Whether the last row of a record's numbers is rather a record of its own.

use super::LEAST_HEAD;
use super::table::{RecordKind, RecordType, ShapeKind};

/// The rows and columns of the matrix of a quadric.
const ROWS: usize = 4;

/// Whether the last row of a record's numbers can be read as a record, and is rather one: it has a type that no table
/// of numbers has there, or as a row of a quadric it would make the matrix asymmetric.
pub fn is_record(ty: &RecordType, params: &[f64]) -> bool {
    let length = ty.vectors.last().copied().unwrap_or(0);
    let Some(start) = params.len().checked_sub(length).filter(|_| length > 2) else {
        return false;
    };
    let Some(&[id, code, ..]) = params.get(start..) else {
        return false;
    };
    let is_id = id.fract() == 0.0 && id >= 1.0;
    let code = (code.fract() == 0.0).then_some(code as i64);
    let Some(other) = code.and_then(RecordType::by_code).filter(|_| is_id) else {
        return false;
    };
    let least = 2 + other.params.len();
    let fits = !other.is_counted() && [least, least + other.optional.len()].contains(&length);
    let is_sure = other.code <= LEAST_HEAD || other.kind == RecordKind::Render;
    fits && (is_sure || is_asymmetric(ty, params))
}

/// Whether the last row of a quadric's matrix differs from its last column.
fn is_asymmetric(ty: &RecordType, params: &[f64]) -> bool {
    let last = ROWS - 1;
    let differs = |i: usize| params[ROWS * i + last] != params[ROWS * last + i];
    ty.kind == RecordKind::Shape(ShapeKind::Quadric)
        && params.len() == ROWS * ROWS
        && (0..last).any(differs)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_that_are_records() {
        let is = |code: i64, params: &[f64]| is_record(RecordType::by_code(code).unwrap(), params);
        let quadric = |column: [f64; 3], row: [f64; 4]| {
            let [a, b, c] = column;
            [
                &[1.0, 0.0, 0.0, a, 0.0, 1.0, 0.0, b, 0.0, 0.0, 1.0, c][..],
                &row,
            ]
            .concat()
        };
        assert!(is(15, &quadric([0.0; 3], [2.0, -2.0, 30.0, 1.0])));
        assert!(is(15, &quadric([0.0; 3], [3.0, 14.0, 2.0, 1.0])));
        // Symmetric, no type, and too few numbers for a translation.
        assert!(!is(15, &quadric([2.0, -2.0, 30.0], [2.0, -2.0, 30.0, 1.0])));
        assert!(!is(15, &quadric([0.0; 3], [0.0, 0.0, 0.5, -1.0])));
        assert!(!is(15, &quadric([0.0; 3], [3.0, -1.0, 2.0, 1.0])));
        let triangle = |row: [f64; 3]| [&[0.0, 0.0, 0.0, 1.0, 0.0, 0.0][..], &row].concat();
        assert!(is(6, &triangle([50.0, -402.0, 1.0])));
        assert!(!is(6, &triangle([3.0, 9.0, 1.0])));
    }
}
