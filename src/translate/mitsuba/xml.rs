//! Elements of Mitsuba's scene files.

use super::output::ShapeInfo;
use crate::geometry::Matrix;
use crate::scene::Vec3;
use crate::translate::number;

/// The components of a vector: `1, 2, 3`.
pub(super) fn vector(v: Vec3) -> String {
    let [x, y, z] = v.map(number);
    format!("{x}, {y}, {z}")
}

/// A transformation by a matrix.
pub(super) fn transform(name: &str, m: &Matrix) -> String {
    let rows: Vec<String> = m.0.iter().flatten().map(|x| number(*x)).collect();
    let rows = rows.join(" ");
    format!("<transform name=\"{name}\"><matrix value=\"{rows}\"/></transform>")
}

/// A colour under a name.
pub(super) fn rgb(name: &str, c: Vec3) -> String {
    format!("<rgb name=\"{name}\" value=\"{}\"/>", vector(c))
}

/// A shape from a file.
pub(super) fn ply(file: &str, bsdf: &str, info: &ShapeInfo, number: usize) -> String {
    let file = escaped(file);
    format!(
        "  <shape type=\"ply\" id=\"Object_{}_{number}\">\n    <string name=\"filename\" value=\"{file}\"/>\n    {bsdf}\n  </shape>\n",
        info.shape
    )
}

/// A line with a comment for readers. Spaces are put between hyphens, since XML comments must not have two side by
/// side.
pub(super) fn comment(text: &str) -> String {
    let mut out = String::from("  <!-- ");
    for c in text.chars() {
        if c == '-' && out.ends_with('-') {
            out.push(' ');
        }
        out.push(c);
    }
    out + " -->\n"
}

/// Text as it may stand between quotes.
pub(super) fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            c => out.push(c),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hyphens_are_kept_apart() {
        assert_eq!(comment("a-b"), "  <!-- a-b -->\n");
        assert_eq!(comment("a -- b---"), "  <!-- a - - b- - - -->\n");
        assert_eq!(comment("-->"), "  <!-- - -> -->\n");
    }
}
