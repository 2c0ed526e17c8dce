//! Applying fixes until none is left.

use crate::commands::Loaded;
use crate::diagnostics::render::Tally;
use crate::diagnostics::{Diagnostic, Fix, fixes};

/// Fixes that do harm together are tried one by one, so many of them.
const TRIED_ALONE: usize = 64;

/// Applies fixes as long as that makes a scene check better, and counts them. `again` reads the scene
/// from other bytes.
///
/// Each step has fewer errors, or as many and fewer warnings, and so on: it comes to an end, and what
/// comes out never checks worse than what went in.
pub fn to_fixed_point(
    mut loaded: Loaded,
    unsafe_too: bool,
    again: impl Fn(Vec<u8>) -> Loaded,
) -> (Loaded, usize) {
    let mut fixed = 0;
    while let Some((better, count)) = step(&loaded, unsafe_too, &again) {
        loaded = better;
        fixed += count;
    }
    (loaded, fixed)
}

/// The scene after some of its fixes, and how many these were.
fn step(
    loaded: &Loaded,
    unsafe_too: bool,
    again: &impl Fn(Vec<u8>) -> Loaded,
) -> Option<(Loaded, usize)> {
    let fix = |d: &Diagnostic| d.applicable_fix(unsafe_too).cloned();
    let all: Vec<Fix> = loaded.diagnostics.iter().filter_map(fix).collect();
    let try_these = |fixes: &[Fix]| {
        let (text, count) = fixes::apply(&loaded.source.text, fixes.iter());
        if count == 0 {
            return None;
        }
        let fixed = again(loaded.source.encode(&text));
        (weight(&fixed) < weight(loaded)).then_some((fixed, count))
    };
    try_these(&all).or_else(|| {
        let mut alone = all.chunks(1).take(TRIED_ALONE);
        alone.find_map(try_these)
    })
}

/// How many errors, warnings, notes and remarks on style there are.
fn weight(loaded: &Loaded) -> [usize; 4] {
    let mut tally = Tally::default();
    tally.add(&loaded.diagnostics);
    [tally.errors, tally.warnings, tally.notes, tally.style]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn fixed(text: &str, unsafe_too: bool) -> (String, usize) {
        let read = |bytes| Loaded::new("a.zpg", bytes);
        let (loaded, count) = to_fixed_point(read(text.into()), unsafe_too, read);
        (loaded.source.text, count)
    }

    #[test]
    fn until_none_is_left() {
        // The separators hide that two records share a line.
        let (text, count) = fixed("2 11 <0,1,2> 1 3 9 0,5\n1 9999 2 0\n", false);
        assert_eq!(text, "2 11 0 1 2 1\n3 9 0.5\n1 9999 2 0\n");
        assert_eq!(count, 3);
        // What cannot be mended stays byte for byte.
        let broken = "2 9 # of what size? #\n1 9999 2 0\n";
        assert_eq!(fixed(broken, true), (broken.to_owned(), 0));
    }

    #[test]
    fn guesses_only_where_they_may_be() {
        let torus = "2 14 1 3\n1 9999 2 0\n";
        assert_eq!(fixed(torus, false), (torus.to_owned(), 0));
        assert_eq!(fixed(torus, true), ("2 14 3 1\n1 9999 2 0\n".to_owned(), 1));
    }

    #[test]
    fn the_encoding_and_the_line_breaks_stay() {
        let bytes = b"# \xf8 #\r\n2 9 0,5 # \xe9 # 3 9 1\r\n1 9999 2 0\r\n".to_vec();
        let read = |bytes| Loaded::new("a.zpg", bytes);
        let (loaded, _) = to_fixed_point(read(bytes), false, read);
        let out = loaded.source.encode(&loaded.source.text);
        assert_eq!(
            out,
            b"0 # \xf8 #\r\n2 9 0.5 # \xe9 #\r\n3 9 1\r\n1 9999 2 0\r\n"
        );
    }
}
