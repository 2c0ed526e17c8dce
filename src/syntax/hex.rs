//! Colours as other programs write them: `#ff8000`, `#f80`, `0xff8000`, `ff8000`.

/// Red, green and blue, from 0 to 255, of a word that is a colour; `None` for any other word.
pub fn colour(word: &str) -> Option<[u8; 3]> {
    let sign = word.strip_prefix('#');
    let digits = sign
        .or_else(|| word.strip_prefix("0x"))
        .or_else(|| word.strip_prefix("0X"))
        .unwrap_or(word);
    if !digits.bytes().all(|b| b.is_ascii_hexdigit()) {
        return None;
    }
    let part = |i: usize, n: usize| u8::from_str_radix(&digits[n * i..n * (i + 1)], 16).ok();
    match digits.len() {
        6 => Some([part(0, 2)?, part(1, 2)?, part(2, 2)?]),
        // `#f80` is `#ff8800`.
        3 if sign.is_some() => Some([17 * part(0, 1)?, 17 * part(1, 1)?, 17 * part(2, 1)?]),
        _ => None,
    }
}

/// The colour that a text begins with: its word, with the `#`, and its red, green and blue.
pub fn at_start(text: &str) -> Option<(&str, [u8; 3])> {
    let ends = |c: char| c == '#' || c.is_whitespace();
    let end = text.get(1..)?.find(ends).map_or(text.len(), |i| i + 1);
    let word = &text[..end];
    Some((word, colour(word)?))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ways_to_write_a_colour() {
        for word in ["#ff8000", "#FF8000", "0xff8000", "0XFF8000", "ff8000"] {
            assert_eq!(colour(word), Some([255, 128, 0]), "{word}");
        }
        assert_eq!(colour("#f80"), Some([255, 136, 0]));
        assert_eq!(colour("804020"), Some([128, 64, 32]));
        for word in [
            "f80",
            "0xf80",
            "#ff80",
            "#ff8000ff",
            "#ff800g",
            "#",
            "",
            "žlutá",
            "+ff800",
        ] {
            assert_eq!(colour(word), None, "{word}");
        }
        assert_eq!(at_start("#f80# 1"), Some(("#f80", [255, 136, 0])));
        assert_eq!(at_start("#ff8000 # orange #").map(|c| c.0), Some("#ff8000"));
        assert_eq!(at_start("# ff8000"), None);
        assert_eq!(at_start("č"), None);
    }
}
