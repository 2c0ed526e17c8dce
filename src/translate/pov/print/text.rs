//! Numbers, vectors and colours as POV-Ray reads them, and `Page`, which indents lines. Braces are written where the
//! thing is printed.

use std::fmt::{self, Write};

use crate::geometry::Matrix;
use crate::translate::number;

/// A vector as POV-Ray writes it: `<1, 2, 3>`.
pub(crate) fn vector(v: &[f64]) -> String {
    let parts: Vec<String> = v.iter().map(|x| number(*x)).collect();
    format!("<{}>", parts.join(", "))
}

/// `rgb 0.5` or `rgb <1, 0, 0>`.
pub(crate) fn rgb(c: [f64; 3]) -> String {
    if c[0] == c[1] && c[1] == c[2] {
        format!("rgb {}", number(c[0]))
    } else {
        format!("rgb {}", vector(&c))
    }
}

/// A matrix as POV-Ray reads it. The program's matrices act on columns and POV-Ray's on rows, so it is the transpose,
/// without its last column.
pub(crate) fn matrix(m: &Matrix) -> String {
    let r = &m.0;
    let columns: Vec<String> = (0..4)
        .map(|j| {
            let column: Vec<String> = (0..3).map(|i| number(r[i][j])).collect();
            column.join(", ")
        })
        .collect();
    format!("matrix <{}>", columns.join(", "))
}

/// A matrix as people would write it, with `scale`, `rotate` and `translate`, if it only scales, turns about a
/// coordinate axis, and moves; otherwise with `matrix`.
pub(crate) fn transformation(m: &Matrix) -> String {
    let r = &m.0;
    let way = [r[0][3], r[1][3], r[2][3]];
    let straight = (0..3).all(|i| (0..3).all(|j| i == j || r[i][j] == 0.0));
    let (scales, turn) = match straight {
        true => ([r[0][0], r[1][1], r[2][2]], None),
        false => match scaled_and_turned(m) {
            Some((scales, degrees, axis)) => (scales, Some((degrees, axis))),
            None => return matrix(m),
        },
    };
    let mut steps = Vec::new();
    match scales {
        s if s == [1.0; 3] => {}
        [x, y, z] if x == y && y == z => steps.push(format!("scale {}", number(x))),
        s => steps.push(format!("scale {}", vector(&s))),
    }
    if let Some((degrees, axis)) = turn {
        let axis = ["x", "y", "z"][axis];
        steps.push(format!("rotate {}*{axis}", number(degrees)));
    }
    if way != [0.0; 3] || steps.is_empty() {
        steps.push(format!("translate {}", vector(&way)));
    }
    steps.join(" ")
}

/// The factors, the angle in degrees and the axis (0 to 2) of a matrix that scales and then turns about this axis. The
/// factors and the angle have nine decimals at most. `None` if the matrix differs from these steps by more than
/// rounding.
fn scaled_and_turned(m: &Matrix) -> Option<([f64; 3], f64, usize)> {
    let r = &m.0;
    let short = |x: f64| (x * 1e9).round() / 1e9;
    let column = |j: usize| [0, 1, 2].map(|i| r[i][j]);
    let scales = [0, 1, 2].map(|j| {
        let [x, y, z] = column(j);
        short(x.hypot(y).hypot(z))
    });
    (0..3).find_map(|axis| {
        let [j, k] = [(axis + 1) % 3, (axis + 2) % 3];
        let degrees = short(r[k][j].atan2(r[j][j]).to_degrees());
        let [x, y, z] = scales;
        let meant = Matrix::rotation(degrees, axis).after(&Matrix::scaling(x, y, z));
        let alike =
            |i: usize, j: usize| (meant.0[i][j] - r[i][j]).abs() <= 4.0 * f64::EPSILON * scales[j];
        (0..9)
            .all(|n| alike(n / 3, n % 3))
            .then_some((scales, degrees, axis))
    })
}

/// Indented lines on their way to a stream.
pub(crate) struct Page<'w> {
    out: &'w mut dyn Write,
    depth: usize,
}

impl<'w> Page<'w> {
    pub(crate) fn new(out: &'w mut dyn Write) -> Page<'w> {
        Page { out, depth: 0 }
    }

    /// Writes a whole line.
    pub(crate) fn line(&mut self, text: fmt::Arguments) -> fmt::Result {
        self.begin()?;
        self.out.write_fmt(text)?;
        self.end(None)
    }

    pub(crate) fn blank(&mut self) -> fmt::Result {
        self.out.write_char('\n')
    }

    /// Writes the indentation of a line.
    pub(crate) fn begin(&mut self) -> fmt::Result {
        (0..self.depth).try_for_each(|_| self.out.write_str("  "))
    }

    /// Writes a part of a line.
    pub(crate) fn write(&mut self, text: &str) -> fmt::Result {
        self.out.write_str(text)
    }

    /// Ends a line, with a comment if there is one.
    pub(crate) fn end(&mut self, comment: Option<&str>) -> fmt::Result {
        match comment {
            Some(comment) => writeln!(self.out, " // {comment}"),
            None => self.out.write_char('\n'),
        }
    }

    /// Prints lines that are indented by one step more.
    pub(crate) fn indented(&mut self, print: impl FnOnce(&mut Self) -> fmt::Result) -> fmt::Result {
        self.depth += 1;
        let printed = print(self);
        self.depth -= 1;
        printed
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
        let askew = Matrix::rotation(30.0, 0).after(&Matrix::rotation(20.0, 1));
        assert_eq!(transformation(&askew), matrix(&askew));
    }

    #[test]
    fn simple_changes_are_called_by_their_names() {
        let (move_, stretch) = (
            Matrix::translation(1.0, 2.0, 3.0),
            Matrix::scaling(2.0, 2.0, 2.0),
        );
        assert_eq!(transformation(&move_), "translate <1, 2, 3>");
        assert_eq!(transformation(&stretch), "scale 2");
        for (degrees, axis, words) in [
            (30.0, 1, "rotate 30*y"),
            (-12.5, 0, "rotate -12.5*x"),
            (90.0, 2, "rotate 90*z"),
        ] {
            let turn = Matrix::rotation(degrees, axis);
            assert_eq!(transformation(&turn), words);
            let all = move_.after(&turn).after(&Matrix::scaling(2.0, 0.1, 3.0));
            let all = transformation(&all);
            assert_eq!(
                all,
                format!("scale <2, 0.1, 3> {words} translate <1, 2, 3>")
            );
        }
        // A matrix that also mirrors is no turn.
        let mirrored = Matrix::rotation(30.0, 1).after(&Matrix::scaling(1.0, 1.0, -1.0));
        assert_eq!(transformation(&mirrored), matrix(&mirrored));
        let both = move_.after(&Matrix::scaling(2.0, 1.0, 1.0));
        assert_eq!(transformation(&both), "scale <2, 1, 1> translate <1, 2, 3>");
    }
}
