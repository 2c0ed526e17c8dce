//! Numbers, vectors and colours as POV-Ray reads them.

use crate::scene::Matrix;
use crate::syntax::Captions;

/// The shortest decimal that reads back as the same number.
pub fn number(x: f64) -> String {
    let size = x.abs();
    if x == 0.0 {
        "0".to_owned()
    } else if (1e-5..1e15).contains(&size) {
        // As people write it, where an exponent would not be shorter; whole numbers to 2⁵³ are exact.
        x.to_string()
    } else {
        format!("{x:e}")
    }
}

/// `<1, 2, 3>`.
pub fn vector(v: &[f64]) -> String {
    let parts: Vec<String> = v.iter().map(|x| number(*x)).collect();
    format!("<{}>", parts.join(", "))
}

/// `rgb 0.5` or `rgb <1, 0, 0>`.
pub fn rgb(c: [f64; 3]) -> String {
    if c[0] == c[1] && c[1] == c[2] {
        format!("rgb {}", number(c[0]))
    } else {
        format!("rgb {}", vector(&c))
    }
}

/// A matrix of ours acts on columns, POV-Ray's on rows: the transpose, without its last column.
pub fn matrix(m: &Matrix) -> String {
    let r = &m.0;
    let columns: Vec<String> = (0..4)
        .map(|j| {
            let column: Vec<String> = (0..3).map(|i| number(r[i][j])).collect();
            column.join(", ")
        })
        .collect();
    format!("matrix <{}>", columns.join(", "))
}

/// A matrix as people would write it where it only scales and moves.
pub fn transformation(m: &Matrix) -> String {
    let r = &m.0;
    if (0..3).any(|i| (0..3).any(|j| i != j && r[i][j] != 0.0)) {
        return matrix(m);
    }
    let (scales, way) = ([r[0][0], r[1][1], r[2][2]], [r[0][3], r[1][3], r[2][3]]);
    let scale = match scales {
        [x, y, z] if x == y && y == z => number(x),
        _ => vector(&scales),
    };
    match (scales == [1.0; 3], way == [0.0; 3]) {
        (true, _) => format!("translate {}", vector(&way)),
        (false, true) => format!("scale {scale}"),
        (false, false) => format!("scale {scale} translate {}", vector(&way)),
    }
}

/// What the scene calls an entity: its ID and what a comment says of it.
pub fn entity(id: u32, captions: &Captions) -> String {
    match captions.get(id) {
        Some(words) => format!("{id}, {words}"),
        None => id.to_string(),
    }
}

/// Adds a comment to the first line of a text.
pub fn commented(text: &str, comment: &str) -> String {
    match text.split_once('\n') {
        Some((first, rest)) => format!("{first} // {comment}\n{rest}"),
        None => format!("{text} // {comment}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_read_back() {
        for x in [0.0, -0.0, 1.0, -0.1, 1.0 / 3.0, 1e-300, 1e300, 123456.75] {
            assert_eq!(number(x).parse::<f64>().unwrap(), x);
        }
        assert_eq!(number(1e-7), "1e-7");
        assert_eq!(rgb([0.5; 3]), "rgb 0.5");
    }

    #[test]
    fn matrices_are_transposed() {
        let m = Matrix::translation(1.0, 2.0, 3.0).after(&Matrix::rotation(90.0, 2));
        assert_eq!(matrix(&m), "matrix <0, 1, 0, -1, 0, 0, 0, 0, 1, 1, 2, 3>");
        assert_eq!(transformation(&m), matrix(&m));
    }

    #[test]
    fn simple_changes_are_called_by_their_names() {
        let (move_, stretch) = (
            Matrix::translation(1.0, 2.0, 3.0),
            Matrix::scaling(2.0, 2.0, 2.0),
        );
        assert_eq!(transformation(&move_), "translate <1, 2, 3>");
        assert_eq!(transformation(&stretch), "scale 2");
        let both = move_.after(&Matrix::scaling(2.0, 1.0, 1.0));
        assert_eq!(transformation(&both), "scale <2, 1, 1> translate <1, 2, 3>");
    }
}
