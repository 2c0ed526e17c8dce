//! Text that is commented out: `0 # ~ 4 9 1 #`, a comment for each line.
//!
//! Comments do not nest, so a `#` within is written `~~`, and a `~` as `~'`: `4 9 1 # red #` becomes `0 # ~ 4 9 1 ~~
//! red ~~ #`. Text that is commented out twice gains one character for each of these signs, and the coding of one text
//! is never that of another. The text of a line keeps all of its own spaces, with one more before it and one behind it.
//! A line that goes on with a record or comment of the line before, as in a matrix in four rows, begins with `0 # ~+ `.

use std::ops::Range;

/// The sign that stands for `#`.
pub const SIGN: &str = "~~";

/// The sign that stands for `~`.
pub const TILDE: &str = "~'";

/// The end of a line that is commented out.
pub const END: &str = " #";

/// The beginning of a line that is commented out. `goes_on` is true if the line before has begun its record or comment.
pub fn begin(goes_on: bool) -> &'static str {
    match goes_on {
        false => "0 # ~ ",
        true => "0 # ~+ ",
    }
}

/// Whether a comment, with its signs, is text that is commented out.
pub fn is_commented_out(comment: &str) -> bool {
    ["# ~ ", "# ~+ "]
        .iter()
        .any(|start| comment.starts_with(start))
}

/// A line that is commented out.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CommentedOut {
    /// Whether the line goes on with a record or comment that the line before it has begun.
    pub goes_on: bool,
    /// The bytes of the line that hold its text, still coded.
    pub text: Range<usize>,
}

/// Reads a line, without its line break; nothing if it is not commented out. The formatter may have moved the `0`, and
/// spaces at the end do not count.
pub fn read(line: &str) -> Option<CommentedOut> {
    let blank = [' ', '\t'];
    let comment = line.trim_start_matches(blank).strip_prefix('0')?;
    let inside = comment.trim_start_matches(blank).strip_prefix("# ~")?;
    let (goes_on, inside) = match inside.strip_prefix('+') {
        Some(inside) => (true, inside),
        None => (false, inside),
    };
    let inside = inside.strip_prefix(' ')?;
    let start = line.len() - inside.len();
    let text = inside.trim_end_matches(blank).strip_suffix(END)?;
    (!text.contains('#')).then(|| CommentedOut {
        goes_on,
        text: start..start + text.len(),
    })
}

/// Turns a line into a comment, which [`read`] can read.
pub fn comment_out(line: &str) -> String {
    let coded = line.replace('~', TILDE).replace('#', SIGN);
    format!("{}{coded}{END}", begin(false))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_told_apart() {
        let text = |line| read(line).map(|c| (c.goes_on, &line[c.text]));
        assert_eq!(text("0 # ~ 4 9 1 #"), Some((false, "4 9 1")));
        assert_eq!(
            text("\t0  # ~+  4 ~~ a ~~  # "),
            Some((true, " 4 ~~ a ~~ "))
        );
        assert_eq!(text("0 # ~  #"), Some((false, "")));
        for other in [
            "",
            "0",
            "4 9 1",
            "0 # a heading #",
            "0 # ~5 cm #",
            "0 # ~ 4 9 1",
            "0 # ~ #",
            "0 # ~ 4 # 9 #",
            "0 # ~ 4 9 1 # 5 9 1",
            "# ~ 4 9 1 #",
            "2 9 1 # ~ 4 9 1 #",
        ] {
            assert_eq!(read(other), None, "{other}");
        }
    }
}
